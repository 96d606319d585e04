//! The new vertices: the parts of the present ones, in their order.

use meshmend_core::{Column, Connectivity, CornerId, Id, VertexId};

use super::parts::VertexParts;
use crate::stored_vertices::StoredVertices;

/// The new vertices in order, and which of them each corner is at.
pub(crate) struct NewVertices {
    /// The new vertex at each corner of the complex.
    pub(crate) of_corner: Column<CornerId, VertexId>,
    /// For each new vertex the present vertex that it is a part of.
    pub(crate) present: Vec<VertexId>,
    /// For each new vertex its point, which is that of its lowest vertex as stored.
    pub(crate) positions: Vec<[f64; 3]>,
    /// For each present vertex the first new vertex that is a part of it.
    pub(crate) first_part: Vec<VertexId>,
}

const NONE: VertexId = VertexId(u32::MAX);

impl NewVertices {
    /// Each part goes by its lowest stored vertex. The first part (by lowest corner) of each stored vertex keeps that
    /// vertex's place in the order. Further parts follow at the end in corner order; then come vertices in no face of the
    /// complex whose place is taken.
    ///
    /// *Cost*: linear, and n log n in the parts that follow at the end.
    pub(crate) fn of<K: Connectivity>(kernel: &K, stored: &StoredVertices<'_>, parts: &VertexParts) -> Self {
        let pieces = Pieces::of(kernel, stored, parts);
        let count = kernel.vertex_count() + parts.parts.len() - parts.vertices.len();
        let mut new = NewVertices {
            of_corner: Column::default(),
            present: Vec::with_capacity(count),
            positions: Vec::with_capacity(count),
            first_part: vec![NONE; kernel.vertex_count()],
        };
        let mut new_of_part = vec![NONE; parts.parts.len()];
        for piece in pieces.in_order() {
            let (id, vertex) = (VertexId::new(new.present.len()), pieces.vertex(piece));
            new.present.push(vertex);
            new.positions.push(stored.position(pieces.stored_vertex(piece)));
            let first = &mut new.first_part[vertex.index()];
            *first = id.min(*first);
            if let Some(part) = pieces.part(piece) {
                new_of_part[part] = id;
            }
        }
        new.of_corner = kernel.corners().map(|c| new.first_part[kernel.corner_vertex(c).index()]).collect();
        for &(corner, part) in &parts.corners {
            new.of_corner[corner] = new_of_part[part as usize];
        }
        new
    }
}

/// What becomes a new vertex. The pieces are numbered: first the present vertices, of which those count that stay whole,
/// then the parts.
struct Pieces<'a, K> {
    kernel: &'a K,
    stored: &'a StoredVertices<'a>,
    parts: &'a VertexParts,
    /// The lowest stored vertex behind each part.
    behind_parts: Vec<VertexId>,
    /// The lowest stored vertex behind each present one that is in a face. Absent if each is the vertex itself.
    behind_vertices: Option<Vec<VertexId>>,
}

impl<'a, K: Connectivity> Pieces<'a, K> {
    fn of(kernel: &'a K, stored: &'a StoredVertices<'a>, parts: &'a VertexParts) -> Self {
        let mut behind_parts = vec![NONE; parts.parts.len()];
        for &(corner, part) in &parts.corners {
            let lowest = &mut behind_parts[part as usize];
            *lowest = stored.of(corner).min(*lowest);
        }
        let behind_vertices = (!stored.are_present()).then(|| lowest_stored(kernel, stored));
        Pieces { kernel, stored, parts, behind_parts, behind_vertices }
    }

    /// The number of the part, if it is one.
    fn part(&self, piece: u32) -> Option<usize> {
        (piece as usize).checked_sub(self.kernel.vertex_count())
    }

    fn vertex(&self, piece: u32) -> VertexId {
        self.part(piece).map_or(VertexId(piece), |part| self.parts.parts[part].vertex)
    }

    /// The lowest stored vertex behind a piece.
    fn stored_vertex(&self, piece: u32) -> VertexId {
        match (self.part(piece), &self.behind_vertices) {
            (Some(part), _) => self.behind_parts[part],
            (None, Some(behind)) if behind[piece as usize] != NONE => behind[piece as usize],
            (None, _) => self.stored.of_vertex(VertexId(piece)),
        }
    }

    /// The lowest corner, if it has any.
    fn lowest_corner(&self, piece: u32) -> Option<CornerId> {
        match self.part(piece) {
            Some(part) => Some(self.parts.parts[part].lowest_corner),
            None => self.kernel.vertex_corners(VertexId(piece)).min(),
        }
    }

    /// All pieces in the order of the new vertices.
    fn in_order(&self) -> impl Iterator<Item = u32> + use<K> {
        const FREE: u32 = u32::MAX;
        let first_part = self.kernel.vertex_count() as u32;
        let mut apart = self.parts.vertices.iter().map(|(vertex, _)| vertex.0).peekable();
        let whole = (0..first_part).filter(|vertex| apart.next_if_eq(vertex).is_none());
        let (in_faces, alone): (Vec<u32>, Vec<u32>) =
            whole.partition(|&vertex| self.kernel.is_referenced(VertexId(vertex)));
        let mut holders = vec![FREE; self.stored.count()];
        let mut further = Vec::new();
        for piece in in_faces.into_iter().chain((first_part..).take(self.parts.parts.len())) {
            let holder = &mut holders[self.stored_vertex(piece).index()];
            match *holder {
                FREE => *holder = piece,
                before if self.lowest_corner(piece) < self.lowest_corner(before) => {
                    *holder = piece;
                    further.push(before);
                }
                _ => further.push(piece),
            }
        }
        further.sort_by_key(|&piece| self.lowest_corner(piece));
        for vertex in alone {
            match &mut holders[self.stored_vertex(vertex).index()] {
                free @ &mut FREE => *free = vertex,
                _ => further.push(vertex),
            }
        }
        holders.into_iter().filter(|&piece| piece != FREE).chain(further)
    }
}

/// The lowest stored vertex behind each vertex in a face.
fn lowest_stored<K: Connectivity>(kernel: &K, stored: &StoredVertices<'_>) -> Vec<VertexId> {
    let mut lowest = vec![NONE; kernel.vertex_count()];
    for corner in kernel.corners() {
        let behind = &mut lowest[kernel.corner_vertex(corner).index()];
        *behind = stored.of(corner).min(*behind);
    }
    lowest
}
