#![doc = include_str!("winged_edge.md")]

use std::iter;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceTable,
    Lesson, ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

/// The winged edges of a manifold complex.
#[derive(Clone, Debug)]
pub struct WingedEdge {
    edges: Column<EdgeId, Record>,
    corner_side: Column<CornerId, Side>,
    /// The side of each face's first corner.
    face_side: Column<FaceId, Side>,
    /// Where the star begins: the edge with the hole on its clockwise side, or else that of the lowest corner.
    vertex_edge: Column<VertexId, EdgeId>,
}

/// An edge from its smaller to its larger vertex, as seen from outside.
#[derive(Clone, Copy, Debug)]
struct Record {
    /// Smaller and larger.
    ends: [VertexId; 2],
    /// Left and right.
    faces: [FaceId; 2],
    /// At either end the next edge clockwise and the next one counter-clockwise, across a hole too.
    wings: [[EdgeId; 2]; 2],
    /// The corners that own the left and the right side: the left one begins at the smaller vertex.
    corners: [CornerId; 2],
}

/// An edge and one side of it, left (0) or right (1), in one word: there are fewer than 2³¹ edges. A side leaves the
/// end of its own number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Side(u32);

/// Places of the two wings at an end.
const CLOCKWISE: usize = 0;
const COUNTER_CLOCKWISE: usize = 1;

/// What stands for a hole, and for what is not there: there are always fewer elements.
const NO_FACE: FaceId = FaceId(u32::MAX);
const NO_CORNER: CornerId = CornerId(u32::MAX);
const NO_EDGE: EdgeId = EdgeId(u32::MAX);
const NO_SIDE: Side = Side(u32::MAX);

impl Side {
    #[inline]
    fn new(edge: EdgeId, place: usize) -> Self {
        Side(edge.0 << 1 | place as u32)
    }
    #[inline]
    fn edge(self) -> EdgeId {
        EdgeId(self.0 >> 1)
    }
    #[inline]
    fn place(self) -> usize {
        (self.0 & 1) as usize
    }
    /// The other side of the edge, which runs the other way.
    #[inline]
    fn other(self) -> Self {
        Side(self.0 ^ 1)
    }
}

impl Record {
    /// The question of this structure: at which end is this vertex?
    #[inline]
    fn end(&self, vertex: VertexId) -> usize {
        usize::from(self.ends[1] == vertex)
    }

    /// Which side is a hole's.
    fn hole(&self) -> Option<usize> {
        self.corners.iter().position(|&corner| corner == NO_CORNER)
    }
}

impl WingedEdge {
    #[inline]
    fn record(&self, side: Side) -> &Record {
        &self.edges[side.edge()]
    }

    #[inline]
    fn owner(&self, side: Side) -> CornerId {
        self.record(side).corners[side.place()]
    }

    /// The side after another round its face or hole: the clockwise wing at the far end, on its side that leaves there.
    #[inline]
    fn after(&self, side: Side) -> Side {
        let (record, far) = (self.record(side), side.other().place());
        let wing = record.wings[far][CLOCKWISE];
        Side::new(wing, self.edges[wing].end(record.ends[far]))
    }

    /// The side before another: the counter-clockwise wing at the near end, on its side that comes in there.
    #[inline]
    fn before(&self, side: Side) -> Side {
        let (record, near) = (self.record(side), side.place());
        let wing = record.wings[near][COUNTER_CLOCKWISE];
        Side::new(wing, self.edges[wing].end(record.ends[near])).other()
    }

    /// Turns counter-clockwise about a vertex: the sides that leave it, up to the first one with a hole to its left.
    #[inline]
    fn leaving(&self, vertex: VertexId) -> impl Iterator<Item = Side> + Clone {
        let first = Some(self.vertex_edge[vertex]).filter(|&edge| edge != NO_EDGE);
        let first = first.map(|edge| Side::new(edge, self.edges[edge].end(vertex)));
        iter::successors(first, move |&side| {
            let left = self.before(side).other();
            (Some(left) != first && self.owner(left) != NO_CORNER).then_some(left)
        })
    }
}

impl Lesson for WingedEdge {
    const TEXT: &'static str = include_str!("winged_edge.md");
}

