//! Plain words for places, directions and verdicts.

use super::decimal::{self, Span, brief, near};
use super::motion::{self, Run, Shown};
use super::{Chute, Ride, Subject, Toss};
use crate::answer::{
    Action, Arc, ArcSet, CounterExample, EmptyReason, FeederPlan, FingerSet, Insertion, Interval, Pins, Proposal,
    Simulation, Stability, Status, Suggestion, Throw,
};
use crate::exact::{Q, to_f64};
use crate::model::{Range, Shape};
use num_traits::{One as _, Signed as _, Zero as _};

/// The answer of `plan feeder` in one line.
pub(super) fn feeder(chute: &Chute, answer: &FeederPlan) -> String {
    let entries = match chute.feeder.entries.len() {
        1 => "its entry".to_owned(),
        2 => "both entries".to_owned(),
        n => format!("all {n} entries"),
    };
    let evaluations = answer.trace.len();
    match &answer.best {
        Some(best) => format!(
            "parts leave as they are to from {entries} in the time-stepper; cost {} s, {} s at first",
            near(best.cost, 4),
            near(answer.start.cost, 4)
        ),
        None => {
            format!("no design was confirmed in {evaluations} evaluations; allow more (--evaluations), or wider bounds")
        }
    }
}

/// The answer of `plan insert` in one line.
pub(super) fn insertion(subject: &Subject, answer: &Insertion) -> String {
    let seats = match subject.fixture.fixels.len() {
        1 => "seats the part on its fixel".to_owned(),
        2 => "seats the part on both fixels".to_owned(),
        n => format!("seats the part on all {n} fixels"),
    };
    match answer.plan.as_ref().map(|plan| &plan.action) {
        Some(Action::PushEdge { edge, interval, .. }) => {
            format!("push on edge {edge} {}: {seats}", interval_of(subject, *edge, interval))
        }
        Some(Action::PushArc { arc, .. }) => {
            format!("push the disc towards its center {}: {seats}", arc_from(arc.as_ref(), "from"))
        }
        Some(Action::Tilt { arc, .. }) => {
            format!("tilt the tray so that gravity pulls {}: {seats}", arc_from(arc.as_ref(), "towards"))
        }
        Some(Action::Wrench) => {
            format!("apply force and torque together, no single push or tilt will do: {seats}")
        }
        None if answer.acyclic.is_empty() => {
            let reason = answer.empty_because.as_ref().map_or_else(String::new, |reason| format!(": {}", why(reason)));
            format!("no wrench is guaranteed to seat the part{reason}")
        }
        None => format!("some wrench {seats}, but none was singled out"),
    }
}

/// The answer of `plan insert --suggest` in one line.
pub(super) fn suggestion(answer: &Suggestion) -> String {
    match (answer.proposals.first(), &answer.empty_because) {
        (Some(best), _) => format!("put {}", proposal(best)),
        (None, Some(reason)) => format!("no places are certain to seat the part: {}", why(reason)),
        (None, None) => {
            "none found: no places were met from which a push or tilt is certain to seat the part".to_owned()
        }
    }
}

/// Edges, action and margin of a proposal.
pub(super) fn proposal(proposal: &Proposal) -> String {
    let mut edges: Vec<usize> = proposal.places.iter().map(|(edge, _)| *edge).collect();
    edges.sort_unstable();
    let fixels = match edges.as_slice() {
        [edge] => format!("the fixel on edge {edge}"),
        [] => "no fixels".to_owned(),
        several => {
            let several: Vec<String> = several.iter().map(usize::to_string).collect();
            format!("the fixels on edges {}", joined(&several, "and"))
        }
    };
    let action = match &proposal.plan.action {
        Action::PushEdge { edge, .. } => format!("push on edge {edge}"),
        Action::PushArc { .. } => "push on the rim".to_owned(),
        Action::Tilt { .. } => "tilt the tray".to_owned(),
        Action::Wrench => "apply a wrench".to_owned(),
    };
    format!("{fixels} and {action}: margin at least {} %", decimal::percent_at_least(&proposal.plan.margin2))
}

