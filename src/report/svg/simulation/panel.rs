//! One view of a run.

use super::super::canvas::{At, Canvas, GREEN, INK, MUTED, Pen};
use super::super::label::Labels;
use super::super::legend::{Legend, Swatch};
use super::super::scene::{quartered, scale_bar};
use super::super::view::along;
use super::clip;
use super::shades::{PATH, Shades};
use super::snapshots::Snapshots;
use crate::report::decimal::near;
use crate::report::motion::{Outline, Run, Shown, View};

const FIXED: &str = "#eceff1";
const HATCH: &str = "#c2c8ce";
/// Times are written beside so many bodies, not more.
const MOST_TIMED: usize = 3;
const COM: f64 = 5.0;
/// Least distance of two places whose times are written, in pixels.
const APART: f64 = 7.0;
/// Length of the arrow of a finger, in pixels.
const FINGER: f64 = 40.0;
/// Below a view, for its scale.
pub(super) const FOOT: f64 = 22.0;

/// What a view shows, in m.
pub(super) struct Panel<'a> {
    pub(super) view: View,
    /// Outlines of what is fixed.
    fixed: Vec<Outline>,
    /// Outlines of each body at each chosen time, and its center of mass.
    bodies: Vec<Vec<(Vec<Outline>, [f64; 2])>>,
    times: Vec<f64>,
    paths: Vec<Vec<[f64; 2]>>,
    names: Vec<&'a str>,
    /// Where fingers press, and in which direction.
    fingers: Vec<[[f64; 2]; 2]>,
    low: [f64; 2],
    high: [f64; 2],
}

/// Where a view lies on the page, and how many pixels a metre has there.
pub(super) struct Room {
    pub(super) low: At,
    pub(super) high: At,
    pub(super) scale: f64,
}

impl Room {
    /// Where points (m) are drawn, with `middle` in the middle.
    pub(super) fn centered(&self, middle: [f64; 2]) -> impl Fn([f64; 2]) -> At + use<> {
        let center = At::new((self.low.x + self.high.x) / 2.0, (self.low.y + self.high.y) / 2.0);
        let scale = self.scale;
        move |[x, y]: [f64; 2]| At::new(center.x + (x - middle[0]) * scale, center.y - (y - middle[1]) * scale)
    }
}

impl<'a> Panel<'a> {
    pub(super) fn new<S: Shown>(run: &Run<'a, S>, snapshots: &Snapshots<S>, view: View) -> Self {
        let world = run.world;
        let fixed: Vec<Outline> = world.fixed.iter().flat_map(|fixed| S::outlines(&fixed.shape, None, view)).collect();
        let frames: Vec<_> = snapshots.drawn.iter().map(|index| snapshots.frames[*index]).collect();
        let bodies = world.bodies.iter().enumerate().map(|(number, body)| {
            let pose = |pose: &S::Pose| (S::outlines(&body.shape, Some(pose), view), view.of(pose.as_ref()));
            frames.iter().map(|frame| pose(&frame.poses[number])).collect::<Vec<_>>()
        });
        let bodies: Vec<_> = bodies.collect();
        let paths: Vec<Vec<[f64; 2]>> =
            (0..bodies.len()).map(|body| snapshots.path(body).map(|pose| view.of(pose)).collect()).collect();
        let moving = bodies.iter().flatten().flat_map(|(outlines, _)| outlines).flat_map(extent);
        let (mut low, mut high) = bounds(moving.chain(paths.iter().flatten().copied()));
        // obstacles are shown as far as they are near
        let size = (high[0] - low[0]).max(high[1] - low[1]).max(1e-6);
        let [least, most] = [low.map(|end| end - 0.15 * size), high.map(|end| end + 0.15 * size)];
        for corner in fixed.iter().flat_map(extent) {
            for axis in 0..2 {
                low[axis] = low[axis].min(corner[axis].max(least[axis]));
                high[axis] = high[axis].max(corner[axis].min(most[axis]));
            }
        }
        for axis in 0..2 {
            let spare = 0.06 * size + 0.5 * (0.35 * size - (high[axis] - low[axis])).max(0.0);
            low[axis] -= spare;
            high[axis] += spare;
        }
        let names = world.bodies.iter().map(|body| body.name.as_str()).collect();
        let fingers = world.bodies.iter().filter_map(|body| body.finger.map(|finger| [finger.at, finger.direction]));
        let times = frames.iter().map(|frame| frame.time).collect();
        Self { view, fixed, bodies, times, paths, names, fingers: fingers.collect(), low, high }
    }

