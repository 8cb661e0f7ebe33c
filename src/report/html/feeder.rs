//! The page that plays a device before and after its design, all entries at once.

use super::simulation_data;
use crate::answer::{FeederPlan, Film, Frame, Simulation};
use crate::model::{Obstacle, Planar, PlanarShape, World};
use crate::report::motion::{Outline, Run, Shown};
use crate::report::svg::{At, within};
use crate::report::{Chute, phrase};

/// Time between two frames (s).
const TICK: f64 = 0.004;

/// Around what moves, over its extent.
const MARGIN: f64 = 0.12;

/// The page of `plan feeder`; nothing to play where there are no films.
#[must_use]
pub fn feeder(chute: &Chute, answer: &FeederPlan, films: &[Film]) -> String {
    let remark = "Above the device as it was at first, below as it was designed, an entry each.";
    let data = collage(films).map(|(world, simulation)| {
        simulation_data(&Run { name: chute.name, world: &world, warnings: &[] }, &simulation)
    });
    super::page(chute.name, &phrase::feeder(chute, answer), remark, &data.unwrap_or_default())
}

/// All films in one scene, side by side, those of a design in a row, the obstacles cut off around what moves.
fn collage(films: &[Film]) -> Option<(World<Planar>, Simulation<Planar>)> {
    let first = films.first()?;
    let windows: Vec<[[f64; 2]; 2]> = films.iter().map(window).collect();
    let wide = windows.iter().map(|[low, high]| high[0] - low[0]).fold(0.0, f64::max);
    let high = windows.iter().map(|[low, high]| high[1] - low[1]).fold(0.0, f64::max);
    let (mut world, mut simulation) = (first.world.clone(), first.simulation.clone());
    (world.bodies, world.fixed, world.materials) = (Vec::new(), Vec::new(), Vec::new());
    let duration = films.iter().map(|film| film.simulation.time).fold(0.0, f64::max);
    let frame = |tick: usize| Frame {
        time: tick as f64 * TICK,
        poses: Vec::new(),
        velocities: Vec::new(),
        touches: Vec::new(),
    };
    let mut frames: Vec<Frame<Planar>> = (0..=(duration / TICK) as usize).map(frame).collect();
    let (mut row, mut column) = (0, 0);
    for (index, (film, [low, _])) in films.iter().zip(&windows).enumerate() {
        if index > 0 {
            (row, column) = if films[index - 1].design == film.design { (row, column + 1) } else { (row + 1, 0) };
        }
        let shift = [column as f64 * 1.08 * wide - low[0], -(row as f64) * 1.08 * high - low[1]];
        let mut body = film.world.bodies[0].clone();
        body.name = format!("{} {}", body.name, index + 1);
        world.bodies.push(body);
        let end = [low[0] + wide, low[1] + high];
        world.fixed.extend(film.world.fixed.iter().filter_map(|fixed| {
            let shape = moved(&fixed.shape, [*low, end], shift)?;
            Some(Obstacle { name: fixed.name.clone(), shape, surface_velocity: fixed.surface_velocity })
        }));
        for frame in &mut frames {
            let at = film.simulation.frames.partition_point(|shown| shown.time <= frame.time).saturating_sub(1);
            let shown = &film.simulation.frames[at];
            let [x, y, angle] = shown.poses[0];
            frame.poses.push([x + shift[0], y + shift[1], angle]);
            frame.velocities.push(shown.velocities[0]);
        }
    }
    simulation.last = frames.last()?.clone();
    (simulation.frames, simulation.time) = (frames, duration);
    simulation.events.clear();
    simulation.deformations.clear();
    simulation.notes.clear();
    Some((world, simulation))
}

/// The corners of what a film shows.
fn window(film: &Film) -> [[f64; 2]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for frame in &film.simulation.frames {
        for outline in Planar::outlines(&film.world.bodies[0].shape, Some(&frame.poses[0]), Planar::VIEWS[0]) {
            let corners = match outline {
                Outline::Polygon(corners) => corners,
                Outline::Disc { center: [x, y], radius, .. } => {
                    vec![[x - radius, y - radius], [x + radius, y + radius]]
                }
                Outline::Half { .. } => Vec::new(),
            };
            for corner in corners {
                for axis in 0..2 {
                    low[axis] = low[axis].min(corner[axis]);
                    high[axis] = high[axis].max(corner[axis]);
                }
            }
        }
    }
    let spare = MARGIN * (high[0] - low[0]).max(high[1] - low[1]);
    [low.map(|end| end - spare), high.map(|end| end + spare)]
}

/// What of an obstacle lies in a window, moved; nothing of what has no edges there.
fn moved(shape: &PlanarShape, [low, high]: [[f64; 2]; 2], shift: [f64; 2]) -> Option<PlanarShape> {
    match shape {
        PlanarShape::Polygon(corners) => {
            let [low, high] = [low, high].map(|[x, y]| At::new(x, y));
            let corners: Vec<At> = corners.iter().map(|[x, y]| At::new(*x, *y)).collect();
            let kept = within(&corners, low, high).into_iter().map(|at| [at.x + shift[0], at.y + shift[1]]);
            let kept: Vec<[f64; 2]> = kept.collect();
            (kept.len() > 2).then_some(PlanarShape::Polygon(kept))
        }
        PlanarShape::Circle { center: [x, y], radius } => {
            let is_inside = (low[0]..=high[0]).contains(x) && (low[1]..=high[1]).contains(y);
            is_inside.then_some(PlanarShape::Circle { center: [x + shift[0], y + shift[1]], radius: *radius })
        }
        PlanarShape::Compound(parts) => {
            let parts: Vec<PlanarShape> = parts.iter().filter_map(|part| moved(part, [low, high], shift)).collect();
            (!parts.is_empty()).then_some(PlanarShape::Compound(parts))
        }
        PlanarShape::HalfPlane { point: [x, y], normal } => {
            Some(PlanarShape::HalfPlane { point: [x + shift[0], y + shift[1]], normal: *normal })
        }
    }
}
