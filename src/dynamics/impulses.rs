//! The contact problem of a step: which impulses make the velocities admissible, equations (10)-(13).

use super::contact::{Contact, add_scaled, dot};
use super::forces::{Forces, exact_problem, forces};
use super::mechanics::Mechanics;
use super::single::{ball, planar};
use super::solved::{Refused, Solved};
use crate::answer::ContactName;
use crate::complementarity::{Basis, Lcp, Solver, Verdict};
use crate::model::World;

/// Most times that friction cones are turned in one problem.
const MAX_ALIGNMENTS: usize = 20;

/// Turn of a cone (rad) that no longer matters.
const ALIGNED: f64 = 1e-9;

/// Slip, relative to the speeds that meet at a contact, that is told from rounding.
pub(super) const SLIPPING: f64 = 1e-9;

/// How Coulomb's cone is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FrictionCone {
    /// By the inscribed pyramid (8) with as many edges as the scene says; exact in the plane.
    Edges,
    /// By a pyramid turned until an edge of it lies against the slip: the exact disc.
    Disc,
}

/// Builds and solves contact problems; keeps its memory and its last basis between steps.
#[derive(Debug)]
pub(super) struct Impulses<S: Mechanics> {
    solver: Solver,
    cone: FrictionCone,
    /// Edges of a friction cone along (t, o).
    directions: Vec<[f64; 2]>,
    /// Edges of the cones of all contacts of the problem, contact by contact.
    edges: Vec<[f64; 2]>,
    /// M⁻¹ times the rows of each contact, on the body and on the other.
    weighed: Vec<(S::Rows, Option<S::Rows>)>,
    /// Wᵀ M⁻¹ W over the rows n, t (o) of all contacts.
    gram: Vec<f64>,
    m: Vec<f64>,
    q: Vec<f64>,
    warm: Basis,
    warm_names: Vec<ContactName>,
    /// Whether a contact of a problem since this was last reset is pressed harder by its own friction the more it pushes,
    /// A_nn < μ |A_nt|: then forces may not exist or not be unique.
    pub is_suspect: bool,
    /// Impulses along n, t and o of the last problem, a contact each (N s).
    pub answer: Vec<[f64; 3]>,
}

impl<S: Mechanics> Impulses<S> {
    pub fn new(world: &World<S>, cone: FrictionCone) -> Self {
        let is_frictionless = world.materials.iter().all(|material| material.friction == 0.0);
        let n = match cone {
            _ if is_frictionless => 0,
            FrictionCone::Disc if S::TANGENTS == 2 => 4,
            _ => world.directions,
        };
        let around = |j: usize| {
            let (sine, cosine) = libm::sincos(std::f64::consts::TAU * j as f64 / n as f64);
            [cosine, sine]
        };
        // exact in the plane, where the two are +t and -t
        let directions = if n == 2 { vec![[1.0, 0.0], [-1.0, 0.0]] } else { (0..n).map(around).collect() };
        Self {
            solver: Solver::default(),
            cone: if S::TANGENTS == 1 { FrictionCone::Edges } else { cone },
            directions,
            edges: Vec::new(),
            weighed: Vec::new(),
            gram: Vec::new(),
            m: Vec::new(),
            q: Vec::new(),
            warm: Basis::default(),
            warm_names: Vec::new(),
            is_suspect: false,
            answer: Vec::new(),
        }
    }

    /// Changes `velocities` by impulses at `contacts` so that each leaves with a normal velocity of at least
    /// `-offset`, presses only where it just does, and friction opposes slip.
    ///
    /// `offset` is `φ/h` for a step that closes gaps, `e v_n` of before for an impact; a contact each. `pressed`, where it
    /// is not empty, is the normal impulse at each contact that acts already and that friction may count on (N s).
    pub fn solve(
        &mut self,
        world: &World<S>,
        poses: &[S::Pose],
        contacts: &[Contact<S>],
        offset: &[f64],
        pressed: &[f64],
        velocities: &mut [S::Velocity],
    ) -> Result<Solved, Refused> {
        let n_rows = 1 + if self.directions.is_empty() { 0 } else { S::TANGENTS };
        self.weigh(world, poses, contacts);
        self.multiply(contacts, n_rows);
        self.is_suspect |= self.suspects(contacts, n_rows);
        self.edges.clear();
        contacts.iter().for_each(|_| self.edges.extend_from_slice(&self.directions));
        if let ([contact], [], false) = (contacts, pressed, self.is_suspect)
            && let Some((impulse, residual)) = self.single(contact, offset[0], velocities, n_rows)
        {
            self.warm_names.clear();
            self.answer.clear();
            self.answer.push(impulse);
            self.apply(contacts, velocities, n_rows);
            return Ok(Solved { residual, problems: 1, closed: 1, ..Solved::nothing() });
        }
        if self.cone == FrictionCone::Edges || n_rows == 1 {
            self.assemble(contacts, offset, pressed, velocities, n_rows);
            let solved = self.complement(world, poses, contacts)?;
            self.apply(contacts, velocities, n_rows);
            return Ok(solved);
        }
        let free = velocities.to_vec();
        let mut total = Solved::nothing();
        self.align(contacts, velocities);
        for _ in 0..MAX_ALIGNMENTS {
            velocities.copy_from_slice(&free);
            self.assemble(contacts, offset, pressed, velocities, n_rows);
            total.add(self.complement(world, poses, contacts)?);
            self.apply(contacts, velocities, n_rows);
            if self.align(contacts, velocities) <= ALIGNED {
                return Ok(total);
            }
        }
        Ok(total)
    }

