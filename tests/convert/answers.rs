//! Polyhedra whose answers are known by hand.

use super::support::{int, q};
use super::{PLAIN, converted, polyhedron, words};
use partplan::cone::format::{read, write};
use partplan::cone::{Extras, Polyhedron, Representation, canonical, convert, project, without_redundancy};

const BOTH: Extras = Extras { adjacency: true, incidence: true };
const SQUARE: &str = "H-representation\nbegin\n4 3 integer\n1 1 0\n1 -1 0\n1 0 1\n1 0 -1\nend\n";

#[test]
fn the_square_has_four_corners_in_a_ring() {
    let found = convert(&polyhedron(SQUARE), BOTH);
    assert_eq!(words(found.polyhedron.rows()), ["1 -1 -1", "1 -1 1", "1 1 -1", "1 1 1"]);
    assert_eq!(found.adjacency.unwrap(), [vec![1, 2], vec![0, 3], vec![0, 3], vec![1, 2]]);
    assert_eq!(found.incidence.unwrap(), [vec![0, 2], vec![0, 3], vec![1, 2], vec![1, 3]]);
    assert_eq!(found.dimension, Some(2));
}

#[test]
fn the_ways_to_write_a_file_do_not_matter() {
    let plain = "H-representation\nlinearity 1 2\nbegin\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend\n";
    let rows = [vec![q("1/2"), q("-1/3"), int(0)], vec![int(-1), int(1), int(1)], vec![int(0), int(1), int(0)]];
    let expected = Polyhedron::new(Representation::Inequalities, 3, rows.to_vec(), &[1]);
    assert_eq!(polyhedron(plain), expected);
    for other in [
        "name\n* comment\nh-representation\nlinearity 1 2\nbegin\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend",
        "H-representation\nbegin\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend\nlinearity 1 2\n",
        "H-representation\nbegin\nlinearity 1 2\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend",
        "H-representation\nbegin\n3 3 rational\nlinearity 1 2\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend",
        "H-representation\nbegin\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend\nequality 1 2",
        "H-representation\npartial_enumeration 1\n 2\nbegin\n3 3 rational\n1/2 -1/3 0\n-1 1 1\n0 1 0\nend",
        "H-representation\r\nlinearity 1 2\r\nbegin\r\n3 3 rational\r\n1/2 -1/3 0\r\n-1 1 1\r\n0 1 0\r\nend\r\n",
        "\u{feff}H-representation\nlinearity 1 2\nbegin 3 3 rational 1/2\n-1/3\n0 -1\n\n1 1 0 1\n0 end",
        "H-representation\nlinearity 1 2\nbegin\n***** 3 rational\n1/2 -1/3 0\n* middle\n-1 1 1\n0 1 0\nend",
        "H-representation\nlinearity 1 2\nbegin\n* size\n3 3 real\n.5 -2/6 0.0\n-1. +1 1e0\n0 10.0E-01 -.0\nend",
    ] {
        assert_eq!(read(other.as_bytes()).map(|document| document.polyhedron), Ok(expected.clone()), "{other}");
    }
}

#[test]
fn options_are_ignored_aloud() {
    let text = "first\nbegin\n1 2 integer\n1 1\nend\nhull\nincidence\nmaximize\n0 1\n1 2\nnonsense here\n";
    assert_eq!(
        read(text.as_bytes()).unwrap().warnings,
        [
            "line 6: option \"hull\" has no effect",
            "line 7: option \"incidence\" has no effect",
            "line 8: option \"maximize\" has no effect",
            "line 11: \"nonsense\" is not understood and ignored",
            "no line says H-representation or V-representation: read as H-representation",
        ]
    );
    let many = SQUARE.to_owned() + &"nonsense\n".repeat(1000);
    let warnings = read(many.as_bytes()).unwrap().warnings;
    assert_eq!((warnings.len(), warnings[10].as_str()), (11, "990 more lines are ignored"));
}

#[test]
fn decimals_are_the_fractions_that_they_denote() {
    let found = converted("H-representation\nbegin\n2 2 real\n0.1 -1\n-1e-1 0.5\nend");
    assert_eq!(found.dimension, None);
    let found = converted("H-representation\nbegin\n2 2 real\n0.3 -1\n-0.1 1\nend");
    assert_eq!(words(found.polyhedron.rows()), ["1 1/10", "1 3/10"]);
}

