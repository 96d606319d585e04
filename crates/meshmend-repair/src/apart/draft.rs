//! The mesh over new vertices: the same faces, with vertices inserted in some of their sides.

use meshmend_core::{
    Blend, Column, CornerId, Draft, FaceTable, FaceTableBuilder, Id, PolygonMesh, Sources, VertexId,
};

use super::new_vertices::NewVertices;
use super::subdivide::Inserted;
use crate::PassError;

/// The draft of the mesh whose corners are at new vertices.
pub(crate) fn draft(mesh: &PolygonMesh, new: NewVertices, inserted: Inserted) -> Result<Draft, PassError> {
    let NewVertices { of_corner, present, positions, first_part } = new;
    let created = inserted.vertices.len();
    let vertex_count = present.len() + created;
    let vertices = stored_corners(mesh, of_corner, &first_part);
    let faces = if created == 0 {
        NewFaces::over(mesh.faces(), vertices, vertex_count)?
    } else {
        NewFaces::with_inserted(mesh, &vertices, vertex_count, &inserted)?
    };
    let sources = present.iter().map(|&v| Some(v)).chain(std::iter::repeat_n(None, created));
    let face_sources = Sources::same(mesh.faces().face_count());
    Ok(Draft {
        vertex_sources: Sources::listed(sources),
        kept_positions: Some(positions.into()),
        created_vertices: inserted.vertices,
        created_corners: faces.created_corners,
        ..Draft::of_faces(mesh, faces.faces, face_sources, faces.corner_sources)
    })
}

/// Faces, the old corner behind each of their corners, and the corners that were created.
struct NewFaces {
    faces: FaceTable,
    corner_sources: Sources<CornerId>,
    created_corners: Vec<(CornerId, Blend)>,
}

impl NewFaces {
    fn over(old: &FaceTable, vertices: Vec<VertexId>, vertex_count: usize) -> Result<Self, PassError> {
        Ok(NewFaces {
            faces: old.over(vertex_count, vertices)?,
            corner_sources: Sources::same(old.corner_count()),
            created_corners: Vec::new(),
        })
    }

    fn with_inserted(
        mesh: &PolygonMesh,
        vertices: &[VertexId],
        vertex_count: usize,
        inserted: &Inserted,
    ) -> Result<Self, PassError> {
        let (old, complex) = (mesh.faces(), mesh.complex());
        let first = vertex_count - inserted.vertices.len();
        let sides = inserted.sides.iter().map(|(side, place, blend)| {
            (complex.stored_corner(*side), VertexId::new(first + *place as usize), *blend)
        });
        let mut sides = sides.peekable();
        let mut builder = FaceTableBuilder::default();
        let (mut sources, mut created_corners) = (Vec::with_capacity(old.corner_count()), Vec::new());
        for face in old.faces() {
            for corner in old.face_corners(face) {
                builder.push_corner(vertices[corner.index()]);
                sources.push(Some(corner));
                if let Some((_, vertex, blend)) = sides.next_if(|(side, _, _)| *side == corner) {
                    builder.push_corner(vertex);
                    created_corners.push((CornerId::new(sources.len()), blend));
                    sources.push(None);
                }
            }
            builder.end_face();
        }
        let faces = builder.build(vertex_count)?;
        Ok(NewFaces { faces, corner_sources: Sources::listed(sources), created_corners })
    }
}

/// The new vertex at each corner as stored. A corner that the complex leaves out goes with the corner before it in its
/// face if that is at the same vertex, else with the vertex's first part.
fn stored_corners(
    mesh: &PolygonMesh,
    of_corner: Column<CornerId, VertexId>,
    first_part: &[VertexId],
) -> Vec<VertexId> {
    let (old, complex) = (mesh.faces(), mesh.complex());
    if complex.is_as_stored() {
        return of_corner.into_vec();
    }
    let mut new: Vec<Option<VertexId>> = vec![None; old.corner_count()];
    for (corner, &vertex) in of_corner.iter() {
        new[complex.stored_corner(corner).index()] = Some(vertex);
    }
    let mut last: Option<(VertexId, VertexId)> = None;
    let mut found = Vec::with_capacity(new.len());
    for corner in old.corners() {
        let present = old.corner_vertex(corner);
        let beside = last.filter(|(v, _)| *v == present).map(|(_, part)| part);
        let vertex = new[corner.index()].or(beside).unwrap_or(first_part[present.index()]);
        last = Some((present, vertex));
        found.push(vertex);
    }
    found
}
