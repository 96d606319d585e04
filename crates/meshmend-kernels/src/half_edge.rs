#![doc = include_str!("half_edge.md")]

use std::iter;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceTable,
    Id, Lesson, ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

/// The half-edge structure of a manifold complex.
#[derive(Clone, Debug)]
pub struct HalfEdge {
    /// Those of the faces first, each with the id of its corner; then those along the boundary.
    halves: Column<Half, Record>,
    corner_count: usize,
    vertex_half: Column<VertexId, Half>,
    edge_half: Column<EdgeId, Half>,
    face_half: Column<FaceId, Half>,
}

/// A half-edge: a corner's side, or its twin along the boundary.
type Half = CornerId;

/// What stands for the face of a boundary half-edge: there are always fewer faces.
const NO_FACE: FaceId = FaceId(u32::MAX);

/// What stands for the half-edge of a vertex in no face, and of a degenerate face: there are always fewer halves.
const NO_HALF: Half = CornerId(u32::MAX);

#[derive(Clone, Copy, Debug)]
struct Record {
    next: Half,
    prev: Half,
    twin: Half,
    origin: VertexId,
    face: FaceId,
    edge: EdgeId,
}

impl HalfEdge {
    /// The sides along the boundary loop that a side belongs to, from this one on, as the hole runs: each next
    /// side ends where the one before begins. `None` for a side with an opposite.
    ///
    /// *Cost*: constant for each side.
    pub fn boundary_loop(&self, corner: CornerId) -> impl Iterator<Item = CornerId> + Clone {
        let first = self.halves[corner].twin;
        let first = self.is_outside(first).then_some(first);
        iter::successors(first, move |&half| Some(self.halves[half].next).filter(|&next| Some(next) != first))
            .map(|half| self.halves[half].twin)
    }

    fn is_outside(&self, half: Half) -> bool {
        self.halves[half].face == NO_FACE
    }

    /// What a half-edge is to others: a corner, or one along the boundary.
    fn target(&self, half: Half) -> Target {
        if half == NO_HALF {
            Target::Nothing
        } else if half.index() < self.corner_count {
            Target::Cell(half.into())
        } else {
            Target::Dart(half.0)
        }
    }
}

impl Lesson for HalfEdge {
    const TEXT: &'static str = include_str!("half_edge.md");
}

impl Connectivity for HalfEdge {
    const NAME: &'static str = "half-edge";
    const CAPABILITIES: Capabilities = Capabilities {
        non_simple_faces: false,
        non_manifold_edges: false,
        non_manifold_vertices: false,
        mixed_orientation: false,
        polygons: true,
        ordered_vertex_stars: true,
    };

    fn assemble(complex: &Complex) -> Self {
        let (faces, edges) = (complex.faces(), complex.edges());
        let (mut halves, face_half) = halves_of_faces(faces, edges);
        let edge_half = pair_twins(&mut halves, edges);
        link_boundary(&mut halves, faces);
        let vertex_half = first_halves(&halves, faces);
        HalfEdge { halves, corner_count: faces.corner_count(), vertex_half, edge_half, face_half }
    }

