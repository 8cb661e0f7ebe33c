//! Oracles that share no code with the planner: slow, exact, and each as close to its definition as it can be.
#![allow(dead_code, missing_docs)] // every test binary uses a part of it

pub mod canonical;
pub mod cases;
pub mod conveyed;
pub mod drawn;
pub mod hull;
pub mod lp;
pub mod member;
pub mod modes;
pub mod paper;
pub mod random;
pub mod sturm;
pub mod topple;
pub mod witness;

use partplan::exact::{Q, parse_literal};

pub type Wrench = [Q; 3];

/// The rational that `text` denotes.
pub fn q(text: &str) -> Q {
    parse_literal(text).expect("a number")
}

/// The rational `value`.
pub fn int(value: i64) -> Q {
    Q::from_integer(value.into())
}

pub fn wrench(fx: i64, fy: i64, torque: i64) -> Wrench {
    [int(fx), int(fy), int(torque)]
}

pub fn dot(a: &[Q], b: &[Q]) -> Q {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `a x b` in the plane.
pub fn cross(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[1] - &a[1] * &b[0]
}
