//! Real roots counted by Sturm's theorem, on rational coefficients (low degree first).

use num_traits::{Signed, Zero};
use partplan::exact::Q;

/// The number of distinct real roots in `(low, high]`.
pub fn count(p: &[Q], low: &Q, high: &Q) -> usize {
    let chain = chain(p);
    sign_changes(chain.iter().map(|p| value(p, low))) - sign_changes(chain.iter().map(|p| value(p, high)))
}

/// The number of distinct real roots.
pub fn count_all(p: &[Q]) -> usize {
    let chain = chain(p);
    let leading = |p: &Vec<Q>| p.last().cloned().expect("no member of a Sturm chain is zero");
    let at_minus_infinity = chain.iter().map(|p| if p.len().is_multiple_of(2) { -leading(p) } else { leading(p) });
    sign_changes(at_minus_infinity) - sign_changes(chain.iter().map(leading))
}

pub fn value(p: &[Q], x: &Q) -> Q {
    p.iter().rev().fold(Q::zero(), |sum, c| sum * x + c)
}

pub fn product(a: &[Q], b: &[Q]) -> Vec<Q> {
    let mut product = vec![Q::zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

/// `p, p', -rem(p, p'), …` down to the greatest common divisor, remainders divided by the size of their leading coefficient.
fn chain(p: &[Q]) -> Vec<Vec<Q>> {
    let mut chain = vec![trimmed(p.to_vec())];
    let mut next = trimmed(p.iter().enumerate().skip(1).map(|(power, c)| c * Q::from_integer(power.into())).collect());
    while !next.is_empty() {
        let rest = remainder(chain.last().expect("never empty").clone(), &next);
        let scale = rest.last().map(|leading| -leading.abs());
        let rest = rest.iter().zip(scale.iter().cycle()).map(|(c, scale)| c / scale).collect();
        chain.push(std::mem::replace(&mut next, rest));
    }
    chain
}

fn remainder(mut a: Vec<Q>, b: &[Q]) -> Vec<Q> {
    while a.len() >= b.len() {
        let factor = a.last().expect("not empty") / b.last().expect("not empty");
        let shift = a.len() - b.len();
        for (i, c) in b.iter().enumerate() {
            a[shift + i] -= &factor * c;
        }
        a = trimmed(a);
    }
    a
}

fn trimmed(mut p: Vec<Q>) -> Vec<Q> {
    while p.last().is_some_and(Q::is_zero) {
        p.pop();
    }
    p
}

fn sign_changes(values: impl Iterator<Item = Q>) -> usize {
    let signs: Vec<bool> = values.filter(|v| !v.is_zero()).map(|v| v.is_positive()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}
