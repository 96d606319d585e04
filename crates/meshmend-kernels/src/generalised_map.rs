#![doc = include_str!("generalised_map.md")]

use std::iter;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceTable,
    Id, Lesson, ManifoldConnectivity, Per, Pointer, Target, VertexId,
};

/// The generalised map of a manifold complex.
#[derive(Clone, Debug)]
pub struct GeneralisedMap {
    /// To the other end of the side.
    alpha_0: Column<Dart, Dart>,
    /// To the other side at the same corner.
    alpha_1: Column<Dart, Dart>,
    /// To the other side of the edge, at the same end; to itself on the boundary.
    alpha_2: Column<Dart, Dart>,
    dart_vertex: Column<Dart, VertexId>,
    side_edge: Column<CornerId, EdgeId>,
    side_face: Column<CornerId, FaceId>,
    /// Where the star of each vertex begins.
    vertex_dart: Column<VertexId, Dart>,
    edge_dart: Column<EdgeId, Dart>,
    face_dart: Column<FaceId, Dart>,
}

/// One end of a side: that of corner c has the darts 2c, where it begins, and 2c + 1, where it ends.
type Dart = CornerId;

/// What stands for the dart of a vertex in no face, and of a degenerate face: there are always fewer darts.
const NO_DART: Dart = CornerId(u32::MAX);

/// The dart where the side of a corner begins.
#[inline]
fn begin(corner: CornerId) -> Dart {
    CornerId(2 * corner.0)
}

/// The corner whose side a dart is an end of.
#[inline]
fn side(dart: Dart) -> CornerId {
    CornerId(dart.0 / 2)
}

/// Whether a dart is where its side begins.
#[inline]
fn is_begin(dart: Dart) -> bool {
    dart.0.is_multiple_of(2)
}

impl GeneralisedMap {
    /// The corner that a dart stands at: that of its side where it begins, the following one where it ends.
    #[inline]
    fn corner(&self, dart: Dart) -> CornerId {
        side(if is_begin(dart) { dart } else { self.alpha_1[dart] })
    }

    /// The orbit of α₂ ∘ α₁ from where a star begins: a dart a corner, up to the boundary or once round.
    #[inline]
    fn star(&self, vertex: VertexId) -> impl Iterator<Item = Dart> + Clone {
        let first = Some(self.vertex_dart[vertex]).filter(|&dart| dart != NO_DART);
        iter::successors(first, move |&dart| {
            let last = self.alpha_1[dart];
            let beyond = self.alpha_2[last];
            (beyond != last && Some(beyond) != first).then_some(beyond)
        })
    }
}

impl Lesson for GeneralisedMap {
    const TEXT: &'static str = include_str!("generalised_map.md");
}

impl Connectivity for GeneralisedMap {
    const NAME: &'static str = "generalised-map";
    const CAPABILITIES: Capabilities =
        Capabilities { non_simple_faces: true, ordered_vertex_stars: true, ..Capabilities::SURFACES };

    fn assemble(complex: &Complex) -> Self {
        let (faces, table) = (complex.faces(), complex.edges());
        let mut map = GeneralisedMap {
            alpha_0: Column::exactly((0..2 * faces.corner_count()).map(|dart| CornerId::new(dart ^ 1))),
            alpha_1: Column::filled(NO_DART, 2 * faces.corner_count()),
            alpha_2: Column::exactly((0..2 * faces.corner_count()).map(CornerId::new)),
            dart_vertex: Column::filled(VertexId(0), 2 * faces.corner_count()),
            side_edge: Column::exactly(faces.corners().map(|corner| table.corner_edge(corner))),
            side_face: Column::filled(FaceId(0), faces.corner_count()),
            vertex_dart: Column::filled(NO_DART, faces.vertex_count()),
            edge_dart: Column::filled(NO_DART, table.edge_count()),
            face_dart: Column::filled(NO_DART, faces.face_count()),
        };
        map.link_faces(faces);
        map.link_edges(table);
        map.begin_stars(faces);
        map
    }

