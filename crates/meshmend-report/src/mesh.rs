//! A mesh in the page's data.

use meshmend::mesh::Id;
use meshmend::{CheckReport, FaceId, PolygonMesh, VertexId};
use serde::Serialize;

use crate::packed::Packed;

/// A mesh: positions as single precision about a point near them, and faces with the ids that reports name.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct MeshData {
    /// The point that all positions are relative to.
    origin: [f64; 3],
    /// How many vertices and faces the mesh has.
    vertices: usize,
    faces: usize,
    positions: Packed,
    /// Where each face begins among the corners, and where the last one ends; absent where all are triangles.
    #[serde(skip_serializing_if = "Option::is_none")]
    offsets: Option<Packed>,
    corners: Packed,
    /// The vertices and faces that are there, where not all are.
    #[serde(skip_serializing_if = "Option::is_none")]
    vertex_ids: Option<Packed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    face_ids: Option<Packed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    loose_edges: Option<Packed>,
}

impl MeshData {
    /// The mesh of a report, with the vertices that are stored: of those that are one in its view, faces name the lowest.
    ///
    /// *Cost*: linear.
    pub(crate) fn whole(stored: &PolygonMesh, report: &CheckReport, origin: [f64; 3]) -> Self {
        let faces = report.mesh.faces();
        let name = |vertex: VertexId| report.stored_vertex(vertex).0;
        let offsets = faces.faces().map(|face| faces.corner_range(face).end as u32);
        let loose = report.mesh.loose_edges();
        MeshData {
            origin,
            vertices: stored.counts().vertices,
            faces: faces.face_count(),
            positions: positions(stored.positions().iter(), origin),
            offsets: (!faces.is_all_triangles()).then(|| std::iter::once(0).chain(offsets).collect()),
            corners: faces.corner_vertices().iter().map(|&vertex| name(vertex)).collect(),
            vertex_ids: None,
            face_ids: None,
            loose_edges: (!loose.is_empty()).then(|| loose.iter().flatten().map(|&end| name(end)).collect()),
        }
    }

    /// Some faces of the mesh of a report, ascending, with their vertices.
    ///
    /// *Cost*: linear in the faces that are kept, and in the vertices.
    pub(crate) fn part(
        stored: &PolygonMesh,
        report: &CheckReport,
        kept: &[FaceId],
        origin: [f64; 3],
    ) -> Self {
        let faces = report.mesh.faces();
        let name = |vertex: VertexId| report.stored_vertex(vertex);
        let corners = |face: FaceId| faces.face_vertices(face).iter().map(|&vertex| name(vertex));
        let mut vertices: Vec<VertexId> = kept.iter().flat_map(|&face| corners(face)).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |vertex: VertexId| vertices.binary_search(&vertex).unwrap_or_default() as u32;
        let ends = kept.iter().scan(0, |end, &face| {
            *end += faces.corner_range(face).len() as u32;
            Some(*end)
        });
        MeshData {
            origin,
            vertices: stored.counts().vertices,
            faces: faces.face_count(),
            positions: positions(vertices.iter().map(|v| &stored.positions()[v.index()]), origin),
            offsets: Some(std::iter::once(0).chain(ends).collect()),
            corners: kept.iter().flat_map(|&face| corners(face)).map(place).collect(),
            vertex_ids: Some(vertices.iter().map(|vertex| vertex.0).collect()),
            face_ids: Some(kept.iter().map(|face| face.0).collect()),
            loose_edges: None,
        }
    }

    /// Triangles that show the shape of a mesh. They are not its faces.
    pub(crate) fn shape(points: &[[f64; 3]], triangles: Vec<[u32; 3]>, origin: [f64; 3]) -> Self {
        MeshData {
            origin,
            vertices: points.len(),
            faces: triangles.len(),
            positions: positions(points.iter(), origin),
            offsets: None,
            corners: triangles.into_iter().flatten().collect(),
            vertex_ids: None,
            face_ids: None,
            loose_edges: None,
        }
    }
}

fn positions<'a>(points: impl Iterator<Item = &'a [f64; 3]>, origin: [f64; 3]) -> Packed {
    let about =
        |point: &[f64; 3]| -> [f32; 3] { std::array::from_fn(|axis| (point[axis] - origin[axis]) as f32) };
    Packed::Floats(points.flat_map(about).collect())
}

/// The middle of the bounding box of what is finite.
pub(crate) fn middle(points: &[[f64; 3]]) -> [f64; 3] {
    let [low, high] = bounds(points);
    let middle = std::array::from_fn(|axis| low[axis] * 0.5 + high[axis] * 0.5);
    if middle.iter().all(|x: &f64| x.is_finite()) { middle } else { [0.0; 3] }
}

/// The bounding box of what is finite.
pub(crate) fn bounds(points: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let finite = points.iter().filter(|point| point.iter().all(|x| x.is_finite()));
    finite.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], point| {
        [
            std::array::from_fn(|axis| low[axis].min(point[axis])),
            std::array::from_fn(|axis| high[axis].max(point[axis])),
        ]
    })
}