    /// The only contact of a problem in closed form, where there is one; q of (13) is kept beside it.
    fn single(
        &mut self,
        contact: &Contact<S>,
        offset: f64,
        free: &[S::Velocity],
        n_rows: usize,
    ) -> Option<([f64; 3], f64)> {
        let normal = contact.velocity(0, free) + offset;
        let mu = contact.material.friction;
        match (n_rows, self.cone) {
            (2, _) => {
                let slip = contact.velocity(1, free);
                self.q.clear();
                self.q.extend([normal, slip, -slip, 0.0]);
                let [nn, nt, _, tt] = self.gram[..] else { return None };
                planar([nn, nt, tt], [normal, slip], mu)
            }
            (3, FrictionCone::Disc) => {
                let slip = [contact.velocity(1, free), contact.velocity(2, free)];
                let gram: &[f64; 9] = self.gram[..].try_into().ok()?;
                ball(gram, normal, slip, mu)
            }
            _ => None,
        }
    }

    /// Turns the cone of each contact that slips so that an edge lies against its slip; returns the largest turn.
    ///
    /// Friction along an edge is that of the exact disc, so that a solution in which nothing turns any more is one for the
    /// disc.
    fn align(&mut self, contacts: &[Contact<S>], velocities: &[S::Velocity]) -> f64 {
        let mut largest = 0.0_f64;
        for (contact, edges) in contacts.iter().zip(self.edges.chunks_exact_mut(self.directions.len())) {
            let slip = [contact.velocity(1, velocities), contact.velocity(2, velocities)];
            let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
            if speed <= SLIPPING * contact.speed(velocities) {
                continue;
            }
            let against = slip.map(|s| -s / speed);
            let nearest = edges.iter().map(|edge| against[0] * edge[0] + against[1] * edge[1]).fold(-1.0, f64::max);
            let turn = (2.0 * (1.0 - nearest)).max(0.0).sqrt();
            if turn > ALIGNED {
                largest = largest.max(turn);
                for (edge, [t, o]) in edges.iter_mut().zip(&self.directions) {
                    *edge = [t * against[0] - o * against[1], t * against[1] + o * against[0]];
                }
            }
        }
        largest
    }

    fn weigh(&mut self, world: &World<S>, poses: &[S::Pose], contacts: &[Contact<S>]) {
        let weighed = |body: usize, rows: &S::Rows| {
            let mut weighed = *rows;
            for row in weighed.as_mut() {
                *row = S::weighed(&world.bodies[body], &poses[body], row);
            }
            weighed
        };
        self.weighed.clear();
        self.weighed.extend(contacts.iter().map(|contact| {
            let ContactName { body, other, .. } = contact.name;
            (weighed(body, &contact.rows), contact.other_rows.as_ref().map(|rows| weighed(other, rows)))
        }));
    }

    /// Wᵀ M⁻¹ W, row-major over contacts and their rows, both triangles the same numbers.
    fn multiply(&mut self, contacts: &[Contact<S>], n_rows: usize) {
        let size = contacts.len() * n_rows;
        self.gram.clear();
        self.gram.resize(size * size, 0.0);
        for (i, a) in contacts.iter().enumerate() {
            for (j, b) in contacts.iter().enumerate().take(i + 1) {
                let (weighed, other_weighed) = &self.weighed[j];
                for r in 0..n_rows {
                    for s in 0..n_rows {
                        let mut sum = 0.0;
                        for (body, rows) in a.sides() {
                            if body == b.name.body {
                                sum += dot(&rows.as_ref()[r], &weighed.as_ref()[s]);
                            }
                            if let (Some(other), true) = (other_weighed, body == b.name.other) {
                                sum += dot(&rows.as_ref()[r], &other.as_ref()[s]);
                            }
                        }
                        let (row, column) = (i * n_rows + r, j * n_rows + s);
                        self.gram[row * size + column] = sum;
                        self.gram[column * size + row] = sum;
                    }
                }
            }
        }
    }

    /// Whether some A_nn < μ |A_nt|.
    fn suspects(&self, contacts: &[Contact<S>], n_rows: usize) -> bool {
        let size = contacts.len() * n_rows;
        contacts.iter().enumerate().any(|(i, contact)| {
            let row = &self.gram[i * n_rows * size + i * n_rows..][..n_rows];
            let tangential: f64 = row[1..].iter().map(|a| a * a).sum();
            row[0] * row[0] < contact.material.friction.powi(2) * tangential
        })
    }

    /// A_nn, A_nt and A_tt of the only contact of the last problem, where it is one in the plane.
    pub fn single_compliance(&self) -> Option<[f64; 3]> {
        match self.gram[..] {
            [nn, nt, _, tt] => Some([nn, nt, tt]),
            _ => None,
        }
    }

