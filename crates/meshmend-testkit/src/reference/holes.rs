//! Faces with holes: which they are, and what is wrong with the pieces that one was cut into.
//!
//! Such faces are cut along diagonals of the program's own choice, so a repair of them is judged instead of compared.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::Zero;

use super::corners::{fold_spikes, simple_loops};
use super::sheets::{cross, dot, minus, plus};
use super::{Point, weld};

/// The faces that come back to a vertex, and of whose loops one turns against the face as a whole.
pub fn faces_with_holes(positions: &[Point], faces: &[Vec<u32>]) -> Vec<u32> {
    let welded = weld(positions);
    let name = |v: u32| welded[v as usize];
    let has_hole = |face: &Vec<u32>| {
        if face.iter().any(|&v| positions[v as usize].is_none()) {
            return false;
        }
        let word = fold_spikes(face, name);
        let loops = simple_loops(&word, name);
        let whole = area_vector(positions, &word);
        loops.len() > 1
            && word.len() > 2
            && loops.iter().any(|found| dot(&area_vector(positions, found), &whole) < BigRational::zero())
    };
    (0..faces.len() as u32).filter(|&f| has_hole(&faces[f as usize])).collect()
}

/// A face without spikes, by welded vertices.
pub fn word_of(positions: &[Point], face: &[u32]) -> Vec<u32> {
    let welded = weld(positions);
    let names: Vec<u32> = face.iter().map(|&v| welded[v as usize]).collect();
    fold_spikes(&names, |v| v)
}

/// The loops of three corners or more into which a word falls at repeated vertices, inner loops first.
pub fn loops_of(word: &[u32]) -> Vec<Vec<u32>> {
    simple_loops(word, |v| v)
}

/// What is wrong with the pieces of a face with holes; all are lists of welded vertices, the word without spikes.
///
/// The pieces are simple, over the face's own vertices; their rim is the face's rim, but for its bridges (sides that it
/// runs both ways), along which pieces may be joined; no edge has more than two of their sides, and those two run
/// opposite ways; and together they cover what the face covers: equal area vectors, and no piece turns against it.
pub fn hole_faults(positions: &[Point], word: &[u32], pieces: &[Vec<u32>]) -> Vec<String> {
    let (mut found, whole) = (Vec::new(), area_vector(positions, word));
    let mut sides: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    let mut total = std::array::from_fn(|_| BigRational::zero());
    let own: BTreeSet<u32> = word.iter().copied().collect();
    for piece in pieces {
        let different: BTreeSet<u32> = piece.iter().copied().collect();
        if different.len() < piece.len() || piece.len() < 3 || !different.is_subset(&own) {
            found.push(format!("{piece:?} is not a simple face over the face's vertices"));
        }
        let area = area_vector(positions, piece);
        total = plus(&total, &area);
        if dot(&area, &whole) < BigRational::zero() {
            found.push(format!("{piece:?} turns against the face"));
        }
        sides_of(piece).for_each(|side| *sides.entry(side).or_default() += 1);
    }
    if total != whole {
        found.push(format!("the pieces cover {total:?}, the face {whole:?}"));
    }
    if sides.values().any(|&count| count > 1) {
        found.push("two pieces run along an edge the same way".into());
    }
    if rim(&sides.into_keys().collect()) != rim(&sides_of(word).collect()) {
        found.push("the rim of the pieces is not that of the face".into());
    }
    found
}

/// Twice the area vector of a closed polygon.
fn area_vector(positions: &[Point], corners: &[u32]) -> [BigRational; 3] {
    let points: Vec<&[BigRational; 3]> =
        corners.iter().filter_map(|&v| positions[v as usize].as_ref()).collect();
    let mut total = std::array::from_fn(|_| BigRational::zero());
    for pair in points.windows(2).skip(1) {
        total = plus(&total, &cross(&minus(pair[0], points[0]), &minus(pair[1], points[0])));
    }
    total
}

fn sides_of(word: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    word.iter().zip(word.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// The sides whose edge is not run the other way.
fn rim(sides: &BTreeSet<[u32; 2]>) -> BTreeSet<[u32; 2]> {
    sides.iter().filter(|[a, b]| !sides.contains(&[*b, *a])).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Soup;
    use crate::reference::exact_positions;

    fn ring() -> (Vec<Point>, Vec<u32>) {
        let at = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [1, 3], [3, 3], [3, 1]];
        let positions = at.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec();
        let positions = exact_positions(&Soup { positions, faces: Vec::new() });
        (positions, vec![0, 1, 2, 3, 0, 4, 5, 6, 7, 4])
    }

    #[test]
    fn a_ring_has_a_hole_and_a_figure_of_two_loops_has_none() {
        let (positions, ring) = ring();
        let faces = [ring, vec![0, 1, 4, 2, 3, 4], vec![0, 1, 2]];
        assert_eq!(faces_with_holes(&positions, &faces), [0]);
    }

    #[test]
    fn right_pieces_have_no_faults_and_others_have_theirs() {
        let (positions, ring) = ring();
        let right = [vec![0, 1, 2, 6, 7, 4], vec![0, 4, 5, 6, 2, 3]];
        assert_eq!(hole_faults(&positions, &ring, &right), [""; 0]);
        let filled = [vec![0, 1, 2, 3], vec![4, 5, 6, 7]];
        assert_eq!(hole_faults(&positions, &ring, &filled), ["[4, 5, 6, 7] turns against the face"]);
        let twice = [right.to_vec(), vec![vec![0, 1, 2]]].concat();
        assert_eq!(hole_faults(&positions, &ring, &twice).len(), 3);
    }
}
