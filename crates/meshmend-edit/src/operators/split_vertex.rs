//! A vertex becomes an edge.
//!
//! ```text
//!        to                      to
//!      d ──╲                   d ──╲
//!           v ── from c   →       t│v ╲
//!      · ──╱                       │h  c     w takes the edges from `from` on, counter-clockwise, up to `to`
//!                              · ──w ╱
//! ```

use crate::place::Place;
use crate::records::Half;
use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, FaceKey, HalfKey, Opening, Refused};

impl Editor {
    /// Whether a new vertex can take an arc of the edges of a vertex.
    ///
    /// # Errors
    /// `stale`; `not-one-vertex`; `same-half` if the arc has no inside; `link-condition` where two triangles lie on each other
    /// and would become a tetrahedron, which nothing undoes; `full`.
    pub fn can_split_vertex(&self, from: Opening, to: Opening) -> Result<(), Refused> {
        let halves = [from, to].map(Opening::half);
        self.fresh(halves.map(Into::into))?;
        let mut reasons = Vec::new();
        if self.halves[halves[0]].origin != self.halves[halves[1]].origin {
            reasons.push(EditRefusal::NotOneVertex(halves));
        }
        if from == to {
            reasons.push(EditRefusal::SameHalf(halves[0]));
        }
        if let (Opening::Edge(one), Opening::Edge(other)) = (from, to)
            && one != other
        {
            reasons.extend(self.pillow(one, other));
        }
        reasons.extend(self.full(6));
        unless(reasons)
    }

    /// A reason against opening both edges of a vertex between two triangles on the same three vertices.
    fn pillow(&self, one: HalfKey, other: HalfKey) -> Option<EditRefusal> {
        let are_neighbours = self.turned(one) == other && self.turned(other) == one;
        if !are_neighbours || self.triangle(one).is_none() || self.triangle(other).is_none() {
            return None;
        }
        let edges = vec![self.halves[self.halves[one].next].edge];
        Some(EditRefusal::LinkCondition { vertices: Vec::new(), edges, faces: Vec::new() })
    }

    /// Splits a vertex: a new one at a point takes what lies counter-clockwise from one opening to the other, and an edge joins
    /// the two. A face or hole in which an end of the arc lies gets a side more, and an edge along which one lies becomes a
    /// triangle. [`Editor::collapse`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_split_vertex`].
    ///
    /// *Cost*: linear in the edges of the vertex.
    pub fn split_vertex(&mut self, from: Opening, to: Opening, point: [f64; 3]) -> Result<Done, Refused> {
        self.can_split_vertex(from, to)?;
        let kept = self.halves[from.half()].origin;
        let arc = self.arc(from, to);
        let source = &self.vertices[kept];
        let (source, place) = (source.source, source.place);
        let vertex = self.add_vertex(point, source, place);
        let [back, there] = self.add_edge(vertex, kept);
        let mut edges = vec![self.halves[back].edge];
        let mut faces = Vec::new();
        self.set_origin(&arc, vertex);
        for (half, opening) in [(back, from), (there, to)] {
            match opening {
                Opening::Corner(next) => self.lengthen(half, next),
                Opening::Edge(outward) => {
                    let (edge, face) = self.open_triangle(half, outward);
                    edges.push(edge);
                    faces.push(face);
                }
            }
        }
        self.vertices[vertex].half = Some(back);
        self.vertices[kept].half = Some(there);
        let undo = Edit::Collapse { half: back, point: self.vertices[kept].position };
        Ok(Done { vertices: vec![vertex], edges, faces, ..Done::undone_by(undo) })
    }

    /// The half-edges that go to the new vertex.
    fn arc(&self, from: Opening, to: Opening) -> Vec<HalfKey> {
        let mut arc = Vec::new();
        if let Opening::Edge(half) = from {
            arc.push(half);
            if to == Opening::Corner(half) {
                return arc;
            }
        }
        for half in self.star(from.half()).skip(1).chain([from.half()]) {
            if to == Opening::Edge(half) {
                break;
            }
            arc.push(half);
            if to == Opening::Corner(half) {
                break;
            }
        }
        arc
    }

    /// Puts a half-edge into a face or hole, before another one.
    fn lengthen(&mut self, half: HalfKey, next: HalfKey) {
        let Half { prev, face, place, .. } = self.halves[next];
        self.link(prev, half);
        self.link(half, next);
        (self.halves[half].face, self.halves[half].place) = (face, place);
    }

    /// Opens an edge to a triangle on a half-edge. The two halves of the edge stay outside of it, each with another twin.
    fn open_triangle(&mut self, base: HalfKey, outward: HalfKey) -> (EdgeKey, FaceKey) {
        let Half { twin: inward, edge, .. } = self.halves[outward];
        let [at_vertex, at_tip] = self.corners_beside(outward, inward);
        let (end, tip) = (self.target_of(base), self.halves[inward].origin);
        let there = self.add_half(end, None, at_vertex);
        let back = self.add_half(tip, None, at_tip);
        self.halves[base].place = at_vertex;
        self.pair(there, inward, edge);
        let new = self.edges.insert(back);
        self.pair(back, outward, new);
        self.link(base, there);
        self.link(there, back);
        self.link(back, base);
        (new, self.add_face(base, None))
    }

    /// The corners at both ends of an edge in a face beside it: the attributes of a triangle that opens there.
    fn corners_beside(&self, outward: HalfKey, inward: HalfKey) -> [Place; 2] {
        let place = |half: HalfKey| self.halves[half].place;
        if self.halves[inward].face.is_some() {
            [place(self.halves[inward].next), place(inward)]
        } else {
            [place(outward), place(self.halves[outward].next)]
        }
    }
}