    /// Width, in m.
    pub(super) fn wide(&self) -> f64 {
        self.high[0] - self.low[0]
    }

    /// Height, in m.
    pub(super) fn high(&self) -> f64 {
        self.high[1] - self.low[1]
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, legend: &mut Legend, room: &Room) {
        let middle = [(self.low[0] + self.high[0]) / 2.0, (self.low[1] + self.high[1]) / 2.0];
        let place = room.centered(middle);
        let mut labels = Labels::within([room.low, room.high]).rimmed();
        for outline in &self.fixed {
            obstacle(canvas, outline, room, &place);
            legend.add(Swatch::Band(HATCH), "fixed");
        }
        let last = self.times.len().saturating_sub(1).max(1);
        for index in 0..self.times.len() {
            for (number, poses) in self.bodies.iter().enumerate() {
                let shade = Shades::of(number).shade(index as f64 / last as f64);
                let is_end = index + 1 == self.times.len();
                let width = if is_end || index == 0 { 2.0 } else { 1.3 };
                let pen = Pen::fill(shade, if is_end { 0.35 } else { 0.12 }).outlined(shade, width);
                poses[index].0.iter().for_each(|outline| self.body(canvas, outline, pen, room, &place, &mut labels));
            }
        }
        for path in &self.paths {
            let line: Vec<At> = path.iter().map(|point| place(*point)).collect();
            canvas.line(&line, Pen::stroke(PATH, 1.0).dashed());
            labels.avoid(&line);
        }
        for [at, [x, y]] in &self.fingers {
            let tip = place(*at);
            canvas.arrow(At::new(tip.x - FINGER * x, tip.y + FINGER * y), tip, GREEN, 2.5);
            legend.add(Swatch::Line(Pen::stroke(GREEN, 2.5)), "finger on a straight guide");
        }
        for (number, poses) in self.bodies.iter().enumerate() {
            self.times(canvas, &mut labels, number, poses, &place);
        }
        labels.draw(canvas);
        let rim = [room.low, At::new(room.high.x, room.low.y), room.high, At::new(room.low.x, room.high.y)];
        canvas.polygon(&rim, Pen::stroke("#d5d9dd", 1.0));
        let end = At::new(room.high.x - 1.0, room.high.y + FOOT);
        scale_bar(canvas, end, 1.0 / room.scale, "m");
    }

    fn body(
        &self,
        canvas: &mut Canvas,
        outline: &Outline,
        pen: Pen,
        room: &Room,
        place: &impl Fn([f64; 2]) -> At,
        labels: &mut Labels,
    ) {
        match outline {
            Outline::Polygon(corners) => {
                let corners: Vec<At> = corners.iter().map(|corner| place(*corner)).collect();
                canvas.polygon(&corners, pen);
                let next = corners.iter().cycle().skip(1);
                corners.iter().zip(next).for_each(|(from, to)| labels.avoid(&along(*from, *to)));
            }
            Outline::Disc { center, radius, mark } => {
                let (center, mark, radius) = (place(*center), place(*mark), radius * room.scale);
                canvas.circle(center, radius, pen);
                canvas.line(&[center, mark], Pen::stroke(pen.stroke, pen.width));
                canvas.circle(mark, 2.2, Pen::fill(pen.stroke, 1.0));
                let rim = (0..72).map(|k| center.along(At::unit(f64::from(k) * std::f64::consts::PI / 36.0), radius));
                labels.avoid(&rim.collect::<Vec<_>>());
            }
            Outline::Half { .. } => {}
        }
    }

