//! The known word nearest to a misspelt one.

/// The candidate at the smallest edit distance, if that is small for the word's length.
pub(super) fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().take(64).collect();
    let limit = (letters.len() / 3).max(1);
    let scored = candidates.iter().map(|candidate| (distance(&letters, candidate), *candidate));
    scored.filter(|(distance, _)| *distance <= limit).min_by_key(|(distance, _)| *distance).map(|(_, word)| word)
}

/// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours; case does not count.
fn distance(word: &[char], other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let same = |a: char, b: char| a.eq_ignore_ascii_case(&b);
    let mut rows = [vec![0; other.len() + 1], (0..=other.len()).collect(), Vec::new()];
    for (i, a) in word.iter().enumerate() {
        let [before, last, _] = &rows;
        let mut row = vec![i + 1];
        for (j, b) in other.iter().enumerate() {
            let mut best = (last[j + 1] + 1).min(row[j] + 1).min(last[j] + usize::from(!same(*a, *b)));
            if i > 0 && j > 0 && same(*a, other[j - 1]) && same(word[i - 1], *b) {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        rows[2] = row;
        rows.rotate_left(1);
    }
    rows[1][other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_counts_single_edits() {
        let between = |a: &str, b: &str| distance(&a.chars().collect::<Vec<_>>(), b);
        assert_eq!(between("kitten", "sitting"), 3);
        assert_eq!(between("fritcion", "friction"), 1);
        assert_eq!(between("", "abc"), 3);
        assert_eq!(between("abc", ""), 3);
        assert_eq!(between("MASS", "mass"), 0);
    }

    #[test]
    fn far_words_are_not_suggested() {
        assert_eq!(nearest("fricton", &["at", "edge", "friction"]), Some("friction"));
        assert_eq!(nearest("color", &["at", "edge", "friction"]), None);
    }
}
