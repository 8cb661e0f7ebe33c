//! Machine integers against integers of any size, near the ends of their ranges.

use super::draw::runs;
use num_traits::Zero;
use partplan::exact::{Entries, Int, Long, Matrix, Overflow, Q, Z, primitive_row};
use proptest::collection::vec;
use proptest::prelude::*;

/// Any size up to the ends of `i128`, often near a power of two or with many factors two.
fn wide() -> impl Strategy<Value = i128> {
    let near = (0..=126_u32, -2..=2_i128, any::<bool>()).prop_map(|(bits, off, negative)| {
        let value = (1_i128 << bits) - 1 + off.min(i128::from(bits < 126));
        if negative { -value } else { value }
    });
    prop_oneof![2 => -9..=9_i128, 3 => near, 1 => Just(i128::MAX), 1 => Just(-i128::MAX)]
}

fn narrow() -> impl Strategy<Value = i64> {
    let near = (0..=62_u32, -2..=2_i64, any::<bool>()).prop_map(|(bits, off, negative)| {
        let value = (1_i64 << bits) - 1 + off.min(i64::from(bits < 62));
        if negative { -value } else { value }
    });
    prop_oneof![2 => -9..=9_i64, 3 => near, 1 => Just(i64::MAX), 1 => Just(-i64::MAX)]
}

fn big<T: Int>(row: &[T]) -> Vec<Z> {
    row.iter().map(T::to_z).collect()
}

fn long(value: &Z) -> Long {
    Long::from_z(value).expect("any size fits")
}

fn longs(row: &[Z]) -> Vec<Long> {
    row.iter().map(long).collect()
}

/// The row if every entry fits.
fn fitted<T: Int>(row: &[Z]) -> Result<Vec<T>, Overflow> {
    row.iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)
}

fn combined<T: Int>(p: &T::Wide, a: &[T], q: &T::Wide, b: &[T]) -> Result<Vec<T>, Overflow> {
    let mut out = Entries::new();
    T::combine(p, a, q, b, &mut out).map(|()| out.to_vec())
}

/// By definition: the combination over the greatest common divisor of its entries.
fn expected(p: i128, a: &[Z], q: i128, b: &[Z]) -> Vec<Z> {
    let row: Vec<Q> = a.iter().zip(b).map(|(x, y)| Q::from_integer(x * p + y * q)).collect();
    super::naive::coprime(&row)
}

fn two_rows<V: std::fmt::Debug>(entry: impl Strategy<Value = V> + Clone) -> impl Strategy<Value = (Vec<V>, Vec<V>)> {
    (1..=4_usize).prop_flat_map(move |columns| (vec(entry.clone(), columns), vec(entry.clone(), columns)))
}