#[test]
fn rows_may_be_scaled_by_anything_positive() {
    let big = format!("1{}", "0".repeat(30));
    let scaled = SQUARE.replace("1 -1 0", &format!("{big} -{big} 0")).replace("1 0 -1", "2/4 0 -4/8");
    assert_eq!(converted(&scaled), converted(SQUARE));
    assert_eq!(without_redundancy(&polyhedron(&scaled), PLAIN).polyhedron, polyhedron(&scaled));
    let scaled = format!("V-representation\nbegin\n3 3 rational\n1 0 0\n0 {big} -{big}/3\n0 1/{big} 0\nend");
    let plain = "V-representation\nbegin\n3 3 integer\n1 0 0\n0 3 -1\n0 1 0\nend";
    assert_eq!(converted(&scaled), converted(plain));
}

#[test]
fn an_empty_polyhedron_has_no_generators_and_comes_back_empty() {
    for empty in ["2 2 integer\n-1 1\n0 -1", "1 3 integer\n-1 0 0", "2 3 integer\n1 1 0\n-2 -1 0"] {
        let found = convert(&polyhedron(&format!("H-representation\nbegin\n{empty}\nend")), BOTH);
        assert_eq!((found.dimension, found.polyhedron.rows().len()), (None, 0), "{empty}");
        let back = convert(&found.polyhedron, BOTH);
        assert_eq!((back.dimension, back.polyhedron.rows().len()), (None, 1));
        assert_eq!(back.polyhedron.rows()[0][0], int(-1));
        assert_eq!(convert(&back.polyhedron, BOTH), found);
    }
    let contradiction = polyhedron("H-representation\nlinearity 2 1 2\nbegin\n2 2 integer\n-1 1\n1 1\nend");
    assert_eq!(convert(&contradiction, PLAIN).dimension, None);
    assert_eq!(words(without_redundancy(&contradiction, PLAIN).polyhedron.rows()), ["-1 0"]);
    assert_eq!(project(&contradiction, &[0], PLAIN).dimension, None);
}

#[test]
fn rays_and_lines_without_a_point_start_at_the_origin() {
    let wedge = converted("V-representation\nbegin\n2 3 integer\n0 1 0\n0 1 1\nend");
    assert_eq!(words(wedge.polyhedron.rows()), ["0 0 1", "0 1 -1"]);
    let line = converted("V-representation\nlinearity 1 1\nbegin\n1 3 integer\n0 1 2\nend");
    assert_eq!(
        (words(line.polyhedron.rows()), line.polyhedron.linear(), line.dimension),
        (vec!["0 -2 1".into()], &[0][..], Some(1))
    );
    let back = convert(&line.polyhedron, PLAIN).polyhedron;
    assert_eq!((words(back.rows()), back.linear()), (vec!["0 1 2".into(), "1 0 0".into()], &[0][..]));
}

#[test]
fn the_last_zero_ray_stands_for_the_origin() {
    for (linearity, linear) in [("", &[][..]), ("linearity 2 1 2\n", &[0][..])] {
        let zeros = polyhedron(&format!("V-representation\n{linearity}begin\n2 2 integer\n0 0\n0 0\nend"));
        let found = without_redundancy(&zeros, BOTH);
        assert_eq!((words(found.polyhedron.rows()), found.polyhedron.linear()), (vec!["0 0".into()], linear));
        assert_eq!(
            (found.dimension, found.adjacency, found.fates.unwrap().redundant),
            (Some(0), Some(vec![vec![]]), vec![1])
        );
        assert_eq!(words(convert(&found.polyhedron, PLAIN).polyhedron.rows()), ["0 1"]);
        assert_eq!(words(canonical(&zeros, PLAIN).polyhedron.rows()), ["1 0"]);
    }
}

#[test]
fn the_whole_space_has_no_inequalities() {
    let space = converted("H-representation\nbegin\n0 3 integer\nend");
    assert_eq!(words(space.polyhedron.rows()), ["0 1 0", "0 0 1", "1 0 0"]);
    assert_eq!((space.polyhedron.linear(), space.dimension), (&[0, 1][..], Some(2)));
    let back = convert(&space.polyhedron, PLAIN);
    assert_eq!((back.polyhedron.rows().len(), back.dimension), (0, Some(2)));
    let trivial = converted("H-representation\nbegin\n2 3 integer\n1 0 0\n0 0 0\nend");
    assert_eq!(trivial.polyhedron, space.polyhedron);
}

