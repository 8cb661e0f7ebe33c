//! Modes as solutions of the contact problem `0 ≤ w = M z + q ⊥ z ≥ 0`, against their wrench cones.

use crate::cones::ours;
use crate::support::member::{in_cone, landmarks, rational};
use crate::support::modes::{Contact, Contacts};
use crate::support::random::{loose, perpendicular, runs, wrenches};
use crate::support::{Wrench, dot, int, wrench};
use num_traits::{One, Signed, Zero};
use partplan::answer::{CanonicalCone, Cone};
use partplan::complementarity::{Enumeration, ExactLcp, Piece, enumerate};
use partplan::exact::Q;
use partplan::model::Part;
use partplan::planner::{Question, stability};
use proptest::prelude::*;
use proptest::sample::Index;

/// The variables of one contact, a bit each: `z = (c_n, c_+, c_-, λ)` with `c_t = c_+ - c_-`.
const C_N: u32 = 1;
const C_PLUS: u32 = 1 << 1;
const C_MINUS: u32 = 1 << 2;
const LAMBDA: u32 = 1 << 3;
/// `w = (a_n, λ + a_t, λ - a_t, μ c_n - c_+ - c_-)`.
const A_N: u32 = 1 << 4;
const W_PLUS: u32 = 1 << 5;
const W_MINUS: u32 = 1 << 6;
const SLACK: u32 = 1 << 7;

/// What a letter asks of the variables: those that are zero, and those that are positive.
///
/// The contacts touch at rest, so `a_n` and `a_t` stand where gaps and slip velocities do otherwise. A letter speaks of `a`
/// and `c` only. Where `μ c_n > 0` complementarity makes `λ = |a_t|`; where `μ c_n = 0` any `λ ≥ |a_t|` fits the same `a` and
/// `c`. So `l`, `r` and `n` may ask for `λ = |a_t|`: a solution that they miss differs from one that they keep in `λ` only.
/// With that `a_t > 0` is `λ - a_t = 0` and `λ > 0`, and every letter is a face of the solutions with variables that are
/// positive on it. A grazing contact (`a_n = 0`, `c = 0`) has the letter `s` unless that is strict, and by its `a_t` one of
/// `l`, `r` and `n` as well.
fn conditions(letter: char, strict_s: bool) -> [u32; 2] {
    match letter {
        's' => [C_N | C_PLUS | C_MINUS, if strict_s { A_N } else { 0 }],
        'l' => [A_N | W_MINUS | C_PLUS | SLACK, LAMBDA],
        'r' => [A_N | W_PLUS | C_MINUS | SLACK, LAMBDA],
        'n' => [A_N | W_PLUS | W_MINUS, 0],
        _ => panic!("{letter} is not among the letters"),
    }
}

/// The contact problem under the wrench `g` on the part, contact by contact: `a = Jᵀ M⁻¹ (g + J c)`.
fn contact_problem(part: &Part, contacts: &[Contact], g: &Wrench) -> ExactLcp {
    let directions = |contact: &Contact| {
        let backward = std::array::from_fn(|axis| -&contact.tangent[axis]);
        [contact.normal.clone(), contact.tangent.clone(), backward]
    };
    let (mut m, mut q) = (Vec::new(), Vec::new());
    for (index, contact) in contacts.iter().enumerate() {
        for (row, direction) in directions(contact).iter().enumerate() {
            let per_mass = [&direction[0] / &part.mass, &direction[1] / &part.mass, &direction[2] / &part.inertia];
            let entries = contacts.iter().enumerate().flat_map(|(other, acting)| {
                let [n, plus, minus] = directions(acting).map(|force| dot(&per_mass, &force));
                [n, plus, minus, int(i64::from(other == index && row > 0))]
            });
            m.push(entries.collect());
            q.push(dot(&per_mass, g));
        }
        let bound = [contact.friction.kinetic.max.clone(), -Q::one(), -Q::one(), Q::zero()];
        let entry = |at: usize| if at / 4 == index { bound[at % 4].clone() } else { Q::zero() };
        m.push((0..4 * contacts.len()).map(entry).collect());
        q.push(Q::zero());
    }
    ExactLcp::new(m, q).expect("four rows and columns a contact")
}

