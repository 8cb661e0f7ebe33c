//! Devices designed through dynamics: the published feeder, what a case may say, and searches.

use partplan::answer::{EntryFate, FeederDesign, FeederPlan};
use partplan::case::{FeederCase, Limits, read_feeder};
use partplan::design::{Journal, Score, SearchOptions, design, evaluated, robustness};
use partplan::dynamics::ModelKind;
use partplan::model::Feeder;
use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn feeder() -> Feeder {
    let path = format!("{}/cases/feeder.json", env!("CARGO_MANIFEST_DIR"));
    let FeederCase { feeder, .. } = read_feeder(&std::fs::read(path).unwrap(), &Limits::default()).unwrap();
    feeder
}

/// The known good design, rounded.
const GOOD: [f64; 12] = [0.04, 0.03, 0.021, 0.08, -0.049, -0.026, 0.0525, 0.023, 0.093, 0.005, 0.56, 0.3];

fn at(feeder: &Feeder, variables: &[f64], step: f64) -> FeederDesign {
    evaluated(feeder, variables, &feeder.nominal(), ModelKind::StewartTrinkle, Some(step))
}

/// Costs, times and places of an independent program, at its step and at half of it.
#[test]
fn the_first_design_gets_stuck_and_the_known_one_passes() {
    let feeder = feeder();
    for (step, stuck, passed) in [(1e-3, 14.788_279, 0.932_125), (5e-4, 14.793_413, 0.932_091)] {
        let first = at(&feeder, &feeder.start(), step);
        assert!((first.cost - stuck).abs() < 0.03, "{first:?}");
        assert!(first.runs.iter().all(|run| run.fate == EntryFate::Rests), "{first:?}");
        assert!((first.runs[0].time - 0.371).abs() < 0.015 && (first.runs[1].time - 0.274).abs() < 0.015, "{first:?}");
        let good = at(&feeder, &GOOD, step);
        assert!(good.passes() && (good.cost - passed).abs() < 0.03, "{good:?}");
        assert!((good.runs[0].time - 0.473).abs() < 0.015 && (good.runs[1].time - 0.428).abs() < 0.015, "{good:?}");
    }
}

/// What the drawing measures is the variable it names.
#[test]
fn dimensions_are_drawn_where_they_are() {
    let feeder = feeder();
    for variables in [feeder.start(), GOOD.to_vec()] {
        let dimensions = feeder.device.dimensions(&variables, &feeder.nominal());
        assert_eq!(dimensions.len(), variables.len());
        for (variable, value) in feeder.variables.iter().zip(&variables) {
            let dimension = dimensions.iter().find(|dimension| dimension.name == variable.name).unwrap();
            let [a, b] = dimension.ends;
            let measured = match dimension.corner {
                None => (b[0] - a[0]).hypot(b[1] - a[1]),
                Some(corner) => {
                    let [a, b] = [a, b].map(|end| (end[1] - corner[1]).atan2(end[0] - corner[0]));
                    (a - b).abs()
                }
            };
            assert!((measured - value.abs()).abs() < 1e-6, "{dimension:?} of {value}");
        }
    }
}

/// Scores in memory; ends a search after so many new ones.
struct Memory {
    known: Mutex<HashMap<Vec<u64>, Score>>,
    most_new: usize,
    new: AtomicUsize,
}

impl Memory {
    fn new(known: HashMap<Vec<u64>, Score>, most_new: usize) -> Self {
        Self { known: Mutex::new(known), most_new, new: AtomicUsize::new(0) }
    }
}

fn bits(variables: &[f64]) -> Vec<u64> {
    variables.iter().map(|value| value.to_bits()).collect()
}

impl Journal for Memory {
    fn known(&self, variables: &[f64]) -> Option<Score> {
        self.known.lock().unwrap().get(&bits(variables)).copied()
    }

    fn add(&self, variables: &[f64], score: Score, _: usize) -> bool {
        let is_new = self.known.lock().unwrap().insert(bits(variables), score).is_none();
        self.new.fetch_add(usize::from(is_new), Ordering::Relaxed) < self.most_new
    }
}

fn searched(feeder: &Feeder, options: &SearchOptions, jobs: usize, journal: &Memory) -> FeederPlan {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build().unwrap();
    pool.install(|| design(feeder, options, journal))
}

const SHORT: SearchOptions = SearchOptions { evaluations: 120, seed: 5, worst: false, draws: 0 };