/// The answer of `plan stable` in one line.
pub(super) fn stability(answer: &Stability) -> String {
    let strong = &answer.strong;
    if strong.everything {
        return "the seated part cannot move, whatever wrench acts on it".to_owned();
    }
    let closure = if answer.force_closure {
        "force closure: the fixels can balance every wrench"
    } else {
        "no force closure: some wrenches move the part"
    };
    let strong = if strong.is_empty() {
        "no wrench is certain to leave it at rest".to_owned()
    } else if !strong.has_interior() {
        "it is certain to rest only under wrenches that no disturbance may touch".to_owned()
    } else {
        format!("it is certain to rest under {} % of all wrenches", decimal::percent(&strong.volume_in_box))
    };
    format!("{closure}; {strong}")
}

/// The answer of `plan pins` in one line.
pub(super) fn pins(ride: &Ride, answer: &Pins) -> String {
    let plan = &answer.plan;
    let all = match answer.symmetry.classes.len() {
        1 => "the one orientation".to_owned(),
        2 => "both orientations".to_owned(),
        count => format!("all {count} orientations"),
    };
    let goal = ride.end.map_or_else(|| "one".to_owned(), |edge| format!("edge {edge} down"));
    let turn = if ride.is_uncertain() { "are certain to turn" } else { "turn" };
    if let Some(pins) = &plan.sequence {
        return match (pins.len(), answer.stable.as_slice()) {
            (0, [only]) => format!("no pins are needed: the part rests on edge {only} only"),
            (0, stable) => {
                format!("no pins are needed: the part looks the same on each of its {} edges", stable.len())
            }
            (n, _) => {
                let end: Vec<String> = plan.end.iter().map(usize::to_string).collect();
                let alike = if end.len() > 1 { ", which look the same" } else { "" };
                let turn = if n == 1 { "turns" } else { "turn" };
                format!("{} {turn} {all} into edge {} down{alike}", count(n, "pin"), joined(&end, "or"))
            }
        };
    }
    match (plan.needs, &plan.obstacle, plan.limit) {
        (Some(least), ..) => {
            let most = ride.max_pins.map_or_else(String::new, |most| format!(", more than the {most} allowed"));
            format!("it takes {} to turn {all} into {goal}{most}", count(least, "pin"))
        }
        (None, Some(_), _) => format!("it is proved that no pins {turn} {all} into {goal}"),
        (None, None, Some(limit)) => {
            format!("undecided: the {} limit ended the search for pins that turn {all} into {goal}", limit.name())
        }
        (None, None, None) => format!("undecided: whether pins turn {all} into {goal} was not found out"),
    }
}

/// The answer of `plan throw` in one line.
pub(super) fn throw(toss: &Toss, answer: &Throw) -> String {
    let unit = toss.part.unit.symbol();
    let n_sets = answer.limit.sets.len();
    match (answer.status(), answer.window(), &answer.certificate.counterexample) {
        ("plan", Some(window), _) => {
            let (at, edges, often) = (near(window.at, 4), alike(&window.edges), often(window.throws_per_part));
            let not_all = if answer.certificate.is_invariant { "" } else { "; not from every start" };
            format!("put the sensor at {at} {unit}: when it is covered, {edges} is down, {often}{not_all}")
        }
        ("no-plan", _, Some(example)) => {
            format!("it is proved that not all throws lead to one pattern: {}", lost(toss, answer, example))
        }
        ("no-plan", ..) => "it is proved that throws lead to several patterns".to_owned(),
        _ if answer.is_stopped => "undecided: stopped before it was proved where throws lead".to_owned(),
        _ if answer.certificate.is_unique => {
            "undecided: all throws lead to one pattern, but no place of a sensor is proved to tell an edge".to_owned()
        }
        _ if answer.limit.is_unique_in_reach => {
            "undecided: every throw that was tried leads to one pattern, which is not proved at this resolution"
                .to_owned()
        }
        _ if n_sets == 0 => "undecided: no throw that was tried comes to a pattern".to_owned(),
        _ => format!("undecided: throws that were tried lead to {}", count(n_sets, "pattern")),
    }
}

