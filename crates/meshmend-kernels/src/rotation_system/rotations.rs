//! How a rotation system is read off the faces: about each vertex from corner to corner, over the edges between them.

use std::fmt;

use meshmend_core::{Column, Complex, CornerId, EdgeId, EdgeTable, FaceTable, Id, VertexId};

/// An edge as seen from one of its ends: a place in the rotation there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Dart(pub(super) u32);

/// What stands for the corner of a gap and of a degenerate face: there are always fewer corners.
pub(super) const NO_CORNER: CornerId = CornerId(u32::MAX);

/// The rotations of all vertices, one after the other.
pub(super) struct Rotations {
    /// Where the rotation of each vertex begins, and one more.
    pub(super) starts: Vec<u32>,
    pub(super) edges: Column<Dart, EdgeId>,
    /// The places of an edge in the rotations of its two ends.
    pub(super) places: Column<EdgeId, [Dart; 2]>,
    /// The corner between a dart and the next one about its vertex.
    pub(super) corner_after: Column<Dart, CornerId>,
}

impl Id for Dart {
    fn new(index: usize) -> Self {
        Dart(index as u32)
    }
    fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for Dart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "d{}", self.0)
    }
}

/// A mesh of which the rotations are found.
struct Assembly<'a> {
    faces: &'a FaceTable,
    table: &'a EdgeTable,
    starts: Vec<u32>,
    rotation: Vec<EdgeId>,
    corner_after: Vec<CornerId>,
    places: Column<EdgeId, [Dart; 2]>,
    /// Of each corner the ones after and before it in its face.
    next: Column<CornerId, CornerId>,
    prev: Column<CornerId, CornerId>,
}

/// A corner with one of its two sides at a vertex, named by the corner that owns that.
type Wedge = (CornerId, CornerId);

impl Rotations {
    /// The rotations of a manifold complex, vertex by vertex.
    ///
    /// *Cost*: linear.
    pub(super) fn of(complex: &Complex) -> Self {
        let (faces, table) = (complex.faces(), complex.edges());
        let darts = 2 * table.edge_count();
        let mut assembly = Assembly {
            faces,
            table,
            starts: Vec::with_capacity(faces.vertex_count() + 1),
            rotation: Vec::with_capacity(darts),
            corner_after: Vec::with_capacity(darts),
            places: Column::filled([Dart::default(); 2], table.edge_count()),
            next: Column::filled(NO_CORNER, faces.corner_count()),
            prev: Column::filled(NO_CORNER, faces.corner_count()),
        };
        for face in faces.faces() {
            for corner in faces.face_corners(face) {
                let next = faces.corner_after(face, corner);
                (assembly.next[corner], assembly.prev[next]) = (next, corner);
            }
        }
        let mut lowest = Column::filled(NO_CORNER, faces.vertex_count());
        faces.corners().rev().for_each(|corner| lowest[faces.corner_vertex(corner)] = corner);
        for (vertex, &corner) in lowest.iter() {
            assembly.starts.push(assembly.rotation.len() as u32);
            if corner != NO_CORNER {
                assembly.rotate(vertex, corner);
            }
        }
        assembly.starts.push(assembly.rotation.len() as u32);
        let Assembly { starts, rotation, corner_after, places, .. } = assembly;
        Rotations { starts, edges: rotation.into(), places, corner_after: corner_after.into() }
    }
}

impl Assembly<'_> {
    /// The rotation of one vertex: from the boundary on, or else from the lowest corner; counter-clockwise as the face of
    /// that corner runs.
    fn rotate(&mut self, vertex: VertexId, lowest: CornerId) {
        // Clockwise of a corner is the side that leaves.
        let (mut first, mut clockwise) = (lowest, lowest);
        while let Some((corner, side)) = self.step(vertex, clockwise) {
            (first, clockwise) = (corner, side);
            if first == lowest {
                break;
            }
        }
        let mut corner = first;
        loop {
            self.push(vertex, clockwise, corner);
            let counter = if clockwise == corner { self.prev[corner] } else { corner };
            match self.step(vertex, counter) {
                Some((next, _)) if next == first => break,
                Some((next, far)) => {
                    corner = next;
                    clockwise = if far == next { self.prev[next] } else { next };
                }
                None => {
                    self.push(vertex, counter, NO_CORNER);
                    break;
                }
            }
        }
    }

    /// From a side at a vertex over its edge to the corner there, with the further side of that.
    fn step(&self, vertex: VertexId, side: CornerId) -> Option<Wedge> {
        let mut sides = self.table.edge_corners(self.table.corner_edge(side));
        let mate = sides.find(|&mate| mate != side)?;
        if self.faces.corner_vertex(mate) == vertex {
            Some((mate, self.prev[mate]))
        } else {
            let corner = self.next[mate];
            Some((corner, corner))
        }
    }

    fn push(&mut self, vertex: VertexId, side: CornerId, corner: CornerId) {
        let edge = self.table.corner_edge(side);
        self.places[edge][usize::from(self.table.ends(edge)[1] == vertex)] = Dart::new(self.rotation.len());
        self.rotation.push(edge);
        self.corner_after.push(corner);
    }
}
