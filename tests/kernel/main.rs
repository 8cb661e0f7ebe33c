//! The cone kernel and its integers, judged by their definitions and by slow exact oracles.

mod closed;
mod combination;
mod difference;
mod draw;
mod integers;
mod naive;
mod nearest;
mod pitfalls;
mod polyhedra;
mod rungs;
mod spatial;
mod strict;
#[path = "../support/mod.rs"]
mod support;
mod volume;