proptest! {
    #![proptest_config(runs(2000))]

    #[test]
    fn a_combination_of_words_is_exact_or_an_overflow(
        (a, b) in two_rows(narrow().boxed()), p in wide(), q in wide()
    ) {
        let expected = expected(p, &big(&a), q, &big(&b));
        let found = combined(&p, &a, &q, &b);
        let small = [p, q].iter().all(|v| i64::try_from(*v).is_ok());
        if small || found.is_ok() {
            prop_assert_eq!(found, fitted::<i64>(&expected));
        }
    }

    #[test]
    fn a_combination_of_double_words_overflows_only_if_its_primitive_row_does(
        (a, b) in two_rows(wide().boxed()), p in wide(), q in wide()
    ) {
        let expected = expected(p, &big(&a), q, &big(&b));
        prop_assert_eq!(combined(&p.into(), &a, &q.into(), &b), fitted::<i128>(&expected));
        let (p, q) = (long(&Z::from(p)), long(&Z::from(q)));
        prop_assert_eq!(combined(&p, &longs(&big(&a)), &q, &longs(&big(&b))), Ok(longs(&expected)));
    }

    #[test]
    fn a_product_of_rows_is_exact_or_an_overflow((a, b) in two_rows(narrow().boxed()), (c, d) in two_rows(wide().boxed())) {
        let exact = |a: &[Z], b: &[Z]| a.iter().zip(b).map(|(x, y)| x * y).sum::<Z>();
        let words = exact(&big(&a), &big(&b));
        if let Ok(found) = i64::dot(&a, &b) {
            prop_assert_eq!(Z::from(found), words.clone());
        } else {
            prop_assert!(a.len() > 2, "two products of words fit 127 bits");
        }
        if let Ok(double) = i128::dot(&c, &d) {
            let expected = exact(&big(&c), &big(&d));
            prop_assert_eq!(i128::wide_sign(&double), expected.cmp(&Z::zero()));
            prop_assert_eq!(Z::from(i128::wide_negated(&double)), -&expected);
            prop_assert_eq!(Z::from(double), expected);
        } else {
            prop_assert!(c.len() > 2, "two products of double words fit 255 bits");
        }
        prop_assert_eq!(Long::dot(&longs(&big(&a)), &longs(&big(&b))), Ok(long(&words)));
    }

    #[test]
    fn primitive_rows_agree_on_all_types(row in vec(wide(), 0..5)) {
        let rational: Vec<Q> = row.iter().map(|v| Q::from_integer((*v).into())).collect();
        let expected = super::naive::coprime(&rational);
        let mut narrow = Entries::new();
        let mut double = Entries::new();
        prop_assert_eq!(i64::primitive(&row, &mut narrow).map(|()| narrow.to_vec()), fitted::<i64>(&expected));
        let wide: Vec<_> = row.iter().map(i128::widen).collect();
        i128::primitive(&wide, &mut double).unwrap();
        prop_assert_eq!(big(&double), expected.clone());
        prop_assert_eq!(primitive_row(&rational), expected.clone());
        let mut in_place = row.clone();
        i128::make_primitive(&mut in_place);
        prop_assert_eq!(big(&in_place), expected);
    }

    /// Dot products of up to 256 bits as factors and as a row of their own.
    #[test]
    fn products_of_double_words_are_kept_whole(
        (a, b) in two_rows(wide().boxed()), (c, d) in two_rows(wide().boxed()), (x, y) in two_rows(wide().boxed())
    ) {
        let exact = |a: &[i128], b: &[i128]| a.iter().zip(b).map(|(x, y)| x.to_z() * y).sum::<Z>();
        let [Ok(p), Ok(q)] = [(&a, &b), (&c, &d)].map(|(a, b)| i128::dot(a, b)) else { return Ok(()) };
        let [p_big, q_big] = [exact(&a, &b), exact(&c, &d)];
        let rational = |row: &[Z]| row.iter().cloned().map(Q::from_integer).collect::<Vec<Q>>();
        let mut row = Entries::new();
        let found = i128::primitive(&[p, q], &mut row).map(|()| row.to_vec());
        prop_assert_eq!(found, fitted::<i128>(&super::naive::coprime(&rational(&[p_big.clone(), q_big.clone()]))));
        let whole: Vec<Z> = big(&x).iter().zip(big(&y)).map(|(x, y)| x * &p_big + y * &q_big).collect();
        let whole = super::naive::coprime(&rational(&whole));
        prop_assert_eq!(combined(&long(&p_big), &longs(&big(&x)), &long(&q_big), &longs(&big(&y))), Ok(longs(&whole)));
        if let Ok(found) = combined(&p, &x, &q, &y) {
            prop_assert_eq!(big(&found), whole);
        }
    }

    #[test]
    fn long_integers_are_ordered_and_kept_as_others(x in wide(), y in wide(), shift in 0_u32..300) {
        let (x, y) = (Z::from(x) << shift, Z::from(y));
        prop_assert_eq!(long(&x).cmp(&long(&y)), x.cmp(&y));
        prop_assert_eq!(long(&x).to_z(), x.clone());
        prop_assert_eq!(long(&x).negated().to_z(), -&x);
        prop_assert_eq!(long(&x).sign(), x.cmp(&Z::zero()));
    }

    #[test]
    fn a_row_of_fractions_becomes_integers_on_the_same_ray(row in vec((-99..=99_i64, 1..=30_i64), 1..6)) {
        let row: Vec<Q> = row.into_iter().map(|(p, q)| Q::new(p.into(), q.into())).collect();
        let integers = primitive_row(&row);
        prop_assert_eq!(&integers, &super::naive::coprime(&row));
        if let Some(at) = row.iter().position(|v| !v.is_zero()) {
            let factor = Q::from_integer(integers[at].clone()) / &row[at];
            prop_assert!(factor > Q::zero());
            prop_assert!(row.iter().zip(&integers).all(|(v, i)| v * &factor == Q::from_integer(i.clone())));
        }
    }
}

