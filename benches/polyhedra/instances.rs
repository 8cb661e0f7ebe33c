//! The public polyhedra files and a few more that are made here, as coprime integer rows.

use num_traits::Zero as _;
use partplan::cone::format::read;
use partplan::cone::{Extras, Pair, Polyhedron, Representation, convert};
use partplan::exact::{Int, Ladder, Long, Matrix, Overflow, Q, Rung, Z, climb, primitive_row};
use std::any::Any;
use std::fs;
use std::hint::black_box;
use std::path::Path;

/// Rows `(b, a)` of a polyhedron up to a positive factor.
pub struct Instance {
    pub name: String,
    representation: Representation,
    rows: Vec<(bool, Vec<Z>)>,
    columns: usize,
}

/// How many rows the minimal form found has, linear ones apart. Neither the apex of a cone counts nor the facet at infinity,
/// which some programs list and others do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    pub rows: usize,
    pub linear: usize,
}

/// Every instance, by family and name.
pub fn all() -> Vec<Instance> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/polyhedra");
    let mut instances = made();
    for family in fs::read_dir(folder).expect("the polyhedra of the tests") {
        let family = family.expect("a readable folder").path();
        let Ok(files) = fs::read_dir(&family) else { continue };
        for file in files {
            let path = file.expect("a readable folder").path();
            let text = fs::read(&path).expect("a readable file");
            let name = [&family, &path].map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned());
            let document = read(&text).unwrap_or_else(|fault| panic!("{}: {fault}", path.display()));
            instances.push(Instance::of(name.join("/"), &document.polyhedron));
        }
    }
    instances.sort_by(|a, b| a.name.cmp(&b.name));
    instances
}

impl Instance {
    fn of(name: String, polyhedron: &Polyhedron) -> Self {
        let rows = polyhedron.rows().iter().enumerate();
        let rows = rows.map(|(index, row)| (polyhedron.linear().contains(&index), primitive_row(row))).collect();
        Self { name, representation: polyhedron.representation(), rows, columns: polyhedron.columns() }
    }

    fn made(name: &str, representation: Representation, rows: Vec<(bool, Vec<i64>)>) -> Self {
        let columns = rows[0].1.len();
        let rows = rows.into_iter().map(|(linear, row)| (linear, row.into_iter().map(Z::from).collect()));
        Self { name: format!("made/{name}"), representation, rows: rows.collect(), columns }
    }

    /// The instance as the drivers read it.
    pub fn rows(&self) -> String {
        let shape = if self.is_cone() { "cone" } else { "polyhedron" };
        let head = format!("{} {shape} {} {}\n", self.representation.letter(), self.columns, self.rows.len());
        let line = |(linear, row): &(bool, Vec<Z>)| {
            let entries: String = row.iter().map(|entry| format!(" {entry}")).collect();
            format!("{}{entries}\n", u8::from(*linear))
        };
        head + &self.rows.iter().map(line).collect::<String>()
    }

    /// What [`Instance::rows`] wrote.
    pub fn from_rows(text: &str) -> Self {
        let mut words = text.split_whitespace();
        let mut next = || words.next().expect("a complete file of rows");
        let representation = if next() == "H" { Representation::Inequalities } else { Representation::Generators };
        next();
        let mut number = || next().parse::<Z>().expect("an integer");
        let columns = usize::try_from(number()).expect("a count of columns");
        let count = usize::try_from(number()).expect("a count of rows");
        let rows = (0..count).map(|_| (!number().is_zero(), (0..columns).map(|_| number()).collect())).collect();
        Self { name: String::new(), representation, rows, columns }
    }

    /// Rows and columns, and what they are.
    pub fn shape(&self) -> String {
        format!("{} {}×{}", self.representation.letter(), self.rows.len(), self.columns)
    }

    /// Whether the constants are zero throughout, so that their column says nothing.
    fn is_cone(&self) -> bool {
        self.rows.iter().all(|(_, row)| row[0].is_zero())
    }

    /// What the conversion finds.
    pub fn size(&self) -> Size {
        let row = |row: &(bool, Vec<Z>)| {
            let divisor = if self.representation == Representation::Inequalities || row.1[0].is_zero() {
                Z::from(1)
            } else {
                row.1[0].clone()
            };
            row.1.iter().map(|entry| Q::new(entry.clone(), divisor.clone())).collect()
        };
        let linear: Vec<usize> = (0..self.rows.len()).filter(|index| self.rows[*index].0).collect();
        let rows = self.rows.iter().map(row).collect();
        let found = convert(&Polyhedron::new(self.representation, self.columns, rows, &linear), Extras::default());
        let (linear, rows) = (found.polyhedron.linear().len(), found.polyhedron.rows());
        let apex = usize::from(self.is_cone() && self.representation == Representation::Inequalities);
        Size { rows: rows.len().saturating_sub(linear + apex), linear }
    }

