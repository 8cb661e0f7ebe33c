//! The whole planner against the public cases.

use super::expected::{self, Expected, index, number};
use partplan::answer::{Fate, LimitSet, Piece, Throw};
use partplan::exact::{from_float_exact, parse_literal};
use partplan::mechanics::throwing::{Settling, Thrown};
use partplan::model::Thrower;
use partplan::planner::{self, ThrowError, ThrowQuestion};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// All answers, asked about all throws that the cases tell.
static ANSWERS: LazyLock<Vec<(Expected, Throw)>> = LazyLock::new(|| {
    let answer = |case: Expected| {
        let asked = |throw: &Value| (index(&throw["edge"]), parse_literal(throw["R"].as_str().unwrap()).unwrap());
        let throws = case.answer["throws"].as_array().unwrap().iter().map(asked).collect();
        let question = ThrowQuestion { throws, ..ThrowQuestion::default() };
        let answer = planner::throw(&case.part(), &case.thrower(), &question, &mut |_| true).unwrap();
        (case, answer)
    };
    expected::all().into_iter().map(answer).collect()
});

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// What is told by edge.
fn by_edge(value: &Value) -> impl Iterator<Item = (usize, &Value)> {
    value.as_object().unwrap().iter().map(|(edge, value)| (edge.parse().unwrap(), value))
}

#[test]
fn breaks_of_the_map_and_its_ranges_agree() {
    for (case, answer) in ANSWERS.iter() {
        let wanted = &case.answer["Z"];
        assert!(
            (answer.reach.scan_to - number(&wanted["scan_to"])).abs() < 1e-9 * answer.reach.scan_to,
            "{}",
            case.name
        );
        for (edge, wanted) in by_edge(&wanted["edges"]) {
            let reach = answer.reach.edges.iter().find(|reach| reach.edge == edge).unwrap();
            let close = |found: f64, wanted: f64, by: f64| (found - wanted).abs() <= by * answer.part_radius;
            // the reference starts a billionth above the end of the domain
            let is_start = |radius: f64| (radius - reach.r_low).abs() <= 2e-9 * reach.r_low;
            if let (Some(r_flip), false) = (wanted["R_flip"].as_f64(), reach.pieces.is_empty()) {
                let found = reach.r_flip.unwrap();
                assert!(
                    close(found, r_flip, 1e-10) || is_start(r_flip) && is_start(found),
                    "{} {edge}: {found} {r_flip}",
                    case.name
                );
            }
            if let Some(r_max) = wanted["R_max"].as_f64() {
                assert!(close(reach.r_max, r_max, 1e-8), "{} {edge}: {} {r_max}", case.name, reach.r_max);
            }
            let all = wanted["pieces"].as_array().unwrap();
            let narrow = answer.reach.scan_to / 1_500.0;
            // a narrow piece that the reference missed splits the one about it
            let mut found = reach.pieces.iter().peekable();
            for (place, wanted) in all.iter().enumerate() {
                while found.peek().is_some_and(|piece| !is_same(piece, wanted)) {
                    let piece = found.next().unwrap();
                    assert!(piece.to - piece.from < narrow, "{} {edge}: {piece:?} before {wanted}", case.name);
                }
                let Some(piece) = found.next() else { panic!("{} {edge}: no {wanted}", case.name) };
                let [from, to] = [&wanted["from"], &wanted["to"]].map(number);
                assert!(
                    close(piece.from, from, 1e-10) || place == 0 && is_start(piece.from),
                    "{} {edge}: {piece:?} {wanted}",
                    case.name
                );
                assert!(close(piece.to, to, 1e-10), "{} {edge}: {piece:?} {wanted}", case.name);
            }
            assert!(all.len() == 40 || found.all(|piece| piece.to - piece.from < narrow), "{} {edge}", case.name);
        }
    }
}

fn is_same(piece: &Piece, wanted: &Value) -> bool {
    let landing = wanted["edge"].as_u64().map(|_| (index(&wanted["edge"]), wanted["steps"].as_i64().unwrap()));
    (piece.impact_vertex, piece.landing) == (index(&wanted["impact_vertex"]), landing)
}

