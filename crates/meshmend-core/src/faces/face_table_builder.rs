//! A face table that is collected face by face.

use crate::{FaceTable, FaceTableError, VertexId};

/// Collects faces one by one; no starts are stored while all of them are triangles.
#[derive(Clone, Debug, Default)]
pub struct FaceTableBuilder {
    starts: Option<Vec<u32>>,
    corners: Vec<VertexId>,
    open: usize,
}

impl FaceTableBuilder {
    /// Makes room for so many further corners.
    pub fn reserve(&mut self, corners: usize) {
        self.corners.reserve_exact(corners);
    }

    /// Adds a corner to the face that is being built.
    #[inline]
    pub fn push_corner(&mut self, vertex: VertexId) {
        self.corners.push(vertex);
    }

    /// How many corners have been added, those of the open face included.
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// How many faces have been ended.
    pub fn face_count(&self) -> usize {
        self.starts.as_ref().map_or(self.open / 3, |starts| starts.len() - 1)
    }

    /// Ends the face that is being built, however many corners it has.
    #[inline]
    pub fn end_face(&mut self) {
        let end = self.corners.len();
        if self.starts.is_none() && end - self.open != 3 {
            self.starts = Some((0..=self.open).step_by(3).map(|start| start as u32).collect());
        }
        if let Some(starts) = &mut self.starts {
            starts.push(end.min(u32::MAX as usize) as u32);
        }
        self.open = end;
    }

    /// Adds a whole face.
    pub fn push_face(&mut self, vertices: impl IntoIterator<Item = VertexId>) {
        self.corners.extend(vertices);
        self.end_face();
    }

    /// Adds all faces that another builder has ended.
    ///
    /// *Cost*: a copy while all faces of both are triangles, else a step a face.
    pub fn append(&mut self, other: &Self) {
        let ended = &other.corners[..other.open];
        match &other.starts {
            None if self.starts.is_none() => {
                self.corners.extend_from_slice(ended);
                self.open += ended.len();
            }
            None => ended.chunks_exact(3).for_each(|face| self.push_face(face.iter().copied())),
            Some(starts) => {
                let face = |pair: &[u32]| &ended[pair[0] as usize..pair[1] as usize];
                starts.windows(2).for_each(|pair| self.push_face(face(pair).iter().copied()));
            }
        }
    }

    /// Forgets the corners of the face that is being built.
    #[inline]
    pub fn abandon_face(&mut self) {
        self.corners.truncate(self.open);
    }

    /// Forgets all faces, and keeps the memory for others.
    pub fn clear(&mut self) {
        (self.starts, self.open) = (None, 0);
        self.corners.clear();
    }

    /// The table over so many vertices.
    ///
    /// # Errors
    /// As [`FaceTable::polygons`].
    pub fn build(self, vertex_count: usize) -> Result<FaceTable, FaceTableError> {
        FaceTable::of_parts(vertex_count, self.starts, self.corners)
    }
}
