//! What pins do to parts on a conveyor, against public cases, force balance, and closed forms.

mod oracle;
mod public;
#[path = "../support/mod.rs"]
mod support;
