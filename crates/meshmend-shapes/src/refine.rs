//! The two changes that leave the topology of a shape as it is.

use meshmend_core::{Id, VertexId};

use crate::error::ShapeError;
use crate::mesh_builder::{MeshBuilder, has_room};
use crate::shape::Shape;
use crate::truth::Truth;

impl Shape {
    /// The same surface or complex with each edge halved and each face of n corners cut into n quads that meet in a
    /// new vertex inside it: V' = V + E + F, E' = 2E + Σn and F' = Σn.
    ///
    /// Its faces must be simple, as those of every shape but [`out_and_back`](crate::out_and_back) are. Where a
    /// surface passes through itself new vertices may coincide.
    ///
    /// # Errors
    /// When that is too large.
    ///
    /// *Cost*: linear.
    pub fn refined(&self) -> Result<Shape, ShapeError> {
        let (faces, edges) = (self.mesh.complex().faces(), self.mesh.complex().edges());
        let mut builder = MeshBuilder::with_room(&[faces.corner_count(), 4])?;
        let place = |v: &VertexId| self.mesh.position(*v);
        let middles = edges.all_ends().iter().map(|ends| mean(ends.iter().map(place)));
        let centres = faces.faces().map(|face| mean(faces.face_vertices(face).iter().map(place)));
        builder.points(self.mesh.positions().iter().copied().chain(middles).chain(centres));
        let (vertex_count, edge_count) = (faces.vertex_count(), edges.edge_count());
        let middle = |corner| (vertex_count + edges.corner_edge(corner).index()) as u32;
        for face in faces.faces() {
            let centre = (vertex_count + edge_count + face.index()) as u32;
            let mut before = faces.face_corners(face).next_back();
            for corner in faces.face_corners(face) {
                let last = before.replace(corner).unwrap_or(corner);
                builder.face(&[faces.corner_vertex(corner).0, middle(corner), centre, middle(last)]);
            }
        }
        let Truth { vertices, edges, faces: face_count, .. } = self.truth;
        let corners = faces.corner_count();
        let counts = [vertices + edges + face_count, 2 * edges + corners, corners];
        builder.shape(format!("{}, refined", self.name), self.truth.with_counts(counts))
    }

    /// The same [refined](Shape::refined) so many times. What would be too large is refused before any of it is made.
    ///
    /// # Errors
    /// When that is too large.
    ///
    /// *Cost*: linear in what it makes.
    pub fn refined_times(&self, times: usize) -> Result<Shape, ShapeError> {
        let corners = self.mesh.complex().faces().corner_count();
        // Each corner becomes a face of four.
        let factor = u32::try_from(times).map_or(usize::MAX, |times| 4_usize.saturating_pow(times));
        has_room(corners.saturating_mul(factor))?;
        let mut shape = self.clone();
        for _ in 0..times {
            shape = shape.refined()?;
        }
        Ok(shape)
    }

    /// The same with each face of n > 3 corners cut into n − 2 triangles from its first corner, by n − 3 new edges.
    ///
    /// Those edges are new for every shape but [`out_and_back`](crate::out_and_back), whose faces touch themselves.
    ///
    /// # Errors
    /// When the mesh can't be made, which does not happen to a mesh of this crate.
    ///
    /// *Cost*: linear.
    pub fn triangulated(&self) -> Result<Shape, ShapeError> {
        let faces = self.mesh.faces();
        let mut builder =
            MeshBuilder::with_room(&[faces.corner_count().saturating_sub(2 * faces.face_count()), 3])?;
        builder.points(self.mesh.positions().iter().copied());
        for face in faces.faces() {
            if let [first, rest @ ..] = faces.face_vertices(face) {
                rest.windows(2).for_each(|pair| builder.face(&[first.0, pair[0].0, pair[1].0]));
            }
        }
        let Truth { vertices, edges, faces: face_count, .. } = self.truth;
        let diagonals = faces.corner_count() - 3 * face_count;
        let counts = [vertices, edges + diagonals, face_count + diagonals];
        let name = if diagonals > 0 { format!("{} in triangles", self.name) } else { self.name.clone() };
        builder.shape(name, self.truth.with_counts(counts))
    }
}

impl Truth {
    fn with_counts(&self, [vertices, edges, faces]: [usize; 3]) -> Truth {
        Truth { vertices, edges, faces, ..self.clone() }
    }
}

fn mean(points: impl ExactSizeIterator<Item = [f64; 3]>) -> [f64; 3] {
    let count = points.len() as f64;
    let sum = points.fold([0.0; 3], |sum, point| [0, 1, 2].map(|axis| sum[axis] + point[axis]));
    sum.map(|x| x / count)
}
