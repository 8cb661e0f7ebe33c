//! Good case files: every spelling and default, against numbers computed elsewhere.

use partplan::case::{Case, Limits, Section, read, read_for};
use partplan::exact::{Q, Z, parse_literal, ratio};
use partplan::model::{GivenPush, LengthUnit, Place, Range, Shape};
use proptest::prelude::*;
use serde_json::Value;

fn case(text: &str) -> Case {
    match read(text.as_bytes(), &Limits::default()) {
        Ok(case) => case,
        Err(faults) => panic!("{text}\n{faults:#?}"),
    }
}

fn q(text: &str) -> Q {
    parse_literal(text).unwrap()
}

fn point(x: &str, y: &str) -> [Q; 2] {
    [q(x), q(y)]
}

/// A rectangle, 6 by 4, with `rest` in its part.
fn part(rest: &str) -> Case {
    case(&format!("{{\"part\": {{\"shape\": {{\"polygon\": [[0, 0], [6, 0], [6, 4], [0, 4]]}}{rest}}}}}"))
}

fn with_fixel(shape: &str, fixel: &str) -> Case {
    case(&format!("{{\"part\": {{\"shape\": {shape}}}, \"insert\": {{\"fixels\": [{fixel}]}}}}"))
}

const RECTANGLE: &str = r#"{"polygon": [[0, 0], [6, 0], [6, 4], [0, 4]]}"#;
const DISC: &str = r#"{"circle": {"center": [1, 2], "radius": 5}}"#;

fn friction(text: &str) -> [Range; 2] {
    let case = with_fixel(RECTANGLE, &format!("{{\"at\": [2, 0], \"friction\": {text}}}"));
    let friction = case.fixture.unwrap().fixels.remove(0).friction;
    [friction.static_, friction.kinetic]
}

fn range(min: &str, max: &str) -> Range {
    Range { min: q(min), max: q(max) }
}

fn cross(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[1] - &a[1] * &b[0]
}

fn dot(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1]
}

/// The result files write integers bare and other rationals as strings.
fn rational(value: &Value) -> Q {
    value.as_str().map_or_else(|| q(&value.to_string()), q)
}

fn vector(value: &Value) -> [Q; 2] {
    [rational(&value[0]), rational(&value[1])]
}

/// Name, case and published results of every case in a folder.
fn published(folder: &str) -> impl Iterator<Item = (String, Case, Value)> {
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    paths.filter_map(|path| {
        let name = path.file_name().unwrap().to_str().unwrap().to_string();
        if !name.ends_with(".json") || name.ends_with(".expected.json") {
            return None;
        }
        let expected = std::fs::read(path.with_extension("expected.json")).unwrap();
        let case = read(&std::fs::read(&path).unwrap(), &Limits::default()).unwrap();
        Some((name, case, serde_json::from_slice(&expected).unwrap()))
    })
}

#[test]
fn the_public_cases_read_to_their_published_numbers() {
    let mut n_cases = 0;
    for (name, case, expected) in published("tests/wrench") {
        assert_eq!(case.part.center_of_mass, vector(&expected["center_of_mass"]), "{name}");
        assert_eq!(case.part.gyration2(), rational(&expected["rho2"]), "{name}");
        let fixels = case.fixture.unwrap().fixels;
        let theirs = expected["fixels"].as_array().unwrap();
        assert_eq!(fixels.len(), theirs.len(), "{name}");
        for (fixel, theirs) in fixels.iter().zip(theirs) {
            assert_eq!(fixel.point, vector(&theirs["at"]), "{name}");
            let normal = vector(&theirs["normal"]);
            assert_eq!(cross(&fixel.normal, &normal), ratio(0, 1), "{name}");
            assert!(dot(&fixel.normal, &normal) > ratio(0, 1), "{name}");
        }
        n_cases += 1;
    }
    assert!(n_cases >= 16);
}

#[test]
fn a_bare_part_gets_its_defaults() {
    let case = part("");
    assert_eq!((case.name, case.fixture, case.warnings), (None, None, vec![]));
    assert_eq!((case.part.unit, case.part.mass), (LengthUnit::Metre, ratio(1, 1)));
    assert_eq!(case.part.center_of_mass, point("3", "2"));
    assert_eq!(case.part.center_of_mass_tolerance, ratio(0, 1));
    // (w² + h²) / 12
    assert_eq!(case.part.inertia, ratio(52, 12));
}

