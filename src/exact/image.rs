//! What a rational function takes a real algebraic number to.

use super::{Algebraic, Entries, Int as _, Long, Polynomial, Q, ratio};
use num_traits::{One as _, Signed as _};

impl Algebraic {
    /// An interval at most `width` wide that holds `numerator / denominator` at this number; `None` if the denominator
    /// is zero here.
    ///
    /// # Panics
    /// If `width` is not positive.
    #[must_use]
    pub fn image(&self, numerator: &Polynomial, denominator: &Polynomial, width: &Q) -> Option<[Q; 2]> {
        assert!(width.is_positive(), "an enclosure needs a positive width");
        if self.sign_of(denominator).is_eq() {
            return None;
        }
        let mut number = self.clone();
        let mut bits = 2;
        // the denominator is not zero, so both ranges shrink to their values
        loop {
            let bounds = number.bounds();
            let image = quotient(&numerator.range_on(&bounds), &denominator.range_on(&bounds));
            if let Some([low, high]) = image
                && &high - &low <= *width
            {
                return Some([low, high]);
            }
            number = number.halved(bits);
            bits *= 2;
        }
    }

    /// `numerator / denominator` at this number, exactly; `None` if the denominator is zero here.
    ///
    /// # Cost
    /// Elimination on about `n m` integer rows of that length, for a number of degree `n` and a function of degree `m`;
    /// [`Algebraic::image`] is far cheaper where an enclosure is enough.
    ///
    /// # Examples
    /// ```
    /// use partplan::exact::{Polynomial, ratio};
    /// let root_of_two = Polynomial::from([-2, 0, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
    /// let [one, x_squared] = [Polynomial::from([1]), Polynomial::from([0, 0, 1])];
    /// assert_eq!(root_of_two.apply(&x_squared, &one).unwrap(), ratio(2, 1));
    /// ```
    #[must_use]
    pub fn apply(&self, numerator: &Polynomial, denominator: &Polynomial) -> Option<Self> {
        let mut width = Q::one();
        let mut enclosure = self.image(numerator, denominator, &width)?;
        if enclosure[0] == enclosure[1] {
            return Some(enclosure[0].clone().into());
        }
        let equation = equation_of_image(&self.polynomial(), numerator, denominator);
        // other roots are at a distance
        loop {
            let [low, high] = enclosure;
            let mut inside = equation.real_roots(low..=high)?;
            if inside.len() == 1 {
                return inside.pop();
            }
            width *= ratio(1, 1 << 20);
            enclosure = self.image(numerator, denominator, &width)?;
        }
    }
}

/// The quotients of numbers from two intervals; `None` if the divisor may be zero.
fn quotient(dividend: &[Q; 2], divisor: &[Q; 2]) -> Option<[Q; 2]> {
    let [low, high] = divisor;
    if !low.is_positive() && !high.is_negative() {
        return None;
    }
    let mut ends = [&dividend[0] / low, &dividend[0] / high, &dividend[1] / low, &dividend[1] / high];
    ends.sort();
    let [least, .., greatest] = ends;
    Some([least, greatest])
}

/// The square-free polynomial that is zero exactly where `a / b` takes the roots of `own`, real and complex, poles left out.
///
/// It is the first linear dependence of `a^k b^(n-k)` modulo `own`, `k = 0, 1, …`, for `own` of degree `n`. As `own` is
/// square-free, a dependence is one of the values at its roots. Where `b` is not zero it is a polynomial that vanishes at
/// `a / b`; at a pole all values but the last are zero, and then the last is not needed.
fn equation_of_image(own: &Polynomial, a: &Polynomial, b: &Polynomial) -> Polynomial {
    let n = own.degree().unwrap_or_default();
    let length = 1 + n.max(n * a.degree().max(b.degree()).unwrap_or_default());
    // columns: powers of x, then how much of each a^k b^(n-k) is in the row
    let row = |polynomial: &Polynomial, shift: usize, mark: Option<usize>| -> Entries<Long> {
        let mut row = Entries::from_elem(Long::default(), length + n + 1);
        let coefficients = polynomial.coefficients().iter().filter_map(Long::from_z);
        row[shift..].iter_mut().zip(coefficients).for_each(|(entry, c)| *entry = c);
        mark.into_iter().for_each(|k| row[length + k] = Long::unit());
        row
    };
    let mut reducers: Vec<Option<Entries<Long>>> =
        (0..length).map(|top| Some(row(own, top.checked_sub(n)?, None))).collect();
    (0..=n)
        .find_map(|k| reduced(row(&(&power(a, k) * &power(b, n - k)), 0, Some(k)), &mut reducers))
        .map(|relation| Polynomial::new(relation[length..].iter().map(Long::to_z).collect()))
        .expect("n + 1 vectors of n dimensions are dependent")
}

/// The row without any power of x, if the reducers can bring it there; else it becomes one of them.
fn reduced(mut row: Entries<Long>, reducers: &mut [Option<Entries<Long>>]) -> Option<Entries<Long>> {
    for top in (0..reducers.len()).rev() {
        if row[top].sign().is_eq() {
            continue;
        }
        let Some(reducer) = &reducers[top] else {
            reducers[top] = Some(row);
            return None;
        };
        let mut next = Entries::new();
        Long::combine(&reducer[top], &row, &row[top].negated(), reducer, &mut next).expect("any size fits");
        row = next;
    }
    Some(row)
}

fn power(polynomial: &Polynomial, exponent: usize) -> Polynomial {
    (0..exponent).fold(Polynomial::from([1]), |product, _| &product * polynomial)
}
