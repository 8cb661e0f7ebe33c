//! Exact planner for feeding, orienting and fixturing parts.
//!
//! One JSON case describes a part; a planner answers in exact arithmetic what is guaranteed to happen to it.
//!
//! ```text
//! text -> case -> model -> planner -> answer -> report -> text
//!                   |        |
//!                geometry  mechanics
//!                   |        |
//!                 exact    cone
//! ```
//!
//! Data flows one way. Floats occur where pictures are drawn and where a function says so in its name, never in a
//! decision.

pub mod answer;
pub mod case;
pub mod complementarity;
pub mod cone;
pub mod dynamics;
pub mod exact;
pub mod geometry;
pub mod mechanics;
pub mod model;
pub mod planner;
pub mod report;
