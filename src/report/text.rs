//! Text for people: the answer first.