/// A vertex or ray of a piece: which variables of which contact are positive.
struct Generator {
    is_vertex: bool,
    positive: Vec<u32>,
}

/// Those of a piece, all points of which are seen to be solutions.
fn generators(lcp: &ExactLcp, piece: &Piece) -> Vec<Generator> {
    let generator = |z: &Vec<Q>, is_vertex: bool| {
        let share = int(i64::from(is_vertex));
        let w: Vec<Q> = lcp.m().iter().zip(lcp.q()).map(|(row, q)| dot(row, z) + q * &share).collect();
        assert!(z.iter().chain(&w).all(|value| !value.is_negative()), "a generator leaves the piece");
        let bits = |values: &[Q]| (0..4).map(|bit| u32::from(values[bit].is_positive()) << bit).sum::<u32>();
        let positive = z.chunks(4).zip(w.chunks(4)).map(|(z, w)| bits(z) | bits(w) << 4).collect();
        Generator { is_vertex, positive }
    };
    let vertices = piece.vertices.iter().map(|vertex| generator(vertex, true));
    let all: Vec<Generator> = vertices.chain(piece.rays.iter().map(|ray| generator(ray, false))).collect();
    for contact in 0..lcp.size() / 4 {
        let bits = all.iter().fold(0, |bits, generator| bits | generator.positive[contact]);
        assert_eq!(bits >> 4 & bits & 15, 0, "a pair is violated inside of the piece");
    }
    all
}

/// Whether some solution of the piece has the mode: the face with its zeros has a vertex, and each variable that is to be
/// positive is so at some generator of the face, hence all at once inside of it.
fn has_mode(piece: &[Generator], mode: &str, strict_s: bool) -> bool {
    let asked: Vec<[u32; 2]> = mode.chars().map(|letter| conditions(letter, strict_s)).collect();
    let on_face =
        |generator: &&Generator| generator.positive.iter().zip(&asked).all(|(bits, [zero, _])| bits & zero == 0);
    let face: Vec<&Generator> = piece.iter().filter(on_face).collect();
    let reached = |contact: usize| face.iter().fold(0, |all, generator| all | generator.positive[contact]);
    face.iter().any(|generator| generator.is_vertex)
        && asked.iter().enumerate().all(|(contact, [_, positive])| positive & !reached(contact) == 0)
}

fn all_modes(contacts: usize) -> Vec<String> {
    (0..contacts).fold(vec![String::new()], |modes, _| {
        modes.iter().flat_map(|mode| "slrn".chars().map(move |letter| format!("{mode}{letter}"))).collect()
    })
}

/// A wrench, once the cones of the modes are known.
#[derive(Debug, Clone)]
enum Load {
    Any(Wrench),
    /// A generator of a cone, the sum of two, zero.
    Landmark([Index; 2]),
    /// A landmark of one cone and one of another.
    Sum([[Index; 2]; 2]),
    /// Where the planes of two faces meet, coordinate planes among them.
    Meet([Index; 2]),
}

fn loads() -> impl Strategy<Value = Load> {
    let index = any::<Index>;
    prop_oneof![
        2 => wrenches(1).prop_map(|mut drawn| Load::Any(drawn.remove(0))),
        4 => [index(), index()].prop_map(Load::Landmark),
        2 => [[index(), index()], [index(), index()]].prop_map(Load::Sum),
        3 => [index(), index()].prop_map(Load::Meet),
    ]
}

impl Load {
    fn wrench(&self, cones: &[CanonicalCone]) -> Wrench {
        let landmark = |[cone, point]: &[Index; 2]| point.get(&landmarks(cone.get(cones))).clone();
        match self {
            Self::Any(g) => g.clone(),
            Self::Landmark(at) => landmark(at),
            Self::Sum(at) => {
                let [a, b] = at.each_ref().map(landmark);
                std::array::from_fn(|axis| &a[axis] + &b[axis])
            }
            Self::Meet(at) => {
                let axes = [wrench(1, 0, 0), wrench(0, 1, 0), wrench(0, 0, 1)];
                let normals = cones.iter().flat_map(normals).chain(axes).collect::<Vec<_>>();
                let [a, b] = at.each_ref().map(|index| index.get(&normals));
                perpendicular(a, b)
            }
        }
    }
}

