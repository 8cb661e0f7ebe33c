//! Random fixtures.
