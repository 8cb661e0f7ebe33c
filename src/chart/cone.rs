//! Cones from their normals to their rays: integers of every width beside doubles, by the faces that come out.

use super::contacts::Random;
use super::measure::{Curve, Measure, Outcome};
use crate::answer::ChartFamily;
use crate::cone::Pair;
use crate::exact::{Int, Ladder, Long, Matrix, Overflow, Rung, Z, climb, on_rung};

/// Bits of the coefficients, in a quick and in a whole chart.
const QUICK: [u32; 3] = [4, 20, 50];
const WHOLE: [u32; 7] = [4, 10, 20, 30, 40, 50, 60];

/// Cones of a point.
const COUNTS: [usize; 2] = [40, 300];

/// Dimension of the cones, as those of planar motion with one more for strictness.
const DIMENSION: usize = 4;

/// Normals drawn, and sums of two of them.
const DRAWN: usize = 7;
const SUMS: usize = 6;

/// What is added to the normals that are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Nothing.
    Generic,
    /// Sums of two of them, which touch the cone only.
    Degenerate,
    /// Such sums off by one in an entry: slivers that are cut off, or are not.
    Nearly,
}

/// For each ray the normals that it lies on, one bit each, sorted.
pub(super) type Faces = Vec<u64>;

/// A cone with its normals and its faces.
pub(super) struct Work {
    normals: Vec<Vec<Z>>,
    faces: Faces,
}

pub(super) fn measure(measure: &mut Measure) {
    let kinds = [("generic", Kind::Generic), ("degenerate", Kind::Degenerate), ("nearly degenerate", Kind::Nearly)];
    for (work, kind) in kinds {
        #[cfg(feature = "float-cone")]
        for (method, tolerance) in [("doubles, 1e-12", 1e-12), ("doubles, 1e-9", 1e-9), ("doubles, 1e-6", 1e-6)] {
            over_bits(measure, work, kind, method, &|cone: &Work| super::float_cone::faces(&cone.normals, tolerance));
        }
        for method in ["i64", "i128", "any size", "climbing"] {
            over_bits(measure, work, kind, method, &|cone: &Work| match method {
                "i64" => cone.run::<i64>().ok()?,
                "i128" => cone.run::<i128>().ok()?,
                "any size" => cone.run::<Long>().ok()?,
                _ => climb(cone, Rung::Word).0,
            });
        }
    }
}

/// A point for each size of the coefficients.
fn over_bits(measure: &mut Measure, work: &str, kind: Kind, method: &str, faces: &dyn Fn(&Work) -> Option<Faces>) {
    for bits in measure.pick(QUICK.to_vec(), WHOLE.to_vec()) {
        let setting = format!("{bits} bits");
        if !measure.wants(&[ChartFamily::Cone.name(), work, method, &setting]) {
            continue;
        }
        let cones = cones(bits, kind, measure.pick(COUNTS[0], COUNTS[1]), measure.question.seed);
        let curve = Curve { family: ChartFamily::Cone, work, method };
        measure.point(curve, &setting, cones.len() as u64, |_| {
            let (mut answered, mut wrong) = (0_u64, 0_u64);
            for cone in &cones {
                if let Some(found) = faces(cone) {
                    answered += 1;
                    wrong += u64::from(found != cone.faces);
                }
            }
            let of = cones.len() as u64;
            let error = (answered > 0).then(|| wrong as f64 / answered as f64);
            Outcome { error, failed: of - answered + wrong, of }
        });
    }
}

/// Pointed cones of full dimension around a common direction.
fn cones(bits: u32, kind: Kind, count: usize, seed: u64) -> Vec<Work> {
    let mut random = Random(seed.wrapping_add(u64::from(bits) << 8).wrapping_add(kind as u64));
    let mut found = Vec::new();
    while found.len() < count {
        let mut normals: Vec<Vec<Z>> = (0..DRAWN).map(|_| normal(&mut random, bits)).collect();
        for _ in 0..if kind == Kind::Generic { 0 } else { SUMS } {
            let [a, b] = [0, 1].map(|_| random.count(0, DRAWN - 1));
            let mut sum: Vec<Z> = normals[a].iter().zip(&normals[b]).map(|(a, b)| a + b).collect();
            if kind == Kind::Nearly {
                sum[random.count(0, DIMENSION - 1)] += if random.chance(0.5) { 1 } else { -1 };
            }
            normals.push(sum);
        }
        let mut work = Work { normals, faces: Faces::new() };
        // draws whose cone has lines are left out
        if let (Some(faces), _) = climb(&work, Rung::Word)
            && faces.len() >= DIMENSION
        {
            work.faces = faces;
            found.push(work);
        }
    }
    found
}

/// With the direction (1, 1, ...) on its inner side.
fn normal(random: &mut Random, bits: u32) -> Vec<Z> {
    loop {
        let mask = (1_u64 << bits) - 1;
        let mut entry = || Z::from(random.number() & mask) * if random.number() & 1 == 0 { 1 } else { -1 };
        let row: Vec<Z> = (0..DIMENSION).map(|_| entry()).collect();
        let side: Z = row.iter().sum();
        match side.cmp(&Z::default()) {
            std::cmp::Ordering::Less => return row,
            std::cmp::Ordering::Greater => return row.into_iter().map(|entry| -entry).collect(),
            std::cmp::Ordering::Equal => {}
        }
    }
}

impl Ladder for Work {
    /// `None` where the cone has lines.
    type Output = Option<Faces>;

    /// By the kernel of the crate.
    fn run<T: Int>(&self) -> Result<Option<Faces>, Overflow> {
        let mut normals = Matrix::new(DIMENSION);
        for normal in &self.normals {
            normals.push(&on_rung::<T>(normal)?);
        }
        let pair = Pair::from_normals(&Matrix::new(DIMENSION), &normals)?;
        if !pair.lines().is_empty() {
            return Ok(None);
        }
        let mut faces = Faces::new();
        for ray in pair.rays().rows() {
            let mut on = 0;
            for (index, normal) in normals.rows().enumerate() {
                on |= u64::from(T::wide_sign(&T::dot(ray, normal)?).is_eq()) << index;
            }
            faces.push(on);
        }
        faces.sort_unstable();
        Ok(Some(faces))
    }
}
