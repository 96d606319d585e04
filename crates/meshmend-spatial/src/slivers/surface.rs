//! The faces of a mesh while slivers are mended: corners get other vertices, and faces go.

use meshmend_core::{CornerId, FaceId, FaceTable, Id, Lists, PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, is_finite};

/// A neighbour of a vertex, and how many sides run between the two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Neighbour {
    pub(super) vertex: VertexId,
    pub(super) sides: usize,
    /// How many of these run towards it.
    pub(super) towards: usize,
}

impl Neighbour {
    /// Whether the edge has one side, or two that run against each other.
    pub(super) fn is_regular(self) -> bool {
        self.sides == 1 || self.sides == 2 && self.towards == 1
    }
}

/// The faces as they are now. Vertices never move; ids stay those of the mesh.
pub(super) struct Faces<'a> {
    mesh: &'a PolygonMesh,
    table: &'a FaceTable,
    /// The vertex of each corner.
    vertices: Vec<VertexId>,
    /// The corner of the mesh whose attributes each corner has.
    origins: Vec<CornerId>,
    is_gone: Vec<bool>,
    /// The faces at each vertex of the mesh.
    stored: Lists<VertexId, FaceId>,
    /// Where the list of a vertex is that other faces came to, if any did.
    grown: Vec<u32>,
    lists: Vec<Vec<FaceId>>,
}