impl Connectivity for WingedEdge {
    const NAME: &'static str = "winged-edge";
    const CAPABILITIES: Capabilities =
        Capabilities { ordered_vertex_stars: true, ..Capabilities::ORIENTED_SURFACES };

    fn assemble(complex: &Complex) -> Self {
        let (faces, table) = (complex.faces(), complex.edges());
        let mut kernel = WingedEdge {
            edges: bare_records(table),
            corner_side: sides_of_corners(faces, table),
            face_side: Column::filled(NO_SIDE, faces.face_count()),
            vertex_edge: Column::filled(NO_EDGE, faces.vertex_count()),
        };
        kernel.link_faces(faces);
        kernel.link_holes();
        kernel.begin_stars(faces);
        kernel
    }

    fn vertex_count(&self) -> usize {
        self.vertex_edge.len()
    }
    fn edge_count(&self) -> usize {
        self.edges.len()
    }
    fn face_count(&self) -> usize {
        self.face_side.len()
    }
    fn corner_count(&self) -> usize {
        self.corner_side.len()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        let side = self.corner_side[corner];
        self.record(side).ends[side.place()]
    }
    #[inline]
    fn corner_target(&self, corner: CornerId) -> VertexId {
        let side = self.corner_side[corner].other();
        self.record(side).ends[side.place()]
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_side[corner].edge()
    }
    #[inline]
    fn is_forward(&self, corner: CornerId) -> bool {
        self.corner_side[corner].place() == 0
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        let side = self.corner_side[corner];
        self.record(side).faces[side.place()]
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.owner(self.after(self.corner_side[corner]))
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.owner(self.before(self.corner_side[corner]))
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edges[edge].ends
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.face_side[face]).filter(|&side| side != NO_SIDE);
        iter::successors(first, move |&side| Some(self.after(side)).filter(|&next| Some(next) != first))
            .map(|side| self.owner(side))
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let [left, right] = self.edges[edge].corners;
        [left.min(right), left.max(right)].into_iter().filter(|&corner| corner != NO_CORNER)
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.leaving(vertex).map(|side| self.owner(side))
    }
    #[inline]
    fn vertex_ring(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> + Clone {
        self.leaving(vertex).map(|side| self.record(side).ends[side.other().place()])
    }

    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        Some(self.owner(self.corner_side[corner].other())).filter(|&other| other != NO_CORNER)
    }

    /// The wing on the side of the hole.
    #[inline]
    fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        let record = &self.edges[edge];
        let (hole, end) = (record.hole()?, record.end(at));
        let wing = if hole == end { COUNTER_CLOCKWISE } else { CLOCKWISE };
        (record.ends[end] == at).then_some(record.wings[end][wing])
    }

    fn heap_bytes(&self) -> usize {
        self.edges.heap_bytes()
            + self.corner_side.heap_bytes()
            + self.face_side.heap_bytes()
            + self.vertex_edge.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let field = |name, each| Array::new(name, Per::Edge, each, self.edges.capacity());
        vec![
            field("ends", size_of::<[VertexId; 2]>()),
            field("faces", size_of::<[FaceId; 2]>()),
            field("wings", size_of::<[[EdgeId; 2]; 2]>()),
            field("corners", size_of::<[CornerId; 2]>()),
            Array::of_column("corner side", Per::Corner, &self.corner_side),
            Array::of_column("face side", Per::Face, &self.face_side),
            Array::of_column("vertex edge", Per::Vertex, &self.vertex_edge),
        ]
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        match of {
            Cell::Edge(edge) => self.edges[edge].pointers(),
            Cell::Corner(corner) => vec![self.corner_side[corner].pointer()],
            Cell::Face(face) if self.face_side[face] == NO_SIDE => {
                vec![Pointer { field: "first side", to: Target::Nothing }]
            }
            Cell::Face(face) => vec![self.face_side[face].pointer()],
            Cell::Vertex(vertex) if self.vertex_edge[vertex] == NO_EDGE => {
                vec![Pointer { field: "first edge", to: Target::Nothing }]
            }
            Cell::Vertex(vertex) => vec![Pointer::new("first edge", self.vertex_edge[vertex])],
        }
    }
}

impl ManifoldConnectivity for WingedEdge {}

