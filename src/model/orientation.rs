//! Directions in space: those of a body, and the tangents of a contact.

/// A direction of the body in the world, v + 2 e × (e × v + e0 v), for a pose `(x, y, z, e0, ex, ey, ez)` of unit length.
#[must_use]
pub fn turned(pose: &[f64; 7], v: [f64; 3]) -> [f64; 3] {
    let (e0, e) = (pose[3], [pose[4], pose[5], pose[6]]);
    let inner = cross(e, v);
    let inner = [inner[0] + e0 * v[0], inner[1] + e0 * v[1], inner[2] + e0 * v[2]];
    let outer = cross(e, inner);
    [v[0] + 2.0 * outer[0], v[1] + 2.0 * outer[1], v[2] + 2.0 * outer[2]]
}

/// Tangents t and o of a unit normal with (t, o, n) right-handed: t = +x and o = +y for n = +z.
#[must_use]
pub fn tangents(n: [f64; 3]) -> [[f64; 3]; 2] {
    let across = if n[1].abs() < 0.9 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, -n[1].signum()] };
    let t = cross(across, n);
    let length = (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]).sqrt();
    let t = t.map(|x| x / length);
    [t, cross(n, t)]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_right_handed_and_start_with_the_axes() {
        assert_eq!(tangents([0.0, 0.0, 1.0]), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        for n in [[0.6, 0.8, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.48, 0.6, -0.64]] {
            let [t, o] = tangents(n);
            let found = cross(t, o);
            assert!(found.iter().zip(n).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?} for {n:?}");
        }
    }

    /// A quarter turn about z takes x to y.
    #[test]
    fn a_quarter_turn() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let [x, y, z] = turned(&[0.0, 0.0, 0.0, half, 0.0, 0.0, half], [1.0, 0.0, 0.0]);
        assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 0.0);
    }
}
