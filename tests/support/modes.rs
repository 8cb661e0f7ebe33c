//! Membership of one wrench in every set of the `insert` section, decided by linear programs from the letters' table.
//!
//! Letter `b` (breaks) stands for `s` with `a_n > 0`.

use super::lp::{Program, Relation};
use super::{Wrench, cross, dot};
use num_traits::Zero;
use partplan::exact::Q;
use partplan::model::{Fixture, Friction, Part};

/// One fixel in the frame of the center of mass.
#[derive(Debug, Clone)]
pub struct Contact {
    pub point: [Q; 2],
    /// Wrench of the contact normal: a column of J.
    pub normal: Wrench,
    /// Wrench of the contact tangent: a column of J.
    pub tangent: Wrench,
    pub friction: Friction,
}

/// All fixels, and the squared radius of gyration.
#[derive(Debug, Clone)]
pub struct Contacts {
    pub list: Vec<Contact>,
    pub rho2: Q,
}

impl Contacts {
    pub fn of(part: &Part, fixture: &Fixture) -> Self {
        let [x, y] = &part.center_of_mass;
        let list = fixture.fixels.iter().map(|fixel| {
            let point = [&fixel.point[0] - x, &fixel.point[1] - y];
            Contact::new(point, fixel.normal.clone(), fixel.friction.clone())
        });
        Self { list: list.collect(), rho2: &part.inertia / &part.mass }
    }

    /// Acceleration of the part under `force`, for unit mass.
    fn acceleration(&self, force: &Wrench) -> Wrench {
        [force[0].clone(), force[1].clone(), &force[2] / &self.rho2]
    }

    /// Whether some contact forces allowed by `mode` give, by Newton's law `M v' = g + J c`, accelerations that it allows.
    pub fn consistent(&self, mode: &str, g: &Wrench) -> bool {
        assert_eq!(mode.len(), self.list.len());
        let edges: Vec<Wrench> = self.list.iter().zip(mode.chars()).flat_map(|(c, letter)| c.forces(letter)).collect();
        let mut program = Program::new(0, edges.len());
        for (functional, relation) in self.acceleration_rows(mode) {
            let row = edges.iter().map(|edge| dot(&functional, &self.acceleration(edge))).collect();
            program.require(row, relation, -dot(&functional, &self.acceleration(g)));
        }
        program.is_feasible()
    }

    /// Whether the accelerations that `mode` asks for exist; a prefix speaks of the first fixels only.
    pub fn feasible(&self, mode: &str) -> bool {
        let mut program = Program::new(3, 0);
        for (functional, relation) in self.acceleration_rows(mode) {
            program.require(functional.to_vec(), relation, Q::zero());
        }
        program.is_feasible()
    }

    fn acceleration_rows(&self, mode: &str) -> Vec<(Wrench, Relation)> {
        self.list.iter().zip(mode.chars()).flat_map(|(contact, letter)| contact.accelerations(letter)).collect()
    }

    /// Feasible modes over `alphabet`; what no acceleration of the first fixels allows, no more fixels can.
    pub fn feasible_modes(&self, alphabet: &str) -> Vec<String> {
        let mut modes = vec![String::new()];
        for _ in &self.list {
            let longer = modes.iter().flat_map(|mode| alphabet.chars().map(move |letter| format!("{mode}{letter}")));
            modes = longer.filter(|mode| self.feasible(mode)).collect();
        }
        modes
    }

    /// Balanced at rest at the least static friction.
    pub fn weak(&self, g: &Wrench) -> bool {
        let edges = self.least_friction_edges();
        let mut program = Program::new(0, edges.len());
        for i in 0..3 {
            program.require(edges.iter().map(|edge| edge[i].clone()).collect(), Relation::Equal, -&g[i]);
        }
        program.is_feasible()
    }