impl Record {
    fn pointers(&self) -> Vec<Pointer> {
        let [[v0_cw, v0_ccw], [v1_cw, v1_ccw]] = self.wings;
        let face = |field, face| match face {
            NO_FACE => Pointer { field, to: Target::Hole },
            face => Pointer::new(field, face),
        };
        let corner = |field, corner| match corner {
            NO_CORNER => Pointer { field, to: Target::Nothing },
            corner => Pointer::new(field, corner),
        };
        vec![
            Pointer::new("v0", self.ends[0]),
            Pointer::new("v1", self.ends[1]),
            face("left face", self.faces[0]),
            face("right face", self.faces[1]),
            Pointer::new("wing v0 cw", v0_cw),
            Pointer::new("wing v0 ccw", v0_ccw),
            Pointer::new("wing v1 cw", v1_cw),
            Pointer::new("wing v1 ccw", v1_ccw),
            corner("left corner", self.corners[0]),
            corner("right corner", self.corners[1]),
        ]
    }
}

impl Side {
    fn pointer(self) -> Pointer {
        Pointer::new(["left side of", "right side of"][self.place()], self.edge())
    }
}

/// The edges with their ends and the corners that own their sides.
fn bare_records(table: &EdgeTable) -> Column<EdgeId, Record> {
    Column::exactly(table.edges().map(|edge| {
        let mut corners = [NO_CORNER; 2];
        for side in table.edge_sides(edge) {
            corners[usize::from(!side.is_forward())] = side.corner();
        }
        Record { ends: table.ends(edge), faces: [NO_FACE; 2], wings: [[NO_EDGE; 2]; 2], corners }
    }))
}

fn sides_of_corners(faces: &FaceTable, table: &EdgeTable) -> Column<CornerId, Side> {
    Column::exactly(faces.corners().map(|corner| {
        let edge = table.corner_edge(corner);
        Side::new(edge, usize::from(faces.corner_vertex(corner) != table.ends(edge)[0]))
    }))
}

impl WingedEdge {
    /// Tells each side its face, and each edge its wings within faces.
    fn link_faces(&mut self, faces: &FaceTable) {
        for face in faces.faces() {
            let mut corners = faces.face_corners(face);
            if let Some(first) = corners.next() {
                self.face_side[face] = self.corner_side[first];
            }
            for corner in faces.face_corners(face) {
                let side = self.corner_side[corner];
                let following = self.corner_side[faces.corner_after(face, corner)];
                self.edges[side.edge()].faces[side.place()] = face;
                self.link(side, following);
            }
        }
    }

    /// Makes one side follow another round their face or hole: each edge becomes a wing of the other at the vertex
    /// between them.
    fn link(&mut self, side: Side, following: Side) {
        self.edges[side.edge()].wings[side.other().place()][CLOCKWISE] = following.edge();
        self.edges[following.edge()].wings[following.place()][COUNTER_CLOCKWISE] = side.edge();
    }

    /// The sides that have a hole on them, by edge.
    fn hole_sides(&self) -> impl Iterator<Item = Side> {
        self.edges.iter().filter_map(|(edge, record)| Some(Side::new(edge, record.hole()?)))
    }

    /// Goes on round the holes, where each side is followed by the one that leaves where it ends.
    fn link_holes(&mut self) {
        let mut leaving = Column::filled(NO_SIDE, self.vertex_edge.len());
        self.hole_sides().for_each(|side| leaving[self.record(side).ends[side.place()]] = side);
        let sides: Vec<Side> = self.hole_sides().collect();
        for side in sides {
            let far = self.record(side).ends[side.other().place()];
            self.link(side, leaving[far]);
        }
    }

    fn begin_stars(&mut self, faces: &FaceTable) {
        for corner in faces.corners().rev() {
            self.vertex_edge[faces.corner_vertex(corner)] = self.corner_side[corner].edge();
        }
        // A hole's side comes to the vertex where the side of the face leaves: the hole is clockwise of that.
        let holes: Vec<Side> = self.hole_sides().collect();
        for side in holes {
            let far = self.record(side).ends[side.other().place()];
            self.vertex_edge[far] = side.edge();
        }
    }
}

#[cfg(test)]
mod tests;
