#![doc = include_str!("simple_record.md")]

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId, Grouped,
    Id, KernelTask, Lesson, ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

use crate::triangles::{Triangles, next, prev};

/// The simple records of a triangle complex.
#[derive(Clone, Debug)]
pub struct SimpleRecord {
    vertex_count: usize,
    triangles: Triangles,
    edges: Column<EdgeId, EdgeRecord>,
    faces: Column<FaceId, FaceRecord>,
}

/// An edge: its two vertices, and the one or two faces along it, ascending.
#[derive(Clone, Copy, Debug)]
struct EdgeRecord {
    vertices: [VertexId; 2],
    faces: [FaceId; 2],
}

/// A face: its three vertices in order, and the edge from each of them to the next.
#[derive(Clone, Copy, Debug)]
struct FaceRecord {
    vertices: [VertexId; 3],
    edges: [EdgeId; 3],
}

/// What stands for the face that a boundary edge does not have: there are always fewer faces.
const NO_FACE: FaceId = FaceId(u32::MAX);

/// The record of a degenerate face.
const EMPTY: FaceRecord = FaceRecord { vertices: [VertexId(u32::MAX); 3], edges: [EdgeId(u32::MAX); 3] };

impl SimpleRecord {
    /// The face of a corner and its place there.
    #[inline]
    fn place(&self, corner: CornerId) -> (&FaceRecord, usize) {
        (&self.faces[self.triangles.corner_face(corner)], corner.index() % 3)
    }

    /// The corner of a face whose side runs along an edge: one of three.
    #[inline]
    fn side_along(&self, edge: EdgeId, face: FaceId) -> Option<CornerId> {
        let place = self.faces[face].edges.iter().position(|&along| along == edge)?;
        Some(self.corner(face, place))
    }

    #[inline]
    fn corner(&self, face: FaceId, place: usize) -> CornerId {
        CornerId(self.triangles.first_corner(face).0 + place as u32)
    }
}

impl Lesson for SimpleRecord {
    const TEXT: &'static str = include_str!("simple_record.md");
}

impl Connectivity for SimpleRecord {
    const NAME: &'static str = "simple-record";
    const CAPABILITIES: Capabilities = Capabilities {
        non_simple_faces: false,
        non_manifold_edges: false,
        non_manifold_vertices: true,
        mixed_orientation: true,
        polygons: false,
        ordered_vertex_stars: false,
    };
    const COSTS: Costs = Costs { vertex_star: Cost::Linear, ..Costs::CONSTANT };

    fn assemble(complex: &Complex) -> Self {
        let (faces, table) = (complex.faces(), complex.edges());
        let triangles = Triangles::of(faces);
        let edges = Column::exactly(table.edges().map(|edge| {
            let mut along = [NO_FACE; 2];
            let sides = table.edge_corners(edge);
            along.iter_mut().zip(sides).for_each(|(face, side)| *face = triangles.corner_face(side));
            EdgeRecord { vertices: table.ends(edge), faces: along }
        }));
        let mut records = Column::filled(EMPTY, faces.face_count());
        for corner in faces.corners() {
            let (record, place) = (&mut records[triangles.corner_face(corner)], corner.index() % 3);
            record.vertices[place] = faces.corner_vertex(corner);
            record.edges[place] = table.corner_edge(corner);
        }
        SimpleRecord { vertex_count: faces.vertex_count(), triangles, edges, faces: records }
    }

