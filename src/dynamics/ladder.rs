//! The cheapest model that a scene allows, and the step that its tolerance asks for.

use super::Moment;
use super::mechanics::Mechanics;
use super::moreau::Moreau;
use super::options::Options;
use super::run::run;
use super::song_pang_kumar::{self, SimulationError, SongPangKumar};
use crate::answer::{ModelChoice, Simulation, Status};
use crate::model::World;

/// Steps of the first run, unless something moves faster than they resolve: where no contact changes, and else.
const CALM_STEPS: f64 = 16.0;
const FIRST_STEPS: f64 = 64.0;

/// Most times that the step is halved.
const MAX_HALVINGS: usize = 12;

/// Share of a period that one step may cover at first, over 2π: ω h.
const FIRST_PHASE: f64 = 0.2;

/// Runs a scene by the first rung of the ladder that is enough:
///
/// 1. frictionless rigid contacts, if no coefficient of friction is above 0;
/// 2. rigid contacts with friction and located impacts;
/// 3. compliant contacts, if the scene says how stiff they are and either they give way by more than the tolerance, at
///    the hardest impact that the rigid run met (v √(m/K)) and under all weights or the largest force at its end (f/K), or
///    rigid contacts are ambiguous.
///
/// The step is that of the options or of the scene; else it is halved until the final poses of two runs differ by less
/// than the tolerance.
pub(super) fn climb<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    watch: &mut dyn FnMut(Moment<S>) -> bool,
) -> Result<Simulation<S>, SimulationError> {
    let friction = world.materials.iter().map(|material| material.friction).fold(0.0, f64::max);
    let (chosen, reason) = if friction == 0.0 {
        ("frictionless", "no coefficient of friction is above 0".to_string())
    } else {
        ("moreau", format!("the largest coefficient of friction is {friction}, above 0"))
    };
    let mut rigid_why = vec![reason.clone()];
    let e = world.materials.iter().map(|material| material.restitution.coefficient()).fold(0.0, f64::max);
    rigid_why.push(match e {
        0.0 => "nothing restitutes: impacts are located and plastic".to_string(),
        e => format!("the largest coefficient of restitution is {e}: impacts are located, and bounce"),
    });
    let first = world.duration / FIRST_STEPS;
    let mut rigid = refined(world, options, [world.duration / CALM_STEPS, first], &rigid_why, |choice| {
        run(world, options, ModelChoice { chosen, ..choice }, &mut Moreau::new(world), watch)
    });
    let has_compliance = world.materials.iter().any(|material| material.compliance.is_some());
    if !has_compliance || matches!(rigid.status, Status::Partial) {
        return Ok(rigid);
    }
    song_pang_kumar::check(world)?;
    let softest = softest(world);
    let heaviest = world.bodies.iter().filter(|body| !body.is_kinematic).map(|body| body.mass).fold(0.0, f64::max);
    let give = rigid.solver.fastest_impact * (heaviest / softest).sqrt() + load(world, &rigid) / softest;
    let tolerance = options.tolerance;
    if rigid.status == Status::Complete && give <= tolerance {
        rigid
            .model
            .why
            .push(format!("contacts give way by at most {give:.2e} m, within the tolerance of {tolerance} m: rigid"));
        return Ok(rigid);
    }
    let mut why = vec![reason];
    why.push(if rigid.status == Status::Complete {
        format!("contacts give way by up to {give:.2e} m, more than the tolerance of {tolerance} m: compliant")
    } else {
        "rigid contacts have no unique motion here: compliant".to_string()
    });
    let options = &Options { second_order: true, ..options.clone() };
    let lightest =
        world.bodies.iter().filter(|body| !body.is_kinematic).map(|body| body.mass).fold(f64::INFINITY, f64::min);
    let first = first.min(FIRST_PHASE * (lightest / stiffest(world)).sqrt());
    let mut compliant = refined(world, options, [first; 2], &why, |choice| {
        let mut stepper = SongPangKumar::new(world, options.second_order);
        run(world, options, ModelChoice { chosen: "spk", ..choice }, &mut stepper, watch)
    });
    let step = compliant.model.step;
    compliant.notes.splice(0..0, song_pang_kumar::notes(world, step, options.second_order));
    Ok(compliant)
}

