//! Mode cones, feasible modes and whole plans. Run `cargo bench`.
//!
//! Contacts lie on a polygon of 50 edges with integer vertices, those of `feasible` in a fan with many modes. The group `paper_route` runs the same modes by the
//! paper's construction, a conversion in up to 2n dimensions, so that each figure has its yardstick in the same run.

use divan::{Bencher, black_box};
use partplan::cone::Pair;
use partplan::cone::format::read;
use partplan::exact::{Int, Ladder, Long, Matrix, Overflow, Q, Rung, Z, climb, primitive_row, ratio, to_f64};
use partplan::geometry::Polygon;
use partplan::mechanics::{Contact, ContactRows, Interaction, Mode, feasible_modes, mode_cone};
use partplan::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};
use partplan::planner::{Question, insertion, stability};
use std::any::Any;

#[path = "../tests/support/mod.rs"]
mod support;

fn main() {
    divan::main();
}

#[divan::bench(args = [1, 2, 3, 4, 5, 6, 50])]
fn mode_cones(bencher: Bencher, n: usize) {
    let contacts = contacts(n);
    let modes = modes(n);
    let mut next = modes.iter().cycle();
    bencher.bench_local(|| mode_cone(&contacts, black_box(next.next().unwrap()), true));
}

/// The first half of the paper's method for the same modes: K^F, the face normals of the span of K.
#[divan::bench(args = [1, 2, 3, 4, 5, 6])]
fn paper_route(bencher: Bencher, n: usize) {
    let (part, fixture) = ring(n);
    let contacts = support::modes::Contacts::of(&part, &fixture);
    let spans: Vec<KSpan> = modes(n).iter().map(|mode| KSpan::of(&contacts, &Mode(mode.clone()).to_string())).collect();
    let mut next = spans.iter().cycle();
    bencher.bench_local(|| climb(black_box(next.next().unwrap()), Rung::Word));
}

/// Mode cones of contacts with measured places and normals, whose rows fit no word, on the rung that holds them.
#[divan::bench(args = [3, 6])]
fn mode_cones_of_long_numbers(bencher: Bencher, n: usize) {
    let (part, fixture) = measured(n);
    let contacts = Contact::of(&part, &fixture);
    let jobs: Vec<ModeCone> = modes(n).into_iter().map(|mode| ModeCone::of(&contacts, mode)).collect();
    let mut next = jobs.iter().cycle();
    bencher.bench_local(|| climb(black_box(next.next().unwrap()), Rung::Word));
}

/// All modes of three contacts with the letters of strong stability, feasible or not.
#[divan::bench]
fn all_modes_of_three(bencher: Bencher) {
    let contacts = contacts(3);
    let letters = [Interaction::Separate, Interaction::SlideLeft, Interaction::SlideRight, Interaction::Roll];
    let mode = |code: usize| (0..3).map(|place| letters[code >> (2 * place) & 3]).collect::<Vec<_>>();
    let modes: Vec<_> = (0..64).map(mode).collect();
    bencher.bench_local(|| {
        modes.iter().filter(|mode| mode_cone(&contacts, black_box(mode), true).is_ok_and(|cone| cone.is_some())).count()
    });
}

const SPANS: [&str; 3] = ["w3g_n3_m_poly", "w3g_n5_m_big", "fan3_k128_b24"];

/// Cones in three dimensions from their rays: friction cones and a fan.
#[divan::bench(args = SPANS)]
fn spans(bencher: Bencher, name: &str) {
    let rays = Matrix::from_rows(3, span(name));
    bencher.bench_local(|| Pair::from_rays(black_box(rays.clone())));
}

/// The same rays with a fourth coordinate that is zero, which the method for any dimension converts.
#[divan::bench(args = SPANS)]
fn spans_in_four_dimensions(bencher: Bencher, name: &str) {
    let rows = span(name).into_iter().map(|mut row| {
        row.push(0);
        row
    });
    let rays = Matrix::from_rows(4, rows);
    bencher.bench_local(|| Pair::from_rays(black_box(rays.clone())));
}

