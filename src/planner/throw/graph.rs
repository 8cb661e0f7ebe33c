//! Strongly connected components.

/// The components in which a walk may go on for ever: of several nodes, or of one with an arrow to itself.
///
/// Tarjan's algorithm without recursion.
pub(super) fn components(arrows: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let n = arrows.len();
    let (mut order, mut least, mut is_open) = (vec![UNSEEN; n], vec![0; n], vec![false; n]);
    let (mut open, mut count, mut found) = (Vec::new(), 0, Vec::new());
    let mut walk: Vec<(usize, usize)> = Vec::new();
    for root in 0..n {
        if order[root] != UNSEEN {
            continue;
        }
        walk.push((root, 0));
        while let Some(&mut (node, ref mut place)) = walk.last_mut() {
            if *place == 0 {
                (order[node], least[node]) = (count, count);
                count += 1;
                open.push(node);
                is_open[node] = true;
            }
            if let Some(&to) = arrows[node].get(*place) {
                *place += 1;
                if order[to] == UNSEEN {
                    walk.push((to, 0));
                } else if is_open[to] {
                    least[node] = least[node].min(order[to]);
                }
                continue;
            }
            walk.pop();
            if let Some((parent, _)) = walk.last() {
                least[*parent] = least[*parent].min(least[node]);
            }
            if least[node] == order[node] {
                let start = open.iter().rposition(|other| *other == node).unwrap_or(0);
                let component = open.split_off(start);
                component.iter().for_each(|node| is_open[*node] = false);
                if component.len() > 1 || arrows[node].contains(&node) {
                    found.push(component);
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Two nodes are in one component if and only if each is reached from the other.
        #[test]
        fn components_are_what_reaches_itself(
            arrows in proptest::collection::vec(proptest::collection::vec(0..9_usize, 0..3), 9)
        ) {
            let mut reaches = [[false; 9]; 9];
            for (node, to) in arrows.iter().enumerate() {
                to.iter().for_each(|to| reaches[node][*to] = true);
            }
            for k in 0..9 {
                for i in 0..9 {
                    for j in 0..9 {
                        reaches[i][j] |= reaches[i][k] && reaches[k][j];
                    }
                }
            }
            let mut place = [None; 9];
            for (number, component) in components(&arrows).iter().enumerate() {
                component.iter().for_each(|node| place[*node] = Some(number));
            }
            for i in 0..9 {
                prop_assert_eq!(place[i].is_some(), reaches[i][i]);
                for j in 0..9 {
                    prop_assert_eq!(i != j && place[i].is_some() && place[i] == place[j], i != j && reaches[i][j] && reaches[j][i]);
                }
            }
        }
    }
}
