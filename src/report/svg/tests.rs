use super::super::Subject;
use super::insertion;
use crate::answer::{Action, Arc, ArcSet, EmptyReason, FingerSet, Insertion, Recommendation, Region};
use crate::exact::{Q, Z, ratio};
use crate::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};

fn disc(radius: Q) -> Part {
    Part {
        unit: LengthUnit::Millimetre,
        shape: Shape::Circle { center: [ratio(0, 1), ratio(0, 1)], radius },
        center_of_mass: [ratio(0, 1), ratio(0, 1)],
        center_of_mass_tolerance: ratio(1, 10),
        mass: ratio(1, 1),
        inertia: ratio(1, 2),
    }
}

fn fixture(radius: &Q) -> Fixture {
    let range = Range { min: ratio(1, 10), max: ratio(1, 5) };
    Fixture {
        fixels: vec![Fixel {
            place: Place::Arc,
            point: [ratio(0, 1), -radius],
            normal: [ratio(0, 1), ratio(1, 1)],
            friction: Friction { static_: range.clone(), kinetic: range },
        }],
    }
}

fn region(dim: Option<usize>) -> Region {
    Region { dim, everything: false, volume_in_box: ratio(0, 1), cells: Vec::new() }
}

fn upper_half() -> ArcSet {
    let direction = |x: i64| [Z::from(x), Z::from(0)];
    ArcSet { all: false, arcs: vec![Arc { from: direction(1), to: direction(-1), closed: [false, true] }] }
}

fn answer(plan: Option<Action>) -> Insertion {
    Insertion {
        goal: region(plan.as_ref().map(|_| 3)),
        acyclic: region(plan.as_ref().map(|_| 3)),
        hold: region(None),
        unrefuted: region(None),
        empty_because: plan.is_none().then_some(EmptyReason::DependentNormals),
        goal_fingers: FingerSet::Arcs(upper_half()),
        acyclic_fingers: FingerSet::Arcs(upper_half()),
        goal_tilt: upper_half(),
        acyclic_tilt: upper_half(),
        plan: plan.map(|action| Recommendation {
            action,
            wrench: [ratio(1, 1), ratio(-1, 1), ratio(-1, 3)],
            margin2: ratio(1, 50),
        }),
        wrenches: Vec::new(),
        modes: Vec::new(),
        robust: None,
        robust_acyclic: None,
        critical_friction: None,
        nearest_change: None,
    }
}

fn drawing(name: &str, radius: &Q, answer: &Insertion) -> String {
    let (part, fixture) = (disc(radius.clone()), fixture(radius));
    insertion(&Subject { name, part: &part, fixture: &fixture, warnings: &[] }, answer)
}

/// Checks nesting of elements, quoting of attributes and the escapes of text.
pub(super) fn assert_well_formed(svg: &str) {
    let mut open = Vec::new();
    let mut rest = svg;
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        assert!(!text.contains('>'), "a bare > in {text:?}");
        assert!(!text.contains('&') || text.contains("&amp;") || text.contains("&lt;") || text.contains("&gt;"));
        let end = start + rest[start..].find('>').expect("every tag ends");
        let tag = &rest[start + 1..end];
        assert_eq!(tag.matches('"').count() % 2, 0, "quotes in {tag:?}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "elements nest");
        } else if !tag.ends_with('/') {
            open.push(tag.split_whitespace().next().expect("a name"));
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty() && svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
}

#[test]
fn drawings_are_well_formed_whatever_the_name() {
    let push = Action::PushArc { arc: None, direction: [Z::from(0), Z::from(1)] };
    let svg = drawing("a <b> & \"c\"\u{0} > d", &ratio(1, 1), &answer(Some(push)));
    assert_well_formed(&svg);
    assert!(svg.contains("a &lt;b&gt; &amp; \"c\"  &gt; d"));
}

#[test]
fn every_action_and_no_action_can_be_drawn() {
    let direction = || [Z::from(3), Z::from(-4)];
    let actions = [
        Some(Action::PushArc { arc: None, direction: direction() }),
        Some(Action::Tilt { arc: None, direction: direction() }),
        Some(Action::Wrench),
        None,
    ];
    for action in actions {
        let has_plan = action.is_some();
        let svg = drawing("disc", &ratio(1, 1), &answer(action));
        assert_well_formed(&svg);
        assert_eq!(svg.contains("recommended"), has_plan);
    }
}

/// The units of the part change the scale bar and nothing else.
#[test]
fn a_part_of_any_size_is_drawn_alike() {
    let draw = |radius: &Q| drawing("disc", radius, &answer(None)).lines().count();
    let huge = Q::from(Z::from(10).pow(400));
    assert_eq!(draw(&ratio(1, 1)), draw(&ratio(1, 1_000_000)));
    assert_well_formed(&drawing("disc", &huge, &answer(None)));
    assert!(!drawing("disc", &huge, &answer(None)).contains("NaN"));
}
