//! Marks on the page, in pixels: strokes and letters have the same size whatever the part's units.

use svg::node::element::{Circle, Description, Group, Path, Rectangle, Text, Title};
use svg::{Document, Node};

pub(super) const INK: &str = "#2b2f33";
pub(super) const MUTED: &str = "#6b7177";
pub(super) const PART: &str = "#eef1f4";
pub(super) const GREEN: &str = "#009e73";
pub(super) const BLUE: &str = "#0072b2";
pub(super) const SKY: &str = "#56b4e9";
pub(super) const PINK: &str = "#cc79a7";
pub(super) const ORANGE: &str = "#e69f00";
pub(super) const RED: &str = "#d55e00";

/// A point or vector on the page: x to the right, y downward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) struct At {
    pub(in crate::report) x: f64,
    pub(in crate::report) y: f64,
}

impl At {
    pub(in crate::report) fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at `radians` counter-clockwise from the x axis, as seen on the page.
    pub(super) fn unit(radians: f64) -> Self {
        Self::new(radians.cos(), -radians.sin())
    }

    /// The point `distance` away along `direction`.
    pub(super) fn along(self, direction: Self, distance: f64) -> Self {
        Self::new(self.x + direction.x * distance, self.y + direction.y * distance)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }

    pub(super) fn length(self) -> f64 {
        self.x.hypot(self.y)
    }

    /// The same direction with length one; zero stays zero.
    pub(super) fn normalized(self) -> Self {
        let length = self.length();
        if length > 0.0 { Self::new(self.x / length, self.y / length) } else { self }
    }

    /// Turned by +90 degrees as seen on the page (counter-clockwise).
    pub(super) fn turned(self) -> Self {
        Self::new(self.y, -self.x)
    }
}

/// How a mark is inked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pen {
    pub(super) fill: &'static str,
    pub(super) opacity: f64,
    pub(super) stroke: &'static str,
    pub(super) width: f64,
    pub(super) dash: &'static str,
}

impl Pen {
    pub(super) fn fill(colour: &'static str, opacity: f64) -> Self {
        Self { fill: colour, opacity, stroke: "none", width: 0.0, dash: "" }
    }

    pub(super) fn stroke(colour: &'static str, width: f64) -> Self {
        Self { fill: "none", opacity: 1.0, stroke: colour, width, dash: "" }
    }

    pub(super) fn outlined(self, stroke: &'static str, width: f64) -> Self {
        Self { stroke, width, ..self }
    }

    pub(super) fn dashed(self) -> Self {
        Self { dash: "4 3", ..self }
    }
}

/// Where a text's anchor is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Align {
    Left,
    Middle,
    Right,
}

/// The page.
pub(super) struct Canvas {
    marks: Vec<Box<dyn Node>>,
}

impl Canvas {
    pub(super) fn new() -> Self {
        Self { marks: Vec::new() }
    }

    pub(super) fn polygon(&mut self, points: &[At], pen: Pen) {
        self.path(&format!("{}Z", polyline(points)), pen);
    }

    pub(super) fn line(&mut self, points: &[At], pen: Pen) {
        self.path(&polyline(points), pen);
    }

    /// Many lines as one mark.
    pub(super) fn lines(&mut self, lines: &[Vec<At>], pen: Pen) {
        self.path(&lines.iter().map(|line| polyline(line)).collect::<String>(), pen);
    }

    pub(super) fn circle(&mut self, center: At, radius: f64, pen: Pen) {
        let circle = Circle::new().set("cx", number(center.x)).set("cy", number(center.y)).set("r", number(radius));
        self.add(circle, pen);
    }

    /// A circular arc, counter-clockwise by `sweep` radians from `start`; `closed` makes it a sector.
    pub(super) fn arc(&mut self, center: At, radius: f64, start: f64, sweep: f64, closed: bool, pen: Pen) {
        let mut d = String::new();
        // at most a third of a turn each, so that no flag of the path has to tell a long way from a short one
        let pieces = (sweep / 2.0).ceil().max(1.0);
        for piece in 0..=pieces as usize {
            let to = center.along(At::unit(start + sweep * piece as f64 / pieces), radius);
            if piece == 0 {
                d += &if closed { format!("M{}L{}", pair(center), pair(to)) } else { format!("M{}", pair(to)) };
            } else {
                d += &format!("A{0} {0} 0 0 0 {1}", number(radius), pair(to));
            }
        }
        self.path(&if closed { d + "Z" } else { d }, pen);
    }