    fn vertex_count(&self) -> usize {
        self.vertex_count
    }
    fn edge_count(&self) -> usize {
        self.edges.len()
    }
    fn face_count(&self) -> usize {
        self.faces.len()
    }
    fn corner_count(&self) -> usize {
        3 * self.triangles.proper_count()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        let (face, place) = self.place(corner);
        face.vertices[place]
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        let (face, place) = self.place(corner);
        face.edges[place]
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
        self.edges[edge].vertices
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.triangles.face_corners(face)
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let faces = self.edges[edge].faces.into_iter().filter(|&face| face != NO_FACE);
        faces.filter_map(move |face| self.side_along(edge, face))
    }
    /// A vertex knows nothing, so every face is looked at.
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.iter().filter_map(move |(face, record)| {
            let place = record.vertices.iter().position(|&at| at == vertex)?;
            Some(self.corner(face, place))
        })
    }

    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        let (face, edge) = (self.corner_face(corner), self.corner_edge(corner));
        let [one, other] = self.edges[edge].faces;
        let beyond = if one == face { other } else { one };
        if beyond == NO_FACE { None } else { self.side_along(edge, beyond) }
    }

    fn ask_of_all_vertices<T: KernelTask>(&self, task: T) -> T::Output {
        task.run(&Grouped::of(self))
    }

    fn heap_bytes(&self) -> usize {
        self.triangles.heap_bytes() + self.edges.heap_bytes() + self.faces.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let of_edge = |name| Array::new(name, Per::Edge, size_of::<[u32; 2]>(), self.edges.capacity());
        let of_face = |name| Array::new(name, Per::Face, size_of::<[u32; 3]>(), self.faces.capacity());
        let mut arrays = vec![
            of_edge("edge vertices"),
            of_edge("edge faces"),
            of_face("face vertices"),
            of_face("face edges"),
        ];
        arrays.extend(self.triangles.arrays());
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        match of {
            Cell::Edge(edge) => {
                let EdgeRecord { vertices, faces } = self.edges[edge];
                let face = |field, face| match face {
                    NO_FACE => Pointer { field, to: Target::Nothing },
                    face => Pointer::new(field, face),
                };
                let ends = [Pointer::new("vertex 0", vertices[0]), Pointer::new("vertex 1", vertices[1])];
                [ends, [face("face 0", faces[0]), face("face 1", faces[1])]].concat()
            }
            Cell::Face(face) if self.face_corners(face).next().is_some() => {
                let FaceRecord { vertices: [a, b, c], edges: [ab, bc, ca] } = self.faces[face];
                let vertices =
                    [Pointer::new("vertex 0", a), Pointer::new("vertex 1", b), Pointer::new("vertex 2", c)];
                let edges =
                    [Pointer::new("edge 0", ab), Pointer::new("edge 1", bc), Pointer::new("edge 2", ca)];
                [vertices, edges].concat()
            }
            Cell::Face(_) | Cell::Vertex(_) | Cell::Corner(_) => Vec::new(),
        }
    }
}

impl ManifoldConnectivity for SimpleRecord {}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use meshmend_core::{Build, FaceTableBuilder};

    use super::*;

    fn build(faces: &[&[u32]]) -> SimpleRecord {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        SimpleRecord::build(&Complex::of(&Arc::new(builder.build(9).unwrap()))).unwrap()
    }

    #[test]
    fn records_say_what_they_hold_and_a_vertex_says_nothing() {
        let kernel = build(&[&[0, 1, 2], &[7, 7, 8], &[1, 0, 3]]);
        let fields = |of: Cell| {
            kernel
                .pointers(of)
                .iter()
                .map(|found| format!("{} {}", found.field, found.to))
                .collect::<Vec<_>>()
        };
        assert_eq!(fields(Cell::Edge(EdgeId(0))), ["vertex 0 v0", "vertex 1 v1", "face 0 f0", "face 1 f2"]);
        assert_eq!(fields(Cell::Edge(EdgeId(1)))[3], "face 1 –");
        assert_eq!(
            fields(Cell::Face(FaceId(2))),
            ["vertex 0 v1", "vertex 1 v0", "vertex 2 v3", "edge 0 e0", "edge 1 e2", "edge 2 e4"]
        );
        assert!(fields(Cell::Face(FaceId(1))).is_empty() && fields(Cell::Vertex(VertexId(0))).is_empty());
    }

    #[test]
    fn a_bow_tie_and_a_pinched_band_are_held() {
        let bow_tie = build(&[&[0, 1, 2], &[0, 3, 4]]);
        assert!(bow_tie.vertex_corners(VertexId(0)).eq([0, 3].map(CornerId)));
        let band = build(&[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4], &[3, 4, 0], &[4, 0, 1], &[0, 7, 8]]);
        assert!(band.vertex_corners(VertexId(0)).eq([0, 11, 13, 15].map(CornerId)));
        assert_eq!(band.across(CornerId(1)), Some(CornerId(3)), "both sides of v1-v2 run the same way");
    }
}
