//! Polyhedra and cones in the exchange format of cddlib and lrslib, with the results of independent programs.

use super::naive::{Row, coprime, echelon, forms, forms_of_normals, rank, reduced, rows_of};
use super::support::{dot, q};
use num_traits::{One, Zero};
use partplan::cone::{Generators, Pair};
use partplan::exact::{Int, Ladder, Matrix, Overflow, Q, Rung, climb, primitive_row};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Rows `(b, a)` of `b + a x >= 0`, or points `(1, x)` and rays `(0, x)`; the first of them equalities or lines.
struct File {
    is_inequalities: bool,
    dim: usize,
    linear: Vec<Row>,
    others: Vec<Row>,
}

fn read(path: &Path) -> File {
    let text = fs::read_to_string(path).unwrap();
    let (head, rest) = text.split_once("begin").unwrap();
    let (body, tail) = rest.split_once("end").unwrap();
    let linearity = head.lines().chain(tail.lines()).find_map(|line| line.strip_prefix("linearity"));
    let linear: Vec<usize> =
        linearity.unwrap_or("0").split_whitespace().skip(1).map(|word| word.parse().unwrap()).collect();
    let mut words = body.split_whitespace();
    let [count, dim] = [0; 2].map(|_: i32| words.next().unwrap().parse::<usize>().unwrap());
    let numbers: Vec<Q> = words.skip(1).map(q).collect();
    let rows: Vec<Row> = numbers.chunks(dim).map(<[Q]>::to_vec).collect();
    assert_eq!(rows.len(), count, "{}", path.display());
    let part = |is_linear: bool| {
        let own = rows.iter().enumerate().filter(|(i, _)| linear.contains(&(i + 1)) == is_linear);
        own.map(|(_, row)| row.clone()).collect()
    };
    File { is_inequalities: head.contains("H-representation"), dim, linear: part(true), others: part(false) }
}

fn unit(dim: usize) -> Row {
    (0..dim).map(|i| if i == 0 { Q::one() } else { Q::zero() }).collect()
}

fn negated(rows: &[Row]) -> Vec<Row> {
    rows.iter().map(|row| row.iter().map(|v| -v).collect()).collect()
}

fn fitted<T: Int>(columns: usize, rows: &[Row]) -> Result<Matrix<T>, Overflow> {
    let mut matrix = Matrix::new(columns);
    for row in rows {
        matrix.push(&primitive_row(row).iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)?);
    }
    Ok(matrix)
}

/// The other form, as rows of the file format: lines or equalities, and the rest.
impl Ladder for File {
    type Output = (Vec<Row>, Vec<Row>);

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let mut others = if self.is_inequalities { negated(&self.others) } else { self.others.clone() };
        if self.is_inequalities {
            others.push(negated(&[unit(self.dim)]).remove(0));
        } else if others.iter().all(|row| row[0].is_zero()) {
            others.push(unit(self.dim));
        }
        let (linear, others) = (fitted::<T>(self.dim, &self.linear)?, fitted::<T>(self.dim, &others)?);
        let pair = if self.is_inequalities {
            Pair::from_normals(&linear, &others)?
        } else {
            Pair::from_generators(&Generators { lines: linear, rays: others })?
        };
        let generators = Generators { lines: pair.lines().clone(), rays: pair.rays().clone() };
        assert_eq!(Pair::from_normals(pair.equalities(), pair.facets())?, pair);
        assert_eq!(Pair::from_generators(&generators)?, pair);
        Ok(if self.is_inequalities {
            (rows_of(pair.lines()), rows_of(pair.rays()))
        } else {
            (rows_of(pair.equalities()), negated(&rows_of(pair.facets())))
        })
    }
}

/// The canonical text that the expected digests are of: as the kernel's form, but with pivots from the last column on,
/// ordered by pivot, without the apex of a cone and without the side at infinity.
fn canonical(file: &File, linear: &[Row], others: &[Row]) -> (usize, usize, String) {
    if file.is_inequalities && others.iter().all(|row| row[0].is_zero()) {
        return (0, 0, "empty".into());
    }
    let backwards = |rows: &[Row]| -> Vec<Row> { rows.iter().map(|r| r.iter().rev().cloned().collect()).collect() };
    let basis = echelon(file.dim, &backwards(linear));
    let mut rest: Vec<_> = backwards(others).iter().map(|row| coprime(&reduced(&basis, row))).collect();
    rest.iter_mut().for_each(|row| row.reverse());
    let trivial = coprime(&unit(file.dim));
    let is_cone = rest.iter().filter(|row| !row[0].is_zero()).count() == 1;
    rest.retain(|row| *row != trivial || (file.is_inequalities && !is_cone));
    rest.sort();
    let mut lines: Vec<_> = basis.iter().rev().map(coprime).collect();
    lines.iter_mut().for_each(|row| row.reverse());
    let text = |rows: &[Vec<_>], tag: &str| -> String {
        rows.iter().map(|row| [tag.into(), row.iter().map(|v| format!("{v},")).collect::<String>()].concat()).collect()
    };
    (rest.len(), lines.len(), text(&lines, "L") + &text(&rest, "R"))
}

fn fnv(text: &str) -> String {
    let digest = text
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{digest:016x}")
}

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/polyhedra")
}

#[test]
fn conversions_agree_with_independent_programs() {
    let text = fs::read_to_string(folder().join("expected.json")).unwrap();
    let Value::Object(expected) = serde_json::from_str(&text).unwrap() else { panic!("an object of instances") };
    let mut faults = Vec::new();
    for (name, instance) in &expected {
        let file = read(&folder().join(name));
        let ((linear, others), _) = climb(&file, Rung::Word);
        if !name.starts_with("classic") {
            assert_eq!(climb(&file, Rung::Big).0, (linear.clone(), others.clone()), "{name}");
        }
        let (rays, lines, text) = canonical(&file, &linear, &others);
        let found = serde_json::json!({ "rays": rays, "lines": lines, "hash": fnv(&text) });
        if found != *instance {
            faults
                .push(format!("{name}: {found} instead of {instance}: {}", text.chars().take(200).collect::<String>()));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A cone with a facet that floating-point conversions lost: <https://github.com/cddlib/cddlib/issues/44>.
#[test]
fn the_cone_of_cddlib_issue_44_has_all_of_its_facets() {
    let file = read(&folder().join("cddlib_issue_44.ext"));
    let rays: Vec<Row> = file.others.iter().map(|row| row[1..].to_vec()).collect();
    let polar = Pair::from_normals(&Matrix::new(3), &fitted::<i64>(3, &rays).unwrap()).unwrap();
    assert_eq!(forms(&polar), forms_of_normals(3, &[], &rays));
    let cone = polar.into_polar();
    assert_eq!((cone.facets().len(), cone.equalities().len(), cone.lines().len()), (4, 0, 0));
    for facet in rows_of(cone.facets()) {
        let on: Vec<Row> = rays.iter().filter(|ray| dot(&facet, ray).is_zero()).cloned().collect();
        assert_eq!(rank(3, &on), 2);
    }
}
