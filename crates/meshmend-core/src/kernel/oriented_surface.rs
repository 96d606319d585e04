//! Is a table of triangles an oriented surface, told without its edges?
//!
//! Most meshes are one, and then a repair has nothing to do. A table of edges takes 42 bytes a triangle and most of the time of a
//! repair; the corners of each vertex, in which the answer lies too, take 14, and whoever builds the edges afterwards uses them.
//!
//! In an oriented surface no two sides run from one vertex to the same other one. So at a vertex each corner leads to at most one
//! next one: that whose side comes in where its own goes out. The corners are one umbrella when these steps pass through all.

use crate::edges::vertex_corners::VertexCorners;
use crate::{Complex, FaceTable, Id, VertexId, threads};

/// Vertices that a thread looks at together.
const CHUNK: usize = 1 << 12;

impl Complex {
    /// Whether all faces are triangles that make a consistently oriented surface, closed or open, each of whose vertices is disc or
    /// half-disc, with no face that repeats another one either way; and every vertex is in a face. A mesh without faces is none.
    ///
    /// ```
    /// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
    /// let is_surface = |corners: &[u32]| {
    ///     let faces = FaceTable::triangles(4, corners.iter().copied().map(VertexId).collect())?;
    ///     Ok::<bool, Box<dyn std::error::Error>>(PolygonMesh::new(vec![[0.0; 3]; 4], faces)?.complex().is_oriented_surface())
    /// };
    /// assert!(is_surface(&[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])?);
    /// assert!(!is_surface(&[0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 2, 3])?, "a face is the wrong way round");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// *Cost*: O(Σ d log d) over the vertices' degrees d, and up to the first vertex that is none; 14 bytes a triangle. Where the
    /// answer is no they are kept: there is more to ask.
    pub fn is_oriented_surface(&self) -> bool {
        let faces = self.faces();
        if !self.is_as_stored() || !faces.is_all_triangles() || faces.face_count() == 0 {
            return false;
        }
        let corners = self.vertex_corners_for_now();
        let vertices = faces.vertex_count();
        let are_surface = |chunk: usize| {
            let mut star = Fan::default();
            let mut chunk = chunk * CHUNK..vertices.min((chunk + 1) * CHUNK);
            chunk.all(|vertex| star.is_umbrella(faces, &corners, VertexId::new(vertex)))
        };
        let mut chunks = 0..vertices.div_ceil(CHUNK);
        let is_surface =
            if chunks.len() <= 1 { chunks.all(are_surface) } else { threads::all(chunks, are_surface) };
        if !is_surface {
            self.keep_vertex_corners(corners);
        }
        is_surface
    }
}

/// Stars of more corners are sorted, not compared each with each.
const FEW: usize = 12;

/// The corners at a vertex; reused from vertex to vertex.
#[derive(Default)]
struct Fan {
    /// For each corner the vertex to which its side goes, and the one from which the side before it comes.
    out: Vec<VertexId>,
    into: Vec<VertexId>,
    /// The same, sorted, the latter with their corners: where there are many.
    by_out: Vec<VertexId>,
    by_into: Vec<(VertexId, u32)>,
}

impl Fan {
    /// Whether the corners at a vertex are one umbrella of consistent triangles.
    #[inline]
    fn is_umbrella(&mut self, faces: &FaceTable, corners: &VertexCorners, vertex: VertexId) -> bool {
        let of_vertex = corners.of(vertex);
        self.out.clear();
        self.into.clear();
        for corner in of_vertex {
            let (face, place) = (corner.index() / 3, corner.index() % 3);
            let triangle = &faces.corner_vertices()[3 * face..3 * face + 3];
            self.out.push(triangle[(place + 1) % 3]);
            self.into.push(triangle[(place + 2) % 3]);
        }
        if of_vertex.len() <= FEW {
            let into = |vertex| self.into.iter().position(|&into| into == vertex);
            return self.is_passed_through(into, |vertex| self.out.contains(&vertex));
        }
        self.by_out.clone_from(&self.out);
        self.by_out.sort_unstable();
        self.by_into.clear();
        self.by_into.extend(self.into.iter().copied().zip(0..));
        self.by_into.sort_unstable();
        let into = |vertex| {
            let at = self.by_into.partition_point(|&(into, _)| into < vertex);
            let (into, place) = self.by_into.get(at)?;
            (*into == vertex).then_some(*place as usize)
        };
        self.is_passed_through(into, |vertex| self.by_out.binary_search(&vertex).is_ok())
    }

    /// Whether steps from corner to corner pass through all, by the first corner that comes from a vertex, and by whether one goes
    /// to a vertex.
    ///
    /// An open fan is begun where no step leads to. Of two corners that come from one vertex the second is never stepped to; where
    /// two go to one vertex, the walk comes to a corner again, and goes on without an end.
    #[inline]
    fn is_passed_through(
        &self,
        into: impl Fn(VertexId) -> Option<usize>,
        goes_out_to: impl Fn(VertexId) -> bool,
    ) -> bool {
        let count = self.out.len();
        let first = (0..count).find(|&corner| !goes_out_to(self.into[corner]));
        let start = first.unwrap_or(0);
        let mut at = start;
        for passed in 1..=count {
            match into(self.out[at]) {
                None => return first.is_some() && passed == count,
                // Two corners that close round a vertex are a face and its reverse.
                Some(next) if next == start => return passed == count && count > 2,
                Some(next) => at = next,
            }
        }
        false
    }
}
