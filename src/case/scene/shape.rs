//! What reading needs to know about the plane and about space.

use super::super::Limits;
use super::super::kind::FaultKind;
use super::super::reader::{Fields, Path, Reader};
use crate::model::{Finger, Space};
use jsonc_parser::ast::Value;

/// Whether a shape moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    Body,
    Fixed,
}

/// A shape with what follows from it.
pub struct Solid<S: Space> {
    pub shape: S::Shape,
    pub n_vertices: usize,
    /// Inertia about the origin for each unit of mass, if the mass is spread evenly and that has principal axes along the
    /// frame's; only for bodies.
    pub gyration2: Option<S::Inertia>,
    /// What is odd about the origin as a center of mass if the mass is spread evenly.
    pub offset: Option<String>,
    /// What is odd about it in any case.
    pub outside: Option<String>,
}

/// The plane, or space.
pub trait Dimension: Space {
    /// Of the earth, downward.
    const GRAVITY: Self::Vector;
    const GRAVITY_HELP: &'static str;
    const POSE_HELP: &'static str;
    const VELOCITY_HELP: &'static str;
    const WRENCH_HELP: &'static str;
    const SHAPE_HELP: &'static str;
    /// Edges of the friction cone, unless the file says otherwise.
    const DIRECTIONS: usize;

    /// A shape; `None` after a fault.
    fn shape(reader: &mut Reader, value: &Value, path: &Path, role: Role, limits: &Limits) -> Option<Solid<Self>>;

    /// Brings orientations to their normal form.
    fn pose(reader: &mut Reader, value: &Value, path: &Path) -> Option<Self::Pose>;

    /// Moments of inertia as written.
    fn inertia(reader: &mut Reader, value: &Value, path: &Path) -> Option<Self::Inertia>;

    /// A finger that presses on a body of this shape; `None` after a fault.
    fn finger(reader: &mut Reader, value: &Value, path: &Path, shape: Option<&Self::Shape>) -> Option<Finger>;

    /// Velocity of a surface along its tangents.
    fn surface_velocity(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 2]>;
}

impl Reader {
    /// The one of `keys` that is there; the object knows no other keys.
    pub fn one_of(&mut self, fields: &Fields, keys: &[&'static str], path: &Path, help: &str) -> Option<&'static str> {
        let mut present = keys.iter().copied().filter(|key| fields.get(key).is_some());
        match (present.next(), present.next()) {
            (Some(key), None) => Some(key),
            (Some(first), Some(second)) => {
                self.exclude(fields, [first, second], path, help);
                None
            }
            (None, _) if !fields.is_empty() => None, // unknown keys, and that is said
            (None, _) => {
                let key = keys.first().copied().unwrap_or_default();
                self.fault(FaultKind::MissingKey { key }, fields.span.clone(), &path.key(key), help);
                None
            }
        }
    }

    /// Refuses what only fixed things can be.
    pub fn fixed_only(&mut self, fields: &Fields, key: &'static str, path: &Path, role: Role, help: &str) -> bool {
        if role == Role::Fixed {
            return true;
        }
        self.fault(FaultKind::FixedOnly { shape: key }, fields.key_span(key), &path.key(key), help);
        false
    }
}
