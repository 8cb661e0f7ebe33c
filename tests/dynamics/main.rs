//! The time-steppers against the published scenes, closed forms and invariants.

mod dbg;
mod discrete;
mod peers;
mod published;
