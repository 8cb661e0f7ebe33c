//! Exact polyhedral cones in any dimension, not necessarily closed.
//!
//! A [`Cone`] is a closed cone in both forms (face normals and generators, [`Pair`]) together with the faces that are
//! missing from it. Everything is generic over the integer ([`crate::exact::Int`]) and exact: an operation either
//! returns the right answer or [`Overflow`](crate::exact::Overflow), and then runs again on wider integers.
//!
//! Sign convention everywhere: a face normal `h` of a cone satisfies `h · x ≤ 0` on it. Polyhedra ([`Polyhedron`]) keep that of their files, `b + a · x ≥ 0`.

pub(crate) mod bits;
pub mod format;

mod adjacent;
mod combination;
mod convert;
mod cut;
mod describe;
mod difference;
mod faces;
mod frame;
mod interior;
mod lattice;
mod linear;
mod nearest;
mod nnc;
mod pair;
mod polyhedron;
mod primal_dual;
mod simple;
mod simplex;
mod spatial;
mod volume;

pub use combination::{Summands, summands};
pub use convert::{Converted, Extras, Fates, canonical, convert, project, without_redundancy};
pub use difference::{Outside, Split, complement, split, subtract};
pub use faces::Face;
pub use nearest::nearest;
pub use nnc::{Cone, HalfSpaces};
pub use pair::{Generators, Pair};
pub use polyhedron::{Polyhedron, Representation};
pub use volume::volume_in_box;
