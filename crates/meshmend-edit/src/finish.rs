//! The mesh that comes of the edits, with everything carried along.

use meshmend_core::{
    Blend, CornerId, Draft, DraftError, FaceId, FaceTable, FaceTableBuilder, FaceTableError, Id, PolygonMesh,
    Provenance, Sources, VertexDraft, VertexId,
};
use slotmap::SecondaryMap;

use crate::place::Place;
use crate::records::{Face, Vertex};
use crate::{Editor, FaceKey, HalfKey, VertexKey};

impl Editor {
    /// Ends the editing: the mesh, and where each of its elements came from.
    ///
    /// Vertices and faces that were kept come first, in the order of the mesh, and then the created ones in the order in which
    /// they were made. A face begins at its lowest kept corner, or else at the half-edge with which it was made. A corner is
    /// kept where its vertex and its face are; any other one takes the attributes of the corner that it comes from. A vertex
    /// that loose elements or degenerate faces use stays for them, in no face. If nothing was changed the mesh is the very
    /// one that was given.
    ///
    /// # Errors
    /// When there are more corners than a mesh holds.
    ///
    /// *Cost*: O(n log n).
    pub fn finish(self) -> Result<(PolygonMesh, Provenance), DraftError> {
        let vertices = self.ordered_vertices();
        let faces = self.ordered_faces(&vertices)?;
        let counts = self.mesh.counts();
        let positions = vertices.kept.iter().map(|&(source, key)| match key {
            Some(key) => self.vertices[key].position,
            None => self.mesh.position(source),
        });
        let positions: Vec<[f64; 3]> = positions.collect();
        let is_moved = |(&(source, _), position): (&(VertexId, _), &[f64; 3])| {
            self.mesh.position(source).map(f64::to_bits) != position.map(f64::to_bits)
        };
        let has_moved = vertices.kept.iter().zip(&positions).any(is_moved);
        let created = vertices.created.iter().map(|&key| {
            let Vertex { position, place, .. } = self.vertices[key];
            VertexDraft { position, place }
        });
        let created: Vec<VertexDraft> = created.collect();
        let sources = vertices.kept.iter().map(|&(source, _)| Some(source));
        let vertex_sources = Sources::listed(sources.chain(created.iter().map(|_| None)));
        let is_same = vertex_sources.is_all_of(counts.vertices)
            && faces.sources.is_all_of(counts.faces)
            && faces.corner_sources.is_all_of(counts.corners);
        if is_same && !has_moved {
            return Ok((self.mesh, Provenance::same(counts)));
        }
        self.mesh.rebuild(Draft {
            vertex_sources,
            kept_positions: has_moved.then(|| positions.into()),
            created_vertices: created,
            created_corners: faces.created_corners,
            ..Draft::of_faces(&self.mesh, faces.table, faces.sources, faces.corner_sources)
        })
    }

    /// The vertices of the result, in order.
    fn ordered_vertices(&self) -> Vertices {
        let mut kept: Vec<(VertexId, u64, Option<VertexKey>)> = Vec::with_capacity(self.vertices.len());
        let mut created: Vec<(u64, VertexKey)> = Vec::new();
        for (key, vertex) in &self.vertices {
            match vertex.source {
                Some(source) => kept.push((source, vertex.made, Some(key))),
                None => created.push((vertex.made, key)),
            }
        }
        kept.sort_unstable();
        kept.extend(self.vertices_left_for_others(&kept));
        kept.sort_unstable();
        created.sort_unstable();
        let created: Vec<VertexKey> = created.into_iter().map(|(_, key)| key).collect();
        let mut new = SecondaryMap::with_capacity(self.vertices.len());
        let keys = kept.iter().map(|&(_, _, key)| key).chain(created.iter().map(|&key| Some(key)));
        for (at, key) in keys.enumerate() {
            if let Some(key) = key {
                new.insert(key, VertexId::new(at));
            }
        }
        Vertices { kept: kept.into_iter().map(|(source, _, key)| (source, key)).collect(), created, new }
    }

    /// The vertices of the mesh that are gone and that loose elements or degenerate faces use.
    fn vertices_left_for_others(
        &self,
        kept: &[(VertexId, u64, Option<VertexKey>)],
    ) -> Vec<(VertexId, u64, Option<VertexKey>)> {
        let degenerate = self.mesh.complex().degenerate_faces().iter();
        let used = self.mesh.loose_edges().iter().flatten().chain(self.mesh.loose_points());
        let used = used.chain(degenerate.flat_map(|&face| self.mesh.faces().face_vertices(face)));
        let mut left: Vec<VertexId> = used.copied().collect();
        left.sort_unstable();
        left.dedup();
        let is_gone = |vertex: &VertexId| kept.binary_search_by_key(vertex, |&(source, ..)| source).is_err();
        left.into_iter().filter(is_gone).map(|vertex| (vertex, 0, None)).collect()
    }

