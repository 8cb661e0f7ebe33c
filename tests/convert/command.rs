//! `plan convert` as a program: standard input, limits, warnings, refusals.

use std::io::Write as _;
use std::process::{Command, Output, Stdio};

fn run(arguments: &[&str], input: &str) -> Output {
    let mut run = Command::new(env!("CARGO_BIN_EXE_plan"))
        .args(["convert", "-"])
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // arguments may be refused before the input is read
    let _ = run.stdin.take().unwrap().write_all(input.as_bytes());
    run.wait_with_output().unwrap()
}

fn texts(run: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (run.status.code(), text(&run.stdout), text(&run.stderr))
}

/// Points on the moment curve: every conversion of them is as large as can be.
fn cyclic(points: i64, dim: u32) -> String {
    let row =
        |t: i64| format!("1{}\n", (1..=dim).map(|power| format!(" {}", i128::from(t).pow(power))).collect::<String>());
    let rows: String = (1..=points).map(row).collect();
    format!("V-representation\nbegin\n{points} {} integer\n{rows}end\n", dim + 1)
}

#[test]
fn standard_input_is_converted_and_warned_about() {
    let (status, out, err) = texts(&run(&[], "begin\n2 2 integer\n0 1\n1 -1\nend\nhull\n"));
    assert_eq!((status, out.as_str()), (Some(0), "V-representation\nbegin\n 2 2 integer\n 1 0\n 1 1\nend\n"));
    assert_eq!(
        err,
        "warning: standard input: line 6: option \"hull\" has no effect\n\
         warning: standard input: no line says H-representation or V-representation: read as H-representation\n"
    );
}

#[test]
fn what_is_printed_can_be_read_again_with_all_its_lists() {
    let (_, octahedron, _) = texts(&run(&["--adjacency", "--incidence"], &cyclic(6, 3)));
    let (status, back, err) = texts(&run(&[], &octahedron));
    assert_eq!((status, err.as_str()), (Some(0), ""));
    assert_eq!(back.replace("\n ", "\n"), cyclic(6, 3));
}

#[test]
fn a_bad_file_ends_with_status_two_and_its_place() {
    let (status, out, err) = texts(&run(&[], "begin\n2 2 integer\n0 1\n1 1/0\nend\n"));
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert_eq!(err, "error: standard input:4:3: the denominator of \"1/0\" is zero (row 2, entry 2)\n");
}

#[test]
fn an_empty_polyhedron_is_an_answer() {
    let (status, out, err) = texts(&run(&["--format", "json"], "H-representation\nbegin\n1 2 integer\n-1 0\nend\n"));
    assert_eq!((status, err.as_str()), (Some(0), ""));
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((found["schema"].as_str(), found["status"].as_str()), (Some("plan.convert/1"), Some("report")));
    assert_eq!((found["result"]["empty"].as_bool(), found["result"]["dimension"].as_i64()), (Some(true), Some(-1)));
    assert_eq!(found["result"]["rows"], serde_json::json!([]));
}

#[test]
fn a_time_limit_ends_a_conversion_undecided() {
    let (status, out, err) = texts(&run(&["--time-limit", "0.05"], &cyclic(60, 16)));
    assert_eq!((status, err.as_str()), (Some(3), ""));
    assert_eq!(out, "undecided: no answer within 0.05 s; --time-limit allows more\n");
    let (status, out, _) = texts(&run(&["--time-limit", "0.05", "--format", "json"], &cyclic(60, 16)));
    assert_eq!(status, Some(3));
    assert!(out.contains("\"status\": \"undecided\"") && out.contains("\"limit\":\"time\""), "{out}");
}

#[test]
fn a_memory_limit_ends_a_conversion_undecided() {
    let (status, out, err) = texts(&run(&["--memory-limit", "1MiB"], &cyclic(60, 16)));
    assert_eq!((status, err.as_str()), (Some(3), ""));
    assert_eq!(out, "undecided: no answer within 1.0 MiB of memory; --memory-limit allows more\n");
    let (status, out, _) = texts(&run(&["--memory-limit", "1MiB", "--format", "json"], &cyclic(60, 16)));
    assert_eq!(status, Some(3));
    assert!(out.contains("\"status\": \"undecided\"") && out.contains("\"limit\":\"memory\""), "{out}");
    let (status, out, err) = texts(&run(&["--memory-limit", "much"], "begin\n1 2 integer\n1 0\nend\n"));
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert!(err.contains("expected a size, 500MB or 2GiB for instance"), "{err}");
}
