//! The most robust wrenches, and what their numbers claim, by other means.

mod acyclic;
mod goal;
#[path = "../support/mod.rs"]
mod support;

use num_traits::{One as _, Signed as _};
use partplan::answer::Insertion;
use partplan::exact::{Q, ratio};
use partplan::planner::{Question, insertion};
use support::random::Setup;

fn answer((part, fixture): &Setup) -> Insertion {
    insertion(part, fixture, &Question { robust: true, ..Question::default() }).expect("no modes are asked for")
}

fn norm2(g: &[Q], rho2: &Q) -> Q {
    &g[0] * &g[0] + &g[1] * &g[1] + &g[2] * &g[2] / rho2
}

/// Whether `root² ≥ square` although both were rounded to doubles and back.
fn covers(root: &Q, square: &Q) -> bool {
    !root.is_negative() && root * root * (Q::one() + ratio(1, 1_000_000_000_000_000)) >= *square
}
