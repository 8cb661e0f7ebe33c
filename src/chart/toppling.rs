//! On which side of a critical height a pin is: doubles, doubles with bounds and exact numbers behind them, exact numbers.

use super::contacts::Random;
use super::measure::{Curve, Measure, Outcome};
use crate::answer::ChartFamily;
use crate::exact::{Algebraic, Q, from_float_exact, ratio};
use crate::mechanics::toppling::{Height, Signs, Toppled};

/// Distances from the critical height, over it, in powers of two; the last is a few doubles away.
const QUICK: [i32; 3] = [10, 40, 51];
const WHOLE: [i32; 6] = [4, 20, 40, 48, 50, 52];

/// Heights of a point.
const COUNTS: [usize; 2] = [1_000, 20_000];

/// A pin's height and what it is compared with.
struct Pair<'a> {
    critical: &'a Height,
    double: f64,
    height: Height,
    exact: Algebraic,
    is_above: bool,
}

pub(super) fn measure(measure: &mut Measure) {
    if !measure.wants_family(ChartFamily::Toppling) {
        return;
    }
    let (corners, center, belt, pin) = (ellipse(), [ratio(3, 10), ratio(-1, 5)], ratio(4, 3), ratio(7, 80));
    let part = Toppled { corners: &corners, center_of_mass: &center, belt_friction: &belt, pin_friction: [&pin; 2] };
    let signs = Signs::default();
    let critical: Vec<Height> = (0..corners.len())
        .filter(|edge| crate::geometry::rests_on(&corners, &center, *edge))
        .map(|edge| part.turn(edge, false, &signs))
        .flat_map(|turn| turn.rolling_jams.into_iter().chain(turn.settling_jams).flatten().chain(turn.heights))
        .filter(|height| *height > Height::zero())
        .collect();
    for power in measure.pick(QUICK.to_vec(), WHOLE.to_vec()) {
        let setting = format!("2^-{power} away");
        let pairs = pairs(&critical, power, measure.pick(COUNTS[0], COUNTS[1]), measure.question.seed);
        let few = &pairs[..pairs.len().div_ceil(20)];
        let mut point = |method: &str, pairs: &[Pair], says: &dyn Fn(&Pair) -> bool| {
            let curve = Curve { family: ChartFamily::Toppling, work: "pins near critical heights", method };
            measure.point(curve, &setting, pairs.len() as u64, |_| {
                let failed = pairs.iter().filter(|pair| says(pair) != pair.is_above).count() as u64;
                let of = pairs.len() as u64;
                Outcome { error: Some(failed as f64 / of as f64), failed, of }
            });
        };
        point("doubles", &pairs, &|pair| pair.double > pair.critical.near());
        point("bounds, exact in doubt", &pairs, &|pair| pair.height > *pair.critical);
        point("always exact", few, &|pair| pair.exact > *pair.critical.exact());
    }
}

/// Pins about `2^-power` of a critical height above or below it, and which of the two they are.
fn pairs(critical: &[Height], power: i32, count: usize, seed: u64) -> Vec<Pair<'_>> {
    let mut random = Random(seed.wrapping_add(power.unsigned_abs().into()));
    let pair = |_| {
        let critical = &critical[random.count(0, critical.len() - 1)];
        let away = random.within(-4.0, 4.0) * 2_f64.powi(-power);
        let double = critical.near() * (1.0 + away);
        let height: Q = from_float_exact(double)?;
        let exact = Algebraic::from(height.clone());
        let is_above = exact > *critical.exact();
        Some(Pair { critical, double, height: Height::rational(&height), exact, is_above })
    };
    if critical.is_empty() { Vec::new() } else { (0..count).filter_map(pair).collect() }
}

/// Twelve corners on an ellipse, not quite regular, with six decimals.
fn ellipse() -> Vec<[Q; 2]> {
    let corner = |index: u32| {
        let share = (f64::from(index) + 0.37 * f64::from(index * index % 7) / 7.0) / 12.0;
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * share);
        [13.0 * cosine, 10.0 * sine].map(|x| ratio((x * 1e6).round() as i64, 1_000_000))
    };
    (0..12).map(corner).collect()
}
