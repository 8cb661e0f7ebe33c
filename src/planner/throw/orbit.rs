//! Orbits of the throw map.

use super::system::{State, System};
use crate::answer::EndedOrbit;
use crate::mechanics::throwing::{Catch, Thrown};

/// An orbit: its start, and the throws from there.
#[derive(Debug, Clone)]
pub(super) struct Orbit {
    pub(super) start: State,
    /// From where each throw was made, and how it ended.
    pub(super) throws: Vec<(State, Catch)>,
}

impl Orbit {
    /// Throws `count` times.
    ///
    /// # Errors
    /// How it ended before.
    pub(super) fn follow(system: &System, start: State, count: usize) -> Result<Self, EndedOrbit> {
        let mut throws = Vec::with_capacity(count);
        let mut at = start;
        while throws.len() < count {
            match system.throw(at) {
                Thrown::Caught(catch) if catch.radius >= system.low(catch.edge) && catch.radius <= system.far() => {
                    throws.push((at, catch));
                    at = (catch.edge, catch.radius);
                }
                thrown => return Err(EndedOrbit { start, after: throws.len(), at, fate: system.told(&thrown) }),
            }
        }
        Ok(Self { start, throws })
    }
}