#[test]
fn cycles_of_the_approximated_system_agree() {
    for (case, answer) in ANSWERS.iter() {
        let wanted = &case.answer["hybrid"];
        assert_eq!(json!(answer.hybrid.cycles), wanted["cycles"], "{}", case.name);
        for (edge, wanted) in by_edge(&wanted["next"]) {
            let Some(slide) = answer.hybrid.slides.iter().find(|slide| slide.edge == edge) else {
                assert!(wanted["slides_next_on"].is_null(), "{} {edge}: {wanted}", case.name);
                continue;
            };
            assert_eq!(json!(slide.next), wanted["slides_next_on"], "{} {edge}", case.name);
            let flips = wanted["flips"].as_array().unwrap();
            if slide.next.is_some() {
                assert_eq!(slide.flips.len(), flips.len(), "{} {edge}", case.name);
                for ((onto, radius, steps), wanted) in slide.flips.iter().zip(flips) {
                    assert_eq!((*onto, *steps), (index(&wanted[0]), wanted[2].as_i64().unwrap()));
                    assert!(
                        (radius - number(&wanted[1])).abs() < 1e-7 * answer.part_radius,
                        "{} {edge}: {radius} {wanted}",
                        case.name
                    );
                }
            }
        }
    }
}

/// Whether the sets have the same bands, as far as bands are known, and the same transitions.
fn is_alike(found: &LimitSet, wanted: &Value, part_radius: f64) -> bool {
    let slack = 3.0 * wanted["band_spread_between_starts"].as_f64().unwrap() + 0.01 * part_radius;
    let bands: BTreeMap<usize, Vec<f64>> = by_edge(&wanted["bands"]).map(|(edge, band)| (edge, floats(band))).collect();
    let transitions: BTreeSet<String> = found.transitions.iter().map(|[from, to]| format!("{from}>{to}")).collect();
    let expected: BTreeSet<String> =
        wanted["transitions"].as_array().unwrap().iter().map(|one| one.as_str().unwrap().to_owned()).collect();
    found.bands.len() == bands.len()
        && transitions == expected
        && found.bands.iter().all(|(edge, band)| {
            bands.get(edge).is_some_and(|wanted| band.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= slack))
        })
}

#[test]
fn limit_sets_agree() {
    for (case, answer) in ANSWERS.iter() {
        let wanted = &case.answer["limit_set"];
        let sets = wanted["sets"].as_array().unwrap();
        assert_eq!(answer.limit.sets.len(), sets.len(), "{}", case.name);
        assert_eq!(json!(answer.limit.is_unique), wanted["unique"], "{}", case.name);
        for set in sets {
            let found = answer.limit.sets.iter().find(|found| is_alike(found, set, answer.part_radius));
            let found = found.unwrap_or_else(|| {
                panic!(
                    "{}: none is {set}\n{:?}",
                    case.name,
                    answer.limit.sets.iter().map(|s| (&s.bands, &s.transitions)).collect::<Vec<_>>()
                )
            });
            assert_eq!(json!(found.period), set["period"], "{}", case.name);
            // of edges that look alike either may be met more often
            let class = |edge: usize| answer.classes.iter().position(|class| class.contains(&edge));
            assert_eq!(class(found.main_edge), class(index(&set["main_edge"])), "{}", case.name);
            let ratio = |found: f64, wanted: f64| (found / wanted - 1.0).abs();
            assert!(ratio(found.throws_per_cycle, number(&set["throws_per_cycle"])) < 0.05, "{}", case.name);
            assert!((found.lyapunov - number(&set["lyapunov_per_throw"])).abs() < 0.02, "{}", case.name);
            for (edge, share) in by_edge(&set["share"]) {
                assert!((found.share[&edge] - number(share)).abs() < 0.02, "{} {edge}", case.name);
            }
            for (edge, jogs) in by_edge(&set["jogs_between_flips"]) {
                let found = found.jogs[&edge];
                let [least, most] = [0, 1].map(|k| index(&jogs[k]));
                assert!(
                    found[0].abs_diff(least) <= 1 && found[1].abs_diff(most) <= 1,
                    "{} {edge}: {found:?} {jogs}",
                    case.name
                );
            }
        }
    }
}

