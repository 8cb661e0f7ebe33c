//! The exchange format of cddlib and lrslib for polyhedra, `.ine` and `.ext` files.
//!
//! ```text
//! H-representation
//! linearity 1 1
//! begin
//!  3 3 rational
//!  -1 1 1
//!  0 1 0
//!  0 0 1
//! end
//! ```
//! The rows `(b, a)` mean `b + a · x ≥ 0`; those of a `V-representation` are points `(1, x)` and rays `(0, x)`. A
//! `linearity` line counts its rows and numbers them from one: equalities, or lines.

mod fault;
mod read;
mod scan;
mod write;

pub use fault::{FormatError, FormatFault};
pub use read::{Document, MAX_COLUMNS, MAX_DECIMAL_EXPONENT, read};
pub use write::write;
