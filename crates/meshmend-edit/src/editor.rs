//! The editable mesh, and what can be asked of it.

use std::iter;

use meshmend_core::{
    Capabilities, CornerId, EdgeTable, FaceId, FaceTable, Id, PolygonMesh, Refusal, VertexId, admission,
};
use slotmap::{Key as _, SlotMap};

use crate::place::Place;
use crate::records::{Face, Half, Vertex};
use crate::{EdgeKey, FaceKey, HalfKey, StaleKey, VertexKey};

/// A half-edge mesh that can be edited.
///
/// Its elements are named by keys. A key whose element is gone names no other one: every question and every operator says
/// that it is stale. Keys of another editor must not be used: they may name anything here.
#[derive(Clone, Debug)]
pub struct Editor {
    pub(crate) mesh: PolygonMesh,
    pub(crate) halves: SlotMap<HalfKey, Half>,
    /// One of the two half-edges of each edge.
    pub(crate) edges: SlotMap<EdgeKey, HalfKey>,
    pub(crate) vertices: SlotMap<VertexKey, Vertex>,
    pub(crate) faces: SlotMap<FaceKey, Face>,
    /// How many vertices and faces were ever made.
    pub(crate) made: u64,
    vertex_keys: Vec<VertexKey>,
    face_keys: Vec<FaceKey>,
    corner_keys: Vec<HalfKey>,
}

impl Editor {
    /// Begins to edit a mesh.
    ///
    /// Degenerate faces and loose elements take no part, and are in the result as they are.
    ///
    /// # Errors
    /// Everything in the mesh that a half-edge structure does not hold: edges and vertices that are not manifold, neighbours
    /// that run against each other, faces that come back to a vertex.
    ///
    /// *Cost*: O(n log n); 100 bytes a side.
    pub fn new(mesh: &PolygonMesh) -> Result<Editor, Refusal> {
        let complex = mesh.complex();
        let defects = admission(complex, &Capabilities::ORIENTED_SURFACES);
        if !defects.is_empty() {
            return Err(Refusal { kernel: "half-edge", defects });
        }
        let (faces, edges) = (complex.faces(), complex.edges());
        let mut editor = Editor {
            mesh: mesh.clone(),
            halves: SlotMap::with_capacity_and_key(2 * edges.edge_count()),
            edges: SlotMap::with_capacity_and_key(edges.edge_count()),
            vertices: SlotMap::with_capacity_and_key(faces.vertex_count()),
            faces: SlotMap::with_capacity_and_key(complex.proper_face_count()),
            made: 0,
            vertex_keys: Vec::with_capacity(faces.vertex_count()),
            face_keys: Vec::with_capacity(faces.face_count()),
            corner_keys: Vec::with_capacity(faces.corner_count()),
        };
        editor.add_vertices();
        editor.add_faces(faces);
        editor.add_edges(edges);
        editor.link_boundary(edges);
        Ok(editor)
    }

    fn add_vertices(&mut self) {
        for (vertex, &position) in self.mesh.positions().iter().enumerate() {
            let source = Some(VertexId::new(vertex));
            let record = Vertex { half: None, position, source, place: None, made: 0 };
            self.vertex_keys.push(self.vertices.insert(record));
        }
    }

    /// Adds the faces with their half-edges, which have no edge and no twin yet.
    fn add_faces(&mut self, faces: &FaceTable) {
        for face in faces.faces() {
            let range = faces.corner_range(face);
            if range.is_empty() {
                self.face_keys.push(FaceKey::null());
                continue;
            }
            let key = self.faces.insert(Face { half: HalfKey::null(), source: Some(face), made: 0 });
            self.face_keys.push(key);
            for corner in range.clone() {
                let corner = CornerId::new(corner);
                let origin = self.vertex_keys[faces.corner_vertex(corner).index()];
                let place = Place::Corner(self.mesh.complex().stored_corner(corner));
                let half = self.add_half(origin, Some(key), place);
                self.vertices[origin].half.get_or_insert(half);
                self.corner_keys.push(half);
            }
            for corner in range.clone() {
                let next = if corner + 1 == range.end { range.start } else { corner + 1 };
                self.link(self.corner_keys[corner], self.corner_keys[next]);
            }
            self.faces[key].half = self.corner_keys[range.start];
        }
    }

    /// Adds the edges, with a twin along the boundary for each side that has none.
    fn add_edges(&mut self, edges: &EdgeTable) {
        for edge in edges.edges() {
            let mut sides = edges.edge_corners(edge).map(|corner| self.corner_keys[corner.index()]);
            let (Some(one), other) = (sides.next(), sides.next()) else { continue };
            let other = other.unwrap_or_else(|| {
                let origin = self.halves[self.halves[one].next].origin;
                self.add_half(origin, None, Place::Unknown)
            });
            let key = self.edges.insert(one);
            self.pair(one, other, key);
        }
    }

