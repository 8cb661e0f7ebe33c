//! Design of devices through dynamics: dimensions with which parts leave as they are to, however they enter.
//!
//! Song, Trinkle, Kumar and Pang (2004), section V. Everything here is in doubles: it proposes designs and says how they fared in
//! the time-steppers, and proves nothing.

mod objective;
mod robust;
mod score;
mod search;

pub use objective::{evaluated, films, run};
pub use robust::robustness;
pub use score::{Score, Scoring, SearchOptions};
pub use search::{Journal, design};
