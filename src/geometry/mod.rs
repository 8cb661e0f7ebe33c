//! Exact planar geometry: polygons, their moments, and points on their outline.

mod polygon;

pub use polygon::Polygon;
