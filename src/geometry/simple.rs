//! Whether a closed chain of vertices is simple: spikes, repeated vertices, edges that meet.

use super::polygon::{MAX_REPORTED_FAULTS, PolygonFault};
use super::scaled::Scaled;
use super::{cross, difference, dot};
use crate::exact::{Q, Z};
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};
use std::cmp::Ordering;

/// Largest magnitude of a grid coordinate: a difference of products of differences then fits `i128`.
const GRID: i64 = 1 << 60;

/// Faults of the chain in the order of their first vertex, at most [`MAX_REPORTED_FAULTS`]; no edge has zero length.
pub(super) fn faults(vertices: &[[Q; 2]], scaled: &Scaled) -> Vec<PolygonFault> {
    let chain = Chain::new(vertices, scaled);
    let mut faults = repeated_vertices(&chain);
    let spikes = spikes(&chain);
    faults.extend(crossings(&chain, &spikes, MAX_REPORTED_FAULTS.saturating_sub(faults.len() + spikes.len())));
    faults.extend(spikes.into_iter().map(|vertex| PolygonFault::Spike { vertex }));
    faults.truncate(MAX_REPORTED_FAULTS);
    faults
}

/// The chain on a grid of machine integers.
///
/// `order` compares coordinates exactly; `grid` approximates them from below to one unit and is exact when `exact`.
struct Chain<'a> {
    vertices: &'a [[Q; 2]],
    order: Vec<[i64; 2]>,
    grid: Vec<[i64; 2]>,
    exact: bool,
}

impl<'a> Chain<'a> {
    fn new(vertices: &'a [[Q; 2]], scaled: &Scaled) -> Self {
        let fits = |value: &Z| value.to_i64().filter(|v| (-GRID..=GRID).contains(v));
        let exact: Option<Vec<[i64; 2]>> = scaled.points.iter().map(|[x, y]| Some([fits(x)?, fits(y)?])).collect();
        if let Some(grid) = exact {
            return Self { vertices, order: grid.clone(), grid, exact: true };
        }
        let [x, y] = [0, 1].map(|axis| column(&scaled.points, axis));
        let zip = |x: Vec<i64>, y: Vec<i64>| x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
        Self { vertices, order: zip(ranks(&x), ranks(&y)), grid: zip(snapped(&x), snapped(&y)), exact: false }
    }

    fn len(&self) -> usize {
        self.vertices.len()
    }

    fn edge(&self, edge: usize) -> [usize; 2] {
        [edge, (edge + 1) % self.len()]
    }

    /// Sign of `(b - a) × (c - a)`.
    fn turn(&self, a: usize, b: usize, c: usize) -> Ordering {
        let d = |to: usize, axis: usize| i128::from(self.grid[to][axis]) - i128::from(self.grid[a][axis]);
        let (x1, y1, x2, y2) = (d(b, 0), d(b, 1), d(c, 0), d(c, 1));
        let product = x1 * y2 - y1 * x2;
        // every difference is off by less than 1 in an inexact grid, which is exact up to a positive factor per axis
        let doubt = if self.exact { 0 } else { x1.abs() + y1.abs() + x2.abs() + y2.abs() + 2 };
        if self.exact || product.abs() > doubt {
            return product.cmp(&0);
        }
        let [a, b, c] = [a, b, c].map(|i| &self.vertices[i]);
        cross(&difference(a, b), &difference(a, c)).cmp(&Q::zero())
    }

    fn in_box(&self, edge: [usize; 2], point: usize) -> bool {
        (0..2).all(|axis| {
            let (a, b, p) = (self.order[edge[0]][axis], self.order[edge[1]][axis], self.order[point][axis]);
            a.min(b) <= p && p <= a.max(b)
        })
    }
}

fn column(points: &[[Z; 2]], axis: usize) -> Vec<&Z> {
    points.iter().map(|point| &point[axis]).collect()
}

fn ranks(values: &[&Z]) -> Vec<i64> {
    let mut sorted: Vec<usize> = (0..values.len()).collect();
    sorted.sort_by_key(|i| values[*i]);
    let mut ranks = vec![0; values.len()];
    let mut rank = 0;
    for pair in sorted.windows(2) {
        rank += i64::from(values[pair[0]] != values[pair[1]]);
        ranks[pair[1]] = rank;
    }
    ranks
}

fn snapped(values: &[&Z]) -> Vec<i64> {
    let (Some(min), Some(max)) = (values.iter().min(), values.iter().max()) else {
        return Vec::new();
    };
    let extent = (*max - *min).max(Z::one());
    let snap = |value: &Z| ((value - *min) * GRID / &extent).to_i64();
    values.iter().map(|value| snap(value).expect("a share of the extent lies on the grid")).collect()
}

