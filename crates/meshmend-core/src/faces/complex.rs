//! What is analysed: the faces as stored, put in normal form.
//!
//! Consecutive repeats of a vertex are dropped, and a face that then has fewer than three different vertices is
//! *degenerate*: it keeps its number but has no corner here, and is listed apart. So a face has the same id in
//! the mesh and in every kernel, every corner has a side and an edge, and no query returns an `Option` for the
//! sake of rubbish. Usually nothing has to change, and the complex shares the mesh's own table.

use std::sync::{Arc, OnceLock};

use crate::edges::vertex_corners::VertexCorners;
use crate::{CornerId, EdgeTable, FaceId, FaceTable, FaceTableBuilder, Id, Sources, VertexId};

/// The normalised faces of a mesh, with the canonical numbering of their edges.
#[derive(Debug)]
pub struct Complex {
    faces: Arc<FaceTable>,
    degenerate: Vec<FaceId>,
    stored_corner: Sources<CornerId>,
    is_as_stored: bool,
    edges: OnceLock<Arc<EdgeTable>>,
    vertex_corners: OnceLock<Arc<VertexCorners>>,
}

impl Complex {
    /// The complex of a table of faces.
    ///
    /// *Cost*: one pass; a second table only where some face is not in normal form.
    pub fn of(faces: &Arc<FaceTable>) -> Self {
        if faces.faces().all(|f| is_normal(faces.face_vertices(f))) {
            let stored_corner = Sources::same(faces.corner_count());
            return Complex {
                faces: Arc::clone(faces),
                degenerate: Vec::new(),
                stored_corner,
                is_as_stored: true,
                edges: OnceLock::new(),
                vertex_corners: OnceLock::new(),
            };
        }
        let mut builder = FaceTableBuilder::default();
        let (mut degenerate, mut stored_corner, mut kept) = (Vec::new(), Vec::new(), Vec::new());
        for face in faces.faces() {
            let vertices = faces.face_vertices(face);
            normal_form(vertices, &mut kept);
            if has_three_different(kept.iter().map(|&i| vertices[i])) {
                let first = faces.corner_range(face).start;
                stored_corner.extend(kept.iter().map(|&i| Some(CornerId::new(first + i))));
                builder.push_face(kept.iter().map(|&i| vertices[i]));
            } else {
                degenerate.push(face);
                builder.end_face();
            }
        }
        // The vertices are those of a well-formed table, and there are no more corners than it has.
        let normal =
            builder.build(faces.vertex_count()).unwrap_or_else(|_| FaceTable::empty(faces.vertex_count()));
        Complex {
            faces: Arc::new(normal),
            degenerate,
            stored_corner: Sources::listed(stored_corner),
            is_as_stored: false,
            edges: OnceLock::new(),
            vertex_corners: OnceLock::new(),
        }
    }

    /// The faces in normal form, degenerate ones without corners.
    #[inline]
    pub fn faces(&self) -> &FaceTable {
        &self.faces
    }

    /// The same faces, to be shared.
    pub fn shared_faces(&self) -> Arc<FaceTable> {
        Arc::clone(&self.faces)
    }

    /// The faces with fewer than three different vertices, ascending.
    pub fn degenerate_faces(&self) -> &[FaceId] {
        &self.degenerate
    }

    /// How many faces take part: F in χ = V − E + F.
    pub fn proper_face_count(&self) -> usize {
        self.faces.face_count() - self.degenerate.len()
    }

    /// The corner of the mesh's own table that a corner of the complex is.
    #[inline]
    pub fn stored_corner(&self, corner: CornerId) -> CornerId {
        self.stored_corner.of(corner).unwrap_or(corner)
    }

    /// Whether the complex is the stored table, corner for corner.
    pub fn is_as_stored(&self) -> bool {
        self.is_as_stored
    }

    /// Whether the edges have been asked for before.
    pub fn has_edges(&self) -> bool {
        self.edges.get().is_some()
    }

    /// The edges, numbered by (smaller vertex, larger vertex); built when first asked for.
    pub fn edges(&self) -> &EdgeTable {
        self.edges.get_or_init(|| Arc::new(EdgeTable::build(&self.faces)))
    }

    /// The same edges, to be shared.
    pub fn shared_edges(&self) -> Arc<EdgeTable> {
        Arc::clone(self.edges.get_or_init(|| Arc::new(EdgeTable::build(&self.faces))))
    }

    /// The corners of each vertex, grouped if nobody has asked for them before, and not kept.
    pub(crate) fn vertex_corners_for_now(&self) -> Arc<VertexCorners> {
        self.vertex_corners.get().cloned().unwrap_or_else(|| Arc::new(VertexCorners::build(&self.faces)))
    }