impl<'a> Faces<'a> {
    /// The faces of a mesh, before any step.
    ///
    /// *Cost*: linear.
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let table = mesh.faces();
        let pairs = table.faces().flat_map(|face| table.face_vertices(face).iter().map(move |&v| (v, face)));
        Faces {
            mesh,
            table,
            vertices: table.corner_vertices().to_vec(),
            origins: table.corners().collect(),
            is_gone: vec![false; table.face_count()],
            stored: Lists::group(table.vertex_count(), pairs),
            grown: vec![u32::MAX; table.vertex_count()],
            lists: Vec::new(),
        }
    }

    /// The vertex of each corner, the corner whose attributes it has, and which faces are gone.
    pub(super) fn into_parts(self) -> (Vec<VertexId>, Vec<CornerId>, Vec<bool>) {
        (self.vertices, self.origins, self.is_gone)
    }

    pub(super) fn point(&self, vertex: VertexId) -> Point {
        self.mesh.position(vertex)
    }

    pub(super) fn is_there(&self, face: FaceId) -> bool {
        !self.is_gone[face.index()]
    }

    /// The vertices of a face.
    pub(super) fn of_face(&self, face: FaceId) -> &[VertexId] {
        &self.vertices[self.table.corner_range(face)]
    }

    /// The corners of a face if it is a triangle of three different vertices.
    pub(super) fn triangle(&self, face: FaceId) -> Option<[VertexId; 3]> {
        match *self.of_face(face) {
            [a, b, c] if a != b && b != c && c != a => Some([a, b, c]),
            _ => None,
        }
    }

    /// The points of some vertices, if all are finite.
    pub(super) fn points(&self, vertices: [VertexId; 3]) -> Option<[Point; 3]> {
        Some(vertices.map(|vertex| self.point(vertex))).filter(|points| points.iter().all(is_finite))
    }

    /// The corner of a face at a vertex.
    pub(super) fn corner(&self, face: FaceId, vertex: VertexId) -> Option<CornerId> {
        let mut range = self.table.corner_range(face);
        range.find(|&place| self.vertices[place] == vertex).map(CornerId::new)
    }

    /// The corner of the mesh whose attributes a corner has.
    pub(super) fn origin(&self, corner: CornerId) -> CornerId {
        self.origins[corner.index()]
    }

    /// The faces at a vertex, in no order, each once.
    pub(super) fn star(&self, vertex: VertexId) -> Vec<FaceId> {
        let mut star: Vec<FaceId> = self.listed(vertex).to_vec();
        star.retain(|&face| self.is_there(face) && self.of_face(face).contains(&vertex));
        // A face that comes to a vertex twice is listed twice, side by side.
        star.dedup();
        star
    }

    /// The neighbours of a vertex with some faces, ascending.
    pub(super) fn neighbours(&self, vertex: VertexId, star: &[FaceId]) -> Vec<Neighbour> {
        let mut ends: Vec<(VertexId, bool)> = Vec::with_capacity(2 * star.len());
        for &face in star {
            let corners = self.of_face(face);
            let last = corners.len() - 1;
            for place in (0..corners.len()).filter(|&place| corners[place] == vertex) {
                ends.push((corners[if place == 0 { last } else { place - 1 }], false));
                ends.push((corners[if place == last { 0 } else { place + 1 }], true));
            }
        }
        ends.sort_unstable();
        let groups = ends.chunk_by(|one, other| one.0 == other.0);
        let towards = |group: &[(VertexId, bool)]| group.iter().filter(|(_, towards)| *towards).count();
        let neighbour = |group: &[(VertexId, bool)]| Neighbour {
            vertex: group[0].0,
            sides: group.len(),
            towards: towards(group),
        };
        groups.map(neighbour).collect()
    }

    /// Whether no face of some comes to a vertex twice.
    pub(super) fn are_simple(&self, faces: &[FaceId]) -> bool {
        let repeats =
            |corners: &[VertexId]| (1..corners.len()).any(|at| corners[..at].contains(&corners[at]));
        faces.iter().all(|&face| !repeats(self.of_face(face)))
    }

    /// Whether the triangles at a vertex, whose edges there are regular, hang together there.
    pub(super) fn is_umbrella(&self, vertex: VertexId, star: &[FaceId]) -> bool {
        let side = |&face: &FaceId| {
            let corners = self.triangle(face)?;
            let at = corners.iter().position(|&corner| corner == vertex)?;
            Some((corners[(at + 1) % 3], corners[(at + 2) % 3]))
        };
        let mut sides: Vec<(VertexId, VertexId)> = star.iter().filter_map(side).collect();
        sides.sort_unstable();
        let next =
            |from: VertexId| sides.binary_search_by_key(&from, |(from, _)| *from).ok().map(|at| sides[at].1);
        let mut ends: Vec<VertexId> = sides.iter().map(|(_, to)| *to).collect();
        ends.sort_unstable();
        let first = sides.iter().map(|(from, _)| *from).find(|from| ends.binary_search(from).is_err());
        let Some(first) = first.or(sides.first().map(|(from, _)| *from)) else { return false };
        let (mut at, mut count) = (first, 0);
        while let Some(to) = next(at).filter(|_| count < sides.len()) {
            (at, count) = (to, count + 1);
        }
        count == star.len()
    }

    /// Puts a corner of a face to another vertex, with the attributes of a corner of the mesh.
    pub(super) fn put(&mut self, face: FaceId, from: VertexId, to: VertexId, origin: CornerId) {
        let Some(corner) = self.corner(face, from) else { return };
        self.vertices[corner.index()] = to;
        self.origins[corner.index()] = origin;
        if !self.listed(to).contains(&face) {
            self.grown_list(to).push(face);
        }
    }

    /// Takes a face away.
    pub(super) fn remove(&mut self, face: FaceId) {
        self.is_gone[face.index()] = true;
    }

    /// Faces among which those at a vertex are.
    fn listed(&self, vertex: VertexId) -> &[FaceId] {
        match self.lists.get(self.grown[vertex.index()] as usize) {
            Some(list) => list,
            None => self.stored.of(vertex),
        }
    }

    fn grown_list(&mut self, vertex: VertexId) -> &mut Vec<FaceId> {
        let at = &mut self.grown[vertex.index()];
        if *at == u32::MAX {
            *at = self.lists.len() as u32;
            self.lists.push(self.stored.of(vertex).to_vec());
        }
        &mut self.lists[*at as usize]
    }
}
