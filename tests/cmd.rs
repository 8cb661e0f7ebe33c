//! Every documented command, its output and its exit status.

#[test]
fn documented_commands_print_what_is_documented() {
    trycmd::TestCases::new().case("tests/cmd/*.trycmd").run();
}

/// What README asks of a command besides: a whole search takes minutes in a build for tests.
fn more(command: &str) -> &'static [&'static str] {
    if command == "feeder" { &["--evaluations", "200"] } else { &[] }
}

/// README shows what its commands print; the binary is the same, the way to start it may be shorter.
#[test]
fn readme_shows_what_the_plans_print() {
    let readme = include_str!("../README.md");
    let examples = [
        ("cargo run --release -- insert", "insert", "pawl", "\n$ "),
        ("plan pins", "pins", "three_pins", "```"),
        ("plan throw", "throw", "throw_triangle", "```"),
        ("plan simulate", "simulate", "peg_drop", "```"),
        ("plan feeder", "feeder", "feeder", "```"),
    ];
    for (start, command, case, end) in examples {
        let (case, more) = (format!("cases/{case}.json"), more(command));
        let asked = [&[case.as_str()], more].concat();
        let (_, rest) =
            readme.split_once(&format!("$ {start} {}\n", asked.join(" "))).expect("README shows the command");
        let (shown, _) = rest.split_once(end).expect("the example ends");
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_plan")).arg(command).args(asked).output().unwrap();
        assert!(run.status.success());
        assert_eq!(String::from_utf8(run.stdout).unwrap().trim_end(), shown.trim_end());
    }
}

#[test]
fn the_pictures_in_readme_are_those_drawn_today() {
    let folder = std::env::temp_dir().join(format!("plan-readme-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let pictures = [
        ("insert", "pawl", include_str!("../cases/pawl.svg")),
        ("pins", "three_pins", include_str!("../cases/three_pins.svg")),
        ("throw", "throw_triangle", include_str!("../cases/throw_triangle.svg")),
        ("simulate", "peg_drop", include_str!("../cases/peg_drop.svg")),
        ("feeder", "feeder", include_str!("../cases/feeder.svg")),
    ];
    for (command, case, shown) in pictures {
        let drawn = folder.join("drawn.svg");
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_plan"))
            .args([command, &format!("cases/{case}.json"), "--svg"])
            .arg(&drawn)
            .args(more(command))
            .output()
            .unwrap();
        assert!(run.status.success());
        assert!(std::fs::read_to_string(&drawn).unwrap() == shown, "draw cases/{case}.svg again");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    use std::process::{Command, Stdio};
    let mut run = Command::new(env!("CARGO_BIN_EXE_plan"))
        .args(["stable", "cases/pawl.json", "--format", "json", "--cells"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(run.stdout.take());
    let run = run.wait_with_output().unwrap();
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(String::from_utf8(run.stderr).unwrap(), "");
}

/// Coordinates over nine different denominators of 100 digits: planning takes far longer than the limit.
#[test]
fn a_time_limit_ends_the_run_undecided() {
    use std::io::Write as _;
    use std::process::{Command, Stdio};
    let outline = [(0, 0), (9, -2), (12, 0), (11, 3), (8, 2), (6, 4), (3, 5), (0, 4), (-1, 2)];
    let near = |value: i32, k: usize| {
        let denominator = format!("{}{}7", k + 1, "3".repeat(98));
        let numerator = format!("{}1", "0".repeat(99)).replace('0', &(k % 9).to_string());
        if value < 0 { format!("\"-{}/1\"", -value) } else { format!("\"{value}{numerator}/1{denominator}\"") }
    };
    let vertex = |(k, (x, y)): (usize, &(i32, i32))| format!("[{}, {}]", near(*x, k), near(*y, k));
    let vertices = outline.iter().enumerate().map(vertex).collect::<Vec<_>>().join(", ");
    let fixel = |edge: usize| format!("{{ \"edge\": {edge}, \"s\": 0.3, \"friction\": 0.2 }}");
    let fixels = [1, 4, 8].map(fixel).join(", ");
    let case = format!(
        "{{ \"part\": {{ \"shape\": {{ \"polygon\": [{vertices}] }} }}, \"insert\": {{ \"fixels\": [{fixels}] }} }}"
    );
    let mut run = Command::new(env!("CARGO_BIN_EXE_plan"))
        .args(["insert", "-", "--format", "json", "--time-limit", "0.01"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    run.stdin.take().unwrap().write_all(case.as_bytes()).unwrap();
    let run = run.wait_with_output().unwrap();
    let shown = String::from_utf8(run.stdout).unwrap();
    assert_eq!((run.status.code(), String::from_utf8(run.stderr).unwrap().as_str()), (Some(3), ""), "{shown}");
    assert!(shown.contains("\"status\": \"undecided\""), "{shown}");
}
