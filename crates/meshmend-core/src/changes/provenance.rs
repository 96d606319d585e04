//! The record of change: where each element of a new mesh came from.
//!
//! A pass says, for each new face, corner and vertex, which old one it is, and which faces it flipped. Everything
//! else (removed, merged, split, created) is derived from that, so the record can't contradict the mesh. Records
//! compose. The map of vertices is then read off the corners: composing vertex maps would claim that a vertex
//! that was welded and then split again came from all the welded ones.

use crate::{Blend, Counts, FaceId, FaceTable, Id, Sources, VertexId};

/// Where every element of a mesh came from.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Provenance {
    /// The size of the mesh before.
    pub before: Counts,
    /// For each new vertex the old vertex whose place it has.
    pub vertices: Sources<VertexId>,
    /// For each new face the old face that it is, or is a part of.
    pub faces: Sources<FaceId>,
    /// For each new corner the old corner that it is.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub corners: Sources<crate::CornerId>,
    /// The new faces that run the other way round than their sources, ascending.
    pub flipped: Vec<FaceId>,
    /// The created vertices with their places in terms of the old mesh, ascending; no place is given where it
    /// depends on elements that were created before, or on none of the old mesh.
    pub created: Vec<(VertexId, Option<Blend>)>,
}

impl Provenance {
    /// The record of no change.
    pub fn same(counts: Counts) -> Self {
        Provenance {
            before: counts,
            vertices: Sources::same(counts.vertices),
            faces: Sources::same(counts.faces),
            corners: Sources::same(counts.corners),
            flipped: Vec::new(),
            created: Vec::new(),
        }
    }

    /// Whether it records that nothing changed.
    pub fn is_same(&self) -> bool {
        self.vertices.is_all_of(self.before.vertices)
            && self.faces.is_all_of(self.before.faces)
            && self.corners.is_all_of(self.before.corners)
            && self.flipped.is_empty()
    }

    /// The record of this change and a later one together.
    ///
    /// `stored` are the faces before this change, `result` those after the later one: the source of a vertex is
    /// the lowest stored vertex behind its corners.
    ///
    /// *Cost*: linear in the elements; constant where the later one changed nothing.
    pub fn then(&self, later: &Provenance, stored: &FaceTable, result: &FaceTable) -> Provenance {
        if later.is_same() {
            return self.clone();
        }
        if self.is_same() && later.vertices.is_all_of(later.before.vertices) {
            return later.clone();
        }
        let corners = self.corners.then(&later.corners);
        let mut vertices: Vec<Option<VertexId>> =
            self.vertices.then(&later.vertices).iter().map(|(_, old)| old).collect();
        let mut is_read_off = vec![false; vertices.len()];
        for corner in result.corners() {
            let vertex = result.corner_vertex(corner).index();
            if let Some(old) = corners.of(corner).map(|c| stored.corner_vertex(c)) {
                let best = if is_read_off[vertex] { vertices[vertex] } else { None };
                vertices[vertex] = Some(best.map_or(old, |b| b.min(old)));
                is_read_off[vertex] = true;
            }
        }
        Provenance {
            before: self.before,
            faces: self.faces.then(&later.faces),
            flipped: self.flipped_with(later),
            created: self.created_with(later),
            vertices: Sources::listed(vertices),
            corners,
        }
    }

    /// The faces that one of the two changes flipped and the other did not.
    fn flipped_with(&self, later: &Provenance) -> Vec<FaceId> {
        let mut was_flipped = vec![false; self.faces.len()];
        self.flipped.iter().for_each(|f| was_flipped[f.index()] = true);
        let mut is_flipped: Vec<bool> =
            later.faces.iter().map(|(_, middle)| middle.is_some_and(|m| was_flipped[m.index()])).collect();
        later.flipped.iter().for_each(|f| is_flipped[f.index()] ^= true);
        is_flipped.iter().enumerate().filter(|(_, flip)| **flip).map(|(f, _)| FaceId::new(f)).collect()
    }

    /// The created vertices that survive the later change, and those that it creates.
    fn created_with(&self, later: &Provenance) -> Vec<(VertexId, Option<Blend>)> {
        let place_of = |vertex: VertexId| {
            let at = self.created.binary_search_by_key(&vertex, |(created, _)| *created);
            at.ok().map(|at| self.created[at].1)
        };
        let kept = later.vertices.iter().filter(|_| !self.created.is_empty());
        let kept = kept.filter_map(|(new, middle)| Some((new, place_of(middle?)?)));
        let own = later
            .created
            .iter()
            .map(|&(v, place)| (v, place.and_then(|p| p.seen_from_before(&self.corners, &self.faces))));
        let mut created: Vec<_> = kept.chain(own).collect();
        created.sort_unstable_by_key(|(vertex, _)| *vertex);
        created
    }

    /// The old faces of which nothing is left, ascending.
    pub fn removed_faces(&self) -> Vec<FaceId> {
        unset(&self.faces.survivors(self.before.faces))
    }

