mod cases;

use super::super::pins::tests::{assert_apart, height_of, written};
use super::super::tests::assert_well_formed;
use super::PAGE;
use super::cycle::cycle;
use super::pose::Pose;
use super::scale::Scale;
use crate::answer::{Certificate, CounterExample, EndedOrbit, Fate, SettingKind, Throw};
use crate::exact::{Q, Z, ratio};
use cases::{Drawn, design, regular, triangle};

fn one() -> Q {
    ratio(1, 1)
}

fn texts_of(svg: &str) -> Vec<String> {
    written(svg).into_iter().map(|written| written.text).collect()
}

fn says(svg: &str, text: &str) -> bool {
    texts_of(svg).iter().any(|written| written.contains(text))
}

/// Well formed, all numbers finite, and every text legible.
fn assert_sound(drawn: &Drawn) -> String {
    let svg = drawn.svg();
    assert_well_formed(&svg);
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", drawn.name);
    assert_apart(&drawn.name, &written(&svg), [PAGE, height_of(&svg)]);
    svg
}

/// The triangle, but for what `change` does.
fn changed(change: impl FnOnce(&mut Throw)) -> Drawn {
    let mut drawn = triangle(&one());
    change(&mut drawn.answer);
    drawn
}

fn without_limit_set(answer: &mut Throw) {
    answer.limit.sets.clear();
    answer.limit.orbits.clear();
    answer.sensors.clear();
    answer.certificate = Certificate::default();
}

#[test]
fn a_plan_is_drawn_with_all_its_pictures() {
    let svg = assert_sound(&triangle(&one()));
    let headings = ["States", "Sensor", "Orbits", "One cycle"];
    assert!(headings.iter().all(|heading| texts_of(&svg).iter().any(|text| text == heading)));
    assert!(says(&svg, "sensor at 27 cm: covered by edge 1 only") && says(&svg, "proved: all that recurs is here"));
    assert!(!says(&svg, "Settings of the arm") && !says(&svg, "not proved"));
}

#[test]
fn every_stable_edge_has_one_lane() {
    for corners in [3, 5, 12] {
        let drawn = regular(corners);
        let svg = assert_sound(&drawn);
        let lanes = texts_of(&svg).into_iter().take_while(|text| text != "Sensor");
        let names: Vec<String> = lanes.filter(|text| text.starts_with("edge ")).collect();
        assert_eq!(names, (0..corners).map(|edge| format!("edge {edge}")).collect::<Vec<_>>());
    }
}

#[test]
fn of_very_many_edges_twelve_are_drawn_and_that_is_said() {
    let svg = assert_sound(&regular(40));
    assert!(says(&svg, "12 of 40 stable edges are shown"));
    let lanes = texts_of(&svg).into_iter().take_while(|text| text != "Sensor");
    assert_eq!(lanes.filter(|text| text.starts_with("edge ")).count(), 12);
}

/// Corner 0 is the left end of edge 0, u_l = -8/3 from the center of mass, which is 2 over the edge; the hypotenuse has its
/// right angle, 4.8 high, over 3.6 from its right end.
#[test]
fn parts_lie_on_the_arm_as_in_the_frame_of_the_paper() {
    let drawn = triangle(&one());
    let pose = |edge: usize| Pose::new(&drawn.answer.hull, &drawn.part.center_of_mass, &one(), edge).unwrap();
    let near = |[x, y]: [f64; 2], [a, b]: [f64; 2]| (x - a).abs() < 1e-12 && (y - b).abs() < 1e-12;
    let flat = pose(0);
    let there = [[-8.0 / 3.0, 0.0], [16.0 / 3.0, 0.0], [-8.0 / 3.0, 6.0]];
    assert!(
        flat.corners.iter().zip(there).all(|(corner, there)| near(*corner, there)) && (flat.com - 2.0).abs() < 1e-12
    );
    let long = pose(1);
    let [right, top, left] = [2, 0, 1].map(|corner| long.corners[corner]);
    assert!(near([right[0] - left[0], right[1]], [10.0, 0.0]) && near([right[0] - top[0], top[1]], [3.6, 4.8]));
    for (edge, ends) in drawn.answer.edges.iter().map(|edge| [edge.u_left.to_f64(), edge.u_right.to_f64()]).enumerate()
    {
        let corners = pose(edge).corners;
        assert!(near(corners[edge], [ends[0], 0.0]) && near(corners[(edge + 1) % 3], [ends[1], 0.0]));
    }
}

