//! A vertex within a face, and without it.
//!
//! ```text
//!        ┌───────┐                 ┌───────┐
//!        │       │      poke →     │ ╲   ╱ │
//!        │   f   │                 │   c   │
//!        │       │  ← remove_vertex│ ╱   ╲ │
//!        └───────┘                 └───────┘
//! ```

use crate::place::Place;
use crate::refusal::unless;
use crate::{Done, Edit, EditRefusal, Editor, FaceKey, HalfKey, Key, Refused, VertexKey};

impl Editor {
    /// Whether a vertex can be put into a face.
    ///
    /// # Errors
    /// `stale`; `full`.
    pub fn can_poke(&self, face: FaceKey) -> Result<(), Refused> {
        self.fresh([face.into()])?;
        unless(self.full(2 * self.round(self.faces[face].half).count()).into_iter().collect())
    }

    /// Puts a vertex into a face and joins it to all of its corners. [`Editor::remove_vertex`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_poke`].
    ///
    /// *Cost*: linear in the sides of the face.
    pub fn poke(&mut self, face: FaceKey, point: [f64; 3]) -> Result<Done, Refused> {
        self.can_poke(face)?;
        let rim: Vec<HalfKey> = self.round(self.faces[face].half).collect();
        let source = self.faces[face].source;
        let place = Place::within(source);
        let vertex = self.add_vertex(point, None, place.blend());
        let spokes: Vec<[HalfKey; 2]> =
            rim.iter().map(|&half| self.add_edge(vertex, self.halves[half].origin)).collect();
        let mut faces = Vec::with_capacity(rim.len() - 1);
        for (at, &half) in rim.iter().enumerate() {
            let following = (at + 1) % rim.len();
            let (inward, outward) = (spokes[following][1], spokes[at][0]);
            self.halves[inward].place = self.halves[rim[following]].place;
            self.halves[outward].place = place;
            self.link(half, inward);
            self.link(inward, outward);
            self.link(outward, half);
            if at == 0 {
                self.set_face(half, Some(face));
            } else {
                faces.push(self.add_face(half, source));
            }
        }
        self.vertices[vertex].half = spokes.first().map(|spoke| spoke[0]);
        let edges = spokes.iter().map(|spoke| self.halves[spoke[0]].edge).collect();
        Ok(Done { vertices: vec![vertex], edges, faces, ..Done::undone_by(Edit::RemoveVertex { vertex }) })
    }

    /// Whether a vertex can be removed with its edges, so that the triangles round it become one face.
    ///
    /// # Errors
    /// `stale`; `boundary`; `degree` if it has fewer than three edges; `not-a-triangle` for each face of more sides round it,
    /// since [`Editor::poke`] makes triangles alone. Triangles round a vertex share no more than that and their edges.
    pub fn can_remove_vertex(&self, vertex: VertexKey) -> Result<(), Refused> {
        self.fresh([vertex.into()])?;
        let halves: Vec<HalfKey> = self.star_of(vertex).collect();
        let mut reasons = Vec::new();
        if self.is_on_boundary(vertex) {
            reasons.push(EditRefusal::Boundary(Key::Vertex(vertex)));
        }
        if halves.len() < 3 {
            reasons.push(EditRefusal::Degree { vertex, found: halves.len(), needed: "at least 3" });
        }
        let larger = halves.iter().filter(|&&half| self.triangle(half).is_none());
        reasons.extend(larger.filter_map(|&half| self.halves[half].face).map(EditRefusal::NotATriangle));
        unless(reasons)
    }

    /// Removes a vertex with its edges, so that the triangles round it become one face. [`Editor::poke`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_remove_vertex`].
    ///
    /// *Cost*: linear in the edges of the vertex.
    pub fn remove_vertex(&mut self, vertex: VertexKey) -> Result<Done, Refused> {
        self.can_remove_vertex(vertex)?;
        let spokes: Vec<HalfKey> = self.star_of(vertex).collect();
        let rim: Vec<HalfKey> = spokes.iter().map(|&spoke| self.halves[spoke].next).collect();
        let faces: Vec<FaceKey> = rim.iter().filter_map(|&half| self.halves[half].face).collect();
        let (kept, point) = (faces[0], self.vertices[vertex].position);
        for (at, &half) in rim.iter().enumerate() {
            self.link(half, rim[(at + 1) % rim.len()]);
            let origin = self.halves[half].origin;
            self.vertices[origin].half = Some(half);
        }
        let source = faces.iter().find_map(|&face| self.faces[face].source);
        self.set_face(rim[0], Some(kept));
        (self.faces[kept].half, self.faces[kept].source) = (rim[0], self.faces[kept].source.or(source));
        faces[1..].iter().for_each(|&face| _ = self.faces.remove(face));
        spokes.iter().for_each(|&spoke| self.remove_edge(spoke));
        self.vertices.remove(vertex);
        Ok(Done::undone_by(Edit::Poke { face: kept, point }))
    }
}
