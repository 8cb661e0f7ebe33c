//! A place for the drawing of pins that is to come.

use super::super::{Ride, phrase};
use super::canvas::Canvas;
use super::view::WIDTH;
use crate::answer::Pins;

/// The drawing of `plan pins`: nothing yet but its title.
#[must_use]
pub fn pins(ride: &Ride, answer: &Pins) -> String {
    Canvas::new().finish(WIDTH, 0.0, ride.name, &phrase::pins(ride, answer))
}
