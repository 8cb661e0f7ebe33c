//! `plan throw` against the public cases, the paper and the mechanics.

mod enclosure;
mod expected;
mod map;
mod plan;
