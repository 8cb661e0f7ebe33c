//! Random parts with small rational corners, and friction from none to practically infinite.

use super::topple::Conveyed;
use super::{conveyed, int, random};
use num_traits::One;
use partplan::answer::Pins;
use partplan::exact::{Q, ratio};
use partplan::geometry::Polygon;
use partplan::model::{Conveyor, Part, Range};
use partplan::planner::{PinQuestion, pins};
use proptest::collection::{btree_set, vec};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;

/// A part and a conveyor before they are built.
#[derive(Debug, Clone)]
pub struct Drawn {
    pub outline: Vec<[Q; 2]>,
    pub center: [Q; 2],
    pub belt: Q,
    pub pin: Q,
}

impl Drawn {
    pub fn new(outline: Vec<[Q; 2]>, center: [Q; 2], belt: Q, pin: Q) -> Self {
        Self { outline, center, belt, pin }
    }

    pub fn part(&self) -> Part {
        conveyed::part(&self.outline, &self.center)
    }

    pub fn conveyor(&self) -> Conveyor {
        Conveyor { belt_friction: Range::exactly(self.belt.clone()), pin_friction: Range::exactly(self.pin.clone()) }
    }

    /// What the planner says; nothing of it is uncertain.
    pub fn planned(&self) -> Pins {
        pins(&self.part(), &self.conveyor(), &PinQuestion::default()).expect("nothing in the case is uncertain")
    }

    pub fn oracle(&self) -> Conveyed {
        Conveyed::new(&self.outline, &self.center, &self.belt, &self.pin)
    }
}

/// Corners and a center of mass inside of their hull.
type Body = (Vec<[Q; 2]>, [Q; 2]);

fn coordinate() -> impl Strategy<Value = Q> {
    (-12..=12_i64, select(vec![1_i64, 1, 2, 5])).prop_map(|(p, q)| ratio(p, q))
}

/// Corners on an ellipse: convex, with up to 12 of them.
fn round() -> impl Strategy<Value = Vec<[Q; 2]>> {
    (btree_set(-14..=14_i64, 3..=12), select(vec![1_i64, 2, 5]), 0..=2_i64).prop_map(|(tangents, width, skew)| {
        let corner = |eighths: &i64| {
            let t = ratio(*eighths, 6);
            let square = &t * &t;
            let scale = int(5) / (Q::one() + &square);
            let [x, y] = [(Q::one() - square) * &scale, int(2) * t * scale];
            [&x * int(width) + &y * int(skew), y]
        };
        tangents.iter().map(corner).collect()
    })
}

/// Corners in the order of their directions: not convex as a rule.
fn jagged() -> impl Strategy<Value = Vec<[Q; 2]>> {
    (btree_set(-14..=14_i64, 4..=12), vec(2..=9_i64, 12)).prop_map(|(tangents, radii)| {
        let corner = |(fifths, radius): (&i64, &i64)| {
            let t = ratio(*fifths, 5);
            let square = &t * &t;
            let scale = int(*radius) / (Q::one() + &square);
            [(Q::one() - square) * &scale, int(2) * t * scale]
        };
        tangents.iter().zip(&radii).map(corner).collect()
    })
}

fn outlines() -> impl Strategy<Value = Vec<[Q; 2]>> {
    let few = vec([coordinate(), coordinate()], 3..=5);
    prop_oneof![2 => few, 3 => round(), 3 => jagged()]
}

/// Simple polygons of 3 to 12 corners; the center of mass is anywhere strictly inside of the hull.
pub fn bodies() -> impl Strategy<Value = Body> {
    (outlines(), vec(1..=8_i64, 12)).prop_filter_map("the outline crosses itself", |(outline, weights)| {
        let polygon = Polygon::new(outline).ok()?;
        let outline = polygon.vertices().to_vec();
        let total: i64 = weights[..outline.len()].iter().sum();
        let mean = |axis: usize| outline.iter().zip(&weights).map(|(v, w)| &v[axis] * ratio(*w, total)).sum();
        let center: [Q; 2] = [mean(0), mean(1)];
        Some((outline, center))
    })
}

pub fn belts() -> impl Strategy<Value = Q> {
    select(vec![(1, 10), (1, 2), (1, 1), (4, 3), (2, 1), (5, 1), (20, 1), (1_000_000, 1)])
        .prop_map(|(p, q)| ratio(p, q))
}

pub fn pin_frictions() -> impl Strategy<Value = Q> {
    select(vec![(0, 1), (0, 1), (1, 20), (7, 80), (1, 4), (1, 1), (1000, 1)]).prop_map(|(p, q)| ratio(p, q))
}

pub fn drawn() -> impl Strategy<Value = Drawn> {
    (bodies(), belts(), pin_frictions())
        .prop_map(|((outline, center), belt, pin)| Drawn::new(outline, center, belt, pin))
}

/// `cases` runs unless the environment says otherwise, the same in every run: where forces balance almost exactly, doubles
/// may be wrong, and a part on which they are should not turn up by chance.
pub fn runs(cases: u32) -> ProptestConfig {
    let default = random::runs_of("proptest-regressions/pins.txt", cases);
    let seed = match default.rng_seed {
        RngSeed::Random => RngSeed::Fixed(2001),
        asked => asked,
    };
    ProptestConfig { rng_seed: seed, ..default }
}
