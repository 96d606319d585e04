#![doc = include_str!("quad_edge.md")]

mod algebra;

use std::iter;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceTable,
    Id, Lesson, ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

use algebra::{Dart, Subdivision};

/// The quad-edge structure of a manifold complex.
#[derive(Clone, Debug)]
pub struct QuadEdge {
    edges: Subdivision<Labels>,
    corner_edge: Column<CornerId, EdgeId>,
    /// Where the star begins: a dart out of the vertex with the first corner on its left.
    vertex_dart: Column<VertexId, Dart>,
    face_corner: Column<FaceId, CornerId>,
    hole_count: usize,
}

/// What stands for the corner of a degenerate face, and of a hole: there are always fewer corners.
const NO_CORNER: CornerId = CornerId(u32::MAX);

/// What lies round an edge. A side's place, 0 or 1, is left or right of the record's own direction.
#[derive(Clone, Copy, Debug)]
struct Labels {
    ends: [VertexId; 2],
    faces: [FaceId; 2],
    sides: [CornerId; 2],
    runs: SecondSide,
}

/// How the second side of an edge lies to the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SecondSide {
    Opposite,
    SameWay,
}

impl QuadEdge {
    /// How many holes the surface has, one for each boundary loop.
    pub fn hole_count(&self) -> usize {
        self.hole_count
    }

    /// Which hole lies beside a side, numbered by lowest edge; `None` for a side with an opposite.
    ///
    /// *Cost*: constant.
    pub fn hole_beside(&self, corner: CornerId) -> Option<usize> {
        let labels = self.labels(self.side_dart(corner));
        labels.faces[1].index().checked_sub(self.face_corner.len())
    }

    /// The sides along the boundary loop that a side belongs to, from this one on, going backwards along it.
    /// `None` for a side with an opposite.
    ///
    /// *Cost*: constant for each side.
    pub fn boundary_loop(&self, corner: CornerId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.side_dart(corner).sym()).filter(|&dart| self.side_left_of(dart) == NO_CORNER);
        iter::successors(first, move |&dart| Some(self.edges.lnext(dart)).filter(|&next| Some(next) != first))
            .map(|dart| self.labels(dart).sides[0])
    }

    fn labels(&self, dart: Dart) -> &Labels {
        self.edges.label(dart.edge)
    }

    /// A corner's side as a dart with the corner's face on its left, directed as the face runs.
    #[inline]
    fn side_dart(&self, corner: CornerId) -> Dart {
        let edge = self.corner_edge[corner];
        self.edges.label(edge).dart(edge, corner)
    }

    /// The side on the left of a dart, whichever way that runs; [`NO_CORNER`] for a hole's.
    #[inline]
    fn side_left_of(&self, dart: Dart) -> CornerId {
        self.labels(dart).sides[left(dart)]
    }

    /// The corner between a dart and the next one counter-clockwise out of the same vertex. Of its two sides there
    /// the corner owns the one that its face leaves along.
    fn corner_left_of(&self, dart: Dart) -> CornerId {
        let side = self.side_left_of(dart);
        if self.labels(dart).dart(dart.edge, side) == dart {
            side
        } else {
            self.side_left_of(self.edges.onext(dart).flip())
        }
    }
}

impl Lesson for QuadEdge {
    const TEXT: &'static str = include_str!("quad_edge.md");
}

impl Connectivity for QuadEdge {
    const NAME: &'static str = "quad-edge";
    const CAPABILITIES: Capabilities = Capabilities {
        non_simple_faces: true,
        non_manifold_edges: false,
        non_manifold_vertices: false,
        mixed_orientation: true,
        polygons: true,
        ordered_vertex_stars: true,
    };

    fn assemble(complex: &Complex) -> Self {
        let (faces, table) = (complex.faces(), complex.edges());
        let mut kernel = QuadEdge {
            edges: make_edges(faces, table),
            corner_edge: exactly(faces.corners().map(|c| table.corner_edge(c))).into(),
            vertex_dart: Column::filled(Dart::NONE, faces.vertex_count()),
            face_corner: Column::filled(NO_CORNER, faces.face_count()),
            hole_count: 0,
        };
        kernel.link_faces(faces);
        kernel.link_holes();
        kernel.begin_stars(faces);
        kernel
    }

