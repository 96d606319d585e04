//! The right answers, from plain lists of the faces.
//!
//! Edges are found anew from the faces; the shared edge table is not looked at, and no answer of a kernel either.

use std::collections::BTreeMap;

use meshmend_core::{Complex, CornerId, EdgeId, FaceId, Id, VertexId};

/// The right answers over one complex.
pub(crate) struct Expected {
    /// The vertices of each face.
    pub(crate) faces: Vec<Vec<VertexId>>,
    /// The corners of each face.
    pub(crate) face_corners: Vec<Vec<CornerId>>,
    /// Of each corner its vertex, face and edge, and the corners after and before it in its face.
    pub(crate) vertex: Vec<VertexId>,
    pub(crate) face: Vec<FaceId>,
    pub(crate) edge: Vec<EdgeId>,
    pub(crate) next: Vec<CornerId>,
    pub(crate) prev: Vec<CornerId>,
    /// The edges in order of their ends, each with its corners, ascending.
    pub(crate) edges: Vec<([VertexId; 2], Vec<CornerId>)>,
    /// The corners at each vertex, ascending.
    pub(crate) stars: Vec<Vec<CornerId>>,
}

impl Expected {
    pub(crate) fn of(complex: &Complex) -> Self {
        let table = complex.faces();
        let faces: Vec<Vec<VertexId>> = table.faces().map(|f| table.face_vertices(f).to_vec()).collect();
        let mut all = Expected {
            face_corners: Vec::with_capacity(faces.len()),
            vertex: Vec::new(),
            face: Vec::new(),
            edge: Vec::new(),
            next: Vec::new(),
            prev: Vec::new(),
            edges: Vec::new(),
            stars: vec![Vec::new(); table.vertex_count()],
            faces,
        };
        let mut by_ends: BTreeMap<[VertexId; 2], Vec<CornerId>> = BTreeMap::new();
        for (f, face) in all.faces.iter().enumerate() {
            let first = all.vertex.len();
            let corner = |place: usize| CornerId::new(first + place % face.len());
            all.face_corners.push((0..face.len()).map(corner).collect());
            for (place, &vertex) in face.iter().enumerate() {
                let target = face[(place + 1) % face.len()];
                by_ends.entry([vertex.min(target), vertex.max(target)]).or_default().push(corner(place));
                all.stars[vertex.index()].push(corner(place));
                all.vertex.push(vertex);
                all.face.push(FaceId::new(f));
                all.next.push(corner(place + 1));
                all.prev.push(corner(place + face.len() - 1));
            }
        }
        all.edges.extend(by_ends);
        all.edge = vec![EdgeId::new(0); all.vertex.len()];
        for (e, (_, corners)) in all.edges.iter().enumerate() {
            corners.iter().for_each(|corner| all.edge[corner.index()] = EdgeId::new(e));
        }
        all
    }

    pub(crate) fn vertices(&self) -> impl Iterator<Item = VertexId> + use<> {
        (0..self.stars.len()).map(VertexId::new)
    }

    pub(crate) fn all_edges(&self) -> impl Iterator<Item = EdgeId> + use<> {
        (0..self.edges.len()).map(EdgeId::new)
    }

    pub(crate) fn all_faces(&self) -> impl Iterator<Item = FaceId> + use<> {
        (0..self.faces.len()).map(FaceId::new)
    }

    pub(crate) fn corners(&self) -> impl Iterator<Item = CornerId> + use<> {
        (0..self.vertex.len()).map(CornerId::new)
    }

    pub(crate) fn edge_corners(&self, edge: EdgeId) -> &[CornerId] {
        &self.edges[edge.index()].1
    }

    pub(crate) fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edges[edge.index()].0
    }

    pub(crate) fn target(&self, corner: CornerId) -> VertexId {
        self.vertex[self.next[corner.index()].index()]
    }

    pub(crate) fn is_forward(&self, corner: CornerId) -> bool {
        self.vertex[corner.index()] == self.ends(self.edge[corner.index()])[0]
    }

    /// The other side along a corner's edge, where there are exactly two.
    pub(crate) fn across(&self, corner: CornerId) -> Option<CornerId> {
        match *self.edge_corners(self.edge[corner.index()]) {
            [one, other] => Some(if one == corner { other } else { one }),
            _ => None,
        }
    }

    /// The edges at a vertex, each once, ascending.
    pub(crate) fn vertex_edges(&self, vertex: VertexId) -> Vec<EdgeId> {
        let sides = self.stars[vertex.index()].iter().flat_map(|corner| [*corner, self.prev[corner.index()]]);
        let mut edges: Vec<EdgeId> = sides.map(|side| self.edge[side.index()]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The corners at a vertex in one walk: counter-clockwise as the face of the lowest corner runs, from the boundary on,
    /// else from the lowest corner. `None` where there is no such walk past all of them.
    pub(crate) fn rotation(&self, vertex: VertexId) -> Option<Vec<CornerId>> {
        let star = &self.stars[vertex.index()];
        let Some(&lowest) = star.first() else { return Some(Vec::new()) };
        let (after, end) = self.turn(lowest, Way::OverPrevious);
        let mut walk = Vec::new();
        if end.is_some() {
            (walk, _) = self.turn(lowest, Way::OverOwn);
            walk.reverse();
            walk.pop();
        }
        walk.extend(after);
        (walk.len() == star.len()).then_some(walk)
    }

    /// The boundary edge where the fan ends that begins with a boundary edge at one of its vertices.
    pub(crate) fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        let [side] = *self.edge_corners(edge) else { return None };
        if !self.ends(edge).contains(&at) {
            return None;
        }
        let (_, end) = if self.vertex[side.index()] == at {
            self.turn(side, Way::OverPrevious)
        } else {
            self.turn(self.next[side.index()], Way::OverOwn)
        };
        let last = self.edge[end?.index()];
        (self.edge_corners(last).len() == 1).then_some(last)
    }

    /// The corners that are come to from a corner about its vertex, that one first, and the side that leads on to no other
    /// corner; no such side where the walk comes round.
    fn turn(&self, start: CornerId, way: Way) -> (Vec<CornerId>, Option<CornerId>) {
        let (mut walk, mut corner, mut over) = (Vec::new(), start, way);
        loop {
            walk.push(corner);
            let side = match over {
                Way::OverOwn => corner,
                Way::OverPrevious => self.prev[corner.index()],
            };
            let Some(other) = self.across(side) else { return (walk, Some(side)) };
            // The other side leaves the vertex, or comes to it; its corner is left over the face's other side there.
            (corner, over) = if self.vertex[other.index()] == self.vertex[start.index()] {
                (other, Way::OverPrevious)
            } else {
                (self.next[other.index()], Way::OverOwn)
            };
            if (corner, over) == (start, way) {
                return (walk, None);
            }
        }
    }
}

/// Over which of its two sides a corner is left: its own, or the one before it, which comes to its vertex.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    OverOwn,
    OverPrevious,
}
