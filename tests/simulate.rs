//! `plan simulate` from outside: exit status, streams, files.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A scene that takes far longer than any test waits.
const ENDLESS: &str = r#"{"scene": {"duration": 1e5, "step": 1e-3, "friction": 0.2, "bodies": [
    {"name": "disc", "shape": {"circle": {"radius": 0.1}}, "mass": 1, "pose": [0, 0.1, 0], "velocity": [1, 0, 0]}],
    "fixed": [{"name": "floor", "shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}]}}"#;

/// A folder of its own for a test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("plan-simulate-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn plan() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plan"));
    command.arg("simulate").stdin(Stdio::null());
    command
}

fn document(run: &Output) -> Value {
    serde_json::from_slice(&run.stdout).unwrap_or_else(|error| panic!("{error}: {run:?}"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

#[test]
fn a_run_is_reported_and_its_files_are_whole() {
    let folder = Folder::new("files");
    for case in ["peg_drop", "sphere", "chute"] {
        let [svg, html, csv, jsonl] = ["a.svg", "a.html", "a.csv", "a.jsonl"].map(|name| folder.file(name));
        let case = format!("cases/{case}.json");
        let mut run = plan();
        run.args([&case, "--format", "json", "--frames", "50"]).arg("--svg").arg(&svg).arg("--html").arg(&html);
        let run = run.arg("--trajectory").arg(&csv).output().unwrap();
        assert_eq!((run.status.code(), String::from_utf8_lossy(&run.stderr).as_ref()), (Some(0), ""));
        let answer = document(&run);
        assert_eq!((&answer["schema"], &answer["status"]), (&"plan.simulate/1".into(), &"report".into()));
        assert_eq!(answer["result"]["status"], "complete");
        assert!(read(&svg).ends_with("</svg>\n") && read(&html).ends_with("</html>\n"));
        let rows = read(&csv).lines().count();
        assert!((3..=52).contains(&rows), "{rows} rows");
        assert!(plan().arg(&case).arg("--trajectory").arg(&jsonl).output().unwrap().status.success());
        assert!(read(&jsonl).starts_with("{\"case\""));
        assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 4, "no other files are left");
    }
}

#[test]
fn the_text_fits_a_screen() {
    let run = plan().arg("cases/chute.json").output().unwrap();
    let text = String::from_utf8(run.stdout).unwrap();
    assert!(text.starts_with("peg ") && text.lines().count() <= 25, "{text}");
}

#[test]
fn runs_are_the_same_every_time() {
    let run = || plan().args(["cases/chute.json", "--format", "json"]).output().unwrap().stdout;
    assert_eq!(run(), run());
}

#[test]
fn without_friction_a_block_slides_on() {
    let text = r#"{"scene": {"duration": 0.5, "friction": 0.5, "bodies": [{"shape": {"polygon":
        [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]}, "mass": 1, "pose": [0, 0.05, 0], "velocity": [1, 0, 0]}],
        "fixed": [{"shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}]}}"#;
    let folder = Folder::new("frictionless");
    let scene = folder.file("block.json");
    fs::write(&scene, text).unwrap();
    let speed = |model: &str| {
        let run = plan().arg(&scene).args(["--model", model, "--format", "json"]).output().unwrap();
        document(&run)["result"]["final"]["velocities"][0][0].as_f64().unwrap()
    };
    assert!((speed("frictionless") - 1.0).abs() < 1e-9);
    assert!(speed("st").abs() < 1e-9);
}

#[test]
fn limits_leave_a_partial_answer() {
    let folder = Folder::new("limits");
    let scene = folder.file("endless.json");
    fs::write(&scene, ENDLESS).unwrap();
    for (option, value, said) in
        [("--time-limit", "0.2", "--time-limit allows more"), ("--max-steps", "7", "--max-steps")]
    {
        let run = plan().arg(&scene).args([option, value, "--step", "1e-3", "--format", "json"]).output().unwrap();
        assert_eq!(run.status.code(), Some(3));
        let answer = document(&run);
        assert_eq!((&answer["status"], &answer["result"]["status"]), (&"undecided".into(), &"partial".into()));
        assert!(answer["result"]["notes"][0].as_str().is_some_and(|note| note.contains(said)), "{answer}");
        assert!(answer["result"]["time"].as_f64().is_some_and(|time| time > 0.0 && time < 1e5));
    }
}

/// Ctrl-C ends the run, not the report.
#[cfg(unix)]
#[test]
fn an_interrupted_run_is_reported_as_far_as_it_came() {
    let folder = Folder::new("interrupt");
    let (scene, svg) = (folder.file("endless.json"), folder.file("a.svg"));
    fs::write(&scene, ENDLESS).unwrap();
    let mut command = plan();
    command.arg(&scene).args(["--format", "json", "--svg"]).arg(&svg);
    let run = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    let kill = Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let run = run.wait_with_output().unwrap();
    assert_eq!(run.status.code(), Some(130), "{run:?}");
    let answer = document(&run);
    assert_eq!((&answer["status"], &answer["result"]["notes"][0]), (&"undecided".into(), &"interrupted".into()));
    assert!(read(&svg).ends_with("</svg>\n"));
}

#[test]
fn a_scene_is_read_from_standard_input() {
    use std::io::Write as _;
    let mut command = plan();
    command.arg("-").stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut run = command.spawn().unwrap();
    run.stdin.take().unwrap().write_all(&fs::read("cases/peg_drop.json").unwrap()).unwrap();
    assert!(run.wait_with_output().unwrap().status.success());
}
