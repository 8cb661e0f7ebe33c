//! One contact in closed form.

/// Impulses along n and t of the only contact in the plane, and the residual relative to the velocities.
///
/// `compliance` is A_nn, A_nt and A_tt (1/kg), `free` the velocities along n and t without impulse (m/s). `None` where
/// A_nn ≤ μ |A_nt|, for then the answer may not be unique, and where rounding cannot tell.
pub(super) fn planar(compliance: [f64; 3], free: [f64; 2], mu: f64) -> Option<([f64; 3], f64)> {
    let ([nn, nt, tt], [normal, slip]) = (compliance, free);
    if nn <= mu * nt.abs() {
        return None;
    }
    if normal >= 0.0 {
        return Some(([0.0; 3], 0.0));
    }
    let determinant = nn * tt - nt * nt;
    let stick = [(nt * slip - tt * normal) / determinant, (nt * normal - nn * slip) / determinant];
    let is_held = determinant > 1e-9 * nn * tt && stick[0] >= 0.0 && stick[1].abs() <= mu * stick[0];
    let impulse = if is_held {
        stick
    } else {
        let sliding = [1.0, -1.0].map(|direction| {
            let press = -normal / (nn - mu * direction * nt);
            (press, direction, slip + (nt - mu * direction * tt) * press)
        });
        let (press, direction, _) = sliding.into_iter().find(|(_, direction, slip)| slip * direction > 0.0)?;
        [press, -mu * direction * press]
    };
    let left = nn * impulse[0] + nt * impulse[1] + normal;
    let residual = left.abs() / normal.abs().max(slip.abs());
    (residual <= 1e-12).then_some(([impulse[0], impulse[1], 0.0], residual))
}

/// The same in space where normal and tangents do not act on each other and the tangents are alike, as for a ball: then the
/// exact friction disc has a closed form. `gram` is 3 × 3 over n, t and o.
pub(super) fn ball(gram: &[f64; 9], normal: f64, slip: [f64; 2], mu: f64) -> Option<([f64; 3], f64)> {
    let [nn, nt, no, _, tt, to, _, _, oo] = *gram;
    let rounding = 1e-14 * nn.max(tt);
    if [nt, no, to].iter().any(|a| a.abs() > rounding) || (tt - oo).abs() > rounding {
        return None;
    }
    if normal >= 0.0 {
        return Some(([0.0; 3], 0.0));
    }
    let press = -normal / nn;
    let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
    let drag = if speed <= mu * press * tt { 1.0 / tt } else { mu * press / speed };
    Some(([press, -drag * slip[0], -drag * slip[1]], f64::EPSILON))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complementarity::{Factors, Solver, Verdict};
    use proptest::prelude::*;

    proptest! {
        /// The closed form is what the ladder of solvers finds, for a part of 1 kg touched at (x, y).
        #[test]
        fn one_contact_is_solved_as_by_the_ladder(
            x in -1.0..1.0_f64, y in -1.0..1.0_f64, inertia in 0.01..2.0_f64, mu in 0.0..1.5_f64,
            normal in -2.0..0.5_f64, slip in -2.0..2.0_f64,
        ) {
            let jacobian = [0.0, 1.0, x, 1.0, 0.0, -y, -1.0, 0.0, y];
            let inverse_mass = [1.0, 1.0, 1.0 / inertia];
            let compliance = [1.0 + x * x / inertia, -x * y / inertia, 1.0 + y * y / inertia];
            let q = [normal, slip, -slip, 0.0];
            let factors = Factors { jacobian: &jacobian, inverse_mass: &inverse_mass, mu: &[mu], directions: 2, q: &q };
            let mut m = Vec::new();
            factors.assemble(&mut m).unwrap();
            if let Some(([press, drag, _], _)) = planar(compliance, [normal, slip], mu) {
                let mut solver = Solver::default();
                let lcp = crate::complementarity::Lcp { m: &m, q: &q };
                let Verdict::Solved(solution) = solver.solve(lcp, None, &|| factors.to_exact()).unwrap() else {
                    panic!("the ladder finds no solution")
                };
                prop_assert!((press - solution.z[0]).abs() < 1e-9, "{press} for {}", solution.z[0]);
                prop_assert!((drag - solution.z[1] + solution.z[2]).abs() < 1e-9);
            } else {
                prop_assert!(compliance[0] <= mu * compliance[1].abs(), "not solved");
            }
        }
    }

    /// A ball: p_n = -m v_n, and a slip beyond 7/2 μ of it slides on.
    #[test]
    fn a_ball_slides_or_rolls() {
        let gram = [5.0, 0.0, 0.0, 0.0, 17.5, 0.0, 0.0, 0.0, 17.5];
        let (rolls, _) = ball(&gram, -1.0, [0.3, 0.4], 0.3).unwrap();
        assert!((rolls[0] - 0.2).abs() < 1e-15 && (rolls[1] + 0.3 / 17.5).abs() < 1e-15);
        let (slides, _) = ball(&gram, -1.0, [3.0, 4.0], 0.3).unwrap();
        assert!((slides[1] + 0.036).abs() < 1e-15 && (slides[2] + 0.048).abs() < 1e-15);
    }
}
