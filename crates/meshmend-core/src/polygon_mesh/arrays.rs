//! A mesh from plain arrays, and back.

use crate::{FaceTable, FaceTableError, Layer, PolygonMesh, VertexId};

/// The points and faces of a mesh as plain arrays.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshArrays {
    /// The point of each vertex.
    pub points: Vec<[f64; 3]>,
    /// The vertices at the corners of all faces, face after face.
    pub corners: Vec<u32>,
    /// Where the corners of each face begin, and one more: face `f` has the corners `starts[f] .. starts[f + 1]`.
    pub starts: Vec<u32>,
}

impl PolygonMesh {
    /// A mesh of triangles: a point for each vertex, and three vertices for each face. Points are in single or double
    /// precision; a coordinate may be NaN or infinite.
    ///
    /// ```
    /// use meshmend_core::PolygonMesh;
    ///
    /// let points = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    /// let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [2, 1, 3]])?;
    /// assert_eq!(mesh.triangles(), Some(vec![[0, 1, 2], [2, 1, 3]]));
    ///
    /// let wrong = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [2, 1, 4]]).unwrap_err();
    /// assert_eq!(wrong.to_string(), "corner 2 of face 1 names vertex 4, but there are 4 vertices");
    /// # Ok::<(), meshmend_core::FaceTableError>(())
    /// ```
    ///
    /// # Errors
    /// When a corner names a vertex that has no point; the error says which, counted from 0. When there are more
    /// elements than a mesh holds.
    ///
    /// *Cost*: a copy of both arrays.
    pub fn from_triangles<P: Copy + Into<f64>>(
        points: &[[P; 3]],
        triangles: &[[u32; 3]],
    ) -> Result<Self, FaceTableError> {
        let corners = triangles.as_flattened().iter().copied().map(VertexId).collect();
        Ok(Self::of_fitting(in_doubles(points), FaceTable::triangles(points.len(), corners)?))
    }

    /// A mesh of faces of any size: face `f` has the corners `starts[f] .. starts[f + 1]`. A face may have any number of
    /// corners and repeat a vertex: [checks and repairs](crate::Complex) are there for that.
    ///
    /// ```
    /// use meshmend_core::PolygonMesh;
    ///
    /// // A square and a triangle beside it.
    /// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.5, 0.0]];
    /// let mesh = PolygonMesh::from_polygons(&points, &[0, 1, 2, 3, 1, 4, 2], &[0, 4, 7])?;
    /// assert_eq!(mesh.counts().faces, 2);
    /// let arrays = mesh.to_arrays();
    /// assert_eq!(arrays.starts, [0, 4, 7]);
    ///
    /// let wrong = PolygonMesh::from_polygons(&points, &arrays.corners, &[0, 4, 3, 7]).unwrap_err();
    /// assert_eq!(wrong.to_string(), "face 1 begins at corner 4 and ends before it, at corner 3");
    /// # Ok::<(), meshmend_core::FaceTableError>(())
    /// ```
    ///
    /// # Errors
    /// When a corner names a vertex that has no point, or the starts do not ascend from 0 to the number of corners; the
    /// error says where, counted from 0. When there are more elements than a mesh holds.
    ///
    /// *Cost*: a copy of the three arrays.
    pub fn from_polygons<P: Copy + Into<f64>>(
        points: &[[P; 3]],
        corners: &[u32],
        starts: &[u32],
    ) -> Result<Self, FaceTableError> {
        let corners = corners.iter().copied().map(VertexId).collect();
        Ok(Self::of_fitting(in_doubles(points), FaceTable::polygons(points.len(), starts.to_vec(), corners)?))
    }

    /// The faces as triangles; `None` if a face has more or fewer corners than three.
    ///
    /// *Cost*: a copy of the corners.
    pub fn triangles(&self) -> Option<Vec<[u32; 3]>> {
        let corners =
            self.faces().is_all_triangles().then(|| self.faces().corner_vertices().chunks_exact(3))?;
        Some(corners.map(|corners| [corners[0].0, corners[1].0, corners[2].0]).collect())
    }

