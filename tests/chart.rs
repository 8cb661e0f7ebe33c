//! What `plan chart` measures: errors are known or repeated, and what is asked for is measured alone.

use partplan::answer::{Chart, ChartFamily, ChartMap, ChartPoint};
use partplan::case::{Limits, read_scene};
use partplan::chart::{ChartQuestion, chart};
use partplan::model::{Scene, World};
use std::cell::Cell;

fn measured(only: &str) -> Chart {
    let question = ChartQuestion { quick: true, only: Some(only.to_owned()), ..ChartQuestion::default() };
    chart(&question, &|_| true)
}

fn of<'a>(chart: &'a Chart, method: &str) -> Vec<&'a ChartPoint> {
    chart.points.iter().filter(|point| point.method == method).collect()
}

/// The points without their times.
fn figures(chart: &Chart) -> Vec<(String, Option<f64>, u64, u64)> {
    chart.points.iter().map(|point| (point.id(), point.error, point.failed, point.of)).collect()
}

#[test]
fn errors_are_repeated_and_a_point_is_measured_alone() {
    let all = measured("stepping/ball bounces");
    assert_eq!(figures(&all), figures(&measured("stepping/ball bounces")));
    assert_eq!(all.points.len(), 6, "two models that restitute, three steps");
    for (point, figures) in all.points.iter().zip(figures(&all)) {
        let alone = measured(&point.id());
        assert_eq!(self::figures(&alone), [figures]);
        assert!(alone.tiles.is_empty());
        let [low, median, high] = point.time;
        assert!(0.0 < low && low <= median && median <= high);
    }
    assert_eq!(measured("stepping/ball").points.len(), 0, "names are whole");
}

/// The first-order step errs by h v/2 on a box that slides to a stop from 3 m/s; located ends of slip leave less than h².
#[test]
fn time_steppers_err_as_their_order_says() {
    let slide = measured("stepping/box slides to a stop");
    let errors = |method: &str| of(&slide, method).iter().map(|point| point.error.unwrap()).collect::<Vec<_>>();
    for (error, h) in errors("Stewart-Trinkle").into_iter().zip([1e-2, 2e-3, 5e-4]) {
        assert!((error / (1.5 * h) - 1.0).abs() < 0.01, "{error} at {h}");
    }
    assert!(errors("Moreau").iter().zip([1e-2, 2e-3, 5e-4]).all(|(error, h)| *error < h * h));
    assert!(slide.points.iter().all(|point| point.failed == 0));
}

/// What a ball does on a soft floor no rigid model knows: it is pressed in by 6.27 mm, by the closed form of the oscillator.
#[test]
fn the_automatic_choice_takes_the_rung_that_a_scene_needs() {
    let chosen = |work: &str| measured(&format!("ladder/{work}/auto")).points.remove(0);
    let tolerance = 1e-3;
    for (work, rung) in [
        ("box on ice", "frictionless"),
        ("box slides to a stop", "moreau"),
        ("box slips on a hard floor", "moreau"),
        ("ball lands on a soft floor", "spk"),
    ] {
        let auto = chosen(work);
        assert!(auto.setting.starts_with(&format!("tolerance {tolerance}: {rung} ")), "{auto:?}");
        assert!(auto.error.unwrap() < tolerance, "{auto:?}");
    }
    let rigid = measured("ladder/ball lands on a soft floor/rigid");
    assert!(rigid.points.iter().all(|point| (point.error.unwrap() - 6.27e-3).abs() < 1e-5), "{rigid:?}");
    let ice = measured("ladder/box slides to a stop/frictionless");
    // it slides on for 1.5 s at 3 m/s instead of stopping after 9/(2 μ g) m
    assert!(ice.points.iter().all(|point| (point.error.unwrap() - 2.9709).abs() < 1e-3 && point.failed == 1));
}

#[test]
fn contact_problems_are_answered_and_failures_are_counted() {
    let ends = measured("lcp/squeezed, without solution");
    for point in &ends.points {
        let is_exact = matches!(point.method.as_str(), "ladder to integers" | "integers");
        assert_eq!((point.failed == 0, point.error == Some(0.0)), (is_exact, is_exact), "{point:?}");
    }
    let heavy = measured("lcp/stacks, ratio 1000");
    let failed = |method: &str| of(&heavy, method).iter().map(|point| point.failed).collect::<Vec<_>>();
    assert_eq!((failed("ladder to integers"), failed("integers")), (vec![0], vec![0]));
    let swept = failed("Gauss-Seidel");
    assert!(swept[0] == 50 && swept[2] > 40, "a heavy block on light ones: sweeps converge slowly, {swept:?}");
    // one contact: a sweep is the answer
    let light = measured("lcp/planar, 1 to 4 contacts/Gauss-Seidel");
    let failed: Vec<u64> = light.points.iter().map(|point| point.failed).collect();
    assert!(failed.is_sorted_by(|a, b| a >= b) && failed[0] < 60 && failed[3] == 0, "{failed:?}");
}

/// Integers are never wrong, whatever their width; doubles are where slivers are narrower than their tolerance.
#[test]
fn cones_in_integers_are_right_and_those_in_doubles_are_not() {
    let chart = measured("cone");
    let works = ["generic", "degenerate", "nearly degenerate"];
    assert_eq!(chart.points.len(), works.len() * 7 * 3);
    for point in &chart.points {
        let is_integer = !point.method.starts_with("doubles");
        assert!(!is_integer || matches!(point.error, None | Some(0.0)), "{point:?}");
        let always_answers = matches!(point.method.as_str(), "any size" | "climbing");
        assert!(!always_answers || point.failed == 0, "{point:?}");
        // rows with 4 bits fit anywhere, and no doubt arises
        assert!(point.setting != "4 bits" || (point.error, point.failed) == (Some(0.0), 0), "{point:?}");
    }
    let narrow = measured("cone/nearly degenerate/doubles, 1e-6/20 bits");
    assert!(narrow.points[0].failed > 30, "{narrow:?}");
    let overflow = measured("cone/generic/i64/50 bits");
    assert_eq!((overflow.points[0].error, overflow.points[0].failed), (None, 40));
}

