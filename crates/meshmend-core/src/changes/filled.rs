//! What faces that fill a hole have of the attributes round it.

use std::ops::Range;

use crate::{CornerId, Draft, FaceId, Id, Layer, NO_VALUE, Role, Values};

/// Faces that a pass creates to close a hole, and what lies round that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilledHole {
    /// The new faces, by their places.
    pub faces: Range<usize>,
    /// For each side of the hole the old face beside it.
    pub beside: Vec<FaceId>,
    /// New corners at vertices of the hole, each with the two old corners at the ends of the hole's sides there.
    pub corners: Vec<(CornerId, [CornerId; 2])>,
}

/// Gives new faces the name that most of the faces round their hole have, of those that as many have the one of the lowest
/// face. Numbers are not given.
///
/// *Cost*: O(n log n) in the sides of the holes.
pub(super) fn name_faces(layer: &Layer, draft: &Draft, uses: &mut [u32]) {
    if !matches!(*layer.values, Values::Text(_)) || layer.role() == Role::Identity {
        return;
    }
    for hole in &draft.filled {
        let name = most_frequent(layer, &hole.beside);
        uses[hole.faces.clone()].fill(name);
    }
}

/// The use that most of some faces have; of several the one of the lowest face.
fn most_frequent(layer: &Layer, faces: &[FaceId]) -> u32 {
    let mut faces = faces.to_vec();
    faces.sort_unstable();
    let uses = faces.iter().map(|face| layer.element_use(face.index()));
    let mut by_value: Vec<(u32, usize)> = uses.zip(0..).collect();
    let order = |one: u32, other: u32| match (one == NO_VALUE, other == NO_VALUE) {
        (false, false) => layer.cmp_values(one, other),
        (one, other) => one.cmp(&other),
    };
    by_value.sort_by(|one, other| order(one.0, other.0).then(one.1.cmp(&other.1)));
    let groups = by_value.chunk_by(|one, other| order(one.0, other.0).is_eq());
    let best = groups.max_by_key(|group| (group.len(), std::cmp::Reverse(group[0].1)));
    best.map_or(NO_VALUE, |group| group[0].0)
}

/// Gives new corners the value that both corners beside them have, if these are the same to the bit.
///
/// *Cost*: linear in the corners of the filled holes.
pub(super) fn give_agreed_values(layer: &Layer, draft: &Draft, uses: &mut [u32]) {
    for (corner, beside) in draft.filled.iter().flat_map(|hole| &hole.corners) {
        let [one, other] = beside.map(|corner| layer.element_use(corner.index()));
        if layer.same_value(one, other) {
            uses[corner.index()] = one;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, Domain};

    #[test]
    fn most_faces_name_it_and_of_equal_numbers_the_lowest_face() {
        let names = Values::Text(["a", "b", "a"].map(|name| name.as_bytes().to_vec()).to_vec());
        let uses = vec![1, 0, 2, 1, 1, NO_VALUE];
        let layer = Layer::indexed("material", Domain::Face, 1, Carry::Copy, names, uses);
        let named =
            |faces: &[u32]| most_frequent(&layer, &faces.iter().copied().map(FaceId).collect::<Vec<_>>());
        assert_eq!(named(&[0, 1, 2]), 0, "two have the name `a`");
        assert_eq!(named(&[1, 0]), 1, "face 0 is the lowest");
        assert_eq!(named(&[4, 3, 2, 1]), 0);
        assert_eq!(named(&[5, 5, 1]), NO_VALUE);
    }
}