    /// The points and faces as plain arrays, of which [`from_polygons`](Self::from_polygons) makes the same ones again.
    /// Loose elements and layers are not part of them.
    ///
    /// *Cost*: a copy of points, corners and starts.
    pub fn to_arrays(&self) -> MeshArrays {
        let faces = self.faces();
        let starts = match faces.starts() {
            Some(starts) => starts.to_vec(),
            None => (0..=faces.face_count() as u32).map(|face| 3 * face).collect(),
        };
        MeshArrays {
            points: self.positions().to_vec(),
            corners: faces.corner_vertices().iter().map(|vertex| vertex.0).collect(),
            starts,
        }
    }

    /// The first layer of a name, whichever elements it gives values to: a layer of vertices moves to the corners when
    /// vertices that differ are welded.
    ///
    /// ```
    /// use meshmend_core::{Carry, Domain, Layer, PolygonMesh, Values};
    ///
    /// let uv = Layer::direct("texcoord", Domain::Corner, 2, Carry::Interpolate, Values::F32(vec![0.5; 6]));
    /// let mesh = PolygonMesh::from_triangles(&[[0.0; 3]; 3], &[[0, 1, 2]])?.with_layers(vec![uv])?;
    /// let uv = mesh.layer_named("texcoord").ok_or("no texture coordinates")?;
    /// let at = |value: usize| [0, 1].map(|place| uv.values().number(2 * value + place));
    /// let of_corners: Vec<_> = uv.corner_values(mesh.faces()).map(|value| value.map(at)).collect();
    /// assert_eq!(of_corners, [Some([Some(0.5), Some(0.5)]); 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn layer_named(&self, name: &str) -> Option<&Layer> {
        self.layers().iter().find(|layer| layer.name() == name)
    }
}

