//! The one place that makes the mesh that a draft describes.

use std::sync::Arc;

use super::anchors;
use crate::polygon_mesh::points::Points;
use crate::{Counts, Draft, DraftError, Id, PolygonMesh, Provenance, VertexId};

impl PolygonMesh {
    /// Makes the mesh that a draft describes, with every attribute and loose element carried along.
    ///
    /// A vertex layer whose values differ across vertices that become one moves to the corners, and returns to
    /// the vertices as soon as no vertex has corners that differ.
    ///
    /// # Errors
    /// When the draft does not fit this mesh; that is a mistake of the pass that made it.
    ///
    /// *Cost*: linear in the new elements and the layers.
    pub fn rebuild(&self, mut draft: Draft) -> Result<(PolygonMesh, Provenance), DraftError> {
        check_counts(&draft)?;
        let positions = self.draft_positions(&mut draft);
        let (edges, points) = self.draft_loose(&draft)?;
        let layers = self.carried_layers(&draft);
        let metadata = anchors::carried(self.metadata(), &draft);
        let kept = draft.vertex_sources.len() - draft.created_vertices.len();
        let places = draft.created_vertices.iter().enumerate();
        let provenance = Provenance {
            before: Counts { ..self.counts() },
            vertices: draft.vertex_sources,
            faces: draft.face_sources,
            corners: draft.corner_sources,
            flipped: draft.flipped,
            created: places.map(|(i, v)| (VertexId::new(kept + i), v.place)).collect(),
        };
        let mesh =
            PolygonMesh::of_points(positions, draft.faces)?.with_loose(edges, points)?.with_layers(layers)?;
        Ok((mesh.with_metadata(metadata), provenance))
    }

    fn draft_positions(&self, draft: &mut Draft) -> Points {
        let mut positions = match draft.kept_positions.take() {
            Some(kept) if draft.created_vertices.is_empty() => return kept.into(),
            Some(kept) => Arc::unwrap_or_clone(kept),
            None if draft.vertex_sources.is_same() => self.positions()[..draft.vertex_sources.len()].to_vec(),
            None => draft.vertex_sources.iter().filter_map(|(_, old)| Some(self.position(old?))).collect(),
        };
        positions.extend(draft.created_vertices.iter().map(|v| v.position));
        positions.into()
    }

    fn draft_loose(&self, draft: &Draft) -> Result<(Vec<[VertexId; 2]>, Vec<VertexId>), DraftError> {
        let edges = if draft.drop_loose.edges { &[] } else { self.loose_edges() };
        let points = if draft.drop_loose.points { &[] } else { self.loose_points() };
        if edges.is_empty() && points.is_empty() {
            return Ok((Vec::new(), Vec::new()));
        }
        let mut target: Vec<Option<VertexId>> = vec![None; self.counts().vertices];
        for (new, old) in draft.vertex_sources.iter() {
            if let Some(slot) = old.map(|o| &mut target[o.index()]) {
                slot.get_or_insert(new);
            }
        }
        let moved = |v: VertexId| match &draft.merged_into {
            Some(merged) => merged.get(v.index()).copied().ok_or(DraftError::LooseVertex(v)),
            None => target[v.index()].ok_or(DraftError::LooseVertex(v)),
        };
        let edges =
            edges.iter().map(|&[a, b]| Ok([moved(a)?, moved(b)?])).collect::<Result<_, DraftError>>()?;
        let points = points.iter().map(|&v| moved(v)).collect::<Result<_, DraftError>>()?;
        Ok((edges, points))
    }
}

fn check_counts(draft: &Draft) -> Result<(), DraftError> {
    let faces = &draft.faces;
    let created = draft.vertex_sources.iter().filter(|(_, old)| old.is_none()).count();
    let kept = draft.vertex_sources.len() - created;
    let needed = [
        ("face source", draft.face_sources.len(), faces.face_count()),
        ("corner source", draft.corner_sources.len(), faces.corner_count()),
        ("vertex source", draft.vertex_sources.len(), faces.vertex_count()),
        ("created vertex", draft.created_vertices.len(), created),
        ("kept position", draft.kept_positions.as_ref().map_or(kept, |kept| kept.len()), kept),
    ];
    match needed.into_iter().find(|(_, found, expected)| found != expected) {
        Some((what, found, expected)) => Err(DraftError::Count { what, found, expected }),
        None => Ok(()),
    }
}
