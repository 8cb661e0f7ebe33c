//! Every documented command, its output and its exit status.

#[test]
fn documented_commands_print_what_is_documented() {
    trycmd::TestCases::new().case("tests/cmd/*.trycmd").run();
}

/// README shows what its first command prints; the binary is the same, the way to start it shorter.
#[test]
fn readme_shows_what_the_plan_prints() {
    let readme = include_str!("../README.md");
    let shown = readme
        .split_once("$ cargo run --release -- insert cases/pawl.json\n")
        .and_then(|(_, rest)| rest.split_once("\n$ "))
        .expect("README starts with the two commands")
        .0;
    let run =
        std::process::Command::new(env!("CARGO_BIN_EXE_plan")).args(["insert", "cases/pawl.json"]).output().unwrap();
    assert!(run.status.success());
    assert_eq!(String::from_utf8(run.stdout).unwrap().trim_end(), shown);
}

#[test]
fn the_picture_in_readme_is_the_one_drawn_today() {
    let folder = std::env::temp_dir().join(format!("plan-readme-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let drawn = folder.join("pawl.svg");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_plan"))
        .args(["insert", "cases/pawl.json", "--svg"])
        .arg(&drawn)
        .output()
        .unwrap();
    assert!(run.status.success());
    assert!(std::fs::read_to_string(&drawn).unwrap() == include_str!("../cases/pawl.svg"), "draw cases/pawl.svg again");
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
