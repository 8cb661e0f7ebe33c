//! What differs between the plane and space: kinematics, inertia, contacts.

use super::contact::{Contact, dot};
use crate::model::{Body, Finger, Space, World};

/// A space that bodies move in.
pub trait Mechanics: Space {
    /// Number of tangents of a contact.
    #[doc(hidden)]
    const TANGENTS: usize;

    /// Outlines made ready for contact queries.
    type Outlines: std::fmt::Debug;

    /// Makes the outlines of a world ready.
    #[doc(hidden)]
    fn outlines(world: &World<Self>) -> Self::Outlines;

    /// Every contact with a gap of at most `reach` at these poses, in a fixed order.
    #[doc(hidden)]
    fn contacts(
        outlines: &mut Self::Outlines,
        world: &World<Self>,
        poses: &[Self::Pose],
        reach: f64,
        out: &mut Contacts<Self>,
    );

    /// The pose after moving at `velocity` for `time` (s): `q + G ν h`, orientations kept of unit length.
    #[doc(hidden)]
    fn advanced(pose: &Self::Pose, velocity: &Self::Velocity, time: f64) -> Self::Pose;

    /// M⁻¹ times a wrench, in world axes.
    #[doc(hidden)]
    fn weighed(body: &Body<Self>, pose: &Self::Pose, wrench: &Self::Velocity) -> Self::Velocity;

    /// A row of W along the principal axes of the body, where M is diagonal.
    #[doc(hidden)]
    fn principal(body: &Body<Self>, pose: &Self::Pose, row: &Self::Velocity) -> Self::Velocity;

    /// The diagonal of M⁻¹ along the principal axes; zero for a kinematic body.
    #[doc(hidden)]
    fn inverse_mass(body: &Body<Self>) -> Self::Velocity;

    /// M times a velocity, in world axes.
    #[doc(hidden)]
    fn momentum(body: &Body<Self>, pose: &Self::Pose, velocity: &Self::Velocity) -> Self::Velocity;

    /// The wrench of gravity and of gyroscopic effects (N, N m).
    #[doc(hidden)]
    fn own_wrench(
        gravity: &Self::Vector,
        body: &Body<Self>,
        pose: &Self::Pose,
        velocity: &Self::Velocity,
    ) -> Self::Velocity;

    /// The wrench of a finger at its center of mass, where it touches the body.
    #[doc(hidden)]
    fn push(body: &Body<Self>, finger: &Finger, pose: &Self::Pose) -> Option<Self::Velocity>;

    /// Height over which gravity has pulled: `-g · x` (m²/s²).
    #[doc(hidden)]
    fn potential(gravity: &Self::Vector, pose: &Self::Pose) -> f64;

    /// The displacement from one pose to another: translation, and turn about the center of mass as a rotation vector.
    #[doc(hidden)]
    fn displacement(from: &Self::Pose, to: &Self::Pose) -> Self::Velocity;

    /// A distance that no point of a body of this radius is farther from in one pose than in the other (m).
    #[doc(hidden)]
    fn separation(radius: f64, a: &Self::Pose, b: &Self::Pose) -> f64;

    /// A distance that no point of the body is farther away from its center of mass (m).
    #[doc(hidden)]
    fn radius(body: &Body<Self>) -> f64;

    /// A speed that no point of the body exceeds (m/s).
    #[doc(hidden)]
    fn fastest(radius: f64, velocity: &Self::Velocity) -> f64;

    /// The same pair of features after the bodies moved from the poses `from`, where `contact` was found, to `to`.
    #[doc(hidden)]
    fn follow(
        outlines: &Self::Outlines,
        world: &World<Self>,
        contact: &Contact<Self>,
        from: &[Self::Pose],
        to: &[Self::Pose],
    ) -> Contact<Self>;

    /// How a wrench that acts at `point` times a velocity changes as the body turns, the point with it; a row.
    #[doc(hidden)]
    fn swing(
        point: &Self::Vector,
        pose: &Self::Pose,
        wrench: &Self::Velocity,
        velocity: &Self::Velocity,
    ) -> Self::Velocity;

    /// Whether bodies cannot have this shape: nothing finds what they would touch.
    #[doc(hidden)]
    fn is_fixed_only(shape: &Self::Shape) -> bool;

    /// Half the least thickness of a shape (m); infinite for what lies below a line or plane.
    #[doc(hidden)]
    fn half_thickness(shape: &Self::Shape) -> f64;
}

/// W M⁻¹ Wᵀ of one row of W on one body (1/kg).
pub(super) fn mobility<S: Mechanics>(world: &World<S>, poses: &[S::Pose], body: usize, row: &S::Velocity) -> f64 {
    dot(row, &S::weighed(&world.bodies[body], &poses[body], row))
}

/// The contacts of a step.
pub type Contacts<S> = Vec<Contact<S>>;
