//! Section 3: Betti numbers, from the ranks of the boundary matrices.

use std::collections::BTreeMap;

use super::cells::Cells;

/// Arithmetic modulo a prime: 2 gives Z/2, a large one stands for Q.
const LARGE_PRIME: u64 = (1 << 31) - 1;

/// β₀, β₁ and β₂ over Z/2.
pub(super) fn betti_z2(cells: &Cells) -> [usize; 3] {
    betti(cells, 2)
}

/// β₀, β₁ and β₂ over Q: modulo a prime larger than any torsion that a small complex can have.
pub(super) fn betti_q(cells: &Cells) -> [usize; 3] {
    betti(cells, LARGE_PRIME)
}

/// dim ker ∂ₖ − rank ∂ₖ₊₁ for k = 0, 1, 2.
fn betti(cells: &Cells, prime: u64) -> [usize; 3] {
    let proper = cells.proper();
    let of_edges = cells.ends.iter().map(|&[a, b]| [(a as usize, -1), (b as usize, 1)].into());
    let of_faces = proper.iter().map(|&f| face_boundary(cells, f));
    let first = rank(of_edges.collect(), prime);
    let second = rank(of_faces.collect(), prime);
    [cells.referenced.len() - first, cells.ends.len() - first - second, proper.len() - second]
}

/// The sum of a face's sides, each with its sign.
fn face_boundary(cells: &Cells, face: usize) -> BTreeMap<usize, i64> {
    let mut boundary = BTreeMap::new();
    for place in 0..cells.faces[face].len() {
        let word = &cells.faces[face];
        let sign = if word[place] < word[(place + 1) % word.len()] { 1 } else { -1 };
        *boundary.entry(cells.edge(face, place)).or_insert(0) += sign;
    }
    boundary
}

/// The rank of a matrix given by its rows, by elimination: each row is reduced by those before it.
fn rank(rows: Vec<BTreeMap<usize, i64>>, prime: u64) -> usize {
    let mut by_leader: BTreeMap<usize, BTreeMap<usize, u64>> = BTreeMap::new();
    for row in rows {
        let residue = |x: i64| x.rem_euclid(prime as i64) as u64;
        let mut row: BTreeMap<usize, u64> = row.into_iter().map(|(column, x)| (column, residue(x))).collect();
        row.retain(|_, x| *x != 0);
        while let Some((&leader, &value)) = row.first_key_value() {
            let Some(pivot) = by_leader.get(&leader) else {
                let scale = inverse(value, prime);
                row.values_mut().for_each(|x| *x = *x * scale % prime);
                by_leader.insert(leader, row);
                break;
            };
            for (&column, &x) in pivot {
                let entry = row.entry(column).or_insert(0);
                *entry = (*entry + (prime - value) * x) % prime;
            }
            row.retain(|_, x| *x != 0);
        }
    }
    by_leader.len()
}

/// By Fermat's little theorem.
fn inverse(value: u64, prime: u64) -> u64 {
    let (mut power, mut base, mut exponent) = (1, value, prime - 2);
    while exponent > 0 {
        if exponent % 2 == 1 {
            power = power * base % prime;
        }
        base = base * base % prime;
        exponent /= 2;
    }
    power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rank_depends_on_the_field() {
        let rows = vec![[(0, 1), (1, 1)].into(), [(0, 1), (1, -1)].into(), BTreeMap::new()];
        assert_eq!(rank(rows.clone(), 2), 1);
        assert_eq!(rank(rows, LARGE_PRIME), 2);
    }

    #[test]
    fn inverses_are() {
        for value in [1, 2, 3, 1 << 20, LARGE_PRIME - 1] {
            assert_eq!(value * inverse(value, LARGE_PRIME) % LARGE_PRIME, 1);
        }
        assert_eq!(inverse(1, 2), 1);
    }
}
