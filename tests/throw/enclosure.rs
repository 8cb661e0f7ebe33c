//! The throw map on intervals of radii.

use super::expected::{self, Expected, index, number};
use partplan::exact::FloatInterval;
use partplan::mechanics::throwing::{Branch, BranchEnd, Elsewhere, Enclosing, Settling, Thrown};
use proptest::prelude::*;
use std::sync::LazyLock;

fn enclosing(case: &Expected) -> Enclosing {
    Enclosing::new(case.body(), case.body())
}

fn about(radius: f64, margin: f64) -> FloatInterval {
    FloatInterval::from_ends(radius - margin, radius + margin)
}

/// Proved to keep their branch by an independent program.
#[test]
fn throws_keep_one_branch_within_the_margins_of_the_public_cases() {
    for case in expected::all() {
        let enclosing = enclosing(&case);
        for (throws, margin) in [("throws", "throws_margin"), ("stress_throws", "stress_margin")] {
            let margin = case.answer[margin].as_f64().unwrap();
            let mut n_several = 0;
            let throws = case.answer[throws].as_array().unwrap();
            for throw in throws {
                let radii = about(number(&throw["R"]), margin);
                let branches = enclosing.branches(index(&throw["edge"]), radii, Settling::Full);
                let wanted = number(&throw["to_R"]);
                let (edge, steps) = (index(&throw["to_edge"]), throw["steps"].as_i64().unwrap());
                let is_met = |branch: &Branch| matches!(branch.end, BranchEnd::Rest { edge: e, steps: s, radii, .. } if (e, s) == (edge, steps) && radii.contains(wanted));
                assert!(branches.iter().any(is_met), "{}: {branches:?} for {throw}", case.name);
                n_several += usize::from(branches.len() > 1);
            }
            assert!(n_several == 0, "{} {margin}: {n_several} of {}", case.name, throws.len());
        }
    }
}

#[test]
fn enclosures_are_no_wider_than_the_map_stretches() {
    for case in expected::all() {
        let enclosing = enclosing(&case);
        for throw in case.answer["throws"].as_array().unwrap() {
            let (radius, slope) = (number(&throw["R"]), number(&throw["slope"]));
            let width = 1e-3;
            let branches = enclosing.branches(index(&throw["edge"]), about(radius, width), Settling::Full);
            let BranchEnd::Rest { radii, .. } = branches[0].end else { panic!("{}: {branches:?}", case.name) };
            let [low, high] = radii.ends();
            assert!(high - low < 2.0 * width * slope.abs() * 1.001 + 1e-12 * radius, "{}: {}", case.name, high - low);
        }
    }
}

fn is_within(interval: FloatInterval, value: f64, doubt: f64) -> bool {
    let [low, high] = interval.ends();
    low - doubt <= value && value <= high + doubt
}

proptest! {
    /// What a throw does is among what the interval says, also across breaks and grazing flights.
    #[test]
    fn intervals_hold_what_their_points_do(
        which in 0..10_usize, start in 0.0..1.0_f64, width in 1e-7..0.3_f64, inside in 0.0..1.0_f64,
    ) {
        static CASES: LazyLock<Vec<(String, Enclosing)>> =
            LazyLock::new(|| expected::all().iter().map(|case| (case.name.clone(), enclosing(case))).collect());
        let (name, enclosing) = &CASES[which];
        let body = enclosing.near();
        let stable: Vec<usize> = (0..body.n_corners()).filter(|edge| body.is_stable(*edge)).collect();
        let edge = stable[(start * 1e6) as usize % stable.len()];
        let clear = (0..body.n_corners()).map(|edge| body.ends(edge)[1].max(-body.ends(edge)[0])).fold(0.0, f64::max);
        let low = 1.5 * clear + start * 2.0 * body.lambda();
        let radii = FloatInterval::from_ends(low, low + width * clear);
        let branches = enclosing.branches(edge, radii, Settling::Full);
        let thrown_from = low + inside * width * clear;
        let thrown = body.throw(edge, thrown_from, Settling::Full);
        let is_told = |branch: &Branch| match (branch.end, thrown) {
            (BranchEnd::Rest { edge, steps, radii, moved }, Thrown::Caught(catch)) => {
                let doubt = 1e-13 * radii.ends()[1].abs();
                (edge, steps) == (catch.edge, catch.steps) && branch.impact_vertex == catch.impact_vertex
                    && is_within(radii, catch.radius, doubt)
                    && is_within(moved, catch.radius - thrown_from, doubt)
            }
            (BranchEnd::Other(Elsewhere::OffArm), Thrown::OffArm { .. }) => true,
            (BranchEnd::Other(Elsewhere::Balanced), Thrown::Balanced { .. }) => true,
            (BranchEnd::Other(elsewhere), _) => elsewhere == Elsewhere::Unknown,
            _ => false,
        };
        prop_assert!(branches.iter().any(is_told), "{} {edge} {radii:?}: {branches:?}, {thrown:?}", name);
    }
}