    fn vertex_count(&self) -> usize {
        self.vertex_dart.len()
    }
    fn edge_count(&self) -> usize {
        self.edge_dart.len()
    }
    fn face_count(&self) -> usize {
        self.face_dart.len()
    }
    fn corner_count(&self) -> usize {
        self.side_edge.len()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.dart_vertex[begin(corner)]
    }
    #[inline]
    fn corner_target(&self, corner: CornerId) -> VertexId {
        self.dart_vertex[self.alpha_0[begin(corner)]]
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.side_edge[corner]
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.side_face[corner]
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        side(self.alpha_1[self.alpha_0[begin(corner)]])
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        side(self.alpha_1[begin(corner)])
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let dart = self.edge_dart[edge];
        let [one, other] = [dart, self.alpha_0[dart]].map(|dart| self.dart_vertex[dart]);
        [one.min(other), one.max(other)]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        let first = Some(self.face_dart[face]).filter(|&dart| dart != NO_DART);
        let following = move |&dart: &Dart| {
            Some(self.alpha_1[self.alpha_0[dart]]).filter(|&following| Some(following) != first)
        };
        iter::successors(first, following).map(side)
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let lowest = side(self.edge_dart[edge]);
        iter::once(lowest).chain(self.across(lowest))
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.star(vertex).map(|dart| self.corner(dart))
    }

    #[inline]
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        Some(side(self.alpha_2[begin(corner)])).filter(|&beyond| beyond != corner)
    }

    fn heap_bytes(&self) -> usize {
        self.alpha_0.heap_bytes()
            + self.alpha_1.heap_bytes()
            + self.alpha_2.heap_bytes()
            + self.dart_vertex.heap_bytes()
            + self.side_edge.heap_bytes()
            + self.side_face.heap_bytes()
            + self.vertex_dart.heap_bytes()
            + self.edge_dart.heap_bytes()
            + self.face_dart.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        vec![
            Array::of_column("α0", Per::Dart, &self.alpha_0),
            Array::of_column("α1", Per::Dart, &self.alpha_1),
            Array::of_column("α2", Per::Dart, &self.alpha_2),
            Array::of_column("dart vertex", Per::Dart, &self.dart_vertex),
            Array::of_column("side edge", Per::Corner, &self.side_edge),
            Array::of_column("side face", Per::Corner, &self.side_face),
            Array::of_column("vertex dart", Per::Vertex, &self.vertex_dart),
            Array::of_column("edge dart", Per::Edge, &self.edge_dart),
            Array::of_column("face dart", Per::Face, &self.face_dart),
        ]
    }

    /// A corner's record is that of the two ends of its side.
    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let dart = |field, dart: Dart| {
            let to = if dart == NO_DART { Target::Nothing } else { Target::Dart(dart.0) };
            Pointer { field, to }
        };
        match of {
            Cell::Corner(corner) => {
                let (near, far) = (begin(corner), self.alpha_0[begin(corner)]);
                vec![
                    dart("α0 begin", self.alpha_0[near]),
                    dart("α1 begin", self.alpha_1[near]),
                    dart("α2 begin", self.alpha_2[near]),
                    Pointer::new("vertex begin", self.dart_vertex[near]),
                    dart("α0 end", self.alpha_0[far]),
                    dart("α1 end", self.alpha_1[far]),
                    dart("α2 end", self.alpha_2[far]),
                    Pointer::new("vertex end", self.dart_vertex[far]),
                    Pointer::new("edge", self.side_edge[corner]),
                    Pointer::new("face", self.side_face[corner]),
                ]
            }
            Cell::Vertex(vertex) => vec![dart("dart", self.vertex_dart[vertex])],
            Cell::Edge(edge) => vec![dart("dart", self.edge_dart[edge])],
            Cell::Face(face) => vec![dart("dart", self.face_dart[face])],
        }
    }
}

impl ManifoldConnectivity for GeneralisedMap {}

impl GeneralisedMap {
    /// Joins at each corner the end of the side before to the beginning of its own.
    fn link_faces(&mut self, faces: &FaceTable) {
        for face in faces.faces() {
            let mut corners = faces.face_corners(face);
            self.face_dart[face] = corners.next().map_or(NO_DART, begin);
            for corner in faces.face_corners(face) {
                let (here, ends_here) =
                    (begin(corner), self.alpha_0[begin(faces.corner_before(face, corner))]);
                (self.alpha_1[here], self.alpha_1[ends_here]) = (ends_here, here);
                let vertex = faces.corner_vertex(corner);
                (self.dart_vertex[here], self.dart_vertex[ends_here]) = (vertex, vertex);
                self.side_face[corner] = face;
            }
        }
    }

    /// Joins the two sides of each edge end to end: crosswise if they run opposite ways.
    fn link_edges(&mut self, table: &EdgeTable) {
        for edge in table.edges() {
            let mut sides = table.edge_sides(edge).iter();
            let Some(one) = sides.next() else { continue };
            let dart = begin(one.corner());
            self.edge_dart[edge] = dart;
            let Some(other) = sides.next() else { continue };
            let begins = begin(other.corner());
            let runs_along = one.is_forward() == other.is_forward();
            let at_begin = if runs_along { begins } else { self.alpha_0[begins] };
            self.join(dart, at_begin);
            self.join(self.alpha_0[dart], self.alpha_0[at_begin]);
        }
    }

