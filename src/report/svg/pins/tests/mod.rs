mod cases;
mod curves;

use super::super::tests::assert_well_formed;
use super::{MOST, PAGE};
use crate::answer::{
    ActionInterval, Curve, CurveKind, Decisions, Limit, Orientation, PinAction, PinPlan, Pins, Symmetry,
};
use crate::exact::{Q, from_float_exact, ratio};
use crate::model::LengthUnit;
use cases::{Drawn, q};
use svg::node::element::tag::Type;
use svg::parser::Event;

/// A text of the page, with a box that it fills at least.
pub(in super::super) struct Written {
    pub(in super::super) text: String,
    low: [f64; 2],
    high: [f64; 2],
}

pub(in super::super) fn written(svg: &str) -> Vec<Written> {
    let (mut down, mut open, mut all) = (vec![0.0], None, Vec::new());
    for event in svg::read(svg).expect("a drawing") {
        match event {
            Event::Tag("g", Type::Start, attributes) => {
                let shift = attributes["transform"].trim_start_matches("translate(0 ").trim_end_matches(')');
                down.push(down[down.len() - 1] + shift.parse::<f64>().expect("a shift"));
            }
            Event::Tag("g", Type::End, _) => drop(down.pop()),
            Event::Tag("text", Type::Start, attributes) => open = Some(attributes),
            Event::Text(text) => {
                let Some(attributes) = open.take() else { continue };
                let value = |name: &str| attributes[name].parse::<f64>().expect("a number");
                // narrow letters are half as wide as they are tall
                let width = 0.47 * value("font-size") * text.chars().count() as f64;
                let left = match attributes.get("text-anchor").map(|anchor| &**anchor) {
                    None => value("x"),
                    Some("middle") => value("x") - width / 2.0,
                    Some(_) => value("x") - width,
                };
                let base = value("y") + down[down.len() - 1];
                let (low, high) = ([left, base - 0.7 * value("font-size")], [left + width, base]);
                all.push(Written { text: text.to_owned(), low, high });
            }
            _ => {}
        }
    }
    all
}

fn says(svg: &str, text: &str) -> bool {
    written(svg).iter().any(|written| written.text == text)
}

pub(in super::super) fn height_of(svg: &str) -> f64 {
    let rest = svg.split_once(" height=\"").expect("a height").1;
    rest.split_once('"').expect("an end").0.parse().expect("a number")
}

#[test]
fn public_cases_are_drawn_well_formed_and_without_texts_over_each_other() {
    for drawn in cases::all().into_iter().chain([12, 200].map(many)) {
        let svg = drawn.svg();
        assert_well_formed(&svg);
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{}", drawn.name);
        let texts = written(&svg);
        assert!(texts.len() > 40);
        assert_apart(&drawn.name, &texts, [PAGE, height_of(&svg)]);
    }
}

/// Texts are on a page of this width and height, and none is over another.
pub(in super::super) fn assert_apart(name: &str, texts: &[Written], [right, bottom]: [f64; 2]) {
    for (index, one) in texts.iter().enumerate() {
        let inside = one.low[0] >= 0.0 && one.high[0] <= right && one.high[1] <= bottom;
        assert!(inside, "{name}: {} leaves the page", one.text);
        for other in &texts[index + 1..] {
            let overlaps = (0..2).all(|axis| one.low[axis] < other.high[axis] && other.low[axis] < one.high[axis]);
            assert!(!overlaps, "{name}: {} is over {}", one.text, other.text);
        }
    }
}

#[test]
fn every_orientation_and_every_pin_has_its_place_in_all_three_pictures() {
    for drawn in cases::all() {
        let svg = drawn.svg();
        for edge in drawn.edges() {
            let next = drawn.answer.orientations.iter().find(|orientation| orientation.edge == edge).unwrap().next;
            for text in [format!("edge {edge}"), format!("edge {edge} \u{2192} {next}"), format!("\u{2192} {next}")] {
                assert!(says(&svg, &text), "{}: {text}", drawn.name);
            }
        }
        let pins = drawn.answer.plan.sequence.as_ref().map_or(0, Vec::len);
        for pin in 1..=pins {
            assert!(says(&svg, &format!("pin {pin}")), "{}: pin {pin}", drawn.name);
            assert!(written(&svg).iter().any(|written| written.text.starts_with(&format!("pin {pin}: "))));
        }
        assert_eq!(says(&svg, "Sequence of pins"), pins > 0);
        assert_eq!(says(&svg, "Stable orientations"), pins == 0);
    }
}

