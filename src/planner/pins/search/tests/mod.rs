//! Checks against enumeration without any pruning, against the cases' own answers, and by replay.

mod arcs;

mod cases;
mod enumeration;
mod heights;
mod scene;
