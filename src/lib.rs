//! Exact planner for feeding, orienting and fixturing parts.
//!
//! One JSON case describes a part; a planner answers in exact arithmetic what is guaranteed to happen to it. A scene
//! describes bodies; a time-stepper answers in doubles, verified step by step, how they move.
//!
//! ```text
//! text -> case -> model -> planner -> answer -> verify -> report -> text
//!                   |        |                     |
//!                geometry  mechanics            dynamics
//!                   |        |                     |
//!                 exact    cone              complementarity
//! ```
//!
//! Data flows one way. Floats occur in the time-steppers, where pictures are drawn and where a function says so in its
//! name, never in a planner's decision.

pub mod answer;
pub mod case;
pub mod chart;
pub mod complementarity;
pub mod cone;
pub mod design;
pub mod dynamics;
pub mod exact;
pub mod geometry;
pub mod mechanics;
pub mod model;
pub mod planner;
pub mod report;
pub mod verify;
