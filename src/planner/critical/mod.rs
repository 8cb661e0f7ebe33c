//! How much friction a guarantee bears.

mod family;
