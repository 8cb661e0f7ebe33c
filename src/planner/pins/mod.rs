//! Pins over a conveyor: what they do to a part, and which of them turn it into one orientation.

// the toppling graph is to call it
#[cfg_attr(not(test), expect(dead_code))]
mod search;
