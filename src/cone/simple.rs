//! Pairs of sets of equal size that differ in one member, found without comparing all pairs.

use super::bits::{BitRows, count, intersect, members};

/// Takes out of `ones` and `others` the sets of `size` members, in turn, and appends their pairs with `size - 1` common
/// members to `found`; unless comparing all pairs is cheaper.
///
/// Each set of the smaller list is filed under all of its subsets with one member less, and found there by those of the
/// larger one.
///
/// # Cost
/// O((a + b) `size`) look-ups for a sets and b others.
///
/// # Source
/// The subfacets of simplicial facets in Bruns, Ichim & Söger, The power of pyramid decomposition in Normaliz (2016), §2.
pub(super) fn match_simple(
    on: &BitRows,
    size: usize,
    ones: &mut Vec<usize>,
    others: &mut Vec<usize>,
    found: &mut Vec<(usize, usize)>,
) {
    let is_simple = |ray: &usize| count(on.row(*ray)) == size;
    let [n_ones, n_others] = [&*ones, &*others].map(|list| list.iter().copied().filter(|ray| is_simple(ray)).count());
    // a look-up takes about as long as this many comparisons
    const LOOK_UP: usize = 16;
    if n_ones * n_others <= LOOK_UP * size * (n_ones + n_others) {
        return;
    }
    let [simple_ones, simple_others]: [Vec<usize>; 2] =
        [ones, others].map(|list| list.extract_if(.., |ray| is_simple(ray)).collect());
    pair_up(on, size, &simple_ones, &simple_others, found);
}

fn pair_up(on: &BitRows, size: usize, ones: &[usize], others: &[usize], found: &mut Vec<(usize, usize)>) {
    let is_swapped = ones.len() > others.len();
    let (few, many) = if is_swapped { (others, ones) } else { (ones, others) };
    let mut files = Files::with_room_for(few.len() * size);
    for ray in few.iter().copied() {
        subsets(on.row(ray)).for_each(|key| files.insert(key, ray));
    }
    for ray in many.iter().copied() {
        for key in subsets(on.row(ray)) {
            for filed in files.under(key) {
                // sets that only look alike have fewer common members
                if count(&intersect(on.row(filed), on.row(ray))) + 1 == size {
                    found.push(if is_swapped { (ray, filed) } else { (filed, ray) });
                }
            }
        }
    }
}

/// Keys of the subsets that lack one member.
fn subsets(set: &[u64]) -> impl Iterator<Item = u64> {
    let whole = members(set).fold(0, |key, member| key ^ scattered(member));
    members(set).map(move |member| whole ^ scattered(member))
}

/// Of splitmix64; a set has the exclusive or of its members.
fn scattered(member: usize) -> u64 {
    let mut bits = (member as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ bits >> 31
}

/// An open hash table from keys to rays; a key may have several.
struct Files {
    slots: Vec<(u64, usize)>,
}

const FREE: usize = usize::MAX;

impl Files {
    fn with_room_for(count: usize) -> Self {
        Self { slots: vec![(0, FREE); (2 * count + 1).next_power_of_two()] }
    }

    fn insert(&mut self, key: u64, ray: usize) {
        let mut at = self.first(key);
        while self.slots[at].1 != FREE {
            at = self.next(at);
        }
        self.slots[at] = (key, ray);
    }

    fn under(&self, key: u64) -> impl Iterator<Item = usize> {
        let chain = std::iter::successors(Some(self.first(key)), |at| Some(self.next(*at)));
        let filled = chain.map(|at| self.slots[at]).take_while(|slot| slot.1 != FREE);
        filled.filter(move |slot| slot.0 == key).map(|slot| slot.1)
    }

    fn first(&self, key: u64) -> usize {
        key as usize & (self.slots.len() - 1)
    }

    fn next(&self, at: usize) -> usize {
        (at + 1) & (self.slots.len() - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        /// Among sets of other sizes, over one word and over several, on one side and on both.
        #[test]
        fn pairs_are_those_that_comparison_finds(
            universe in 5_usize..90, sets in proptest::collection::btree_set(proptest::collection::btree_set(0_usize..90, 2..5), 0..60),
            split in 0_usize..60,
        ) {
            let sets: BTreeSet<BTreeSet<usize>> =
                sets.iter().map(|set| set.iter().map(|member| member % universe).collect()).collect();
            let mut on = BitRows::new(universe);
            sets.iter().for_each(|set| on.push(universe, |member| set.contains(&member)));
            let sets: Vec<_> = sets.into_iter().collect();
            let simple: Vec<usize> = (0..sets.len()).filter(|ray| sets[*ray].len() == 3).collect();
            let (ones, others) = simple.split_at(split.min(simple.len()));
            let is_pair = |one: usize, other: usize| sets[one].intersection(&sets[other]).count() == 2;
            let expected: BTreeSet<(usize, usize)> = ones
                .iter()
                .flat_map(|one| others.iter().map(|other| (*one, *other)))
                .filter(|(one, other)| is_pair(*one, *other))
                .collect();
            let mut found = Vec::new();
            pair_up(&on, 3, ones, others, &mut found);
            prop_assert_eq!(found.len(), expected.len());
            prop_assert_eq!(found.into_iter().collect::<BTreeSet<_>>(), expected);
        }
    }
}
