//! An edge becomes two, and two become one.
//!
//! ```text
//!        a ────── e ────── b      split_edge →      a ── e ── m ── n ── b
//!                                 ← join_edges
//! ```

use meshmend_core::Blend;

use crate::place::{Fraction, Place, simplest};
use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, HalfKey, Refused, VertexKey};

impl Editor {
    /// Whether a vertex can be put on an edge, a fraction of the way along its first half-edge.
    ///
    /// # Errors
    /// `stale`; `not-between` unless 0 < at < 1; `full`.
    pub fn can_split_edge(&self, edge: EdgeKey, at: f64) -> Result<(), Refused> {
        self.fresh([edge.into()])?;
        let is_between = at > 0.0 && at < 1.0;
        let reasons = (!is_between).then_some(EditRefusal::NotBetween).into_iter().chain(self.full(2));
        unless(reasons.collect())
    }

    /// Puts a vertex on an edge, a fraction of the way along its first half-edge. [`Editor::join_edges`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_split_edge`].
    ///
    /// *Cost*: constant.
    pub fn split_edge(&mut self, edge: EdgeKey, at: f64) -> Result<Done, Refused> {
        self.can_split_edge(edge, at)?;
        let there = self.edges[edge];
        let back = self.halves[there].twin;
        let (fraction, rest) = match simplest(at) {
            Some([p, q]) => (Some([p, q]), Some([q - p, q])),
            None => (None, None),
        };
        let places = [self.place_on(there, fraction), self.place_on(back, rest)];
        let [from, to] = [there, back].map(|half| self.halves[half].origin);
        let position = between(self.vertices[from].position, self.vertices[to].position, at);
        let vertex = self.add_vertex(position, None, best(places));
        let [there_on, back_on] = self.add_edge(vertex, to);

        let (after, before) = (self.halves[there].next, self.halves[back].prev);
        self.link(there_on, after);
        self.link(there, there_on);
        self.link(before, back_on);
        self.link(back_on, back);
        self.begin_face_elsewhere(back, back_on);
        let [left, right] = [there, back].map(|half| self.halves[half].face);
        (self.halves[there_on].face, self.halves[there_on].place) = (left, places[0]);
        (self.halves[back_on].face, self.halves[back_on].place) = (right, self.halves[back].place);
        (self.halves[back].origin, self.halves[back].place) = (vertex, places[1]);
        self.vertices[to].half = Some(back_on);
        self.vertices[vertex].half = Some(there_on);
        let edges = vec![self.halves[there_on].edge];
        Ok(Done { vertices: vec![vertex], edges, ..Done::undone_by(Edit::JoinEdges { vertex }) })
    }

    /// Where a new corner on the side of a half-edge lies.
    fn place_on(&self, half: HalfKey, at: Option<Fraction>) -> Place {
        let ends = [half, self.halves[half].next].map(|half| self.halves[half].place);
        Place::between(ends, at, self.source_left_of(half), self.mesh.faces())
    }

    /// Whether a vertex can be taken out of the line of its two edges.
    ///
    /// # Errors
    /// `stale`; `degree` unless it has two edges; `triangle` if a face there has three sides; `already-joined` if an edge
    /// joins its neighbours.
    pub fn can_join_edges(&self, vertex: VertexKey) -> Result<(), Refused> {
        self.fresh([vertex.into()])?;
        let halves = self.two_halves(vertex)?;
        let mut reasons: Vec<EditRefusal> =
            halves.iter().filter_map(|&half| self.triangle(half)).map(EditRefusal::Triangle).collect();
        let neighbours = halves.map(|half| self.target_of(half));
        if self.are_joined(neighbours[0], neighbours[1]) {
            reasons.push(EditRefusal::AlreadyJoined(neighbours));
        }
        unless(reasons)
    }

    /// Takes a vertex out of the line of its two edges, one of which stays. [`Editor::split_edge`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_join_edges`].
    ///
    /// *Cost*: linear in the edges of a neighbour.
    pub fn join_edges(&mut self, vertex: VertexKey) -> Result<Done, Refused> {
        self.can_join_edges(vertex)?;
        let [gone, _] = self.two_halves(vertex)?;
        let gone_back = self.halves[gone].twin;
        let kept = self.halves[gone].prev;
        let kept_back = self.halves[kept].twin;
        let end = self.halves[gone_back].origin;
        let [a, m, b] = [self.halves[kept].origin, vertex, end].map(|v| self.vertices[v].position);

        let (after, before) = (self.halves[gone].next, self.halves[gone_back].prev);
        self.link(kept, after);
        self.link(before, kept_back);
        self.halves[kept_back].origin = end;
        self.halves[kept_back].place = self.halves[gone_back].place;
        for (half, instead) in [(gone, kept), (gone_back, kept_back)] {
            self.begin_face_elsewhere(half, instead);
        }
        self.vertices[end].half = Some(kept_back);
        self.remove_edge(gone);
        self.vertices.remove(vertex);
        let edge = self.halves[kept].edge;
        let at = if self.edges[edge] == kept { along(a, b, m) } else { along(b, a, m) };
        Ok(Done::undone_by(Edit::SplitEdge { edge, at }))
    }

    /// The half-edges out of a vertex that has two edges.
    fn two_halves(&self, vertex: VertexKey) -> Result<[HalfKey; 2], EditRefusal> {
        let halves: Vec<HalfKey> = self.star_of(vertex).collect();
        let found = halves.len();
        halves.try_into().map_err(|_| EditRefusal::Degree { vertex, found, needed: "exactly 2" })
    }

    /// Makes a face begin at another half-edge if it begins at this one.
    pub(crate) fn begin_face_elsewhere(&mut self, half: HalfKey, instead: HalfKey) {
        if let Some(face) = self.halves[half].face
            && self.faces[face].half == half
        {
            self.faces[face].half = instead;
        }
    }
}

/// The place of a vertex between two corners: one on a side of the mesh if there is any.
fn best(places: [Place; 2]) -> Option<Blend> {
    let [one, other] = places.map(Place::blend);
    match (one, other) {
        (Some(Blend::Along { .. }), _) => one,
        (_, Some(Blend::Along { .. })) => other,
        _ => one.or(other),
    }
}

fn between(a: [f64; 3], b: [f64; 3], at: f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] + (b[axis] - a[axis]) * at)
}

/// How far along the way from one point to another a third one lies; halfway if it lies beside.
fn along(a: [f64; 3], b: [f64; 3], point: [f64; 3]) -> f64 {
    let difference = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|axis| q[axis] - p[axis]);
    let dot = |u: [f64; 3], v: [f64; 3]| (0..3).map(|axis| u[axis] * v[axis]).sum::<f64>();
    let way = difference(a, b);
    let at = dot(way, difference(a, point)) / dot(way, way);
    if at > 0.0 && at < 1.0 { at } else { 0.5 }
}