/// Bit by bit, on any number of threads, and after a kill: what was known is not run again.
#[test]
fn a_search_is_repeated_by_its_seed_and_gone_on_with() {
    let feeder = feeder();
    let whole = searched(&feeder, &SHORT, 1, &Memory::new(HashMap::new(), usize::MAX));
    assert_eq!(whole, searched(&feeder, &SHORT, 2, &Memory::new(HashMap::new(), usize::MAX)));
    let other = SearchOptions { seed: 6, ..SHORT };
    assert!(whole.trace != searched(&feeder, &other, 2, &Memory::new(HashMap::new(), usize::MAX)).trace);
    let killed = Memory::new(HashMap::new(), 50);
    let part = searched(&feeder, &SHORT, 2, &killed);
    assert!(part.trace.len() < whole.trace.len() && part.trace[..] == whole.trace[..part.trace.len()]);
    let known = killed.known.into_inner().unwrap();
    let n_known = known.len();
    let again = Memory::new(known, usize::MAX);
    assert_eq!(whole, searched(&feeder, &SHORT, 2, &again));
    assert_eq!(again.new.into_inner(), whole.trace.len() - n_known);
}

/// From a device that gets stuck; the design is confirmed here once more, at steps that the search did not take.
#[test]
fn a_search_finds_a_design_that_passes_at_every_step() {
    let feeder = feeder();
    let options = SearchOptions { evaluations: 300, ..SHORT };
    let found = searched(&feeder, &options, 2, &Memory::new(HashMap::new(), usize::MAX));
    let best = found.best.expect("a design that passes");
    assert!(!found.start.passes() && best.passes() && best.cost < 1.5, "{best:?}");
    for variable in feeder.variables.iter().zip(&best.variables) {
        assert!((variable.0.low..=variable.0.high).contains(variable.1), "{variable:?}");
    }
    for step in [1e-3, 7e-4, 3e-4, 1e-4] {
        assert!(at(&feeder, &best.variables, step).passes(), "{step}");
    }
    assert_eq!(found.checks.iter().map(|check| check.model).collect::<Vec<_>>(), ["st", "st", "spk"]);
    assert!(found.checks.iter().all(|check| check.design.passes()));
}

/// A ball over a slot, with more that is fixed.
fn slot(variables: &str, fixed: &str) -> String {
    format!(
        r#"{{"feeder": {{
            "variables": {{{variables}}},
            "uncertain": {{"radius": {{"value": 0.01, "off": 0.001}}}},
            "let": {{"half": "gap/2"}},
            "entries": [{{"name": "drop", "pose": ["radius/4", "2*radius", 0]}}],
            "goal": {{"pose": [0, -0.1, 0], "within": [0.02, 7]}},
            "scene": {{
                "duration": 1, "step": 1e-3, "friction": 0.1,
                "bodies": [{{"name": "ball", "mass": 0.1, "shape": {{"circle": {{"center": [0, 0], "radius": "radius"}}}}}}],
                "fixed": [
                    {{"name": "left", "shape": {{"polygon": [[-0.1, -0.05], ["-half", -0.05], ["-half", 0], [-0.1, 0]]}}}},
                    {{"name": "right", "shape": {{"polygon": [["half", -0.05], [0.1, -0.05], [0.1, 0], ["half", 0]]}}}}{fixed}
                ]
            }}
        }}}}"#
    )
}

const GAP: &str = r#""gap": {"min": 0.01, "max": 0.06, "start": 0.015}"#;

fn read_slot(variables: &str, fixed: &str) -> Result<Feeder, Vec<(&'static str, String)>> {
    match read_feeder(slot(variables, fixed).as_bytes(), &Limits::default()) {
        Ok(case) => Ok(case.feeder),
        Err(faults) => Err(faults.iter().map(|fault| (fault.code(), fault.path().to_owned())).collect()),
    }
}

/// A ball of radius 10 mm needs a slot of 20 mm: known without any of this.
#[test]
fn a_slot_must_be_wider_than_the_ball() {
    let feeder = read_slot(GAP, "").unwrap();
    assert_eq!(at(&feeder, &[0.0199], 1e-3).runs[0].fate, EntryFate::Rests);
    assert_eq!(at(&feeder, &[0.0205], 1e-3).runs[0].fate, EntryFate::Passes);
    let options = SearchOptions { evaluations: 60, seed: 1, worst: true, draws: 2 };
    let found = searched(&feeder, &options, 2, &Memory::new(HashMap::new(), usize::MAX));
    let best = found.best.expect("a wider slot");
    let robust = robustness(&feeder, &best.variables, 1, 50, &|| true).unwrap();
    let [low, high] = robust.tolerances[0];
    assert!((0.02..0.0205).contains(&low) && high > best.variables[0], "{robust:?}");
    assert_eq!(robust.passed, [50, 50], "{best:?}");
    let tight = robustness(&feeder, &[0.0201], 1, 200, &|| true).unwrap();
    assert!((80..=120).contains(&tight.passed[0]), "{tight:?}");
}

