//! Which of many cycles of vertices repeat an earlier one.
//!
//! Almost no cycle has a repeat. Each cycle gets a number out of so many that most cycles have one of their own. Only
//! cycles that share a number are sorted and compared. So no number decides, and no input takes longer than sorting does.

use meshmend_core::{VertexId, canonical_rotation};

use rayon::prelude::*;

/// Pairs (first, later) of cycles that are equal up to where they begin. They are sorted by the cycle in its least rotation,
/// then by the later one; triangles come before all others.
pub(super) fn repeats<C: Iterator<Item = VertexId>>(
    count: usize,
    cycle: impl Fn(u32) -> C,
) -> Vec<(u32, u32)> {
    let (mut triangles, mut others) = (Vec::new(), Vec::new());
    let mut least: Vec<VertexId> = Vec::new();
    for which in sharing_a_number(count, &cycle) {
        least.clear();
        least.extend(cycle(which));
        let start = canonical_rotation(&least);
        least.rotate_left(start);
        match least[..] {
            [a, b, c] => triangles.push(key([a.0, b.0, c.0, which])),
            _ => others.push((least.clone(), which)),
        }
    }
    triangles.par_sort_unstable();
    others.par_sort_unstable();
    let mut found = Vec::new();
    for run in triangles.chunk_by(|one, other| one >> 32 == other >> 32) {
        found.extend(run[1..].iter().map(|&later| (run[0] as u32, later as u32)));
    }
    for run in others.chunk_by(|one, other| one.0 == other.0) {
        found.extend(run[1..].iter().map(|later| (run[0].1, later.1)));
    }
    found
}

/// Words as one number that sorts as they do.
fn key(words: [u32; 4]) -> u128 {
    words.into_iter().fold(0, |key, word| key << 32 | u128::from(word))
}

/// The cycles that share their number with another one, ascending.
fn sharing_a_number<C: Iterator<Item = VertexId>>(
    count: usize,
    cycle: impl Fn(u32) -> C,
) -> impl Iterator<Item = u32> {
    const NUMBERS_A_CYCLE: usize = 4;
    let numbers = (NUMBERS_A_CYCLE * count).next_power_of_two().clamp(2, 1 << 30);
    let shift = u32::BITS - numbers.trailing_zeros();
    let number = |which| cycle(which).fold(0u32, |sum, v| sum.wrapping_add(spread(v.0))) >> shift;
    let mut uses = vec![0u8; numbers];
    let used: Vec<u32> = (0..count as u32).map(number).collect();
    for &number in &used {
        uses[number as usize] = uses[number as usize].saturating_add(1);
    }
    (0..count as u32).filter(move |&which| uses[used[which as usize] as usize] > 1)
}

/// Another number for a number, so that sums of such numbers are spread evenly.
fn spread(value: u32) -> u32 {
    let value = value.wrapping_mul(0x9E37_79B9);
    (value ^ value >> 15).wrapping_mul(0x85EB_CA6B)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_are_found_again_however_they_are_rotated() {
        let mut state = 7u32;
        let mut next = |below: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % below
        };
        for _ in 0..300 {
            let count = 1 + next(60);
            let cycles: Vec<Vec<VertexId>> =
                (0..count).map(|_| (0..3 + next(3)).map(|_| VertexId(next(5))).collect()).collect();
            let mut found = repeats(cycles.len(), |which| cycles[which as usize].iter().copied());
            found.sort_unstable_by_key(|pair| pair.1);
            let is_rotated = |one: &[VertexId], other: &[VertexId]| {
                let mut turned = one.to_vec();
                one.len() == other.len()
                    && (0..one.len()).any(|_| {
                        turned.rotate_left(1);
                        turned == other
                    })
            };
            let first = |later: u32| {
                (0..later).find(|&one| is_rotated(&cycles[one as usize], &cycles[later as usize]))
            };
            let expected: Vec<(u32, u32)> =
                (0..count).filter_map(|later| Some((first(later)?, later))).collect();
            assert_eq!(found, expected);
        }
    }
}
