//! Settings of the arm that are recommended.

use super::expected::{self, Expected};
use partplan::answer::{Design, SettingKind, Throw};
use partplan::exact::{Q, from_float_exact, ratio};
use partplan::model::{Range, Thrower};
use partplan::planner::{self, Sweep, ThrowQuestion};

fn swept(case: &Expected, thrower: &Thrower, margin: Q) -> Design {
    let sweep = Sweep { offset: [ratio(-1, 1), ratio(0, 1)], release: [ratio(300, 1), ratio(340, 1)], grid: 4, margin };
    let question = ThrowQuestion { sweep: Some(sweep), starts: 1, ..ThrowQuestion::default() };
    planner::throw(&case.part(), thrower, &question, &mut |_| true).unwrap().design.unwrap()
}

fn planned(case: &Expected, offset: f64, release: f64) -> Throw {
    let [offset, release_deg_per_s] = [offset, release].map(|value| from_float_exact(value).unwrap());
    let thrower = Thrower { offset, release_deg_per_s, ..case.thrower() };
    planner::throw(&case.part(), &thrower, &ThrowQuestion::default(), &mut |_| true).unwrap()
}

#[test]
fn a_recommended_arm_is_a_plan_and_its_sensor_reads_one_edge_all_over_the_margin() {
    let case = expected::of("triangle_6_8_10");
    let design = swept(&case, &case.thrower(), ratio(1, 100));
    let best = design.best.clone().unwrap();
    let setting = &design.settings[best.place];
    let (offset, release) = (design.offsets[best.place / 4], design.releases[best.place % 4]);
    assert!(best.is_proved && best.window[0] < best.window[1]);
    let answer = planned(&case, offset, release);
    assert_eq!(answer.status(), "plan");
    let at = 0.5 * (best.window[0] + best.window[1]);
    let size = answer.part_radius;
    for [across, along] in [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0], [0.5, 0.3]] {
        let near = planned(&case, offset + 0.01 * size * across, release * (1.0 + 0.01 * along));
        let set = &near.limit.sets[0];
        assert!(near.limit.is_unique_in_reach);
        let mut seen = 0;
        for (edge, radius) in &set.orbit {
            let [left, right] = [&near.edges[*edge].u_left, &near.edges[*edge].u_right].map(|end| end.to_f64());
            if (radius + left..=radius + right).contains(&at) {
                assert_eq!(Some(*edge), setting.edge);
                seen += 1;
            }
        }
        assert!(seen > 0);
    }
}

#[test]
fn settings_do_not_depend_on_the_number_of_threads() {
    let case = expected::of("triangle_6_8_10");
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| swept(&case, &case.thrower(), ratio(1, 100)))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn an_arm_that_would_slip_is_not_recommended() {
    let case = expected::of("triangle_6_8_10");
    let with = |mu: Q| {
        let friction = Some(Range { min: mu.clone(), max: mu });
        swept(&case, &Thrower { friction, ..case.thrower() }, ratio(1, 10))
    };
    let free = with(ratio(3, 1));
    let feeders = |design: &Design| {
        design
            .settings
            .iter()
            .filter(|setting| setting.kind == SettingKind::Feeder)
            .map(|setting| setting.friction)
            .collect()
    };
    let needed: Vec<f64> = feeders(&free);
    // friction that every pattern needs, but with no margin left
    let least = needed.iter().copied().fold(f64::INFINITY, f64::min);
    let bare = with(from_float_exact(1.05 * least).unwrap());
    assert!(!needed.is_empty() && bare.best.is_none());
    assert!(bare.why_none.is_some());
}

#[test]
fn a_sweep_that_is_stopped_says_so() {
    let case = expected::of("triangle_6_8_10");
    let sweep = Sweep {
        offset: [ratio(-1, 1), ratio(0, 1)],
        release: [ratio(300, 1), ratio(300, 1)],
        grid: 100,
        margin: ratio(0, 1),
    };
    let question = ThrowQuestion { sweep: Some(sweep), starts: 1, ..ThrowQuestion::default() };
    let mut is_in_sweep = false;
    let mut watch = |progress: planner::ThrowProgress| {
        is_in_sweep |= progress.stage == planner::ThrowStage::Sweep && progress.done > 0;
        !is_in_sweep
    };
    let answer = planner::throw(&case.part(), &case.thrower(), &question, &mut watch).unwrap();
    let design = answer.design.as_ref().unwrap();
    assert!(answer.is_stopped && design.best.is_none() && design.why_none.as_deref() == Some("the sweep was stopped"));
    assert_eq!((design.settings.len(), answer.status()), (100, "undecided"));
    let tried = design.settings.iter().filter(|setting| setting.kind != SettingKind::Open).count();
    assert!(0 < tried && tried < 100, "{tried}");
}
