//! What parts at rest cover over the arm, and where a sensor tells one edge.

use super::super::canvas::{Align, At, GREEN, INK, MUTED, Pen};
use super::super::legend::Swatch;
use super::mark::{self, Mark};
use super::{PAGE, Picture, SIDE, Setting};
use crate::answer::{Sensor, SensorWindow};
use crate::report::{decimal, phrase};

const ROW: f64 = 24.0;
const BAR: f64 = 13.0;

/// Draws the footprints of the limit set whose window is proved, else of the first; `None` if none was found.
pub(super) fn draw(setting: &Setting) -> Option<Picture> {
    let sensors = &setting.answer.sensors;
    let is_proved = |sensor: &&Sensor| sensor.windows.iter().any(|window| window.proved.is_some());
    let sensor = sensors.iter().find(is_proved).or_else(|| sensors.first())?;
    let rows: Vec<_> =
        setting.lanes.iter().filter_map(|lane| Some((lane, sensor.footprints.get(&lane.edge)?))).collect();
    let window = setting.answer.window().or_else(|| sensor.windows.first());
    let none = if window.is_none() { "no place on the arm is covered by one edge only" } else { "" };
    let about = "what parts at rest cover, from the left end of the edge to its right end";
    let mut picture = Picture::new("Sensor", &[about, none]);
    let top = picture.bottom + 20.0;
    let bottom = top + ROW * rows.len().max(1) as f64 + 6.0;
    let ends = [SIDE, PAGE - SIDE].map(|x| At::new(x, top));
    picture.canvas.line(&ends, Pen::stroke("#d5d9dd", 1.0));
    let title = format!("along the arm, {}", setting.unit());
    if let Some(window) = window {
        draw_window(&mut picture, setting, window, [top, bottom]);
    }
    setting.radii.draw_across(&mut picture.canvas, bottom, top, &title);
    for (row, (lane, ends)) in rows.into_iter().enumerate() {
        let y = top + ROW * (row as f64 + 0.5) + 3.0;
        let name = At::new(SIDE + 2.0, y);
        lane.hue.dot(&mut picture.canvas, At::new(name.x + 3.0, y), 4.0);
        picture.canvas.text(At::new(name.x + 12.0, y), Align::Left, 12.0, INK, true, &format!("edge {}", lane.edge));
        let x = ends.map(|end| setting.radii.at(end));
        picture.canvas.polygon(&mark::rectangle(x, [y - BAR / 2.0, y + BAR / 2.0]), lane.hue.bar());
        let pen = Pen::fill(MUTED, 0.75).outlined(MUTED, 1.0);
        picture.legend.add(Swatch::Throw(Mark::Area(pen)), "covered in the limit set, in the color of the edge");
    }
    if let Some(window) = window {
        draw_place(&mut picture, setting, window, [top, bottom]);
    }
    picture.bottom = bottom + 34.0;
    Some(picture)
}

fn draw_window(picture: &mut Picture, setting: &Setting, window: &SensorWindow, y: [f64; 2]) {
    let area = |range: [f64; 2]| mark::rectangle(range.map(|end| setting.radii.at(end)), y);
    let pen = Pen::fill(GREEN, 0.1).outlined(GREEN, 1.0).dashed();
    picture.canvas.polygon(&area(window.range), pen);
    picture.legend.add(Swatch::Throw(Mark::Area(pen)), "covered by nothing else in the limit set");
    if let Some(proved) = window.proved {
        let pen = Pen::fill(GREEN, 0.35).outlined(GREEN, 1.4);
        picture.canvas.polygon(&area(proved), pen);
        picture.legend.add(Swatch::Throw(Mark::Area(pen)), "proved");
    }
}

fn draw_place(picture: &mut Picture, setting: &Setting, window: &SensorWindow, [top, bottom]: [f64; 2]) {
    let x = setting.radii.at(window.at);
    let pen = Pen::stroke(GREEN, 2.0);
    picture.canvas.line(&[At::new(x, top), At::new(x, bottom)], pen);
    mark::sensor(&mut picture.canvas, At::new(x, bottom - 9.0), true);
    picture.legend.add(Swatch::Throw(Mark::Sensor(true)), "place for the sensor");
    let edges: Vec<String> = window.edges.iter().map(ToString::to_string).collect();
    let word = if edges.len() == 1 { "edge" } else { "edges" };
    let which = phrase::joined(&edges, "or");
    let proved = if window.proved.is_some() { "" } else { ", not proved" };
    let text =
        format!("sensor at {} {}: covered by {word} {which} only{proved}", decimal::near(window.at, 4), setting.unit());
    let half = 3.4 * text.chars().count() as f64;
    let middle = x.clamp(SIDE + half, PAGE - SIDE - half);
    picture.canvas.text(At::new(middle, top - 9.0), Align::Middle, 12.0, INK, true, &text);
}
