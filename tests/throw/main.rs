//! `plan throw` against the public cases, the paper and the mechanics.

mod carry;
mod design;
mod enclosure;
mod expected;
mod grasp;
mod map;
mod plan;
mod properties;
mod replay;
mod starts;
