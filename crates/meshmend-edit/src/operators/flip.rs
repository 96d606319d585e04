//! The edge between two triangles joins their tips in place of its ends.
//!
//! ```text
//!            b                      b
//!          ╱ │ ╲                  ╱   ╲
//!        c   │h  d      →       c ←─ h ─ d
//!          ╲ │ ╱                  ╲   ╱
//!            a                      a
//! ```

use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, Refused, VertexKey};

impl Editor {
    /// Whether an edge can be turned to join the tips of its two triangles.
    ///
    /// # Errors
    /// `stale`; `boundary`; `not-a-triangle` for each face that is larger; `already-joined` if the tips are one vertex or an
    /// edge joins them; `degree` if one of its ends would have fewer than three edges, or two on the boundary.
    pub fn can_flip(&self, edge: EdgeKey) -> Result<(), Refused> {
        self.fresh([edge.into()])?;
        let half = self.edges[edge];
        let halves = [half, self.halves[half].twin];
        if halves.iter().any(|&half| self.halves[half].face.is_none()) {
            return Err(EditRefusal::Boundary(edge.into()).into());
        }
        let larger = halves.iter().filter(|&&half| self.triangle(half).is_none());
        let mut reasons: Vec<EditRefusal> =
            larger.filter_map(|&half| self.halves[half].face).map(EditRefusal::NotATriangle).collect();
        if reasons.is_empty() {
            let tips = halves.map(|half| self.halves[self.halves[half].prev].origin);
            if tips[0] == tips[1] || self.are_joined(tips[0], tips[1]) {
                reasons.push(EditRefusal::AlreadyJoined(tips));
            }
        }
        reasons.extend(halves.iter().filter_map(|&half| self.too_few_edges(self.halves[half].origin)));
        unless(reasons)
    }

    /// A reason against taking an edge from a vertex.
    fn too_few_edges(&self, vertex: VertexKey) -> Option<EditRefusal> {
        let found = self.star_of(vertex).count();
        let (least, needed) = if self.is_on_boundary(vertex) { (3, "at least 3") } else { (4, "at least 4") };
        (found < least).then_some(EditRefusal::Degree { vertex, found, needed })
    }

    /// Turns an edge counter-clockwise, so that it joins the tips of its two triangles. Another flip undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_flip`].
    ///
    /// *Cost*: linear in the edges of the four vertices.
    pub fn flip(&mut self, edge: EdgeKey) -> Result<Done, Refused> {
        self.can_flip(edge)?;
        let left = self.edges[edge];
        let right = self.halves[left].twin;
        let [one, other] = [left, right].map(|half| self.halves[half]);
        let tips = [one.prev, other.prev].map(|half| (self.halves[half].origin, self.halves[half].place));
        for (half, this, that, (origin, place)) in [(left, one, other, tips[1]), (right, other, one, tips[0])]
        {
            self.link(half, this.prev);
            self.link(this.prev, that.next);
            self.link(that.next, half);
            (self.halves[half].origin, self.halves[half].place) = (origin, place);
            (self.halves[that.next].face, self.halves[that.next].place) = (this.face, this.place);
            self.vertices[this.origin].half = Some(that.next);
            if let Some(face) = this.face {
                self.faces[face].half = this.prev;
            }
        }
        Ok(Done::undone_by(Edit::Flip { edge }))
    }
}