/// Heights, tolerances and what is said of them are those of the case, with units.
#[test]
fn pins_are_labelled_with_height_tolerance_and_band() {
    let svg = cases::three_pins().svg();
    // 3.6673129... < 3.9 < 4.0808972...
    assert!(says(&svg, "3.9 m \u{b1} 0.18 m") && says(&svg, "3.668 to 4.08 m"));
    // 2.8506697... < 3 < 3.0736968...
    assert!(says(&svg, "3 m \u{b1} 0.073 m") && says(&svg, "2.851 to 3.073 m"));
}

/// Each row of the sequence ends with the same edge.
#[test]
fn the_part_is_drawn_after_the_last_pin_as_it_ends() {
    let drawn = cases::three_pins();
    let mut last: Vec<f64> = Vec::new();
    let texts = written(&drawn.svg());
    let sequence = || texts.iter().take_while(|written| written.text != "Toppling graph");
    let right = sequence().filter(|written| written.text.starts_with("edge ")).map(|w| w.low[0]).fold(0.0, f64::max);
    for written in sequence().filter(|written| written.text.starts_with("edge ") && written.low[0] > right - 1.0) {
        assert_eq!(written.text, "edge 1");
        last.push(written.low[1]);
    }
    assert_eq!(last.len(), drawn.answer.stable.len());
}

#[test]
fn drawings_are_well_formed_whatever_the_name() {
    let drawn = Drawn { name: "a <b> & \"c\"\u{0} > d".to_owned(), ..cases::three_pins() };
    assert_well_formed(&drawn.svg());
    assert!(drawn.svg().contains("a &lt;b&gt; &amp; \"c\"  &gt; d"));
}

#[test]
fn every_action_is_drawn_in_its_own_way() {
    let actions = [
        Some(PinAction::Jam),
        Some(PinAction::Repeat),
        Some(PinAction::Pass),
        Some(PinAction::FallBack),
        None,
        Some(PinAction::PassUnder),
    ];
    let mut drawn = cases::three_pins();
    for (index, orientation) in drawn.answer.orientations.iter_mut().enumerate() {
        let end = |k: usize| ratio(i64::try_from(k).unwrap(), 2).into();
        // the first orientation knows all of them, the others one each
        let here: &[Option<PinAction>] = if index == 0 { &actions } else { &[Some(PinAction::PassUnder)] };
        let interval = |(k, action): (usize, &Option<PinAction>)| ActionInterval {
            from: end(k),
            to: (k + 1 < here.len()).then(|| end(k + 1)),
            action: *action,
        };
        orientation.intervals = here.iter().enumerate().map(interval).collect();
    }
    let svg = drawn.svg();
    for action in actions {
        assert!(says(&svg, action.map_or("uncertain", PinAction::name)));
    }
    let colours =
        |action: Option<PinAction>| svg.matches(&format!("fill=\"{}\"", super::action::colour(action))).count();
    // a band, a bar, and a sample in both legends
    assert_eq!((colours(Some(PinAction::Repeat)), colours(Some(PinAction::Pass))), (4, 4));
    assert!(colours(Some(PinAction::Jam)) >= 2);
    drawn.answer.orientations[0].intervals.retain(|interval| interval.action.is_some());
    assert!(!says(&drawn.svg(), "uncertain"));
}

/// A polygon of so many corners near a circle, each orientation with many intervals and curves.
fn many(n: usize) -> Drawn {
    let exact = |value: f64| from_float_exact((value * 1024.0).round() / 1024.0).unwrap();
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / n as f64;
    let hull: Vec<[Q; 2]> = (0..n).map(|k| [exact(100.0 * angle(k).cos()), exact(100.0 * angle(k).sin())]).collect();
    let turn = 360.0 / n as f64;
    let kinds = |k: usize| [CurveKind::Vertex(k), CurveKind::Rolling(k), CurveKind::Jamming(k)];
    let wave = |k: usize, t: usize| 100.0 + 99.0 * (angle(k) + t as f64 / 40.0).sin();
    let points = |k: usize| (0..=64).map(|t| [turn * t as f64 / 64.0, wave(k, t)]).collect::<Vec<_>>();
    let curves: Vec<Curve> = (0..n).flat_map(|k| kinds(k).map(|kind| Curve { kind, points: points(k) })).collect();
    let actions = [PinAction::Jam, PinAction::Repeat, PinAction::Pass];
    let count = 4 * n;
    let end = |k: usize| exact(200.0 * k as f64 / count as f64).into();
    let interval = |k: usize| ActionInterval {
        from: end(k),
        to: (k < count).then(|| end(k + 1)),
        action: Some(if k < count { actions[k % 3] } else { PinAction::PassUnder }),
    };
    let intervals: Vec<ActionInterval> = (0..=count).map(interval).collect();
    let orientation = |edge: usize| Orientation {
        edge,
        next: (edge + n - 1) % n,
        pivots: vec![edge],
        theta_t_deg: turn / 2.0,
        theta_1_deg: turn,
        height: q("200").into(),
        intervals: intervals.clone(),
        topple: Vec::new(),
        repeat_over_dip: None,
        curves: curves.clone(),
    };
    let stable: Vec<usize> = (0..n).collect();
    let answer = Pins {
        hull: hull.clone(),
        symmetry: Symmetry { shift: n, classes: stable.iter().map(|edge| vec![*edge]).collect() },
        orientations: (0..n).map(orientation).collect(),
        stable,
        plan: PinPlan::default(),
        queries: Vec::new(),
        decisions: Decisions::default(),
    };
    let part = cases::part(LengthUnit::Millimetre, hull, [q("0"), q("0")]);
    Drawn { name: "wheel".to_owned(), part, conveyor: cases::conveyor(q("1"), q("0.1")), answer }
}

