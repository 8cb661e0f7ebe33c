//! The contact problem of a step: which impulses make the velocities admissible, equations (10)-(13).

use super::contact::{Contact, add_scaled, dot};
use super::mechanics::Mechanics;
use crate::answer::ContactName;
use crate::complementarity::{Basis, ExactLcp, Factors, Lcp, LcpError, Proof, Rung, Solver, Undecided, Verdict};
use crate::model::World;

/// Builds and solves contact problems; keeps its memory and its last basis between steps.
#[derive(Debug)]
pub(super) struct Impulses<S: Mechanics> {
    solver: Solver,
    /// Directions of the friction cone along (t, o), all contacts alike.
    directions: Vec<[f64; 2]>,
    /// M⁻¹ times the rows of each contact, on the body and on the other.
    weighed: Vec<(S::Rows, Option<S::Rows>)>,
    /// Wᵀ M⁻¹ W over the rows n, t (o) of all contacts.
    gram: Vec<f64>,
    m: Vec<f64>,
    q: Vec<f64>,
    warm: Basis,
    warm_names: Vec<ContactName>,
    /// Impulses along n, t and o of the last problem, a contact each (N s).
    pub answer: Vec<[f64; 3]>,
}

impl<S: Mechanics> Impulses<S> {
    pub fn new(world: &World<S>) -> Self {
        let is_frictionless = world.materials.iter().all(|material| material.friction == 0.0);
        let n = if is_frictionless { 0 } else { world.directions };
        let around = |j: usize| {
            let (sine, cosine) = libm::sincos(std::f64::consts::TAU * j as f64 / n as f64);
            [cosine, sine]
        };
        // exact in the plane, where the two are +t and -t
        let directions = if n == 2 { vec![[1.0, 0.0], [-1.0, 0.0]] } else { (0..n).map(around).collect() };
        Self {
            solver: Solver::default(),
            directions,
            weighed: Vec::new(),
            gram: Vec::new(),
            m: Vec::new(),
            q: Vec::new(),
            warm: Basis::default(),
            warm_names: Vec::new(),
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
        self.assemble(contacts, offset, pressed, velocities, n_rows);
        self.complement(world, poses, contacts).inspect(|_| self.apply(contacts, velocities, n_rows))
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
        let along = |d: usize, s: usize| self.directions[d][s - 1];
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
                self.q[row] = (1..n_rows).map(|s| along(d, s) * contact.velocity(s, free)).sum();
                for j in 0..n_c {
                    let normal: f64 = (1..n_rows).map(|s| along(d, s) * gram(i * n_rows + s, j * n_rows)).sum();
                    self.m[row * size + j] = normal;
                    self.m[j * size + row] = normal;
                    for e in 0..n_l {
                        let mut sum = 0.0;
                        for s in 1..n_rows {
                            for r in 1..n_rows {
                                sum += along(d, s) * gram(i * n_rows + s, j * n_rows + r) * along(e, r);
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
        let Self { solver, directions, m, q, warm, .. } = self;
        let exact = || exact_problem(world, poses, contacts, directions, q);
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
            for (d, [t, o]) in self.directions.iter().enumerate() {
                let along = solution.z[n_c + i * n_l + d];
                impulse[1] += along * t;
                impulse[2] += along * o;
            }
            impulse
        }));
        Ok(Solved {
            residual: solution.residual,
            pivots: solution.pivots,
            rung: solution.rung,
            problems: 1,
            impacts: 0,
        })
    }

    fn apply(&self, contacts: &[Contact<S>], velocities: &mut [S::Velocity], n_rows: usize) {
        for ((contact, (weighed, other)), impulse) in contacts.iter().zip(&self.weighed).zip(&self.answer) {
            for s in 0..n_rows {
                add_scaled(&mut velocities[contact.name.body], impulse[s], &weighed.as_ref()[s]);
                if let Some(other) = other {
                    add_scaled(&mut velocities[contact.name.other], impulse[s], &other.as_ref()[s]);
                }
            }
        }
    }
}

/// How the contact problems of a step were solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solved {
    pub residual: f64,
    pub pivots: usize,
    pub rung: Rung,
    pub problems: usize,
    pub impacts: usize,
}

impl Solved {
    pub fn nothing() -> Self {
        Self { residual: 0.0, pivots: 0, rung: Rung::Free, problems: 0, impacts: 0 }
    }

    /// Adds the work of another problem of the same step.
    pub fn add(&mut self, other: Self) {
        self.residual = self.residual.max(other.residual);
        self.pivots += other.pivots;
        self.rung = self.rung.max(other.rung);
        self.problems += other.problems;
        self.impacts += other.impacts;
    }
}

/// Why a contact problem was not solved.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Refused {
    /// Proved: no impulses are admissible.
    NoSolution(Proof),
    /// Given up at a limit.
    Undecided(Undecided),
    /// The numbers are no problem at all: something overflowed.
    Broken(LcpError),
}

impl From<LcpError> for Refused {
    fn from(error: LcpError) -> Self {
        Self::Broken(error)
    }
}

/// The problem as it is, from rows and masses: a rounded M would ask another question.
fn exact_problem<S: Mechanics>(
    world: &World<S>,
    poses: &[S::Pose],
    contacts: &[Contact<S>],
    directions: &[[f64; 2]],
    q: &[f64],
) -> Result<ExactLcp, LcpError> {
    let dof = S::Velocity::default().as_ref().len();
    let n_v = dof * world.bodies.len();
    let mut jacobian = Vec::new();
    let mut push = |contact: &Contact<S>, factors: [f64; 3]| {
        let start = jacobian.len();
        jacobian.resize(start + n_v, 0.0);
        for (body, rows) in contact.sides() {
            let mut row = S::Velocity::default();
            for (factor, from) in factors.iter().zip(rows.as_ref()) {
                add_scaled(&mut row, *factor, from);
            }
            let row = S::principal(&world.bodies[body], &poses[body], &row);
            jacobian[start + dof * body..][..dof].copy_from_slice(row.as_ref());
        }
    };
    contacts.iter().for_each(|contact| push(contact, [1.0, 0.0, 0.0]));
    for contact in contacts {
        directions.iter().for_each(|[t, o]| push(contact, [0.0, *t, *o]));
    }
    let inverse_mass: Vec<f64> = world.bodies.iter().flat_map(|body| S::inverse_mass(body).as_ref().to_vec()).collect();
    let mu: Vec<f64> = contacts.iter().map(|contact| contact.material.friction).collect();
    Factors { jacobian: &jacobian, inverse_mass: &inverse_mass, mu: &mu, directions: directions.len(), q }.to_exact()
}
