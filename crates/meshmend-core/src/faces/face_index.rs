//! Which face a corner is of, and the corners beside it there: the part of an index that table kernels have in common.

use std::sync::Arc;

use crate::{Array, Column, CornerId, FaceId, FaceTable, Id, Per};

/// A face table with the face of each corner at once.
///
/// *Layout*: the table, which the mesh shares, and 4 bytes a corner unless every face is a triangle.
#[derive(Clone, Debug)]
pub struct FaceIndex {
    faces: Arc<FaceTable>,
    /// Absent when every face is a triangle.
    corner_face: Option<Column<CornerId, FaceId>>,
}

impl FaceIndex {
    /// The index of a table. *Cost*: O(1) when every face is a triangle, else one pass over the corners.
    pub fn new(faces: Arc<FaceTable>) -> Self {
        let corner_face = (!faces.is_all_triangles()).then(|| {
            let mut owners = Vec::with_capacity(faces.corner_count());
            let sizes = faces.faces().map(|face| (face, faces.corner_range(face).len()));
            sizes.for_each(|(face, size)| owners.extend(std::iter::repeat_n(face, size)));
            owners.into()
        });
        FaceIndex { faces, corner_face }
    }

    /// The table.
    #[inline]
    pub fn faces(&self) -> &FaceTable {
        &self.faces
    }

    /// The face that a corner is of. *Cost*: O(1).
    #[inline]
    pub fn corner_face(&self, corner: CornerId) -> FaceId {
        match &self.corner_face {
            None => FaceId(corner.0 / 3),
            Some(owners) => owners[corner],
        }
    }

    /// The corner after another in its face. *Cost*: O(1).
    #[inline]
    pub fn next_corner(&self, corner: CornerId) -> CornerId {
        match &self.corner_face {
            None => CornerId(if corner.0 % 3 == 2 { corner.0 - 2 } else { corner.0 + 1 }),
            Some(owners) => self.faces.corner_after(owners[corner], corner),
        }
    }

    /// The corner before another in its face. *Cost*: O(1).
    #[inline]
    pub fn prev_corner(&self, corner: CornerId) -> CornerId {
        match &self.corner_face {
            None => CornerId(if corner.0.is_multiple_of(3) { corner.0 + 2 } else { corner.0 - 1 }),
            Some(owners) => self.faces.corner_before(owners[corner], corner),
        }
    }

    /// The array beside the table, if there is one.
    pub fn array(&self) -> Option<Array> {
        let owners = self.corner_face.as_ref()?;
        Some(Array::of_column("corner face", Per::Corner, owners))
    }

    /// Bytes on the heap beside the table.
    pub fn heap_bytes(&self) -> usize {
        self.corner_face.as_ref().map_or(0, Column::heap_bytes)
    }
}

impl FaceTable {
    /// The corner after another in the face that it is of.
    #[inline]
    pub fn corner_after(&self, face: FaceId, corner: CornerId) -> CornerId {
        let range = self.corner_range(face);
        let next = corner.index() + 1;
        CornerId::new(if next == range.end { range.start } else { next })
    }

    /// The corner before another in the face that it is of.
    #[inline]
    pub fn corner_before(&self, face: FaceId, corner: CornerId) -> CornerId {
        let range = self.corner_range(face);
        CornerId::new(if corner.index() == range.start { range.end } else { corner.index() } - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FaceTableBuilder, VertexId};

    #[test]
    fn triangles_and_polygons_have_their_corners_in_a_ring() {
        for sizes in [vec![3, 3, 3], vec![3, 5, 1, 4]] {
            let mut builder = FaceTableBuilder::default();
            sizes.iter().for_each(|&size| builder.push_face((0..size).map(VertexId)));
            let table = Arc::new(builder.build(9).unwrap());
            let index = FaceIndex::new(table.clone());
            for face in table.faces() {
                let corners: Vec<CornerId> = table.face_corners(face).collect();
                for (place, &corner) in corners.iter().enumerate() {
                    let next = corners[(place + 1) % corners.len()];
                    assert_eq!(index.corner_face(corner), face);
                    assert_eq!((index.next_corner(corner), index.prev_corner(next)), (next, corner));
                }
            }
            assert_eq!(index.heap_bytes() == 0, table.is_all_triangles());
        }
    }
}
