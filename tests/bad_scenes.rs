//! Bad scenes: what is said, where, and what would be right.

use partplan::case::{Fault, Limits, missing_section, read_scene, render};
use proptest::prelude::*;

/// The text, `§` before the character that the fault must point at; code and path; words of the message and of the help.
type Bad = (String, &'static str, &'static str, &'static str, &'static str);

const BODY: &str = r#""name": "peg", "mass": 1, "pose": [0, 1, 0], "shape": {"circle": {"radius": 0.1}}"#;
const BALL: &str = r#""name": "ball", "mass": 1, "pose": [0, 0, 1, 1, 0, 0, 0], "shape": {"sphere": {"radius": 0.1}}"#;
const FLOOR: &str = r#""name": "floor", "shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}"#;

fn scene(keys: &str) -> String {
    format!("{{\"scene\": {{\"bodies\": [{{{BODY}}}], {keys}}}}}")
}

/// A scene with everything it needs, and these keys.
fn more(keys: &str) -> String {
    scene(&format!("\"duration\": 1, \"friction\": 0.2, {keys}"))
}

fn body(keys: &str) -> String {
    format!("{{\"scene\": {{\"duration\": 1, \"friction\": 0.2, \"bodies\": [{{\n{keys}}}]}}}}")
}

fn body_of(shape: &str) -> String {
    body(&format!("\"mass\": 1, \"pose\": [0, 0, 0], \"shape\": {shape}"))
}

fn more_of_body(keys: &str) -> String {
    body(&format!("{BODY}, {keys}"))
}

fn fixed(keys: &str) -> String {
    more(&format!("\"fixed\": [{{{keys}}}]"))
}

fn fixed_of(shape: &str) -> String {
    fixed(&format!("\"shape\": {shape}"))
}

fn space(keys: &str) -> String {
    format!("{{\"scene\": {{\"dimension\": 3, \"duration\": 1, \"friction\": 0.2, {keys}}}}}")
}

fn spatial_body(keys: &str) -> String {
    space(&format!("\"bodies\": [{{\"mass\": 1, {keys}}}]"))
}

fn friction(value: &str) -> String {
    scene(&format!("\"duration\": 1, \"friction\": {value}"))
}

fn pairs(between: &str) -> String {
    more(&format!(
        "\"fixed\": [{{{FLOOR}}}, {{\"name\": \"wall\", \"shape\": {{\"point\": [0, 0]}}}}], \"pairs\": [{between}]"
    ))
}

fn unmarked(text: &str) -> (String, (usize, usize)) {
    let (before, after) = text.split_once('§').unwrap_or(("", text));
    let column = before.split('\n').next_back().map_or(0, |line| line.chars().count()) + 1;
    (format!("{before}{after}"), (before.split('\n').count(), column))
}

fn faults(text: &str) -> Vec<Fault> {
    read_scene(text.as_bytes(), &Limits::default()).expect_err(text)
}

fn check((text, code, path, message, help): &Bad) {
    let (text, position) = unmarked(text);
    let found = faults(&text);
    let seen = render(&found, "bad.json", text.as_bytes(), false);
    let [fault] = &found[..] else { panic!("one fault expected\n{seen}") };
    assert_eq!((fault.code(), fault.path(), fault.position(text.as_bytes())), (*code, *path, position), "{seen}");
    assert!(fault.message().contains(message), "{message:?} is not in\n{seen}");
    assert!(fault.help_text().is_some_and(|text| text.contains(help)), "{help:?} is not in\n{seen}");
}