#[test]
fn heights_beside_critical_ones_are_told_apart_exactly_only() {
    let chart = measured("toppling");
    assert_eq!(chart.points.len(), 9);
    for point in chart.points.iter().filter(|point| point.method != "doubles") {
        assert_eq!((point.error, point.failed), (Some(0.0), 0), "{point:?}");
    }
    let doubles: Vec<u64> = of(&chart, "doubles").iter().map(|point| point.failed).collect();
    assert!(doubles[0] == 0 && doubles[2] > 20, "{doubles:?}");
}

/// Finer cells enclose more tightly; an enclosure at 1024 cells is off by about two cells.
#[test]
fn throws_are_enclosed_more_tightly_by_finer_cells() {
    let proofs = measured("throw/triangle with sides 6, 8 and 10/proof by intervals");
    let errors: Vec<f64> = proofs.points.iter().map(|point| point.error.unwrap()).collect();
    assert!(errors.is_sorted_by(|a, b| a > b) && errors[2] < 3.0 / 1024.0, "{errors:?}");
}

#[test]
fn maps_tell_where_methods_fail() {
    let chart = measured("step-stiffness/Song-Pang-Kumar, 2nd order");
    let at = |step: f64, stiffness: f64| {
        let found = chart.tiles.iter().find(|tile| (tile.x, tile.y) == (step, stiffness)).unwrap();
        [found.succeeded, found.ambiguous, found.failed]
    };
    // a tenth of a step a period is enough, ten periods a step are not
    assert_eq!((at(1e-4, 1e3), at(1e-2, 1e7)), ([1, 0, 0], [0, 0, 1]));
    assert!(chart.points.is_empty() && chart.tiles.iter().all(|tile| tile.map == ChartMap::StepStiffness));
    let gauss = measured("degeneracy-conditioning/Gauss-Seidel, 1000 sweeps");
    let failed = |ratio: f64| gauss.tiles.iter().filter(|tile| tile.y == ratio).map(|tile| tile.failed).sum::<u64>();
    assert!(failed(1.0) == 0 && failed(1e9) > 40, "{gauss:?}");
}

/// A scene of a user is measured against itself at a much smaller step.
#[test]
fn scenes_are_charted() {
    let text = r#"{"name": "box", "scene": {"gravity": [3, -9.81], "duration": 0.1, "friction": 0.2, "bodies": [{"name": "box",
        "shape": {"polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}, "mass": 1, "pose": [0, 1, 0]}],
        "fixed": [{"name": "floor", "shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}]}}"#;
    let scene = read_scene(text.as_bytes(), &Limits::default()).unwrap().scene;
    let question = ChartQuestion { quick: true, scenes: vec![("box".to_owned(), scene)], ..ChartQuestion::default() };
    let chart = chart(&question, &|_| true);
    let families: Vec<ChartFamily> = chart.points.iter().map(|point| point.family).collect();
    assert_eq!(families, [vec![ChartFamily::Stepping; 6], vec![ChartFamily::Ladder; 1]].concat());
    // it slips at 3 - 0.2 g: first-order steps run ahead by a h t/2
    for (point, h) in of(&chart, "Stewart-Trinkle").into_iter().zip([1e-2, 2e-3, 5e-4]) {
        let ahead = (3.0 - 0.2 * 9.81) * h * 0.1 / 2.0;
        assert!((point.error.unwrap() - ahead).abs() < 0.02 * ahead, "{point:?}");
    }
}

/// One that says how its surfaces give way is measured against the compliant model, whose choice is then right.
#[test]
fn compliant_scenes_are_charted() {
    let scene = read_scene(include_bytes!("../cases/peg_drop.json"), &Limits::default()).unwrap().scene;
    let Scene::Planar(world) = scene else { panic!("it is planar") };
    let scenes = vec![("peg".to_owned(), Scene::Planar(World { duration: 0.2, ..world }))];
    let chart = chart(&ChartQuestion { quick: true, scenes, ..ChartQuestion::default() }, &|_| true);
    assert_eq!(chart.points.len(), 4 * 3 + 1);
    let auto = of(&chart, "auto")[0];
    assert!(auto.error.unwrap() < 1e-3 && auto.setting.contains("spk"), "{auto:?}");
}

#[test]
fn a_watch_ends_it() {
    // asked before and after each point, and not again on short ones
    let left = Cell::new(8);
    let stopped = chart(&ChartQuestion { quick: true, ..ChartQuestion::default() }, &|_| {
        left.set(left.get() - 1);
        left.get() >= 0
    });
    assert_eq!((stopped.points.len(), stopped.tiles.len()), (4, 0));
    let text = r#"{"scene": {"gravity": [0, -9.81], "duration": 1e6, "friction": 0.2, "bodies": [{"name": "ball", "mass": 1,
        "shape": {"circle": {"center": [0, 0], "radius": 1}}, "pose": [0, 1, 0]}],
        "fixed": [{"name": "floor", "shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}]}}"#;
    let scene = read_scene(text.as_bytes(), &Limits::default()).unwrap().scene;
    let question = ChartQuestion { quick: true, scenes: vec![("long".to_owned(), scene)], ..ChartQuestion::default() };
    left.set(3);
    let stopped = chart(&question, &|_| {
        left.set(left.get() - 1);
        left.get() >= 0
    });
    assert!(stopped.points.is_empty(), "its reference alone would take days");
}
