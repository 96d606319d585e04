//! Small questions about a cyclic sequence of vertices.

/// The place at which the lexicographically least rotation of a cycle begins.
///
/// Two cycles are equal up to rotation exactly when their least rotations are equal.
///
/// ```
/// # use meshmend_core::canonical_rotation;
/// assert_eq!(canonical_rotation(&[3, 1, 2]), 1);
/// assert_eq!(canonical_rotation(&[1, 2, 1, 1]), 2);
/// ```
///
/// *Cost*: linear, however often a value repeats. *Source*: K. S. Booth, Lexicographically least circular
/// substrings, 1980, in the two-pointer form.
pub fn canonical_rotation<T: Ord>(cycle: &[T]) -> usize {
    let n = cycle.len();
    let at = |place: usize| if place < n { &cycle[place] } else { &cycle[place - n] };
    let (mut best, mut rival, mut matched) = (0, 1, 0);
    while best < n && rival < n && matched != n {
        match at(best + matched).cmp(at(rival + matched)) {
            std::cmp::Ordering::Equal => {
                matched += 1;
                continue;
            }
            std::cmp::Ordering::Less => rival += matched + 1,
            std::cmp::Ordering::Greater => best += matched + 1,
        }
        if best == rival {
            rival += 1;
        }
        matched = 0;
    }
    best.min(rival)
}

/// How many different values a sequence holds.
///
/// *Cost*: quadratic up to sixteen values, n log n beyond.
pub fn distinct_count<T: Ord + Copy>(sequence: &[T]) -> usize {
    if sequence.len() <= 16 {
        return (0..sequence.len()).filter(|&i| !sequence[..i].contains(&sequence[i])).count();
    }
    let mut sorted = sequence.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    sorted.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONGEST: u32 = if cfg!(miri) { 3 } else { 6 };

    /// All sequences of up to so many values out of three.
    fn sequences() -> impl Iterator<Item = Vec<u8>> {
        (1..=LONGEST).flat_map(|n| (0..3usize.pow(n)).map(move |code| digits(code, n)))
    }

    fn digits(code: usize, n: u32) -> Vec<u8> {
        (0..n).map(|i| (code / 3usize.pow(i) % 3) as u8).collect()
    }

    #[test]
    fn the_rotation_is_the_least_of_all() {
        for cycle in sequences() {
            let rotated = |start: usize| [&cycle[start..], &cycle[..start]].concat();
            let least = (0..cycle.len()).map(rotated).min().unwrap();
            assert_eq!(rotated(canonical_rotation(&cycle)), least, "{cycle:?}");
        }
    }

    #[test]
    fn both_ways_of_counting_agree() {
        for sequence in sequences() {
            let long = sequence.repeat(17);
            assert_eq!(distinct_count(&sequence), distinct_count(&long), "{sequence:?}");
        }
    }
}