/// How the part is lost where the map leads out of its domain.
fn lost(toss: &Toss, answer: &Throw, example: &CounterExample) -> String {
    let unit = toss.part.unit.symbol();
    let from = format!("from edge {} at {} {unit} the part lands", example.edge, near(example.radii[0], 6));
    let Some((edge, [_, radius])) = example.landing else { return format!("{from} beside the arm") };
    let grasp = answer.edges.iter().find(|other| other.edge == edge).and_then(|edge| edge.grasp.as_ref());
    let why = match grasp {
        Some(grasp) if radius < grasp.r_grasp.to_f64() => "where it slips or rolls when it is thrown again",
        Some(_) => "where it reaches over the pivot",
        None => "where it does not rest",
    };
    format!("{from} on edge {edge} at {} {unit}, {why}", near(radius, 6))
}

/// How often something happens, from the mean number of throws between.
pub(super) fn often(throws: f64) -> String {
    match near(throws, 3) {
        _ if !throws.is_finite() => "too seldom to be met".to_owned(),
        once if once == "1" => "at every throw".to_owned(),
        throws => format!("once in {throws} throws"),
    }
}

/// `edge 1`, or several that look the same.
pub(super) fn alike(edges: &[usize]) -> String {
    let names: Vec<String> = edges.iter().map(usize::to_string).collect();
    let same = if edges.len() > 1 { ", which look the same," } else { "" };
    format!("edge {}{same}", joined(&names, "or"))
}

/// The answer of `plan simulate` in one line.
pub(super) fn simulation<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let time = decimal::near(answer.time, 4);
    let ended = match &run.world.bodies[..] {
        [only] => match (answer.last.poses.first(), answer.last.velocities.first()) {
            (Some(pose), Some(velocity)) => {
                let does = if motion::is_at_rest::<S>(velocity) { "is at rest" } else { "moves" };
                let at = pose.as_ref().iter().take(S::DIMENSION).map(|x| motion::rounded(*x)).collect::<Vec<_>>();
                let name = motion::plain(&only.name);
                format!("{name} {does} at ({}) m, {}, after {time} s", at.join(", "), S::orientation(pose))
            }
            _ => format!("nothing is known after {time} s"),
        },
        bodies => {
            let resting = answer.last.velocities.iter().filter(|velocity| motion::is_at_rest::<S>(velocity)).count();
            format!("after {time} s {resting} of {} bodies are at rest", bodies.len())
        }
    };
    match answer.status {
        Status::Complete => ended,
        Status::Ambiguous => format!("{ended}, by one of several motions that the model allows"),
        Status::Inconsistent if answer.time < run.world.duration => {
            format!("no motion is possible at some step: {ended}")
        }
        Status::Inconsistent => format!("no finite force is consistent with some step of it: {ended}"),
        Status::Partial => {
            format!("stopped before the {} s asked for: {ended}", decimal::near(run.world.duration, 4))
        }
    }
}

/// Why no wrench is guaranteed to seat the part.
pub(super) fn why(reason: &EmptyReason) -> String {
    match reason {
        EmptyReason::DependentNormals => "the normals of the fixels are not independent".to_owned(),
        EmptyReason::PairForceClosure { fixels: [first, second] } => {
            format!("fixels {first} and {second} can jam the part between them")
        }
        EmptyReason::BlockingModes { .. } => "whatever acts, the part can stop short of a fixel or leave it".to_owned(),
    }
}

/// What would change that.
pub(super) fn remedy(reason: &EmptyReason) -> &'static str {
    match reason {
        EmptyReason::DependentNormals => {
            "use at most three fixels (two on a disc), their normals neither all parallel nor through one point"
        }
        EmptyReason::PairForceClosure { .. } => {
            "lower their friction, or move one so that each lies outside the other's friction cone"
        }
        EmptyReason::BlockingModes { .. } => "lower the friction or move a fixel",
    }
}