    fn join(&mut self, one: Dart, other: Dart) {
        self.alpha_2[one] = other;
        self.alpha_2[other] = one;
    }

    /// Turns clockwise from the lowest corner of each vertex until the boundary is come to, or once round.
    fn begin_stars(&mut self, faces: &FaceTable) {
        for corner in faces.corners() {
            let vertex = faces.corner_vertex(corner);
            if self.vertex_dart[vertex] != NO_DART {
                continue;
            }
            let lowest = begin(corner);
            let mut dart = lowest;
            while self.alpha_2[dart] != dart {
                dart = self.alpha_1[self.alpha_2[dart]];
                if dart == lowest {
                    break;
                }
            }
            self.vertex_dart[vertex] = dart;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use meshmend_core::{Build, FaceTableBuilder};
    use meshmend_testkit::worlds::{damaged_grid, self_touching};
    use proptest::prelude::*;

    use super::*;

    fn build(faces: &[&[u32]]) -> GeneralisedMap {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        GeneralisedMap::build(&Complex::of(&Arc::new(builder.build(9).unwrap()))).unwrap()
    }

    /// What makes three permutations a generalised map of dimension two, whose cells have one vertex, edge and face.
    fn assert_axioms(map: &GeneralisedMap) {
        let (zero, one, two) = (&map.alpha_0, &map.alpha_1, &map.alpha_2);
        for dart in (0..zero.len()).map(Dart::new) {
            assert_eq!([zero[zero[dart]], one[one[dart]], two[two[dart]]], [dart; 3], "involutions");
            assert!(zero[dart] != dart && one[dart] != dart, "only α2 has fixed points");
            let turned = |dart| zero[two[dart]];
            assert_eq!(turned(turned(dart)), dart, "α0 α2 is an involution");
            assert_eq!(map.dart_vertex[one[dart]], map.dart_vertex[dart], "α1 stays at the vertex");
            assert_eq!(map.dart_vertex[two[dart]], map.dart_vertex[dart], "α2 stays at the vertex");
            let (edge, face) = (|dart| map.side_edge[side(dart)], |dart| map.side_face[side(dart)]);
            assert_eq!([edge(zero[dart]), edge(two[dart])], [edge(dart); 2], "α0 and α2 stay at the edge");
            assert_eq!([face(zero[dart]), face(one[dart])], [face(dart); 2], "α0 and α1 stay in the face");
        }
    }

    #[test]
    fn the_darts_of_the_picture() {
        let map = build(&[&[0, 1, 2], &[1, 0, 3]]);
        // The side of c0 begins with dart 0 at v0, that of c3 with dart 6 at v1.
        assert_eq!([map.alpha_0[CornerId(0)], map.alpha_1[CornerId(0)]].map(|dart| dart.0), [1, 5]);
        assert_eq!(map.alpha_2[CornerId(0)], CornerId(7));
        assert_eq!(map.alpha_2[CornerId(2)], CornerId(2), "the boundary");
        let fields: Vec<String> = map
            .pointers(Cell::Corner(CornerId(0)))
            .iter()
            .map(|found| format!("{} {}", found.field, found.to))
            .collect();
        assert_eq!(fields[..4], ["α0 begin dart 1", "α1 begin dart 5", "α2 begin dart 7", "vertex begin v0"]);
        assert_eq!(map.pointers(Cell::Vertex(VertexId(8)))[0].to, Target::Nothing);
    }

    #[test]
    fn sides_that_run_the_same_way_are_joined_begin_to_begin() {
        let map = build(&[&[0, 1, 2], &[0, 1, 3]]);
        assert_eq!(map.alpha_2[CornerId(0)], CornerId(6));
        assert_axioms(&map);
        let star: Vec<u32> = map.vertex_corners(VertexId(0)).map(|corner| corner.0).collect();
        assert_eq!(star, [3, 0]);
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: if cfg!(miri) { 4 } else { 500 }, ..Default::default() })]

        #[test]
        fn the_axioms_hold_on_whatever_is_admitted(soup in prop_oneof![damaged_grid(), self_touching()]) {
            if let Ok(map) = GeneralisedMap::build(&soup.complex()) {
                assert_axioms(&map);
            }
        }
    }
}
