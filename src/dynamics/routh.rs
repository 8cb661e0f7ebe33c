//! Slip that reverses inside an impact: what laws of impact disagree about.

/// The impact of one contact in the plane: velocities of before and how impulses change them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SingleImpact {
    /// Normal velocity before (m/s), negative.
    pub approach: f64,
    /// Slip before (m/s).
    pub slip: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// A_nn, A_nt and A_tt (1/kg).
    pub compliance: [f64; 3],
}

impl SingleImpact {
    /// Slip at the end of the compression by Routh's law (m/s): friction follows the slip as it changes.
    ///
    /// The normal impulse grows from zero; while the contact slips, `dp_t = -μ sgn(s) dp_n`. Where the slip ends, it stays
    /// ended if friction can hold it, `|A_nt| ≤ μ A_tt`; else it reverses.
    pub fn routh_slip(&self) -> f64 {
        let Self { approach, slip, friction, compliance: [nn, nt, tt] } = *self;
        let against = |direction: f64| [nn - friction * direction * nt, nt - friction * direction * tt];
        let direction = if slip < 0.0 { -1.0 } else { 1.0 };
        let [normal, tangential] = against(direction);
        let to_end = -approach / normal;
        let to_stop = -slip / tangential;
        if to_stop.is_nan() || to_stop <= 0.0 || (normal > 0.0 && to_end <= to_stop) {
            return slip + tangential * to_end;
        }
        if nt.abs() <= friction * tt {
            return 0.0;
        }
        let left = approach + normal * to_stop;
        let [normal, tangential] = against(-direction);
        tangential * -left / normal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published rod: |A_nt / A_tt| = 0.743 > μ = 0.3, slip 0.2 m/s, ends at -0.5976 by Routh's law.
    #[test]
    fn the_published_rod_slips_back() {
        let (m, j, a, b, angle) = (1.0, 0.083_366_666_666_666_66, 0.5, 0.01, 0.5_f64);
        let (x, y) = (-a * angle.cos() + b * angle.sin(), -a * angle.sin() - b * angle.cos());
        // n = +y, t = +x: torques x and -y
        let compliance = [1.0 / m + x * x / j, -x * y / j, 1.0 / m + y * y / j];
        assert!((compliance[1] / compliance[2]).abs() > 0.74);
        let fall = (2.0 * 9.81_f64 * (0.6 + y)).sqrt();
        let impact = SingleImpact { approach: -fall, slip: 0.2, friction: 0.3, compliance };
        assert!((impact.routh_slip() + 0.5976).abs() < 1e-4, "{}", impact.routh_slip());
    }

    /// Enough friction stops the slip for good; little friction does not stop it at all.
    #[test]
    fn slip_ends_or_goes_on() {
        let impact = SingleImpact { approach: -1.0, slip: 0.1, friction: 2.0, compliance: [1.0, 0.3, 1.0] };
        assert_eq!(impact.routh_slip(), 0.0);
        let impact = SingleImpact { friction: 0.01, slip: 5.0, ..impact };
        let wanted = 5.0 + (0.3 - 0.01) / (1.0 - 0.01 * 0.3);
        assert!((impact.routh_slip() - wanted).abs() < 1e-12);
    }
}