/// Where on an edge: "between 1.2 mm and 4.4 mm from vertex 0".
pub(super) fn interval_of(subject: &Subject, edge: usize, interval: &Interval) -> String {
    let unit = subject.part.unit.symbol();
    if interval.s[0].is_zero() && interval.s[1].is_one() && interval.closed == [true, true] {
        let next = match &subject.part.shape {
            Shape::Polygon(polygon) => (edge + 1) % polygon.vertices().len(),
            Shape::Circle { .. } => edge,
        };
        return format!("anywhere from vertex {edge} to vertex {next}");
    }
    match decimal::along_edge(&edge_length2(subject, edge), interval) {
        Span::Single(at) => format!("at one place only, about {at} {unit} from vertex {edge}"),
        Span::Between(low, high) => format!("between {low} {unit} and {high} {unit} from vertex {edge}"),
    }
}

/// Squared length of an edge; zero on a disc, which has none.
pub(super) fn edge_length2(subject: &Subject, edge: usize) -> Q {
    let Shape::Polygon(polygon) = &subject.part.shape else { return Q::default() };
    let [from, to] = polygon.edge(edge);
    let [x, y] = [&to[0] - &from[0], &to[1] - &from[1]];
    &x * &x + &y * &y
}

/// Every place of a finger set, one phrase a place.
pub(super) fn places(subject: &Subject, fingers: &FingerSet) -> Vec<String> {
    match fingers {
        FingerSet::Edges(edges) => edges
            .iter()
            .flat_map(|e| e.intervals.iter().map(|i| format!("edge {} {}", e.edge, interval_of(subject, e.edge, i))))
            .collect(),
        FingerSet::Arcs(set) => directions(set, "the rim at"),
    }
}

/// Every arc of a set of directions, each after `word`.
pub(super) fn directions(set: &ArcSet, word: &str) -> Vec<String> {
    if set.all {
        return vec![arc_from(None, word)];
    }
    set.arcs.iter().map(|arc| arc_from(Some(arc), word)).collect()
}

/// `brief` values as `(1, 2.5, -1/3)`.
pub(super) fn tuple(values: &[Q]) -> String {
    format!("({})", values.iter().map(brief).collect::<Vec<_>>().join(", "))
}

/// A point to four digits, as `(1.2, 3.4)`.
pub(super) fn point(point: &[Q; 2]) -> String {
    let [x, y] = point.each_ref().map(|v| near(to_f64(v), 4));
    format!("({x}, {y})")
}

/// Degrees of a vector, counter-clockwise from the x axis.
pub(super) fn heading(vector: &[Q; 2]) -> String {
    let scale = vector.iter().map(Q::abs).max().filter(|v| !v.is_zero()).unwrap_or_else(Q::one);
    let [x, y] = vector.each_ref().map(|v| to_f64(&(v / &scale)));
    near(y.atan2(x).to_degrees(), 4)
}

/// A friction coefficient: `0.2`, or `0.1 to 0.3`.
pub(super) fn range(range: &Range) -> String {
    let (min, max) = (brief(&range.min), brief(&range.max));
    if min == max { min } else { format!("{min} to {max}") }
}

fn arc_from(arc: Option<&Arc>, word: &str) -> String {
    let Some(arc) = arc else { return format!("{word} any direction") };
    match decimal::degrees(arc) {
        Span::Single(at) if arc.closed == [true, true] || arc.from != arc.to => {
            format!("{word} {at} deg, one direction only")
        }
        Span::Single(at) => format!("{word} any direction but {at} deg"),
        Span::Between(..) if arc.from == arc.to => {
            format!("{word} any direction but {} deg", near(decimal::angle(&arc.from), 5))
        }
        Span::Between(low, high) => format!("{word} {low} to {high} deg"),
    }
}

/// `a`, `a and b`, `a, b and c`, or with another conjunction.
pub(super) fn joined(words: &[String], conjunction: &str) -> String {
    match words {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} {conjunction} {last}", first.join(", ")),
    }
}

/// Numbers as [`joined`] by "and", all of them up to `most`, else the first and how many there are more.
pub(super) fn numbered(numbers: &[usize], most: usize) -> String {
    let shown = if numbers.len() > most { most - 1 } else { numbers.len() };
    let mut names: Vec<String> = numbers[..shown].iter().map(usize::to_string).collect();
    if shown < numbers.len() {
        names.push(format!("{} more", numbers.len() - shown));
    }
    joined(&names, "and")
}

/// `1 pin`, `2 pins`.
pub(super) fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}
