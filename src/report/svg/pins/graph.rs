//! The toppling graph, as in Fig. 8 of the paper: heights over the turn of the part, from one stable orientation to the next.

use super::super::canvas::{Align, At, BLUE, Canvas, INK, MUTED, Pen, RED};
use super::super::label::Labels;
use super::super::legend::{Legend, Swatch};
use super::super::view;
use super::action::{self, Rect};
use super::axis::{Upright, ticks};
use super::bars::{Bar, bars};
use super::diagram::MOST_LINES;
use super::planned::{self, planned};
use super::{PAGE, Picture, SIDE, Setting, row_length};
use crate::answer::{Curve, CurveKind, Orientation, PinAction};
use crate::report::decimal;

const HEIGHT: f64 = 290.0;
/// Left of the curves, for the axis.
const AXIS: f64 = 52.0;
/// So many turns beside each other.
const IN_A_ROW: usize = 6;
/// No turn is narrower.
const NARROWEST: f64 = 116.0;
/// So many curves of a kind are drawn in a panel.
const MOST_CURVES: usize = 24;
/// Where there are more curves, corners are not named.
const MOST_NAMES: usize = 24;
/// Points closer than this are one.
const FINE: f64 = 2.0;
/// Below a row, for its axis and the names of its panels.
const FOOT: f64 = 62.0;

/// Where the center of mass is over the pivot.
const TIPPING: Pen = Pen { fill: "none", opacity: 1.0, stroke: INK, width: 1.2, dash: "6 4" };

/// Draws the toppling graph, in several rows if there are many orientations.
pub(super) fn draw(setting: &Setting) -> Picture {
    let mut remark = vec!["turn of the part, counter-clockwise, from one stable orientation to the next".to_owned()];
    remark.extend(Some(super::left_out(setting)).filter(|text| !text.is_empty()));
    let most = setting.shown.iter().map(|orientation| step(&orientation.curves)).max().unwrap_or(1);
    if most > 1 {
        remark.push(format!("one curve in {most} where there are many"));
    }
    let mut picture = Picture::new("Toppling graph", &remark.join("; "));
    explain(&mut picture.legend, setting);
    let mut turned = 0.0;
    let points = setting.shown.iter().flat_map(|orientation| &orientation.curves).flat_map(|curve| &curve.points);
    let highest = points.filter_map(|[_, height]| setting.heights.share_near(*height));
    let highest = highest.fold(setting.heights.tallest, f64::max);
    for row in setting.shown.chunks(row_length(setting.shown.len(), IN_A_ROW)) {
        let top = picture.bottom + 24.0;
        let upright = Upright::new(top, top + HEIGHT, highest);
        draw_row(&mut picture, setting, upright, row, turned);
        turned += row.iter().map(|orientation| orientation.theta_1_deg).sum::<f64>();
        picture.bottom = upright.belt + FOOT;
    }
    picture
}

/// What the marks mean, in the same order whatever comes first.
fn explain(legend: &mut Legend, setting: &Setting) {
    let kinds = [CurveKind::Vertex(0), CurveKind::Radius, CurveKind::Rolling(0), CurveKind::Jamming(0)];
    let curves = || setting.shown.iter().flat_map(|orientation| &orientation.curves);
    for kind in kinds.into_iter().filter(|kind| curves().any(|curve| pen(curve.kind) == pen(*kind))) {
        legend.add(Swatch::Line(pen(kind)), meaning(kind));
    }
    legend.add(Swatch::Line(TIPPING), "\u{3b8}t: center of mass over the pivot");
    if !planned(setting.answer).is_empty() {
        legend.add(Swatch::Line(planned::pen()), "planned pin that the part may meet");
    }
    let intervals = || setting.shown.iter().flat_map(|orientation| &orientation.intervals);
    for action in action::ALL.into_iter().filter(|action| is_shaded(*action)) {
        if intervals().any(|interval| interval.action == action) {
            legend.add(action::swatch(action), action::meaning(action));
        }
    }
}

/// Heights that topple the part, or may do so.
fn is_shaded(action: Option<PinAction>) -> bool {
    matches!(action, Some(PinAction::Repeat | PinAction::Pass) | None)
}

fn draw_row(picture: &mut Picture, setting: &Setting, upright: Upright, row: &[&Orientation], turned: f64) {
    let (left, right) = (SIDE + AXIS, PAGE - SIDE);
    let mut panels = Vec::new();
    let (mut x, mut from) = (left, turned);
    for (orientation, width) in row.iter().zip(widths(row, right - left)) {
        let pixels = width / orientation.theta_1_deg.max(1e-9);
        panels.push(Panel { orientation, upright, x: [x, x + width], pixels, turned: from });
        (x, from) = (x + width, from + orientation.theta_1_deg);
    }
    for panel in &panels {
        panel.shade(&mut picture.canvas, &bars(panel.orientation, &setting.heights, &upright));
    }
    upright.draw(&mut picture.canvas, &setting.heights, left, right);
    for panel in &panels {
        panel.draw(&mut picture.canvas, setting);
    }
    turns(&mut picture.canvas, &panels, upright.belt);
}

