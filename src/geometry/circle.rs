//! Rational points on a circle by the tangent of the half angle.

use super::{difference, dot};
use crate::exact::{Q, Z, approximate};
use num_traits::{One as _, Signed as _};

/// Halvings of the step around the circle before the nearest short rational point is taken as it is.
const MAX_HALVINGS: u32 = 64;

/// A rational point exactly on the circle, close to where the ray from `center` through `point` leaves it.
///
/// Within `tolerance` of `point` when the circle itself is nearer than that; `None` if `point` is the center.
#[must_use]
pub fn rational_point_on_circle(center: &[Q; 2], radius: &Q, point: &[Q; 2], tolerance: &Q) -> Option<[Q; 2]> {
    let [x, y] = difference(center, point);
    let distance2 = dot(&[x.clone(), y.clone()], &[x.clone(), y.clone()]);
    if !distance2.is_positive() {
        return None;
    }
    let limit2 = tolerance * tolerance;
    let mut step = tolerance.clone();
    let mut best = None;
    for _ in 0..MAX_HALVINGS {
        // |dp/dt| <= 2 r, and half of the step pays for the square root
        let t_tolerance = &step / (radius * Q::from(Z::from(8)));
        let norm = square_root(&distance2, &(&t_tolerance * x.abs().max(y.abs())));
        let half_tangent = approximate(&(&y / (norm + x.abs())), &t_tolerance);
        let t2 = &half_tangent * &half_tangent;
        let cosine = (Q::one() - &t2) / (Q::one() + &t2);
        let sine = (&half_tangent + &half_tangent) / (Q::one() + &t2);
        let cosine = if x.is_negative() { -cosine } else { cosine };
        let candidate = [&center[0] + radius * cosine, &center[1] + radius * sine];
        let gap = difference(&candidate, point);
        let is_close = dot(&gap, &gap) <= limit2;
        best = Some(candidate);
        if is_close {
            break;
        }
        step /= Q::from(Z::from(2));
    }
    best
}

/// A rational at most `tolerance` above the square root of `value > 0`, and not below it.
fn square_root(value: &Q, tolerance: &Q) -> Q {
    // ceil(sqrt(v s²)) / s with 1 / s <= tolerance
    let scale = tolerance.recip().ceil().to_integer().max(Z::one());
    let radicand = (value * Q::from(&scale * &scale)).ceil().to_integer();
    let mut root = radicand.sqrt();
    if &root * &root < radicand {
        root += 1;
    }
    Q::new(root, scale)
}
