//! Plans against dynamics.

#[path = "../support/mod.rs"]
mod support;

mod insert;
mod pins;
mod throw;
mod wrench_scenes;