/// Rays of a public file.
fn span(name: &str) -> Vec<Vec<i64>> {
    let path = format!("{}/tests/polyhedra/wrench3/{name}.ext", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read(path).expect("a readable file");
    let rays = read(&text).expect("a polyhedron").polyhedron;
    let row = |row: &Vec<Q>| primitive_row(&row[1..]).iter().map(|entry| i64::from_z(entry).expect("a word")).collect();
    rays.rows().iter().map(row).collect()
}

/// A mode and its contacts on every rung that holds them.
struct ModeCone {
    mode: Vec<Interaction>,
    word: Option<Vec<ContactRows<i64>>>,
    double: Option<Vec<ContactRows<i128>>>,
    big: Option<Vec<ContactRows<Long>>>,
}

impl ModeCone {
    fn of(contacts: &[Contact], mode: Vec<Interaction>) -> Self {
        Self { mode, word: on(contacts), double: on(contacts), big: on(contacts) }
    }
}

fn on<T: Int>(contacts: &[Contact]) -> Option<Vec<ContactRows<T>>> {
    contacts.iter().map(|contact| contact.on_rung().ok()).collect()
}

impl Ladder for ModeCone {
    type Output = bool;

    fn run<T: Int>(&self) -> Result<bool, Overflow> {
        let rungs: [&dyn Any; 3] = [&self.word, &self.double, &self.big];
        let contacts = rungs.into_iter().find_map(|contacts| contacts.downcast_ref::<Option<Vec<ContactRows<T>>>>());
        let contacts = contacts.and_then(Option::as_ref).ok_or(Overflow)?;
        Ok(black_box(mode_cone(contacts, &self.mode, true)?).is_some())
    }
}

#[divan::bench(args = [2, 3, 4, 6, 10, 20, 50])]
fn feasible(bencher: Bencher, n: usize) {
    let contacts = rows(&fan(n));
    bencher.bench_local(|| feasible_modes(black_box(&contacts)));
}

#[divan::bench]
fn insertion_of_three(bencher: Bencher) {
    let (part, fixture) = pawl();
    bencher.bench_local(|| insertion(black_box(&part), &fixture, &Question::default()));
}

#[divan::bench]
fn insertion_of_three_with_robust(bencher: Bencher) {
    let (part, fixture) = pawl();
    let question = Question { robust: true, ..Question::default() };
    bencher.bench_local(|| insertion(black_box(&part), &fixture, &question));
}

#[divan::bench]
fn insertion_of_three_with_critical_friction(bencher: Bencher) {
    let (part, fixture) = pawl();
    let question = Question { critical: true, ..Question::default() };
    bencher.bench_local(|| insertion(black_box(&part), &fixture, &question));
}

/// The same with the second fixel moved, so that no pair jams and the sets shrink to nothing.
#[divan::bench]
fn insertion_of_three_with_irrational_critical_friction(bencher: Bencher) {
    let (part, mut fixture) = pawl();
    fixture.fixels[1].point = [ratio(9, 2), ratio(9, 2)];
    fixture.fixels[1].normal = [ratio(-1, 1), ratio(-3, 1)];
    let question = Question { critical: true, ..Question::default() };
    bencher.bench_local(|| insertion(black_box(&part), &fixture, &question));
}

#[divan::bench]
fn stability_of_three(bencher: Bencher) {
    let (part, fixture) = pawl();
    bencher.bench_local(|| stability(black_box(&part), &fixture, &Question::default()));
}

/// The columns of K, eq. (15), each on its ray.
struct KSpan(Vec<Vec<Z>>);

impl KSpan {
    fn of(contacts: &support::modes::Contacts, mode: &str) -> Self {
        let k = support::paper::cone_form(contacts, mode, support::paper::SlidingSign::Table2).k;
        let mut columns: Vec<Vec<Z>> =
            k.column_iter().map(|column| primitive_row(&column.iter().cloned().collect::<Vec<_>>())).collect();
        if columns.is_empty() {
            columns.push(vec![Z::from(0); k.nrows()]);
        }
        Self(columns)
    }
}

impl Ladder for KSpan {
    type Output = usize;

    fn run<T: Int>(&self) -> Result<usize, Overflow> {
        let columns = self.0[0].len();
        let mut rays = Matrix::new(columns);
        for column in &self.0 {
            let row = column.iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)?;
            rays.push(&row);
        }
        Ok(Pair::from_rays(rays)?.facets().len())
    }
}

fn contacts(n: usize) -> Vec<ContactRows<i64>> {
    rows(&ring(n))
}

fn rows((part, fixture): &(Part, Fixture)) -> Vec<ContactRows<i64>> {
    Contact::of(part, fixture).iter().map(|contact| contact.on_rung().expect("the rows are short")).collect()
}

/// The modes that planning asks for, all of them non-empty: the feasible ones, and for few contacts those that add none
/// (`s` at one, `m` or `u` at the others).
fn modes(n: usize) -> Vec<Vec<Interaction>> {
    let contacts = contacts(n);
    let mut modes = feasible_modes(&contacts).expect("the rows are short");
    modes.push(vec![Interaction::Maintain; n]);
    if n <= 6 {
        for separating in 0..n {
            for maintained in (0..1_u32 << n).filter(|set| set >> separating & 1 == 0) {
                let letter = |contact: usize| match contact {
                    _ if contact == separating => Interaction::Separate,
                    _ if maintained >> contact & 1 == 1 => Interaction::Maintain,
                    _ => Interaction::Unconstrained,
                };
                modes.push((0..n).map(letter).collect());
            }
        }
    }
    modes.retain(|mode| mode_cone(&contacts, mode, true).is_ok_and(|cone| cone.is_some()));
    modes
}