    /// An arrow whose tip touches `tip`.
    pub(super) fn arrow(&mut self, tail: At, tip: At, colour: &'static str, width: f64) {
        let direction = tip.minus(tail).normalized();
        let (length, half) = (width * 4.2, width * 1.7);
        let base = tip.along(direction, -length);
        self.line(&[tail, tip.along(direction, -0.8 * length)], Pen::stroke(colour, width));
        let side = direction.turned();
        let notch = tip.along(direction, -0.8 * length);
        self.polygon(&[tip, base.along(side, half), notch, base.along(side, -half)], Pen::fill(colour, 1.0));
    }

    /// A text whose baseline's middle height is at `at`.
    pub(super) fn text(&mut self, at: At, align: Align, size: f64, colour: &'static str, bold: bool, content: &str) {
        self.marks.push(letters(at, align, size, colour, bold, content).into());
    }

    /// As [`Canvas::text`], with a light rim that keeps it legible over lines.
    pub(super) fn rimmed_text(
        &mut self,
        at: At,
        align: Align,
        size: f64,
        colour: &'static str,
        bold: bool,
        content: &str,
    ) {
        let text = letters(at, align, size, colour, bold, content)
            .set("paint-order", "stroke")
            .set("stroke", "#ffffff")
            .set("stroke-opacity", "0.85")
            .set("stroke-width", "3")
            .set("stroke-linejoin", "round");
        self.marks.push(text.into());
    }

    /// Adds another page `down` from the top of this one.
    pub(super) fn inset(&mut self, other: Self, down: f64) {
        let mut group = Group::new().set("transform", format!("translate(0 {})", number(down)));
        for mark in other.marks {
            group.append(mark);
        }
        self.marks.push(group.into());
    }

    pub(super) fn finish(self, width: f64, height: f64, title: &str, description: &str) -> String {
        let mut page = Document::new()
            .set("viewBox", format!("0 0 {} {}", number(width), number(height)))
            .set("width", number(width))
            .set("height", number(height))
            .set("font-family", "Helvetica, Arial, Liberation Sans, sans-serif")
            .set("role", "img")
            .add(Title::new(printable(title)))
            .add(Description::new().add(svg::node::Text::new(printable(description))))
            .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "#ffffff"));
        for mark in self.marks {
            page.append(mark);
        }
        format!("{page}\n")
    }

    fn path(&mut self, d: &str, pen: Pen) {
        self.add(Path::new().set("d", d).set("stroke-linejoin", "round"), pen);
    }

    fn add<N: Node>(&mut self, mut node: N, pen: Pen) {
        node.assign("fill", pen.fill);
        if pen.opacity < 1.0 {
            node.assign("fill-opacity", number(pen.opacity));
        }
        if pen.width > 0.0 {
            node.assign("stroke", pen.stroke);
            node.assign("stroke-width", number(pen.width));
        }
        if !pen.dash.is_empty() {
            node.assign("stroke-dasharray", pen.dash);
        }
        self.marks.push(node.into());
    }
}

fn letters(at: At, align: Align, size: f64, colour: &'static str, bold: bool, content: &str) -> Text {
    let mut text = Text::new(printable(content))
        .set("x", number(at.x))
        .set("y", number(at.y + 0.35 * size))
        .set("font-size", number(size))
        .set("fill", colour);
    match align {
        Align::Left => {}
        Align::Middle => text = text.set("text-anchor", "middle"),
        Align::Right => text = text.set("text-anchor", "end"),
    }
    if bold {
        text = text.set("font-weight", "bold");
    }
    text
}

/// Two decimals are a hundredth of a pixel.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn pair(at: At) -> String {
    format!("{} {}", number(at.x), number(at.y))
}

fn polyline(points: &[At]) -> String {
    let corner = |(index, at): (usize, &At)| format!("{}{}", if index == 0 { "M" } else { "L" }, pair(*at));
    points.iter().enumerate().map(corner).collect()
}

/// XML has no way to write most control characters.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c }).collect()
}
