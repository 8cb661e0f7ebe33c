//! Bad case files: what is said, where, and what would be right.

use partplan::case::{Fault, Limits, Section, missing_section, read, read_for, render};
use partplan::exact::ratio;
use proptest::prelude::*;

/// A bad file, `§` before the character that the fault must point at, and what must be said of it.
struct Bad {
    text: String,
    code: &'static str,
    path: &'static str,
    message: &'static str,
    help: &'static str,
}

fn bad(
    text: impl Into<String>,
    code: &'static str,
    path: &'static str,
    message: &'static str,
    help: &'static str,
) -> Bad {
    Bad { text: text.into(), code, path, message, help }
}

fn polygon(vertices: &str) -> String {
    format!("{{\n  \"part\": {{\"shape\": {{\"polygon\": {vertices}}}}}\n}}")
}

fn part(rest: &str) -> String {
    format!("{{\n  \"part\": {{\"shape\": {{\"polygon\": [[0, 0], [6, 0], [6, 4], [0, 4]]}}, {rest}}}\n}}")
}

fn fixel(fixel: &str) -> String {
    format!(
        "{{\n  \"part\": {{\"shape\": {{\"polygon\": [[0, 0], [6, 0], [6, 4], [0, 4]]}}}},\n  \"insert\": {{\"fixels\": \
         [\n    {fixel}]}}\n}}"
    )
}

fn friction(friction: &str) -> String {
    fixel(&format!("{{\"at\": [2, 0], \"friction\": {friction}}}"))
}

fn on_circle(fixel: &str) -> String {
    format!(
        "{{\"part\": {{\"shape\": {{\"circle\": {{\"center\": [0, 0], \"radius\": 1}}}}}}, \"insert\": {{\"fixels\": [{fixel}]}}}}"
    )
}

/// The marked text without its mark, and the line and column of the mark.
fn unmarked(text: &str) -> (String, (usize, usize)) {
    let (before, after) = text.split_once('§').unwrap_or(("", text));
    let line = before.split('\n').count();
    let column = before.split('\n').next_back().map_or(0, |line| line.chars().count()) + 1;
    (format!("{before}{after}"), (line, column))
}

fn check(bad: &Bad) {
    let (text, position) = unmarked(&bad.text);
    let faults = read(text.as_bytes(), &Limits::default()).expect_err(&bad.text);
    let seen = render(&faults, "bad.json", text.as_bytes(), false);
    let [fault] = &faults[..] else {
        panic!("one fault expected in {}\n{seen}", bad.text);
    };
    assert_eq!(fault.code(), bad.code, "{seen}");
    assert_eq!(fault.path(), bad.path, "{seen}");
    assert_eq!(fault.position(text.as_bytes()), position, "{seen}");
    assert!(fault.message().contains(bad.message), "{:?} is not in\n{seen}", bad.message);
    assert!(fault.help_text().is_some_and(|help| help.contains(bad.help)), "{:?} is not in\n{seen}", bad.help);
    assert!(seen.contains(&format!("error[{}]: {}", bad.code, fault.message())), "{seen}");
    assert!(seen.contains("bad.json"), "{seen}");
}

fn faults(text: &str) -> Vec<Fault> {
    read(text.as_bytes(), &Limits::default()).expect_err(text)
}

fn codes(faults: &[Fault]) -> Vec<&'static str> {
    faults.iter().map(Fault::code).collect()
}

#[test]
fn texts_that_are_not_json() {
    let number = "write 0.125, 1e-3 or \"1/3\"";
    for case in [
        bad("", "C003", "", "the file is empty", "\"part\""),
        bad(" \n\t \r\n", "C003", "", "the file is empty", "\"part\""),
        bad("\u{feff}{}", "C005", "", "byte order mark", "UTF-8 without"),
        bad("{\n  §// no\n \"part\": 1}", "C005", "", "comments are not allowed", "remove the comment"),
        bad("{§/* no */ \"part\": 1}", "C005", "", "comments are not allowed", "remove the comment"),
        bad("{\"name\": \"a\"§,}", "C005", "", "trailing comma", "remove the comma"),
        bad("{\"name\": [1, 2§, ]}", "C005", "", "trailing comma", "remove the comma"),
        bad("{\"name\": [1§ 2]}", "C005", "", "a comma is missing", "write a comma"),
        bad("{\"name\": [1,§, 2]}", "C005", "", "a value is missing", "write a value"),
        bad("{\"name\": \"a\"§ \"part\": 1}", "C005", "", "a comma is missing", "write a comma"),
        bad("{\"name\" §1}", "C005", "", "a colon is missing", "\"key\": value"),
        bad("{§'name': 1}", "C005", "", "double quotes", "\"...\""),
        bad("{§name: 1}", "C005", "", "keys need double quotes", "\"key\": value"),
        bad("{\"name\": §\"abc}", "C005", "", "the string is not closed", "close the string"),
        bad("{\"name\": \"a§\nb\"}", "C005", "", "control character U+000A", "\\n"),
        bad("{\"name\": \"a§\\q\"}", "C005", "", "bad escape", "\\n"),
        bad("{\"name\": \"a§\\ud800\"}", "C005", "", "bad escape", "\\u0000"),
        bad("{\"name\": 1} §{}", "C005", "", "more than one value", "one JSON object"),
        bad("{\"name\": {\"a\": [1, 2§]  ", "C005", "", "the file ends before this object is closed", "complete?"),
        bad("{\"name\": [1, §2", "C005", "", "the file ends before this list is closed", "complete?"),
        bad("{\"name\": [§nul]}", "C005", "", "unexpected `nul`", "JSON needs a value"),
        bad("{\"name\": §“a”}", "C005", "", "unexpected `“`", "plain ASCII"),
        bad("{\"name\":§\u{a0}1}", "C005", "", "unexpected `\\u{a0}`", "plain ASCII"),
        bad("{\"name\": §0x10}", "C005", "", "not how JSON writes a number", number),
        bad("{\"name\": §+1}", "C005", "", "not how JSON writes a number", number),
        bad("{\"name\": §.5}", "C005", "", "not how JSON writes a number", number),
        bad("{\"name\": §5.}", "C005", "", "not how JSON writes a number", number),
        bad("{\"name\": 0§12}", "C005", "", "a comma is missing", "write a comma"),
        bad("{\"name\": 1e§}", "C005", "", "not how JSON writes a number", number),
        bad("[0, §NaN]", "C006", "", "`NaN` is not a finite number", number),
        bad("[0, §-Infinity]", "C006", "", "`-Infinity` is not a finite number", number),
    ] {
        check(&case);
    }
}