    /// In the interior of the weakly stable cone: every direction is left to move in.
    pub fn weak_interior(&self, g: &Wrench) -> bool {
        // g is interior iff it stays inside after a small step towards each of four wrenches that surround the origin:
        // g + t d inside for some t > 0
        let edges = self.least_friction_edges();
        [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, -1, -1]].iter().all(|step| {
            let mut program = Program::new(0, edges.len() + 1);
            for i in 0..3 {
                let mut row: Vec<Q> = edges.iter().map(|edge| edge[i].clone()).collect();
                row.push(Q::from_integer(step[i].into()));
                program.require(row, Relation::Equal, -&g[i]);
            }
            let mut moves = vec![Q::zero(); edges.len() + 1];
            moves[edges.len()] = Q::from_integer(1.into());
            program.require(moves, Relation::Greater, Q::zero());
            program.is_feasible()
        })
    }

    fn least_friction_edges(&self) -> Vec<Wrench> {
        self.list.iter().flat_map(|c| [c.edge(&c.friction.static_.min), c.edge(&-&c.friction.static_.min)]).collect()
    }

    pub fn all_at_one_point(&self) -> bool {
        self.list.iter().all(|contact| contact.point == self.list[0].point)
    }

    /// The modes of (19): the part moves.
    pub fn moving_modes(&self) -> Vec<String> {
        self.feasible_modes("blrn").into_iter().filter(|mode| mode.contains(['b', 'l', 'r'])).collect()
    }

    /// Outside of all `moving` modes, and of pivoting about the only contact point.
    pub fn strong(&self, moving: &[String], g: &Wrench) -> bool {
        let moves = moving.iter().any(|mode| self.consistent(mode, g));
        let pivots = self.all_at_one_point() && self.pivots(g);
        !(moves || pivots)
    }

    /// Whether the part may turn about a point where it rolls on every fixel.
    fn pivots(&self, g: &Wrench) -> bool {
        let mode = "n".repeat(self.list.len());
        let edges: Vec<Wrench> = self.list.iter().flat_map(|contact| contact.forces('n')).collect();
        [1, -1].iter().any(|sense| {
            let mut program = Program::new(0, edges.len());
            for (functional, relation) in self.acceleration_rows(&mode) {
                let row = edges.iter().map(|edge| dot(&functional, &self.acceleration(edge))).collect();
                program.require(row, relation, -dot(&functional, &self.acceleration(g)));
            }
            let sense = Q::from_integer((*sense).into());
            let row = edges.iter().map(|edge| &edge[2] * &sense).collect();
            program.require(row, Relation::Greater, -(&g[2] * &sense));
            program.is_feasible()
        })
    }

    /// Whether the transitions possible under `g` contain no cycle, straight from the definition.
    pub fn acyclic(&self, g: &Wrench) -> bool {
        let n = self.list.len();
        let possible = |letter: &dyn Fn(usize) -> char| self.consistent(&(0..n).map(letter).collect::<String>(), g);
        let has = |set: usize, contact: usize| set >> contact & 1 == 1;
        let leads = |from: usize, to: usize| match (from & !to, to & !from) {
            (0, 0) => from + 1 < 1 << n && possible(&|i| if has(from, i) { 'm' } else { 's' }),
            (broken, 0) => possible(&|i| match i {
                _ if has(broken, i) => 'b',
                _ if has(to, i) => 'm',
                _ => 'u',
            }),
            (0, added) => possible(&|i| match i {
                _ if has(from, i) => 'm',
                _ if has(added, i) => 'a',
                _ => 'u',
            }),
            _ => false,
        };
        let mut reach: Vec<Vec<bool>> =
            (0..1 << n).map(|from| (0..1 << n).map(|to| leads(from, to)).collect()).collect();
        for via in 0..1 << n {
            for from in 0..1 << n {
                for to in 0..1 << n {
                    reach[from][to] |= reach[from][via] && reach[via][to];
                }
            }
        }
        (0..1 << n).all(|state| !reach[state][state])
    }

    /// Outside of all the modes of (21) that undo or delay seating.
    pub fn goal(&self, g: &Wrench) -> bool {
        !unseating_modes(self.list.len()).iter().any(|mode| self.consistent(mode, g))
    }
}

impl Contact {
    pub fn new(point: [Q; 2], normal: [Q; 2], friction: Friction) -> Self {
        let tangent = [-&normal[1], normal[0].clone()];
        let column = |d: &[Q; 2]| [d[0].clone(), d[1].clone(), cross(&point, d)];
        Self { normal: column(&normal), tangent: column(&tangent), point, friction }
    }

    /// Wrench of the force `n + slope t`.
    pub fn edge(&self, slope: &Q) -> Wrench {
        std::array::from_fn(|i| &self.normal[i] + slope * &self.tangent[i])
    }

    /// Edges of the cone of forces that `letter` allows.
    fn forces(&self, letter: char) -> Vec<Wrench> {
        let (kinetic, largest) = (&self.friction.kinetic, &self.friction.static_.max);
        match letter {
            'l' => vec![self.edge(&-&kinetic.min), self.edge(&-&kinetic.max)],
            'r' => vec![self.edge(&kinetic.min), self.edge(&kinetic.max)],
            'n' | 'm' => vec![self.edge(largest), self.edge(&-largest)],
            's' | 'b' | 'a' | 'u' => vec![],
            _ => panic!("{letter} is not a letter"),
        }
    }

    /// Conditions `functional . v' (relation) 0` that `letter` puts on the part's acceleration.
    fn accelerations(&self, letter: char) -> Vec<(Wrench, Relation)> {
        let plus = |d: &Wrench, relation| (d.clone(), relation);
        let minus = |d: &Wrench, relation| (std::array::from_fn(|i| -&d[i]), relation);
        let (n, t) = (&self.normal, &self.tangent);
        match letter {
            's' => vec![plus(n, Relation::AtLeast)],
            'b' => vec![plus(n, Relation::Greater)],
            'a' => vec![minus(n, Relation::Greater)],
            'u' => vec![],
            'l' => vec![plus(n, Relation::Equal), plus(t, Relation::Greater)],
            'r' => vec![plus(n, Relation::Equal), minus(t, Relation::Greater)],
            'n' => vec![plus(n, Relation::Equal), plus(t, Relation::Equal)],
            'm' => vec![plus(n, Relation::Equal)],
            _ => panic!("{letter} is not a letter"),
        }
    }
}

/// The `n 2^(n-1)` modes with `s` at one fixel, `m` on any others, `u` on the rest.
pub fn unseating_modes(n: usize) -> Vec<String> {
    let mut modes = Vec::new();
    for open in 0..n {
        for held in (0..1_usize << n).filter(|held| held >> open & 1 == 0) {
            modes.push((0..n).map(|i| if i == open { 's' } else { ['u', 'm'][held >> i & 1] }).collect());
        }
    }
    modes
}

/// `mode` with `s` meaning `a_n > 0`.
pub fn breaking(mode: &str) -> String {
    mode.replace('s', "b")
}
