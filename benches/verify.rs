//! Verification, `cargo bench --bench verify`: runs a second of insertions, pins and throws, on one thread and on two.

use partplan::case::{Limits, read};
use partplan::planner::{self, PinQuestion, Question, ThrowQuestion};
use partplan::verify::{Experiment, InsertTrials, PinTrials, Push, ThrowTrials, tally};
use std::time::Instant;

fn main() {
    println!("| plan | runs | runs/s, one thread | two threads | ratio |");
    println!("|---|---|---|---|---|");
    let case = |name: &str| {
        let path = format!("{}/cases/{name}.json", env!("CARGO_MANIFEST_DIR"));
        read(&std::fs::read(path).expect("a case"), &Limits::default()).expect("a valid case")
    };
    let pawl = case("pawl");
    let fixture = pawl.fixture.expect("fixels");
    let found = planner::insertion(&pawl.part, &fixture, &Question::default()).expect("modes of its length");
    let push = Push::recommended(&pawl.part, &found.plan.expect("a plan"));
    report("pawl, insert", 2_000, &InsertTrials::new(&pawl.part, &fixture, push, 1, None));
    let three = case("three_pins");
    let conveyor = three.conveyor.expect("a conveyor");
    let found = planner::pins(&three.part, &conveyor, &PinQuestion::default()).expect("a polygon");
    report("three_pins, pins", 64, &PinTrials::new(&three.part, &conveyor, &found, &[], 1).expect("pins"));
    let triangle = case("throw_triangle");
    let thrower = triangle.thrower.expect("an arm");
    let found = planner::throw(&triangle.part, &thrower, &ThrowQuestion::default(), &mut |_| true).expect("throws");
    let trials = ThrowTrials::new(&triangle.part, &thrower, &found, None, 1).expect("a pattern");
    report("throw_triangle, throw", 400, &trials);
}

fn report(name: &str, runs: u64, experiment: &impl Experiment) {
    let rate = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let once = || {
            let start = Instant::now();
            let tally = pool.install(|| tally(experiment, 0..runs, &|| true)).expect("nothing ends the runs");
            assert_eq!(tally.runs(), runs);
            start.elapsed().as_secs_f64()
        };
        runs as f64 / (0..3).map(|_| once()).fold(f64::INFINITY, f64::min)
    };
    let (one, two) = (rate(1), rate(2));
    println!("| {name} | {runs} | {one:.0} | {two:.0} | {:.2} |", two / one);
}
