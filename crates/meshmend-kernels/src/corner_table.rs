#![doc = include_str!("corner_table.md")]

use std::iter;
use std::sync::Arc;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, FaceId, FaceTable, Lesson,
    ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

use crate::triangles::{NO_CORNER, Triangles, next, prev};

/// The corner table of a manifold triangle complex.
#[derive(Clone, Debug)]
pub struct CornerTable {
    /// V: the vertex of each corner, which the mesh has already.
    faces: Arc<FaceTable>,
    triangles: Triangles,
    /// O: the corner that looks at the same edge from the other side.
    opposite: Column<CornerId, CornerId>,
    corner_edge: Column<CornerId, EdgeId>,
    /// The lowest corner whose side runs along each edge.
    edge_corner: Column<EdgeId, CornerId>,
    /// Where the star begins.
    vertex_corner: Column<VertexId, CornerId>,
}

impl Lesson for CornerTable {
    const TEXT: &'static str = include_str!("corner_table.md");
}

impl Connectivity for CornerTable {
    const NAME: &'static str = "corner-table";
    const CAPABILITIES: Capabilities = Capabilities { ordered_vertex_stars: true, ..Capabilities::TRIANGLES };

    fn assemble(complex: &Complex) -> Self {
        let (faces, table) = (complex.shared_faces(), complex.edges());
        let mut opposite = Column::filled(NO_CORNER, faces.corner_count());
        let mut edge_corner = Column::filled(NO_CORNER, table.edge_count());
        let mut vertex_corner = Column::filled(NO_CORNER, faces.vertex_count());
        faces.corners().rev().for_each(|corner| vertex_corner[faces.corner_vertex(corner)] = corner);
        for edge in table.edges() {
            let mut sides = table.edge_corners(edge);
            let Some(one) = sides.next() else { continue };
            edge_corner[edge] = one;
            if let Some(other) = sides.next() {
                opposite[prev(one)] = prev(other);
                opposite[prev(other)] = prev(one);
            } else {
                vertex_corner[faces.corner_vertex(one)] = one;
            }
        }
        let corner_edge = Column::exactly(faces.corners().map(|corner| table.corner_edge(corner)));
        let triangles = Triangles::of(&faces);
        CornerTable { faces, triangles, opposite, corner_edge, edge_corner, vertex_corner }
    }

    fn vertex_count(&self) -> usize {
        self.vertex_corner.len()
    }
    fn edge_count(&self) -> usize {
        self.edge_corner.len()
    }
    fn face_count(&self) -> usize {
        self.triangles.face_count()
    }
    fn corner_count(&self) -> usize {
        self.opposite.len()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.faces.corner_vertex(corner)
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_edge[corner]
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.triangles.corner_face(corner)
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        next(corner)
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        prev(corner)
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let corner = self.edge_corner[edge];
        let (one, other) = (self.corner_vertex(corner), self.corner_vertex(next(corner)));
        [one.min(other), one.max(other)]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.triangles.face_corners(face)
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let lowest = self.edge_corner[edge];
        iter::once(lowest).chain(self.across(lowest))
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.vertex_corner[vertex]).filter(|&corner| corner != NO_CORNER);
        // Swing: across the side that comes in lies the corner to the left.
        iter::successors(first, move |&corner| self.across(prev(corner)).filter(|&left| Some(left) != first))
    }

    /// The side of a corner lies opposite to the corner before it.
    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        Some(self.opposite[prev(corner)]).filter(|&found| found != NO_CORNER).map(next)
    }

    fn heap_bytes(&self) -> usize {
        self.triangles.heap_bytes()
            + self.opposite.heap_bytes()
            + self.corner_edge.heap_bytes()
            + self.edge_corner.heap_bytes()
            + self.vertex_corner.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let mut arrays = vec![
            Array::of_column("opposite", Per::Corner, &self.opposite),
            Array::of_column("corner edge", Per::Corner, &self.corner_edge),
            Array::of_column("edge corner", Per::Edge, &self.edge_corner),
            Array::of_column("vertex corner", Per::Vertex, &self.vertex_corner),
        ];
        arrays.extend(self.triangles.arrays());
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let corner = |field, corner| match corner {
            NO_CORNER => Pointer { field, to: Target::Nothing },
            corner => Pointer::new(field, corner),
        };
        match of {
            Cell::Corner(of) => vec![
                Pointer::new("V", self.corner_vertex(of)),
                match self.opposite[of] {
                    NO_CORNER => Pointer { field: "O", to: Target::Hole },
                    opposite => Pointer::new("O", opposite),
                },
                Pointer::new("edge", self.corner_edge[of]),
            ],
            Cell::Edge(edge) => vec![Pointer::new("lowest side", self.edge_corner[edge])],
            Cell::Vertex(vertex) => vec![corner("first corner", self.vertex_corner[vertex])],
            Cell::Face(face) => vec![corner("first corner", self.triangles.first_corner(face))],
        }
    }
}

impl ManifoldConnectivity for CornerTable {}

#[cfg(test)]
mod tests {
    use meshmend_core::{Build, FaceTableBuilder};

    use super::*;

    fn build(faces: &[&[u32]]) -> CornerTable {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        CornerTable::build(&Complex::of(&Arc::new(builder.build(9).unwrap()))).unwrap()
    }

    #[test]
    fn opposite_corners_look_at_each_other_across_their_edge() {
        let kernel = build(&[&[0, 1, 2], &[1, 0, 3]]);
        assert_eq!(kernel.opposite[CornerId(2)], CornerId(5));
        assert_eq!(kernel.opposite[CornerId(5)], CornerId(2));
        assert_eq!(kernel.opposite(CornerId(0)), Some(CornerId(3)), "the opposite of a side is a side");
        let shown: Vec<String> =
            kernel.pointers(Cell::Corner(CornerId(0))).iter().map(|found| found.to.to_string()).collect();
        assert_eq!(shown, ["v0", "a hole", "e0"]);
    }

    #[test]
    fn a_degenerate_face_between_triangles_brings_nothing_out_of_step() {
        let kernel = build(&[&[0, 1, 2], &[4, 4, 5], &[1, 0, 3]]);
        assert_eq!(kernel.corner_face(CornerId(3)), FaceId(2));
        assert_eq!(kernel.face_corners(FaceId(1)).count(), 0);
        assert!(kernel.face_vertices(FaceId(2)).eq([1, 0, 3].map(VertexId)));
        assert_eq!(kernel.pointers(Cell::Face(FaceId(1)))[0].to, Target::Nothing);
    }

    #[test]
    fn a_swing_goes_from_the_boundary_on_or_from_the_lowest_corner() {
        let kernel = build(&[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1]]);
        let star = |vertex| kernel.vertex_corners(VertexId(vertex)).map(|c| c.0).collect::<Vec<_>>();
        assert_eq!([star(0), star(1), star(8)], [vec![0, 3, 6], vec![1, 8], vec![]]);
    }
}
