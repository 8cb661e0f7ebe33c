//! Contacts and their changes in words.

use super::{Run, Shown};
use crate::answer::{ContactName, ContactState, Event, Feature};

/// Longest name shown to people.
const LONGEST: usize = 28;

/// A name for people: without control characters, cut where it is long.
#[must_use]
pub fn plain(name: &str) -> String {
    let shown: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).take(LONGEST).collect();
    if name.chars().nth(LONGEST).is_some() { format!("{shown}\u{2026}") } else { shown }
}

/// A contact: `peg vertex 0 / floor`.
#[must_use]
pub fn contact<S: Shown>(run: &Run<S>, contact: &ContactName, name: impl Fn(&str) -> String) -> String {
    let side = |number: usize, feature: Feature| format!("{}{}", name(&bearer(run, number)), words::<S>(feature));
    format!("{} / {}", side(contact.body, contact.feature), side(contact.other, contact.other_feature))
}

/// What changes at a contact, in words.
#[must_use]
pub fn change(event: &Event) -> &'static str {
    use ContactState::{Open, Slip, Stick};
    match (event.from, event.to) {
        (Open, Stick) => "touches and sticks",
        (Open, Slip) => "touches and slips",
        (Stick | Slip, Open) => "comes apart",
        (Stick, Slip) => "starts to slip",
        (Slip, Stick) => "stops slipping",
        (Open, Open) => "stays apart",
        (Stick, Stick) => "sticks",
        (Slip, Slip) => "slips on",
    }
}

/// The name of a body, or, numbered after those, of what is fixed.
fn bearer<S: Shown>(run: &Run<S>, number: usize) -> String {
    let bodies = run.world.bodies.iter().map(|body| &body.name);
    let mut names = bodies.chain(run.world.fixed.iter().map(|fixed| &fixed.name));
    names.nth(number).cloned().unwrap_or_else(|| format!("body {number}"))
}

fn words<S: Shown>(feature: Feature) -> String {
    match feature {
        Feature::Vertex(number) => format!(" vertex {number}"),
        Feature::Edge(number) => format!(" edge {number}"),
        Feature::Surface(0) => String::new(),
        // nothing in space is made of pieces
        Feature::Surface(number) if S::DIMENSION == 3 => format!(" face {number}"),
        Feature::Surface(number) => format!(" piece {number}"),
    }
}