#[test]
fn scenes_of_the_wrong_shape() {
    let circle = r#"{"circle": {"center": [0, 0], "radius""#;
    let cases: Vec<Bad> = vec![
        (r#"§{"part": {}}"#.into(), "C017", "scene", "the section `scene` is missing", "\"duration\": 1"),
        (r#"{"scene": §[]}"#.into(), "C012", "scene", "expected an object, found a list", "\"bodies\""),
        (more("§\"duratoin\": 1"), "C011", "scene.duratoin", "unknown key", "did you mean `duration`?"),
        (r#"{"scene": §{"duration": 1, "friction": 0}}"#.into(), "C014", "scene.bodies", "`bodies` is missing", "pose"),
        (r#"{"scene": {"duration": 1, "bodies": §[]}}"#.into(), "C071", "scene.bodies", "no bodies", "\"pose\""),
        (r#"{"scene": {"duration": 1, "bodies": §3}}"#.into(), "C012", "scene.bodies", "expected a list", "\"pose\""),
        (more("\"dimension\": §4"), "C024", "scene.dimension", "2 or 3, not 4", "3 for space"),
        (more("\"gravity\": §[0, 0, -9.81]"), "C013", "scene.gravity", "expected 2 numbers, found 3", "[0, -9.81]"),
        (
            scene("\"friction\": 1").replacen("{\"bodies", "§{\"bodies", 1),
            "C014",
            "scene.duration",
            "missing",
            "seconds",
        ),
        (scene("\"friction\": 1, \"duration\": §0"), "C022", "scene.duration", "must be positive, not 0", "above 0"),
        (more("\"step\": §-1e-3"), "C022", "scene.step", "`step` must be positive, not -0.001", "above 0"),
        (more("\"margin\": §-1"), "C023", "scene.margin", "`margin` must not be negative, not -1", "write 0"),
        (more("\"directions\": §4"), "C024", "scene.directions", "2 in the plane, not 4", "leave it out"),
        (more("\"step\": §1e-400"), "C070", "scene.step", "1e-400 is beyond the range", "1e-300"),
        (more("\"gravity\": [0, §-1e999]"), "C070", "scene.gravity[1]", "-1e999 is beyond", "1e300"),
        (more("\"gravity\": [0, §\"1/0\"]"), "C020", "scene.gravity[1]", "denominator is zero", "1e-3"),
        (more("\"fixed\": §{}"), "C012", "scene.fixed", "expected a list, found an object", "leave it out"),
        (body(&BODY.replace("\"peg\"", "§7")), "C012", "scene.bodies[0].name", "expected a string", "\"peg\""),
        (
            body(&BODY.replace("\"mass\": 1,", "")).replacen("{\n", "§{\n", 1),
            "C014",
            "scene.bodies[0].mass",
            "`mass` is missing",
            "0.2",
        ),
        (body(&BODY.replace("\"mass\": 1,", "\"mass\": §0,")), "C022", "scene.bodies[0].mass", "positive", "above 0"),
        (
            more_of_body("\"inertia\": §-2"),
            "C022",
            "scene.bodies[0].inertia",
            "`inertia` must be positive, not -2",
            "above 0",
        ),
        (
            body(&BODY.replace("[0, 1, 0]", "§[0, 1]")),
            "C013",
            "scene.bodies[0].pose",
            "3 numbers, found 2",
            "[x, y, angle]",
        ),
        (more_of_body("\"velocity\": §1"), "C012", "scene.bodies[0].velocity", "expected a list", "[vx, vy, omega]"),
        (
            more_of_body("\"kinematic\": §1"),
            "C012",
            "scene.bodies[0].kinematic",
            "expected true or false, found a number",
            "as told",
        ),
        (body_of("§{}"), "C014", "scene.bodies[0].shape.polygon", "`polygon` is missing", circle),
        (
            body_of("{\"polygn\": [], §\"circle\": {\"radius\": 1}}").replacen('§', "", 1).replacen(
                "\"polygn",
                "§\"polygn",
                1,
            ),
            "C011",
            "scene.bodies[0].shape.polygn",
            "unknown key `polygn`",
            "`polygon`",
        ),
    ];
    cases.iter().for_each(check);
}

#[test]
fn shapes_that_are_none() {
    let circle = r#"{"circle": {"center": [0, 0], "radius""#;
    let polygon = "scene.bodies[0].shape.polygon";
    let cases: Vec<Bad> = vec![
        (
            body_of("{\"circle\": {\"radius\": §0}}"),
            "C022",
            "scene.bodies[0].shape.circle.radius",
            "positive",
            "above 0",
        ),
        (body_of("{\"circle\": {\"radius\": 1}, §\"polygon\": []}"), "C015", polygon, "exclude each other", circle),
        (
            body_of("{\"polygon\": §[[0, 0], [1, 0]]}"),
            "C030",
            polygon,
            "at least three vertices",
            "[[0, 0], [1, 0], [0, 1]]",
        ),
        (
            body_of("{\"polygon\": [[0, 0], [2, 2], §[2, 0], [0, 2]]}"),
            "C034",
            "scene.bodies[0].shape.polygon[2]",
            "edges 0 and 2 cross",
            "in the order",
        ),
        (body_of("{\"polygon\": §[[0, 0], [1, 0], [1, 1e-400]]}"), "C078", polygon, "rounded", "nearly coincide"),
        (body_of("{\"polygon\": §[[0, 0], [1e400, 0], [0, 1e400]]}"), "C070", polygon, "a length of 1e400", "metres"),
        (
            body_of("{§\"half_plane\": {\"point\": [0, 0], \"normal\": [0, 1]}}"),
            "C076",
            "scene.bodies[0].shape.half_plane",
            "only what is fixed",
            circle,
        ),
        (body_of("{§\"point\": [0, 0]}"), "C076", "scene.bodies[0].shape.point", "cannot be a `point`", circle),
        (
            body_of("{\"compound\": §[]}"),
            "C077",
            "scene.bodies[0].shape.compound",
            "one piece or more",
            "\"compound\": [{",
        ),
        (
            body_of("{\"compound\": [{\"compound\": §[{\"circle\": {\"radius\": 1}}]}]}"),
            "C077",
            "scene.bodies[0].shape.compound[0].compound",
            "none of them compound",
            "circle",
        ),
        (
            body_of("{§\"sphere\": {\"radius\": 1}}"),
            "C011",
            "scene.bodies[0].shape.sphere",
            "unknown key `sphere`",
            "known keys here: polygon",
        ),
        (
            fixed_of("{\"half_plane\": §{\"point\": [0, 0]}}"),
            "C014",
            "scene.fixed[0].shape.half_plane.normal",
            "missing",
            "\"normal\": [0, 1]",
        ),
        (
            fixed_of("{\"half_plane\": {\"point\": [0, 0], \"normal\": §[0, 0]}}"),
            "C056",
            "scene.fixed[0].shape.half_plane.normal",
            "the normal is zero",
            "out of the material",
        ),
        (
            fixed(&format!("{FLOOR}, \"surface_velocity\": §[1, 0]")),
            "C012",
            "scene.fixed[0].surface_velocity",
            "expected a number",
            "1e-3",
        ),
        (
            fixed(&format!("{FLOOR}, §\"mass\": 1")),
            "C011",
            "scene.fixed[0].mass",
            "unknown key `mass`",
            "known keys here: name, shape",
        ),
    ];
    cases.iter().for_each(check);
}

#[test]
fn spatial_scenes() {
    let pose = r#""pose": [0, 0, 1, 1, 0, 0, 0]"#;
    let cases: Vec<Bad> = vec![
        (
            space(&format!("\"directions\": §5, \"bodies\": [{{{BALL}}}]")),
            "C024",
            "scene.directions",
            "even, from 4 to 256, not 5",
            "write 16",
        ),
        (
            space(&format!("\"directions\": §2, \"bodies\": [{{{BALL}}}]")),
            "C024",
            "scene.directions",
            "not 2",
            "write 16",
        ),
        (
            spatial_body(&format!("{pose}, \"shape\": {{§\"polygon\": []}}")),
            "C011",
            "scene.bodies[0].shape.polygon",
            "unknown key",
            "sphere, box, half_space",
        ),
        (
            spatial_body(&format!("{pose}, \"shape\": {{\"box\": §{{}}}}")),
            "C014",
            "scene.bodies[0].shape.box.half",
            "`half` is missing",
            "\"half\": [",
        ),
        (
            spatial_body(&format!("{pose}, \"shape\": {{\"box\": {{\"size\": §[1, 0, 1]}}}}")),
            "C022",
            "scene.bodies[0].shape.box.size",
            "`size` must be positive, not 0",
            "above 0",
        ),
        (
            spatial_body(&format!(
                "{pose}, \"shape\": {{§\"half_space\": {{\"point\": [0, 0, 0], \"normal\": [0, 0, 1]}}}}"
            )),
            "C076",
            "scene.bodies[0].shape.half_space",
            "only what is fixed",
            "sphere",
        ),
        (
            spatial_body(r#""pose": §[0, 0, 1], "shape": {"sphere": {"radius": 1}}"#),
            "C013",
            "scene.bodies[0].pose",
            "expected 7 numbers, found 3",
            "upright is e0 = 1",
        ),
        (
            spatial_body(r#""pose": §[0, 0, 1, 0, 0, 0, 0], "shape": {"sphere": {"radius": 1}}"#),
            "C079",
            "scene.bodies[0].pose",
            "all zero",
            "upright",
        ),
        (
            spatial_body(&format!("{pose}, \"inertia\": §[1, 2], \"shape\": {{\"sphere\": {{\"radius\": 1}}}}")),
            "C013",
            "scene.bodies[0].inertia",
            "3 numbers, found 2",
            "principal moments",
        ),
        (
            spatial_body(&format!("{pose}, \"inertia\": [1, §0, 1], \"shape\": {{\"sphere\": {{\"radius\": 1}}}}")),
            "C022",
            "scene.bodies[0].inertia[1]",
            "positive",
            "above 0",
        ),
        (
            space(&format!(
                "\"bodies\": [§{{\"mass\": 1, {pose}, \"shape\": {{\"sphere\": {{\"center\": [0.1, 0.1, 0], \"radius\": 1}}}}}}]"
            )),
            "C014",
            "scene.bodies[0].inertia",
            "`inertia` is missing",
            "principal axes",
        ),
    ];
    cases.iter().for_each(check);
}

#[test]
fn motions_and_wrenches() {
    let cases: Vec<Bad> = vec![
        (more_of_body("\"wrench\": §[1]"), "C013", "scene.bodies[0].wrench", "3 numbers, found 1", "\"from\": 0"),
        (
            more_of_body("\"wrench\": [§{\"wrench\": [0, 0, 0]}]"),
            "C014",
            "scene.bodies[0].wrench[0].from",
            "missing",
            "seconds",
        ),
        (
            more_of_body("\"wrench\": [{\"from\": §-1, \"wrench\": [0, 0, 0]}]"),
            "C023",
            "scene.bodies[0].wrench[0].from",
            "a time must not be negative",
            "write 0",
        ),
        (
            more_of_body("\"wrench\": [{\"from\": 1, \"wrench\": [0, 0, 0]}, {\"from\": §0.5, \"wrench\": [0, 0, 0]}]"),
            "C080",
            "scene.bodies[0].wrench[1].from",
            "0.5 follows 1",
            "by time",
        ),
        (
            more_of_body("\"kinematic\": true, §\"wrench\": [0, 0, 0]"),
            "C081",
            "scene.bodies[0].wrench",
            "`wrench` is for free bodies only",
            "as told",
        ),
        (
            more_of_body("§\"motion\": []"),
            "C081",
            "scene.bodies[0].motion",
            "for kinematic bodies only",
            "\"kinematic\": true",
        ),
        (
            more_of_body(
                "\"kinematic\": true, \"velocity\": [0, 0, 0], §\"motion\": [{\"from\": 0, \"velocity\": [0, 0, 0]}]",
            ),
            "C015",
            "scene.bodies[0].motion",
            "exclude each other",
            "from",
        ),
    ];
    cases.iter().for_each(check);
}

#[test]
fn what_happens_at_contacts() {
    let one = "write one coefficient like 0.2";
    let pair = "{\"between\": [\"peg\", \"floor\"], \"friction\": 0.3}";
    let cases: Vec<Bad> = vec![
        (friction("§-0.1"), "C023", "scene.friction", "must not be negative, not -0.1", one),
        (
            friction("{§\"static\": 0.3, \"kinetic\": 0.2}"),
            "C062",
            "scene.friction.static",
            "one coefficient of friction",
            one,
        ),
        (friction("{§\"min\": 0.1, \"max\": 0.2}"), "C062", "scene.friction.min", "one coefficient of friction", one),
        (
            friction("{\"angle_deg\": §{\"min\": 1, \"max\": 2}}"),
            "C062",
            "scene.friction.angle_deg",
            "one coefficient",
            one,
        ),
        (friction("{\"angle_deg\": §90}"), "C024", "scene.friction.angle_deg", "below 90 degrees, not 90", one),
        (more("\"restitution\": §1.5"), "C024", "scene.restitution", "between 0 and 1, not 1.5", "{\"poisson\": 0.5}"),
        (
            more("\"restitution\": {\"poisson\": §-1}"),
            "C024",
            "scene.restitution.poisson",
            "between 0 and 1, not -1",
            "newton",
        ),
        (
            more("\"restitution\": {\"newton\": 1, §\"poisson\": 1}"),
            "C015",
            "scene.restitution.poisson",
            "exclude",
            "newton",
        ),
        (more("\"contact\": §{\"damping\": 1}"), "C014", "scene.contact.stiffness", "missing", "\"stiffness\": 5e4"),
        (
            more("\"contact\": {\"stiffness\": §0, \"damping\": 1}"),
            "C022",
            "scene.contact.stiffness",
            "positive",
            "above 0",
        ),
        (
            more("\"contact\": {\"stiffness\": 1, \"damping\": [1, §-1]}"),
            "C023",
            "scene.contact.damping[1]",
            "`damping` must not be negative",
            "write 0",
        ),
        (
            more("\"contact\": {\"stiffness\": §[1, 1, 1], \"damping\": 1}"),
            "C013",
            "scene.contact.stiffness",
            "2 numbers, found 3",
            "[normal, tangential]",
        ),
        (
            pairs("{\"between\": [\"peg\", §\"flor\"]}"),
            "C074",
            "scene.pairs[0].between[1]",
            "named `flor`",
            "did you mean `floor`?",
        ),
        (pairs("{\"between\": §[\"peg\"]}"), "C075", "scene.pairs[0].between", "two different names", "between"),
        (
            pairs("{\"between\": §[\"peg\", \"peg\"]}"),
            "C075",
            "scene.pairs[0].between",
            "two different names",
            "itself",
        ),
        (
            pairs("{\"between\": §[\"wall\", \"floor\"]}"),
            "C075",
            "scene.pairs[0].between",
            "neither of the two moves",
            "name a body",
        ),
        (
            pairs(&format!("{pair}, {{\"between\": §[\"floor\", \"peg\"]}}")),
            "C075",
            "scene.pairs[1].between",
            "twice",
            "keep one",
        ),
        (pairs("§{\"friction\": 1}"), "C014", "scene.pairs[0].between", "missing", "[\"peg\", \"floor\"]"),
        (
            more(&format!("\"fixed\": [{{{FLOOR}}}, §{{{FLOOR}}}]")),
            "C073",
            "scene.fixed[1].name",
            "`floor` is taken",
            "another name",
        ),
        (
            scene(&format!("\"duration\": 1, \"fixed\": [{{{FLOOR}}}]")).replacen("{\"bodies", "§{\"bodies", 1),
            "C082",
            "scene.friction",
            "no friction is given between `peg` and `floor`",
            "\"pairs\": [{\"between\": [\"peg\", \"floor\"], \"friction\": 0.2}]",
        ),
        (
            format!(
                "{{\"scene\": {{\"duration\": 1, \"bodies\": [{{{BODY}, \"friction\": 0.25}}], \"fixed\": [{{{FLOOR}, \"friction\": §0.5}}]}}}}"
            ),
            "C083",
            "scene.pairs",
            "`peg` and `floor` disagree on friction",
            "\"pairs\": [{\"between\": [\"peg\", \"floor\"], \"friction\": 0.25}]",
        ),
    ];
    cases.iter().for_each(check);
}

#[test]
fn all_faults_are_collected() {
    let text = r#"{"scene": {"dimension": 2, "duration": -1, "step": 0, "bodies": [
        {"mass": 0, "shape": {"circle": {"radius": -1}}, "pose": [0, 0]}, 5,
        {"mass": 1, "shape": {"polygon": [[0, 0]]}, "pose": ["x", 0, 0]}], "fixed": [{"shape": {}}], "friction": -1}}"#;
    let found = faults(text);
    let paths: Vec<&str> = found.iter().map(Fault::path).collect();
    assert_eq!(
        paths,
        [
            "scene.duration",
            "scene.step",
            "scene.bodies[0].mass",
            "scene.bodies[0].shape.circle.radius",
            "scene.bodies[0].pose",
            "scene.bodies[1]",
            "scene.bodies[2].shape.polygon",
            "scene.bodies[2].pose[0]",
            "scene.fixed[0].shape.polygon",
        ],
        "{}",
        render(&found, "bad.json", text.as_bytes(), false)
    );
}

#[test]
fn a_missing_scene_shows_one_that_reads() {
    let fault = missing_section("scene");
    let help = fault.help_text().unwrap();
    let example = help.strip_prefix("the smallest one is ").unwrap();
    assert!(read_scene(format!("{{{example}}}").as_bytes(), &Limits::default()).is_ok(), "{example}");
}

#[test]
fn scenes_beyond_the_limits_are_refused() {
    let bodies = |count: usize| {
        let body = |index: usize| format!("{{{}}}", BODY.replace("\"peg\"", &format!("\"{index}\"")));
        let bodies = (0..count).map(body).collect::<Vec<_>>().join(",");
        format!("{{\"scene\": {{\"duration\": 1, \"friction\": 0, \"bodies\": [{bodies}]}}}}")
    };
    assert!(read_scene(bodies(200).as_bytes(), &Limits::default()).is_ok());
    let found = faults(&bodies(201));
    assert_eq!(found[0].message(), "201 bodies, more than the limit of 200");
    let few = Limits { vertices: 5, ..Limits::default() };
    let found = read_scene(bodies(6).as_bytes(), &few).unwrap_err();
    assert_eq!(found[0].message(), "6 vertices, more than the limit of 5");
}

#[test]
fn a_unit_of_length_does_not_apply_and_that_is_said() {
    let text = more("\"restitution\": 0").replacen('{', "{\"length_unit\": \"mm\", ", 1);
    let warnings = read_scene(text.as_bytes(), &Limits::default()).unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("length_unit"), "{warnings:?}");
}

/// Pieces that turn a scene into a bad one.
const PIECES: [&str; 16] = [
    "0",
    "-1",
    "1e400",
    "1e-400",
    "null",
    "[]",
    "{}",
    "\"x\"",
    "true",
    "1/3",
    "\"1/3\"",
    "[[0,0],[0,0]]",
    "§",
    "\"",
    "}",
    "-",
];

proptest! {
    /// Whatever a scene holds, there is an answer, and every fault says where and shows in type.
    #[test]
    fn damaged_scenes_are_read_or_refused(
        case in 0..3_usize,
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0..12_usize, 0..PIECES.len()), 1..4),
    ) {
        let cases = ["peg_drop", "sphere", "chute"];
        let mut bytes = std::fs::read(format!("cases/{}.json", cases[case])).unwrap();
        for (at, length, piece) in cuts {
            let at = at.index(bytes.len());
            let end = (at + length).min(bytes.len());
            bytes.splice(at..end, PIECES[piece].bytes());
        }
        if let Err(faults) = read_scene(&bytes, &Limits::default()) {
            prop_assert!(!faults.is_empty());
            prop_assert!(!render(&faults, "bad.json", &bytes, false).is_empty());
        }
    }

    /// The same, one value of a sound scene replaced as a whole.
    #[test]
    fn replaced_values_are_read_or_refused(case in 0..3_usize, at in any::<prop::sample::Index>(), piece in 0..PIECES.len()) {
        let cases = ["peg_drop", "sphere", "chute"];
        let text = std::fs::read_to_string(format!("cases/{}.json", cases[case])).unwrap();
        let starts: Vec<usize> = text.match_indices(": ").map(|(at, _)| at + 2).collect();
        let start = starts[at.index(starts.len())];
        let mut parsed = serde_json::Deserializer::from_str(&text[start..]).into_iter::<serde_json::Value>();
        prop_assume!(parsed.next().is_some_and(|value| value.is_ok()));
        let end = start + parsed.byte_offset();
        let bytes = format!("{}{}{}", &text[..start], PIECES[piece], &text[end..]).into_bytes();
        if let Err(faults) = read_scene(&bytes, &Limits::default()) {
            prop_assert!(faults.iter().all(|fault| fault.help_text().is_some()), "{faults:?}");
        }
    }
}