#[test]
fn a_cycle_goes_from_one_arrival_to_the_next() {
    let drawn = triangle(&one());
    let set = &drawn.answer.limit.sets[0];
    let states = cycle(set);
    let mut order: Vec<usize> = states.iter().map(|(edge, _)| *edge).collect();
    order.dedup();
    assert_eq!(order, [1, 0, 2, 1]);
    assert!((8..20).contains(&states.len()));
}

#[test]
fn a_cycle_is_long_enough_to_visit_all_edges() {
    let drawn = changed(|answer| {
        let states = [(1, 12.0), (2, 13.0), (1, 14.0), (2, 15.0), (1, 16.0), (0, 17.0)];
        answer.limit.sets[0].orbit = states.iter().cycle().take(100).copied().collect();
        answer.limit.sets[0].pattern = vec![1, 2];
    });
    let edges: Vec<usize> = cycle(&drawn.answer.limit.sets[0]).iter().map(|(edge, _)| *edge).collect();
    assert_eq!(edges, [1, 2, 1, 0, 1]);
    assert!(says(&assert_sound(&drawn), "on edges 1, 2, 1, 0"));
}

#[test]
fn long_runs_of_jogs_are_told_and_not_drawn() {
    let drawn = changed(|answer| {
        let jogs = (0..15).map(|k| (1, 9.0 + f64::from(k)));
        let cycle: Vec<(usize, f64)> = jogs.chain([(0, 18.0), (2, 14.0)]).collect();
        answer.limit.sets[0].orbit = cycle.iter().cycle().take(100).copied().collect();
    });
    let svg = assert_sound(&drawn);
    assert!(says(&svg, "13 more jogs") && says(&svg, "before each of 17 throws"));
}

#[test]
fn without_a_limit_set_lanes_and_poses_remain() {
    let svg = assert_sound(&changed(without_limit_set));
    assert!(says(&svg, "no pattern was found") && says(&svg, "edge 2") && says(&svg, "R_max"));
    assert!(says(&svg, "Poses") && !says(&svg, "One cycle") && !says(&svg, "Orbits") && !says(&svg, "Sensor"));
}

#[test]
fn what_leaves_is_drawn() {
    for landing in [Some((2, [3.0, 3.1])), Some((0, [2.0, 2.0])), Some((17, [3.0, 4.0])), None] {
        let drawn = changed(|answer| {
            without_limit_set(answer);
            let example = CounterExample { edge: 0, radii: [14.0, 14.01], landing, leaves_domain: true };
            answer.certificate.counterexample = Some(example);
            let lost = |after, start| EndedOrbit { start, after, at: (0, 14.0), fate: Fate::NoGrasp };
            answer.limit.ended = vec![lost(7, (1, 12.0)), lost(0, (0, 14.0)), lost(900, (2, 70.0)), lost(2, (17, 9.0))];
        });
        assert_eq!(drawn.answer.status(), "no-plan");
        let svg = assert_sound(&drawn);
        assert!(says(&svg, "end where no throw is possible") && says(&svg, "all of them end"));
        assert_eq!(says(&svg, "beside the arm"), landing.is_none());
    }
}

#[test]
fn two_patterns_are_told_apart() {
    let svg = assert_sound(&changed(|answer| {
        let mut other = answer.limit.sets[0].clone();
        other.bands.values_mut().for_each(|band| *band = band.map(|end| end + 30.0));
        answer.limit.sets.push(other);
        answer.certificate.is_unique = false;
        answer.certificate.components.push(answer.certificate.components[0].clone());
    }));
    assert!(says(&svg, "2 patterns were met") && says(&svg, "proved: a pattern stays here"));
}

