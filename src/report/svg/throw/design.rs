//! The settings of the arm that were tried: a map, or a curve if only one control was varied.

use super::super::canvas::{Align, At, BLUE, Canvas, GREEN, INK, MUTED, ORANGE, PINK, Pen};
use super::super::legend::Swatch;
use super::mark::{self, Mark};
use super::scale::{Scale, clamped};
use super::{PAGE, Picture, SIDE};
use crate::answer::{Design, Setting, SettingKind};
use crate::exact::to_f64;
use crate::report::decimal;

const HEIGHT: f64 = 300.0;
const LOW: f64 = 180.0;
const AXIS: f64 = 60.0;
/// Right of the map, for the key of rates.
const KEY: f64 = 104.0;
const SHADES: usize = 8;
const RATE: &str = "parts delivered a second";
const KINDS: [SettingKind; 5] =
    [SettingKind::Feeder, SettingKind::Blind, SettingKind::Several, SettingKind::Lost, SettingKind::Open];

/// Draws the settings; `None` if none were tried.
pub(super) fn draw(shown: &super::Setting) -> Option<Picture> {
    let design = shown.answer.design.as_ref()?;
    let is_complete = design.settings.len() == design.offsets.len() * design.releases.len();
    if design.settings.is_empty() || !is_complete {
        return None;
    }
    let best = design.best.as_ref().filter(|best| best.place < design.settings.len());
    let recommended = best.map(|best| {
        let (release, offset) = at(design, best.place);
        let proved = if best.is_proved { "proved" } else { "not proved" };
        let (release, offset) = (decimal::near(release, 4), decimal::near(offset, 4));
        format!("recommended: {release}\u{b0}/s with the offset {offset} {}, {proved}", shown.unit())
    });
    let none = design.why_none.as_deref().filter(|_| best.is_none()).unwrap_or("");
    let mut picture = Picture::new("Settings of the arm", &[recommended.as_deref().unwrap_or(""), none]);
    let (wide, tall) = (design.releases.len(), design.offsets.len());
    let is_curve = (wide == 1) != (tall == 1);
    let marks = if is_curve { draw_curve(&mut picture, shown, design) } else { draw_map(&mut picture, shown, design) };
    let thrower = shown.toss.thrower;
    let own = (to_f64(&thrower.release_deg_per_s), to_f64(&thrower.offset));
    if let Some(own) = marks(own) {
        mark::own(&mut picture.canvas, own);
        picture.legend.add(Swatch::Throw(Mark::Own), "the case as it is");
    }
    if let Some(place) = best.and_then(|best| marks(at(design, best.place))) {
        mark::best(&mut picture.canvas, place);
        picture.legend.add(Swatch::Throw(Mark::Best), "recommended");
    }
    Some(picture)
}

/// Release speed and offset of a setting.
fn at(design: &Design, place: usize) -> (f64, f64) {
    let wide = design.releases.len();
    (design.releases[place % wide], design.offsets[place / wide])
}

/// Feed rate of each setting (1/s); zero where nothing is fed.
fn rates(design: &Design) -> Vec<f64> {
    let is_fed = |setting: &&Setting| setting.kind == SettingKind::Feeder && setting.rate().is_finite();
    design.settings.iter().map(|setting| Some(setting).filter(is_fed).map_or(0.0, Setting::rate).max(0.0)).collect()
}

fn meaning(kind: SettingKind) -> &'static str {
    match kind {
        SettingKind::Feeder => "one pattern, which a sensor reads",
        SettingKind::Blind => "one pattern that no sensor reads",
        SettingKind::Several => "several patterns",
        SettingKind::Lost => "orbits end",
        SettingKind::Open => "not tried",
    }
}

/// `share` of the highest rate.
fn pen(kind: SettingKind, share: f64) -> Pen {
    let shade = (clamped(share) * (SHADES - 1) as f64).round() / (SHADES - 1) as f64;
    match kind {
        SettingKind::Feeder => Pen::fill(GREEN, 0.15 + 0.85 * shade),
        SettingKind::Blind => Pen::fill(BLUE, 0.55),
        SettingKind::Several => Pen::fill(ORANGE, 0.75),
        SettingKind::Lost => Pen::fill(MUTED, 0.55),
        SettingKind::Open => Pen::fill("#ffffff", 1.0),
    }
}

/// Where a setting is on the page, if it is within the picture.
type Place = Box<dyn Fn((f64, f64)) -> Option<At>>;

fn draw_map(picture: &mut Picture, shown: &super::Setting, design: &Design) -> Place {
    let (top, bottom) = (picture.bottom + 16.0, picture.bottom + 16.0 + HEIGHT);
    let (left, right) = (SIDE + AXIS, PAGE - SIDE - KEY);
    let (release_ends, offset_ends) = (borders(&design.releases), borders(&design.offsets));
    let axis = |ends: &[f64], page| Scale { values: [ends[0], ends[ends.len() - 1]], page, least_step: 0.0 };
    let (across, up) = (axis(&release_ends, [left, right]), axis(&offset_ends, [bottom, top]));
    let rates = rates(design);
    let most = rates.iter().copied().fold(0.0, f64::max);
    for (place, tried) in design.settings.iter().enumerate() {
        let (column, row) = (place % design.releases.len(), place / design.releases.len());
        let x = [column, column + 1].map(|k| across.at(release_ends[k]));
        let y = [row, row + 1].map(|k| up.at(offset_ends[k]));
        let pen = pen(tried.kind, rates[place] / most);
        picture.canvas.polygon(&mark::rectangle(x, y), pen.outlined("#ffffff", 0.5));
    }
    axes(&mut picture.canvas, shown, &across, &up);
    explain(picture, design);
    if most > 0.0 {
        draw_key(&mut picture.canvas, right + 26.0, [top, bottom], most);
    }
    picture.bottom = bottom + 36.0;
    Box::new(move |(release, offset)| {
        (across.holds(release) && up.holds(offset)).then(|| At::new(across.at(release), up.at(offset)))
    })
}

