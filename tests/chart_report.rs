//! Charts as files: what is written is read back, and drawings say what failed.

use partplan::answer::{Chart, ChartFamily, ChartMap, ChartPoint, ChartTile};
use partplan::report::{csv, html, json, markdown, svg, text};
use proptest::prelude::*;

fn point(method: &str, setting: &str, error: Option<f64>, failed: u64, time: f64) -> ChartPoint {
    ChartPoint {
        family: ChartFamily::Ladder,
        work: "box".to_owned(),
        method: method.to_owned(),
        setting: setting.to_owned(),
        error,
        failed,
        of: 10,
        time: [0.9 * time, time, 1.2 * time],
        command: None,
    }
}

fn ladder() -> Chart {
    Chart {
        conditions: vec![("run".to_owned(), "quick".to_owned()), ("seed".to_owned(), "7".to_owned())],
        points: vec![
            point("rigid", "16 steps", Some(5e-4), 0, 1e-5),
            point("rigid", "64 steps", Some(1e-5), 0, 4e-5),
            point("rigid", "512 steps", Some(1e-7), 0, 3e-4),
            point("frictionless", "16 steps", Some(1e-6), 3, 5e-6),
            point("auto", "tolerance 0.001: moreau at h = 1e-2", Some(2e-5), 0, 6e-5),
        ],
        ..Chart::default()
    }
}

/// 60 µs beside 40 µs for an error at most as large, and beside 10 µs within the tolerance; what failed is no rival.
#[test]
fn a_choice_is_compared_with_the_cheapest_rung() {
    let row =
        "| box | tolerance 0.001: moreau at h = 1e-2 | 0.00002 | 60 µs | 1.5 (rigid, 64 steps) | 6 (rigid, 16 steps) |";
    assert!(markdown::chart(&ladder()).contains(row), "{}", markdown::chart(&ladder()));
    assert!(html::chart(&ladder()).contains("<td>1.5 (rigid, 64 steps)</td><td>6 (rigid, 16 steps)</td>"));
    let told = text::chart(&ladder());
    assert!(told.contains("1.5 times the cheapest rung as accurate"), "{told}");
    assert!(
        told.contains("ladder      box: rigid (512 steps), 0.0000001 in 300 µs") || told.contains("1.0e-7 in 300 µs"),
        "{told}"
    );
}

#[test]
fn every_row_names_the_command_that_measures_it_again() {
    let rows = csv::chart(&ladder());
    assert!(rows.starts_with("# run: quick\n# seed: 7\nkind,family,work,"), "{rows}");
    assert!(rows.contains("plan chart --quick --seed 7 --only 'ladder/box/rigid/16 steps'"), "{rows}");
    assert_eq!(csv::quoted("it's"), r"'it'\''s'");
    let document = json::chart(&ladder());
    assert_eq!(
        document["result"]["points"][3]["command"],
        "plan chart --quick --seed 7 --only 'ladder/box/frictionless/16 steps'"
    );
    assert_eq!(document["result"]["points"].as_array().unwrap().len(), 5);
}

#[test]
fn bad_rows_are_refused_with_their_line() {
    let good = csv::chart(&ladder());
    let said = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        csv::read_chart(&good.replacen(from, to, 1)).unwrap_err().to_string()
    };
    assert!(said("5e-4", "-5e-4").starts_with("line 4: error is \"-5e-4\"; write a finite number, not negative"));
    assert!(said("5e-4", "inf").starts_with("line 4: error is \"inf\""));
    assert!(said(",0,10,", ",11,10,").starts_with("line 4: 11 of 10 runs failed"));
    assert!(
        said("point,ladder", "point,latter")
            .starts_with("line 4: there is no family \"latter\"; write one of stepping, ")
    );
    assert!(said("point,ladder", "dot,ladder").starts_with("line 4: the kind is \"dot\"; write point or tile"));
    assert!(said("kind,", "sort,").starts_with("line 3: these are not the columns of a chart"));
    assert!(said("# run: quick", "# run").starts_with("line 1: \"# run\" where a condition is needed"));
    assert!(said("1.2e-5", "1e-9").contains("the times are not in order"));
    assert!(csv::read_chart("").is_err());
    assert!(said("5e-4", "").starts_with("line 4: 10 runs did not fail and there is no error; write the error of"));
    assert_eq!(said("point,ladder,box,", "point,ladder,"), "line 4: the row has 15 fields; write 16");
}

