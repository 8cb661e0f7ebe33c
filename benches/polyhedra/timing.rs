//! Median CPU time of a conversion.

use cpu_time::ProcessTime;
use std::hint::black_box;

/// Median of nine samples of at least 4 ms each, in microseconds; of fewer when one run is long. And the last result.
pub fn median<R>(mut run: impl FnMut() -> R) -> (f64, R) {
    let start = ProcessTime::now();
    let mut result = run();
    let first = start.elapsed().as_secs_f64();
    if first > 2.0 {
        return (first * 1e6, result);
    }
    let mut sample = |repeats: u32| {
        let start = ProcessTime::now();
        for _ in 0..repeats {
            result = black_box(run());
        }
        start.elapsed().as_secs_f64()
    };
    let mut repeats = 1;
    while sample(repeats) < 0.004 {
        repeats *= 2;
    }
    let count = if first > 0.2 { 3 } else { 9 };
    let mut samples: Vec<f64> = (0..count).map(|_| sample(repeats) / f64::from(repeats)).collect();
    samples.sort_by(f64::total_cmp);
    (samples[count / 2] * 1e6, result)
}