fn axes(canvas: &mut Canvas, shown: &super::Setting, across: &Scale, up: &Scale) {
    across.draw_across(canvas, up.page[0], up.page[0], "release speed, \u{b0}/s");
    up.draw_up(canvas, across.page[0], across.page[0], &format!("offset, {}", shown.unit()));
}

fn draw_key(canvas: &mut Canvas, left: f64, [top, bottom]: [f64; 2], most: f64) {
    let height = 0.5 * (bottom - top) / SHADES as f64;
    for shade in 0..SHADES {
        let low = top + 22.0 + height * (SHADES - shade) as f64;
        let pen = pen(SettingKind::Feeder, shade as f64 / (SHADES - 1) as f64);
        canvas.polygon(&mark::rectangle([left, left + 16.0], [low - height, low]), pen.outlined("#ffffff", 0.5));
    }
    for (share, y) in [(1.0, top + 22.0), (0.0, top + 22.0 + height * SHADES as f64)] {
        canvas.text(At::new(left + 21.0, y), Align::Left, 11.0, MUTED, false, &decimal::near(share * most, 3));
    }
    canvas.text(At::new(left, top + 4.0), Align::Left, 11.0, MUTED, false, "parts/s");
}

/// The feed rate over the control that was varied.
fn draw_curve(picture: &mut Picture, shown: &super::Setting, design: &Design) -> Place {
    let is_release = design.releases.len() > 1;
    let (values, title, fixed) = if is_release {
        let fixed = format!("offset {} {}", decimal::near(design.offsets[0], 4), shown.unit());
        (&design.releases, "release speed, \u{b0}/s".to_owned(), fixed)
    } else {
        let fixed = format!("release speed {}\u{b0}/s", decimal::near(design.releases[0], 4));
        (&design.offsets, format!("offset, {}", shown.unit()), fixed)
    };
    let (top, bottom) = (picture.bottom + 16.0, picture.bottom + 16.0 + LOW);
    let (left, right) = (SIDE + AXIS, PAGE - SIDE);
    let rates = rates(design);
    let ends = borders(values);
    let across = Scale { values: [ends[0], ends[ends.len() - 1]], page: [left, right], least_step: 0.0 };
    let up = Scale::covering(rates.iter().copied().chain([0.0]), [bottom - 10.0, top]);
    across.draw_across(&mut picture.canvas, bottom, top, &format!("{title} ({fixed})"));
    up.draw_up(&mut picture.canvas, left, right, RATE);
    for (place, tried) in design.settings.iter().enumerate() {
        let x = [place, place + 1].map(|k| across.at(ends[k]));
        picture.canvas.polygon(&mark::rectangle(x, [bottom - 8.0, bottom]), pen(tried.kind, 1.0));
    }
    let points: Vec<At> =
        values.iter().zip(&rates).map(|(value, rate)| At::new(across.at(*value), up.at(*rate))).collect();
    picture.canvas.line(&points, Pen::stroke(PINK, 1.4));
    picture.legend.add(Swatch::Line(Pen::stroke(PINK, 1.4)), RATE);
    for point in &points {
        picture.canvas.circle(*point, 2.6, Pen::fill(PINK, 1.0));
    }
    explain(picture, design);
    picture.bottom = bottom + 36.0;
    let values = values.clone();
    Box::new(move |(release, offset)| {
        let value = if is_release { release } else { offset };
        let nearest =
            (0..values.len()).min_by(|a, b| (values[*a] - value).abs().total_cmp(&(values[*b] - value).abs()))?;
        across.holds(value).then(|| At::new(across.at(value), points[nearest].y))
    })
}

fn explain(picture: &mut Picture, design: &Design) {
    for kind in KINDS.into_iter().filter(|kind| design.settings.iter().any(|tried| tried.kind == *kind)) {
        picture.legend.add(Swatch::Throw(Mark::Area(pen(kind, 0.6).outlined(INK, 0.6))), meaning(kind));
    }
}

/// Borders half-way between values, and as far beyond the outer ones.
fn borders(values: &[f64]) -> Vec<f64> {
    let (first, last) = (values[0], values[values.len() - 1]);
    let Some(second) = values.get(1) else {
        let about = if first == 0.0 { 1.0 } else { 0.1 * first.abs() };
        return vec![first - about, first + about];
    };
    let before = values[values.len() - 2];
    let inner = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    std::iter::once(first - 0.5 * (second - first)).chain(inner).chain([last + 0.5 * (last - before)]).collect()
}
