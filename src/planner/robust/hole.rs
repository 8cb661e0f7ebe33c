//! Upper bounds on the distance from a closed cone, in floating point.

use super::frame::{Frame, dot, exact};
use crate::cone::Pair;
use crate::exact::{Int, Overflow};

/// Absolute error of the few products of numbers up to 1 that a distance is made of, with much to spare.
const ERROR: f64 = 64.0 * f64::EPSILON;

/// A closed cone by unit vectors that are off by a few ulp.
pub(super) struct Hole {
    /// Rays, and lines both ways.
    generators: Vec<[f64; 3]>,
    /// Generators that span a piece of the boundary, or of the cone itself if it is flat, with what projects on it.
    pieces: Vec<Piece>,
    /// Facet normals of a solid cone; none for a flat one.
    normals: Vec<[f64; 3]>,
}

/// The cone that two generators span: their cosine and squared sine.
struct Piece {
    ends: [usize; 2],
    cos: f64,
    sin2: f64,
}

impl Hole {
    pub(super) fn of<T: Int>(cone: &Pair<T>, frame: &Frame) -> Result<Self, Overflow> {
        let n_rays = cone.rays().len();
        let lines = cone.lines().rows().map(|line| frame.unit(&exact(line)));
        let mut generators: Vec<[f64; 3]> = cone.rays().rows().map(|ray| frame.unit(&exact(ray))).collect();
        generators.extend(lines.flat_map(|line| [line, line.map(|value| -value)]));
        let is_solid = cone.dim() == 3;
        let mut pieces = Vec::new();
        for face in cone.faces()?.iter().filter(|face| !is_solid || face.len() < n_rays || n_rays == 0) {
            let ends: Vec<usize> = face.iter().copied().chain(n_rays..generators.len()).collect();
            for (at, second) in ends.iter().enumerate() {
                pieces.extend(ends[..at].iter().filter_map(|first| Piece::of(&generators, [*first, *second])));
            }
        }
        let normals =
            if is_solid { cone.facets().rows().map(|normal| frame.dual(&exact(normal))).collect() } else { vec![] };
        Ok(Self { generators, pieces, normals })
    }

    /// An upper bound on the distance of a unit vector, near the distance.
    ///
    /// It is the distance of some point of the cone, which exists whatever rounding does to its coefficients; rounding
    /// of the vectors themselves moves that point by the error that is added.
    pub(super) fn distance_at_most(&self, unit: &[f64; 3]) -> f64 {
        let is_solid = !self.normals.is_empty();
        if is_solid && self.normals.iter().all(|normal| dot(normal, unit) < -ERROR) {
            return 0.0;
        }
        let mut least: f64 = 1.0;
        for generator in &self.generators {
            let share = dot(generator, unit);
            if share > 0.0 {
                let apart = [0, 1, 2].map(|axis| unit[axis] - share * generator[axis]);
                least = least.min(dot(&apart, &apart).sqrt() + ERROR * (1.0 + share));
            }
        }
        for Piece { ends, cos, sin2 } in &self.pieces {
            let [a, b] = ends.map(|end| &self.generators[end]);
            let (along_a, along_b) = (dot(a, unit), dot(b, unit));
            let (of_a, of_b) = ((along_a - cos * along_b) / sin2, (along_b - cos * along_a) / sin2);
            if of_a > 0.0 && of_b > 0.0 {
                let apart = [0, 1, 2].map(|axis| unit[axis] - of_a * a[axis] - of_b * b[axis]);
                least = least.min(dot(&apart, &apart).sqrt() + ERROR * (1.0 + of_a + of_b));
            }
        }
        least
    }
}

impl Piece {
    /// `None` for generators that are parallel or so near that they add nothing to either.
    fn of(generators: &[[f64; 3]], ends: [usize; 2]) -> Option<Self> {
        let [a, b] = ends.map(|end| &generators[end]);
        let cos = dot(a, b);
        let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let sin2 = dot(&normal, &normal);
        (sin2 > 1e-24).then_some(Self { ends, cos, sin2 })
    }
}