#[test]
fn tried_settings_are_a_map_or_a_curve() {
    for (offsets, releases) in [(3, 4), (1, 9), (6, 1), (1, 1), (24, 24)] {
        let svg = assert_sound(&changed(|answer| answer.design = Some(design(offsets, releases))));
        assert!(says(&svg, "recommended: 300\u{b0}/s with the offset -0.75 cm, proved"));
        assert_eq!(says(&svg, "parts delivered a second"), (offsets == 1) != (releases == 1));
    }
}

#[test]
fn settings_without_a_recommended_one_say_why() {
    let nothing = |answer: &mut Throw| {
        let mut tried = design(2, 2);
        tried.settings.iter_mut().for_each(|setting| setting.kind = SettingKind::Lost);
        (tried.best, tried.why_none) = (None, Some("every orbit ends".to_owned()));
        answer.design = Some(tried);
    };
    assert!(says(&assert_sound(&changed(nothing)), "every orbit ends"));
    let incomplete = |answer: &mut Throw| {
        let mut tried = design(2, 2);
        tried.settings.pop();
        answer.design = Some(tried);
    };
    assert!(!says(&assert_sound(&changed(incomplete)), "Settings"));
}

/// The units of the part change numbers and nothing else.
#[test]
fn a_part_of_any_size_is_drawn_alike() {
    let circles = |scale: &Q| assert_sound(&triangle(scale)).matches("<circle").count();
    let power = |exponent: u32| Q::from(Z::from(10).pow(exponent));
    assert!([power(9), power(9).recip()].iter().all(|scale| circles(scale).abs_diff(circles(&one())) < 4));
    assert_sound(&triangle(&power(200)));
    assert_sound(&triangle(&power(200).recip()));
    assert_sound(&triangle(&power(400)));
    assert_sound(&triangle(&power(400).recip()));
}

#[test]
fn numbers_that_are_none_are_left_out() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308] {
        let drawn = changed(|answer| {
            answer.limit.sets[0].orbit[40].1 = value;
            answer.limit.orbits[3][2].1 = value;
            answer.limit.sets[0].bands.insert(0, [value, value]);
            answer.reach.edges[1].r_max = value;
            answer.reach.edges[2].r_low = value;
            answer.sensors[0].windows[0].at = value;
            let mut tried = design(2, 3);
            tried.settings[0].parts_per_throw = value;
            tried.settings[3].seconds_per_throw = 0.0;
            answer.design = Some(tried);
        });
        assert_sound(&drawn);
    }
}

#[test]
fn empty_answers_are_drawn() {
    assert_sound(&changed(|answer| {
        without_limit_set(answer);
        answer.hull.clear();
        answer.stable.clear();
        answer.edges.clear();
        answer.reach.edges.clear();
    }));
    assert_sound(&changed(|answer| {
        answer.limit.sets[0].orbit.clear();
        answer.limit.sets[0].bands.clear();
        answer.limit.orbits = vec![Vec::new(), vec![(1, 9.0)]];
        answer.sensors[0].windows.clear();
        answer.sensors[0].footprints.clear();
    }));
    assert_sound(&changed(|answer| answer.limit.sets[0].orbit.truncate(1)));
}

#[test]
fn names_of_cases_are_escaped_and_shortened() {
    let named = |name: String| assert_sound(&Drawn { name, ..triangle(&one()) });
    assert!(named("a <b> & \"c\"\u{0} > d".to_owned()).contains("a &lt;b&gt; &amp; \"c\"  &gt; d"));
    assert!(named("long ".repeat(200)).contains('\u{2026}'));
}

#[test]
fn axes_end_beyond_their_values_and_start_at_zero_if_near() {
    let scale = |values: &[f64]| Scale::covering(values.iter().copied(), [100.0, 500.0]);
    assert_eq!(scale(&[3.0, 25.0]).values[0], 0.0);
    assert!(scale(&[20.0, 25.0]).values[0] > 19.0 && scale(&[20.0, 25.0]).values[1] > 25.0);
    assert_eq!(scale(&[]).values[0], 0.0);
    let single = scale(&[7.0, f64::NAN, f64::INFINITY]);
    assert!(single.holds(7.0) && (single.at(7.0) - 300.0).abs() < 20.0);
    assert_eq!((single.at(f64::NAN), single.at(f64::INFINITY), single.at(f64::NEG_INFINITY)), (100.0, 500.0, 100.0));
}
