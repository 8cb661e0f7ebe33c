//! What a pin does to a part by exact toppling heights, against the part on a moving belt in the time-stepper.

use crate::support::drawn::{Drawn, bodies};
use crate::support::random::runs;
use crate::support::{conveyed, int};
use partplan::answer::{ActionInterval, Orientation, PinAction, Pins};
use partplan::exact::{Algebraic, Q, ratio, to_f64};
use partplan::planner::{PinQuestion, pins};
use partplan::verify::{Ending, PinTrials};
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Distance to the next critical height over the diameter: the stepper meets a pin from some distance and bounces by its
/// step.
const CLEAR: f64 = 0.005;

/// Turn (rad) for which a part must be stuck: inertia carries it through less.
const STUCK: f64 = 0.05;

/// Share of the energy with which a part could just roll on over the next edge that it may keep after landing on one.
const CALM: f64 = 0.5;

/// Rise of the center of mass over the diameter that must be left where a part falls back: a slow belt gives it the energy
/// for less.
const RISE: f64 = 0.002;

/// Longest way of topples that is followed.
const MAX_TOPPLES: usize = 6;

/// A part, one of its orientations, and a pin.
struct Met {
    drawn: Drawn,
    found: Pins,
    orientation: usize,
    height: Q,
    /// Largest distance between two corners.
    size: f64,
    /// The edge on which it ends, or that it is stuck; `None` where the exact answer does not speak of such a part or is
    /// cautious.
    expected: Option<Option<usize>>,
}

/// Parts at a height of which something is expected; each action as often as the next.
fn any_meeting() -> impl Strategy<Value = Met> {
    let belt = select(vec![(1, 2), (1, 1), (2, 1), (5, 1)]);
    let pin = select(vec![(0, 1), (1, 20), (1, 4), (1, 1)]);
    let wanted =
        select(vec![PinAction::PassUnder, PinAction::FallBack, PinAction::Jam, PinAction::Repeat, PinAction::Pass]);
    (bodies(), belt, pin, wanted, any::<Index>(), 2..=8_i64).prop_filter_map(
        "no wide interval does that",
        |((outline, center), belt, pin, wanted, choice, tenths)| {
            let drawn = Drawn::new(outline, center, ratio(belt.0, belt.1), ratio(pin.0, pin.1));
            let found = drawn.planned();
            let corners: Vec<[f64; 2]> = found.hull.iter().map(|[x, y]| [to_f64(x), to_f64(y)]).collect();
            let distance = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
            let size = corners.iter().flat_map(|a| corners.iter().map(move |b| distance(a, b))).fold(0.0, f64::max);
            let places: Vec<(usize, Q)> = (0..found.orientations.len())
                .flat_map(|orientation| {
                    let intervals = &found.orientations[orientation].intervals;
                    let fit = intervals.iter().filter(|interval| interval.action == Some(wanted));
                    fit.filter_map(move |interval| Some((orientation, inside(interval, size, tenths)?)))
                })
                .collect();
            let (orientation, height) = places.get(choice.index(places.len().max(1)))?.clone();
            let mut met = Met { drawn, found, orientation, height, size, expected: None };
            met.expected = met.end();
            met.expected.is_some().then_some(met)
        },
    )
}

/// A height inside of a wide interval.
fn inside(interval: &ActionInterval, size: f64, tenths: i64) -> Option<Q> {
    let from = interval.from.to_f64();
    let to = interval.to.as_ref().map_or(from + 0.2 * size, Algebraic::to_f64);
    let height = from + 0.1 * tenths as f64 * (to - from);
    (to - from > 0.03 * size && height > 0.02 * size).then(|| Q::from_float(height).expect("a finite height"))
}

impl Met {
    /// Whether a critical height of this orientation is near.
    fn is_near_critical(&self, orientation: &Orientation) -> bool {
        let height = to_f64(&self.height);
        let near = |at: f64| (at - height).abs() < CLEAR * self.size;
        orientation.intervals.iter().any(|interval| near(interval.from.to_f64()))
    }

    /// What is expected, by what happens along the way.
    fn end(&self) -> Option<Option<usize>> {
        let edges = &self.found.orientations;
        let mut at = &edges[self.orientation];
        for _ in 0..MAX_TOPPLES {
            if self.is_near_critical(at) {
                return None;
            }
            match at.action_at(&self.height).0? {
                PinAction::PassUnder => return Some(Some(at.edge)),
                PinAction::FallBack => return self.settles(at).then_some(Some(at.edge)),
                PinAction::Jam => {
                    // after a topple it meets the pin while it still moves
                    let is_first = at.edge == edges[self.orientation].edge;
                    let is_stuck = self.drawn.oracle().is_stuck_at_first(at.edge, to_f64(&self.height), STUCK);
                    return (is_first && is_stuck).then_some(None);
                }
                PinAction::Pass if self.stays(at) => return Some(Some(at.next)),
                PinAction::Repeat if self.stays(at) && at.repeat_over_dip.is_none() => {
                    at = edges.iter().find(|edge| edge.edge == at.next)?;
                }
                PinAction::Pass | PinAction::Repeat => return None,
            }
        }
        None
    }

