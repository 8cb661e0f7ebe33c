//! Plans against the time-stepper, and strong stability against contact problems.

use crate::support::random::{any_setup, runs, seatable};
use num_traits::Signed as _;
use partplan::exact::ratio;
use partplan::planner::{Question, insertion};
use partplan::verify::{InsertTrials, Push, tally};
use proptest::prelude::*;

/// Gaps at the start, over the size of the part: as good as none.
const TINY: f64 = 1e-5;

proptest! {
    #![proptest_config(runs(48))]

    /// What the planner says to seat a part seats it, from every set of contacts, whatever solution the contact problems of the
    /// stepper have. Plans of less than a hundredth of a margin are left out: there a gap is not as good as none.
    #[test]
    fn plans_seat_the_part_in_the_time_stepper(
        (part, fixture) in prop_oneof![3 => seatable(), 1 => any_setup(1..=3)],
        seed in 0..1_000_u64,
    ) {
        let found = insertion(&part, &fixture, &Question::default()).unwrap();
        let plan = found.plan.filter(|plan| (&plan.margin2 - ratio(1, 10_000)).is_positive());
        prop_assume!(plan.is_some());
        let push = Push::recommended(&part, &plan.unwrap());
        let trials = InsertTrials::new(&part, &fixture, push, seed, Some(TINY));
        let tally = tally(&trials, 0..3 * trials.n_states(), &|| true).unwrap();
        prop_assert!(tally.refuted.is_empty(), "{:?}", tally);
        prop_assert!(2 * tally.inconclusive <= tally.runs(), "{:?}", tally);
    }
}
