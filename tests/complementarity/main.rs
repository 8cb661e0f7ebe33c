//! Linear complementarity: published and made instances, properties, brute force, and contacts by the thousand.

mod brute;
mod check;
mod enumeration;
mod instances;
mod ladder;
mod planar;
mod proofs;
mod properties;

use partplan::chart::contacts;
