//! Throws in time, and the page that plays them.

use super::expected;
use partplan::answer::Throw;
use partplan::model::{Part, Thrower};
use partplan::planner::{self, ThrowQuestion};
use partplan::report::{self, Toss};
use serde_json::Value;

fn replayed(name: &str) -> (Part, Thrower, Throw) {
    let case = expected::of(name);
    let (part, thrower) = (case.part(), case.thrower());
    let question = ThrowQuestion { replay: true, ..ThrowQuestion::default() };
    let answer = planner::throw(&part, &thrower, &question, &mut |_| true).unwrap();
    (part, thrower, answer)
}

#[test]
fn a_replay_goes_from_rest_to_rest_without_jumps() {
    for name in ["triangle_6_8_10", "rectangle", "clockwise_mm"] {
        let (_, thrower, answer) = replayed(name);
        let (set, poses) = (&answer.limit.sets[0], &answer.replay);
        let offset = partplan::exact::to_f64(&thrower.offset);
        let height = |edge: usize| offset + answer.edges[edge].d.to_f64();
        assert!(poses.last().unwrap().throw > 3, "{name}");
        for pair in poses.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            assert!(b.time >= a.time && b.throw <= a.throw + 1, "{name}");
            // two moments of a flight or swing are less than 0.03 / w apart
            let moved = (b.x - a.x).hypot(b.y - a.y);
            assert!(moved < 0.15 * answer.part_radius.max(a.x), "{name}: {a:?} {b:?}");
            if b.throw > a.throw {
                let (edge, radius) = set.orbit[b.throw];
                let near = |found: f64, wanted: f64| (found - wanted).abs() < 1e-2 * answer.part_radius;
                assert!(
                    near(a.x, radius) && near(a.y, height(edge)),
                    "{name}: {a:?} is not at {radius} on edge {edge}"
                );
                // it is thrown from where it came to rest, whole turns apart
                let turn = (b.angle - a.angle) / std::f64::consts::TAU;
                assert!(near(b.x, radius) && (turn - turn.round()).abs() < 1e-2, "{name}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn the_page_plays_the_replay() {
    let (part, thrower, answer) = replayed("triangle_6_8_10");
    let toss = Toss { name: "a </script> b", part: &part, thrower: &thrower, warnings: &[], settles_first: false };
    let page = report::html::throw(&toss, &answer);
    assert_eq!(page.matches("</script>").count(), 2);
    let (_, rest) = page.split_once("<script type=\"application/json\" id=\"run\">").unwrap();
    let data: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    for key in ["times", "poses"] {
        assert_eq!(data[key].as_array().map(Vec::len), Some(answer.replay.len()), "{key}");
    }
    assert_eq!(data["graph"]["unit"], "cm");
    assert_eq!(data["events"].as_array().map(Vec::len), answer.replay.last().map(|pose| pose.throw + 1));
    assert_eq!(data["fixed"].as_array().map(Vec::len), Some(3), "arm, pivot and sensor");
    let page = report::html::throw(&toss, &Throw { replay: Vec::new(), ..answer });
    assert!(page.contains("\"times\":[]"));
}