#[test]
fn a_space_without_variables_has_one_point_or_none() {
    assert_eq!(words(converted("H-representation\nbegin\n1 1 integer\n3\nend").polyhedron.rows()), ["1"]);
    assert_eq!(converted("H-representation\nbegin\n1 1 integer\n-3\nend").polyhedron.rows().len(), 0);
    let point = converted("V-representation\nbegin\n2 1 integer\n1\n1\nend");
    assert_eq!((point.polyhedron.rows().len(), point.dimension), (0, Some(0)));
}

#[test]
fn implicit_equalities_are_told_and_duplicates_keep_the_first() {
    // x1 <= 1 and x1 >= 1 make a plane; 2 x2 >= 0 repeats x2 >= 0; x2 >= -1 is implied
    let text = "H-representation\nbegin\n6 3 integer\n1 -1 0\n0 0 1\n-1 1 0\n0 0 2\n1 0 1\n-1 1 1\nend";
    let found = without_redundancy(&polyhedron(text), BOTH);
    assert_eq!(words(found.polyhedron.rows()), ["1 -1 0", "0 0 1"]);
    assert_eq!((found.polyhedron.linear(), found.dimension), (&[0][..], Some(1)));
    let fates = found.fates.unwrap();
    assert_eq!((fates.kept, fates.redundant, fates.implicit), (vec![0, 1], vec![2, 3, 4, 5], vec![0, 2]));
    assert_eq!(found.adjacency, Some(vec![vec![], vec![]]));
}

#[test]
fn redundant_points_of_a_polytope_are_dropped_by_number() {
    let text = "V-representation\nbegin\n5 3 rational\n1 0 0\n1 1/3 1/3\n1 1 0\n1 0 1\n1 0 1/2\nend";
    let found = without_redundancy(&polyhedron(text), Extras { adjacency: true, incidence: false });
    let fates = found.fates.unwrap();
    assert_eq!((fates.kept, fates.redundant, fates.implicit), (vec![0, 2, 3], vec![1, 4], vec![]));
    assert_eq!(found.adjacency.unwrap(), [vec![1, 2], vec![0, 2], vec![0, 1]]);
}

#[test]
fn a_cube_casts_a_square_shadow_whatever_its_form() {
    let cube = "H-representation\nbegin\n6 4 integer\n1 1 0 0\n1 -1 0 0\n2 0 1 0\n2 0 -1 0\n3 0 0 1\n3 0 0 -1\nend";
    let found = project(&polyhedron(cube), &[2, 0], BOTH);
    assert_eq!(words(found.polyhedron.rows()), ["1 0 -1", "1 0 1", "3 -1 0", "3 1 0"]);
    assert_eq!(found.adjacency.unwrap(), [vec![2, 3], vec![2, 3], vec![0, 1], vec![0, 1]]);
    assert_eq!(found.incidence, None);
    let corners = convert(&polyhedron(cube), PLAIN).polyhedron;
    let found = project(&corners, &[2, 0], PLAIN).polyhedron;
    assert_eq!(words(found.rows()), ["1 -3 -1", "1 -3 1", "1 3 -1", "1 3 1"]);
    assert_eq!(canonical(&found, PLAIN).polyhedron, found);
}

#[test]
fn what_is_written_is_minimal_and_plain() {
    let text = "H-representation\nbegin\n3 2 rational\n3 -1\n5/3 2/3\n9 -1\nend\n";
    assert_eq!(write(&converted(text).polyhedron), "V-representation\nbegin\n 2 2 rational\n 1 -5/2\n 1 3\nend\n");
    let back = convert(&converted(text).polyhedron, PLAIN).polyhedron;
    assert_eq!(write(&back), "H-representation\nbegin\n 2 2 integer\n 3 -1\n 5 2\nend\n");
    let lines = converted("H-representation\nlinearity 1 1\nbegin\n1 3 integer\n1 1 1\nend").polyhedron;
    assert_eq!(write(&lines), "V-representation\nlinearity 1 1\nbegin\n 2 3 integer\n 0 -1 1\n 1 -1 0\nend\n");
}