    /// The faces of the result, in order.
    fn ordered_faces(&self, vertices: &Vertices) -> Result<Faces, FaceTableError> {
        let degenerate = self.mesh.complex().degenerate_faces().iter();
        let mut order: Vec<(Option<FaceId>, u64, Option<FaceKey>)> =
            degenerate.map(|&face| (Some(face), 0, None)).collect();
        order.extend(self.faces.iter().map(|(key, face)| (face.source, face.made, Some(key))));
        order.sort_unstable_by_key(|&(source, made, _)| (source.is_none(), source, made));
        let mut list = FaceList::default();
        for &(source, _, key) in &order {
            match (source, key) {
                (Some(face), Some(key)) if self.is_as_stored(key) => {
                    self.push_with_repeats(&mut list, face, key, vertices);
                }
                (_, Some(key)) => self.push_face(&mut list, key, vertices),
                (Some(face), None) => self.push_degenerate(&mut list, face, vertices),
                (None, None) => {}
            }
        }
        Ok(Faces {
            table: list.builder.build(vertices.kept.len() + vertices.created.len())?,
            sources: Sources::listed(order.into_iter().map(|(source, ..)| source)),
            corner_sources: Sources::listed(list.corner_sources),
            created_corners: list.created_corners,
        })
    }

    /// Whether a face has just the corners of its source. That may have more, which repeat the vertex before.
    fn is_as_stored(&self, key: FaceKey) -> bool {
        let complex = self.mesh.complex();
        let Face { half, source: Some(source), .. } = self.faces[key] else { return false };
        if complex.is_as_stored() {
            return false;
        }
        let mut halves = self.round(half);
        let is_same = complex.faces().face_corners(source).all(|corner| {
            let kept = halves.next().and_then(|half| self.kept_corner(half, source));
            kept == Some(complex.stored_corner(corner))
        });
        is_same && halves.next().is_none()
    }

    /// The corner of a face of the mesh that a half-edge is, whose vertex then is that corner's too.
    fn kept_corner(&self, half: HalfKey, face: FaceId) -> Option<CornerId> {
        let record = &self.halves[half];
        let Place::Corner(corner) = record.place else { return None };
        let vertex = self.mesh.faces().corner_vertex(corner);
        let is_kept = self.mesh.faces().corner_range(face).contains(&corner.index())
            && self.vertices[record.origin].source == Some(vertex);
        is_kept.then_some(corner)
    }

    /// Adds a face that takes no part as it is stored.
    fn push_degenerate(&self, list: &mut FaceList, face: FaceId, vertices: &Vertices) {
        for corner in self.mesh.faces().face_corners(face) {
            let vertex = vertices.first_from(self.mesh.faces().corner_vertex(corner));
            list.push_corner(vertex, Some(corner));
        }
        list.builder.end_face();
    }

    /// Adds a face with all the corners of its source, each at the vertex of the corner that it repeats.
    fn push_with_repeats(&self, list: &mut FaceList, face: FaceId, key: FaceKey, vertices: &Vertices) {
        let (first, faces) = (self.faces[key].half, self.mesh.faces());
        let (mut halves, mut current) = (self.round(first).peekable(), first);
        for corner in faces.face_corners(face) {
            if let Some(next) = halves.next_if(|&half| self.kept_corner(half, face) == Some(corner)) {
                current = next;
            }
            // What repeats the last corner follows it, and at the end of a face the first one may be repeated.
            let stands_at = |half| {
                let kept = self.kept_corner(half, face);
                kept.is_some_and(|kept| faces.corner_vertex(kept) == faces.corner_vertex(corner))
            };
            let half = if stands_at(current) { current } else { first };
            list.push_corner(vertices.new[self.halves[half].origin], Some(corner));
        }
        list.builder.end_face();
    }

    /// Adds a face as it is now.
    fn push_face(&self, list: &mut FaceList, key: FaceKey, vertices: &Vertices) {
        let Face { half: first, source, .. } = self.faces[key];
        let kept = |half| source.and_then(|face| self.kept_corner(half, face));
        let lowest = self.round(first).filter_map(|half| Some((kept(half)?, half))).min_by_key(|&(c, _)| c);
        let mut last = None;
        for half in self.round(lowest.map_or(first, |(_, half)| half)) {
            let record = &self.halves[half];
            // Round a face corners ascend: one that does not is a copy, or stands elsewhere now.
            let corner = kept(half).filter(|&corner| last.is_none_or(|last| corner > last));
            if corner.is_some() {
                last = corner;
            } else if let Some(blend) = record.place.attributes() {
                list.created_corners.push((CornerId::new(list.corner_sources.len()), blend));
            }
            list.push_corner(vertices.new[record.origin], corner);
        }
        list.builder.end_face();
    }
}

/// The vertices of the result: those that come from one of the mesh, and then the others.
struct Vertices {
    /// Each with its source; without a key where only loose elements or degenerate faces use it.
    kept: Vec<(VertexId, Option<VertexKey>)>,
    created: Vec<VertexKey>,
    new: SecondaryMap<VertexKey, VertexId>,
}

impl Vertices {
    /// The first vertex that comes from one of the mesh. There is one for each that is asked for.
    fn first_from(&self, source: VertexId) -> VertexId {
        VertexId::new(self.kept.partition_point(|&(kept, _)| kept < source))
    }
}

/// The faces of the result as they are collected.
#[derive(Default)]
struct FaceList {
    builder: FaceTableBuilder,
    corner_sources: Vec<Option<CornerId>>,
    created_corners: Vec<(CornerId, Blend)>,
}

impl FaceList {
    fn push_corner(&mut self, vertex: VertexId, source: Option<CornerId>) {
        self.builder.push_corner(vertex);
        self.corner_sources.push(source);
    }
}

/// The faces of the result.
struct Faces {
    table: FaceTable,
    sources: Sources<FaceId>,
    corner_sources: Sources<CornerId>,
    created_corners: Vec<(CornerId, Blend)>,
}