    fn vertex_count(&self) -> usize {
        self.vertex_half.len()
    }
    fn edge_count(&self) -> usize {
        self.edge_half.len()
    }
    fn face_count(&self) -> usize {
        self.face_half.len()
    }
    fn corner_count(&self) -> usize {
        self.corner_count
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.halves[corner].origin
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.halves[corner].edge
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.halves[corner].face
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.halves[corner].next
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.halves[corner].prev
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let half = self.halves[self.edge_half[edge]];
        let (one, other) = (half.origin, self.halves[half.twin].origin);
        [one.min(other), one.max(other)]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.face_half[face]).filter(|&half| half != NO_HALF);
        iter::successors(first, move |&half| Some(self.halves[half].next).filter(|&next| Some(next) != first))
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let half = self.edge_half[edge];
        iter::once(half).chain(self.opposite(half))
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.vertex_half[vertex]).filter(|&half| half != NO_HALF);
        iter::successors(first, move |&half| {
            let left = self.halves[self.halves[half].prev].twin;
            Some(left).filter(|&left| Some(left) != first && !self.is_outside(left))
        })
    }

    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        Some(self.halves[corner].twin).filter(|&twin| !self.is_outside(twin))
    }

    /// The next half-edge along the hole, or the previous one.
    #[inline]
    fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        let inside = self.halves[self.edge_half[edge]];
        let outside = self.halves[inside.twin];
        let along = match at {
            _ if outside.face != NO_FACE => return None,
            at if at == inside.origin => outside.next,
            at if at == outside.origin => outside.prev,
            _ => return None,
        };
        Some(self.halves[along].edge)
    }

    fn heap_bytes(&self) -> usize {
        self.halves.heap_bytes()
            + self.vertex_half.heap_bytes()
            + self.edge_half.heap_bytes()
            + self.face_half.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let field = |name| Array::new(name, Per::Dart, size_of::<u32>(), self.halves.capacity());
        let mut arrays = ["next", "prev", "twin", "origin", "face", "edge"].map(field).to_vec();
        arrays.push(Array::of_column("vertex half", Per::Vertex, &self.vertex_half));
        arrays.push(Array::of_column("edge half", Per::Edge, &self.edge_half));
        arrays.push(Array::of_column("face half", Per::Face, &self.face_half));
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let half = |field, half: Half| Pointer { field, to: self.target(half) };
        match of {
            Cell::Corner(corner) => {
                let record = self.halves[corner];
                vec![
                    half("next", record.next),
                    half("prev", record.prev),
                    half("twin", record.twin),
                    Pointer::new("origin", record.origin),
                    Pointer::new("face", record.face),
                    Pointer::new("edge", record.edge),
                ]
            }
            Cell::Vertex(vertex) => vec![half("half", self.vertex_half[vertex])],
            Cell::Edge(edge) => vec![half("half", self.edge_half[edge])],
            Cell::Face(face) => vec![half("half", self.face_half[face])],
        }
    }
}

impl ManifoldConnectivity for HalfEdge {}

/// The half-edges of the faces, still without twins, and the first one of each face.
fn halves_of_faces(faces: &FaceTable, edges: &EdgeTable) -> (Column<Half, Record>, Column<FaceId, Half>) {
    let boundary = edges.edges().filter(|&e| edges.edge_corners(e).len() == 1).count();
    let mut halves = Vec::with_capacity(faces.corner_count() + boundary);
    let mut face_half = Column::filled(NO_HALF, faces.face_count());
    for face in faces.faces() {
        let range = faces.corner_range(face);
        if !range.is_empty() {
            face_half[face] = Half::new(range.start);
        }
        for corner in range.clone() {
            let next = if corner + 1 == range.end { range.start } else { corner + 1 };
            let prev = if corner == range.start { range.end } else { corner } - 1;
            let origin = faces.corner_vertex(Half::new(corner));
            let edge = edges.corner_edge(Half::new(corner));
            let (next, prev) = (Half::new(next), Half::new(prev));
            halves.push(Record { next, prev, twin: NO_HALF, origin, face, edge });
        }
    }
    (halves.into(), face_half)
}

/// Makes twins of the two halves of each edge, adding the boundary ones; gives the lowest half of each edge.
fn pair_twins(halves: &mut Column<Half, Record>, edges: &EdgeTable) -> Column<EdgeId, Half> {
    let mut edge_half = Vec::with_capacity(edges.edge_count());
    for edge in edges.edges() {
        let mut sides = edges.edge_corners(edge);
        let Some(one) = sides.next() else { continue };
        let other = sides.next().unwrap_or_else(|| {
            let origin = halves[halves[one].next].origin;
            halves.push(Record { next: NO_HALF, prev: NO_HALF, twin: one, origin, face: NO_FACE, edge })
        });
        halves[one].twin = other;
        halves[other].twin = one;
        edge_half.push(one);
    }
    edge_half.into()
}

/// Links the boundary half-edges to loops: each is followed by the one that begins where it ends.
fn link_boundary(halves: &mut Column<Half, Record>, faces: &FaceTable) {
    let outside = faces.corner_count()..halves.len();
    let mut leaving = Column::filled(NO_HALF, faces.vertex_count());
    for half in outside.clone().map(Half::new) {
        leaving[halves[half].origin] = half;
    }
    for half in outside.map(Half::new) {
        let target = halves[halves[half].twin].origin;
        let next = leaving[target];
        halves[half].next = next;
        halves[next].prev = half;
    }
}