    /// A conversion to time, its rows already in the integers of every rung that holds them.
    pub fn conversion(&self) -> impl Fn() {
        let is_cone = self.is_cone();
        let is_inequalities = self.representation == Representation::Inequalities;
        let skipped = usize::from(is_cone);
        let columns = self.columns - skipped;
        let (mut linear, mut others) = (Vec::new(), Vec::new());
        for (is_linear, row) in &self.rows {
            // the kernel's normals point outward
            let row = row[skipped..].iter().map(|entry| if is_inequalities { -entry } else { entry.clone() }).collect();
            if *is_linear { linear.push(row) } else { others.push(row) }
        }
        if is_inequalities && !is_cone {
            others.push((0..columns).map(|column| Z::from(if column == 0 { -1 } else { 0 })).collect());
        }
        let normals = Normals::new(columns, &linear, &others);
        move || {
            climb(&normals, Rung::Word);
        }
    }
}

/// Equalities and normals in the integers of one rung.
type Rows<T> = (Matrix<T>, Matrix<T>);

/// The same equalities and normals on all rungs.
struct Normals {
    word: Option<Rows<i64>>,
    double: Option<Rows<i128>>,
    big: Option<Rows<Long>>,
}

impl Normals {
    fn new(columns: usize, linear: &[Vec<Z>], others: &[Vec<Z>]) -> Self {
        Self {
            word: rows(columns, linear, others),
            double: rows(columns, linear, others),
            big: rows(columns, linear, others),
        }
    }
}

fn rows<T: Int>(columns: usize, linear: &[Vec<Z>], others: &[Vec<Z>]) -> Option<Rows<T>> {
    let matrix = |rows: &[Vec<Z>]| {
        let narrow = |row: &Vec<Z>| row.iter().map(T::from_z).collect::<Option<Vec<T>>>();
        Some(Matrix::from_rows(columns, rows.iter().map(narrow).collect::<Option<Vec<_>>>()?))
    };
    Some((matrix(linear)?, matrix(others)?))
}

impl Ladder for Normals {
    type Output = ();

    fn run<T: Int>(&self) -> Result<(), Overflow> {
        let rungs: [&dyn Any; 3] = [&self.word, &self.double, &self.big];
        let rows = rungs.into_iter().find_map(|rows| rows.downcast_ref::<Option<Rows<T>>>());
        let (linear, others) = rows.and_then(Option::as_ref).ok_or(Overflow)?;
        black_box(Pair::from_normals(linear, others)?);
        Ok(())
    }
}

/// Instances too plain to keep as files.
fn made() -> Vec<Instance> {
    use Representation::{Generators, Inequalities};
    let power = |base: i64, exponents: std::ops::RangeInclusive<u32>| exponents.map(move |k| base.pow(k)).collect();
    let cyclic = (1..=30).map(|base| (false, power(base, 0..=8))).collect();
    let cuts = |nodes: u32, start: u32| (start..1 << (nodes - 1)).map(move |side| cut_vector(nodes, side));
    let cone = cuts(7, 1).map(|cut| (false, [vec![0], cut].concat())).collect();
    let polytope = cuts(6, 0).map(|cut| (false, [vec![1], cut].concat())).collect();
    vec![
        Instance::made("cyclic30_8", Generators, cyclic),
        Instance::made("cutcone7", Generators, cone),
        Instance::made("cutpol6", Generators, polytope),
        Instance::made("perm7", Inequalities, permutahedron(7)),
        Instance::made("psimp4x4", Inequalities, product_of_simplices(4, 4)),
    ]
}

/// Which edges of the complete graph the cut between `side` and the rest crosses.
fn cut_vector(nodes: u32, side: u32) -> Vec<i64> {
    let pairs = (0..nodes).flat_map(|a| (a + 1..nodes).map(move |b| (a, b)));
    pairs.map(|(a, b)| i64::from((side >> a ^ side >> b) & 1)).collect()
}

/// All orders of 1 to n as a point set: every k coordinates sum to at least 1 + … + k.
fn permutahedron(n: u32) -> Vec<(bool, Vec<i64>)> {
    let triangle = |k: u32| i64::from(k * (k + 1) / 2);
    let row = |set: u32| {
        let members = (0..n).map(move |index| i64::from(set >> index & 1));
        (set == (1 << n) - 1, std::iter::once(-triangle(set.count_ones())).chain(members).collect())
    };
    (1..1 << n).rev().map(row).collect()
}

/// `count` simplices of dimension `dim`, each cut from its orthant by one inequality.
fn product_of_simplices(dim: usize, count: usize) -> Vec<(bool, Vec<i64>)> {
    let mut rows = Vec::new();
    for factor in 0..count {
        let own = factor * dim + 1..=factor * dim + dim;
        for column in own.clone() {
            rows.push((false, (0..=dim * count).map(|c| i64::from(c == column)).collect()));
        }
        rows.push((false, (0..=dim * count).map(|c| if c == 0 { 1 } else { -i64::from(own.contains(&c)) }).collect()));
    }
    rows
}
