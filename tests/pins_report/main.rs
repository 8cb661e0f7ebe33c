//! Reports on pins, against the published results of the public cases.

mod document;
mod published;
#[path = "../support/mod.rs"]
mod support;
mod words;