    /// Whether a part that was tipped over comes to rest on the next edge.
    fn stays(&self, orientation: &Orientation) -> bool {
        let (from, onto) = (orientation.next + 1, orientation.next);
        // the pin may still push while it falls
        orientation.pivots.len() == 1 && self.is_calm([from, onto], self.arm(from)[2].max(self.size))
    }

    /// Whether a part that falls back comes to rest on the edge that it was lifted from.
    fn settles(&self, orientation: &Orientation) -> bool {
        let pivot = orientation.edge;
        let left = self.drawn.oracle().left_to_rise(pivot, to_f64(&self.height));
        left > RISE * self.size && self.is_calm([pivot, pivot + 1], self.arm(pivot)[2])
    }

    /// Whether a part that falls about one corner of an edge, its center of mass at rest as high as that, does not roll on
    /// over the other corner: what is left of its energy after one plastic impact there.
    fn is_calm(&self, corners: [usize; 2], high: f64) -> bool {
        let ([[ax, ay, near], [bx, by, far]], gyration2) = (corners.map(|corner| self.arm(corner)), self.gyration2());
        let height = (ax * by - ay * bx).abs() / (bx - ax).hypot(by - ay);
        // over gravity, per mass
        let kept = (high - height) * (gyration2 + ax * bx + ay * by).powi(2)
            / ((gyration2 + near * near) * (gyration2 + far * far));
        kept < CALM * (far - height)
    }

    /// From the center of mass to a corner, and how far that is.
    fn arm(&self, corner: usize) -> [f64; 3] {
        let corner = &self.found.hull[corner % self.found.hull.len()];
        let [x, y] = [0, 1].map(|axis| to_f64(&(&corner[axis] - &self.drawn.center[axis])));
        [x, y, x.hypot(y)]
    }

    fn gyration2(&self) -> f64 {
        self.size * self.size / 12.0
    }

    /// Where it ends in the time-stepper.
    fn seen(&self) -> Result<usize, Ending> {
        let mut part = conveyed::part(&self.drawn.outline, &self.drawn.center);
        part.inertia = Q::from_float(self.gyration2()).expect("a finite inertia");
        let given = [self.height.clone()];
        let trials = PinTrials::new(&part, &self.drawn.conveyor(), &self.found, &given, 0).expect("a pin");
        trials.end(self.orientation as u64)
    }
}

impl std::fmt::Debug for Met {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let edge = self.found.orientations[self.orientation].edge;
        write!(f, "{:?} on edge {edge} of {:?}, pin {}", self.drawn, self.found.stable, self.height)
    }
}

proptest! {
    #![proptest_config(runs(24))]

    /// A part ends on the edge that the exact heights say, or does not get past the pin.
    #[test]
    fn parts_topple_as_exact_heights_say(met in any_meeting()) {
        match (met.expected.flatten(), met.seen()) {
            (Some(edge), seen) => prop_assert_eq!(seen, Ok(edge)),
            (None, seen) => prop_assert!(seen.is_err(), "stuck by exact heights, but ends on {:?}", seen),
        }
    }
}

/// A block three times as high as wide on a belt of friction 1/2: a pin tips it above half of its width over the friction,
/// and is over it above its height.
#[test]
fn a_block_is_tipped_between_its_width_and_its_height() {
    let outline = vec![[int(0), int(0)], [int(1), int(0)], [int(1), int(3)], [int(0), int(3)]];
    let drawn = Drawn::new(outline, [ratio(1, 2), ratio(3, 2)], ratio(1, 2), int(0));
    let found = pins(&drawn.part(), &drawn.conveyor(), &PinQuestion::default()).unwrap();
    for (height, expected) in [(ratio(7, 10), None), (ratio(6, 5), Some(3)), (ratio(31, 10), Some(0))] {
        let met = Met {
            drawn: drawn.clone(),
            found: found.clone(),
            orientation: 0,
            height,
            size: 10.0_f64.sqrt(),
            expected: None,
        };
        assert_eq!(met.seen().ok(), expected, "{met:?}");
    }
}
