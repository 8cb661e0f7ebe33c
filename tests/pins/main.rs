//! What pins do to parts on a conveyor, against public cases, balance of forces, and closed forms.

mod agree;
mod boxes;
mod closed;
mod expected;
mod extreme;
mod margins;
mod oracle;
mod properties;
mod search;
#[path = "../support/mod.rs"]
mod support;
