//! Accelerations of the arm that keep a part from moving on it.

use super::grasp::RestingEdge;
use crate::exact::{Q, Surd, Z};
use crate::geometry::direction_of_degrees;
use num_traits::{One as _, Zero as _};
use std::cmp::Ordering;

/// A part that lies on an arm with one edge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Load {
    /// The edge.
    pub edge: RestingEdge,
    /// Radius R (length).
    pub radius: Q,
    /// Offset h of the arm (length).
    pub offset: Q,
    /// ρ² (length²).
    pub rho2: Q,
    /// Gravity |g| (length/s²).
    pub gravity: Q,
    /// Coulomb coefficient μ; `None` if nothing slips.
    pub friction: Option<Q>,
}

/// Least and largest angular acceleration (rad/s²); an end that is absent is infinite.
pub type Accelerations<N> = [Option<N>; 2];

impl Load {
    /// The angular accelerations that keep a dynamic grasp, exactly, while the arm points to (cos θ, sin θ) and turns at
    /// `rate` (rad/s); `None` if none does.
    ///
    /// # Source
    /// Lynch, Northrop & Pan (2002), section III-A.1: the wrench **w** is in the cone of **w**_1 to **w**_4. Their g is
    /// negative.
    #[must_use]
    pub fn accelerations(&self, [cosine, sine]: [&Q; 2], rate: &Q) -> Option<Accelerations<Surd>> {
        let of = |value: &Q| [Surd::from(value.clone()), Surd::from(value.clone())];
        match allowed(&self.rows(rate), &[of(cosine), of(sine)]) {
            Allowed::Between(ends) => Some(ends.map(|end| end.map(|[value, _]| value))),
            Allowed::None | Allowed::Unknown(_) => None,
        }
    }

    /// The same for the arm at an angle in degrees: each end between two rationals, about 1e-15 of it apart, or equal where
    /// the end is known to be rational.
    ///
    /// Ends, and signs, that 300 digits do not tell apart are taken to be equal.
    #[must_use]
    pub fn accelerations_at(&self, degrees: &Q, rate: &Q) -> Option<Accelerations<[Q; 2]>> {
        let rows = self.rows(rate);
        let at = |bits| {
            let of = |ends: [Q; 2]| ends.map(Surd::from);
            allowed(&rows, &direction_of_degrees(degrees, bits).map(of))
        };
        let found = match at(256) {
            Allowed::Unknown(_) => at(1_024),
            known => known,
        };
        match found {
            Allowed::Between(ends) | Allowed::Unknown(ends) => Some(ends.map(|end| end.map(short))),
            Allowed::None => None,
        }
    }

    /// What keeps **w** in the cone; (2) and (4) only with friction.
    fn rows(&self, rate: &Q) -> Vec<Row> {
        let rational = |value: &Q| Surd::from(value.clone());
        let (one, d) = (rational(&Q::one()), &self.edge.d);
        let row = |[f_u, f_v, moment]: [&Surd; 3]| self.row([f_u, f_v, moment], &(rate * rate));
        // the line of force is right of the left vertex and left of the right one
        let mut rows = vec![row([&-d, &-&self.edge.u_left, &one]), row([d, &self.edge.u_right, &-&one])];
        if let Some(mu) = &self.friction {
            let mu = rational(mu);
            rows.extend([row([&-&one, &mu, &rational(&Q::zero())]), row([&one, &mu, &rational(&Q::zero())])]);
        }
        rows
    }

    /// A combination of f_u, f_v and τ a unit of mass as it depends on the acceleration, cos θ and sin θ.
    fn row(&self, [of_u, of_v, of_moment]: [&Surd; 3], rate2: &Q) -> Row {
        let rational = |value: &Q| Surd::from(value.clone());
        let level = &rational(&self.offset) + &self.edge.d;
        let (radius, gravity) = (rational(&self.radius), rational(&self.gravity));
        let centripetal = &(&(of_u * &radius) + &(of_v * &level)) * &rational(&-rate2);
        Row {
            slope: &(&(of_v * &radius) - &(of_u * &level)) + &(of_moment * &rational(&self.rho2)),
            constant: centripetal,
            by_direction: [of_v * &gravity, of_u * &gravity],
        }
    }
}

/// `slope` α + `constant` + `by_direction` · (cos θ, sin θ) ≥ 0.
struct Row {
    slope: Surd,
    constant: Surd,
    by_direction: [Surd; 2],
}

impl Row {
    /// Bounds of what does not depend on α.
    fn rest(&self, direction: &[[Surd; 2]; 2]) -> [Surd; 2] {
        let mut rest = [self.constant.clone(), self.constant.clone()];
        for (factor, ends) in self.by_direction.iter().zip(direction) {
            let [low, high] = if factor.sign().is_lt() { [&ends[1], &ends[0]] } else { [&ends[0], &ends[1]] };
            rest = [&rest[0] + &(factor * low), &rest[1] + &(factor * high)];
        }
        rest
    }
}

/// What some rows allow; numbers are between two.
enum Allowed {
    None,
    Between(Accelerations<[Surd; 2]>),
    /// As before, if anything.
    Unknown(Accelerations<[Surd; 2]>),
}

/// Solves the rows; a direction is given by bounds of cosine and sine.
fn allowed(rows: &[Row], direction: &[[Surd; 2]; 2]) -> Allowed {
    let (mut least, mut most) = (None, None);
    let mut is_known = true;
    for row in rows {
        let [low, high] = row.rest(direction);
        let bound = |rest: &Surd| -&(rest / &row.slope);
        match row.slope.sign() {
            Ordering::Equal if high.sign().is_lt() => return Allowed::None,
            Ordering::Equal => is_known &= low.sign().is_ge(),
            Ordering::Greater => least = Some(of_both(least, [bound(&high), bound(&low)], Surd::max)),
            Ordering::Less => most = Some(of_both(most, [bound(&low), bound(&high)], Surd::min)),
        }
    }
    if let (Some([least_low, least_high]), Some([most_low, most_high])) = (&least, &most) {
        if least_low > most_high {
            return Allowed::None;
        }
        is_known &= least_high <= most_low;
    }
    if is_known { Allowed::Between([least, most]) } else { Allowed::Unknown([least, most]) }
}

fn of_both(known: Option<[Surd; 2]>, [low, high]: [Surd; 2], choose: fn(Surd, Surd) -> Surd) -> [Surd; 2] {
    match known {
        Some([known_low, known_high]) => [choose(known_low, low), choose(known_high, high)],
        None => [low, high],
    }
}

/// Rationals around a number between two: the number itself if it is known and rational, else decimals.
fn short([low, high]: [Surd; 2]) -> [Q; 2] {
    if let (Some(value), true) = (low.rational(), low == high) {
        return [value.clone(), value.clone()];
    }
    let step = decimal_step(&low);
    let fine = &step / Q::from(Z::from(1_000));
    let [[low, _], [_, high]] = [low.between(&fine), high.between(&fine)];
    [(low / &step).floor() * &step, (high / &step).ceil() * &step]
}

/// A power of ten about 1e-16 of the number.
fn decimal_step(value: &Surd) -> Q {
    const SMALLEST: i32 = -40;
    let size = value.to_f64().abs();
    let power =
        if size > 0.0 && size.is_finite() { (size.log10().floor() as i32 - 15).max(SMALLEST) } else { SMALLEST };
    let ten = Q::from(Z::from(10).pow(power.unsigned_abs()));
    if power.is_negative() { ten.recip() } else { ten }
}