/// `n` contacts spread over a polygon of 50 edges.
fn ring(n: usize) -> (Part, Fixture) {
    let corner = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / 50.0;
        [(1000.0 * angle.cos()).round() as i64, (1000.0 * angle.sin()).round() as i64]
    };
    let vertices = (0..50).map(|k| corner(k).map(|value| ratio(value, 1))).collect();
    let fixels = (0..n).map(|contact| {
        let k = contact * 50 / n;
        let (a, b) = (corner(k), corner(k + 1));
        let share = ratio(3 + contact as i64 % 5, 10);
        let at = |axis: usize| ratio(a[axis], 1) + ratio(b[axis] - a[axis], 1) * &share;
        let normal = [ratio(a[1] - b[1], 1), ratio(b[0] - a[0], 1)];
        fixel([at(0), at(1)], normal, ratio(1, 5))
    });
    let fixels = fixels.collect();
    (part(vertices, [ratio(13, 1), ratio(-7, 1)], ratio(498_000, 1)), Fixture { fixels })
}

/// The contacts of [`ring`] at places of 24 bits, with unit normals a little off the edges' own.
fn measured(n: usize) -> (Part, Fixture) {
    let (part, mut fixture) = ring(n);
    for (index, fixel) in fixture.fixels.iter_mut().enumerate() {
        let off = ratio(2 * index as i64 - 5, 8_191);
        fixel.point = fixel.point.clone().map(|value| ((value + &off) * ratio(16_384, 1)).round() / ratio(16_384, 1));
        // the half-angle's tangent to 12 bits gives a rational unit vector
        let [x, y] = fixel.normal.each_ref().map(to_f64);
        let half = (y.atan2(x) / 2.0).tan();
        let half = ratio((half * 4_093.0).round() as i64, 4_093);
        let square = &half * &half;
        let one = ratio(1, 1);
        fixel.normal = [(&one - &square) / (&one + &square), ratio(2, 1) * half / (&one + &square)];
    }
    (part, fixture)
}

/// `n` contacts of which each can be the only one to persist: their normals' wrenches span a cone over a circle, so
/// there are Θ(n) feasible modes.
fn fan(n: usize) -> (Part, Fixture) {
    let (part, _) = ring(1);
    let center = part.center_of_mass.clone();
    let contact = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / n as f64;
        let [slope, arm] = [angle.cos(), angle.sin()].map(|value| ratio((1000.0 * value).round() as i64, 1000));
        fixel([&center[0] + arm, center[1].clone()], [slope, ratio(1, 1)], ratio(1, 5))
    };
    let fixels = (0..n).map(contact).collect();
    (part, Fixture { fixels })
}

/// The pawl of the public case `n3_pawl_02`.
fn pawl() -> (Part, Fixture) {
    let outline = [(0, 0), (9, -2), (12, 0), (11, 3), (8, 2), (6, 4), (3, 5), (0, 4), (-1, 2)];
    let vertices = outline.map(|(x, y)| [ratio(x, 1), ratio(y, 1)]).to_vec();
    let fixels = vec![
        fixel([ratio(45, 4), ratio(-1, 2)], [ratio(-2, 1), ratio(3, 1)], ratio(1, 5)),
        fixel([ratio(13, 2), ratio(7, 2)], [ratio(-1, 1), ratio(-1, 1)], ratio(1, 5)),
        fixel([ratio(-3, 4), ratio(5, 2)], [ratio(2, 1), ratio(-1, 1)], ratio(1, 5)),
    ];
    (part(vertices, [ratio(221, 42), ratio(29, 21)], ratio(46937, 3528)), Fixture { fixels })
}

fn part(vertices: Vec<[Q; 2]>, center_of_mass: [Q; 2], inertia: Q) -> Part {
    Part {
        unit: LengthUnit::Metre,
        shape: Shape::Polygon(Polygon::new(vertices).expect("the outline is simple")),
        center_of_mass,
        center_of_mass_tolerance: ratio(0, 1),
        mass: ratio(1, 1),
        inertia,
    }
}

fn fixel(point: [Q; 2], normal: [Q; 2], friction: Q) -> Fixel {
    let range = Range::exactly(friction);
    let friction = Friction { static_: range.clone(), kinetic: range };
    Fixel { place: Place::Edge { edge: 0, s: ratio(1, 2) }, point, normal, friction }
}
