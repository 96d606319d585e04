//! Whether two tables of faces are the same but for the names of vertices that only one of them has.

use std::collections::BTreeSet;

use super::surface::canonical;

/// Whether faces are others with new names for the vertices that the others alone have.
///
/// *Cost*: all ways to name up to five vertices; more are told apart by their faces alone.
pub(super) fn same_up_to_names(found: &[Vec<u32>], expected: &[Vec<u32>]) -> bool {
    let vertices = |faces: &[Vec<u32>]| faces.iter().flatten().copied().collect::<BTreeSet<u32>>();
    let (ours, theirs) = (vertices(found), vertices(expected));
    let new: Vec<u32> = ours.difference(&theirs).copied().collect();
    let old: Vec<u32> = theirs.difference(&ours).copied().collect();
    if new.len() != old.len() {
        return false;
    }
    let expected = canonical(expected);
    let fits = |names: &[u32]| canonical(&renamed(found, &new, names)) == expected;
    if new.len() <= 5 {
        permutations(&old).iter().any(|names| fits(names))
    } else {
        fits(&by_faces(found, &expected, &new, &old))
    }
}

fn renamed(faces: &[Vec<u32>], from: &[u32], to: &[u32]) -> Vec<Vec<u32>> {
    let name = |vertex: &u32| from.iter().position(|new| new == vertex).map_or(*vertex, |at| to[at]);
    faces.iter().map(|face| face.iter().map(name).collect()).collect()
}

pub(super) fn permutations(items: &[u32]) -> Vec<Vec<u32>> {
    let Some((&first, rest)) = items.split_first() else { return vec![Vec::new()] };
    let with = |shorter: Vec<u32>| {
        (0..=shorter.len()).map(move |at| {
            let mut longer = shorter.clone();
            longer.insert(at, first);
            longer
        })
    };
    permutations(rest).into_iter().flat_map(with).collect()
}

/// The old names in the order in which the new ones have faces like theirs.
fn by_faces(found: &[Vec<u32>], expected: &[Vec<u32>], new: &[u32], old: &[u32]) -> Vec<u32> {
    let sorted = |faces: &[Vec<u32>], unknown: &[u32]| {
        let mut all: Vec<(Vec<Vec<u32>>, u32)> =
            unknown.iter().map(|&vertex| (faces_at(faces, unknown, vertex), vertex)).collect();
        all.sort();
        all
    };
    let names = sorted(expected, old);
    let places = sorted(found, new);
    let name =
        |vertex: &u32| places.iter().position(|(_, new)| new == vertex).map_or(*vertex, |at| names[at].1);
    new.iter().map(name).collect()
}

/// The faces at a vertex, from it on, without the names that are not known.
fn faces_at(faces: &[Vec<u32>], unknown: &[u32], vertex: u32) -> Vec<Vec<u32>> {
    let at = faces.iter().filter_map(|face| {
        let place = face.iter().position(|&v| v == vertex)?;
        let turned = face[place..].iter().chain(&face[..place]);
        Some(turned.map(|v| if unknown.contains(v) { u32::MAX } else { *v }).collect())
    });
    let mut all: Vec<Vec<u32>> = at.collect();
    all.sort();
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_new_vertices_do_not_matter_and_all_others_do() {
        let square = [vec![0, 1, 2], vec![0, 2, 3]];
        assert!(same_up_to_names(&[vec![9, 0, 2], vec![1, 2, 0]], &square));
        assert!(!same_up_to_names(&[vec![9, 2, 0], vec![1, 2, 0]], &square));
        assert!(!same_up_to_names(&[vec![0, 2, 1], vec![0, 2, 3]], &square));
        assert!(!same_up_to_names(&[vec![0, 1, 2]], &square));
        let ring = |from: u32| (0..7).map(|at| vec![at, (at + 1) % 7, from + at]).collect::<Vec<_>>();
        assert!(same_up_to_names(&ring(20), &ring(10)));
    }
}
