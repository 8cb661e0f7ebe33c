//! Exact polyhedral cones.