/// Also below fields and commands with line breaks, below empty lines, and with the line ends of other systems.
#[test]
fn lines_are_counted_as_editors_do() {
    let mut chart = ladder();
    chart.points[0].method = "ri\ngid".to_owned();
    let bad = csv::chart(&chart).replacen("point,ladder,box,auto", "dot,ladder,box,auto", 1);
    for text in [bad.clone(), bad.replace("\npoint", "\n\n\npoint"), bad.replace("\ndot", "\n\ndot")] {
        for text in [text.clone(), text.replace('\n', "\r\n")] {
            let line = text.lines().position(|line| line.starts_with("dot,")).unwrap() + 1;
            let said = csv::read_chart(&text).unwrap_err().to_string();
            assert!(said.starts_with(&format!("line {line}: the kind is \"dot\"")), "{said} in {text}");
        }
    }
    assert_eq!(csv::read_chart(&format!("\u{feff}{}", csv::chart(&chart))), Ok(chart));
}

/// A choice without an answer is as accurate as nothing; what it fails in is told beside it.
#[test]
fn a_choice_that_fails_is_not_flattered() {
    let mut chart = ladder();
    (chart.points[4].error, chart.points[4].failed) = (None, 10);
    let row = "| box | tolerance 0.001: moreau at h = 1e-2 | no answer, 100 % fail | 60 µs | - | - |";
    assert!(markdown::chart(&chart).contains(row), "{}", markdown::chart(&chart));
    assert!(text::chart(&chart).contains("moreau at h = 1e-2: no answer"), "{}", text::chart(&chart));
    (chart.points[4].error, chart.points[4].failed) = (Some(2e-5), 3);
    assert!(markdown::chart(&chart).contains("| 0.00002, 30 % fail | 60 µs | 1.5 (rigid, 64 steps)"));
}

#[test]
fn names_do_not_end_cells_of_markdown() {
    let mut chart = ladder();
    for point in &mut chart.points {
        (point.family, point.work) = (ChartFamily::Cone, "a | b <i>\nc".to_owned());
    }
    let tables = markdown::chart(&chart);
    assert!(tables.contains(r"| a \| b &lt;i> c | 1.0e-7 in 300 µs"), "{tables}");
}

/// No method is missing in the legend, and no two look alike.
#[test]
fn every_method_has_its_own_mark() {
    let points = (0..25).map(|k| point(&format!("method {k}"), "x", Some(1e-3), 0, 1e-6)).collect();
    let figure = svg::chart(&Chart { points, ..Chart::default() }, ChartFamily::Ladder).unwrap();
    assert!((0..25).all(|k| figure.lines().any(|line| line == format!("method {k}"))), "{figure}");
}

/// Counts that no machine reaches, in a file that somebody wrote.
#[test]
fn counts_of_many_tiles_do_not_overflow() {
    let tile = |x: f64| {
        let (map, method) = (ChartMap::FrictionMass, "a".to_owned());
        ChartTile { map, method, x, y: 1.0, succeeded: u64::MAX, ambiguous: 0, failed: 0 }
    };
    let chart = Chart { tiles: vec![tile(0.1), tile(0.2)], ..Chart::default() };
    assert!(markdown::chart(&csv::read_chart(&csv::chart(&chart)).unwrap()).contains("| a | 100 % | 0 % | 0 % |"));
}

/// Shares of failures are told wherever there is an answer; no number is written as something else.
#[test]
fn drawings_of_anything_are_sound() {
    let charts = [
        Chart {
            points: vec![point("a", "x", Some(0.0), 0, 1e-6), point("b", "x", Some(0.0), 10, 1e-6)],
            ..Chart::default()
        },
        Chart { points: vec![point("a", "x", None, 10, 1e-6)], ..Chart::default() },
        Chart { points: vec![point("a", "x", Some(f64::NAN), 0, f64::INFINITY)], ..Chart::default() },
        Chart {
            points: vec![point("a", "x", Some(1e-300), 0, 1e-300), point("a", "y", Some(1e300), 1, 1e300)],
            ..Chart::default()
        },
        Chart {
            points: vec![point("a", "x", Some(1.0), 0, 0.0), point("<&>\"'", "<b>", Some(1.0), 4, 0.0)],
            ..Chart::default()
        },
        ladder(),
    ];
    for chart in charts {
        let figure = svg::chart(&chart, ChartFamily::Ladder).unwrap();
        assert!(!figure.contains("NaN") && !figure.contains("inf"), "{figure}");
        for point in chart.points.iter().filter(|point| point.failed > 0 && point.error.is_some()) {
            assert!(figure.contains(&format!("{} % fail", 10 * point.failed)), "{figure}");
        }
        let is_finite = |point: &ChartPoint| point.error.is_some_and(f64::is_finite);
        assert_eq!(figure.contains("no answer"), !chart.points.iter().all(is_finite), "{figure}");
        assert!(!html::chart(&chart).contains("<b>"));
        assert!(
            svg::chart(&chart, ChartFamily::Cone).is_none() && svg::failures(&chart, ChartMap::FrictionMass).is_none()
        );
    }
}