/// Something is there only while an expression is positive.
#[test]
fn a_bar_over_the_slot_is_there_only_while_it_is_long() {
    let bar = r#", {"name": "bar", "only_if_positive": "bar - 0.001", "shape": {"polygon": [["-bar", -0.02], ["bar", -0.02], ["bar", -0.01], ["-bar", -0.01]]}}"#;
    let feeder = read_slot(&format!(r#"{GAP}, "bar": {{"min": 0, "max": 0.05, "start": 0.02}}"#), bar).unwrap();
    let fixed = |bar: f64| feeder.device.scenes(&[0.04, bar], &feeder.nominal()).unwrap()[0].fixed.len();
    assert_eq!((fixed(0.02), fixed(0.0)), (3, 2));
    assert_eq!(at(&feeder, &[0.04, 0.02], 1e-3).runs[0].fate, EntryFate::Rests);
    assert_eq!(at(&feeder, &[0.04, 0.0], 1e-3).runs[0].fate, EntryFate::Passes);
}

#[test]
fn what_is_wrong_with_a_device_is_said_where_it_is() {
    let codes = |variables: &str, fixed: &str| read_slot(variables, fixed).unwrap_err();
    let post = |shape: &str| format!(r#", {{"name": "post", "shape": {shape}}}"#);
    let circle = |radius: &str| post(&format!(r#"{{"circle": {{"center": [0, 0], "radius": {radius}}}}}"#));
    let radius = "feeder.scene.fixed[2].shape.circle.radius";
    let cases = [
        (codes(GAP, &circle("\"gap +\"")), "C086", radius),
        (codes(GAP, &circle("\"gpa\"")), "C087", radius),
        (codes(GAP, &circle("\"1/(gap - 0.015)\"")), "C089", radius),
        (codes(GAP, &circle("\"gap - 0.02\"")), "C022", radius),
        (codes(r#""max": {"min": 0, "max": 1, "start": 0.5}"#, ""), "C088", "feeder.variables.max"),
        (codes(r#""2b": {"min": 0, "max": 1, "start": 0.5}"#, ""), "C088", "feeder.variables.2b"),
        (codes(r#""gap": {"min": 0, "max": 1, "start": 2}"#, ""), "C024", "feeder.variables.gap"),
        (codes(r#""gap": {"min": 0, "max": 1}"#, ""), "C014", "feeder.variables.gap.start"),
        (
            codes(&format!(r#"{GAP}, "radius": {{"min": 0, "max": 1, "start": 0.5}}"#), ""),
            "C073",
            "feeder.uncertain.radius",
        ),
        (codes("", ""), "C012", "feeder.variables"),
        (
            codes(GAP, &post(r#"{"polygon": [[0, 0], ["gap", "gap"], ["gap", 0], [0, "gap"]]}"#)),
            "C034",
            "feeder.scene.fixed[2].shape.polygon",
        ),
        (
            codes(GAP, r#", {"only_if_positive": true, "shape": {"circle": {"center": [0, 0], "radius": 1}}}"#),
            "C011",
            "feeder.scene.fixed[2].only_if_positive",
        ),
    ];
    for (index, (found, code, path)) in cases.iter().enumerate() {
        assert!(found.iter().any(|(c, p)| c == code && p.starts_with(path)), "{index}: {code} {path}, but {found:?}");
    }
    let drawn = |dimension: &str| {
        let text = slot(GAP, "").replacen("\"scene\"", &format!("\"dimensions\": [{dimension}], \"scene\""), 1);
        let faults = read_feeder(text.as_bytes(), &Limits::default()).unwrap_err();
        faults.iter().map(|fault| format!("{} {}", fault.code(), fault.path())).collect::<Vec<_>>()
    };
    let path = "feeder.dimensions[0]";
    assert_eq!(drawn(r#"{"of": "gap", "from": [0, 0], "to": ["gpa", 0]}"#), [format!("C087 {path}.to[0]")]);
    assert_eq!(drawn(r#"{"of": "gap", "from": [0, 0, 0], "to": ["gap", 0]}"#), [format!("C012 {path}.from")]);
    assert_eq!(drawn(r#"{"of": "gap", "to": ["gap", 0]}"#), [format!("C014 {path}.from")]);
    let spatial = r#"{"feeder": {"variables": {"a": {"min": 0, "max": 1, "start": 0}}, "entries": [{"pose": [0, 0, 1, 1, 0, 0, 0]}],
        "goal": {"pose": [0, 0, 0]}, "scene": {"dimension": 3, "duration": 1, "friction": 0, "bodies": [{"mass": 1, "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}]}}}"#;
    assert!(read_feeder(spatial.as_bytes(), &Limits::default()).is_err());
    assert!(read_feeder(b"{}", &Limits::default()).is_err());
}
