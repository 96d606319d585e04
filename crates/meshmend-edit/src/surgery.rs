//! The small steps of which operators are made: they add, remove and link records.

use meshmend_core::{Blend, FaceId, MAX_CORNERS, VertexId};
use slotmap::Key as _;

use crate::place::Place;
use crate::records::{Face, Half, Vertex};
use crate::{EdgeKey, EditRefusal, Editor, FaceKey, HalfKey, Key, Refused, VertexKey};

impl Editor {
    /// Makes one half-edge follow another.
    pub(crate) fn link(&mut self, half: HalfKey, next: HalfKey) {
        self.halves[half].next = next;
        self.halves[next].prev = half;
    }

    /// Makes two half-edges the halves of an edge.
    pub(crate) fn pair(&mut self, one: HalfKey, other: HalfKey, edge: EdgeKey) {
        (self.halves[one].twin, self.halves[one].edge) = (other, edge);
        (self.halves[other].twin, self.halves[other].edge) = (one, edge);
        self.edges[edge] = one;
    }

    /// Adds a half-edge without neighbours.
    pub(crate) fn add_half(&mut self, origin: VertexKey, face: Option<FaceKey>, place: Place) -> HalfKey {
        let (none, edge) = (HalfKey::null(), EdgeKey::null());
        self.halves.insert(Half { next: none, prev: none, twin: none, origin, face, edge, place })
    }

    /// Adds an edge: the half-edge from one vertex to the other, and its twin. They are in no face yet.
    pub(crate) fn add_edge(&mut self, from: VertexKey, to: VertexKey) -> [HalfKey; 2] {
        let there = self.add_half(from, None, Place::Unknown);
        let back = self.add_half(to, None, Place::Unknown);
        let edge = self.edges.insert(there);
        self.pair(there, back, edge);
        [there, back]
    }

    /// Removes an edge and both of its halves.
    pub(crate) fn remove_edge(&mut self, half: HalfKey) {
        let Half { twin, edge, .. } = self.halves[half];
        self.halves.remove(half);
        self.halves.remove(twin);
        self.edges.remove(edge);
    }

    /// Adds a vertex without half-edges.
    pub(crate) fn add_vertex(
        &mut self,
        position: [f64; 3],
        source: Option<VertexId>,
        place: Option<Blend>,
    ) -> VertexKey {
        self.made += 1;
        self.vertices.insert(Vertex { half: None, position, source, place, made: self.made })
    }

    /// Adds a face to the left of a half-edge, and of those that follow it.
    pub(crate) fn add_face(&mut self, half: HalfKey, source: Option<FaceId>) -> FaceKey {
        self.made += 1;
        let face = self.faces.insert(Face { half, source, made: self.made });
        self.set_face(half, Some(face));
        face
    }

    /// Says which face lies to the left of a half-edge and of those that follow it.
    pub(crate) fn set_face(&mut self, first: HalfKey, face: Option<FaceKey>) {
        let mut half = first;
        loop {
            self.halves[half].face = face;
            half = self.halves[half].next;
            if half == first {
                break;
            }
        }
    }

    /// Hands half-edges over to another vertex.
    pub(crate) fn set_origin(&mut self, halves: &[HalfKey], vertex: VertexKey) {
        for &half in halves {
            self.halves[half].origin = vertex;
        }
    }

    /// Makes one vertex another: its half-edges, of which these are all, leave that one.
    pub(crate) fn hand_over(&mut self, halves: &[HalfKey], gone: VertexKey, kept: VertexKey) {
        let sources = [gone, kept].map(|vertex| self.vertices[vertex].source);
        let is_same = sources[0].is_some() && sources[0] == sources[1];
        for &half in halves.iter().filter(|_| !is_same) {
            self.halves[half].place = self.halves[half].place.handed_over();
        }
        self.set_origin(halves, kept);
    }

    /// The face of the mesh from which what lies left of a half-edge comes.
    pub(crate) fn source_left_of(&self, half: HalfKey) -> Option<FaceId> {
        self.faces[self.halves[half].face?].source
    }

    /// Refuses stale keys.
    pub(crate) fn fresh(&self, keys: impl IntoIterator<Item = Key>) -> Result<(), Refused> {
        let is_stale = |key: &Key| match *key {
            Key::Vertex(vertex) => !self.vertices.contains_key(vertex),
            Key::Edge(edge) => !self.edges.contains_key(edge),
            Key::Face(face) => !self.faces.contains_key(face),
            Key::Half(half) => !self.halves.contains_key(half),
        };
        let stale = keys.into_iter().filter(is_stale);
        crate::refusal::unless(stale.map(EditRefusal::Stale).collect())
    }

    /// A reason against so many further half-edges, if there is no number left for them. There are never more vertices,
    /// edges or faces than half-edges, but for vertices in no face.
    pub(crate) fn full(&self, halves: usize) -> Option<EditRefusal> {
        let most = self.halves.len().max(self.vertices.len()).saturating_add(halves);
        (most > MAX_CORNERS).then_some(EditRefusal::Full)
    }
}
