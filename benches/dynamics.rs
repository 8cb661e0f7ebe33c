//! Error and time of the time-steppers on the scenes on which other engines were measured.
//!
//! `cargo bench --bench dynamics [-- [--csv] SCENE…]`; `benches/dynamics_peers.sh` reads the comma-separated form.

#[path = "../tests/dynamics/peers.rs"]
mod peers;

use cpu_time::ThreadTime;
use partplan::answer::Simulation;
use partplan::dynamics::{Mechanics, ModelKind, Options, simulate};
use partplan::model::World;
use std::time::Duration;

fn main() {
    let (flags, wanted): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|arg| arg.starts_with('-'));
    let csv = flags.iter().any(|flag| flag == "--csv");
    let is_wanted = |name: &str| wanted.is_empty() || wanted.iter().any(|wanted| name.starts_with(wanted.as_str()));
    if csv {
        println!("scene,model,h,error,us_per_step,ms_per_simulated_second");
    } else {
        println!(
            "{:24} {:8} {:>8}  {:>9} {:>9} {:>11} {:>7}",
            "scene", "model", "h", "error", "us/step", "ms/sim-s", "impacts"
        );
    }
    for scene in peers::scenes().iter().filter(|scene| is_wanted(&scene.name)) {
        measure(csv, &scene.name, &scene.world, |run| scene.error(run));
    }
    if is_wanted("seed_sphere") {
        measure(csv, "seed_sphere", &peers::sphere(), peers::sphere_error);
    }
}

fn measure<S: Mechanics>(csv: bool, scene: &str, world: &World<S>, error: impl Fn(&Simulation<S>) -> f64) {
    for (name, model) in [("st", ModelKind::StewartTrinkle), ("moreau", ModelKind::Moreau)] {
        for h in [5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4] {
            let options = Options { model, step: Some(h), frames: 2, ..Options::default() };
            let all = Options { frames: usize::MAX, ..options.clone() };
            let run = simulate(world, &all, &mut |_| true).unwrap();
            let error = error(&run);
            let times = times(|| {
                std::hint::black_box(simulate(world, &options, &mut |_| true).unwrap());
            });
            // beside other engines the least counts, which others on the machine disturb least
            let time = times[if csv { 0 } else { times.len() / 2 }];
            let step = time.as_secs_f64() * 1e6 / run.solver.steps as f64;
            let second = time.as_secs_f64() * 1e3 / world.duration;
            if csv {
                println!("{scene},{name},{h},{error:e},{step},{second}");
            } else {
                let impacts = run.solver.impacts;
                println!("{scene:24} {name:8} {h:>8}  {error:>9.1e} {step:>9.3} {second:>11.4} {impacts:>7}");
            }
        }
    }
}

/// CPU times of a run, sorted, over so many that it takes a few hundredths of a second.
fn times(mut run: impl FnMut()) -> Vec<Duration> {
    let mut times = Vec::new();
    let start = ThreadTime::now();
    while times.len() < 5 || start.elapsed() < Duration::from_millis(30) && times.len() < 1000 {
        let start = ThreadTime::now();
        run();
        times.push(start.elapsed());
    }
    times.sort_unstable();
    times
}
