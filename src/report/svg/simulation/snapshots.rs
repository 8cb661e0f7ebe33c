//! At which times bodies are drawn.

use crate::answer::Frame;
use crate::report::motion::{Outline, Run, Shown};

/// Poses of each body that are drawn: fewer of many bodies.
fn poses_of_each(n_bodies: usize) -> usize {
    match n_bodies {
        0..=3 => 10,
        4..=8 => 5,
        9..=24 => 3,
        _ => 2,
    }
}

/// Points of a path.
const MOST_POINTS: usize = 400;

/// The frames that pictures show.
pub(super) struct Snapshots<'a, S: Shown> {
    /// All of them.
    pub(super) frames: Vec<&'a Frame<S>>,
    /// Those whose poses are drawn, by time.
    pub(super) drawn: Vec<usize>,
}

impl<'a, S: Shown> Snapshots<'a, S> {
    /// Frames about equally far apart, by the way of centers of mass and by turning.
    pub(super) fn new(run: &Run<S>, frames: Vec<&'a Frame<S>>) -> Self {
        let sizes: Vec<f64> = run.world.bodies.iter().map(|body| size::<S>(&body.shape)).collect();
        let mut way = vec![0.0];
        for pair in frames.windows(2) {
            let steps = pair[0].poses.iter().zip(&pair[1].poses).zip(&sizes);
            let longest = steps.map(|((from, to), size)| moved::<S>(from, to) + size * S::turn(from, to));
            way.push(way[way.len() - 1] + longest.fold(0.0, f64::max));
        }
        let total = way[way.len() - 1];
        let count = poses_of_each(sizes.len());
        let mut drawn: Vec<usize> = (0..count)
            .map(|k| total * k as f64 / (count - 1) as f64)
            .map(|goal| way.iter().position(|way| *way >= goal).unwrap_or(way.len() - 1))
            .collect();
        drawn.push(frames.len().saturating_sub(1));
        drawn.sort_unstable();
        drawn.dedup();
        if let [.., _, _] = drawn[..]
            && total == 0.0
        {
            drawn.truncate(1);
        }
        drawn.retain(|frame| *frame < frames.len());
        Self { frames, drawn }
    }

    /// The path of a body's center of mass, thinned.
    pub(super) fn path(&self, body: usize) -> impl Iterator<Item = &[f64]> {
        let stride = self.frames.len().div_ceil(MOST_POINTS).max(1);
        let last = self.frames.len().saturating_sub(1);
        let kept = self.frames.iter().enumerate().filter(move |(index, _)| index % stride == 0 || *index == last);
        kept.filter_map(move |(_, frame)| frame.poses.get(body).map(AsRef::as_ref))
    }
}

/// Way of the center of mass.
fn moved<S: Shown>(from: &S::Pose, to: &S::Pose) -> f64 {
    let pairs = from.as_ref().iter().zip(to.as_ref()).take(S::DIMENSION);
    pairs.map(|(from, to)| (to - from).powi(2)).sum::<f64>().sqrt()
}

/// How far the outline reaches from the origin of its frame.
fn size<S: Shown>(shape: &S::Shape) -> f64 {
    let reach = |outline: &Outline| match outline {
        Outline::Polygon(corners) => corners.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max),
        Outline::Disc { center, radius, .. } => center[0].hypot(center[1]) + radius,
        Outline::Half { .. } => 0.0,
    };
    let outlines = S::VIEWS.iter().flat_map(|view| S::outlines(shape, None, *view));
    outlines.map(|outline| reach(&outline)).fold(0.0, f64::max)
}