    /// Keeps the corners of each vertex for whoever asks next.
    pub(crate) fn keep_vertex_corners(&self, corners: Arc<VertexCorners>) {
        self.vertex_corners.get_or_init(|| corners);
    }

    /// The corners of each vertex, to be shared; grouped when first asked for.
    pub(crate) fn shared_vertex_corners(&self) -> Arc<VertexCorners> {
        Arc::clone(self.vertex_corners.get_or_init(|| Arc::new(VertexCorners::build(&self.faces))))
    }
}

/// Whether a face is in normal form already and not degenerate.
fn is_normal(vertices: &[VertexId]) -> bool {
    match *vertices {
        [a, b, c] => a != b && b != c && c != a,
        [] | [_] | [_, _] => false,
        [first, .., last] => {
            first != last
                && vertices.windows(2).all(|pair| pair[0] != pair[1])
                && has_three_different(vertices.iter().copied())
        }
    }
}

/// Puts a face in normal form: consecutive repeats are dropped. Returns whether it is a face of a complex; a degenerate one is left
/// empty.
///
/// ```
/// # use meshmend_core::{VertexId, normalised};
/// let mut normal = Vec::new();
/// assert!(normalised(&[1, 1, 2, 3, 1].map(VertexId), &mut normal));
/// assert_eq!(normal, [1, 2, 3].map(VertexId));
/// assert!(!normalised(&[1, 2, 1, 2].map(VertexId), &mut normal) && normal.is_empty());
/// ```
///
/// *Cost*: linear.
pub fn normalised(face: &[VertexId], normal: &mut Vec<VertexId>) -> bool {
    normal.clear();
    if is_normal(face) {
        normal.extend_from_slice(face);
        return true;
    }
    let mut kept = Vec::new();
    normal_form(face, &mut kept);
    let vertices = kept.iter().map(|&place| face[place]);
    let is_proper = has_three_different(vertices.clone());
    normal.extend(vertices.filter(|_| is_proper));
    is_proper
}

/// The places that stay when consecutive repeats are dropped; the earlier corner stays.
fn normal_form(vertices: &[VertexId], kept: &mut Vec<usize>) {
    kept.clear();
    for (place, vertex) in vertices.iter().enumerate() {
        if kept.last().is_none_or(|&last| vertices[last] != *vertex) {
            kept.push(place);
        }
    }
    while let [first, .., last] = kept[..]
        && vertices[first] == vertices[last]
    {
        kept.pop();
    }
}

fn has_three_different(vertices: impl Iterator<Item = VertexId> + Clone) -> bool {
    let mut rest = vertices.clone();
    let Some(first) = rest.next() else { return false };
    let Some(second) = vertices.clone().find(|&v| v != first) else { return false };
    rest.any(|v| v != first && v != second)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complex(faces: &[&[u32]]) -> Complex {
        let mut builder = FaceTableBuilder::default();
        for face in faces {
            builder.push_face(face.iter().copied().map(VertexId));
        }
        Complex::of(&Arc::new(builder.build(9).unwrap()))
    }

    #[test]
    fn a_proper_table_is_shared() {
        let faces = Arc::new(FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap());
        let complex = Complex::of(&faces);
        assert!(Arc::ptr_eq(&complex.faces, &faces));
        assert!(complex.is_as_stored());
    }

    #[test]
    fn repeats_are_dropped_round_the_end_too_and_the_earlier_corner_stays() {
        let complex = complex(&[&[0, 0, 1, 2, 2, 0, 0]]);
        let corners: Vec<_> = complex.faces().corners().map(|c| complex.stored_corner(c).0).collect();
        assert_eq!(corners, [0, 2, 3]);
    }

    /// The corners that stay are the first ones, and the last one is gone.
    #[test]
    fn a_dropped_last_corner_is_a_change() {
        let complex = complex(&[&[4, 1, 0], &[4, 2, 0, 0]]);
        assert!(!complex.is_as_stored());
    }

    #[test]
    fn degenerate_faces_keep_their_number_and_lose_their_corners() {
        let complex = complex(&[&[0, 1, 0, 1], &[0, 1, 2], &[], &[3], &[4, 4, 4], &[0, 1, 0, 2]]);
        assert_eq!(complex.degenerate_faces(), [0, 2, 3, 4].map(FaceId));
        assert_eq!(complex.proper_face_count(), 2);
        assert_eq!(complex.faces().face_vertices(FaceId(5)).len(), 4);
        assert_eq!(complex.faces().face_vertices(FaceId(0)).len(), 0);
    }
}
