//! Public polyhedron files, against what independent programs found.

use super::{PLAIN, polyhedron, words};
use partplan::cone::format::{read, write};
use partplan::cone::{Extras, Polyhedron, Representation, canonical, convert, without_redundancy};
use partplan::exact::primitive_row;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/polyhedra")
}

fn expected() -> Vec<(String, Value)> {
    let instances = ["expected.json", "expected_larger.json"].into_iter().flat_map(|list| {
        let text = fs::read_to_string(folder().join(list)).unwrap();
        let Value::Object(instances) = serde_json::from_str(&text).unwrap() else { panic!("an object of instances") };
        instances
    });
    instances.collect()
}

fn file(name: &str) -> Polyhedron {
    let document = read(&fs::read(folder().join(name)).unwrap()).unwrap_or_else(|fault| panic!("{name}:{fault}"));
    assert_eq!(document.warnings, [""; 0], "{name}");
    document.polyhedron
}

/// Counts and digest of the canonical text, which leaves out the apex of a cone and writes rays as coprime integers.
fn digest(found: &Polyhedron) -> Value {
    let (linear, others) = found.rows().split_at(found.linear().len());
    let is_generators = found.representation() == Representation::Generators;
    if is_generators && others.is_empty() {
        return json!({ "rays": 0, "lines": 0, "hash": fnv("empty") });
    }
    let zero = super::support::int(0);
    let points = others.iter().filter(|row| row[0] != zero).count();
    let is_apex = |row: &[_]| is_generators && points == 1 && row[1..].iter().all(|value| *value == zero);
    let mut others: Vec<_> = others.iter().filter(|row| !is_apex(row)).map(|row| primitive_row(row)).collect();
    others.sort();
    let text = |tag: &str, row: &[_]| tag.to_owned() + &row.iter().map(|value| format!("{value},")).collect::<String>();
    let lines = linear.iter().map(|row| text("L", &primitive_row(row)));
    let rays = others.iter().map(|row| text("R", row));
    json!({ "rays": others.len(), "lines": linear.len(), "hash": fnv(&lines.chain(rays).collect::<String>()) })
}

fn fnv(text: &str) -> String {
    let digest = text
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{digest:016x}")
}

#[test]
fn every_public_file_converts_to_what_independent_programs_found() {
    let mut faults = Vec::new();
    let expected = expected();
    assert!(expected.len() > 200);
    for (name, expected) in expected {
        let found = digest(&convert(&file(&name), PLAIN).polyhedron);
        if found != expected {
            faults.push(format!("{name}: {found} instead of {expected}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_public_file_converts_there_and_back_to_its_canonical_form() {
    let names: Vec<String> = expected().into_iter().map(|(name, _)| name).collect();
    for name in &names {
        let given = file(name);
        let there = convert(&given, PLAIN).polyhedron;
        // through the text, as a user goes
        let back = convert(&polyhedron(&write(&there)), PLAIN).polyhedron;
        assert_eq!(back, canonical(&given, PLAIN).polyhedron, "{name}");
        assert_eq!(convert(&back, PLAIN).polyhedron, there, "{name}");
    }
}

#[test]
fn every_file_of_the_folder_is_expected() {
    let known: BTreeSet<String> = expected().into_iter().map(|(name, _)| name).collect();
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap()).filter(|entry| entry.path().is_dir()) {
        for file in fs::read_dir(entry.path()).unwrap() {
            let names = [entry.file_name(), file.unwrap().file_name()].map(|name| name.into_string().unwrap());
            found.insert(names.join("/"));
        }
    }
    assert_eq!(found, known);
}

#[test]
fn dropping_redundant_rows_of_public_files_keeps_the_polyhedron() {
    for (name, _) in expected().iter().filter(|(name, _)| !name.starts_with("classic")) {
        let given = file(name);
        let found = without_redundancy(&given, PLAIN);
        assert_eq!(canonical(&found.polyhedron, PLAIN), canonical(&given, PLAIN), "{name}");
        let again = without_redundancy(&found.polyhedron, PLAIN);
        assert_eq!((again.polyhedron, again.fates.unwrap().redundant), (found.polyhedron, vec![]), "{name}");
    }
}

/// A cone with a facet that floating-point conversions lost: <https://github.com/cddlib/cddlib/issues/44>.
#[test]
fn the_cone_of_cddlib_issue_44_has_four_facets_on_two_rays_each() {
    let given = file("cddlib_issue_44.ext");
    let found = convert(&given, Extras { adjacency: true, incidence: true });
    assert_eq!((found.polyhedron.rows().len(), found.polyhedron.linear(), found.dimension), (4, &[][..], Some(3)));
    assert!(found.incidence.unwrap().iter().all(|rays| rays.len() == 2));
    assert!(found.adjacency.unwrap().iter().all(|facets| facets.len() == 2));
    let back = convert(&found.polyhedron, PLAIN).polyhedron;
    assert_eq!(back, canonical(&given, PLAIN).polyhedron);
    assert_eq!(words(back.rows())[0], "1 0 0 0");
    assert_eq!(back.rows().len(), 5);
}
