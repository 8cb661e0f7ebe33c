//! Random numbers of a run: one stream for each, so that runs do not depend on each other.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

/// The numbers of one run.
#[derive(Debug, Clone)]
pub struct Draw(ChaCha8Rng);

impl Draw {
    /// Those of run `run` of a seed.
    #[must_use]
    pub fn new(seed: u64, run: u64) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(run);
        Self(stream)
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between two.
    pub fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number of a range, often one of its ends: what fails, fails there first.
    pub fn extreme(&mut self, range: [f64; 2]) -> f64 {
        match self.unit() {
            u if u < 0.3 => range[0],
            u if u < 0.6 => range[1],
            _ => self.between(range),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_differ_and_are_repeated() {
        let of = |seed, run| Draw::new(seed, run).unit();
        assert_eq!(of(1, 5), of(1, 5));
        assert!(of(1, 5) != of(1, 6) && of(1, 5) != of(2, 5));
        let mut draw = Draw::new(0, 0);
        let ends = (0..1000).filter(|_| [2.0, 3.0].contains(&draw.extreme([2.0, 3.0]))).count();
        assert!((540..660).contains(&ends), "{ends}");
    }
}