    /// M and q of (12) and (13); U is diag(mu), as ERRATA reads the paper.
    fn assemble(
        &mut self,
        contacts: &[Contact<S>],
        offset: &[f64],
        pressed: &[f64],
        free: &[S::Velocity],
        n_rows: usize,
    ) {
        let (n_c, n_l) = (contacts.len(), self.directions.len());
        let size = n_c * if n_l == 0 { 1 } else { n_l + 2 };
        let gram_size = n_c * n_rows;
        let gram = |row: usize, column: usize| self.gram[row * gram_size + column];
        // the components of direction d along the rows after the normal
        let along = |contact: usize, d: usize, s: usize| self.edges[contact * n_l + d][s - 1];
        self.m.clear();
        self.m.resize(size * size, 0.0);
        self.q.clear();
        self.q.resize(size, 0.0);
        for (i, contact) in contacts.iter().enumerate() {
            self.q[i] = contact.velocity(0, free) + offset[i];
            for j in 0..n_c {
                self.m[i * size + j] = gram(i * n_rows, j * n_rows);
            }
            for d in 0..n_l {
                let row = n_c + i * n_l + d;
                self.q[row] = (1..n_rows).map(|s| along(i, d, s) * contact.velocity(s, free)).sum();
                for j in 0..n_c {
                    let normal: f64 = (1..n_rows).map(|s| along(i, d, s) * gram(i * n_rows + s, j * n_rows)).sum();
                    self.m[row * size + j] = normal;
                    self.m[j * size + row] = normal;
                    for e in 0..n_l {
                        let mut sum = 0.0;
                        for s in 1..n_rows {
                            for r in 1..n_rows {
                                sum += along(i, d, s) * gram(i * n_rows + s, j * n_rows + r) * along(j, e, r);
                            }
                        }
                        self.m[row * size + n_c + j * n_l + e] = sum;
                    }
                }
                let bound = n_c + n_c * n_l + i;
                self.m[row * size + bound] = 1.0;
                self.m[bound * size + row] = -1.0;
            }
            if n_l > 0 {
                self.q[n_c + n_c * n_l + i] = contact.material.friction * pressed.get(i).unwrap_or(&0.0);
                self.m[(n_c + n_c * n_l + i) * size + i] = contact.material.friction;
            }
        }
    }

    fn complement(&mut self, world: &World<S>, poses: &[S::Pose], contacts: &[Contact<S>]) -> Result<Solved, Refused> {
        let is_same = self.warm_names.iter().copied().eq(contacts.iter().map(|contact| contact.name));
        let Self { solver, edges, m, q, warm, .. } = self;
        let exact = || exact_problem(world, poses, contacts, edges, q);
        let verdict = solver.solve(Lcp { m, q }, is_same.then_some(&*warm), &exact)?;
        let solution = match verdict {
            Verdict::Solved(solution) => solution,
            Verdict::NoSolution(proof) => return Err(Refused::NoSolution(proof)),
            Verdict::Undecided(why) => return Err(Refused::Undecided(why)),
        };
        warm.clone_from(solution.basis);
        if !is_same {
            self.warm_names.clear();
            self.warm_names.extend(contacts.iter().map(|contact| contact.name));
        }
        let (n_c, n_l) = (contacts.len(), self.directions.len());
        self.answer.clear();
        self.answer.extend((0..n_c).map(|i| {
            let mut impulse = [solution.z[i], 0.0, 0.0];
            for (d, [t, o]) in self.edges[i * n_l..(i + 1) * n_l].iter().enumerate() {
                let along = solution.z[n_c + i * n_l + d];
                impulse[1] += along * t;
                impulse[2] += along * o;
            }
            impulse
        }));
        let (residual, pivots, rung) = (solution.residual, solution.pivots, solution.rung);
        Ok(Solved { residual, pivots, rung, problems: 1, ..Solved::nothing() })
    }

    /// All normal forces that the last problem allows, for a step of length `h`; `contacts` are those of the problem.
    pub fn forces(&self, world: &World<S>, poses: &[S::Pose], contacts: &[Contact<S>], h: f64) -> Option<Forces> {
        let size = contacts.len() * if self.directions.is_empty() { 1 } else { self.directions.len() + 2 };
        let is_last = contacts.len() == self.answer.len() && self.q.len() == size;
        if is_last { forces(world, poses, contacts, &self.edges, &self.q, h) } else { None }
    }

    fn apply(&self, contacts: &[Contact<S>], velocities: &mut [S::Velocity], n_rows: usize) {
        for ((contact, (weighed, other)), impulse) in contacts.iter().zip(&self.weighed).zip(&self.answer) {
            for (impulse, row) in impulse.iter().zip(weighed.as_ref()).take(n_rows) {
                add_scaled(&mut velocities[contact.name.body], *impulse, row);
            }
            for (impulse, row) in impulse.iter().zip(other.iter().flat_map(|rows| rows.as_ref())).take(n_rows) {
                add_scaled(&mut velocities[contact.name.other], *impulse, row);
            }
        }
    }
}