    /// Each half-edge along the boundary is followed by the one that leaves where it ends.
    fn link_boundary(&mut self, edges: &EdgeTable) {
        let open = edges.edges().filter_map(|edge| {
            let mut sides = edges.edge_corners(edge);
            let side = sides.next()?;
            sides.next().is_none().then(|| self.halves[self.corner_keys[side.index()]].twin)
        });
        let open: Vec<HalfKey> = open.collect();
        let mut leaving: Vec<(VertexKey, HalfKey)> =
            open.iter().map(|&half| (self.halves[half].origin, half)).collect();
        leaving.sort_unstable();
        for half in open {
            let target = self.target_of(half);
            if let Ok(at) = leaving.binary_search_by_key(&target, |&(origin, _)| origin) {
                self.link(half, leaving[at].1);
            }
        }
    }
}

/// Questions. Each fails for a stale key, and takes constant time for each answer.
impl Editor {
    /// How many vertices there are, those in no face included.
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// How many faces there are that are not degenerate.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// Every vertex, in an order that depends on the edits alone; at first that of the mesh.
    pub fn vertices(&self) -> impl Iterator<Item = VertexKey> + Clone {
        self.vertices.keys()
    }

    /// Every edge, in an order that depends on the edits alone; at first that of (smaller vertex, larger vertex).
    pub fn edges(&self) -> impl Iterator<Item = EdgeKey> + Clone {
        self.edges.keys()
    }

    /// Every face, in an order that depends on the edits alone; at first that of the mesh.
    pub fn faces(&self) -> impl Iterator<Item = FaceKey> + Clone {
        self.faces.keys()
    }

    /// Every half-edge, those along holes included, in an order that depends on the edits alone.
    pub fn halves(&self) -> impl Iterator<Item = HalfKey> + Clone {
        self.halves.keys()
    }

    /// The key that a vertex of the mesh had at first. None if the mesh has no such vertex.
    pub fn vertex_of(&self, vertex: VertexId) -> Option<VertexKey> {
        self.vertex_keys.get(vertex.index()).copied()
    }

    /// The key that a face of the mesh had at first. None if the mesh has no such face, or it is degenerate.
    pub fn face_of(&self, face: FaceId) -> Option<FaceKey> {
        self.face_keys.get(face.index()).copied().filter(|key| !key.is_null())
    }

    /// The key that a corner of the mesh's complex had at first. None if there is no such corner.
    pub fn half_of(&self, corner: CornerId) -> Option<HalfKey> {
        self.corner_keys.get(corner.index()).copied()
    }

    /// The half-edge that follows in the face or along the hole.
    pub fn next(&self, half: HalfKey) -> Result<HalfKey, StaleKey> {
        Ok(self.half(half)?.next)
    }

    /// The half-edge before in the face or along the hole.
    pub fn prev(&self, half: HalfKey) -> Result<HalfKey, StaleKey> {
        Ok(self.half(half)?.prev)
    }

    /// The other half-edge of the same edge.
    pub fn twin(&self, half: HalfKey) -> Result<HalfKey, StaleKey> {
        Ok(self.half(half)?.twin)
    }

    /// The vertex that a half-edge leaves.
    pub fn origin(&self, half: HalfKey) -> Result<VertexKey, StaleKey> {
        Ok(self.half(half)?.origin)
    }

    /// The vertex that a half-edge leads to.
    pub fn target(&self, half: HalfKey) -> Result<VertexKey, StaleKey> {
        Ok(self.halves[self.half(half)?.twin].origin)
    }

    /// The edge of a half-edge.
    pub fn edge(&self, half: HalfKey) -> Result<EdgeKey, StaleKey> {
        Ok(self.half(half)?.edge)
    }

    /// The face to the left of a half-edge. None along a hole.
    pub fn face(&self, half: HalfKey) -> Result<Option<FaceKey>, StaleKey> {
        Ok(self.half(half)?.face)
    }

    /// The half-edges of a face, in its order.
    pub fn face_halves(&self, face: FaceKey) -> Result<impl Iterator<Item = HalfKey> + Clone, StaleKey> {
        let face = self.faces.get(face).ok_or(StaleKey(face.into()))?;
        Ok(self.round(face.half))
    }

