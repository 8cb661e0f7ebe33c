//! Toppling graphs and pin sequences, `cargo bench --bench pins`: the time against the number of corners, how signs were
//! decided, and what doubles alone would get wrong.

use partplan::exact::{Q, Z, from_float_exact, ratio};
use partplan::geometry::Polygon;
use partplan::mechanics::toppling::{Signs, Toppled};
use partplan::model::{Conveyor, LengthUnit, Part, Range, Shape};
use partplan::planner::{PinQuestion, pins};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    graphs();
    sequences();
    doubles();
}

/// The fastest of a few runs, in milliseconds.
fn milliseconds(mut run: impl FnMut()) -> f64 {
    let once = |run: &mut dyn FnMut()| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..5).map(|_| once(&mut run)).fold(f64::INFINITY, f64::min)
}

fn graphs() {
    println!("| corners | stable edges | critical heights | time | decided by doubles |");
    println!("|---|---|---|---|---|");
    let mut points = Vec::new();
    for n in [5, 10, 20, 50, 100, 200] {
        let (part, conveyor) = (ellipse(n), conveyor(ratio(4, 3), ratio(7, 80)));
        let answer = pins(&part, &conveyor, &PinQuestion::default()).expect("a polygon");
        let time = milliseconds(|| {
            black_box(pins(&part, &conveyor, &PinQuestion::default())).expect("a polygon");
        });
        let heights: usize = answer.orientations.iter().map(|orientation| orientation.intervals.len()).sum();
        let decided = answer.decisions.filtered as f64 / (answer.decisions.filtered + answer.decisions.exact) as f64;
        println!("| {n} | {} | {heights} | {time:.0} ms | {:.1} % |", answer.stable.len(), 100.0 * decided);
        points.push((f64::from(n as u32).ln(), (time / answer.stable.len() as f64).ln()));
    }
    println!("\nthe time for one stable edge grows as the number of corners to the power {:.2}", slope(&points));
}

/// Of the line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let [x, y] = [points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n];
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    covariance / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

fn sequences() {
    println!("\n| case | pins | sets | time |\n|---|---|---|---|");
    for name in ["three_pins", "pentagon", "hexagon_order_2", "paper_fit_free_friction"] {
        let path = format!("{}/tests/topple/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read(path).expect("a case");
        let case = partplan::case::read(&text, &partplan::case::Limits::default()).expect("a valid case");
        let conveyor = case.conveyor.expect("a section on pins");
        let answer = pins(&case.part, &conveyor, &PinQuestion::default()).expect("a polygon");
        let time = milliseconds(|| {
            black_box(pins(&case.part, &conveyor, &PinQuestion::default())).expect("a polygon");
        });
        let count = answer.plan.sequence.map_or("none".to_owned(), |sequence| sequence.len().to_string());
        println!("| {name} | {count} | {} | {time:.0} ms |", answer.plan.searched.reachable_sets);
    }
}

/// Decisions whether a pin is above or below critical heights, exactly and by comparison with the nearest double.
fn doubles() {
    let (part, conveyor) = (ellipse(12), conveyor(ratio(4, 3), ratio(7, 80)));
    let answer = pins(&part, &conveyor, &PinQuestion::default()).expect("a polygon");
    let ends = answer.orientations.iter().flat_map(|orientation| orientation.intervals.iter().map(|i| &i.from));
    let mut ends: Vec<_> = ends.filter(|end| end.to_f64() > 0.0).cloned().collect();
    ends.iter_mut().for_each(|end| end.refine(&Q::new(Z::from(1), Z::from(1) << 200)));
    let signs = Signs::default();
    let Shape::Polygon(outline) = &part.shape else { unreachable!("an ellipse has corners") };
    let toppled = Toppled {
        corners: outline.vertices(),
        center_of_mass: &part.center_of_mass,
        belt_friction: &conveyor.belt_friction.min,
        pin_friction: [&conveyor.pin_friction.min; 2],
    };
    // what doubles know: heights near those found, off by what rounding leaves
    let near: Vec<f64> = answer.stable.iter().flat_map(|edge| near(&toppled, *edge, &signs)).collect();
    let mut state = 1_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 33
    };
    const DECISIONS: usize = 1_000_000;
    let (mut wrong, mut exact_time, mut double_time) = (0, 0.0, 0.0);
    for _ in 0..DECISIONS / 1000 {
        let end = &ends[random() as usize % ends.len()];
        let nearest = end.to_f64();
        let closest = near.iter().copied().min_by(|a, b| (a - nearest).abs().total_cmp(&(b - nearest).abs()));
        let known = closest.unwrap_or(nearest);
        let heights: Vec<f64> = (0..1000)
            .map(|_| {
                let steps = random() as i64 % 17 - 8;
                f64::from_bits(nearest.to_bits().wrapping_add_signed(steps))
            })
            .collect();
        let start = Instant::now();
        let exact: Vec<bool> =
            heights.iter().map(|height| *end < from_float_exact(*height).expect("a finite height")).collect();
        exact_time += start.elapsed().as_secs_f64();
        let start = Instant::now();
        let doubles: Vec<bool> = heights.iter().map(|height| known < *height).collect();
        double_time += start.elapsed().as_secs_f64();
        wrong += exact.iter().zip(&doubles).filter(|(exact, double)| exact != double).count();
    }
    println!("\nof {DECISIONS} heights within 8 doubles of a critical one doubles put {wrong} on the wrong side");
    println!(
        "exact comparisons take {:.2} µs each, those of doubles {:.4} µs",
        exact_time * 1e6 / DECISIONS as f64,
        double_time * 1e6 / DECISIONS as f64
    );
}

/// Ends of jams as doubles compute them.
fn near(toppled: &Toppled, edge: usize, signs: &Signs) -> Vec<f64> {
    let turn = toppled.turn(edge, false, signs);
    let jams = turn.rolling_jams.iter().chain(&turn.settling_jams).flatten();
    jams.chain(&turn.heights).map(partplan::mechanics::toppling::Height::near).collect()
}

fn conveyor(belt: Q, pin: Q) -> Conveyor {
    Conveyor { belt_friction: Range::exactly(belt), pin_friction: Range::exactly(pin) }
}

/// Corners on an ellipse, not quite regular, with six decimals.
fn ellipse(n: usize) -> Part {
    let corner = |index: usize| {
        let share = (index as f64 + 0.37 * (index * index % 7) as f64 / 7.0) / n as f64;
        let (sin, cos) = (std::f64::consts::TAU * share).sin_cos();
        [13.0 * cos, 10.0 * sin].map(|x| ratio((x * 1e6).round() as i64, 1_000_000))
    };
    let outline = Polygon::new((0..n).map(corner).collect()).expect("a convex outline");
    Part {
        unit: LengthUnit::Metre,
        shape: Shape::Polygon(outline),
        center_of_mass: [ratio(3, 10), ratio(-1, 5)],
        center_of_mass_tolerance: ratio(0, 1),
        mass: ratio(1, 1),
        inertia: ratio(1, 1),
    }
}