/// Widths in proportion to the turns, but wide enough for a name.
fn widths(row: &[&Orientation], room: f64) -> Vec<f64> {
    let mut narrow = vec![false; row.len()];
    loop {
        let turns: f64 = row.iter().zip(&narrow).filter(|(_, narrow)| !**narrow).map(|(o, _)| o.theta_1_deg).sum();
        let left = room - NARROWEST * narrow.iter().filter(|narrow| **narrow).count() as f64;
        let width = |o: &Orientation| if turns > 0.0 { left * o.theta_1_deg / turns } else { NARROWEST };
        let before = narrow.clone();
        for (orientation, narrow) in row.iter().zip(&mut narrow) {
            *narrow |= width(orientation) < NARROWEST;
        }
        if narrow == before {
            return row.iter().zip(narrow).map(|(o, narrow)| if narrow { NARROWEST } else { width(o) }).collect();
        }
    }
}

/// The turn from one stable orientation to the next.
struct Panel<'a> {
    orientation: &'a Orientation,
    upright: Upright,
    x: [f64; 2],
    /// Pixels of a degree.
    pixels: f64,
    /// Degrees before this turn, from the first orientation on.
    turned: f64,
}

impl Panel<'_> {
    fn at_turn(&self, degrees: f64) -> f64 {
        (self.x[0] + degrees * self.pixels).clamp(self.x[0], self.x[1])
    }

    fn shade(&self, canvas: &mut Canvas, bars: &[Bar]) {
        for bar in bars.iter().filter(|bar| is_shaded(bar.action)) {
            action::fill(canvas, Rect::new(self.x, bar.y), bar.action);
        }
    }

    fn draw(&self, canvas: &mut Canvas, setting: &Setting) {
        let orientation = self.orientation;
        let (top, belt) = (self.upright.top, self.upright.belt);
        let frame = Pen::stroke(INK, 1.3);
        canvas.lines(&self.x.map(|x| vec![At::new(x, top), At::new(x, belt)]), frame);
        canvas.line(&self.x.map(|x| At::new(x, belt)), frame);
        let tipping = self.at_turn(orientation.theta_t_deg);
        canvas.line(&[At::new(tipping, top), At::new(tipping, belt)], TIPPING);

        let mut labels = Labels::within([At::new(self.x[0] + 2.0, top), At::new(self.x[1] - 2.0, belt - 2.0)]);
        labels.avoid(&column(self.x[0], top, belt));
        labels.avoid(&column(self.x[1], top, belt));
        labels.avoid(&column(tipping, top, belt));
        let planned = planned(setting.answer);
        for pin in planned.iter().take(MOST_LINES).filter(|pin| pin.met.contains(&orientation.edge)) {
            let y = self.upright.y(setting.heights.share_of(pin.height));
            let line = self.x.map(|x| At::new(x, y));
            canvas.line(&line, planned::pen());
            labels.avoid(&view::along(line[0], line[1]));
        }
        self.curves(canvas, setting, &mut labels);
        labels.draw(canvas);
        self.title(canvas);
    }

    fn curves(&self, canvas: &mut Canvas, setting: &Setting, labels: &mut Labels) {
        let curves = &self.orientation.curves;
        let step = step(curves);
        let mut lines: Vec<(CurveKind, Vec<At>)> = Vec::new();
        for curve in curves.iter().filter(|curve| number(curve.kind).is_none_or(|n| n % step == 0)) {
            let line = self.line(curve, setting);
            if line.len() > 1 {
                lines.push((curve.kind, line));
            }
        }
        // those that decide come last, over the others
        lines.sort_by_key(|(kind, _)| matches!(kind, CurveKind::Rolling(_) | CurveKind::Jamming(_)));
        for (kind, line) in &lines {
            let pen = pen(*kind);
            canvas.line(line, Pen::stroke("#ffffff", pen.width + 2.0));
            canvas.line(line, pen);
            labels.avoid(&line.windows(2).flat_map(|ends| view::along(ends[0], ends[1])).collect::<Vec<_>>());
        }
        let is_crowded = lines.len() > MOST_NAMES;
        for (kind, line) in lines.iter().rev().filter(|(kind, _)| !(is_crowded && matches!(kind, CurveKind::Vertex(_))))
        {
            let anchors = [0.5, 0.35, 0.65, 0.2, 0.8].map(|share| line.get((share * line.len() as f64) as usize));
            let colour = if *kind == CurveKind::Radius { INK } else { pen(*kind).stroke };
            labels.offer(anchors.into_iter().flatten().copied().collect(), colour, name(*kind));
        }
    }

    /// The curve on the page, without points that cannot be told apart.
    fn line(&self, curve: &Curve, setting: &Setting) -> Vec<At> {
        let mut line: Vec<At> = Vec::new();
        let last = curve.points.len().saturating_sub(1);
        for (index, [turn, height]) in curve.points.iter().enumerate() {
            let Some(share) = setting.heights.share_near(*height) else { continue };
            let at = At::new(self.at_turn(*turn), self.upright.y(share));
            if index == last || line.last().is_none_or(|before| at.minus(*before).length() >= FINE) {
                line.push(at);
            }
        }
        line
    }

    fn title(&self, canvas: &mut Canvas) {
        let Orientation { edge, next, theta_t_deg, theta_1_deg, .. } = self.orientation;
        let at = At::new((self.x[0] + self.x[1]) / 2.0, self.upright.belt + 31.0);
        canvas.text(at, Align::Middle, 12.0, INK, true, &format!("edge {edge} \u{2192} {next}"));
        let [tipping, landing] = [theta_t_deg, theta_1_deg].map(|degrees| decimal::near(*degrees, 3));
        let turns = format!("\u{3b8}t {tipping}\u{b0}, \u{3b8}1 {landing}\u{b0}");
        canvas.text(At::new(at.x, at.y + 15.0), Align::Middle, 11.0, MUTED, false, &turns);
    }
}