fn in_doubles<P: Copy + Into<f64>>(points: &[[P; 3]]) -> Vec<[f64; 3]> {
    points.iter().map(|point| point.map(Into::into)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, Domain, NO_VALUE, Values};

    const POINTS: [[f64; 3]; 4] =
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [f64::NAN, f64::INFINITY, -0.0]];

    fn polygons(corners: &[u32], starts: &[u32]) -> Result<PolygonMesh, String> {
        PolygonMesh::from_polygons(&POINTS, corners, starts).map_err(|error| error.to_string())
    }

    fn bits(points: &[[f64; 3]]) -> Vec<u64> {
        points.as_flattened().iter().map(|x| x.to_bits()).collect()
    }

    #[test]
    fn numbers_that_are_not_finite_are_data() {
        let mesh = PolygonMesh::from_triangles(&POINTS, &[[0, 1, 3]]).unwrap();
        assert_eq!(bits(mesh.positions()), bits(&POINTS));
        let single = POINTS.map(|point| point.map(|x| x as f32));
        let mesh = PolygonMesh::from_triangles(&single, &[]).unwrap();
        assert_eq!(bits(mesh.positions()), bits(&POINTS));
        assert_eq!(mesh.triangles(), Some(Vec::new()));
    }

    #[test]
    fn a_mesh_without_a_point_has_no_face() {
        let none: [[f64; 3]; 0] = [];
        let mesh = PolygonMesh::from_triangles(&none, &[]).unwrap();
        assert_eq!((mesh.to_arrays().corners, mesh.to_arrays().starts), (vec![], vec![0]));
        let wrong = PolygonMesh::from_triangles(&none, &[[0, 0, 0]]).unwrap_err();
        assert_eq!(wrong.to_string(), "corner 0 of face 0 names vertex 0, but there are 0 vertices");
    }

    #[test]
    fn an_index_that_is_out_of_range_is_named_with_its_face_and_corner() {
        let largest = PolygonMesh::from_triangles(&POINTS, &[[0, 1, 2], [0, u32::MAX, 9]]).unwrap_err();
        assert_eq!(
            largest.to_string(),
            "corner 1 of face 1 names vertex 4294967295, but there are 4 vertices"
        );
        let after_empty = polygons(&[0, 1, 2, 3, 4], &[0, 4, 4, 4, 5]).unwrap_err();
        assert_eq!(after_empty, "corner 0 of face 3 names vertex 4, but there are 4 vertices");
    }

    #[test]
    fn starts_that_do_not_ascend_from_none_to_all_are_named() {
        let wrong = |starts: &[u32]| polygons(&[0, 1, 2], starts).unwrap_err();
        assert_eq!(wrong(&[]), "the starts of the faces are empty; without a face they are [0]");
        assert_eq!(wrong(&[1, 3]), "the first of the starts is 1, not 0");
        assert_eq!(wrong(&[0, 2, 1, 3]), "face 1 begins at corner 2 and ends before it, at corner 1");
        assert_eq!(wrong(&[0, u32::MAX]), "the last of the starts is 4294967295, but there are 3 corners");
        assert_eq!(wrong(&[0]), "the last of the starts is 0, but there are 3 corners");
        assert!(polygons(&[], &[0]).is_ok());
    }

    #[test]
    fn arrays_lead_to_the_same_faces_again() {
        for (corners, starts) in
            [(vec![0, 1, 2, 2, 1, 0], vec![0, 3, 6]), (vec![0, 1, 3, 2, 0], vec![0, 4, 4, 5])]
        {
            let mesh = polygons(&corners, &starts).unwrap();
            let arrays = mesh.to_arrays();
            assert_eq!((&arrays.corners, &arrays.starts), (&corners, &starts));
            let again = PolygonMesh::from_polygons(&arrays.points, &arrays.corners, &arrays.starts).unwrap();
            assert_eq!(again.faces(), mesh.faces());
            assert_eq!(mesh.triangles().is_some(), starts == [0, 3, 6]);
        }
    }

    #[test]
    fn corners_have_the_values_of_their_vertex_or_face() {
        let mesh = polygons(&[0, 1, 2, 2, 1, 3, 0], &[0, 3, 3, 7]).unwrap();
        let layer = |domain, count: u8, uses: Vec<u32>| {
            Layer::indexed("quality", domain, 1, Carry::Copy, Values::U8((0..count).collect()), uses)
        };
        let found = |layer: &Layer| layer.corner_values(mesh.faces()).collect::<Vec<_>>();
        let of_vertices = layer(Domain::Vertex, 2, vec![0, 1, NO_VALUE, 1]);
        let (a, b) = (Some(0), Some(1));
        assert_eq!(found(&of_vertices), [a, b, None, None, b, b, a]);
        assert_eq!(found(&layer(Domain::Face, 3, vec![2, 1, 0])), [Some(2), Some(2), Some(2), a, a, a, a]);
        assert_eq!(found(&layer(Domain::Corner, 7, (0..7).rev().collect())), [6, 5, 4, 3, 2, 1, 0].map(Some));
        assert_eq!(found(&layer(Domain::LooseEdge, 1, vec![0])), [None; 7]);
        let direct = Layer::direct("uv", Domain::Vertex, 2, Carry::Copy, Values::F64(vec![0.0; 8]));
        assert_eq!(found(&direct), [0, 1, 2, 2, 1, 3, 0].map(Some));
    }

    #[test]
    fn a_number_is_told_whatever_its_type_is() {
        let pools =
            [Values::I8(vec![-1]), Values::I16(vec![-1]), Values::I32(vec![-1]), Values::F32(vec![-1.0])];
        assert!(pools.iter().all(|pool| pool.number(0) == Some(-1.0) && pool.number(1).is_none()));
        let pools = [Values::U8(vec![1]), Values::U16(vec![1]), Values::U32(vec![1]), Values::F64(vec![1.0])];
        assert!(pools.iter().all(|pool| pool.number(0) == Some(1.0)));
        assert_eq!(Values::Text(vec![b"1".to_vec()]).number(0), None);
        assert_eq!(
            Values::Lists { starts: vec![0, 1], items: Box::new(Values::U8(vec![1])) }.number(0),
            None
        );
    }
}
