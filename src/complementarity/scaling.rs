//! Rows and columns of a problem times powers of two.

use super::Lcp;

/// The problem `M' = R M C`, `q' = R q` with diagonal `R`, `C` of powers of two; `z = C z'`. Nothing is rounded.
#[derive(Debug, Clone, Default)]
pub(super) struct Scaled {
    m: Vec<f64>,
    q: Vec<f64>,
    rows: Vec<f64>,
    columns: Vec<f64>,
}

impl Scaled {
    /// Scales so that positive diagonal entries are about one (for contacts: impulses over the root of the mass) and in
    /// the rows and columns without diagonal the largest entry is.
    pub(super) fn load(&mut self, lcp: Lcp<'_>) {
        let n = lcp.size();
        let root = |i: usize| {
            let diagonal = lcp.m[i * n + i];
            if diagonal > 0.0 { power_of_two(-exponent(diagonal).div_euclid(2)) } else { 0.0 }
        };
        self.rows.clear();
        self.rows.extend((0..n).map(root));
        self.columns.clear();
        self.columns.extend_from_slice(&self.rows);
        for i in (0..n).filter(|i| lcp.m[i * n + i] <= 0.0) {
            let known = |scale: f64| if scale == 0.0 { 1.0 } else { scale };
            let row = (0..n).fold(0.0_f64, |most, j| most.max(lcp.m[i * n + j].abs() * known(self.columns[j])));
            let column = (0..n).fold(0.0_f64, |most, j| most.max(lcp.m[j * n + i].abs() * known(self.rows[j])));
            self.rows[i] = power_of_two(-exponent(row));
            self.columns[i] = power_of_two(-exponent(column));
        }
        self.m.clear();
        for (row, scale) in lcp.m.chunks_exact(n.max(1)).zip(&self.rows) {
            self.m.extend(row.iter().zip(&self.columns).map(|(entry, column)| entry * scale * column));
        }
        self.q.clear();
        self.q.extend(lcp.q.iter().zip(&self.rows).map(|(entry, scale)| entry * scale));
    }

    /// The scaled problem.
    pub(super) fn lcp(&self) -> Lcp<'_> {
        Lcp { m: &self.m, q: &self.q }
    }

    /// From `z'` to `z`.
    pub(super) fn restore(&self, z: &mut [f64]) {
        z.iter_mut().zip(&self.columns).for_each(|(value, column)| *value *= column);
    }
}

/// The exponent of the leading bit, 0 for zero and for what is not finite.
fn exponent(value: f64) -> i32 {
    let biased = (value.to_bits() >> 52 & 0x7ff) as i32;
    if biased == 0 || biased == 0x7ff { 0 } else { biased - 1023 }
}

/// `2^exponent`, within what doubles can hold without losing bits.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent.clamp(-1000, 1000) + 1023) as u64) << 52)
}