/// The axis of turns below a row of panels, counted from the first orientation.
fn turns(canvas: &mut Canvas, panels: &[Panel], belt: f64) {
    let (Some(first), Some(last)) = (panels.first(), panels.last()) else { return };
    let end = last.turned + last.orientation.theta_1_deg;
    let mut marks = Vec::new();
    let mut free = 0.0;
    for degrees in ticks(end, (end - first.turned) / 12.0) {
        let panel = panels.iter().rev().find(|panel| panel.turned <= degrees);
        let Some(panel) = panel else { continue };
        let x = panel.at_turn(degrees - panel.turned);
        marks.push(vec![At::new(x, belt), At::new(x, belt + 5.0)]);
        let text = format!("{}\u{b0}", decimal::near(degrees, 6));
        if x > free {
            canvas.text(At::new(x, belt + 13.0), Align::Middle, 11.0, MUTED, false, &text);
            free = x + 7.0 * text.chars().count() as f64;
        }
    }
    canvas.lines(&marks, Pen::stroke(INK, 1.0));
}

/// One curve in so many is drawn.
fn step(curves: &[Curve]) -> usize {
    let of = |kind: fn(&CurveKind) -> bool| curves.iter().filter(|curve| kind(&curve.kind)).count();
    let most = [
        of(|kind| matches!(kind, CurveKind::Vertex(_))),
        of(|kind| matches!(kind, CurveKind::Rolling(_))),
        of(|kind| matches!(kind, CurveKind::Jamming(_))),
    ];
    most.into_iter().fold(1, |step, count| step.max(count.div_ceil(MOST_CURVES)))
}

fn number(kind: CurveKind) -> Option<usize> {
    match kind {
        CurveKind::Radius => None,
        CurveKind::Vertex(number) | CurveKind::Rolling(number) | CurveKind::Jamming(number) => Some(number),
    }
}

fn pen(kind: CurveKind) -> Pen {
    match kind {
        CurveKind::Radius => Pen { dash: "8 3 2 3", ..Pen::stroke(MUTED, 1.6) },
        CurveKind::Vertex(_) => Pen::stroke(INK, 0.9),
        CurveKind::Rolling(_) => Pen::stroke(RED, 2.4),
        CurveKind::Jamming(_) => Pen { dash: "5 2", ..Pen::stroke(BLUE, 2.2) },
    }
}

fn name(kind: CurveKind) -> String {
    match kind {
        CurveKind::Radius => "R".to_owned(),
        CurveKind::Vertex(corner) => format!("V{corner}"),
        CurveKind::Rolling(edge) => format!("H{edge}"),
        CurveKind::Jamming(edge) => format!("J{edge}"),
    }
}

fn meaning(kind: CurveKind) -> &'static str {
    match kind {
        CurveKind::Radius => "R: height of the center of mass",
        CurveKind::Vertex(_) => "V: height of a corner",
        CurveKind::Rolling(_) => "H: a pin on this edge must be higher to roll the part",
        CurveKind::Jamming(_) => "J: a lower pin on this edge may jam it",
    }
}

fn column(x: f64, top: f64, belt: f64) -> Vec<At> {
    view::along(At::new(x, top), At::new(x, belt))
}