/// For each vertex the half-edge with which its star begins: the one that leaves along the boundary, so that the
/// fan lies to its left, or else the lowest.
fn first_halves(halves: &Column<Half, Record>, faces: &FaceTable) -> Column<VertexId, Half> {
    let mut first = Column::filled(NO_HALF, faces.vertex_count());
    for corner in faces.corners().rev() {
        first[halves[corner].origin] = corner;
    }
    for half in (faces.corner_count()..halves.len()).map(Half::new) {
        let inside = halves[half].twin;
        first[halves[inside].origin] = inside;
    }
    first
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use meshmend_core::{Build, FaceTableBuilder, Refusal};
    use meshmend_testkit::worlds::damaged_grid;
    use proptest::prelude::*;

    use super::*;

    fn build(vertices: usize, faces: &[&[u32]]) -> Result<HalfEdge, Refusal> {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        HalfEdge::build(&Complex::of(&Arc::new(builder.build(vertices).unwrap())))
    }

    /// A hexagonal disc about v0.
    const DISC: [&[u32]; 6] = [&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 5], &[0, 5, 6], &[0, 6, 1]];

    #[test]
    fn a_closed_star_runs_counter_clockwise_from_the_lowest_corner() {
        let kernel = build(7, &DISC).unwrap();
        let centre: Vec<_> = kernel.vertex_corners(VertexId(0)).map(|c| c.0).collect();
        assert_eq!(centre, [0, 3, 6, 9, 12, 15]);
    }

    #[test]
    fn an_open_fan_runs_counter_clockwise_from_the_boundary() {
        let kernel = build(7, &DISC).unwrap();
        // At v1 the boundary side is that of the first face; the last face lies to the left of it.
        let rim: Vec<_> = kernel.vertex_corners(VertexId(1)).map(|c| c.0).collect();
        assert_eq!(rim, [1, 17]);
        assert!(kernel.opposite(CornerId(1)).is_none());
    }

    #[test]
    fn a_boundary_loop_runs_backwards_round_its_hole() {
        let kernel = build(7, &DISC).unwrap();
        let rim: Vec<_> = kernel.boundary_loop(CornerId(1)).map(|c| c.0).collect();
        assert_eq!(rim, [1, 16, 13, 10, 7, 4]);
        assert_eq!(kernel.boundary_loop(CornerId(0)).count(), 0);
    }

    #[test]
    fn an_annulus_has_two_loops() {
        let sides = [&[0, 1, 4, 3][..], &[1, 2, 5, 4], &[2, 0, 3, 5]];
        let kernel = build(6, &sides).unwrap();
        let outer: Vec<_> = kernel.boundary_loop(CornerId(0)).map(|c| kernel.corner_vertex(c).0).collect();
        let inner: Vec<_> = kernel.boundary_loop(CornerId(2)).map(|c| kernel.corner_vertex(c).0).collect();
        assert_eq!((outer, inner), (vec![0, 2, 1], vec![4, 5, 3]));
    }
    proptest! {
        #![proptest_config(ProptestConfig { cases: if cfg!(miri) { 4 } else { 256 }, ..Default::default() })]
        #[test]
        fn records_agree_with_one_another_along_the_boundary_too(soup in damaged_grid()) {
            if let Ok(kernel) = HalfEdge::build(&soup.complex()) {
                kernel.halves.iter().for_each(|(half, record)| assert_agrees(&kernel, half, record));
            }
        }
    }

    fn assert_agrees(kernel: &HalfEdge, half: Half, record: &Record) {
        let (next, prev, twin) =
            (kernel.halves[record.next], kernel.halves[record.prev], kernel.halves[record.twin]);
        assert_eq!((next.prev, prev.next, twin.twin), (half, half, half));
        assert_eq!((next.face, prev.face), (record.face, record.face));
        assert_eq!((next.origin, twin.edge), (twin.origin, record.edge));
        assert!(twin.origin != record.origin && twin.face != record.face);
    }
}