    fn vertex_count(&self) -> usize {
        self.vertex_dart.len()
    }
    fn edge_count(&self) -> usize {
        self.edges.len()
    }
    fn face_count(&self) -> usize {
        self.face_corner.len()
    }
    fn corner_count(&self) -> usize {
        self.corner_edge.len()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        let dart = self.side_dart(corner);
        self.labels(dart).ends[dart.quarter() / 2]
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_edge[corner]
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        let dart = self.side_dart(corner);
        self.labels(dart).faces[left(dart)]
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.side_left_of(self.edges.lnext(self.side_dart(corner)))
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.side_left_of(self.edges.lprev(self.side_dart(corner)))
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let [one, other] = self.edges.label(edge).ends;
        [one.min(other), one.max(other)]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        let corner = Some(self.face_corner[face]).filter(|&corner| corner != NO_CORNER);
        let first = corner.map(|corner| self.side_dart(corner));
        iter::successors(first, move |&dart| Some(self.edges.lnext(dart)).filter(|&next| Some(next) != first))
            .map(|dart| self.side_left_of(dart))
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let sides = self.edges.label(edge).sides;
        sides.into_iter().filter(|&side| side != NO_CORNER)
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.vertex_dart[vertex]).filter(|&dart| dart != Dart::NONE);
        let is_there = move |&dart: &Dart| Some(dart) != first && self.side_left_of(dart) != NO_CORNER;
        iter::successors(first, move |&dart| Some(self.edges.onext(dart)).filter(is_there))
            .map(|dart| self.corner_left_of(dart))
    }

    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        let other = self.side_left_of(self.side_dart(corner).sym());
        (other != NO_CORNER).then_some(other)
    }

    /// The next dart along the hole, or the previous one.
    fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        let (labels, outside) = (self.edges.label(edge), Dart::along(edge).sym());
        let along = match at {
            _ if labels.sides[1] != NO_CORNER => return None,
            at if at == labels.ends[0] => self.edges.lnext(outside),
            at if at == labels.ends[1] => self.edges.lprev(outside),
            _ => return None,
        };
        Some(along.edge)
    }

    fn heap_bytes(&self) -> usize {
        self.edges.heap_bytes()
            + self.corner_edge.heap_bytes()
            + self.vertex_dart.heap_bytes()
            + self.face_corner.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let field = |name, each| Array::new(name, Per::Edge, each, self.edges.capacity());
        let pair = size_of::<[u32; 2]>();
        let mut arrays = self.edges.arrays().to_vec();
        arrays.extend(["ends", "faces", "sides"].map(|name| field(name, pair)));
        arrays.push(field("second side", size_of::<Labels>() - 3 * pair));
        arrays.push(Array::of_column("corner edge", Per::Corner, &self.corner_edge));
        arrays.push(Array::of_column("vertex dart", Per::Vertex, &self.vertex_dart));
        arrays.push(Array::of_column("face corner", Per::Face, &self.face_corner));
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let nothing = |field| Pointer { field, to: Target::Nothing };
        match of {
            Cell::Edge(edge) => self.fields_of(edge),
            Cell::Corner(corner) => vec![Pointer::new("edge", self.corner_edge[corner])],
            Cell::Vertex(vertex) => vec![match self.vertex_dart[vertex] {
                Dart::NONE => nothing("dart"),
                dart => Pointer::new("dart", dart.edge),
            }],
            Cell::Face(face) => vec![match self.face_corner[face] {
                NO_CORNER => nothing("corner"),
                corner => Pointer::new("corner", corner),
            }],
        }
    }
}

impl ManifoldConnectivity for QuadEdge {}

impl QuadEdge {
    /// What the record of an edge refers to.
    fn fields_of(&self, edge: EdgeId) -> Vec<Pointer> {
        let along = Dart::along(edge);
        let Labels { ends, faces, sides, .. } = *self.edges.label(edge);
        let next = |field, dart| Pointer::new(field, self.edges.onext(dart).edge);
        let face = |field, face: FaceId| match face.index() < self.face_corner.len() {
            true => Pointer::new(field, face),
            false => Pointer { field, to: Target::Hole },
        };
        let side = |field, side| match side {
            NO_CORNER => Pointer { field, to: Target::Nothing },
            side => Pointer::new(field, side),
        };
        vec![
            next("Onext about Org", along),
            next("Onext about Right", along.rot()),
            next("Onext about Dest", along.sym()),
            next("Onext about Left", along.rot_inverse()),
            Pointer::new("Org", ends[0]),
            Pointer::new("Dest", ends[1]),
            face("Left", faces[0]),
            face("Right", faces[1]),
            side("left side", sides[0]),
            side("right side", sides[1]),
        ]
    }
}

impl Labels {
    /// One of the two sides as a dart with its face on the left, directed as the face runs.
    #[inline]
    fn dart(&self, edge: EdgeId, side: CornerId) -> Dart {
        let along = Dart::along(edge);
        if side == self.sides[0] {
            along
        } else if self.runs == SecondSide::Opposite {
            along.sym()
        } else {
            along.flip()
        }
    }
}

