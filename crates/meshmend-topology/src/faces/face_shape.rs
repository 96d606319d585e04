//! Which faces touch themselves, and which list a corner for nothing?
//!
//! A face of the complex is *non-simple* when it is at one of its vertices twice or more (Bærentzen's multiple
//! incidence, §2). It stays in the complex, as a disc whose rim spells its boundary word. A face has *repeated
//! corners* when its stored form lists a vertex twice in a row, or its normal form walks to a vertex and straight
//! back (a b a c).

use meshmend_core::{Connectivity, FaceId, PolygonMesh, VertexId};

/// The faces of a complex that come back to a vertex, each with the first vertex that recurs.
///
/// *Cost*: linear for small faces, n log n for one of n corners.
pub fn non_simple_faces<K: Connectivity>(kernel: &K) -> Vec<(FaceId, VertexId)> {
    let (mut shapes, mut vertices) = (FaceShapes::default(), Vec::new());
    let mut recurring = |face: FaceId| {
        // In normal form a triangle has three different vertices.
        kernel.face_corners(face).nth(3)?;
        vertices.clear();
        vertices.extend(kernel.face_vertices(face));
        shapes.recurring(&vertices)
    };
    kernel.faces().filter_map(|face| Some((face, recurring(face)?))).collect()
}

/// The faces of a mesh's complex that list a vertex twice in a row as stored, or walk to a vertex and straight
/// back; each with the first vertex that does so, repeats in a row coming before spikes.
///
/// *Cost*: linear in the corners.
pub fn faces_with_repeated_corners(mesh: &PolygonMesh) -> Vec<(FaceId, VertexId)> {
    let (stored, normal) = (mesh.faces(), mesh.complex().faces());
    if normal.is_all_triangles() && mesh.complex().is_as_stored() {
        return Vec::new();
    }
    let repeated =
        |face: FaceId| FaceShapes::repeated(stored.face_vertices(face), normal.face_vertices(face));
    stored.faces().filter_map(|face| Some((face, repeated(face)?))).collect()
}

/// Looks at the shape of one face after another.
#[derive(Debug, Default)]
pub struct FaceShapes {
    places: Vec<(VertexId, u32)>,
}

impl FaceShapes {
    /// The first vertex of a face in normal form that recurs, if it is not simple.
    ///
    /// *Cost*: linear for small faces, n log n for one of n corners.
    pub fn recurring(&mut self, normal: &[VertexId]) -> Option<VertexId> {
        if normal.len() <= 16 {
            let mut places = 1..normal.len();
            return places.find(|&i| normal[..i].contains(&normal[i])).map(|i| normal[i]);
        }
        self.places.clear();
        self.places.extend(normal.iter().copied().zip(0..));
        self.places.sort_unstable();
        let recurring = self.places.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        recurring.min_by_key(|pair| pair[1].1).map(|pair| pair[0].0)
    }

    /// The first vertex that a face lists twice in a row as stored, or else from which it walks to another and straight back in
    /// normal form. A degenerate face, whose normal form is empty here, has none.
    ///
    /// *Cost*: linear in the corners.
    pub fn repeated(stored: &[VertexId], normal: &[VertexId]) -> Option<VertexId> {
        let in_a_row = (!normal.is_empty() && normal.len() < stored.len()).then(|| {
            (0..stored.len()).find(|&i| stored[i] == stored[(i + 1) % stored.len()]).map(|i| stored[i])
        });
        // Three different vertices have none.
        let spike = || {
            let n = normal.len();
            (0..n).find(|&i| normal[i] == normal[(i + 2) % n]).map(|i| normal[i])
        };
        in_a_row.flatten().or_else(spike)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{kernel, mesh};

    #[test]
    fn the_first_vertex_that_recurs_is_named() {
        let long: Vec<u32> = (0..20).chain([7, 3]).collect();
        let found = non_simple_faces(&kernel(20, &[&[0, 1, 2], &[5, 1, 2, 1, 5, 3], &[0, 1, 2, 3], &long]));
        assert_eq!(found, [(FaceId(1), VertexId(1)), (FaceId(3), VertexId(7))]);
    }

    #[test]
    fn repeats_and_spikes_are_found_round_the_end_too() {
        let faces: &[&[u32]] =
            &[&[0, 1, 2], &[0, 1, 2, 0], &[0, 3, 1, 3], &[1, 1, 1], &[3, 1, 3, 0], &[2, 2, 0, 1, 0]];
        assert_eq!(repeated(faces), [(1, 0), (2, 3), (4, 3), (5, 2)]);
    }

    fn repeated(faces: &[&[u32]]) -> Vec<(u32, u32)> {
        let found = faces_with_repeated_corners(&mesh(4, faces));
        found.iter().map(|(face, vertex)| (face.0, vertex.0)).collect()
    }

    #[test]
    fn repeats_are_found_where_all_is_triangles_but_for_them_and_spikes_where_nothing_is_dropped() {
        assert_eq!(repeated(&[&[0, 1, 2], &[0, 1, 1, 2]]), [(1, 1)]);
        assert_eq!(repeated(&[&[0, 1, 2], &[0, 3, 1, 3]]), [(1, 3)]);
    }
}