#[test]
fn tiles_show_shares_and_signs() {
    let tile = |x: f64, [succeeded, ambiguous, failed]: [u64; 3]| {
        let map = ChartMap::FrictionMass;
        ChartTile { map, method: "a".to_owned(), x, y: 1.0, succeeded, ambiguous, failed }
    };
    let tiles = vec![tile(0.0, [4, 0, 0]), tile(0.1, [0, 4, 0]), tile(0.2, [0, 0, 4]), tile(0.5, [1, 0, 3])];
    let figure = svg::failures(&Chart { tiles, ..Chart::default() }, ChartMap::FrictionMass).unwrap();
    for word in ["?", "×", "25 %, else ×"] {
        assert_eq!(figure.lines().filter(|line| *line == word).count(), 1, "{word} in {figure}");
    }
}

fn any_point() -> impl Strategy<Value = ChartPoint> {
    let number = || prop_oneof![Just(0.0), 1e-300..1e300_f64, 0.0..1.0_f64];
    let word = || "[ -~µ]{0,12}";
    let numbers = (proptest::option::of(number()), 0..100_u64, 0..100_u64, [number(), number(), number()]);
    (0..ChartFamily::ALL.len(), word(), word(), word(), numbers).prop_map(|(family, work, method, setting, numbers)| {
        let (error, failed, mut more, mut time) = numbers;
        if error.is_none() {
            more = 0;
        }
        time.sort_by(f64::total_cmp);
        let command = (failed > 50).then(|| "other --program".to_owned());
        ChartPoint {
            family: ChartFamily::ALL[family],
            work,
            method,
            setting,
            error,
            failed,
            of: failed + more,
            time,
            command,
        }
    })
}

fn any_tile() -> impl Strategy<Value = ChartTile> {
    let counts = [0..9_u64, 0..9, 0..9];
    (0..ChartMap::ALL.len(), "[ -~]{0,9}", -1e9..1e9_f64, 0.0..1.0_f64, counts).prop_map(
        |(map, method, x, y, counts)| {
            let [succeeded, ambiguous, failed] = counts;
            ChartTile { map: ChartMap::ALL[map], method, x, y, succeeded, ambiguous, failed }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read_back(
        points in proptest::collection::vec(any_point(), 0..6),
        tiles in proptest::collection::vec(any_tile(), 0..6),
    ) {
        let conditions = [("seed", "1: 2"), ("cases", "'a\\n\\\nb\r'"), ("# empty", "")];
        let conditions = conditions.map(|(name, value)| (name.to_owned(), value.to_owned())).to_vec();
        let chart = Chart { conditions, points, tiles, limit: None };
        prop_assert_eq!(csv::read_chart(&csv::chart(&chart)), Ok(chart));
    }
}

/// The charts of README, its tables and its numbers are those of one file.
#[test]
fn readme_shows_what_was_measured() {
    let numbers = include_str!("../cases/chart/chart.csv");
    let chart = csv::read_chart(numbers).unwrap();
    assert_eq!(csv::chart(&chart), numbers);
    let readme = include_str!("../README.md");
    assert!(readme.contains(&markdown::chart(&chart)), "write README again from cases/chart/chart.md");
    let folder = format!("{}/cases/chart", env!("CARGO_MANIFEST_DIR"));
    let families = ChartFamily::ALL.map(|family| (family.name(), svg::chart(&chart, family)));
    let maps = ChartMap::ALL.map(|map| (map.name(), svg::failures(&chart, map)));
    for (name, figure) in families.into_iter().chain(maps) {
        let shown = std::fs::read_to_string(format!("{folder}/{name}.svg")).unwrap();
        assert!(Some(shown) == figure, "draw cases/chart/{name}.svg again: plan chart --from cases/chart/chart.csv");
    }
}