fn repeated_vertices(chain: &Chain) -> Vec<PolygonFault> {
    let mut sorted: Vec<usize> = (0..chain.len()).collect();
    sorted.sort_by_key(|i| (chain.order[*i], *i));
    let mut faults: Vec<(usize, usize)> = sorted
        .windows(2)
        .filter(|pair| chain.order[pair[0]] == chain.order[pair[1]])
        .map(|pair| (pair[0], pair[1]))
        .collect();
    faults.sort_unstable();
    faults
        .into_iter()
        .take(MAX_REPORTED_FAULTS)
        .map(|(first, second)| PolygonFault::RepeatedVertex { first, second })
        .collect()
}

fn spikes(chain: &Chain) -> Vec<usize> {
    let n = chain.len();
    (0..n)
        .filter(|vertex| {
            let (before, after) = ((vertex + n - 1) % n, (vertex + 1) % n);
            chain.turn(*vertex, before, after) == Ordering::Equal && {
                let [at, before, after] = [*vertex, before, after].map(|i| &chain.vertices[i]);
                dot(&difference(at, before), &difference(at, after)).is_positive()
            }
        })
        .take(MAX_REPORTED_FAULTS)
        .collect()
}

fn crossings(chain: &Chain, spikes: &[usize], limit: usize) -> Vec<PolygonFault> {
    let n = chain.len();
    let bounds: Vec<[[i64; 2]; 2]> = (0..n)
        .map(|edge| {
            let [a, b] = chain.edge(edge).map(|i| chain.order[i]);
            [0, 1].map(|axis| [a[axis].min(b[axis]), a[axis].max(b[axis])])
        })
        .collect();
    let mut by_left_end: Vec<usize> = (0..n).collect();
    by_left_end.sort_by_key(|edge| bounds[*edge][0][0]);

    let mut found = Vec::new();
    let mut active: Vec<usize> = Vec::new();
    'sweep: for edge in by_left_end {
        let [[left, _], [low, high]] = bounds[edge];
        active.retain(|other| bounds[*other][0][1] >= left);
        for &other in &active {
            let (first, second) = (edge.min(other), edge.max(other));
            let neighbours = second - first == 1 || (first == 0 && second == n - 1);
            let [other_low, other_high] = bounds[other][1];
            if neighbours || other_high < low || high < other_low {
                continue;
            }
            if let Some(at) = meeting_point(chain, first, second)
                && !belongs_to_spike(chain, spikes, [first, second], &at)
            {
                if found.len() == limit {
                    break 'sweep;
                }
                found.push((first, second, at));
            }
        }
        active.push(edge);
    }
    found.sort_by_key(|(first, second, _)| (*first, *second));
    found.into_iter().map(|(first, second, at)| PolygonFault::Crossing { first, second, at }).collect()
}

/// Whether two edges, both next to a spike's, meet only because it turns back over one of its neighbours.
fn belongs_to_spike(chain: &Chain, spikes: &[usize], edges: [usize; 2], at: &[Q; 2]) -> bool {
    let n = chain.len();
    spikes.iter().any(|vertex| {
        let [far_before, before, after] = [vertex + n - 2, vertex + n - 1, vertex + 1].map(|i| i % n);
        let is_pair = |a: usize, b: usize| edges == [a.min(b), a.max(b)];
        (is_pair(before, after) && *at == chain.vertices[after])
            || (is_pair(far_before, *vertex) && *at == chain.vertices[before])
    })
}

/// A common point of two edges; `None` also where two equal vertices meet, which is a fault of its own.
fn meeting_point(chain: &Chain, first: usize, second: usize) -> Option<[Q; 2]> {
    let ([a, b], [c, d]) = (chain.edge(first), chain.edge(second));
    let (abc, abd) = (chain.turn(a, b, c), chain.turn(a, b, d));
    if abc == abd && abc != Ordering::Equal {
        return None;
    }
    let (cda, cdb) = (chain.turn(c, d, a), chain.turn(c, d, b));
    if cda == cdb && cda != Ordering::Equal {
        return None;
    }
    let ends = [(abc, [a, b], c), (abd, [a, b], d), (cda, [c, d], a), (cdb, [c, d], b)];
    if ends.iter().all(|(turn, _, _)| *turn != Ordering::Equal) {
        return Some(proper_crossing(chain, [a, b], [c, d]));
    }
    let touches = |(turn, edge, point): &(Ordering, [usize; 2], usize)| {
        *turn == Ordering::Equal
            && chain.in_box(*edge, *point)
            && edge.iter().all(|end| chain.order[*end] != chain.order[*point])
    };
    ends.iter().find(|end| touches(end)).map(|(_, _, point)| chain.vertices[*point].clone())
}

fn proper_crossing(chain: &Chain, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> [Q; 2] {
    let [a, b, c, d] = [a, b, c, d].map(|i| &chain.vertices[i]);
    let (along, other, gap) = (difference(a, b), difference(c, d), difference(a, c));
    let s = cross(&gap, &other) / cross(&along, &other);
    [&a[0] + &along[0] * &s, &a[1] + &along[1] * &s]
}
