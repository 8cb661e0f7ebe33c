//! The motion of the part over some throws, for playing.

use super::system::System;
use crate::answer::{LimitSet, Pose};

/// Throws played: about two cycles, but not too many to watch.
const MOST_THROWS: usize = 48;
/// Rest between catch and throw (s).
const REST: f64 = 0.1;
/// Moments between two poses.
const EVERY: usize = 2;

/// Plays the orbit of a limit set.
pub(super) fn replay(system: &System, set: &LimitSet) -> Vec<Pose> {
    let cycle = if set.throws_per_cycle.is_finite() { set.throws_per_cycle } else { 0.0 };
    let throws = ((2.0 * cycle).ceil() as usize).clamp(4, MOST_THROWS);
    let mut poses = Vec::new();
    let mut start = 0.0;
    for (throw, &(edge, radius)) in set.orbit.iter().take(throws).enumerate() {
        let (mut number, mut last) = (0, None);
        let time = system.near().play(edge, radius, system.settling, |moment| {
            let pose = Pose { time: start + moment.time, x: moment.at[0], y: moment.at[1], angle: moment.angle, throw };
            if number % EVERY == 0 {
                poses.push(pose);
            }
            number += 1;
            last = Some(pose);
        });
        start += time + REST;
        poses.extend(last.map(|pose| Pose { time: start - 0.5 * REST, ..pose }));
    }
    poses
}
