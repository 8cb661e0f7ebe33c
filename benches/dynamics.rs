//! Error and time of the time-steppers on the scenes on which other engines were measured.
//!
//! `cargo bench --bench dynamics [-- SCENE…]`

#[path = "../tests/dynamics/peers.rs"]
mod peers;

use cpu_time::ThreadTime;
use partplan::dynamics::{ModelKind, Options, simulate};
use std::time::Duration;

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    println!(
        "{:24} {:8} {:>8}  {:>9} {:>9} {:>11} {:>7}",
        "scene", "model", "h", "error", "us/step", "ms/sim-s", "impacts"
    );
    for scene in peers::scenes().iter().filter(|scene| wanted.is_empty() || wanted.contains(&scene.name)) {
        for (name, model) in [("st", ModelKind::StewartTrinkle), ("moreau", ModelKind::Moreau)] {
            for h in [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4] {
                let options = Options { model, step: Some(h), frames: 2, ..Options::default() };
                let all = Options { frames: usize::MAX, ..options.clone() };
                let run = simulate(&scene.world, &all, &mut |_| true);
                let error = scene.error(&run);
                let time = median(|| {
                    std::hint::black_box(simulate(&scene.world, &options, &mut |_| true));
                });
                println!(
                    "{:24} {name:8} {h:>8}  {error:>9.1e} {:>9.3} {:>11.4} {:>7}",
                    scene.name,
                    time.as_secs_f64() * 1e6 / run.solver.steps as f64,
                    time.as_secs_f64() * 1e3 / scene.world.duration,
                    run.solver.impacts,
                );
            }
        }
    }
}

/// Median CPU time of a run, over so many that it takes a few hundredths of a second.
fn median(mut run: impl FnMut()) -> Duration {
    let mut times = Vec::new();
    let start = ThreadTime::now();
    while times.len() < 5 || start.elapsed() < Duration::from_millis(30) && times.len() < 1000 {
        let start = ThreadTime::now();
        run();
        times.push(start.elapsed());
    }
    times.sort_unstable();
    times[times.len() / 2]
}
