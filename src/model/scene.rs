//! A scene: rigid bodies in the plane or in space, what they touch, and what acts on them; SI units, in `f64`.

use std::fmt::Debug;

/// A scene for the time-steppers.
#[derive(Debug, Clone, PartialEq)]
pub enum Scene {
    /// In the plane: three velocities a body.
    Planar(World<Planar>),
    /// In space: six velocities a body.
    Spatial(World<Spatial>),
}

/// The space that a scene lives in: how poses, velocities and shapes are written there.
pub trait Space: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Points and directions (m).
    type Vector: Entries;
    /// Pose: center of mass and orientation.
    type Pose: Entries;
    /// Velocity ν, or a wrench: translational part first.
    type Velocity: Entries;
    /// Rows of W_n, W_t (and W_o) of one contact.
    type Rows: Copy + Debug + PartialEq + Send + Sync + AsRef<[Self::Velocity]> + AsMut<[Self::Velocity]>;
    /// Principal moments of inertia (kg m²).
    type Inertia: Entries;
    /// Outlines.
    type Shape: Clone + Debug + PartialEq + Send + Sync;
}

/// A short array of numbers.
pub trait Entries: Copy + Debug + Default + PartialEq + Send + Sync + AsRef<[f64]> + AsMut<[f64]> + 'static {}

impl<const N: usize> Entries for [f64; N] where Self: Default {}

/// The plane: pose `(x, y, angle)`, velocity `(x, y, angle)` a second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Planar;

impl Space for Planar {
    type Vector = [f64; 2];
    type Pose = [f64; 3];
    type Velocity = [f64; 3];
    type Rows = [[f64; 3]; 2];
    type Inertia = [f64; 1];
    type Shape = PlanarShape;
}

/// Space: pose `(x, y, z, e0, ex, ey, ez)` with Euler parameters of unit length, velocity `(v, ω)` in world axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spatial;

impl Space for Spatial {
    type Vector = [f64; 3];
    type Pose = [f64; 7];
    type Velocity = [f64; 6];
    type Rows = [[f64; 6]; 3];
    type Inertia = [f64; 3];
    type Shape = SpatialShape;
}

/// Bodies and obstacles.
#[derive(Debug, Clone, PartialEq)]
pub struct World<S: Space> {
    /// Acceleration of gravity (m/s²).
    pub gravity: S::Vector,
    /// How long the scene runs (s), positive.
    pub duration: f64,
    /// The step that the case asks for (s), positive.
    pub step: Option<f64>,
    /// Largest gap at which a pair of features is a contact (m); without it every pair is.
    pub margin: Option<f64>,
    /// Number of edges n_l of the friction cone: 2 in the plane.
    pub directions: usize,
    /// What moves.
    pub bodies: Vec<Body<S>>,
    /// What does not.
    pub fixed: Vec<Obstacle<S>>,
    /// What happens where two touch: row `a`, column `b` for the bodies `a < b`, then the obstacles; see
    /// [`World::material`].
    pub materials: Vec<Material>,
}

impl<S: Space> World<S> {
    /// The material between body `a` and `other`: a body after `a`, or the number of bodies plus that of an obstacle.
    #[must_use]
    pub fn material(&self, a: usize, other: usize) -> &Material {
        &self.materials[a * (self.bodies.len() + self.fixed.len()) + other]
    }
}

/// A rigid body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body<S: Space> {
    /// Its name, unique in the scene.
    pub name: String,
    /// Outline in the body's frame, whose origin is the center of mass.
    pub shape: S::Shape,
    /// Mass (kg), positive.
    pub mass: f64,
    /// Moments of inertia about the center of mass (kg m²), positive.
    pub inertia: S::Inertia,
    /// Pose at the start.
    pub pose: S::Pose,
    /// Velocity at the start.
    pub velocity: S::Velocity,
    /// Whether it moves at prescribed velocities, whatever it touches; then [`Body::schedule`] holds velocities.
    pub is_kinematic: bool,
    /// Wrench on a free body, or velocity of a kinematic one, each from its time on; by time.
    pub schedule: Vec<Timed<S>>,
    /// A finger that presses on it; in the plane only.
    pub finger: Option<Finger>,
}

