//! The throw map f(i, R) in doubles.

use super::Settling;
use super::body::Body;
use super::flight::Flight;
use super::roll::{End, Impact, Landing, roll};

/// What a throw does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Thrown {
    /// The part comes to rest.
    Caught(Catch),
    /// A vertex meets the line of the arm left of the pivot.
    OffArm {
        /// Which.
        vertex: usize,
        /// Where (length).
        x: f64,
        /// The vertex of the first impact.
        impact_vertex: usize,
    },
    /// Upright on a vertex, or it rolls on and on.
    Balanced {
        /// Which.
        vertex: usize,
    },
}

/// Rest after a throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Catch {
    /// The edge on the arm.
    pub edge: usize,
    /// x of the center of mass (length).
    pub radius: f64,
    /// Edges that the part was turned over, counter-clockwise, net; zero for a jog.
    pub steps: i64,
    /// Turn in flight (rad).
    pub flight_rotation: f64,
    /// Vertex of the first impact.
    pub impact_vertex: usize,
    /// Where (length).
    pub impact_x: f64,
    /// Angular velocity after it, in units of the release speed.
    pub omega_after: f64,
    /// d(radius)/dR.
    pub slope: f64,
}

impl Body<f64> {
    /// Throws the part that rests on `edge` at `radius`, all of it right of the pivot.
    ///
    /// The error is some units in the last place, away from breaks of the map.
    #[must_use]
    pub fn throw(&self, edge: usize, radius: f64, settling: Settling) -> Thrown {
        self.follow(edge, radius, settling, |_, _| {}, |_| {})
    }

    /// As [`Body::throw`], telling the first impact and each landing.
    pub(super) fn follow(
        &self,
        edge: usize,
        radius: f64,
        settling: Settling,
        met: impl FnOnce(&Flight, &Impact<f64>),
        landed: impl FnMut(&Landing<f64>),
    ) -> Thrown {
        let Some(flight) = self.flight(edge, radius) else { return Thrown::Balanced { vertex: edge } };
        let impact = self.impact(edge, radius, &flight);
        met(&flight, &impact);
        let mut thrown = Thrown::Balanced { vertex: impact.vertex };
        roll(self, &impact, settling, landed, |end| {
            thrown = match end {
                End::Rest { edge: to, steps, beyond } => Thrown::Caught(Catch {
                    edge: to,
                    radius: impact.x + beyond,
                    steps,
                    flight_rotation: flight.angle,
                    impact_vertex: impact.vertex,
                    impact_x: impact.x,
                    omega_after: impact.omega,
                    slope: self.slope(edge, radius, &flight),
                }),
                End::OffArm { vertex, x } => Thrown::OffArm { vertex, x, impact_vertex: impact.vertex },
                End::Balanced { vertex } => Thrown::Balanced { vertex },
                End::Unknown => Thrown::Balanced { vertex: impact.vertex },
            };
        });
        thrown
    }
}