    /// The half-edges that follow one along its face or hole, itself first.
    pub fn loop_halves(&self, half: HalfKey) -> Result<impl Iterator<Item = HalfKey> + Clone, StaleKey> {
        self.half(half)?;
        Ok(self.round(half))
    }

    /// The half-edges that leave a vertex, counter-clockwise; none where it is in no face.
    pub fn vertex_halves(
        &self,
        vertex: VertexKey,
    ) -> Result<impl Iterator<Item = HalfKey> + Clone, StaleKey> {
        let vertex = self.vertices.get(vertex).ok_or(StaleKey(vertex.into()))?;
        Ok(vertex.half.into_iter().flat_map(|half| self.star(half)))
    }

    /// The two half-edges of an edge.
    pub fn edge_halves(&self, edge: EdgeKey) -> Result<[HalfKey; 2], StaleKey> {
        let &half = self.edges.get(edge).ok_or(StaleKey(edge.into()))?;
        Ok([half, self.halves[half].twin])
    }

    /// The half-edge from one vertex to another. None where no edge joins them.
    ///
    /// *Cost*: linear in the edges at the first vertex.
    pub fn half_between(&self, from: VertexKey, to: VertexKey) -> Result<Option<HalfKey>, StaleKey> {
        self.vertices.get(to).ok_or(StaleKey(to.into()))?;
        let mut halves = self.vertex_halves(from)?;
        Ok(halves.find(|&half| self.target_of(half) == to))
    }

    /// Where a vertex is.
    pub fn position(&self, vertex: VertexKey) -> Result<[f64; 3], StaleKey> {
        Ok(self.vertices.get(vertex).ok_or(StaleKey(vertex.into()))?.position)
    }

    /// Moves a vertex.
    ///
    /// # Errors
    /// If the key is stale.
    pub fn set_position(&mut self, vertex: VertexKey, position: [f64; 3]) -> Result<(), StaleKey> {
        self.vertices.get_mut(vertex).ok_or(StaleKey(vertex.into()))?.position = position;
        Ok(())
    }

    /// The vertex of the mesh that a vertex is, or was split from. None for any other created one.
    pub fn vertex_source(&self, vertex: VertexKey) -> Result<Option<VertexId>, StaleKey> {
        Ok(self.vertices.get(vertex).ok_or(StaleKey(vertex.into()))?.source)
    }

    /// The face of the mesh that a face is, or is a piece of. None for any other created one.
    pub fn face_source(&self, face: FaceKey) -> Result<Option<FaceId>, StaleKey> {
        Ok(self.faces.get(face).ok_or(StaleKey(face.into()))?.source)
    }

    fn half(&self, half: HalfKey) -> Result<&Half, StaleKey> {
        self.halves.get(half).ok_or(StaleKey(half.into()))
    }
}

/// The same questions about keys that are known to be fresh.
impl Editor {
    pub(crate) fn target_of(&self, half: HalfKey) -> VertexKey {
        self.halves[self.halves[half].twin].origin
    }

    /// The half-edges along a face or hole, from one on.
    pub(crate) fn round(&self, first: HalfKey) -> impl Iterator<Item = HalfKey> + Clone {
        iter::successors(Some(first), move |&half| Some(self.halves[half].next).filter(|&next| next != first))
    }

    /// The next half-edge out of the same vertex, counter-clockwise.
    pub(crate) fn turned(&self, half: HalfKey) -> HalfKey {
        self.halves[self.halves[half].prev].twin
    }

    /// The half-edges out of the vertex that one leaves, counter-clockwise from that one on.
    pub(crate) fn star(&self, first: HalfKey) -> impl Iterator<Item = HalfKey> + Clone {
        iter::successors(Some(first), move |&half| Some(self.turned(half)).filter(|&next| next != first))
    }

    /// The half-edges out of a vertex, counter-clockwise.
    pub(crate) fn star_of(&self, vertex: VertexKey) -> impl Iterator<Item = HalfKey> + Clone {
        self.vertices[vertex].half.into_iter().flat_map(|half| self.star(half))
    }

    pub(crate) fn is_on_boundary(&self, vertex: VertexKey) -> bool {
        self.star_of(vertex).any(|half| self.halves[half].face.is_none())
    }

    pub(crate) fn are_joined(&self, one: VertexKey, other: VertexKey) -> bool {
        self.star_of(one).any(|half| self.target_of(half) == other)
    }

    /// The face of a half-edge if that has three sides.
    pub(crate) fn triangle(&self, half: HalfKey) -> Option<FaceKey> {
        let Half { next, prev, face, .. } = self.halves[half];
        face.filter(|_| self.halves[next].next == prev)
    }
}