impl<S: Space> Body<S> {
    /// What [`Body::schedule`] holds at a time.
    #[must_use]
    pub fn scheduled(&self, time: f64) -> Option<&S::Velocity> {
        self.schedule.iter().rev().find(|timed| timed.time <= time).map(|timed| &timed.value)
    }
}

/// A value from a time on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timed<S: Space> {
    /// Since when (s).
    pub time: f64,
    /// Wrench (N, N m) in world axes at the center of mass, or velocity.
    pub value: S::Velocity,
}

/// A frictionless fingertip on a straight guide, pressed along it by a steady force.
///
/// It touches a polygon where the guide meets one of its edges, a disc where the guide enters it, and does nothing where
/// the guide misses them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finger {
    /// Edge of the body that it presses on; `None` for a disc.
    pub edge: Option<usize>,
    /// A point of the guide (m, world).
    pub at: [f64; 2],
    /// Unit direction of the guide, the way that the finger presses (world).
    pub direction: [f64; 2],
    /// Force along the guide (N), not negative: the push is this over the cosine between guide and inward normal.
    pub force: f64,
}

/// Something fixed that bodies touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle<S: Space> {
    /// Its name, unique in the scene.
    pub name: String,
    /// Outline in the world's frame.
    pub shape: S::Shape,
    /// Velocity of its surface (m/s): along the tangent `(n_y, -n_x)` in the plane, where n leaves the obstacle; the
    /// first two in space, along t and o.
    pub surface_velocity: [f64; 2],
}

/// An outline in the plane.
#[derive(Debug, Clone, PartialEq)]
pub enum PlanarShape {
    /// Simple, counter-clockwise, convex or not.
    Polygon(Vec<[f64; 2]>),
    /// A disc; of radius zero a point.
    Circle {
        /// Center.
        center: [f64; 2],
        /// Radius, not negative.
        radius: f64,
    },
    /// What lies below a line; fixed only.
    HalfPlane {
        /// A point of the line.
        point: [f64; 2],
        /// Unit normal, out of the material.
        normal: [f64; 2],
    },
    /// Rigidly joined pieces, none of them compound.
    Compound(Vec<Self>),
}

/// An outline in space.
#[derive(Debug, Clone, PartialEq)]
pub enum SpatialShape {
    /// A ball.
    Sphere {
        /// Center.
        center: [f64; 3],
        /// Radius, positive.
        radius: f64,
    },
    /// A box about the origin, along the axes.
    Box {
        /// Half of each length, positive.
        half: [f64; 3],
    },
    /// What lies below a plane; fixed only.
    HalfSpace {
        /// A point of the plane.
        point: [f64; 3],
        /// Unit normal, out of the material.
        normal: [f64; 3],
    },
}

/// What happens where two bodies touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Coefficient of friction, not negative.
    pub friction: f64,
    /// Restitution of impacts.
    pub restitution: Restitution,
    /// Visco-elastic contact, where the case gives it.
    pub compliance: Option<Compliance>,
}

/// A law of impact with its coefficient in [0, 1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Restitution {
    /// Normal velocity after the impact is at least `-e` times that before.
    Newton(f64),
    /// Normal impulse of the expansion is `e` times that of the compression.
    Poisson(f64),
}

impl Restitution {
    /// The coefficient.
    #[must_use]
    pub fn coefficient(self) -> f64 {
        let (Self::Newton(e) | Self::Poisson(e)) = self;
        e
    }
}

/// Lumped visco-elastic contact, equation (14): λ = K δ + C δ̇, normal first, then tangential.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compliance {
    /// K (N/m), positive.
    pub stiffness: [f64; 2],
    /// C (N s/m), not negative.
    pub damping: [f64; 2],
    /// γ (N) of the smoothed friction cone (6), not negative.
    pub gamma: f64,
}