#[test]
fn values_of_the_wrong_shape() {
    let shape = "{\"circle\":";
    for case in [
        bad("§[1, 2]", "C012", "", "expected an object, found a list", "\"part\""),
        bad("§null", "C012", "", "expected an object, found null", "\"part\""),
        bad("§{\"name\": \"bracket\"}", "C017", "part", "the section `part` is missing", "\"polygon\": [["),
        bad(part("\"mass\": 1}, §\"part\": {\"mass\": 1"), "C010", "part", "`part` is given twice", "keep one"),
        bad(part("§\"masss\": 1"), "C011", "part.masss", "unknown key `masss`", "did you mean `mass`?"),
        bad(
            part("§\"color\": 1"),
            "C011",
            "part.color",
            "unknown key `color`",
            "known keys here: shape, center_of_mass",
        ),
        bad(
            part("\"mass\": 1}, §\"inserts\": {}, \"scene\": {\"x\": 1"),
            "C011",
            "inserts",
            "unknown key `inserts`",
            "`insert`",
        ),
        bad(
            part("\"mass\": 1}, \"name\": §3, \"scene\": {\"x\": 1"),
            "C012",
            "name",
            "expected a string, found a number",
            "\"name\"",
        ),
        bad(
            part("\"mass\": 1}, \"length_unit\": §\"inch\", \"scene\": {\"x\": 1"),
            "C016",
            "length_unit",
            "unit of length `inch`",
            "\"mm\"",
        ),
        bad("{\"part\": §5}", "C012", "part", "expected an object, found a number", "\"shape\""),
        bad("{\"part\": §{}}", "C014", "part.shape", "`shape` is missing", shape),
        bad("{\"part\": {\"shape\": §{}}}", "C014", "part.shape.polygon", "`polygon` is missing", shape),
        bad("{\"part\": {\"shape\": §\"square\"}}", "C012", "part.shape", "found a string", shape),
        bad(polygon("§{}"), "C012", "part.shape.polygon", "expected a list, found an object", "polygon"),
        bad(
            polygon("[[0, 0], §7, [0, 1]]"),
            "C012",
            "part.shape.polygon[1]",
            "expected a list, found a number",
            "[0.5, \"1/3\"]",
        ),
        bad(
            polygon("[[0, 0], §[1], [0, 1]]"),
            "C013",
            "part.shape.polygon[1]",
            "expected 2 numbers, found 1",
            "two numbers",
        ),
        bad(
            polygon("[[0, 0], §[1, 0, 0], [0, 1]]"),
            "C013",
            "part.shape.polygon[1]",
            "expected 2 numbers, found 3",
            "two numbers",
        ),
        bad(
            polygon("[[0, 0], [1, §true], [0, 1]]"),
            "C012",
            "part.shape.polygon[1][1]",
            "expected a number, found a boolean",
            "1e-3",
        ),
        bad(
            "{\"part\": {\"shape\": {\"polygon\": [[0, 0], [1, 0], [0, 1]], §\"circle\": {\"center\": [0, 0], \"radius\": 1}}}}",
            "C015",
            "part.shape.circle",
            "`polygon` and `circle` exclude each other",
            shape,
        ),
        bad(
            "{\"part\": {\"shape\": {\"circle\": §{\"radius\": 1}}}}",
            "C014",
            "part.shape.circle.center",
            "`center` is missing",
            shape,
        ),
        bad(
            "{\"part\": {\"shape\": {\"circle\": §{\"center\": [0, 0]}}}}",
            "C014",
            "part.shape.circle.radius",
            "`radius` is missing",
            shape,
        ),
        bad(
            part("\"mass\": 1}, \"insert\": {\"fixels\": §{}"),
            "C012",
            "insert.fixels",
            "expected a list, found an object",
            "fixels",
        ),
        bad(part("\"mass\": 1}, \"insert\": §{"), "C014", "insert.fixels", "`fixels` is missing", "fixels"),
        bad(fixel("§[1, 2]"), "C012", "insert.fixels[0]", "expected an object, found a list", "fixels"),
        bad(fixel("§{\"friction\": 1}"), "C014", "insert.fixels[0].at", "`at` is missing", "{\"edge\": 3"),
        bad(
            friction("§[0.2]"),
            "C012",
            "insert.fixels[0].friction",
            "a number or an object, found a list",
            "\"angle_deg\": 15",
        ),
        bad(friction("{\"static\": §null}"), "C012", "insert.fixels[0].friction.static", "found null", "\"min\""),
        bad(
            friction("{\"angle_deg\": §[1]}"),
            "C012",
            "insert.fixels[0].friction.angle_deg",
            "found a list",
            "\"max\": 55",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn numbers_that_are_not() {
    let help = "write 0.125, 1e-3 or \"1/3\"";
    let at = "part.mass";
    for case in [
        bad(part("\"mass\": §\"7/0\""), "C020", at, "`7/0`: the denominator is zero", help),
        bad(part("\"mass\": §\"\""), "C020", at, "expected a decimal number or a fraction", help),
        bad(part("\"mass\": §\"one\""), "C020", at, "`one`: expected a decimal number", help),
        bad(part("\"mass\": §\" 1\""), "C020", at, "` 1`: expected a decimal number", help),
        bad(part("\"mass\": §\"1/2/3\""), "C020", at, "expected a decimal number or a fraction", help),
        bad(part("\"mass\": §\"0x10\""), "C020", at, "expected a decimal number or a fraction", help),
        bad(part("\"mass\": §1e999999999"), "C020", at, "exponents beyond ±10000", help),
        bad(part("\"mass\": §1e10001"), "C020", at, "exponents beyond ±10000", help),
        bad(part("\"mass\": §\"1e-99999999999999999999999\""), "C020", at, "exponents beyond ±10000", help),
        bad(part("\"mass\": §\"NaN\""), "C006", at, "`NaN` is not a finite number", help),
        bad(part("\"mass\": §\"-inf\""), "C006", at, "`-inf` is not a finite number", help),
        bad(
            part(&format!("\"mass\": §{}", "7".repeat(30_000))),
            "C021",
            at,
            "30000 digits, more than the limit",
            "round",
        ),
        bad(part("\"mass\": §0"), "C022", at, "`mass` must be positive, not 0", "above 0"),
        bad(part("\"mass\": §-1e-3"), "C022", at, "`mass` must be positive, not -0.001", "above 0"),
        bad(part("\"inertia\": §\"-1/3\""), "C022", "part.inertia", "`inertia` must be positive, not -1/3", "above 0"),
        bad(part("\"radius_of_gyration\": §0.0"), "C022", "part.radius_of_gyration", "must be positive", "above 0"),
        bad(
            "{\"part\": {\"shape\": {\"circle\": {\"center\": [0, 0], \"radius\": §0}}}}",
            "C022",
            "part.shape.circle.radius",
            "`radius` must be positive, not 0",
            "above 0",
        ),
    ] {
        check(&case);
    }
    assert!(read(part("\"mass\": 1e400").as_bytes(), &Limits::default()).is_ok());
    assert!(read(part("\"mass\": 1e-10000").as_bytes(), &Limits::default()).is_ok());
}

#[test]
fn polygons_that_are_none() {
    let root = "part.shape.polygon";
    for case in [
        bad(polygon("§[]"), "C030", root, "at least three vertices, not 0", "[[0, 0], [1, 0], [0, 1]]"),
        bad(polygon("§[[0, 0], [1, 0]]"), "C030", root, "at least three vertices, not 2", "[[0, 0], [1, 0], [0, 1]]"),
        bad(
            polygon("§[[0, 0], [1, 1], [3, 3]]"),
            "C032",
            root,
            "all of its vertices lie on one line",
            "three vertices",
        ),
        bad(
            polygon("[[0, 0], [1, 0], §[1, 0], [0, 1]]"),
            "C031",
            "part.shape.polygon[2]",
            "vertices 1 and 2",
            "remove one",
        ),
        bad(
            polygon("[[0, 0], [1, 0], [0, 1], §[0, 0.0]]"),
            "C031",
            "part.shape.polygon[3]",
            "vertices 0 and 3",
            "closes by itself",
        ),
        bad(
            polygon("[[0, 0], [4, 0], [2, 2], [4, 4], [0, 4], §[2, 2]]"),
            "C031",
            "part.shape.polygon[5]",
            "vertices 2 and 5",
            "remove one",
        ),
        bad(
            polygon("[[0, 0], [4, 0], §[4, 6], [4, 4], [0, 4]]"),
            "C033",
            "part.shape.polygon[2]",
            "turns back on itself at vertex 2",
            "move it",
        ),
        bad(
            polygon("[[0, 0], [2, 2], §[2, 0], [0, 2]]"),
            "C034",
            "part.shape.polygon[2]",
            "edges 0 and 2 cross",
            "meet at [1, 1]",
        ),
        bad(
            polygon(&format!("§[[0, 0], [1, 0], [\"1/{}\", \"1/{}\"]]", "1".repeat(15_000), "1".repeat(14_999))),
            "C035",
            root,
            "bits over their common denominator",
            "fewer digits",
        ),
    ] {
        check(&case);
    }
}

/// A vertex on another edge touches it with both of its edges; a doubled vertex makes a spike as well.
#[test]
fn every_fault_of_an_outline_is_reported() {
    let touching = faults(&polygon("[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]"));
    assert_eq!(codes(&touching), ["C034", "C034"]);
    assert!(touching.iter().all(|fault| fault.help_text().unwrap().contains("meet at [2, 0]")));
    let doubled = faults(&polygon("[[0, 0], [4, 0], [6, 0], [4, 0], [4, 4]]"));
    assert_eq!(codes(&doubled), ["C033", "C031"]);
}

#[test]
fn centers_of_mass_outside() {
    let at = "part.center_of_mass";
    for case in [
        bad(
            part("\"center_of_mass\": §[7, 2]"),
            "C040",
            at,
            "[7, 2] is not strictly inside the part's convex hull",
            "centroid [3, 2]",
        ),
        bad(part("\"center_of_mass\": §[6, 2]"), "C040", at, "[6, 2] is not strictly inside", "centroid [3, 2]"),
        bad(part("\"center_of_mass\": §[0, 0]"), "C040", at, "[0, 0] is not strictly inside", "centroid [3, 2]"),
        bad(part("\"center_of_mass\": §{\"at\": [3, 2], \"tolerance\": 2}"), "C040", at, "[3, 2] ± 2", "centroid"),
        bad(
            part("\"center_of_mass\": {\"at\": [3, 2], \"tolerance\": §-1}"),
            "C023",
            "part.center_of_mass.tolerance",
            "not -1",
            "0.05",
        ),
        bad(
            part("\"center_of_mass\": §{\"at\": [3, 2]}"),
            "C014",
            "part.center_of_mass.tolerance",
            "`tolerance` is missing",
            "0.05",
        ),
        bad(part("\"center_of_mass\": §3"), "C012", at, "a list or an object, found a number", "[x, y]"),
        bad(
            "{\"part\": {\"shape\": {\"circle\": {\"center\": [0, 0], \"radius\": 5}}, \"center_of_mass\": §[3, 4]}}",
            "C040",
            at,
            "[3, 4] is not strictly inside the part's circle",
            "centroid [0, 0]",
        ),
        bad(
            part("\"inertia\": 1, §\"radius_of_gyration\": 2"),
            "C015",
            "part.radius_of_gyration",
            "`inertia` and `radius_of_gyration` exclude each other",
            "one of the two",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn fixels_that_do_not_touch_or_have_the_wrong_normal() {
    let at = "insert.fixels[0].at";
    let normal = "insert.fixels[0].normal";
    for case in [
        bad(part("\"mass\": 1}, \"insert\": {\"fixels\": §[]"), "C050", "insert.fixels", "no fixels", "\"at\""),
        bad(
            fixel("{\"at\": §[2, 0.5], \"friction\": 0}"),
            "C052",
            at,
            "the nearest boundary point is [2, 0], 0.5 away",
            "\"at\": [2, 0]",
        ),
        bad(
            fixel("{\"at\": §[9, 8], \"friction\": 0}"),
            "C052",
            at,
            "the nearest boundary point is [6, 4], 5 away",
            "\"at\": [6, 4]",
        ),
        bad(
            fixel("{\"at\": §[2, -0.00001], \"friction\": 0}"),
            "C052",
            at,
            "is [2, 0], 0.00001 away",
            "\"at\": [2, 0]",
        ),
        bad(on_circle("{\"at\": §[1.2, 1.6], \"friction\": 0}"), "C052", at, "is [0.6, 0.8], 1 away", "[0.6, 0.8]"),
        bad(on_circle("{\"at\": §[0, 0], \"friction\": 0}"), "C052", at, "is [1, 0], 1 away", "[1, 0]"),
        bad(
            on_circle("{§\"edge\": 0, \"s\": 0.5, \"friction\": 0}"),
            "C054",
            "insert.fixels[0].edge",
            "a circle has no edges",
            "\"at\"",
        ),
        bad(
            fixel("{\"at\": [2, 0], §\"edge\": 0, \"s\": 0.5, \"friction\": 0}"),
            "C015",
            "insert.fixels[0].edge",
            "`at` and `edge` exclude each other",
            "\"edge\": 3",
        ),
        bad(
            fixel("{\"at\": [2, 0], §\"s\": 0.5, \"friction\": 0}"),
            "C015",
            "insert.fixels[0].s",
            "`at` and `s`",
            "\"edge\": 3",
        ),
        bad(fixel("§{\"edge\": 0, \"friction\": 0}"), "C014", "insert.fixels[0].s", "`s` is missing", "\"s\": \"1/4\""),
        bad(
            fixel("§{\"s\": 0.5, \"friction\": 0}"),
            "C014",
            "insert.fixels[0].edge",
            "`edge` is missing",
            "\"edge\": 3",
        ),
        bad(
            fixel("{\"edge\": §4, \"s\": 0.5, \"friction\": 0}"),
            "C053",
            "insert.fixels[0].edge",
            "edges 0 to 3",
            "from 0",
        ),
        bad(
            fixel("{\"edge\": §-1, \"s\": 0.5, \"friction\": 0}"),
            "C053",
            "insert.fixels[0].edge",
            "no edge -1",
            "from 0",
        ),
        bad(
            fixel("{\"edge\": §0.5, \"s\": 0.5, \"friction\": 0}"),
            "C053",
            "insert.fixels[0].edge",
            "no edge 0.5",
            "from 0",
        ),
        bad(
            fixel("{\"edge\": 0, \"s\": §\"3/2\", \"friction\": 0}"),
            "C024",
            "insert.fixels[0].s",
            "from 0 to 1, not 1.5",
            "share",
        ),
        bad(
            fixel("{\"edge\": 0, \"s\": §-0.1, \"friction\": 0}"),
            "C024",
            "insert.fixels[0].s",
            "from 0 to 1, not -0.1",
            "share",
        ),
        bad(
            fixel("{\"at\": §[0, 0], \"friction\": 0}"),
            "C055",
            normal,
            "vertex 0 needs `normal`",
            "between [1, 0] and [0, 1]",
        ),
        bad(
            fixel("{\"edge\": 0, \"s\": §1, \"friction\": 0}"),
            "C055",
            normal,
            "vertex 1 needs `normal`",
            "between [0, 1] and [-1, 0]",
        ),
        bad(
            fixel("{\"at\": [0, 0], \"normal\": §[0, 0], \"friction\": 0}"),
            "C056",
            normal,
            "the normal is zero",
            "into the part",
        ),
        bad(
            fixel("{\"at\": [0, 0], \"normal\": §[-1, 100], \"friction\": 0}"),
            "C057",
            normal,
            "outside of the normal cone of vertex 0",
            "between [1, 0] and [0, 1]",
        ),
        bad(
            fixel("{\"at\": [0, 0], \"normal\": §[-1, -1], \"friction\": 0}"),
            "C057",
            normal,
            "outside of the normal cone",
            "between",
        ),
        bad(
            fixel("{\"at\": [2, 0], \"normal\": §[1, 9], \"friction\": 0}"),
            "C058",
            normal,
            "along the inward normal [0, 1]",
            "out",
        ),
        bad(
            fixel("{\"at\": [2, 0], \"normal\": §[0, -2], \"friction\": 0}"),
            "C058",
            normal,
            "[0, -1] does not point along",
            "out",
        ),
        bad(
            on_circle("{\"at\": [0, -1], \"normal\": §[1, 1], \"friction\": 0}"),
            "C058",
            normal,
            "inward normal [0, 1]",
            "out",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn friction_that_cannot_be() {
    let path = "insert.fixels[0].friction";
    for case in [
        bad(fixel("§{\"at\": [2, 0]}"), "C014", path, "`friction` is missing", "{\"static\": 0.3"),
        bad(
            fixel("{\"at\": [2, 0], §\"fricton\": 0.2, \"friction\": 0.2}"),
            "C011",
            "insert.fixels[0].fricton",
            "`fricton`",
            "`friction`?",
        ),
        bad(friction("§-0.2"), "C023", path, "a friction coefficient must not be negative, not -0.2", "write 0.2"),
        bad(
            friction("{\"min\": §0.3, \"max\": 0.1}"),
            "C025",
            "insert.fixels[0].friction.min",
            "min 0.3 is above max 0.1",
            "swap",
        ),
        bad(friction("§{\"min\": 0.3}"), "C014", "insert.fixels[0].friction.max", "`max` is missing", "\"max\": 0.3"),
        bad(
            friction("{\"static\": 0.2, \"kinetic\": §0.3}"),
            "C060",
            "insert.fixels[0].friction.kinetic",
            "kinetic friction above static: 0.3 > 0.2",
            "at most",
        ),
        bad(
            friction("{\"static\": {\"min\": 0.1, \"max\": 0.4}, \"kinetic\": §0.2}"),
            "C060",
            "insert.fixels[0].friction.kinetic",
            "0.2 > 0.1",
            "the min of kinetic friction",
        ),
        bad(
            friction("{\"static\": {\"min\": 0.2, \"max\": 0.4}, \"kinetic\": §{\"min\": 0.1, \"max\": 0.5}}"),
            "C060",
            "insert.fixels[0].friction.kinetic",
            "0.5 > 0.4",
            "the max of kinetic friction",
        ),
        bad(
            friction("§{\"kinetic\": 0.3}"),
            "C014",
            "insert.fixels[0].friction.static",
            "`static` is missing",
            "\"static\": 0.3",
        ),
        bad(friction("§{}"), "C014", "insert.fixels[0].friction.static", "`static` is missing", "write 0.2"),
        bad(
            friction("{\"min\": 0, \"max\": 1, §\"static\": 1}"),
            "C015",
            "insert.fixels[0].friction.static",
            "`min` and `static`",
            "\"static\"",
        ),
        bad(
            friction("{\"angle_deg\": 3, §\"kinetic\": 1}"),
            "C015",
            "insert.fixels[0].friction.kinetic",
            "`angle_deg` and `kinetic`",
            "write 0.2",
        ),
        bad(
            friction("{\"angle_deg\": §90}"),
            "C024",
            "insert.fixels[0].friction.angle_deg",
            "below 90 degrees, not 90",
            "{\"angle_deg\": 53}",
        ),
        bad(
            friction("{\"angle_deg\": §-1}"),
            "C024",
            "insert.fixels[0].friction.angle_deg",
            "at least 0 and below 90",
            "{\"angle_deg\": 53}",
        ),
        bad(
            friction("{\"angle_deg\": {\"min\": §9, \"max\": 8}}"),
            "C025",
            "insert.fixels[0].friction.angle_deg.min",
            "min 9 is above max 8",
            "swap",
        ),
        bad(
            friction("{\"angle_deg\": {\"min\": 9, \"max\": §90}}"),
            "C024",
            "insert.fixels[0].friction.angle_deg.max",
            "below 90 degrees, not 90",
            "{\"angle_deg\": 53}",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn sections_of_pins() {
    let square = "\"part\": {\"shape\": {\"polygon\": [[0, 0], [1, 0], [1, 1], [0, 1]]}}";
    let section = |section: &str| format!("{{{square},\n \"pins\": {section}}}");
    let pin = |friction: &str| section(&format!("{{\"belt_friction\": 1, \"pin_friction\": {friction}}}"));
    let single = r#"write 0.2, {"min": 0.1, "max": 0.3} or {"angle_deg": 15}"#;
    let circle = "{\"part\": {\"shape\": {\"circle\": {\"center\": [0, 0], \"radius\": 1}}},\n";
    for case in [
        bad(section("§[]"), "C012", "pins", "expected an object, found a list", "belt_friction"),
        bad(section("§{\"belt_friction\": 1}"), "C014", "pins.pin_friction", "`pin_friction` is missing", single),
        bad(section("§{\"pin_friction\": 1}"), "C014", "pins.belt_friction", "`belt_friction` is missing", single),
        bad(
            section("{\"belt_friction\": 1, \"pin_friction\": 0, §\"pin_frictoin\": 0}"),
            "C011",
            "pins.pin_frictoin",
            "unknown key `pin_frictoin`",
            "did you mean `pin_friction`?",
        ),
        bad(
            section("{\"belt_friction\": 1, \"pin_friction\": 0, §\"speed\": 2}"),
            "C011",
            "pins.speed",
            "unknown key `speed`",
            "known keys here: belt_friction, pin_friction",
        ),
        bad(pin("§-0.1"), "C023", "pins.pin_friction", "must not be negative, not -0.1", single),
        bad(pin("{\"min\": §\"-1/3\", \"max\": 1}"), "C023", "pins.pin_friction.min", "not be negative", single),
        bad(pin("§null"), "C012", "pins.pin_friction", "expected a number or an object, found null", single),
        bad(pin("§\"smooth\""), "C020", "pins.pin_friction", "`smooth`", "1e-3"),
        bad(pin("§\"NaN\""), "C006", "pins.pin_friction", "`NaN` is not a finite number", "1e-3"),
        bad(
            pin("{§\"static\": 0.3, \"kinetic\": 0.2}"),
            "C061",
            "pins.pin_friction.static",
            "one coefficient or range, without `static`",
            r#"or {"min": 0.2, "max": 0.3} to cover both"#,
        ),
        bad(
            pin("{\"min\": 0, \"max\": 1, §\"kinetic\": 0.2}"),
            "C061",
            "pins.pin_friction.kinetic",
            "without `kinetic`",
            "to cover both",
        ),
        bad(pin("{\"min\": §2, \"max\": 1}"), "C025", "pins.pin_friction.min", "min 2 is above max 1", "swap"),
        bad(pin("§{\"min\": 2}"), "C014", "pins.pin_friction.max", "`max` is missing", single),
        bad(
            pin("{\"angle_deg\": 5, §\"max\": 1}"),
            "C015",
            "pins.pin_friction.max",
            "`angle_deg` and `max` exclude each other",
            single,
        ),
        bad(
            pin("{\"angle_deg\": {\"min\": 5, \"max\": §90}}"),
            "C024",
            "pins.pin_friction.angle_deg.max",
            "below 90 degrees, not 90",
            "{\"angle_deg\": 53}",
        ),
        bad(
            format!("{circle} §\"pins\": {{\"belt_friction\": 1, \"pin_friction\": 0}}}}"),
            "C054",
            "pins",
            "a circle has no edges",
            "give it as a polygon",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn sections_of_throw() {
    let square = "\"part\": {\"shape\": {\"polygon\": [[0, 0], [1, 0], [1, 1], [0, 1]]}}";
    let section = |section: &str| format!("{{{square},\n \"throw\": {section}}}");
    let arm = |rest: &str| section(&format!("{{\"offset\": -0.5, \"release_deg_per_s\": 320, {rest}}}"));
    let circle = "{\"part\": {\"shape\": {\"circle\": {\"center\": [0, 0], \"radius\": 1}}},\n";
    for case in [
        bad(section("§[]"), "C012", "throw", "expected an object, found a list", "release_deg_per_s"),
        bad(section("§{\"offset\": 0}"), "C014", "throw.release_deg_per_s", "is missing", "320 for instance"),
        bad(section("§{\"release_deg_per_s\": 320}"), "C014", "throw.offset", "is missing", "-0.5 for instance"),
        bad(section("{\"offset\": §\"low\", \"release_deg_per_s\": 320}"), "C020", "throw.offset", "`low`", "1e-3"),
        bad(
            section("{\"offset\": 0, \"release_deg_per_s\": §0}"),
            "C022",
            "throw.release_deg_per_s",
            "must be positive, not 0",
            "above 0",
        ),
        bad(arm("\"gravity\": §-966"), "C022", "throw.gravity", "must be positive, not -966", "above 0"),
        bad(arm("\"friction\": §0"), "C022", "throw.friction", "must be positive, not 0", "leave friction out"),
        bad(
            arm("\"friction\": §{\"min\": 0, \"max\": 1}"),
            "C022",
            "throw.friction",
            "must be positive, not 0",
            "write a coefficient above 0",
        ),
        bad(arm("\"friction\": §-1"), "C023", "throw.friction", "must not be negative, not -1", "write 0.2"),
        bad(arm("§\"frictoin\": 1"), "C011", "throw.frictoin", "unknown key", "did you mean `friction`?"),
        bad(arm("§\"speed\": 1"), "C011", "throw.speed", "unknown key `speed`", "offset, release_deg_per_s, gravity"),
        bad(
            format!("{circle} §\"throw\": {{\"offset\": 0, \"release_deg_per_s\": 320}}}}"),
            "C054",
            "throw",
            "a circle has no edges",
            "give it as a polygon",
        ),
    ] {
        check(&case);
    }
}

#[test]
fn all_faults_of_a_pins_section_are_reported_with_those_of_the_part() {
    let text = r#"{"part": {"shape": {"polygon": [[0, 0], [1, 0], [0, 1]]}, "mass": 0},
 "pins": {"belt_friction": {"static": 1}, "pin_friction": [-1], "pins": 3}, "insert": {}}"#;
    let expected = [
        ("C022", "part.mass"),
        ("C061", "pins.belt_friction.static"),
        ("C012", "pins.pin_friction"),
        ("C011", "pins.pins"),
    ];
    let seen = |faults: &[Fault]| faults.iter().map(|f| (f.code(), f.path().to_owned())).collect::<Vec<_>>();
    let expected: Vec<(&str, String)> = expected.map(|(code, path)| (code, path.to_owned())).to_vec();
    let of_pins = read_for(Section::Pins, text.as_bytes(), &Limits::default()).unwrap_err();
    assert_eq!(seen(&of_pins), expected);
    let of_insert = read_for(Section::Insert, text.as_bytes(), &Limits::default()).unwrap_err();
    assert_eq!(codes(&of_insert), ["C022", "C014"]);
    assert_eq!(faults(text).len(), 5);
}

#[test]
fn bytes_that_are_not_utf8() {
    let text = b"{\n \"name\": \"\xc3\xa4\xff\"}";
    let faults = read(text, &Limits::default()).unwrap_err();
    assert_eq!(codes(&faults), ["C002"]);
    assert_eq!((faults[0].line(text), faults[0].column(text)), (2, 12));
    assert!(faults[0].message().contains("0xff at offset 14"));
    assert!(render(&faults, "bad.json", text, false).contains("--> bad.json:2:12"));
}

#[test]
fn files_beyond_the_limits_name_the_option() {
    let limits = Limits { bytes: 1000, vertices: 10, fixels: 3, ..Limits::default() };
    let spaces = vec![b' '; 100 << 20];
    let faults = read(&spaces, &Limits::default()).unwrap_err();
    assert_eq!(codes(&faults), ["C001"]);
    assert!(faults[0].message().contains("104857600 bytes"));
    assert!(faults[0].help_text().unwrap().contains("--max-bytes"));
    assert!(render(&faults, "spaces.json", &spaces, false).len() < 1000);
    assert_eq!(codes(&read(&spaces[..1000], &limits).unwrap_err()), ["C003"]);
    assert_eq!(codes(&read(&spaces[..1001], &limits).unwrap_err()), ["C001"]);

    let vertices: Vec<String> = (0..11).map(|i| format!("[{i}, {}]", i * i)).collect();
    let faults = read(polygon(&format!("[{}]", vertices.join(","))).as_bytes(), &limits).unwrap_err();
    assert_eq!(codes(&faults), ["C036"]);
    assert!(faults[0].message().contains("11 vertices, more than the limit of 10"));
    assert!(faults[0].help_text().unwrap().contains("--max-vertices"));
    assert!(read(polygon(&format!("[{}]", vertices[..10].join(","))).as_bytes(), &limits).is_ok());

    let many = vec!["{\"at\": [2, 0], \"friction\": {\"angle_deg\": 12.5}}"; 10_000].join(",");
    let faults = read(fixel(&many).as_bytes(), &Limits::default()).unwrap_err();
    assert_eq!(codes(&faults), ["C051"]);
    assert!(faults[0].message().contains("10000 fixels, more than the limit of 64"));
    assert!(faults[0].help_text().unwrap().contains("--max-fixels"));
}

#[test]
fn deep_nesting_is_refused_before_anything_recurses() {
    for text in ["[".repeat(10 << 20), "{\"a\":".repeat(1 << 20), format!("{}{}", "[".repeat(65), "]".repeat(65))] {
        let faults = faults(&text);
        assert_eq!(codes(&faults), ["C004"]);
        assert!(faults[0].message().contains("more than 64 deep"));
        assert!(render(&faults, "deep.json", text.as_bytes(), false).len() < 1000);
    }
    let allowed = format!("{{\"scene\": {}{}, \"part\": {{}}}}", "[".repeat(63), "]".repeat(63));
    assert_eq!(codes(&faults(&allowed)), ["C014"]);
}

#[test]
fn many_long_numbers_are_refused_once() {
    let long = "3".repeat(15_000);
    let vertices: Vec<String> = (0..200).map(|i| format!("[{i}, {long}]")).collect();
    let faults = faults(&polygon(&format!("[{}]", vertices.join(","))));
    assert_eq!(codes(&faults), ["C021"]);
    assert!(faults[0].message().contains("more than the limit of 1000000"));
}

#[test]
fn all_faults_of_a_file_are_reported_by_position() {
    let text = r#"{
  "name": 3, "nam": "x", "length_unit": "inch",
  "part": { "shape": { "polygon": [[0, 0], [4, 4], [4, 0], [0, "7/0"]] }, "mass": 0, "inertia": 1, "radius_of_gyration": 2 },
  "insert": { "fixels": [ {"at": [1, "NaN"], "edge": 2, "frction": 1},
    {"at": [1], "friction": {"static": 0.2, "kinetic": 0.3}}, {"at": [0, 0], "friction": {"min": 2, "max": 1, "min": 3}} ] }
}"#;
    let faults = faults(text);
    let expected = [
        ("C012", "name"),
        ("C011", "nam"),
        ("C016", "length_unit"),
        ("C020", "part.shape.polygon[3][1]"),
        ("C022", "part.mass"),
        ("C015", "part.radius_of_gyration"),
        ("C014", "insert.fixels[0].friction"),
        ("C006", "insert.fixels[0].at[1]"),
        ("C015", "insert.fixels[0].edge"),
        ("C011", "insert.fixels[0].frction"),
        ("C013", "insert.fixels[1].at"),
        ("C060", "insert.fixels[1].friction.kinetic"),
        ("C025", "insert.fixels[2].friction.min"),
        ("C010", "insert.fixels[2].friction.min"),
    ];
    assert_eq!(faults.iter().map(|fault| (fault.code(), fault.path())).collect::<Vec<_>>(), expected);
    let starts: Vec<usize> = faults.iter().map(|fault| fault.span().unwrap().start).collect();
    assert!(starts.is_sorted());
}

#[test]
fn a_report_underlines_the_text_and_is_short_whatever_the_file() {
    let text = polygon("[[0, 0], [4, 0], [\"7/0\", 2.5]]");
    let expected = "\
error[C020]: `7/0`: the denominator is zero
 --> cases/bad.json:2:51
  |
2 |   \"part\": {\"shape\": {\"polygon\": [[0, 0], [4, 0], [\"7/0\", 2.5]]}}
  |                                                   ^^^^^ part.shape.polygon[2][0]
  |
  = help: write 0.125, 1e-3 or \"1/3\"

";
    assert_eq!(render(&faults(&text), "cases/bad.json", text.as_bytes(), false), expected);
    let colored = render(&faults(&text), "cases/bad.json", text.as_bytes(), true);
    assert!(colored.contains("\u{1b}[") && !colored.contains(":::"));

    let vertices = vec!["[\"x\", 1]"; 9_000].join(",");
    let text = polygon(&format!("[{vertices}]"));
    let faults = faults(&text);
    assert_eq!(faults.len(), 9_000);
    let report = render(&faults, "long.json", text.as_bytes(), false);
    assert!(report.ends_with("... and 8980 more\n"));
    assert!(report.len() < 20_000);
    // 32 characters come before the list of line 2, two brackets before its first "x", nine characters to the next
    assert!(report.contains("long.json:2:44"), "{report}");
}

#[test]
fn a_missing_section_shows_the_smallest_one() {
    let fault = missing_section("insert");
    assert_eq!((fault.code(), fault.message().as_str()), ("C017", "the section `insert` is missing"));
    let report = render(std::slice::from_ref(&fault), "case.json", b"{}", false);
    assert!(report.contains("case.json") && report.contains("\"fixels\""));
    // the section that it shows is a good one
    let example = fault.help_text().unwrap().split_once("is ").unwrap().1.to_string();
    let text = format!("{{\"part\": {{\"shape\": {{\"polygon\": [[0, 0], [1, 0], [0, 1]]}}}}, {example}}}");
    assert_eq!(read(text.as_bytes(), &Limits::default()).unwrap().fixture.unwrap().fixels.len(), 1);
}

#[test]
fn a_missing_pins_section_shows_the_smallest_one() {
    let fault = missing_section("pins");
    let example = fault.help_text().unwrap().split_once("is ").unwrap().1.to_string();
    let text = format!("{{\"part\": {{\"shape\": {{\"polygon\": [[0, 0], [1, 0], [0, 1]]}}}}, {example}}}");
    let conveyor = read(text.as_bytes(), &Limits::default()).unwrap().conveyor.unwrap();
    assert_eq!((conveyor.belt_friction.min, conveyor.pin_friction.max), (ratio(1, 2), ratio(1, 10)));
}

#[test]
fn a_missing_throw_section_shows_the_smallest_one() {
    let fault = missing_section("throw");
    let example = fault.help_text().unwrap().split_once("is ").unwrap().1.to_string();
    let text = format!("{{\"part\": {{\"shape\": {{\"polygon\": [[0, 0], [1, 0], [0, 1]]}}}}, {example}}}");
    let thrower = read(text.as_bytes(), &Limits::default()).unwrap().thrower.unwrap();
    assert_eq!((thrower.offset, thrower.release_deg_per_s), (ratio(-1, 2), ratio(320, 1)));
}

/// A case with every kind of value, to be mutated.
const VALID: &str = r#"{"name": "x", "length_unit": "cm", "part": {"shape": {"polygon": [[0, 0], [8, 0], [9, 4], [3, 7], ["-1", 3.0e0]]},
 "center_of_mass": {"at": [4, 3], "tolerance": 0.05}, "mass": "1/3", "radius_of_gyration": 1e-3}, "insert": {"fixels": [
 {"at": [2, 0], "friction": 0.2}, {"edge": 3, "s": "1/4", "friction": {"static": 0.3, "kinetic": {"min": 0, "max": 0.2}}},
 {"at": [-1, 3], "normal": [2, -1], "friction": {"angle_deg": {"min": 1, "max": 3}}}]}, "pins": {"belt_friction": {"min": 1, "max": "4/3"},
 "pin_friction": {"angle_deg": {"min": 1, "max": 3}}}, "throw": {"offset": "-1/2", "release_deg_per_s": 320, "gravity": 966,
 "friction": {"min": 0.3, "max": 0.4}}}"#;

#[test]
fn the_case_to_be_mutated_is_valid() {
    assert_eq!(read(VALID.as_bytes(), &Limits::default()).map(|case| case.warnings), Ok(vec![]));
}

/// Reading ends with a case or with faults that can be shown.
fn survives(bytes: &[u8]) {
    if let Err(faults) = read(bytes, &Limits::default()) {
        assert!(!faults.is_empty());
        for fault in &faults {
            let span = fault.span().unwrap_or(0..0);
            assert!(span.start <= span.end && span.end <= bytes.len(), "{fault:?}");
        }
        assert!(render(&faults, "fuzz.json", bytes, false).contains("error[C0"));
    }
}

proptest! {
    #[test]
    fn arbitrary_bytes_do_not_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        survives(&bytes);
    }

    #[test]
    fn arbitrary_json_like_text_does_not_panic(text in r#"([\[\]{},: /'"\\\n]|[0-9eE.+-]{1,3}|"(part|shape|polygon|at|insert|pins|pin_friction)"|null|true|NaN|é){0,60}"#) {
        survives(text.as_bytes());
    }

    #[test]
    fn mutated_cases_do_not_panic(
        edits in proptest::collection::vec((0..VALID.len(), prop_oneof![Just(None), any::<u8>().prop_map(Some), "[0-9{}\\[\\],\"-]".prop_map(|s| Some(s.as_bytes()[0]))]), 1..4),
        cut in prop_oneof![3 => Just(VALID.len()), 1 => 0..VALID.len()],
    ) {
        let mut bytes = VALID.as_bytes()[..cut].to_vec();
        for (at, byte) in edits {
            match byte {
                Some(byte) if at < bytes.len() => bytes[at] = byte,
                None if at < bytes.len() => { bytes.remove(at); }
                _ => {}
            }
        }
        survives(&bytes);
    }

    /// Any value in place of any other is answered, never a panic.
    #[test]
    fn exchanged_values_do_not_panic(which in 0_usize..24, value in prop_oneof![
        Just("0"), Just("-1"), Just("1e10000"), Just("\"1/3\""), Just("null"), Just("[]"), Just("{}"), Just("[0,0]"), Just("89.999999999999"),
        Just("[1e-9, -1e-9]"), Just("{\"min\": 0, \"max\": 1e-30}"), Just("{\"at\": [4, 3], \"tolerance\": 1e9}")
    ]) {
        let starts: Vec<usize> = VALID.match_indices(": ").map(|(at, _)| at + 2).collect();
        let start = starts[which % starts.len()];
        let rest = &VALID[start..];
        let end = value_end(rest);
        survives(format!("{}{value}{}", &VALID[..start], &rest[end..]).as_bytes());
    }
}

/// Bytes of the JSON value at the start of `text`.
fn value_end(text: &str) -> usize {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            '[' | '{' => depth += 1,
            ']' | '}' if depth == 0 => return at,
            ']' | '}' => depth -= 1,
            ',' if depth == 0 => return at,
            _ => {}
        }
    }
    text.len()
}
