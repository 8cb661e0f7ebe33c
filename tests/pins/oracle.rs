//! The oracle against what independent exact implementations answered, so that it may judge the planner.

use crate::support::cases::number;
use crate::support::conveyed::{action, all, edge, edges, height, list, optional, point};
use partplan::answer::PinAction;
use partplan::exact::{Q, to_f64};

#[test]
fn it_finds_hull_edges_and_turns() {
    for case in all() {
        let (oracle, expected, name) = (&case.oracle, &case.expected, case.name);
        assert_eq!(oracle.hull, list(&expected["hull"]).iter().map(point).collect::<Vec<[Q; 2]>>(), "{name}");
        assert_eq!(oracle.stable, edges(&expected["stable"]), "{name}");
        for (at, orientation) in oracle.stable.iter().zip(list(&expected["orientations"])) {
            assert_eq!(*at, edge(&orientation["edge"]), "{name}");
            assert_eq!(oracle.next(*at), edge(&orientation["next"]), "{name}, edge {at}");
            assert_eq!(oracle.pivots(*at), edges(&orientation["pivots"]), "{name}, edge {at}");
            assert!((oracle.height(*at) / height(&orientation["height"]) - 1.0).abs() < 1e-12, "{name}, edge {at}");
            for (turn, key) in oracle.turns(*at).into_iter().zip(["theta_t_deg", "theta_1_deg"]) {
                let theirs = orientation[key].as_f64().expect("an angle");
                assert!((turn.to_degrees() - theirs).abs() < 1e-7, "{name}, edge {at}: {turn} {theirs}");
            }
        }
    }
}

#[test]
fn it_agrees_inside_of_every_interval_and_just_beyond_its_ends() {
    for case in all() {
        for orientation in list(&case.expected["orientations"]) {
            let at = edge(&orientation["edge"]);
            for interval in list(&orientation["intervals"]) {
                let from = height(&interval["from"]);
                let to = if interval["to"].is_null() { 2.0 * from } else { height(&interval["to"]) };
                for h in [from * (1.0 + 1e-6), from + (to - from) / 2.0, to * (1.0 - 1e-6)] {
                    let ours = case.oracle.action(at, h.max(1e-6 * to));
                    assert_eq!(ours, Some(action(&interval["action"])), "{}, edge {at} at {h}", case.name);
                }
            }
        }
    }
}

#[test]
fn it_touches_first_what_the_table_says() {
    for case in all() {
        for orientation in list(&case.expected["orientations"]) {
            let at = edge(&orientation["edge"]);
            let table = list(&orientation["topple"]);
            let mut covered = 0.0;
            for row in table {
                let [from, to] = ["from", "to"].map(|key| height(&row[key]));
                covered += to - from;
                for h in [from * (1.0 + 1e-6), (from + to) / 2.0, to * (1.0 - 1e-6)] {
                    let meeting = case.oracle.meet(at, h);
                    assert_eq!(meeting.first, Some(edge(&row["edge"])), "{}, edge {at} at {h}", case.name);
                    assert!(matches!(meeting.action, PinAction::Repeat | PinAction::Pass), "{}, edge {at}", case.name);
                }
            }
            let all = list(&orientation["intervals"]).iter();
            let topples = all.filter(|i| matches!(action(&i["action"]), PinAction::Repeat | PinAction::Pass));
            let length: f64 = topples.map(|i| height(&i["to"]) - height(&i["from"])).sum();
            assert!((covered - length).abs() < 1e-9, "{}, edge {at}", case.name);
        }
    }
}

#[test]
fn it_sees_where_a_part_ducks_below_a_pin() {
    let mut seen = 0;
    for case in all() {
        for orientation in list(&case.expected["orientations"]) {
            let at = edge(&orientation["edge"]);
            let ends: Vec<f64> = optional(&orientation["repeat_over_dip"]).iter().map(height).collect();
            let dips: Vec<[f64; 2]> = ends.chunks(2).map(|ends| [ends[0], ends[1]]).collect();
            for h in (1..1000).map(|step| case.oracle.height(at) * f64::from(step) / 1000.0) {
                let meeting = case.oracle.meet(at, h);
                // the list holds heights that jam as well
                if meeting.action == PinAction::Repeat {
                    let listed = dips.iter().any(|[from, to]| *from < h && h < *to);
                    assert_eq!(meeting.ducks, listed, "{}, edge {at} at {h}", case.name);
                    seen += usize::from(listed);
                }
            }
        }
    }
    assert!(seen > 0);
}

#[test]
fn it_answers_the_queries() {
    for case in all() {
        for query in list(&case.expected["queries"]) {
            let h = to_f64(&number(&query["height"]));
            let critical: Vec<usize> = optional(&query["critical_for"]).iter().map(edge).collect();
            for at in case.oracle.stable.iter().filter(|at| !critical.contains(at)) {
                let place = format!("{}, edge {at} at {h}", case.name);
                let key = at.to_string();
                assert_eq!(case.oracle.action(*at, h), Some(action(&query["actions"][&key])), "{place}");
                let outcome = &query["outcomes"][&key];
                // on the way the height may be critical for another edge
                if let Some(ours) = case.oracle.outcome(*at, h) {
                    assert_eq!(ours, (!outcome.is_null()).then(|| edge(outcome)), "{place}");
                } else {
                    assert!(!critical.is_empty(), "{place}");
                }
            }
        }
    }
}