/// Whether the face on a dart's left is its record's left one (0) or right one (1): turning back exchanges them, and
/// so does flipping.
#[inline]
fn left(dart: Dart) -> usize {
    (dart.quarter() / 2) ^ usize::from(dart.flipped())
}

/// The edges, each by itself, labelled with its ends and sides.
fn make_edges(faces: &FaceTable, table: &EdgeTable) -> Subdivision<Labels> {
    let mut edges = Subdivision::with_capacity(table.edge_count());
    for edge in table.edges() {
        let mut corners = table.edge_sides(edge).iter();
        let Some(first) = corners.next() else { continue };
        let second = corners.next();
        let [low, high] = table.ends(edge);
        let [from, to] = if first.is_forward() { [low, high] } else { [high, low] };
        let same_way = second.is_some_and(|second| second.is_forward() == first.is_forward());
        let runs = if same_way { SecondSide::SameWay } else { SecondSide::Opposite };
        let sides = [first.corner(), second.map_or(NO_CORNER, |second| second.corner())];
        let unknown = FaceId::new(faces.face_count());
        edges.make_edge(Labels { ends: [from, to], faces: [unknown; 2], sides, runs });
    }
    edges
}

impl QuadEdge {
    /// Tells each side its face, and what follows it there.
    fn link_faces(&mut self, faces: &FaceTable) {
        for face in faces.faces() {
            let mut corners = faces.face_corners(face);
            let Some(last) = corners.next_back() else { continue };
            let mut before = self.side_dart(last);
            self.face_corner[face] = CornerId::new(faces.corner_range(face).start);
            for corner in faces.face_corners(face) {
                let dart = self.side_dart(corner);
                self.edges.label_mut(dart.edge).faces[left(dart)] = face;
                self.edges.link(before, dart);
                before = dart;
            }
        }
    }

    /// Closes each boundary loop with a hole: round it goes the boundary, from edge to edge through their common
    /// vertex, each seen from the side that has no face.
    fn link_holes(&mut self) {
        let boundary = self.boundary_at_vertices();
        let mut is_closed = Column::filled(false, self.edges.len());
        for first in self.edges() {
            if self.edge_degree(first) > 1 || is_closed[first] {
                continue;
            }
            let hole = FaceId::new(self.face_corner.len() + self.hole_count);
            self.hole_count += 1;
            let start = Dart::along(first).sym();
            let (mut edge, mut dart) = (first, start);
            loop {
                is_closed[edge] = true;
                self.edges.label_mut(dart.edge).faces[1] = hole;
                // Seen from the hole a dart is Sym or Flip, so it ends at the record's origin or destination.
                let end = self.labels(dart).ends[usize::from(dart.flipped())];
                let [one, other] = boundary[end];
                edge = if one == edge { other } else { one };
                if is_closed[edge] {
                    break;
                }
                let along = Dart::along(edge);
                let following = if self.labels(along).ends[0] == end { along.flip() } else { along.sym() };
                self.edges.link(dart, following);
                dart = following;
            }
            self.edges.link(dart, start);
        }
    }

    /// The two boundary edges of each vertex of the boundary.
    fn boundary_at_vertices(&self) -> Column<VertexId, [EdgeId; 2]> {
        let mut at = Column::filled([EdgeId(u32::MAX); 2], self.vertex_dart.len());
        for edge in self.edges().filter(|&edge| self.edge_degree(edge) == 1) {
            for end in self.edge_ends(edge) {
                let pair: &mut [EdgeId; 2] = &mut at[end];
                *pair = [edge, pair[0]];
            }
        }
        at
    }

    /// Finds where the star of each vertex begins: clockwise from its lowest corner until there is a hole on the
    /// right, or once round.
    fn begin_stars(&mut self, faces: &FaceTable) {
        for corner in faces.corners() {
            let vertex = faces.corner_vertex(corner);
            if self.vertex_dart[vertex] != Dart::NONE {
                continue;
            }
            let lowest = self.side_dart(corner);
            let mut dart = lowest;
            while self.side_left_of(dart.sym()) != NO_CORNER {
                dart = self.edges.oprev(dart);
                if dart == lowest {
                    break;
                }
            }
            self.vertex_dart[vertex] = dart;
        }
    }
}

/// A vector of what an iterator of known length gives, without room to spare.
fn exactly<T>(items: impl ExactSizeIterator<Item = T>) -> Vec<T> {
    let mut vector = Vec::with_capacity(items.len());
    vector.extend(items);
    vector
}

#[cfg(test)]
mod tests;