    /// The new faces that do not come from an old one.
    pub fn added_faces(&self) -> usize {
        self.faces.iter().filter(|(_, old)| old.is_none()).count()
    }
}

fn unset<I: Id>(flags: &[bool]) -> Vec<I> {
    flags.iter().enumerate().filter(|(_, set)| !**set).map(|(index, _)| I::new(index)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CornerId, Draft, PolygonMesh};

    fn mesh(vertices: usize, faces: &[[u32; 3]]) -> PolygonMesh {
        let corners = faces.iter().flatten().copied().map(VertexId).collect();
        let table = FaceTable::triangles(vertices, corners).unwrap();
        PolygonMesh::new(vec![[0.0; 3]; vertices], table).unwrap()
    }

    /// The mesh with other names at its corners.
    fn renamed(mesh: &PolygonMesh, sources: &[u32], corners: &[u32]) -> (PolygonMesh, Provenance) {
        let corners = corners.iter().copied().map(VertexId).collect();
        let faces = FaceTable::triangles(sources.len(), corners).unwrap();
        let draft = Draft {
            vertex_sources: Sources::listed(sources.iter().map(|&v| Some(VertexId(v)))),
            ..Draft::of_faces(mesh, faces, Sources::same(2), Sources::same(6))
        };
        mesh.rebuild(draft).unwrap()
    }

    #[test]
    fn what_was_joined_and_parted_again_comes_from_where_it_was() {
        let stored = mesh(6, &[[0, 1, 2], [3, 4, 5]]);
        // Vertices 1 and 4 are joined, then parted again.
        let (joined, first) = renamed(&stored, &[0, 1, 2, 3, 5], &[0, 1, 2, 3, 1, 4]);
        let (parted, second) = renamed(&joined, &[0, 1, 2, 3, 4, 1], &[0, 1, 2, 3, 5, 4]);
        let both = first.then(&second, stored.faces(), parted.faces());
        let sources: Vec<Option<u32>> = both.vertices.iter().map(|(_, old)| old.map(|v| v.0)).collect();
        assert_eq!(sources, [0, 1, 2, 3, 5, 4].map(Some));
        assert!(!both.is_same(), "the order is another one");
    }

    #[test]
    fn the_source_of_a_vertex_is_one_that_its_corners_had() {
        // Vertex 0 is in no face; joined with 1 it gives its place to it, but not its name.
        let stored = mesh(7, &[[1, 2, 3], [4, 5, 6]]);
        let (joined, first) = renamed(&stored, &[0, 2, 3, 4, 5, 6], &[0, 1, 2, 3, 4, 5]);
        let begin = Provenance::same(stored.counts());
        let both = begin.then(&first, stored.faces(), joined.faces());
        assert_eq!(both.vertices.of(VertexId(0)), Some(VertexId(1)));
    }

    #[test]
    fn two_flips_are_none_and_removals_add_up() {
        let record = |faces: &[u32], flipped: &[u32], before: usize| Provenance {
            before: Counts { vertices: 0, faces: before, corners: 0 },
            vertices: Sources::same(0),
            faces: Sources::listed(faces.iter().map(|&f| Some(FaceId(f)))),
            corners: Sources::<CornerId>::same(0),
            flipped: flipped.iter().copied().map(FaceId).collect(),
            created: Vec::new(),
        };
        let empty = FaceTable::empty(0);
        let first = record(&[0, 2, 3, 4], &[0, 2], 5);
        let both = first.then(&record(&[1, 2, 0], &[0, 1], 4), &empty, &empty);
        assert_eq!(both.flipped, [FaceId(0), FaceId(2)]);
        assert_eq!(both.removed_faces(), [FaceId(1), FaceId(4)]);
        assert_eq!(both.added_faces(), 0);
    }

    #[test]
    fn sources_are_equal_when_each_element_has_the_same_one() {
        let listed = |sources: &[Option<u32>]| -> Sources<FaceId> {
            Sources::listed(sources.iter().map(|source| source.map(FaceId)))
        };
        assert_eq!(listed(&[Some(0), Some(1)]), Sources::same(2));
        for other in [&[Some(1), Some(0)][..], &[Some(0), None], &[Some(0)], &[Some(0), Some(1), Some(2)]] {
            assert_ne!(listed(other), Sources::same(2), "{other:?}");
        }
    }

    #[test]
    fn a_list_that_changes_nothing_is_the_same() {
        let prefix: Sources<FaceId> = Sources::listed([Some(FaceId(0)), Some(FaceId(1))]);
        assert!(prefix.is_same() && prefix.is_all_of(2) && !prefix.is_all_of(3));
        assert_eq!(prefix.survivors(3), [true, true, false]);
        assert!(!prefix.is_empty() && Sources::<FaceId>::same(0).is_empty());
        let created: Sources<FaceId> = Sources::listed([None]);
        assert_eq!((created.len(), created.of(FaceId(0))), (1, None));
    }
}
