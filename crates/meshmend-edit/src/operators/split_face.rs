//! A face becomes two, and two become one.
//!
//! ```text
//!        b ←─ k ─┐            b ───┐
//!        │       │            │ ╲ g│         g is made; the half-edges from k on are its own
//!        │   f   │     →      │f ╲ │
//!        └─ h ─→ ·            └── a
//!        a                      ←  join_faces
//! ```

use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, HalfKey, Refused, VertexKey};

impl Editor {
    /// Whether two corners of a face can be joined by an edge.
    ///
    /// # Errors
    /// `stale`; `boundary` for a half-edge along a hole; `two-faces`; `adjacent` if the corners are neighbours or the same;
    /// `already-joined` if an edge joins their vertices elsewhere; `full`.
    pub fn can_split_face(&self, from: HalfKey, to: HalfKey) -> Result<(), Refused> {
        self.fresh([from.into(), to.into()])?;
        let [one, other] = [from, to].map(|half| self.halves[half]);
        let is_open = |&half: &HalfKey| self.halves[half].face.is_none();
        let mut reasons: Vec<EditRefusal> =
            [from, to].into_iter().filter(is_open).map(|half| EditRefusal::Boundary(half.into())).collect();
        if one.face != other.face {
            reasons.push(EditRefusal::TwoFaces([from, to]));
        } else if from == to || one.next == to || other.next == from {
            reasons.push(EditRefusal::Adjacent([from, to]));
        } else if self.are_joined(one.origin, other.origin) {
            reasons.push(EditRefusal::AlreadyJoined([one.origin, other.origin]));
        }
        reasons.extend(self.full(2));
        unless(reasons)
    }

    /// Joins two corners of a face by an edge. The face keeps the half-edges from the first one on, and those from the
    /// second one on are a new face's. [`Editor::join_faces`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_split_face`].
    ///
    /// *Cost*: linear in the face and in the edges of the first corner's vertex.
    pub fn split_face(&mut self, from: HalfKey, to: HalfKey) -> Result<Done, Refused> {
        self.can_split_face(from, to)?;
        let [one, other] = [from, to].map(|half| self.halves[half]);
        let [closing, opening] = self.add_edge(other.origin, one.origin);
        self.link(other.prev, closing);
        self.link(closing, from);
        self.link(one.prev, opening);
        self.link(opening, to);
        self.halves[closing].place = other.place;
        self.halves[opening].place = one.place;
        self.halves[closing].face = one.face;
        let face = self.add_face(to, self.source_left_of(from));
        if let Some(kept) = one.face {
            self.faces[kept].half = from;
        }
        let edge = self.halves[closing].edge;
        Ok(Done { edges: vec![edge], faces: vec![face], ..Done::undone_by(Edit::JoinFaces { edge }) })
    }

    /// Whether the edge between two faces can be removed.
    ///
    /// # Errors
    /// `stale`; `boundary`; `shares-more` if the faces share more than the edge and its ends. (A face is never on both sides
    /// of an edge here: it would come back to a vertex.)
    pub fn can_join_faces(&self, edge: EdgeKey) -> Result<(), Refused> {
        self.fresh([edge.into()])?;
        let half = self.edges[edge];
        let twin = self.halves[half].twin;
        let (Some(one), Some(other)) = (self.halves[half].face, self.halves[twin].face) else {
            return Err(EditRefusal::Boundary(edge.into()).into());
        };
        let ends = [half, twin].map(|half| self.halves[half].origin);
        let mut vertices: Vec<VertexKey> = self.round(half).map(|half| self.halves[half].origin).collect();
        vertices.sort_unstable();
        let others = self.round(twin).map(|half| self.halves[half].origin);
        let shared = others.filter(|vertex| !ends.contains(vertex) && vertices.binary_search(vertex).is_ok());
        unless(shared.map(|vertex| EditRefusal::SharesMore { faces: [one, other], vertex }).collect())
    }

    /// Removes the edge between two faces. The face of the edge's first half-edge stays. [`Editor::split_face`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_join_faces`].
    ///
    /// *Cost*: O(n log n) in the sides of the two faces.
    pub fn join_faces(&mut self, edge: EdgeKey) -> Result<Done, Refused> {
        self.can_join_faces(edge)?;
        let half = self.edges[edge];
        let twin = self.halves[half].twin;
        let [one, other] = [half, twin].map(|half| self.halves[half]);
        self.link(one.prev, other.next);
        self.link(other.prev, one.next);
        self.halves[other.next].place = one.place;
        self.vertices[one.origin].half = Some(other.next);
        self.vertices[other.origin].half = Some(one.next);
        self.begin_face_elsewhere(half, one.next);
        self.set_face(one.next, one.face);
        if let (Some(kept), Some(gone)) = (one.face, other.face) {
            let source = self.faces[gone].source;
            self.faces[kept].source = self.faces[kept].source.or(source);
            self.faces.remove(gone);
        }
        self.remove_edge(half);
        Ok(Done::undone_by(Edit::SplitFace { from: one.next, to: other.next }))
    }
}
