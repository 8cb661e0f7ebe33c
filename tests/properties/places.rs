//! Where a frictionless finger may push, and how a tray may tilt.

use crate::support::member::{in_arcs, on_edge};
use crate::support::modes::Contacts;
use crate::support::random::{any_friction, degenerate, discs, polygons, runs, seatable};
use crate::support::{Wrench, cross};
use num_traits::Zero;
use partplan::answer::{Arc, ArcSet, FingerSet};
use partplan::exact::{Q, ratio};
use partplan::model::{Fixture, Part, Shape};
use partplan::planner::{Question, insertion, stability};
use proptest::collection::vec;
use proptest::prelude::*;

/// A frictionless push at `point` along `direction`.
fn push(part: &Part, point: &[Q; 2], direction: [Q; 2]) -> Wrench {
    let arm = [0, 1].map(|i| &point[i] - &part.center_of_mass[i]);
    let torque = cross(&arm, &direction);
    let [x, y] = direction;
    [x, y, torque]
}

/// A named set of places or directions, and the programs' opinion of a wrench.
struct Sets {
    contacts: Contacts,
    moving: Vec<String>,
    fingers: Vec<(&'static str, FingerSet)>,
    tilts: Vec<(&'static str, ArcSet)>,
}

impl Sets {
    fn of(part: &Part, fixture: &Fixture) -> Self {
        let question = Question::default();
        let stable = stability(part, fixture, &question).expect("no modes are asked for");
        let insert = insertion(part, fixture, &question).expect("no modes are asked for");
        let contacts = Contacts::of(part, fixture);
        Self {
            moving: contacts.moving_modes(),
            contacts,
            fingers: vec![
                ("goal", insert.goal_fingers),
                ("acyclic", insert.acyclic_fingers),
                ("weak", stable.weak_fingers),
                ("strong", stable.strong_fingers),
                ("closure", stable.closure_fingers),
            ],
            tilts: vec![
                ("goal", insert.goal_tilt),
                ("acyclic", insert.acyclic_tilt),
                ("weak", stable.weak_tilt),
                ("strong", stable.strong_tilt),
            ],
        }
    }

    fn holds(&self, set: &str, g: &Wrench) -> bool {
        match set {
            "goal" => self.contacts.goal(g),
            "acyclic" => self.contacts.acyclic(g),
            "weak" => self.contacts.weak(g),
            "strong" => self.contacts.strong(&self.moving, g),
            "closure" => self.contacts.weak_interior(g),
            _ => panic!("no set is called {set}"),
        }
    }
}

/// Ends of the set's intervals on `edge`, and places close to them on both sides.
fn ends(set: &FingerSet, edge: usize) -> Vec<Q> {
    let FingerSet::Edges(edges) = set else { panic!("a polygon's finger places are on edges") };
    let intervals = edges.iter().filter(|e| e.edge == edge).flat_map(|e| &e.intervals);
    let near = ratio(1, 1_000_000_007);
    let around = intervals.flat_map(|i| i.s.clone()).flat_map(|s| [&s - &near, s.clone(), &s + &near]);
    around.filter(|s| (ratio(0, 1)..=ratio(1, 1)).contains(s)).collect()
}

fn arc_ends(set: &ArcSet) -> Vec<[Q; 2]> {
    let rational = |d: &[_; 2]| [0, 1].map(|i: usize| Q::from_integer(Clone::clone(&d[i])));
    let near = ratio(1, 1_000_000_007);
    let around = |d: [Q; 2]| {
        let turned = |by: Q| [&d[0] - &by * &d[1], &d[1] + &by * &d[0]];
        [turned(near.clone()), turned(-&near), d.clone()]
    };
    set.arcs.iter().flat_map(|arc: &Arc| [rational(&arc.from), rational(&arc.to)]).flat_map(around).collect()
}

fn check_tilts(sets: &Sets, directions: &[[Q; 2]]) -> Result<(), TestCaseError> {
    for (name, tilt) in &sets.tilts {
        for direction in directions.iter().cloned().chain(arc_ends(tilt)) {
            let [x, y] = direction.clone();
            let verdict = sets.holds(name, &[x, y, Q::zero()]);
            prop_assert_eq!(in_arcs(tilt, &direction), verdict, "tilt {} towards {:?}: {:?}", name, direction, tilt);
        }
    }
    Ok(())
}

fn check_fingers(part: &Part, sets: &Sets, shares: &[Q]) -> Result<(), TestCaseError> {
    let Shape::Polygon(polygon) = &part.shape else { panic!("edges are a polygon's") };
    for edge in 0..polygon.vertices().len() {
        let [a, b] = polygon.edge(edge);
        let along = [&b[0] - &a[0], &b[1] - &a[1]];
        for (name, places) in &sets.fingers {
            for s in shares.iter().cloned().chain(ends(places, edge)) {
                let point = [&a[0] + &s * &along[0], &a[1] + &s * &along[1]];
                let verdict = sets.holds(name, &push(part, &point, [-&along[1], along[0].clone()]));
                let ours = on_edge(places, edge, &s);
                prop_assert_eq!(ours, verdict, "{} at {} of edge {}: {:?}", name, s, edge, places);
            }
        }
    }
    Ok(())
}

/// Intervals are maximal and say where they end.
fn check_intervals(part: &Part, sets: &Sets) -> Result<(), TestCaseError> {
    let Shape::Polygon(polygon) = &part.shape else { panic!("edges are a polygon's") };
    for (name, places) in &sets.fingers {
        let FingerSet::Edges(edges) = places else { panic!("a polygon's finger places are on edges") };
        prop_assert!(edges.windows(2).all(|pair| pair[0].edge < pair[1].edge));
        for fingers in edges {
            prop_assert!(!fingers.intervals.is_empty());
            let [a, b] = polygon.edge(fingers.edge);
            for interval in &fingers.intervals {
                let [from, to] = &interval.s;
                prop_assert!(from < to || (from == to && interval.closed == [true, true]), "{} {:?}", name, interval);
                for (s, point) in interval.s.iter().zip(&interval.points) {
                    prop_assert_eq!(point, &[0, 1].map(|i| &a[i] + s * (&b[i] - &a[i])));
                }
            }
            for pair in fingers.intervals.windows(2) {
                let touch = pair[0].s[1] == pair[1].s[0];
                let apart = pair[0].s[1] < pair[1].s[0] || (touch && !pair[0].closed[1] && !pair[1].closed[0]);
                prop_assert!(apart, "{} {:?} and {:?} are one interval", name, pair[0], pair[1]);
            }
        }
    }
    Ok(())
}

fn shares() -> impl Strategy<Value = Vec<Q>> {
    vec((0..=30_i64).prop_map(|p| ratio(p, 30)), 2)
}

fn directions() -> impl Strategy<Value = Vec<[Q; 2]>> {
    let direction = (-9..=9_i64, -9..=9_i64).prop_filter("no direction", |d| *d != (0, 0));
    vec(direction.prop_map(|(x, y)| [ratio(x, 1), ratio(y, 1)]), 4)
}

proptest! {
    #![proptest_config(runs(16))]

    #[test]
    fn fingers_push_exactly_where_the_programs_say(
        (part, fixture) in prop_oneof![polygons(1..=3, any_friction()), seatable()],
        shares in shares(),
        directions in directions(),
    ) {
        let sets = Sets::of(&part, &fixture);
        check_intervals(&part, &sets)?;
        check_fingers(&part, &sets, &shares)?;
        check_tilts(&sets, &directions)?;
    }

    #[test]
    fn fingers_on_degenerate_fixtures_push_exactly_where_the_programs_say(
        (_, (part, fixture)) in degenerate(),
        shares in shares(),
        directions in directions(),
    ) {
        let sets = Sets::of(&part, &fixture);
        check_intervals(&part, &sets)?;
        check_fingers(&part, &sets, &shares)?;
        check_tilts(&sets, &directions)?;
    }

    #[test]
    fn fingers_push_a_disc_exactly_from_where_the_programs_say(
        (part, fixture) in discs(1..=3, any_friction()),
        directions in directions(),
    ) {
        let sets = Sets::of(&part, &fixture);
        check_tilts(&sets, &directions)?;
        let Shape::Circle { center, .. } = &part.shape else { panic!("a disc is a circle") };
        for (name, places) in &sets.fingers {
            let FingerSet::Arcs(arcs) = places else { panic!("a circle's finger places are arcs") };
            for direction in directions.iter().cloned().chain(arc_ends(arcs)) {
                // the line of the push runs through the center
                let verdict = sets.holds(name, &push(&part, center, [-&direction[0], -&direction[1]]));
                prop_assert_eq!(in_arcs(arcs, &direction), verdict, "{} from {:?}: {:?}", name, direction, arcs);
            }
        }
    }
}