#[test]
fn a_value_fits_iff_it_and_its_negative_are_in_range() {
    for (bits, word, double) in [(62_u32, true, true), (63, false, true), (126, false, true), (127, false, false)] {
        let power = Z::from(2).pow(bits);
        for value in [power.clone(), -&power] {
            assert_eq!(<i64 as Int>::from_z(&value).is_some(), word, "{value}");
            assert_eq!(<i128 as Int>::from_z(&value).is_some(), double, "{value}");
        }
        for value in [&power - 1, 1 - &power] {
            assert_eq!(<i64 as Int>::from_z(&value).is_some(), bits < 64, "{value}");
            assert_eq!(<i128 as Int>::from_z(&value).map(|v| v.to_z()), Some(value));
        }
    }
}

/// Its negative would not fit.
#[test]
fn the_least_value_of_a_type_is_an_overflow_wherever_it_would_come_out() {
    let least = i128::from(i64::MIN);
    let mut out = Entries::new();
    assert_eq!(i64::primitive(&[least, 1], &mut out), Err(Overflow));
    assert_eq!(combined(&1, &[-i64::MAX, 1], &1, &[-1, 0]), Err::<Vec<i64>, _>(Overflow));
    assert_eq!(combined(&least, &[1, 0], &1, &[0, 1]), Err::<Vec<i64>, _>(Overflow));
    assert_eq!(combined(&least, &[1, 0], &2, &[0, 1]), Ok(vec![-(1_i64 << 62), 1]));
    assert_eq!(i64::dot(&[1 << 62; 8], &[-(1 << 62); 8]), Err(Overflow));
    assert_eq!(i64::dot(&[1 << 62; 7], &[-(1 << 62); 7]), Ok(-7 << 124));
    assert_eq!(i128::dot(&[i128::MAX; 3], &[i128::MAX; 3]), Err(Overflow));
    assert_eq!(i128::dot(&[i128::MAX; 2], &[-i128::MAX; 2]).map(Z::from), Ok(Z::from(i128::MAX).pow(2) * -2));
    let half = -(1_i128 << 126);
    let one = 1.into();
    assert_eq!(combined(&one, &[half, 1], &one, &[half, 0]), Err::<Vec<i128>, _>(Overflow));
    assert_eq!(combined(&one, &[half, 2], &one, &[half, 0]), Ok(vec![half, 1]));
}

#[test]
fn a_matrix_keeps_its_rows() {
    let mut matrix = Matrix::from_rows(2, [[1_i64, 2], [3, 4], [5, 6]]);
    assert_eq!(matrix.swap_remove(0).as_slice(), [1, 2]);
    assert_eq!(matrix, Matrix::from_rows(2, [[5, 6], [3, 4]]));
    assert_eq!(matrix.swap_remove(1).as_slice(), [3, 4]);
    matrix.push_negated(&[7, -8]);
    matrix.append(&Matrix::identity(2));
    assert_eq!(matrix.rows().collect::<Vec<_>>(), [[5, 6], [-7, 8], [1, 0], [0, 1]]);
    assert_eq!((matrix.len(), matrix.row(1)), (4, &[-7, 8][..]));
}

#[test]
#[should_panic(expected = "as many entries as the matrix has columns")]
fn a_row_of_another_length_is_refused() {
    Matrix::<i64>::new(3).push(&[1, 2]);
}
