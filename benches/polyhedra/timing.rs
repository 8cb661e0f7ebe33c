//! Median CPU time of a conversion.

use cpu_time::ProcessTime;

/// Median of five samples of at least 40 ms each, since some clocks tick every 4 ms, in microseconds; of fewer when one run
/// is long.
pub fn median(mut run: impl FnMut()) -> f64 {
    let mut sample = |repeats: u32| {
        let start = ProcessTime::now();
        for _ in 0..repeats {
            run();
        }
        start.elapsed().as_secs_f64()
    };
    let first = sample(1);
    if first > 2.0 {
        return first * 1e6;
    }
    let mut repeats = 1;
    while sample(repeats) < 0.04 {
        repeats *= 2;
    }
    let count = if first > 0.2 { 3 } else { 5 };
    let mut samples: Vec<f64> = (0..count).map(|_| sample(repeats) / f64::from(repeats)).collect();
    samples.sort_by(f64::total_cmp);
    samples[count / 2] * 1e6
}