#[test]
fn a_disc_defaults_to_its_center_and_half_its_squared_radius() {
    let disc = case(&format!("{{\"part\": {{\"shape\": {DISC}, \"mass\": \"3/2\"}}}}")).part;
    assert_eq!(disc.shape, Shape::Circle { center: point("1", "2"), radius: ratio(5, 1) });
    assert_eq!(disc.center_of_mass, point("1", "2"));
    assert_eq!(disc.inertia, ratio(75, 4));
}

#[test]
fn mass_scales_a_default_inertia_and_a_radius_of_gyration_but_not_a_given_inertia() {
    assert_eq!(part(r#", "mass": 3"#).part.inertia, ratio(13, 1));
    assert_eq!(part(r#", "mass": 3, "radius_of_gyration": 0.5"#).part.inertia, ratio(3, 4));
    assert_eq!(part(r#", "mass": 3, "inertia": 0.5"#).part.inertia, ratio(1, 2));
}

#[test]
fn a_default_inertia_about_another_point_is_warned_about() {
    let moved = part(r#", "center_of_mass": [2.5, 2]"#);
    assert_eq!(moved.part.center_of_mass, point("5/2", "2"));
    assert_eq!(moved.part.inertia, ratio(52, 12));
    assert_eq!(moved.warnings.len(), 1);
    assert!(moved.warnings[0].contains("inertia defaults to the uniform lamina's about its centroid"));
    assert!(part(r#", "center_of_mass": [2.5, 2], "inertia": 1"#).warnings.is_empty());
    assert!(part(r#", "center_of_mass": [2.5, 2], "radius_of_gyration": 1"#).warnings.is_empty());
    assert!(part(r#", "center_of_mass": [3, 2]"#).warnings.is_empty());
}

#[test]
fn a_center_of_mass_may_have_a_tolerance() {
    let part = part(r#", "center_of_mass": {"at": [3, 2], "tolerance": 1.999}"#).part;
    assert_eq!((part.center_of_mass, part.center_of_mass_tolerance), (point("3", "2"), ratio(1999, 1000)));
}

#[test]
fn units_and_names_are_kept() {
    for (text, unit) in [("m", LengthUnit::Metre), ("cm", LengthUnit::Centimetre), ("mm", LengthUnit::Millimetre)] {
        let text =
            format!("{{\"name\": \"b\\u00e4r\", \"length_unit\": \"{text}\", \"part\": {{\"shape\": {RECTANGLE}}}}}");
        assert_eq!(case(&text).part.unit, unit);
        assert_eq!(case(&text).name.as_deref(), Some("bär"));
    }
}

#[test]
fn sections_of_other_tasks_are_left_alone() {
    let text = r#"{"pins": {"belt_friction": "NaN"}, "throw": 1, "scene": [], "part": {"shape": {"polygon": [[0, 0], [1, 0], [0, 1]]}}}"#;
    assert!(read_for(Section::Insert, text.as_bytes(), &Limits::default()).unwrap().fixture.is_none());
    assert!(read(text.as_bytes(), &Limits::default()).is_err());
    let disc = format!(
        "{{\"part\": {{\"shape\": {DISC}}}, \"insert\": {{\"fixels\": [{{\"at\": [6, 2], \"friction\": 1}}]}}, \"pins\": {{}}}}"
    );
    assert!(read_for(Section::Insert, disc.as_bytes(), &Limits::default()).unwrap().fixture.is_some());
    let pins = r#"{"insert": 3, "part": {"shape": {"polygon": [[0, 0], [1, 0], [0, 1]]}}, "pins": {"belt_friction": 1, "pin_friction": 0}}"#;
    assert!(read_for(Section::Pins, pins.as_bytes(), &Limits::default()).unwrap().conveyor.is_some());
    assert!(read_for(Section::Throw, pins.as_bytes(), &Limits::default()).unwrap().thrower.is_none());
}

/// The friction of belt and pin, in any spelling but a static and kinetic pair.
#[test]
fn friction_of_pins_is_one_range() {
    let conveyor = |belt: &str, pin: &str| {
        let pins = format!("{{\"belt_friction\": {belt}, \"pin_friction\": {pin}}}");
        let conveyor = case(&format!("{{\"part\": {{\"shape\": {RECTANGLE}}}, \"pins\": {pins}}}")).conveyor.unwrap();
        [conveyor.belt_friction, conveyor.pin_friction]
    };
    assert_eq!(conveyor("\"4/3\"", "0.0875"), [range("4/3", "4/3"), range("7/80", "7/80")]);
    assert_eq!(conveyor("{\"min\": 1, \"max\": \"4/3\"}", "0"), [range("1", "4/3"), range("0", "0")]);
    let [belt, pin] = conveyor("{\"angle_deg\": {\"min\": 51, \"max\": 55}}", "{\"angle_deg\": 45}");
    // tan 51 = 1.2348971565350513985..., tan 55 = 1.4281480067421145021...
    assert!(belt.min <= q("1.2348971565350514") && belt.max >= q("1.4281480067421145"));
    assert!(belt.min > q("1.23489715653") && belt.max < q("1.42814800675"));
    assert_eq!(pin, range("1", "1"));
    // as the friction of a fixel is read
    assert_eq!([belt.clone(), belt], friction("{\"angle_deg\": {\"min\": 51, \"max\": 55}}"));
}

/// Gravity of 9.81 m/s² in the unit of the case, unless it is given.
#[test]
fn arms_are_read_exactly() {
    let thrower = |unit: &str, rest: &str| {
        let arm = format!("{{\"offset\": \"-1/3\", \"release_deg_per_s\": 320.5{rest}}}");
        let text = format!("{{\"length_unit\": \"{unit}\", \"part\": {{\"shape\": {RECTANGLE}}}, \"throw\": {arm}}}");
        case(&text).thrower.unwrap()
    };
    for (unit, gravity) in [("m", "9.81"), ("cm", "981"), ("mm", "9810")] {
        let found = thrower(unit, "");
        assert_eq!((found.offset, found.release_deg_per_s), (q("-1/3"), q("320.5")));
        assert_eq!((found.gravity, found.friction), (q(gravity), None));
    }
    let found = thrower("cm", r#", "gravity": 966, "friction": {"min": 0.3, "max": 0.5}"#);
    assert_eq!((found.gravity, found.friction), (q("966"), Some(range("0.3", "0.5"))));
    assert_eq!(thrower("m", r#", "friction": {"angle_deg": 45}"#).friction, Some(range("1", "1")));
}

#[test]
fn the_public_conveyors_read_to_their_published_numbers() {
    let mut n_cases = 0;
    for (name, case, expected) in published("tests/topple") {
        let conveyor = case.conveyor.unwrap();
        assert_eq!(case.part.center_of_mass, vector(&expected["center_of_mass"]), "{name}");
        assert_eq!(conveyor.belt_friction, Range::exactly(rational(&expected["belt_friction"])), "{name}");
        assert_eq!(conveyor.pin_friction, Range::exactly(rational(&expected["pin_friction"])), "{name}");
        n_cases += 1;
    }
    assert_eq!(n_cases, 15);
}

#[test]
fn numbers_are_the_literal_digits_and_not_the_nearest_double() {
    for (text, value) in [
        ("0.1", ratio(1, 10)),
        ("\"0.1\"", ratio(1, 10)),
        ("1e-3", ratio(1, 1000)),
        ("2.5E+1", ratio(25, 1)),
        ("\"2/6\"", ratio(1, 3)),
        ("9007199254740993", Q::from(Z::from(9_007_199_254_740_993_i64))),
    ] {
        assert_eq!(part(&format!(", \"mass\": {text}")).part.mass, value);
    }
}

#[test]
fn a_clockwise_list_is_reversed_keeping_vertex_0_first() {
    let text = r#"{"part": {"shape": {"polygon": [[0, 0], [0, 4], [6, 4], [6, 0]]}}, "insert": {"fixels": [{"edge": 0, "s": "1/3", "friction": 0}]}}"#;
    let case = case(text);
    assert_eq!(case.part, part("").part);
    let fixel = &case.fixture.unwrap().fixels[0];
    assert_eq!((&fixel.point, &fixel.normal), (&point("2", "0"), &point("0", "1")));
}

#[test]
fn an_edge_and_a_share_are_a_point() {
    let fixel = |text: &str| with_fixel(RECTANGLE, text).fixture.unwrap().fixels.remove(0);
    let inside = fixel(r#"{"edge": 2, "s": 0.25, "friction": 0}"#);
    assert_eq!(inside.place, Place::Edge { edge: 2, s: ratio(1, 4) });
    assert_eq!((inside.point, inside.normal), (point("4.5", "4"), point("0", "-1")));
    assert_eq!(fixel(r#"{"at": [4.5, 4], "friction": 0}"#).place, inside.place);
    for (text, vertex) in [("0", 2), ("1", 3), ("\"5/5\"", 3)] {
        let normal = if vertex == 2 { "[-2, -4]" } else { "[0.5, -0.5]" };
        let at_end = fixel(&format!("{{\"edge\": 2, \"s\": {text}, \"normal\": {normal}, \"friction\": 0}}"));
        assert_eq!(at_end.place, Place::Vertex { vertex });
        assert_eq!(at_end.normal, if vertex == 2 { point("-1", "-2") } else { point("1", "-1") });
    }
}

#[test]
fn a_given_normal_along_the_outlines_is_accepted() {
    let normal = |shape: &str, text: &str| with_fixel(shape, text).fixture.unwrap().fixels.remove(0).normal;
    assert_eq!(normal(RECTANGLE, r#"{"at": [2, 0], "normal": [0, "7/3"], "friction": 0}"#), point("0", "1"));
    assert_eq!(normal(DISC, r#"{"at": [4, 6], "normal": [-30, -40], "friction": 0}"#), point("-3", "-4"));
}

/// The ends of the cone are normals of one edge alone; at a reflex vertex the cone lies between them likewise.
#[test]
fn vertex_normals_are_accepted_up_to_the_ends_of_the_cone() {
    let ell = r#"{"polygon": [[0, 0], [6, 0], [6, 2], [2, 2], [2, 5], [0, 5]]}"#;
    let is_accepted = |at: &str, normal: &str| {
        let text = format!(
            "{{\"part\": {{\"shape\": {ell}}}, \"insert\": {{\"fixels\": [{{\"at\": {at}, \"normal\": {normal}, \"friction\": 0}}]}}}}"
        );
        read(text.as_bytes(), &Limits::default()).is_ok()
    };
    for (at, normals) in [
        ("[0, 0]", ["[1, 0]", "[0, 1]", "[1, 1000]"]),
        ("[2, 2]", ["[0, -1]", "[-1, 0]", "[-5, -1]"]),
        ("[2, 5]", ["[-1, 0]", "[0, -1]", "[-5, -1]"]),
    ] {
        assert!(normals.iter().all(|normal| is_accepted(at, normal)), "{at}");
    }
    assert!(!is_accepted("[0, 0]", "[1000, -1]"));
    for outside in ["[1, -1]", "[-1, 1]", "[1, 1]", "[0, 1]", "[1, 0]"] {
        assert!(!is_accepted("[2, 2]", outside), "{outside}");
    }
}

#[test]
fn a_point_close_to_an_edge_is_moved_onto_it_and_said_so() {
    let case = with_fixel(RECTANGLE, r#"{"at": [2, -0.000006], "friction": 0}"#);
    let fixel = &case.fixture.unwrap().fixels[0];
    assert_eq!((&fixel.point, &fixel.place), (&point("2", "0"), &Place::Edge { edge: 0, s: ratio(1, 3) }));
    assert_eq!(case.warnings, ["insert.fixels[0].at: [2, -0.000006] is moved onto the boundary at [2, 0], 6e-6 away"]);
    // the tolerance is a millionth of the largest extent, 6
    let beyond = r#"{"part": {"shape": {"polygon": [[0, 0], [6, 0], [6, 4], [0, 4]]}}, "insert": {"fixels": [{"at": [2, -0.0000061], "friction": 0}]}}"#;
    assert_eq!(read(beyond.as_bytes(), &Limits::default()).unwrap_err()[0].code(), "C052");
}

#[test]
fn a_point_on_a_slanted_edge_in_decimals_is_moved_to_the_exact_foot() {
    let shape = r#"{"polygon": [[0, 0], [3, 0], [0, 7]]}"#;
    let case = with_fixel(shape, r#"{"at": [1.2857143, 4], "friction": 0}"#);
    let [x, y] = &case.fixture.unwrap().fixels[0].point;
    assert_eq!(x / ratio(3, 1) + y / ratio(7, 1), ratio(1, 1));
    // the foot: the gap is along the normal (7, 3)
    assert_eq!((q("1.2857143") - x) * ratio(3, 1), (ratio(4, 1) - y) * ratio(7, 1));
    assert_eq!(case.warnings.len(), 1);
}

#[test]
fn friction_in_every_form() {
    let same = |range: Range| [range.clone(), range];
    assert_eq!(friction("0.2"), same(range("1/5", "1/5")));
    assert_eq!(friction("\"1/3\""), same(range("1/3", "1/3")));
    assert_eq!(friction("0"), same(range("0", "0")));
    assert_eq!(friction(r#"{"static": 0.3, "kinetic": 0.2}"#), [range("0.3", "0.3"), range("0.2", "0.2")]);
    assert_eq!(friction(r#"{"static": 0.3}"#), same(range("0.3", "0.3")));
    assert_eq!(friction(r#"{"min": 0.1, "max": 0.3}"#), same(range("0.1", "0.3")));
    assert_eq!(
        friction(r#"{"static": {"min": 0.2, "max": 0.4}, "kinetic": 0.2}"#),
        [range("0.2", "0.4"), range("0.2", "0.2")]
    );
    assert_eq!(
        friction(r#"{"static": {"min": 0.2, "max": 0.4}, "kinetic": {"min": 0.1, "max": 0.4}}"#),
        [range("0.2", "0.4"), range("0.1", "0.4")]
    );
    assert_eq!(friction(r#"{"static": {"min": 0.2, "max": 0.4}}"#), same(range("0.2", "0.4")));
}

#[test]
fn angles_become_ranges_that_hold_the_tangent() {
    let width = ratio(1, 1_000_000_000_000);
    let angle = |text: &str| {
        let [static_, kinetic] = friction(&format!("{{\"angle_deg\": {text}}}"));
        assert_eq!(static_, kinetic);
        static_
    };
    assert_eq!(angle("0"), range("0", "0"));
    assert_eq!(angle("45"), range("1", "1"));
    for (degrees, square) in [("60", ratio(3, 1)), ("30", ratio(1, 3))] {
        let Range { min, max } = angle(degrees);
        assert!(&min * &min <= square && square <= &max * &max);
        assert!(max - min <= width);
    }
    // tan 15° = 2 - √3, so (2 - tan)² = 3
    let Range { min, max } = angle("15");
    let square = |x: &Q| (ratio(2, 1) - x) * (ratio(2, 1) - x);
    assert!(square(&max) <= ratio(3, 1) && ratio(3, 1) <= square(&min));
    let wide = angle(r#"{"min": 30, "max": 60}"#);
    assert_eq!((&wide.min, &wide.max), (&angle("30").min, &angle("60").max));
    // below 1e-12 for an angle of 1e-30 degrees, whose tangent is not zero
    let tiny = angle("1e-30");
    assert!(tiny.min >= ratio(0, 1) && tiny.max > ratio(0, 1) && tiny.max <= width);
    // tan(90° - x) > 1/x - x for small x in radians; one radian is above 57 degrees
    assert!(angle("89.999999999").min > q("5.7e10"));
}

proptest! {
    /// tan(a + b) (1 - tan a tan b) = tan a + tan b.
    #[test]
    fn tangents_obey_the_addition_theorem(a in 0_i64..4500, b in 0_i64..4400) {
        let bounds = |hundredths: i64| {
            let enclosure = partplan::geometry::tangent_of_degrees(&ratio(hundredths, 100)).unwrap();
            prop_assert!(enclosure.lower <= enclosure.upper);
            prop_assert!(&enclosure.upper - &enclosure.lower <= ratio(1, 1_000_000_000_000));
            Ok((enclosure.lower, enclosure.upper))
        };
        let ((a_low, a_high), (b_low, b_high), (low, high)) = (bounds(a)?, bounds(b)?, bounds(a + b)?);
        let one = ratio(1, 1);
        prop_assert!(low * (&one - &a_high * &b_high) <= &a_high + &b_high);
        prop_assert!(high * (&one - &a_low * &b_low) >= &a_low + &b_low);
    }

    /// A point within the tolerance of a circle moves to a rational point exactly on it, within the tolerance.
    #[test]
    fn points_near_a_circle_are_moved_onto_it(degrees in 0.0_f64..360.0, off in -0.9_f64..0.9) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let radius = 5.0 + off * 1e-5;
        let (x, y) = (1.0 + radius * cos, 2.0 + radius * sin);
        let case = with_fixel(DISC, &format!("{{\"at\": [{x:.12}, {y:.12}], \"friction\": 0}}"));
        let fixel = case.fixture.unwrap().fixels.remove(0);
        let arm = [&fixel.point[0] - ratio(1, 1), &fixel.point[1] - ratio(2, 1)];
        prop_assert_eq!(dot(&arm, &arm), ratio(25, 1));
        let gap = [&fixel.point[0] - q(&format!("{x:.12}")), &fixel.point[1] - q(&format!("{y:.12}"))];
        prop_assert!(dot(&gap, &gap) <= q("1e-10"));
        prop_assert_eq!(cross(&arm, &fixel.normal), ratio(0, 1));
        prop_assert!(dot(&arm, &fixel.normal) < ratio(0, 1));
        prop_assert_eq!(case.warnings.len(), 1);
    }
}

/// A case may bring its own plan: a push on an edge or a rim, a tilt, a wrench, or heights of pins.
#[test]
fn plans_that_a_case_brings_are_read_exactly_and_refused_where_they_make_no_sense() {
    let text = |shape: &str, at: &str, plan: &str| {
        format!(
            "{{\"part\": {{\"shape\": {shape}}}, \"insert\": {{\"fixels\": [{{\"at\": {at}, \"friction\": 0.1}}], \"plan\": {plan}}}}}"
        )
    };
    let given = |plan: &str| case(&text(RECTANGLE, "[2, 0]", plan)).given_push.unwrap();
    assert_eq!(given(r#"{"edge": 2, "s": 0.3}"#), GivenPush::Edge { edge: 2, s: q("3/10") });
    assert_eq!(given(r#"{"tilt": [0, "-1/3"]}"#), GivenPush::Tilt(point("0", "-1/3")));
    assert_eq!(given(r#"{"wrench": [0, 1, -2]}"#), GivenPush::Wrench([q("0"), q("1"), q("-2")]));
    let on_disc = case(&text(DISC, "[6, 2]", r#"{"from": [3, 4]}"#)).given_push;
    assert_eq!(on_disc, Some(GivenPush::Circle(point("3", "4"))));
    let codes = |shape: &str, at: &str, plan: &str| -> Vec<&'static str> {
        let faults = read(text(shape, at, plan).as_bytes(), &Limits::default()).unwrap_err();
        faults.iter().map(|fault| fault.code()).collect()
    };
    assert_eq!(codes(RECTANGLE, "[2, 0]", r#"{"edge": 4, "s": 0.3}"#), ["C053"]);
    assert_eq!(codes(RECTANGLE, "[2, 0]", r#"{"from": [0, 1]}"#), ["C084"]);
    assert_eq!(codes(RECTANGLE, "[2, 0]", r#"{"tilt": [0, 0]}"#), ["C085"]);
    assert_eq!(codes(DISC, "[6, 2]", r#"{"edge": 0, "s": 0.5}"#), ["C054"]);
    let pins = |plan: &str| {
        format!(
            "{{\"part\": {{\"shape\": {RECTANGLE}}}, \"pins\": {{\"belt_friction\": 1, \"pin_friction\": 0, \"plan\": {plan}}}}}"
        )
    };
    assert_eq!(case(&pins("[3.9, \"10/3\"]")).given_pins, [q("3.9"), q("10/3")]);
    assert_eq!(read(pins("[0]").as_bytes(), &Limits::default()).unwrap_err()[0].code(), "C022");
}