fn normals(cone: &CanonicalCone) -> impl Iterator<Item = Wrench> {
    let rows = cone.equalities.iter().chain(cone.faces.iter().map(|face| &face.normal));
    rows.map(|row| rational(row).try_into().expect("wrenches have three components"))
}

/// Ten thousand take half a minute; in a build with assertions, what takes a quarter of a minute.
const PROBLEMS: u32 = if cfg!(debug_assertions) { 2000 } else { 10_000 };

/// Whether there is a solution and the part accelerates in none: `a = M⁻¹ (g + J c)` is zero at all vertices and along all rays.
fn is_always_at_rest(contacts: &[Contact], pieces: &[Piece], g: &Wrench) -> bool {
    let is_balanced = |z: &Vec<Q>, share: Q| {
        let force = |axis: usize| {
            let one = |(contact, z): (&Contact, &[Q])| {
                &z[0] * &contact.normal[axis] + (&z[1] - &z[2]) * &contact.tangent[axis]
            };
            contacts.iter().zip(z.chunks(4)).map(one).sum::<Q>() + &share * &g[axis]
        };
        (0..3).all(|axis| force(axis).is_zero())
    };
    let rests = |piece: &Piece| {
        piece.vertices.iter().all(|z| is_balanced(z, Q::one())) && piece.rays.iter().all(|z| is_balanced(z, Q::zero()))
    };
    !pieces.is_empty() && pieces.iter().all(rests)
}

proptest! {
    #![proptest_config(runs(PROBLEMS / 5))]

    /// A wrench is strongly stable exactly when the contact problem under it has solutions and the part rests in all of them:
    /// outside of the set it moves in some solution, inside in none.
    #[test]
    fn strongly_stable_wrenches_move_the_part_in_no_solution(setup in loose(1..=3), load in loads()) {
        let contacts = Contacts::of(&setup.0, &setup.1).list;
        let closed = ours(&setup, &all_modes(contacts.len()), false);
        let occurring: Vec<CanonicalCone> =
            closed.iter().filter_map(|cone| if let Cone::Of(cone) = cone { Some(cone.clone()) } else { None }).collect();
        let g = load.wrench(&occurring);
        let lcp = contact_problem(&setup.0, &contacts, &g);
        let Enumeration::Complete(solutions) = enumerate(&lcp, 100_000) else { panic!("fewer cases than that") };
        let question = Question { wrenches: vec![g.clone()], ..Question::default() };
        let verdict = &stability(&setup.0, &setup.1, &question).unwrap().wrenches[0];
        prop_assert_eq!(verdict.strong, is_always_at_rest(&contacts, &solutions.pieces, &g), "under {:?}", g);
    }
}

proptest! {
    #![proptest_config(runs(PROBLEMS))]

    /// The contact problem has a solution of a mode exactly when the mode's cone holds the wrench, over `s`, `l`, `r`, `n`.
    #[test]
    fn solutions_have_the_modes_whose_cones_hold_the_wrench(setup in loose(1..=3), load in loads()) {
        let contacts = Contacts::of(&setup.0, &setup.1).list;
        let modes = all_modes(contacts.len());
        let closed = ours(&setup, &modes, false);
        let breaking = ours(&setup, &modes, true);
        let occurring: Vec<CanonicalCone> =
            closed.iter().filter_map(|cone| if let Cone::Of(cone) = cone { Some(cone.clone()) } else { None }).collect();
        let g = load.wrench(&occurring);
        let lcp = contact_problem(&setup.0, &contacts, &g);
        let Enumeration::Complete(solutions) = enumerate(&lcp, 100_000) else { panic!("fewer cases than that") };
        let pieces: Vec<_> = solutions.pieces.iter().map(|piece| generators(&lcp, piece)).collect();
        for (cones, strict_s) in [(closed, false), (breaking, true)] {
            let is_solved = |mode: &&String| pieces.iter().any(|piece| has_mode(piece, mode, strict_s));
            let solved: Vec<&String> = modes.iter().filter(is_solved).collect();
            let held: Vec<&String> = modes.iter().zip(&cones).filter(|(_, cone)| in_cone(cone, &g)).map(|at| at.0).collect();
            prop_assert_eq!(solved, held, "solved and held, s strict: {}, under {:?}", strict_s, g);
        }
    }
}