    /// Centers of mass with their times; start and end are named.
    fn times(
        &self,
        canvas: &mut Canvas,
        labels: &mut Labels,
        number: usize,
        poses: &[(Vec<Outline>, [f64; 2])],
        place: &impl Fn([f64; 2]) -> At,
    ) {
        let (Some((_, first)), Some((_, last))) = (poses.first(), poses.last()) else { return };
        let centers: Vec<At> = poses.iter().map(|(_, center)| place(*center)).collect();
        let (start, end) = (place(*first), place(*last));
        for center in centers.iter().skip(1) {
            canvas.circle(*center, 1.8, Pen::fill(INK, 0.7));
        }
        let size = if self.names.len() > 8 { 0.6 } else { 1.0 };
        canvas.circle(start, 3.6 * size, Pen::fill("#ffffff", 1.0).outlined(INK, 1.4 * size));
        quartered(canvas, end, COM * size);
        labels.avoid(&centers);
        if self.names.len() > MOST_TIMED {
            return;
        }
        let time = |index: usize| format!("{} s", near(self.times.get(index).copied().unwrap_or(0.0), 3));
        let aside = At::new(1.0, 0.0);
        let whose = if self.names.len() > 1 {
            format!("{}: ", crate::report::motion::plain(self.names.get(number).copied().unwrap_or_default()))
        } else {
            String::new()
        };
        labels.want(start, aside, 9.0, INK, true, format!("{whose}start, {}", time(0)));
        if centers.len() > 1 {
            labels.want(end, aside, 9.0, INK, true, format!("{whose}end, {}", time(centers.len() - 1)));
        }
        // what is at the place of another needs no second time
        let mut named = vec![start, end];
        for (index, center) in centers.iter().enumerate().skip(1).take(centers.len().saturating_sub(2)) {
            if named.iter().all(|other| center.minus(*other).length() > APART) {
                labels.offer_near(*center, aside, 6.0, MUTED, time(index));
                named.push(*center);
            }
        }
    }
}

/// Something fixed, within its room.
pub(super) fn obstacle(canvas: &mut Canvas, outline: &Outline, room: &Room, place: &impl Fn([f64; 2]) -> At) {
    let frame = [room.low, At::new(room.high.x, room.low.y), room.high, At::new(room.low.x, room.high.y)];
    let polygon = match outline {
        Outline::Polygon(corners) => {
            let corners: Vec<At> = corners.iter().map(|corner| place(*corner)).collect();
            clip::within(&corners, room.low, room.high)
        }
        Outline::Disc { center, radius, .. } if radius * room.scale < 2.5 => {
            let center = place(*center);
            if clip::within(&[center], room.low, room.high).is_empty() {
                return;
            }
            canvas.circle(center, 2.5, Pen::fill(INK, 1.0));
            return;
        }
        Outline::Disc { center, radius, .. } => {
            let center = place(*center);
            let rim = (0..96)
                .map(|k| center.along(At::unit(f64::from(k) * std::f64::consts::PI / 48.0), radius * room.scale));
            clip::within(&rim.collect::<Vec<_>>(), room.low, room.high)
        }
        Outline::Half { point, normal } => clip::beyond(&frame, place(*point), At::new(-normal[0], normal[1])),
    };
    if polygon.len() < 3 {
        return;
    }
    canvas.polygon(&polygon, Pen::fill(FIXED, 1.0));
    canvas.lines(&clip::hatching(&polygon), Pen::stroke(HATCH, 0.8));
    canvas.polygon(&polygon, Pen::stroke(MUTED, 1.2));
}

/// Points that a view of an outline must hold.
pub(super) fn extent(outline: &Outline) -> Vec<[f64; 2]> {
    match outline {
        Outline::Polygon(corners) => corners.clone(),
        Outline::Disc { center: [x, y], radius, .. } => vec![[x - radius, y - radius], [x + radius, y + radius]],
        Outline::Half { .. } => Vec::new(),
    }
}

fn bounds(points: impl Iterator<Item = [f64; 2]>) -> ([f64; 2], [f64; 2]) {
    let start = ([f64::MAX; 2], [f64::MIN; 2]);
    let (low, high) = points.fold(start, |(low, high), point| {
        ([0, 1].map(|axis| low[axis].min(point[axis])), [0, 1].map(|axis| high[axis].max(point[axis])))
    });
    if low[0] > high[0] { ([-0.5; 2], [0.5; 2]) } else { (low, high) }
}
