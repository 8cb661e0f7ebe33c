//! What holds for every polyhedron, against definitions and slow oracles.

use super::draw::{generators, inequalities, polyhedra};
use super::support::lp::{Program, Relation};
use super::support::{dot, int};
use super::{PLAIN, rank};
use partplan::cone::format::{read, write};
use partplan::cone::{Extras, Polyhedron, Representation, canonical, convert, project, without_redundancy};
use partplan::exact::{Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Whether the point is in the polyhedron, by substitution or as a combination of generators.
fn contains(polyhedron: &Polyhedron, point: &[Q]) -> bool {
    let homogeneous: Vec<Q> = std::iter::once(int(1)).chain(point.iter().cloned()).collect();
    let rows = polyhedron.rows().iter().enumerate();
    if polyhedron.representation() == Representation::Inequalities {
        return rows.into_iter().all(|(index, row)| {
            let value = dot(row, &homogeneous);
            if polyhedron.is_linear(index) { value == int(0) } else { value >= int(0) }
        });
    }
    if polyhedron.rows().is_empty() {
        return false;
    }
    // lines first: they may be taken any number of times, backwards too
    let (lines, mut others): (Vec<_>, Vec<_>) = rows.partition(|(index, _)| polyhedron.is_linear(*index));
    let origin: Vec<Q> = (0..polyhedron.columns()).map(|column| int(i64::from(column == 0))).collect();
    if others.iter().all(|(_, row)| row[0] == int(0)) {
        others.push((usize::MAX, &origin));
    }
    let mut program = Program::new(lines.len(), others.len());
    for column in 0..polyhedron.columns() {
        let coefficients = lines.iter().chain(&others).map(|(_, row)| row[column].clone()).collect();
        program.require(coefficients, Relation::Equal, homogeneous[column].clone());
    }
    program.is_feasible()
}

/// Whether some point of `{b + a x >= 0}` has the given values of some variables.
fn has_point_over(polyhedron: &Polyhedron, variables: &[usize], values: &[Q]) -> bool {
    let count = polyhedron.columns() - 1;
    let mut program = Program::new(count, 0);
    for (index, row) in polyhedron.rows().iter().enumerate() {
        let relation = if polyhedron.is_linear(index) { Relation::Equal } else { Relation::AtLeast };
        program.require(row[1..].to_vec(), relation, -&row[0]);
    }
    for (variable, value) in variables.iter().zip(values) {
        let unit = (0..count).map(|column| int(i64::from(column == *variable))).collect();
        program.require(unit, Relation::Equal, value.clone());
    }
    program.is_feasible()
}

fn grid(variables: usize) -> Vec<Vec<Q>> {
    (0..variables).fold(vec![Vec::new()], |points, _| {
        let extended = |point: &Vec<Q>| {
            let point = point.clone();
            [-5, -2, -1, 0, 1, 2, 4].map(move |value| [&point[..], &[ratio(value, 2)]].concat())
        };
        points.iter().flat_map(extended).collect()
    })
}

/// A polyhedron and some of its variables, in any order.
fn projections() -> impl Strategy<Value = (Polyhedron, Vec<usize>)> {
    polyhedra().prop_flat_map(|polyhedron| {
        let all: Vec<usize> = (0..polyhedron.columns() - 1).collect();
        let some = (Just(all).prop_shuffle(), 1..polyhedron.columns());
        (Just(polyhedron), some.prop_map(|(all, count)| all[..count].to_vec()))
    })
}

/// Words of the format and others, in any order.
fn babble() -> impl Strategy<Value = String> {
    let words = [
        "begin",
        "end",
        "H-representation",
        "V-representation",
        "linearity",
        "equality",
        "*",
        "*****",
        "\n",
        "\n",
        "0",
        "1",
        "2",
        "3",
        "-1",
        "1/2",
        "1/0",
        "2e5",
        "1e-401",
        ".5",
        "integer",
        "rational",
        "real",
        "hull",
        "name",
        "ä",
    ];
    vec(select(words.to_vec()), 0..40).prop_map(|words| words.join(" "))
}

proptest! {
    #[test]
    fn any_bytes_are_read_or_refused(bytes in vec(any::<u8>(), 0..200)) {
        let _ = read(&bytes);
    }

    #[test]
    fn any_words_are_read_or_refused_and_what_is_read_converts(text in babble()) {
        if let Ok(document) = read(text.as_bytes()) {
            let there = convert(&document.polyhedron, PLAIN).polyhedron;
            prop_assert_eq!(convert(&there, PLAIN).polyhedron, canonical(&document.polyhedron, PLAIN).polyhedron);
        }
    }

    #[test]
    fn what_is_written_is_read_back(polyhedron in polyhedra()) {
        let document = read(write(&polyhedron).as_bytes()).unwrap();
        prop_assert_eq!(document.warnings, [""; 0]);
        prop_assert_eq!(document.polyhedron, polyhedron);
    }

    #[test]
    fn both_representations_hold_the_same_points(polyhedron in polyhedra()) {
        let other = convert(&polyhedron, PLAIN);
        for point in grid(polyhedron.columns() - 1) {
            prop_assert_eq!(contains(&polyhedron, &point), contains(&other.polyhedron, &point), "{:?}", point);
        }
        prop_assert_eq!(&convert(&other.polyhedron, PLAIN), &canonical(&polyhedron, PLAIN));
    }

    #[test]
    fn dropping_redundant_rows_drops_as_many_as_possible(polyhedron in polyhedra()) {
        let found = without_redundancy(&polyhedron, PLAIN);
        let whole = canonical(&polyhedron, PLAIN);
        prop_assert_eq!(&canonical(&found.polyhedron, PLAIN), &whole);
        prop_assert_eq!(found.polyhedron.rows().len(), without_origin(&polyhedron, &whole.polyhedron));
        let fates = found.fates.unwrap();
        if found.dimension.is_some() {
            let kept: Vec<_> = fates.kept.iter().map(|row| polyhedron.rows()[*row].clone()).collect();
            prop_assert_eq!(found.polyhedron.rows(), kept);
            let mut all: Vec<usize> = fates.kept.iter().chain(&fates.redundant).copied().collect();
            all.sort_unstable();
            prop_assert_eq!(all, (0..polyhedron.rows().len()).collect::<Vec<_>>());
        }
    }

    #[test]
    fn vertices_and_rays_are_adjacent_where_tight_rows_leave_one_dimension(polyhedron in inequalities()) {
        let found = convert(&polyhedron, Extras { adjacency: true, incidence: true });
        let (incidence, adjacency) = (found.incidence.unwrap(), found.adjacency.unwrap());
        let n_lines = found.polyhedron.linear().len();
        let rows = found.polyhedron.rows();
        for (row, on) in rows.iter().zip(&incidence) {
            let tight = polyhedron.rows().iter().enumerate().filter(|(_, input)| dot(input, row) == int(0));
            prop_assert_eq!(on, &tight.map(|(index, _)| index).collect::<Vec<_>>());
        }
        let infinity: Vec<Q> = (0..polyhedron.columns()).map(|column| int(i64::from(column == 0))).collect();
        for a in 0..rows.len() {
            for b in 0..rows.len() {
                let mut tight: Vec<Vec<Q>> = incidence[a].iter().filter(|row| incidence[b].contains(row))
                    .map(|row| polyhedron.rows()[*row].clone()).collect();
                if rows[a][0] == int(0) && rows[b][0] == int(0) {
                    tight.push(infinity.clone());
                }
                let is_edge = rank(&tight) + n_lines + 2 == polyhedron.columns();
                let is_adjacent = a != b && a.min(b) >= n_lines && is_edge;
                prop_assert_eq!(adjacency[a].contains(&b), is_adjacent, "{} {}", a, b);
            }
        }
    }

    #[test]
    fn facets_are_adjacent_where_they_share_a_ridge(polyhedron in generators()) {
        let found = convert(&polyhedron, Extras { adjacency: true, incidence: true });
        prop_assume!(found.dimension.is_some());
        let (incidence, adjacency) = (found.incidence.unwrap(), found.adjacency.unwrap());
        let n_equalities = found.polyhedron.linear().len();
        // an origin that goes without saying lies on every facet of its cone
        let has_points = polyhedron.rows().iter().any(|row| row[0] != int(0));
        let origin: Vec<Q> = (0..polyhedron.columns()).map(|column| int(i64::from(column == 0))).collect();
        for a in n_equalities..incidence.len() {
            for b in (n_equalities..incidence.len()).filter(|b| *b != a) {
                let mut common: Vec<Vec<Q>> = incidence[a].iter().filter(|row| incidence[b].contains(row))
                    .map(|row| polyhedron.rows()[*row].clone()).collect();
                if !has_points {
                    common.push(origin.clone());
                }
                let is_ridge = rank(&common) + n_equalities + 2 == polyhedron.columns();
                prop_assert_eq!(adjacency[a].contains(&b), is_ridge, "{} {}", a, b);
            }
        }
    }

    #[test]
    fn a_projection_holds_the_points_under_the_polyhedron((polyhedron, variables) in projections()) {
        let found = project(&polyhedron, &variables, PLAIN).polyhedron;
        prop_assert_eq!(found.representation(), polyhedron.representation());
        prop_assert_eq!(found.columns(), variables.len() + 1);
        prop_assert_eq!(&canonical(&found, PLAIN).polyhedron, &found);
        let whole = match polyhedron.representation() {
            Representation::Inequalities => polyhedron,
            Representation::Generators => convert(&polyhedron, PLAIN).polyhedron,
        };
        for point in grid(variables.len()) {
            prop_assert_eq!(contains(&found, &point), has_point_over(&whole, &variables, &point), "{:?}", point);
        }
    }
}

/// Rows of the minimal form, less the origin if the file leaves it unsaid beside a ray or line.
fn without_origin(given: &Polyhedron, minimal: &Polyhedron) -> usize {
    let is_unsaid = given.representation() == Representation::Generators
        && !given.rows().is_empty()
        && given.rows().iter().all(|row| row[0] == int(0));
    let rows = minimal.rows().len();
    if is_unsaid { rows.max(2) - 1 } else { rows }
}