/// Runs at a step and its half until the tolerance is met, or once where the step is given. The second of the first steps is
/// for scenes whose contacts change: coarse steps may meet that in another order, and their halves alike.
fn refined<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    [calm, first]: [f64; 2],
    why: &[String],
    mut run: impl FnMut(ModelChoice) -> Simulation<S>,
) -> Simulation<S> {
    let mut at = |step: f64, why: Vec<String>| run(ModelChoice { step, why, ..ModelChoice::default() });
    let with = |reason: String| why.iter().cloned().chain([reason]).collect::<Vec<_>>();
    if let Some(step) = options.step {
        return at(step, with("the step is the one asked for".to_string()));
    }
    if let Some(step) = world.step {
        let coarse = at(2.0 * step, Vec::new());
        let mut fine = match coarse.status {
            Status::Partial => return coarse,
            _ => at(step, with("the step is the scene's".to_string())),
        };
        fine.model.error = difference(world, &coarse, &fine);
        return fine;
    }
    let mut step = calm;
    let mut coarse = at(step, Vec::new());
    let is_calm = coarse.status == Status::Complete
        && coarse.solver.impacts == 0
        && coarse.events.iter().all(|event| event.time <= step);
    if step > first && !is_calm {
        step = first;
        coarse = at(step, Vec::new());
    }
    for halving in 1.. {
        if coarse.status == Status::Partial || coarse.time < world.duration {
            coarse.model.why = with(format!("the step is {step:.3e} s, at which the run ends early"));
            return coarse;
        }
        step *= 0.5;
        let mut fine = at(step, Vec::new());
        let error = difference(world, &coarse, &fine);
        let is_enough = error.is_some_and(|error| error <= options.tolerance);
        let is_last = halving == MAX_HALVINGS || world.duration / step > 0.25 * options.max_steps as f64;
        if fine.time < coarse.time {
            coarse.notes.push("stopped before the step was checked against its half".to_string());
            coarse.status = Status::Partial;
            return coarse;
        }
        if is_enough || is_last || fine.status == Status::Partial {
            let error_text = error.map_or("does not compare".to_string(), |error| format!("differs by {error:.1e} m"));
            let limit = if is_enough { "within" } else { "not within" };
            fine.model.why = with(format!(
                "the step is {step:.3e} s: the end {error_text} from that at twice the step, {limit} the tolerance of {} m",
                options.tolerance
            ));
            fine.model.error = error;
            return fine;
        }
        coarse = fine;
    }
    coarse
}

/// Largest distance of any point of a body between the ends of two runs (m), if both came as far.
fn difference<S: Mechanics>(world: &World<S>, a: &Simulation<S>, b: &Simulation<S>) -> Option<f64> {
    if a.time < world.duration || b.time < world.duration {
        return None;
    }
    let pairs = world.bodies.iter().zip(a.last.poses.iter().zip(&b.last.poses));
    Some(pairs.map(|(body, (a, b))| S::separation(S::radius(body), a, b)).fold(0.0, f64::max))
}

/// The weight of all that moves, or if that is more, the largest force on a contact at the end of a rigid run (N).
fn load<S: Mechanics>(world: &World<S>, rigid: &Simulation<S>) -> f64 {
    let gravity = world.gravity.as_ref().iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    let mass: f64 = world.bodies.iter().filter(|body| !body.is_kinematic).map(|body| body.mass).sum();
    let forces = rigid.last.touches.iter().map(|touch| touch.impulse[0] / rigid.model.step);
    forces.fold(gravity * mass, f64::max)
}

fn softest<S: Mechanics>(world: &World<S>) -> f64 {
    let all = world.materials.iter().filter_map(|material| material.compliance);
    all.map(|compliance| compliance.stiffness[0]).fold(f64::INFINITY, f64::min)
}

fn stiffest<S: Mechanics>(world: &World<S>) -> f64 {
    let all = world.materials.iter().filter_map(|material| material.compliance);
    all.flat_map(|compliance| compliance.stiffness).fold(0.0, f64::max)
}
