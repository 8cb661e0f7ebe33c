//! The ladder of integer types: the same answers on every rung, and no rung higher than needed.

use super::draw::runs;
use super::naive::{Forms, Row, forms, forms_of_normals};
use partplan::cone::{Cone, HalfSpaces, Pair, volume_in_box};
use partplan::exact::{Int, Ladder, Matrix, Overflow, Q, Rung, Z, climb, primitive_row};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Both forms of a cone from one of them.
#[derive(Debug)]
struct Conversion {
    dim: usize,
    equalities: Vec<Vec<Z>>,
    normals: Vec<Vec<Z>>,
}

impl Conversion {
    fn of(normals: Vec<Vec<Z>>) -> Self {
        Self { dim: normals[0].len(), equalities: Vec::new(), normals }
    }

    /// From the generators back, by the polar cone.
    fn back(forms: &Forms) -> Self {
        let (equalities, normals) = (forms.lines.clone(), forms.rays.clone());
        let dim = [&forms.equalities, &forms.facets, &equalities, &normals].iter().find_map(|rows| rows.first());
        Self { dim: dim.expect("the two forms of a cone are not both empty").len(), equalities, normals }
    }

    fn by_brute_force(&self) -> Forms {
        let [equalities, normals] = [&self.equalities, &self.normals].map(|rows| {
            rows.iter().map(|row| row.iter().cloned().map(Q::from_integer).collect()).collect::<Vec<Row>>()
        });
        forms_of_normals(self.dim, &equalities, &normals)
    }
}

fn fitted<T: Int>(columns: usize, rows: &[Vec<Z>]) -> Result<Matrix<T>, Overflow> {
    let mut matrix = Matrix::new(columns);
    for row in rows {
        matrix.push(&row.iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)?);
    }
    Ok(matrix)
}

impl Ladder for Conversion {
    type Output = Forms;

    fn run<T: Int>(&self) -> Result<Forms, Overflow> {
        let pair = Pair::<T>::from_normals(&fitted(self.dim, &self.equalities)?, &fitted(self.dim, &self.normals)?)?;
        Ok(forms(&pair))
    }
}

fn power(bits: u32) -> Z {
    Z::from(2).pow(bits)
}

/// Small numbers, and numbers of about 40, 80 and 200 bits.
fn number() -> impl Strategy<Value = Z> {
    let small = (-9..=9_i64).prop_map(Z::from);
    let large = (select(vec![20_u32, 40, 80, 200]), -1000..=1000_i64, -9..=9_i64);
    prop_oneof![3 => small, 2 => large.prop_map(|(bits, high, low)| power(bits) * high + low)]
}

/// Normals that all hold at some point, so that the cone is more than its apex.
fn conversion() -> impl Strategy<Value = Conversion> {
    (1..=4_usize).prop_flat_map(|dim| {
        let equalities = prop_oneof![4 => Just(Vec::new()), 1 => vec(vec(number(), dim), 1)];
        (equalities, vec(vec(number(), dim), 1..=5)).prop_map(move |(equalities, mut normals)| {
            for row in &mut normals {
                if row.iter().sum::<Z>() > Z::from(0) {
                    row.iter_mut().for_each(|v| *v = -&*v);
                }
            }
            Conversion { dim, equalities, normals }
        })
    })
}

proptest! {
    #![proptest_config(runs(120))]

    #[test]
    fn every_rung_gives_the_same_cone(job in conversion()) {
        let expected = job.by_brute_force();
        let lowest = [job.run::<i64>().is_ok(), job.run::<i128>().is_ok(), true];
        let rungs = [Rung::Word, Rung::DoubleWord, Rung::Big];
        for (start, rung) in rungs.into_iter().enumerate() {
            let first = (start..3).find(|i| lowest[*i]).unwrap();
            let (found, on) = climb(&job, rung);
            prop_assert_eq!(&found, &expected);
            prop_assert_eq!(on, rungs[first]);
            let (back, _) = climb(&Conversion::back(&found), rung);
            prop_assert_eq!((back.equalities, back.facets), (found.lines, found.rays));
            prop_assert_eq!((back.lines, back.rays), (found.equalities, found.facets));
        }
    }
}

fn rows(values: &[&[Z]]) -> Vec<Vec<Z>> {
    values.iter().map(|row| row.to_vec()).collect()
}

/// Three normals whose common rays have entries of twice their bits.
fn twisted(bits: u32) -> Conversion {
    let [zero, one] = [0, 1].map(Z::from);
    let [a, b, c] = [15, 37, 111].map(|v| power(bits) + v);
    Conversion::of(rows(&[&[one.clone(), a, zero.clone()], &[zero.clone(), one.clone(), b], &[c, zero, one]]))
}

