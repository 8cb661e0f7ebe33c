//! Error and time of the time-steppers on the scenes on which other engines were measured, then the time of a step of the
//! paper's two schemes on the published scenes.
//!
//! `cargo bench --bench dynamics [-- [--csv] SCENE…]`; `benches/dynamics_peers.sh` reads the comma-separated form.

#[path = "../tests/dynamics/peers.rs"]
mod peers;
#[path = "../tests/dynamics/published.rs"]
#[allow(dead_code, reason = "the tests use the rest")]
mod published;

use cpu_time::ThreadTime;
use partplan::answer::Simulation;
use partplan::dynamics::{Mechanics, ModelKind, Options, simulate};
use partplan::model::{Scene, World};
use std::time::Duration;

fn main() {
    let (flags, wanted): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|arg| arg.starts_with('-'));
    let csv = flags.iter().any(|flag| flag == "--csv");
    let is_wanted = |name: &str| wanted.is_empty() || wanted.iter().any(|wanted| name.starts_with(wanted.as_str()));
    if csv {
        println!("scene,model,h,error,us_per_step,ms_per_simulated_second,ms_at_end");
    } else {
        println!(
            "{:24} {:8} {:>8}  {:>9} {:>9} {:>11} {:>9} {:>7}",
            "scene", "model", "h", "error", "us/step", "ms/sim-s", "ms at end", "impacts"
        );
    }
    for scene in peers::scenes().iter().filter(|scene| is_wanted(&scene.name)) {
        measure(csv, &scene.name, &scene.world, |run| scene.error(run));
    }
    if is_wanted("seed_sphere") {
        measure(csv, "seed_sphere", &peers::sphere(), peers::sphere_error);
    }
    if !csv {
        println!("\n{:28} {:4} {:>8} {:>8} {:>9} {:>9}", "published scene", "", "h", "steps", "us/step", "problems");
        let expected = published::expected();
        for scene in published::scenes().iter().filter(|scene| is_wanted(&scene.name)) {
            let Some(h) = expected[&scene.name]["rows"][0]["h"].as_f64() else { continue };
            match &scene.scene {
                Scene::Planar(world) => step(&scene.name, scene.model, world, h),
                Scene::Spatial(world) => step(&scene.name, scene.model, world, h),
            }
        }
    }
}

/// Time of a step over half a second, or to where the run ends early.
fn step<S: Mechanics>(name: &str, model: ModelKind, world: &World<S>, h: f64) {
    let world = World { duration: 0.5, ..world.clone() };
    let options = Options { model, step: Some(h), frames: 2, ..Options::default() };
    let run = simulate(&world, &options, &mut |_| true).unwrap();
    let time = fastest(|| {
        std::hint::black_box(simulate(&world, &options, &mut |_| true).unwrap());
    });
    let (steps, problems) = (run.solver.steps, run.solver.problems);
    let each = time.as_secs_f64() * 1e6 / steps.max(1) as f64;
    println!("{name:28} {:4} {h:>8} {steps:>8} {each:>9.3} {problems:>9}", run.model.chosen);
}

fn measure<S: Mechanics>(csv: bool, scene: &str, world: &World<S>, error: impl Fn(&Simulation<S>) -> f64) {
    for (name, model) in [("st", ModelKind::StewartTrinkle), ("moreau", ModelKind::Moreau)] {
        for h in [5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4] {
            let options = Options { model, step: Some(h), frames: 2, forces: true, ..Options::default() };
            let all = Options { frames: usize::MAX, ..options.clone() };
            let run = simulate(world, &all, &mut |_| true).unwrap();
            let error = error(&run);
            let whole = fastest(|| {
                std::hint::black_box(simulate(world, &options, &mut |_| true).unwrap());
            });
            // ended by the watch after as many steps, a run is not asked which forces are determined at its end
            let longer = World { duration: world.duration + h, ..world.clone() };
            let steps = fastest(|| {
                let watch = &mut |time| time < world.duration - 1e-6 * h;
                std::hint::black_box(simulate(&longer, &options, watch).unwrap());
            });
            let step = steps.as_secs_f64() * 1e6 / run.solver.steps as f64;
            let second = steps.as_secs_f64() * 1e3 / world.duration;
            let end = whole.saturating_sub(steps).as_secs_f64() * 1e3;
            if csv {
                println!("{scene},{name},{h},{error:e},{step},{second},{end}");
            } else {
                let impacts = run.solver.impacts;
                println!(
                    "{scene:24} {name:8} {h:>8}  {error:>9.1e} {step:>9.3} {second:>11.4} {end:>9.3} {impacts:>7}"
                );
            }
        }
    }
}

/// CPU time of the run that others on the machine disturb least, of so many that they take a few hundredths of a second;
/// one is enough if it is long.
fn fastest(mut run: impl FnMut()) -> Duration {
    let (mut times, mut total) = (Vec::new(), Duration::ZERO);
    let (enough, long) = (Duration::from_millis(30), Duration::from_millis(200));
    while (times.len() < 5 || total < enough) && times.len() < 100 && total < long {
        let start = ThreadTime::now();
        run();
        times.push(start.elapsed());
        total += times[times.len() - 1];
    }
    times.into_iter().min().unwrap_or_default()
}
