//! Maps of where methods fail.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, ORANGE, Pen, RED, SKY};
use super::super::legend::{Legend, Swatch};
use super::axes::plain;
use super::{GAP, PAGE, SIDE, conditions, head};
use crate::answer::{Chart, ChartMap, ChartTile};
use crate::report::decimal::percent_of;
use crate::report::markdown::distinct;

/// Left of tiles, for the numbers of their axis, and below them.
const LEFT: f64 = 52.0;
const FOOT: f64 = 40.0;
const HEADING: f64 = 36.0;
const ROW: f64 = 30.0;

/// Outcomes: colour, and the sign of a tile of which all runs came out so.
const OUTCOMES: [(&str, &str); 3] = [(SKY, ""), (ORANGE, "?"), (RED, "×")];

/// A stability map, a panel for each method; `None` if nothing of it was measured.
#[must_use]
pub fn failures(chart: &Chart, map: ChartMap) -> Option<String> {
    let tiles: Vec<&ChartTile> = chart.tiles.iter().filter(|tile| tile.map == map).collect();
    let methods = distinct(tiles.iter().map(|tile| tile.method.as_str()));
    if methods.is_empty() {
        return None;
    }
    let values = |of: fn(&ChartTile) -> f64| {
        let mut values: Vec<f64> = tiles.iter().map(|tile| of(tile)).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let axes = [values(|tile| tile.x), values(|tile| tile.y)];
    let mut page = Canvas::new();
    let title = format!("Where methods fail: {}", map.title());
    let mut bottom = head(&mut page, &title, &conditions(chart));
    let wide = (PAGE - 2.0 * SIDE - GAP) / 2.0;
    let high = HEADING + ROW * axes[1].len() as f64 + FOOT;
    for row in methods.chunks(2) {
        for (column, method) in row.iter().enumerate() {
            let shown: Vec<&ChartTile> = tiles.iter().copied().filter(|tile| tile.method == *method).collect();
            panel(&mut page, map, method, &shown, &axes, At::new(SIDE + column as f64 * (wide + GAP), bottom), wide);
        }
        bottom += high + 8.0;
    }
    let mut legend = Legend::default();
    legend.add(Swatch::Band(SKY), "succeeds");
    legend.add(Swatch::Band(ORANGE), "?: says that there is no single answer");
    legend.add(Swatch::Band(RED), "×: fails, or is wrong");
    bottom = legend.draw(&mut page, PAGE, bottom);
    Some(page.finish(PAGE, bottom + 4.0, &title, &format!("{title}; {} against {}", map.axes()[1], map.axes()[0])))
}

fn panel(
    page: &mut Canvas,
    map: ChartMap,
    method: &str,
    tiles: &[&ChartTile],
    axes: &[Vec<f64>; 2],
    low: At,
    wide: f64,
) {
    let [across, up] = axes;
    let cell = (wide - LEFT) / across.len() as f64;
    let corner = At::new(low.x + LEFT, low.y + HEADING);
    let foot = corner.y + ROW * up.len() as f64;
    page.text(At::new(low.x, low.y + 6.0), Align::Left, 12.5, INK, true, method);
    page.text(At::new(low.x, corner.y - 12.0), Align::Left, 11.0, MUTED, false, map.axes()[1]);
    for (index, value) in across.iter().enumerate() {
        let at = At::new(corner.x + (index as f64 + 0.5) * cell, foot + 12.0);
        page.text(at, Align::Middle, 10.5, MUTED, false, &named(*value));
    }
    for (index, value) in up.iter().enumerate() {
        let at = At::new(corner.x - 6.0, foot - (index as f64 + 0.5) * ROW);
        page.text(at, Align::Right, 10.5, MUTED, false, &named(*value));
    }
    let middle = At::new(corner.x + 0.5 * (wide - LEFT), foot + 28.0);
    page.text(middle, Align::Middle, 11.0, MUTED, false, map.axes()[0]);
    for tile in tiles {
        let place = |values: &[f64], value: f64| values.iter().position(|known| *known == value);
        let (Some(column), Some(row)) = (place(across, tile.x), place(up, tile.y)) else { continue };
        let at = At::new(corner.x + column as f64 * cell, foot - (row as f64 + 1.0) * ROW);
        draw(page, tile, at, [cell - 1.5, ROW - 1.5]);
    }
}

/// A number of an axis; zero has no logarithm.
fn named(value: f64) -> String {
    if value > 0.0 && (value / 10_f64.powf(value.log10().floor())).fract() == 0.0 {
        plain(value)
    } else {
        crate::report::decimal::near(value, 3)
    }
}

/// A tile in stripes as wide as the shares of its runs.
fn draw(page: &mut Canvas, tile: &ChartTile, at: At, [wide, high]: [f64; 2]) {
    let counts = [tile.succeeded, tile.ambiguous, tile.failed];
    let of: u64 = counts.iter().sum();
    let mut left = at.x;
    for (count, (colour, sign)) in counts.into_iter().zip(OUTCOMES) {
        let width = wide * count as f64 / (of as f64).max(1.0);
        if count > 0 {
            let corners = [(left, at.y), (left + width, at.y), (left + width, at.y + high), (left, at.y + high)];
            page.polygon(&corners.map(|(x, y)| At::new(x, y)), Pen::fill(colour, 0.85));
        }
        if count == of && !sign.is_empty() {
            page.text(At::new(at.x + 0.5 * wide, at.y + 0.5 * high), Align::Middle, 13.0, INK, true, sign);
        }
        left += width;
    }
    if tile.succeeded > 0 && tile.succeeded < of {
        let sign = if tile.failed >= tile.ambiguous { OUTCOMES[2].1 } else { OUTCOMES[1].1 };
        let share = format!("{}, else {sign}", percent_of(tile.succeeded, of));
        page.text(At::new(at.x + 0.5 * wide, at.y + 0.5 * high), Align::Middle, 10.5, INK, false, &share);
    }
}