fn rung(job: &Conversion) -> Rung {
    let (found, rung) = climb(job, Rung::Word);
    assert_eq!(found, job.by_brute_force());
    rung
}

#[test]
fn a_rung_is_left_when_rays_outgrow_it() {
    assert_eq!(rung(&twisted(2)), Rung::Word);
    assert_eq!(rung(&twisted(30)), Rung::Word);
    assert_eq!(rung(&twisted(40)), Rung::DoubleWord);
    assert_eq!(rung(&twisted(80)), Rung::Big);
    assert_eq!(rung(&twisted(200)), Rung::Big);
}

#[test]
fn entries_beyond_a_type_start_on_the_rung_that_holds_them() {
    let wedge = |slope: Z| Conversion::of(rows(&[&[slope, Z::from(-1)], &[Z::from(-1), Z::from(0)]]));
    assert_eq!(rung(&wedge(power(63) - 1)), Rung::Word);
    assert_eq!(rung(&wedge(power(63))), Rung::DoubleWord);
    assert_eq!(rung(&wedge(power(127) - 1)), Rung::DoubleWord);
    assert_eq!(rung(&wedge(power(127))), Rung::Big);
    assert_eq!(rung(&wedge(power(200))), Rung::Big);
}

/// The negative of `i64::MIN` does not fit `i64`, so that no entry may have this value.
#[test]
fn the_least_integer_of_a_type_is_left_to_the_next_rung() {
    let wedge = |slope: Z| Conversion::of(rows(&[&[slope, Z::from(-1)], &[Z::from(-1), Z::from(0)]]));
    assert_eq!(rung(&wedge(1 - power(63))), Rung::Word);
    assert_eq!(rung(&wedge(-power(63))), Rung::DoubleWord);
    assert_eq!(rung(&wedge(1 - power(127))), Rung::DoubleWord);
    assert_eq!(rung(&wedge(-power(127))), Rung::Big);
}

/// Products of more than 64 bits are no reason to climb as long as the primitive rays are small.
#[test]
fn common_factors_do_not_climb() {
    let a = power(40);
    let [zero, one] = [0, 1].map(Z::from);
    let job = Conversion::of(rows(&[
        &[-&a, a.clone(), zero.clone()],
        &[zero.clone(), -&a, a.clone()],
        &[a.clone(), zero.clone(), -(&a + &a)],
        &[-one, zero.clone(), zero],
    ]));
    assert_eq!(rung(&job), Rung::Word);
}

#[test]
fn scaled_rows_start_small_once_they_are_primitive() {
    let ten = Z::from(10).pow(30);
    let scaled = |row: [i64; 3]| primitive_row(&row.map(|v| Q::new(&ten * v, Z::from(7))));
    let job = Conversion::of(vec![scaled([1, 2, 3]), scaled([-4, 0, 6]), scaled([0, 0, -5])]);
    assert_eq!(job.normals, [[1, 2, 3], [-2, 0, 3], [0, 0, -1]].map(|row| row.map(Z::from).to_vec()));
    assert_eq!(rung(&job), Rung::Word);
}

/// All operations on two cones, as the canonical rows of their results.
struct Operations {
    twist: u32,
}

impl Ladder for Operations {
    type Output = (Vec<Forms>, Q);

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let normals = fitted::<T>(3, &twisted(self.twist).normals)?;
        let mut system = HalfSpaces::none(3);
        system.strict = Matrix::from_rows(3, [normals.row(0)]);
        system.closed = Matrix::from_rows(3, [normals.row(1), normals.row(2)]);
        let one = Cone::from_half_spaces(&system)?.expect("three independent rows can all be negative");
        system.strict.clear();
        let two = Cone::from_half_spaces(&system)?.expect("a closed cone holds its apex");
        let mut results = vec![one.sum(&two)?, one.image(&normals)?];
        results.extend(one.intersection(&two)?);
        results.extend(partplan::cone::subtract(&two, &one)?);
        let volume = volume_in_box(&one, &[1, 2, 3].map(|v| Q::from_integer(v.into())))?;
        Ok((results.iter().map(|cone| forms(cone.closure())).collect(), volume))
    }
}

/// At 31 bits rays just fit a word, and the sections that measure the volume do not: those alone are done in big integers.
#[test]
fn every_rung_gives_the_same_sums_images_differences_and_volumes() {
    for (twist, expected) in [(4, Rung::Word), (31, Rung::Word), (40, Rung::DoubleWord), (90, Rung::Big)] {
        let job = Operations { twist };
        let (found, rung) = climb(&job, Rung::Word);
        assert_eq!(rung, expected, "with entries of {twist} bits");
        for lowest in [Rung::DoubleWord, Rung::Big] {
            assert_eq!(climb(&job, lowest).0, found);
        }
    }
}
