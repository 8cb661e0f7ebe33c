//! The layers of the crate: which folder may import which.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Folder, and the folders that it may import. The command line is the binary's and may import everything.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("exact", &[]),
    ("geometry", &["exact"]),
    ("cone", &["exact"]),
    ("complementarity", &["exact", "cone"]),
    ("model", &["exact", "geometry"]),
    ("mechanics", &["exact", "cone", "geometry", "model"]),
    ("answer", &["exact", "model"]),
    ("dynamics", &["answer", "complementarity", "exact", "geometry", "model"]),
    ("verify", &["answer", "complementarity", "dynamics", "exact", "geometry", "model"]),
    ("design", &["answer", "dynamics", "model", "verify"]),
    ("chart", &["answer", "complementarity", "cone", "dynamics", "exact", "geometry", "mechanics", "model", "planner"]),
    ("planner", &["answer", "cone", "exact", "geometry", "mechanics", "model"]),
    ("case", &["exact", "geometry", "model"]),
    ("report", &["answer", "exact", "geometry", "model"]),
];

#[test]
fn every_folder_imports_only_the_layers_below_it() {
    let mut faults = Vec::new();
    for (folder, text, file) in sources() {
        let (_, allowed) = MAY_IMPORT.iter().find(|(name, _)| *name == folder).unwrap_or_else(|| {
            panic!("{file}: folder {folder} is not in the table of layers; add it there with what it may import")
        });
        for import in imports(&text) {
            if import != folder && !allowed.contains(&import.as_str()) {
                faults.push(format!("{file}: {folder} must not import {import}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn only_exact_names_the_big_integer_crate() {
    let faults: Vec<String> = sources()
        .filter(|(folder, text, _)| folder != "exact" && text.contains("num_bigint"))
        .map(|(_, _, file)| file)
        .collect();
    assert!(faults.is_empty(), "{faults:?}");
}

#[test]
fn the_library_neither_prints_nor_exits_nor_reads_files() {
    let forbidden = ["println!", "eprintln!", "print!(", "process::exit", "std::fs", "std::env", "File::open"];
    let mut faults = Vec::new();
    for (_, text, file) in sources() {
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        for line in code.filter(|line| forbidden.iter().any(|word| line.contains(word))) {
            faults.push(format!("{file}: {line}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn an_import_outside_the_table_is_seen() {
    let text =
        "use crate::cone::Cone;\n    let x = crate::planner::insertion(a);\nuse crate::{exact::Q, report::json};";
    let found: BTreeSet<String> = imports(text).collect();
    assert_eq!(found, ["cone", "exact", "planner", "report"].map(String::from).into());
}

/// Folder, text and path of every source file of the library's folders.
fn sources() -> impl Iterator<Item = (String, String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    for folder in fs::read_dir(&root).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir()) {
        let name = folder.file_name().unwrap().to_str().unwrap().to_owned();
        if name != "cli" {
            collect(&folder, &name, &mut files);
        }
    }
    assert!(files.len() > 20, "the sources were not found");
    files.into_iter()
}

fn collect(folder: &Path, layer: &str, files: &mut Vec<(String, String, String)>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            collect(&path, layer, files);
        } else {
            files.push((layer.to_owned(), fs::read_to_string(&path).unwrap(), path.display().to_string()));
        }
    }
}

/// Every folder that the text names after `crate::`, in braces too.
fn imports(text: &str) -> impl Iterator<Item = String> {
    text.split("crate::").skip(1).flat_map(|rest| match rest.strip_prefix('{') {
        Some(list) => {
            let list = list.split(';').next().unwrap_or_default();
            list.split(',').map(first_name).collect::<Vec<_>>()
        }
        None => vec![first_name(rest)],
    })
}

fn first_name(text: &str) -> String {
    text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}
