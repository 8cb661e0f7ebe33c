//! How a convex body rests on a flat floor, and which of its resting places look the same.

use super::{Polygon, cross, difference, dot};
use crate::exact::Q;
use num_traits::{Signed as _, Zero as _};

/// Whether a body with these corners, counter-clockwise, rests stably on edge `edge`: its center of mass projects strictly
/// inside the edge.
#[must_use]
pub fn rests_on(corners: &[[Q; 2]], center_of_mass: &[Q; 2], edge: usize) -> bool {
    let (start, end) = (&corners[edge], &corners[(edge + 1) % corners.len()]);
    let along = difference(start, end);
    dot(&difference(start, center_of_mass), &along).is_positive()
        && dot(&difference(end, center_of_mass), &along).is_negative()
}

/// The least number of hull edges by which a turn about the center of mass moves the outline onto itself; the number of
/// all hull edges if only a whole turn does.
#[must_use]
pub fn symmetry_shift(outline: &Polygon, center_of_mass: &[Q; 2]) -> usize {
    let corners = without_flat_corners(outline.vertices());
    let arms: Vec<[Q; 2]> = corners.iter().map(|corner| difference(center_of_mass, corner)).collect();
    let next = |index: usize| &arms[(index + 1) % arms.len()];
    // equal products of neighboring arms: a turn takes each pair to the other
    let signature: Vec<[Q; 3]> = arms
        .iter()
        .enumerate()
        .map(|(index, arm)| [dot(arm, arm), dot(arm, next(index)), cross(arm, next(index))])
        .collect();
    let n = signature.len();
    let is_turn = |shift: usize| (0..n).all(|index| signature[index] == signature[(index + shift) % n]);
    let shift = (1..=n).filter(|shift| n.is_multiple_of(*shift)).find(|shift| is_turn(*shift)).unwrap_or(n);
    outline.hull().len() * shift / n
}

fn without_flat_corners(vertices: &[[Q; 2]]) -> Vec<[Q; 2]> {
    let n = vertices.len();
    let is_corner = |index: &usize| {
        let [before, here, after] = [index + n - 1, *index, index + 1].map(|index| &vertices[index % n]);
        !cross(&difference(before, here), &difference(here, after)).is_zero()
    };
    (0..n).filter(is_corner).map(|index| vertices[index].clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::ratio;

    fn polygon(points: &[[i64; 2]]) -> Polygon {
        Polygon::new(points.iter().map(|p| p.map(|x| ratio(x, 1))).collect()).unwrap()
    }

    #[test]
    fn a_square_has_one_orientation_and_an_oblong_two() {
        let center = [ratio(1, 1), ratio(1, 1)];
        assert_eq!(symmetry_shift(&polygon(&[[0, 0], [2, 0], [2, 2], [0, 2]]), &center), 1);
        assert_eq!(symmetry_shift(&polygon(&[[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]]), &center), 1);
        assert_eq!(symmetry_shift(&polygon(&[[-1, 0], [3, 0], [3, 2], [-1, 2]]), &center), 2);
        assert_eq!(symmetry_shift(&polygon(&[[0, 0], [2, 0], [2, 2], [0, 2]]), &[ratio(1, 1), ratio(9, 10)]), 4);
    }

    #[test]
    fn a_notch_tells_edges_of_the_hull_apart() {
        let center = [ratio(2, 1), ratio(2, 1)];
        let notched = polygon(&[[0, 0], [4, 0], [4, 4], [3, 4], [2, 3], [1, 4], [0, 4]]);
        assert_eq!(symmetry_shift(&notched, &center), 4);
        let twice = polygon(&[[0, 0], [1, 0], [2, 1], [3, 0], [4, 0], [4, 4], [3, 4], [2, 3], [1, 4], [0, 4]]);
        assert_eq!(symmetry_shift(&twice, &center), 2);
    }

    #[test]
    fn a_center_of_mass_over_a_corner_leaves_no_stable_edge() {
        let corners = [[0, 0], [2, 0], [2, 2], [0, 2]].map(|p| p.map(|x| ratio(x, 1)));
        assert!(rests_on(&corners, &[ratio(1, 1), ratio(1, 1)], 0));
        assert!(!rests_on(&corners, &[ratio(2, 1), ratio(1, 1)], 0));
        assert!(!rests_on(&corners, &[ratio(0, 1), ratio(1, 1)], 0));
    }
}
