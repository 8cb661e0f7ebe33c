//! The throw map, `cargo bench --bench throw`: throws a second on one core, the cost of throws of intervals of radii beside
//! that, the proof of a pattern, and settings of the arm on one and two threads.

use partplan::exact::{FloatInterval, Q, ratio};
use partplan::mechanics::throwing::{Body, Enclosing, RestingEdge, Settling, Thrown};
use partplan::model::{Part, Shape, Thrower};
use partplan::planner::{self, Sweep, ThrowQuestion};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let (part, thrower) = case("triangle_6_8_10");
    println!("| part | throws/s | sine and cosine in a throw's time | throw of an interval / throw | intervals/s |");
    println!("|---|---|---|---|---|");
    for name in ["triangle_6_8_10", "pentagon", "bracket_fit", "random_10"] {
        let (part, thrower) = case(name);
        maps(name, &part, &thrower);
    }
    plans();
    sweeps(&part, &thrower);
}

fn case(name: &str) -> (Part, Thrower) {
    let path = format!("{}/tests/throw/cases/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read(path).expect("a case");
    let case = partplan::case::read(&text, &partplan::case::Limits::default()).expect("a valid case");
    (case.part, case.thrower.expect("a section on throws"))
}

/// The fastest of a few runs (s).
fn seconds(mut run: impl FnMut()) -> f64 {
    let once = |run: &mut dyn FnMut()| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    (0..5).map(|_| once(&mut run)).fold(f64::INFINITY, f64::min)
}

/// Throws along an orbit of the pattern, and of intervals about its radii as narrow as cells of a proof.
fn maps(name: &str, part: &Part, thrower: &Thrower) {
    const COUNT: usize = 200_000;
    let Shape::Polygon(outline) = &part.shape else { unreachable!("a polygon") };
    let corners: Vec<[Q; 2]> = outline.hull().iter().map(|k| outline.vertices()[*k].clone()).collect();
    let rho2 = part.gyration2();
    let edges = RestingEdge::all(&corners, &part.center_of_mass, &rho2);
    let arm = [&thrower.offset, &thrower.gravity, &thrower.release_deg_per_s];
    let near: Body<f64> = Body::new(&corners, &part.center_of_mass, &rho2, &edges, arm);
    let exact: Body<FloatInterval> = Body::new(&corners, &part.center_of_mass, &rho2, &edges, arm);
    let enclosing = Enclosing::new(exact, near.clone());
    let answer = planner::throw(part, thrower, &ThrowQuestion::default(), &mut |_| true).expect("a part to throw");
    let start = answer.limit.sets[0].orbit[0];
    let next = |at: (usize, f64)| match near.throw(at.0, at.1, Settling::Full) {
        Thrown::Caught(catch) => (catch.edge, catch.radius),
        other => unreachable!("{other:?} in the pattern"),
    };
    let throw = seconds(|| {
        black_box((0..COUNT).fold(start, |at, _| next(at)));
    }) / COUNT as f64;
    let turn = seconds(|| {
        black_box((0..COUNT).fold(0.5, |x: f64, _| {
            let (sin, cos) = libm::sincos(black_box(x));
            0.25 + 0.5 * (sin + cos)
        }));
    }) / COUNT as f64;
    let orbit: Vec<(usize, f64)> = std::iter::successors(Some(start), |at| Some(next(*at))).take(COUNT / 20).collect();
    let half = answer.certificate.width.max(1e-4 * answer.part_radius) / 2.0;
    let interval = seconds(|| {
        for (edge, radius) in &orbit {
            let radii = FloatInterval::from_ends(radius - half, radius + half);
            black_box(enclosing.branches(*edge, radii, Settling::Full));
        }
    }) / orbit.len() as f64;
    println!("| {name} | {:.0} | {:.1} | {:.1} | {:.0} |", 1.0 / throw, throw / turn, interval / throw, 1.0 / interval);
}

fn plans() {
    println!("\n| part | cells | images | whole answer | of that up to the proof |");
    println!("|---|---|---|---|---|");
    for name in ["triangle_6_8_10", "pentagon", "bracket_fit", "random_10"] {
        let (part, thrower) = case(name);
        let mut proof = f64::INFINITY;
        let mut answer = None;
        let whole = seconds(|| {
            let start = Instant::now();
            let mut before = None;
            let mut watch = |progress: planner::ThrowProgress| {
                if progress.stage == planner::ThrowStage::Proof {
                    before.get_or_insert_with(|| start.elapsed().as_secs_f64());
                }
                true
            };
            answer = planner::throw(&part, &thrower, &ThrowQuestion::default(), &mut watch).ok();
            proof = proof.min(before.unwrap_or(f64::INFINITY));
        });
        let certificate = answer.expect("a part to throw").certificate;
        println!(
            "| {name} | {} | {} | {:.0} ms | {:.0} ms |",
            certificate.cells,
            certificate.images,
            1e3 * whole,
            1e3 * proof
        );
    }
}

fn sweeps(part: &Part, thrower: &Thrower) {
    let range = |from, to| [ratio(from, 2), ratio(to, 2)];
    let sweep = Sweep { offset: range(-2, 0), release: range(560, 660), grid: 12, margin: ratio(1, 100) };
    let question = ThrowQuestion { sweep: Some(sweep), starts: 1, ..ThrowQuestion::default() };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let run = || {
            let start = Instant::now();
            black_box(pool.install(|| planner::throw(part, thrower, &question, &mut |_| true))).expect("a part");
            start.elapsed().as_secs_f64()
        };
        (0..3).map(|_| run()).fold(f64::INFINITY, f64::min)
    };
    let [one, two] = [1, 2].map(with);
    println!("\n144 settings: {one:.2} s on one thread, {two:.2} s on two, {:.2} times as fast", one / two);
}
