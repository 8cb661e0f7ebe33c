//! Starts from which no part is lost, where some are.

use super::expected::{self, Expected};
use partplan::answer::Throw;
use partplan::mechanics::throwing::{Settling, Thrown};
use partplan::planner::{self, ThrowQuestion};

fn planned(case: &Expected) -> Throw {
    planner::throw(&case.part(), &case.thrower(), &ThrowQuestion::default(), &mut |_| true).unwrap()
}

/// Edge and radius after so many throws; `None` if the part is lost.
fn followed(case: &Expected, answer: &Throw, start: (usize, f64), count: usize) -> Option<(usize, f64)> {
    let body = case.body::<f64>();
    let low = |edge: usize| answer.reach.edges.iter().find(|reach| reach.edge == edge).map(|reach| reach.r_low);
    let mut at = start;
    for _ in 0..count {
        match body.throw(at.0, at.1, Settling::Full) {
            Thrown::Caught(catch) if low(catch.edge).is_some_and(|low| catch.radius >= low) => {
                at = (catch.edge, catch.radius);
            }
            _ => return None,
        }
    }
    Some(at)
}

#[test]
fn parts_that_start_there_come_to_the_pattern_and_starts_that_lose_them_are_not_there() {
    for name in ["triangle_friction", "random_10"] {
        let case = expected::of(name);
        let answer = planned(&case);
        let proof = &answer.certificate;
        assert!(!proof.is_invariant && proof.is_unique && answer.status() == "plan", "{name}");
        let is_start = |(edge, radius): (usize, f64)| {
            proof
                .starts
                .get(&edge)
                .is_some_and(|ranges| ranges.iter().any(|[low, high]| *low <= radius && radius <= *high))
        };
        let mut n_starts = 0;
        for (edge, ranges) in &proof.starts {
            for [low, high] in ranges {
                for share in [0.0, 0.31, 0.77, 1.0] {
                    let start = (*edge, low + share * (high - low));
                    let end =
                        followed(&case, &answer, start, 1_000).unwrap_or_else(|| panic!("{name}: lost from {start:?}"));
                    let bands = &proof.components[0].bands[&end.0];
                    assert!(
                        bands.iter().any(|[low, high]| *low <= end.1 && end.1 <= *high),
                        "{name}: {start:?} {end:?}"
                    );
                    n_starts += 1;
                }
            }
        }
        assert!(n_starts > 40, "{name}: {n_starts}");
        for ended in &answer.limit.ended {
            assert!(!is_start(ended.start), "{name}: {:?}", ended.start);
        }
        assert!(!answer.limit.ended.is_empty());
    }
}
