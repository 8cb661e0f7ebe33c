//! The objective (18): where and when each part leaves.

use crate::answer::{EntryFate, EntryRun, FeederDesign, Film, Simulation, Status};
use crate::dynamics::{ModelKind, Options, observe, simulate};
use crate::model::{Feeder, Goal, Planar, PlanarShape, World};
use std::f64::consts::TAU;

/// Cost of a device that does not exist, for each entry: more than that of any run.
const NO_DEVICE: f64 = 1e3;

/// Time for which a run that is decided is shown (s), and frames of it.
const AFTERWARDS: f64 = 0.03;
const FRAMES: usize = 300;

/// A device with these dimensions, by a model and with a step (s).
///
/// # Source
/// Song, Trinkle, Kumar & Pang (2004), (18).
#[must_use]
pub fn evaluated(
    feeder: &Feeder,
    variables: &[f64],
    uncertain: &[f64],
    model: ModelKind,
    step: Option<f64>,
) -> FeederDesign {
    let runs = match feeder.device.scenes(variables, uncertain) {
        Ok(worlds) => worlds.iter().map(|world| run(feeder, world, model, step)).collect(),
        Err(_) => feeder.entries.iter().map(|_| no_device(&feeder.goal)).collect::<Vec<_>>(),
    };
    let cost = runs.iter().map(|run| run.cost).sum();
    FeederDesign { variables: variables.to_vec(), cost, runs }
}

fn no_device(goal: &Goal) -> EntryRun {
    EntryRun { fate: EntryFate::NoDevice, time: 0.0, pose: goal.pose, cost: NO_DEVICE }
}

/// One entry: until the first body passes the goal's height, or comes to rest.
#[must_use]
pub fn run(feeder: &Feeder, world: &World<Planar>, model: ModelKind, step: Option<f64>) -> EntryRun {
    let Feeder { goal, rest, .. } = feeder;
    let lever = 0.5 * diameter(&world.bodies[0].shape);
    let (mut last, mut slow_since, mut fate) = ((0.0, world.bodies[0].pose), None, None);
    let options = Options { model, step, frames: 2, second_order: true, ..Options::default() };
    let ended = observe(world, &options, &mut |moment| {
        let (pose, [vx, vy, spin]) = (moment.poses[0], moment.velocities[0]);
        last = (moment.time, pose);
        if pose[1] < goal.pose[1] {
            fate = Some(if is_near(goal, &pose) { EntryFate::Passes } else { EntryFate::Astray });
        }
        let is_slow = vx.hypot(vy).hypot(lever * spin) < rest.speed;
        let since = *slow_since.get_or_insert(moment.time);
        if !is_slow {
            slow_since = None;
        } else if moment.time - since >= rest.time {
            last.0 = since;
            fate = Some(EntryFate::Rests);
        }
        fate.is_none()
    });
    let (fate, (time, pose)) = match (fate, ended) {
        (Some(fate), _) => (fate, last),
        (None, Ok(Simulation { status: Status::Complete | Status::Ambiguous, last: end, .. })) => {
            (EntryFate::TimesOut, (world.duration, end.poses[0]))
        }
        // as if it stood there till the end
        (None, _) => (EntryFate::Unsolved, (world.duration, last.1)),
    };
    let off = [0, 1, 2].map(|entry| pose[entry] - goal.pose[entry]);
    let distance = off.iter().map(|off| off * off).sum::<f64>().sqrt();
    let cost = goal.weight * distance + time;
    EntryRun { fate, time, pose, cost: if cost.is_finite() { cost.min(NO_DEVICE) } else { NO_DEVICE } }
}

/// The runs of a design as they are shown, to soon after they are decided.
#[must_use]
pub fn films(feeder: &Feeder, design: &FeederDesign, name: &'static str) -> Vec<Film> {
    let worlds = feeder.device.scenes(&design.variables, &feeder.nominal()).unwrap_or_default();
    let options = Options { model: ModelKind::StewartTrinkle, frames: FRAMES, ..Options::default() };
    let film = |(entry, (mut world, run)): (usize, (World<Planar>, &EntryRun))| {
        world.duration = world.duration.min(run.time + AFTERWARDS);
        let simulation = simulate(&world, &options, &mut |_| true).ok()?;
        Some(Film { design: name, entry, world, simulation })
    };
    worlds.into_iter().zip(&design.runs).enumerate().filter_map(film).collect()
}

fn is_near(goal: &Goal, pose: &[f64; 3]) -> bool {
    let turn = pose[2] - goal.pose[2];
    let turn = turn - TAU * (turn / TAU).round();
    (pose[0] - goal.pose[0]).abs() <= goal.within[0] && turn.abs() <= goal.within[1]
}

/// Largest distance of two points of an outline.
fn diameter(shape: &PlanarShape) -> f64 {
    match shape {
        PlanarShape::Polygon(corners) => {
            let pairs = corners.iter().flat_map(|a| corners.iter().map(|b| (a[0] - b[0]).hypot(a[1] - b[1])));
            pairs.fold(0.0, f64::max)
        }
        PlanarShape::Circle { radius, .. } => 2.0 * radius,
        PlanarShape::HalfPlane { .. } => 0.0,
        PlanarShape::Compound(parts) => parts.iter().map(diameter).fold(0.0, f64::max),
    }
}
