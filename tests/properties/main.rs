//! What must hold for every fixture, judged by oracles that share no code with the planner.

mod carries;
mod complementarity;
mod cones;
mod invariance;
mod places;
mod sets;
#[path = "../support/mod.rs"]
mod support;
mod toppling;
mod transitions;
mod verification;
