//! Marks of methods: told apart by shape, and by a colour that the colour-blind tell apart.

use super::super::canvas::{At, BLUE, Canvas, GREEN, INK, ORANGE, PINK, Pen, RED, SKY};

/// The mark of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Mark {
    shape: usize,
    colour: usize,
    is_hollow: bool,
}

const COLOURS: [&str; 10] = [BLUE, RED, GREEN, PINK, ORANGE, SKY, INK, "#8a6d3b", "#7a5195", "#8d959c"];
const SIZE: f64 = 4.6;

impl Mark {
    /// That of method number `index`.
    pub(super) fn of(index: usize) -> Self {
        let count = COLOURS.len();
        // after all colours have been used, with other shapes
        Self { shape: (index + index / count) % count, colour: index % count, is_hollow: false }
    }

    /// For runs some of which failed.
    pub(super) fn hollow(self) -> Self {
        Self { is_hollow: true, ..self }
    }

    pub(super) fn colour(self) -> &'static str {
        COLOURS[self.colour]
    }

    pub(super) fn draw(self, canvas: &mut Canvas, at: At) {
        let colour = self.colour();
        let pen = if self.is_hollow { Pen::fill("#ffffff", 1.0) } else { Pen::fill(colour, 1.0) }.outlined(colour, 1.6);
        let corner = |turn: f64, far: f64| at.along(At::unit(turn.to_radians()), far * SIZE);
        let polygon = |turns: &[f64], far: f64| turns.iter().map(|turn| corner(*turn, far)).collect::<Vec<_>>();
        let corners = match self.shape {
            0 => return canvas.circle(at, SIZE, pen),
            1 => polygon(&[45.0, 135.0, 225.0, 315.0], 1.3),
            2 => polygon(&[90.0, 210.0, 330.0], 1.4),
            3 => polygon(&[0.0, 90.0, 180.0, 270.0], 1.4),
            4 => polygon(&[270.0, 30.0, 150.0], 1.4),
            7 => polygon(&[0.0, 120.0, 240.0], 1.4),
            8 => polygon(&[60.0, 180.0, 300.0], 1.4),
            9 => {
                let star =
                    |turn: u32| corner(f64::from(turn) * 36.0 + 90.0, if turn.is_multiple_of(2) { 1.6 } else { 0.7 });
                (0..10).map(star).collect()
            }
            5 => polygon(&[18.0, 90.0, 162.0, 234.0, 306.0], 1.25),
            _ => polygon(&[0.0, 60.0, 120.0, 180.0, 240.0, 300.0], 1.25),
        };
        canvas.polygon(&corners, pen);
    }
}

/// A piece of a curve, for a legend.
pub(in super::super) fn sample(canvas: &mut Canvas, at: At, mark: Mark) {
    if !mark.is_hollow {
        canvas.line(&[At::new(at.x - 11.0, at.y), At::new(at.x + 11.0, at.y)], Pen::stroke(mark.colour(), 1.4));
    }
    mark.draw(canvas, at);
}