#[test]
fn sensors_agree_in_both_readings() {
    let mut compared = [0, 0];
    for (case, answer) in ANSWERS.iter() {
        let sets = case.answer["limit_set"]["sets"].as_array().unwrap();
        for (wanted, set) in case.answer["sensor"].as_array().unwrap().iter().zip(sets) {
            let number_of =
                answer.limit.sets.iter().position(|found| is_alike(found, set, answer.part_radius)).unwrap();
            let sensor = &answer.sensors[number_of];
            let slack = 3.0 * set["band_spread_between_starts"].as_f64().unwrap() + 0.01 * answer.part_radius;
            let close =
                |found: [f64; 2], wanted: &Value| found.iter().zip(floats(wanted)).all(|(a, b)| (a - b).abs() <= slack);
            for (edge, ends) in by_edge(&wanted["footprints"]) {
                assert!(close(sensor.footprints[&edge], ends), "{} {edge}", case.name);
            }
            let is_alone = answer.classes.iter().all(|class| class.len() == 1);
            if let (Some(beyond), true) =
                (&sensor.beyond, wanted["com_radius"]["usable"].as_bool().unwrap() && is_alone)
            {
                assert_eq!(beyond.edges, [index(&wanted["com_radius"]["edge"])], "{}", case.name);
                assert!(close(beyond.range, &wanted["com_radius"]["R_over"]), "{}: {beyond:?} {wanted}", case.name);
                compared[0] += 1;
            }
            if wanted["footprint"]["usable"].as_bool().unwrap() && is_alone {
                let found = sensor.windows.iter().find(|window| close(window.range, &wanted["footprint"]["sensor_at"]));
                let found = found
                    .unwrap_or_else(|| panic!("{}: none is {}\n{:?}", case.name, wanted["footprint"], sensor.windows));
                assert_eq!(found.edges, [index(&wanted["footprint"]["edge"])], "{}", case.name);
                compared[1] += 1;
            }
        }
    }
    assert!(compared[0] > 4 && compared[1] > 4, "{compared:?}");
}

#[test]
fn certificates_agree_and_orbits_end_in_proved_bands() {
    let mut n_proved = 0;
    for (case, answer) in ANSWERS.iter() {
        let (proof, wanted) = (&answer.certificate, &case.answer["proof"]);
        assert_eq!(answer.status() == "plan", proof.is_unique && answer.window().is_some(), "{}", case.name);
        if wanted["tried"] == false {
            continue;
        }
        assert_eq!(json!(proof.is_invariant), wanted["invariant"], "{}", case.name);
        assert_eq!(json!(proof.is_invariant && proof.is_unique), wanted["unique"], "{}", case.name);
        for (edge, range) in by_edge(&wanted["Z"]) {
            let close = |found: f64, wanted: f64| (found - wanted).abs() < 1e-3 * answer.part_radius;
            assert!(proof.z[&edge].iter().zip(floats(range)).all(|(a, b)| close(*a, b)), "{} {edge}", case.name);
        }
        if wanted["unique"] == false {
            continue;
        }
        let body = case.body::<f64>();
        let within = |radius: f64| move |[low, high]: [f64; 2]| low <= radius && radius <= high;
        for (edge, range) in by_edge(&wanted["Z"]) {
            let range = floats(range);
            for k in 0..=40 {
                let mut at = (edge, range[0] + (range[1] - range[0]) * f64::from(k) / 40.0);
                for throw in 0..1_500 {
                    let Thrown::Caught(catch) = body.throw(at.0, at.1, Settling::Full) else {
                        panic!("{}: lost at {at:?}", case.name)
                    };
                    at = (catch.edge, catch.radius);
                    if throw >= 1_000 {
                        let bands = &wanted["components"][0]["bands"][at.0.to_string()];
                        let mut expected =
                            bands.as_array().unwrap().iter().map(|band| [number(&band[0]), number(&band[1])]);
                        assert!(expected.any(within(at.1)), "{}: {at:?}", case.name);
                        let own = &proof.components[0].bands[&at.0];
                        assert!(own.iter().copied().any(within(at.1)), "{}: {at:?}", case.name);
                    }
                }
            }
        }
        n_proved += 1;
    }
    assert_eq!(n_proved, 7);
}

