//! Random planar contact problems, built from where bodies touch: the same for charts, tests and benches.

use crate::complementarity::Factors;

/// Splitmix64: the same problems everywhere.
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// Any number.
    #[must_use]
    pub fn number(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `low..high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.number() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// Log-uniform between powers of ten.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.within(low, high))
    }

    /// One of `low..=high`.
    pub fn count(&mut self, low: usize, high: usize) -> usize {
        low + (self.number() % (high - low + 1) as u64) as usize
    }

    /// Whether something of this probability is so.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.within(0.0, 1.0) < probability
    }
}

/// Kinds of problems, after the failures that each provokes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family {
    /// One body in motion, contacts anywhere around it.
    Generic {
        /// Fewest contacts.
        from: usize,
        /// Most contacts.
        to: usize,
    },
    /// A body on a floor, touching at up to twelve points of a line, at rest or nearly so.
    Resting,
    /// Two to six blocks on each other, the mass of each one or `ratio`, at the top `ratio`.
    Stack {
        /// The ratio.
        ratio: f64,
    },
    /// Opposed contacts that both overlap.
    Squeeze,
    /// Three blocks on each other, the top one heavier by `ratio`, a share of the contacts twice at the same place.
    Doubled {
        /// The ratio.
        ratio: f64,
        /// The share.
        share: f64,
    },
    /// Everything at once: masses of 10^-6 to 10^6, friction up to ten, doubled contacts, and slight overlaps if wanted.
    Wild {
        /// Whether there are overlaps.
        overlaps: bool,
    },
}

/// Whether a family's problems all have solutions: no gap is negative. Among wild ones are closed grips, in which even the
/// rounding of `q` counts as an overlap.
#[must_use]
pub fn is_always_solvable(family: Family) -> bool {
    !matches!(family, Family::Squeeze | Family::Wild { .. })
}

/// A contact problem: what [`Factors`] borrow.
#[derive(Debug, Clone, Default)]
pub struct Problem {
    /// Rows of `W_nᵀ`, then of `W_fᵀ`.
    pub jacobian: Vec<f64>,
    /// Diagonal of the inverse of the mass matrix.
    pub inverse_mass: Vec<f64>,
    /// Coefficient of friction of each contact.
    pub mu: Vec<f64>,
    /// Friction directions for each contact.
    pub directions: usize,
    /// The right side.
    pub q: Vec<f64>,
}

impl Problem {
    /// What it is made of.
    #[must_use]
    pub fn factors(&self) -> Factors<'_> {
        Factors {
            jacobian: &self.jacobian,
            inverse_mass: &self.inverse_mass,
            mu: &self.mu,
            directions: self.directions,
            q: &self.q,
        }
    }
}

/// A contact: its normal and tangential rows, the gap over the step length, friction.
struct Touch {
    normal: Vec<f64>,
    tangent: Vec<f64>,
    gap: f64,
    mu: f64,
}

/// The next problem of a family.
pub fn draw(family: Family, random: &mut Random) -> Problem {
    match family {
        Family::Generic { from, to } => generic(random, from, to),
        Family::Resting => resting(random),
        Family::Stack { ratio } => {
            let count = random.count(2, 6);
            stack(random, count, ratio, 0.0)
        }
        Family::Doubled { ratio, share } => stack(random, 3, ratio, share),
        Family::Squeeze => squeeze(random),
        Family::Wild { overlaps } => wild(random, overlaps),
    }
}

fn generic(random: &mut Random, from: usize, to: usize) -> Problem {
    let (mass, radius) = (random.decades(-1.0, 1.0), random.decades(-2.0, 0.0));
    let count = random.count(from, to);
    let touches = (0..count)
        .map(|_| {
            let gap = if random.chance(0.4) { 0.0 } else { random.within(0.0, 0.5) };
            let (at, normal) = (random.within(0.0, 6.3), random.within(-0.6, 0.6));
            let mu = random.within(0.0, 1.5);
            // the normal points inwards, more or less
            touch(1, 0, [radius * at.cos(), radius * at.sin()], at + normal + std::f64::consts::PI, gap, mu)
        })
        .collect();
    let velocity = [random.within(-1.0, 1.0), random.within(-1.0, 1.0), random.within(-1.0, 1.0) / radius];
    problem(&[[mass, mass * radius * radius * random.within(0.2, 0.6)]], touches, &velocity)
}

fn resting(random: &mut Random) -> Problem {
    let (mass, half) = (random.decades(-2.0, 1.0), random.decades(-2.0, -1.0));
    let count = random.count(2, 12);
    let mu = random.within(0.0, 1.0);
    let up = std::f64::consts::FRAC_PI_2;
    let touches = (0..count)
        .map(|at| {
            let x = half * (2.0 * at as f64 / (count - 1) as f64 - 1.0);
            Touch { ..touch(1, 0, [x, -half], up, 0.0, mu) }
        })
        .collect();
    let step = random.decades(-4.0, -2.0);
    let slide = if random.chance(0.5) { 0.0 } else { random.within(-0.01, 0.01) };
    let velocity = [slide + 9.81 * step * random.within(-0.3, 0.3), -9.81 * step, 0.0];
    problem(&[[mass, mass * half * half * 2.0 / 3.0]], touches, &velocity)
}

fn stack(random: &mut Random, count: usize, ratio: f64, doubled: f64) -> Problem {
    let (half, step) = (random.decades(-2.0, -1.0), random.decades(-4.0, -2.0));
    let mu = random.within(0.1, 1.0);
    let mut bodies = Vec::new();
    let mut touches = Vec::new();
    let up = std::f64::consts::FRAC_PI_2;
    for body in 0..count {
        let mass = if body + 1 == count || random.chance(0.3) { ratio } else { 1.0 };
        bodies.push([mass, mass * half * half * 2.0 / 3.0]);
        let shift = random.within(-0.3, 0.3) * half;
        for x in [-half, half] {
            let gap = if random.chance(0.9) { 0.0 } else { random.within(0.0, 1e-3) };
            let mut contact = touch(count, body, [x, -half], up, gap, mu);
            if body > 0 {
                let below = touch(count, body - 1, [x - shift, half], up, 0.0, mu);
                contact.normal.iter_mut().zip(below.normal).for_each(|(entry, other)| *entry -= other);
                contact.tangent.iter_mut().zip(below.tangent).for_each(|(entry, other)| *entry -= other);
            }
            if doubled > 0.0 && random.chance(doubled) {
                touches.push(Touch { normal: contact.normal.clone(), tangent: contact.tangent.clone(), ..contact });
            }
            touches.push(contact);
        }
    }
    let push = if random.chance(0.5) { 0.0 } else { random.within(-0.5, 0.5) };
    let velocity: Vec<f64> = (0..count).flat_map(|_| [9.81 * step * push, -9.81 * step, 0.0]).collect();
    problem(&bodies, touches, &velocity)
}

fn squeeze(random: &mut Random) -> Problem {
    let (mass, half) = (random.decades(-1.0, 1.0), random.decades(-2.0, -1.0));
    let (axis, mu) = (random.within(0.0, 6.3), random.within(0.0, 1.0));
    let mut touches = Vec::new();
    for side in [0.0, std::f64::consts::PI] {
        let (sin, cos) = (axis + side).sin_cos();
        let gap = -random.within(0.001, 0.05);
        touches.push(touch(1, 0, [-half * cos, -half * sin], axis + side, gap, mu));
    }
    if random.chance(0.5) {
        // exactly opposed, not only as far as sines are
        let opposite = |row: &[f64]| row.iter().map(|entry| -entry).collect::<Vec<_>>();
        touches[1].normal = opposite(&touches[0].normal);
        touches[1].tangent = opposite(&touches[0].tangent);
    }
    for _ in 0..random.count(0, 2) {
        let at = random.within(0.0, 6.3);
        let position = [half * at.cos(), half * at.sin()];
        touches.push(touch(1, 0, position, at + std::f64::consts::PI, random.within(0.0, 0.1), mu));
    }
    let velocity = [random.within(-0.1, 0.1), random.within(-0.1, 0.1), random.within(-1.0, 1.0)];
    problem(&[[mass, mass * half * half * 0.5]], touches, &velocity)
}

fn wild(random: &mut Random, overlaps: bool) -> Problem {
    let n_bodies = random.count(1, 3);
    let mut bodies = Vec::new();
    let mut velocity = Vec::new();
    for _ in 0..n_bodies {
        let mass = random.decades(-6.0, 6.0);
        bodies.push([mass, mass * random.decades(-2.0, 0.0)]);
        velocity.extend([random.within(-1.0, 1.0), random.within(-1.0, 1.0), random.within(-3.0, 3.0)]);
    }
    let count = random.count(1, 12);
    let mut touches: Vec<Touch> = Vec::new();
    while touches.len() < count {
        let mu = if random.chance(0.2) { random.within(0.0, 10.0) } else { random.within(0.0, 1.0) };
        let gap = match random.count(0, 3) {
            0 => random.within(0.0, 0.3),
            1 if overlaps => -random.decades(-9.0, -3.0),
            _ => 0.0,
        };
        let (body, at) = (random.count(0, n_bodies - 1), random.within(0.0, 6.3));
        let (position, angle) = ([at.cos(), at.sin()], at + std::f64::consts::PI + random.within(-0.4, 0.4));
        let mut contact = touch(n_bodies, body, position, angle, gap, mu);
        let other = random.count(0, n_bodies - 1);
        if other != body {
            let against = touch(n_bodies, other, [-at.cos(), -at.sin()], angle, 0.0, mu);
            contact.normal.iter_mut().zip(against.normal).for_each(|(entry, other)| *entry -= other);
            contact.tangent.iter_mut().zip(against.tangent).for_each(|(entry, other)| *entry -= other);
        }
        if touches.len() + 1 < count && random.chance(0.2) {
            touches.push(Touch { normal: contact.normal.clone(), tangent: contact.tangent.clone(), ..contact });
        }
        touches.push(contact);
    }
    problem(&bodies, touches, &velocity)
}

/// The rows of a contact at `at` (from the centre of mass) of one of `count` bodies with the floor or a wall.
fn touch(count: usize, body: usize, at: [f64; 2], angle: f64, gap: f64, mu: f64) -> Touch {
    let mut n = [angle.cos(), angle.sin()];
    if n[0].abs() < 1e-15 {
        n = [0.0, n[1].signum()];
    }
    let t = [n[1], -n[0]];
    let row = |d: [f64; 2]| {
        let mut row = vec![0.0; 3 * count];
        row[3 * body..3 * body + 3].copy_from_slice(&[d[0], d[1], at[0] * d[1] - at[1] * d[0]]);
        row
    };
    Touch { normal: row(n), tangent: row(t), gap, mu }
}

/// `bodies`: mass and moment of inertia.
fn problem(bodies: &[[f64; 2]], touches: Vec<Touch>, velocity: &[f64]) -> Problem {
    let speed = |row: &[f64]| row.iter().zip(velocity).fold(0.0, |sum, (a, b)| sum + a * b);
    let mut problem = Problem { directions: 2, ..Problem::default() };
    problem.inverse_mass = bodies.iter().flat_map(|[mass, inertia]| [1.0 / mass, 1.0 / mass, 1.0 / inertia]).collect();
    for touch in &touches {
        problem.jacobian.extend(&touch.normal);
        problem.q.push(speed(&touch.normal) + touch.gap);
    }
    for touch in &touches {
        problem.jacobian.extend(&touch.tangent);
        problem.jacobian.extend(touch.tangent.iter().map(|entry| -entry));
        problem.q.extend([speed(&touch.tangent), -speed(&touch.tangent)]);
    }
    problem.mu = touches.iter().map(|touch| touch.mu).collect();
    problem.q.extend(touches.iter().map(|_| 0.0));
    problem
}