#[test]
fn two_hundred_orientations_make_a_bounded_drawing_that_says_what_it_leaves_out() {
    let svg = many(200).svg();
    assert_well_formed(&svg);
    assert!(svg.len() < 2_000_000, "{} bytes", svg.len());
    assert!(height_of(&svg) < 2_000.0);
    assert!(
        written(&svg).iter().any(|written| written.text.contains(&format!("the first {MOST} of 200 orientations")))
    );
    assert!(says(&svg, "edge 0") && !says(&svg, "edge 1"));
    let twelve = many(12).svg();
    assert!((0..12).all(|edge| says(&twelve, &format!("edge {edge}"))) && !twelve.contains("the first"));
}

/// A plan may have any number of pins, and pins may share a height.
#[test]
fn a_long_sequence_is_cut_and_says_so() {
    let mut drawn = cases::three_pins();
    let pins = drawn.answer.plan.sequence.take().expect("three pins");
    let long = |index: usize| {
        let mut pin = pins[index % 3].clone();
        pin.height += ratio(i64::try_from(index / 6).unwrap(), 1000);
        pin.outcome = drawn.answer.stable.iter().map(|edge| (*edge, *edge)).collect();
        pin.after.clone_from(&drawn.answer.stable);
        pin
    };
    drawn.answer.plan.sequence = Some((0..60).map(long).collect());
    let svg = drawn.svg();
    assert_well_formed(&svg);
    let texts = written(&svg);
    let says = |text: &str| texts.iter().any(|written| written.text.contains(text));
    assert!(says("the first 6 of 60 pins") && says("the lowest 20 of 30 heights of pins"));
    assert!(says("pin 6") && !texts.iter().any(|written| written.text == "pin 7"));
    // the lowest of all heights is that of the third pin and of the sixth
    assert!(says("pins 3 and 6: 3 "));
    assert_apart(&drawn.name, &texts, [PAGE, height_of(&svg)]);
}

#[test]
fn no_pins_are_drawn_where_none_are_needed_or_the_search_was_ended() {
    let mut drawn = cases::three_pins();
    for sequence in [Some(Vec::new()), None] {
        drawn.answer.plan =
            PinPlan { limit: sequence.is_none().then_some(Limit::Time), sequence, ..PinPlan::default() };
        let svg = drawn.svg();
        assert!(says(&svg, "Stable orientations") && !says(&svg, "pin 1"));
        assert_eq!(svg.contains("the time limit"), drawn.answer.plan.limit.is_some());
    }
}

/// The unit of the part changes numbers and nothing else; no unit is too small or too large.
#[test]
fn a_part_of_any_size_is_drawn() {
    for scale in ["1e-400", "1e-7", "1e9", "1e400"].map(q) {
        let mut drawn = cases::three_pins();
        let scaled = |height: &crate::exact::Algebraic| (height.rational().unwrap() * &scale).into();
        for corner in drawn.answer.hull.iter_mut().chain([&mut drawn.part.center_of_mass]) {
            corner.iter_mut().for_each(|value| *value *= &scale);
        }
        for orientation in &mut drawn.answer.orientations {
            orientation.height = scaled(&orientation.height);
            for interval in &mut orientation.intervals {
                interval.from = scaled(&interval.from);
                interval.to = interval.to.as_ref().map(scaled);
            }
            let factor = crate::exact::to_f64(&scale);
            for point in orientation.curves.iter_mut().flat_map(|curve| &mut curve.points) {
                point[1] *= factor;
            }
        }
        for pin in drawn.answer.plan.sequence.iter_mut().flatten() {
            (pin.low, pin.high) = (scaled(&pin.low), scaled(&pin.high));
            (pin.height, pin.tolerance) = (&pin.height * &scale, &pin.tolerance * &scale);
        }
        let svg = drawn.svg();
        assert_well_formed(&svg);
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{scale}");
        assert!(says(&svg, "edge 1 \u{2192} 5"));
    }
}