#[test]
fn throws_away_from_breaks_are_certain_and_those_next_to_one_have_two_outcomes() {
    for (case, answer) in ANSWERS.iter() {
        assert!(answer.throws.iter().all(|query| query.is_certain && query.fates.len() == 1), "{}", case.name);
        let breaks = answer.reach.edges.iter().flat_map(|edge| {
            // pieces far wider than what counts as near
            let is_wide = |piece: &Piece| piece.to - piece.from > 1e-3 * answer.part_radius;
            let is_told =
                move |pair: &&[Piece]| pair.iter().all(is_wide) && pair.iter().any(|piece| piece.landing.is_some());
            let pairs = edge.pieces.windows(2).filter(is_told);
            pairs.map(|pair| (edge.edge, pair[0], pair[1]))
        });
        let breaks: Vec<(usize, Piece, Piece)> = breaks.collect();
        let throws = breaks.iter().map(|(edge, piece, _)| (*edge, from_float_exact(piece.to).unwrap())).collect();
        let question = ThrowQuestion { throws, ..ThrowQuestion::default() };
        let asked = planner::throw(&case.part(), &case.thrower(), &question, &mut |_| false).unwrap();
        for (query, (_, before, after)) in asked.throws.iter().zip(&breaks) {
            let is_of = |piece: &Piece| {
                query.fates.iter().any(|fate| match fate {
                    Fate::Caught(caught) => {
                        piece.landing == Some((caught.edge, caught.steps))
                            && piece.impact_vertex == caught.impact_vertex
                    }
                    Fate::OffArm { vertex, .. } => {
                        piece.landing.is_none()
                            && (*vertex == piece.impact_vertex || before.impact_vertex == after.impact_vertex)
                    }
                    _ => false,
                })
            };
            assert!(
                !query.is_certain && is_of(before) && is_of(after),
                "{}: {query:?} {before:?} {after:?}",
                case.name
            );
        }
    }
}

#[test]
fn a_planner_that_is_stopped_at_once_is_undecided() {
    let case = expected::of("triangle_6_8_10");
    let mut asked = 0;
    let question = ThrowQuestion { starts: usize::MAX / 2, ..ThrowQuestion::default() };
    let mut watch = |_| {
        asked += 1;
        false
    };
    let answer = planner::throw(&case.part(), &case.thrower(), &question, &mut watch).unwrap();
    assert!(answer.is_stopped && answer.limit.sets.is_empty() && asked == 1);
    assert_eq!(answer.status(), "undecided");
}

#[test]
fn arms_and_throws_of_any_size_are_answered_or_refused() {
    let case = expected::of("triangle_6_8_10");
    let asked = |offset: &str, radius: &str| {
        let thrower = Thrower { offset: parse_literal(offset).unwrap(), ..case.thrower() };
        let question = ThrowQuestion { throws: vec![(0, parse_literal(radius).unwrap())], ..ThrowQuestion::default() };
        planner::throw(&case.part(), &thrower, &question, &mut |_| true)
    };
    for offset in ["1e6", "-1e6", "100", "-100", "1e-300"] {
        assert!(asked(offset, "1e6").is_ok(), "{offset}");
    }
    for radius in ["1e9", "1e30", "1e400"] {
        assert_eq!(asked("0", radius), Err(ThrowError::TooFar { edge: 0 }));
    }
    assert_eq!(asked("-1e40", "1"), Err(ThrowError::OutOfRange));
    assert!(asked("0", "-1e400").is_ok_and(|answer| answer.throws[0].fates == [Fate::NoGrasp]));
}
