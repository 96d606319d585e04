//! How a pass describes the mesh that it wants, and the one place that makes it.
//!
//! A pass fills a [`Draft`]: the new faces, and where each new face, corner and vertex came from. From that
//! [`PolygonMesh::rebuild`] makes the mesh, carries all attributes and loose elements along, and returns the
//! [`Provenance`], so that no pass has attribute code and no record can differ from what was done.

use serde::Serialize;
use thiserror::Error;

use crate::role::{Turned, turned};
use crate::{
    CornerId, Counts, Domain, FaceId, FaceTable, FaceTableError, FlippedNormals, Id, Layer, MeshError,
    NO_VALUE, PolygonMesh, Provenance, Sources, VertexId,
};

/// Where a created element lies, in terms of the old mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Blend {
    /// On the side between two neighbouring corners of a face: from + (to − from) · numerator / denominator.
    Along {
        /// The corner at which it would lie for numerator 0.
        #[serde(rename = "from_corner")]
        from: CornerId,
        /// The corner at which it would lie for numerator = denominator.
        #[serde(rename = "to_corner")]
        to: CornerId,
        /// How many parts of the way.
        numerator: u32,
        /// Of how many parts in all.
        denominator: u32,
    },
    /// Within a face, with the mean of its corners' attributes.
    Inside {
        /// The face.
        face: FaceId,
    },
}

impl Blend {
    /// The same place in terms of the mesh before an earlier change, where its elements existed there.
    pub(crate) fn seen_from_before(self, earlier: &Provenance) -> Option<Blend> {
        Some(match self {
            Blend::Along { from, to, numerator, denominator } => {
                let (from, to) = (earlier.corners.of(from)?, earlier.corners.of(to)?);
                Blend::Along { from, to, numerator, denominator }
            }
            Blend::Inside { face } => Blend::Inside { face: earlier.faces.of(face)? },
        })
    }

    /// The corners that it lies between, with their weights.
    fn parts(self, faces: &FaceTable) -> Vec<(CornerId, f64)> {
        match self {
            Blend::Along { from, to, numerator, denominator } => {
                let share = f64::from(numerator) / f64::from(denominator);
                vec![(from, 1.0 - share), (to, share)]
            }
            Blend::Inside { face } => {
                let corners = faces.face_corners(face);
                let share = 1.0 / corners.len() as f64;
                corners.map(|corner| (corner, share)).collect()
            }
        }
    }
}

/// A vertex that a pass creates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexDraft {
    /// Its point.
    pub position: [f64; 3],
    /// Where that is in terms of the old mesh.
    pub place: Blend,
}

/// The mesh that a pass wants, in terms of the one that it was given.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The new faces over the new vertices.
    pub faces: FaceTable,
    /// For each new face the old one that it is or is a part of.
    pub face_sources: Sources<FaceId>,
    /// For each new corner the old one that it is.
    pub corner_sources: Sources<CornerId>,
    /// The new faces that run the other way round than their sources, ascending.
    pub flipped: Vec<FaceId>,
    /// For each new vertex the old one whose place and attributes it has. The created ones come last.
    pub vertex_sources: Sources<VertexId>,
    /// Where the kept vertices are, if not all of them are where their sources are.
    pub kept_positions: Option<Vec<[f64; 3]>>,
    /// The created vertices, in order.
    pub created_vertices: Vec<VertexDraft>,
    /// The created corners with the old corners that they lie between, ascending.
    pub created_corners: Vec<(CornerId, Blend)>,
    /// For each old vertex the new one that loose elements use instead, where that is not the first new vertex
    /// whose source it is.
    pub merged_into: Option<Vec<VertexId>>,
    /// Whether loose edges and points are left out.
    pub drop_loose: Loose,
    /// Whether stored normals turn with the faces that are flipped.
    pub flipped_normals: FlippedNormals,
}

/// Which loose elements a pass leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Loose {
    /// Leave out the loose edges.
    pub edges: bool,
    /// Leave out the loose points.
    pub points: bool,
}

/// Why a draft makes no mesh: a mistake of the pass, never of the input.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DraftError {
    /// A list has not one entry for each element.
    #[error("a draft has {found} {what}, but {expected} are needed")]
    Count {
        /// Which list.
        what: &'static str,
        /// How many entries it has.
        found: usize,
        /// How many it needs.
        expected: usize,
    },
    /// A loose element's vertex is no longer there.
    #[error("a draft drops {0}, which a loose element uses")]
    LooseVertex(VertexId),
    /// The parts don't fit together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There would be more elements than a mesh holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
}

impl Draft {
    /// A draft that keeps every vertex: the usual start, with new faces over the old vertices.
    pub fn of_faces(
        mesh: &PolygonMesh,
        faces: FaceTable,
        face_sources: Sources<FaceId>,
        corner_sources: Sources<CornerId>,
    ) -> Self {
        Draft {
            faces,
            face_sources,
            corner_sources,
            flipped: Vec::new(),
            vertex_sources: Sources::same(mesh.counts().vertices),
            kept_positions: None,
            created_vertices: Vec::new(),
            created_corners: Vec::new(),
            merged_into: None,
            drop_loose: Loose::default(),
            flipped_normals: FlippedNormals::default(),
        }
    }
}

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
    pub fn rebuild(&self, draft: Draft) -> Result<(PolygonMesh, Provenance), DraftError> {
        check_counts(&draft)?;
        let positions = self.draft_positions(&draft);
        let (edges, points) = self.draft_loose(&draft)?;
        let carried = self.layers().iter().map(|layer| self.carried(layer, &draft));
        let layers: Vec<Layer> = carried.map(|layer| with_turned_values(layer, &draft)).collect();
        let metadata = crate::anchors::carried(self.metadata(), &draft);
        let kept = draft.vertex_sources.len() - draft.created_vertices.len();
        let places = draft.created_vertices.iter().enumerate();
        let provenance = Provenance {
            before: Counts { ..self.counts() },
            vertices: draft.vertex_sources,
            faces: draft.face_sources,
            corners: draft.corner_sources,
            flipped: draft.flipped,
            created: places.map(|(i, v)| (VertexId::new(kept + i), Some(v.place))).collect(),
        };
        let mesh =
            PolygonMesh::new(positions, draft.faces)?.with_loose(edges, points)?.with_layers(layers)?;
        Ok((mesh.with_metadata(metadata), provenance))
    }

    fn draft_positions(&self, draft: &Draft) -> Vec<[f64; 3]> {
        let mut positions = match &draft.kept_positions {
            Some(kept) => kept.clone(),
            None if draft.vertex_sources.is_same() => self.positions()[..draft.vertex_sources.len()].to_vec(),
            None => draft.vertex_sources.iter().filter_map(|(_, old)| Some(self.position(old?))).collect(),
        };
        positions.extend(draft.created_vertices.iter().map(|v| v.position));
        positions
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

    /// A layer as the draft's mesh has it.
    fn carried(&self, layer: &Layer, draft: &Draft) -> Layer {
        match layer.domain() {
            Domain::Face if draft.face_sources.is_all_of(self.counts().faces) => layer.clone(),
            Domain::Face => {
                let uses = draft
                    .face_sources
                    .iter()
                    .map(|(_, old)| old.map_or(NO_VALUE, |f| layer.element_use(f.index())));
                layer.with_uses(Domain::Face, uses.collect())
            }
            Domain::Vertex if draft.vertex_sources.is_all_of(self.counts().vertices) => layer.clone(),
            Domain::Vertex => self.carried_vertex_layer(layer, draft),
            Domain::Corner if self.keeps_corners(draft) && layer.home() != Domain::Vertex => layer.clone(),
            Domain::Corner => self.carried_corner_layer(layer, draft),
            Domain::LooseEdge if draft.drop_loose.edges => layer.with_uses(Domain::LooseEdge, Vec::new()),
            Domain::LoosePoint if draft.drop_loose.points => layer.with_uses(Domain::LoosePoint, Vec::new()),
            Domain::LooseEdge | Domain::LoosePoint => layer.clone(),
        }
    }

    fn keeps_corners(&self, draft: &Draft) -> bool {
        draft.corner_sources.is_all_of(self.counts().corners)
    }

    /// Stays on the vertices unless some corner's old vertex has another value than the vertex it is at now.
    fn carried_vertex_layer(&self, layer: &Layer, draft: &Draft) -> Layer {
        let mut layer = layer.clone();
        let uses = self.vertex_uses(&mut layer, draft);
        let old_use =
            |layer: &Layer, old: CornerId| layer.vertex_use(self.faces().corner_vertex(old).index());
        let differs = draft.corner_sources.iter().any(|(new, old)| {
            let at = draft.faces.corner_vertex(new).index();
            old.is_some_and(|old| !layer.same_value(old_use(&layer, old), uses[at]))
        });
        if !differs {
            return layer.with_uses(Domain::Vertex, uses);
        }
        let by_corner = draft.corner_sources.iter().map(|(new, old)| match old {
            Some(old) => old_use(&layer, old),
            None => uses[draft.faces.corner_vertex(new).index()],
        });
        let by_corner = by_corner.collect();
        settled(layer, by_corner, uses, &draft.faces)
    }

    /// What each new vertex uses: its source's value, or for a created one a blend.
    fn vertex_uses(&self, layer: &mut Layer, draft: &Draft) -> Vec<u32> {
        let kept = draft.vertex_sources.iter().filter_map(|(_, old)| Some(layer.vertex_use(old?.index())));
        let mut uses: Vec<u32> = kept.collect();
        for created in &draft.created_vertices {
            let parts = created.place.parts(self.faces());
            let parts: Vec<(u32, f64)> = parts
                .iter()
                .map(|&(c, weight)| (layer.vertex_use(self.faces().corner_vertex(c).index()), weight))
                .collect();
            uses.push(layer.blended(&parts));
        }
        uses
    }

    fn carried_corner_layer(&self, layer: &Layer, draft: &Draft) -> Layer {
        let (mut layer, first) = (layer.clone(), layer.value_count());
        let old = draft
            .corner_sources
            .iter()
            .map(|(_, old)| old.map_or(NO_VALUE, |c| layer.element_use(c.index())));
        let mut uses: Vec<u32> = old.collect();
        for &(corner, place) in &draft.created_corners {
            let parts = place.parts(self.faces());
            let parts: Vec<(u32, f64)> =
                parts.iter().map(|&(c, weight)| (layer.element_use(c.index()), weight)).collect();
            uses[corner.index()] = layer.blended(&parts);
        }
        if layer.home() != Domain::Vertex {
            layer.pool_created(first, &mut uses);
            return layer.with_uses(Domain::Corner, uses);
        }
        let vertex_uses = self.vertex_uses(&mut layer, draft);
        settled(layer, uses, vertex_uses, &draft.faces)
    }
}

/// A layer whose values turn with flipped faces, if the draft says so.
fn with_turned_values(layer: Layer, draft: &Draft) -> Layer {
    if draft.flipped_normals == FlippedNormals::Keep {
        return layer;
    }
    let Some(Turned { layer, uses }) = turned(&layer, &draft.faces, &draft.flipped) else { return layer };
    if layer.home() != Domain::Vertex {
        let domain = layer.domain();
        return layer.with_uses(domain, uses);
    }
    let vertex_uses = (0..draft.faces.vertex_count()).map(|vertex| layer.vertex_use(vertex)).collect();
    settled(layer, uses, vertex_uses, &draft.faces)
}

/// A vertex layer by corners: back on the vertices if no vertex has corners that differ.
///
/// A vertex's own value is that of its corners where these agree, so that it hangs on the mesh as it is, and not on the
/// way to it.
fn settled(layer: Layer, uses: Vec<u32>, mut vertex_uses: Vec<u32>, faces: &FaceTable) -> Layer {
    let mut seen: Vec<Option<u32>> = vec![None; vertex_uses.len()];
    let mut differs = vec![false; vertex_uses.len()];
    for corner in faces.corners() {
        let (v, value) = (faces.corner_vertex(corner).index(), uses[corner.index()]);
        differs[v] |= !layer.same_value(*seen[v].get_or_insert(value), value);
    }
    for (vertex, own) in vertex_uses.iter_mut().enumerate() {
        *own = seen[vertex].filter(|_| !differs[vertex]).unwrap_or(*own);
    }
    if differs.contains(&true) {
        layer.with_uses(Domain::Corner, uses).with_vertex_uses(vertex_uses)
    } else {
        layer.with_uses(Domain::Vertex, vertex_uses).without_vertex_uses()
    }
}

fn check_counts(draft: &Draft) -> Result<(), DraftError> {
    let faces = &draft.faces;
    let created = draft.vertex_sources.iter().filter(|(_, old)| old.is_none()).count();
    let kept = draft.vertex_sources.len() - created;
    let needed = [
        ("face sources", draft.face_sources.len(), faces.face_count()),
        ("corner sources", draft.corner_sources.len(), faces.corner_count()),
        ("vertex sources", draft.vertex_sources.len(), faces.vertex_count()),
        ("created vertices", draft.created_vertices.len(), created),
        ("kept positions", draft.kept_positions.as_ref().map_or(kept, Vec::len), kept),
    ];
    match needed.into_iter().find(|(_, found, expected)| found != expected) {
        Some((what, found, expected)) => Err(DraftError::Count { what, found, expected }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, FaceTableBuilder, Values};

    /// A square of two triangles, each corner and vertex with a number of its own.
    fn square() -> PolygonMesh {
        let corners = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
        let faces = FaceTable::triangles(4, corners).unwrap();
        let layer = |domain, carry, values| Layer::direct("number", domain, 1, carry, values);
        PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]], faces)
            .unwrap()
            .with_layers(vec![
                layer(Domain::Corner, Carry::Interpolate, Values::F64((0..6).map(f64::from).collect())),
                layer(Domain::Vertex, Carry::Interpolate, Values::F32((0..4u8).map(f32::from).collect())),
                layer(Domain::Face, Carry::Copy, Values::Text(vec![b"a".to_vec(), b"b".to_vec()])),
            ])
            .unwrap()
    }

    fn value(layer: &Layer, element: usize) -> Option<f64> {
        let at = layer.value_of(element)?;
        if let Values::F64(values) = layer.values() {
            return Some(values[at]);
        }
        let Values::F32(values) = layer.values() else { panic!("no layer of a square is of this type") };
        Some(f64::from(values[at]))
    }

    #[test]
    fn created_corners_and_vertices_get_what_lies_between() {
        let mesh = square();
        let place = Blend::Along { from: CornerId(1), to: CornerId(2), numerator: 1, denominator: 4 };
        let mut builder = FaceTableBuilder::default();
        builder.push_face([0, 1, 4, 2].map(VertexId));
        let corners = [Some(0), Some(1), None, Some(2)].map(|c| c.map(CornerId));
        let draft = Draft {
            vertex_sources: Sources::listed(
                [0, 1, 2, 3].map(|v| Some(VertexId(v))).into_iter().chain([None]),
            ),
            created_vertices: vec![VertexDraft { position: [0.75, 0.25, 0.0], place }],
            created_corners: vec![(CornerId(2), place)],
            ..Draft::of_faces(
                &mesh,
                builder.build(5).unwrap(),
                Sources::listed([Some(FaceId(0))]),
                Sources::listed(corners),
            )
        };
        let (new, record) = mesh.rebuild(draft).unwrap();
        assert_eq!(value(&new.layers()[0], 2), Some(1.25));
        assert_eq!(value(&new.layers()[1], 4), Some(1.25));
        assert_eq!(new.layers()[2].element_count(), 1);
        assert_eq!(record.created, [(VertexId(4), Some(place))]);
        assert_eq!(record.removed_faces(), [FaceId(1)]);
    }

    #[test]
    fn a_vertex_inside_a_face_gets_the_mean_of_its_corners() {
        let mesh = square();
        let place = Blend::Inside { face: FaceId(1) };
        let corners = [2, 1, 4, 1, 3, 4, 3, 2, 4].map(VertexId).to_vec();
        let sources = [Some(3), Some(4), None, Some(4), Some(5), None, Some(5), Some(3), None];
        let draft = Draft {
            vertex_sources: Sources::listed((0..4).map(|v| Some(VertexId(v))).chain([None])),
            created_vertices: vec![VertexDraft { position: [0.6, 0.6, 0.0], place }],
            created_corners: [2, 5, 8].map(|c| (CornerId(c), place)).to_vec(),
            ..Draft::of_faces(
                &mesh,
                FaceTable::triangles(5, corners).unwrap(),
                Sources::listed([Some(FaceId(1)); 3]),
                Sources::listed(sources.map(|c| c.map(CornerId))),
            )
        };
        let (new, _) = mesh.rebuild(draft).unwrap();
        let is_about = |found: Option<f64>, mean: f64| found.is_some_and(|x| (x - mean).abs() < 1e-9);
        assert!([2, 5, 8].iter().all(|&c| is_about(value(&new.layers()[0], c), 4.0)));
        assert!(is_about(value(&new.layers()[1], 4), 2.0));
        assert_eq!([0, 1, 2].map(|f| new.layers()[2].value_of(f)), [Some(1); 3]);
    }

    #[test]
    fn a_draft_that_changes_nothing_shares_all_layers() {
        let mesh = square();
        let same = Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(2), Sources::same(6));
        let (same, record) = mesh.rebuild(same).unwrap();
        assert!(record.is_same());
        assert_eq!(same.layers(), mesh.layers());
        for (new, old) in same.layers().iter().zip(mesh.layers()) {
            assert!(new.is_direct() && std::ptr::eq(new.values(), old.values()), "{:?}", new.domain());
        }
    }

    #[test]
    fn a_vertex_layer_moves_to_the_corners_and_comes_back() {
        let mesh = square();
        let joined = FaceTable::triangles(3, [0, 1, 2, 2, 1, 0].map(VertexId).to_vec()).unwrap();
        let draft = Draft {
            vertex_sources: Sources::listed([0, 1, 2].map(|v| Some(VertexId(v)))),
            merged_into: Some([0, 1, 2, 0].map(VertexId).to_vec()),
            ..Draft::of_faces(&mesh, joined, Sources::same(2), Sources::same(6))
        };
        let (joined, _) = mesh.rebuild(draft).unwrap();
        let layer = &joined.layers()[1];
        assert_eq!((layer.domain(), layer.home()), (Domain::Corner, Domain::Vertex));
        let at_corners: Vec<_> = (0..6).map(|c| value(layer, c)).collect();
        assert_eq!(at_corners, [0.0, 1.0, 2.0, 2.0, 1.0, 3.0].map(Some));
        let parted = FaceTable::triangles(4, [0, 1, 2, 2, 1, 3].map(VertexId).to_vec()).unwrap();
        let draft = Draft {
            vertex_sources: Sources::listed([0, 1, 2, 0].map(|v| Some(VertexId(v)))),
            ..Draft::of_faces(&joined, parted, Sources::same(2), Sources::same(6))
        };
        let (parted, _) = joined.rebuild(draft).unwrap();
        let layer = &parted.layers()[1];
        assert_eq!(layer.domain(), Domain::Vertex);
        assert_eq!((0..4).map(|v| value(layer, v)).collect::<Vec<_>>(), [0.0, 1.0, 2.0, 3.0].map(Some));
    }

    /// Vertices 0 and 3 of a square joined, a corner created between two that stay.
    #[test]
    fn a_created_corner_of_a_layer_that_moves_has_its_vertex_value() {
        let mesh = square();
        let place = Blend::Along { from: CornerId(1), to: CornerId(2), numerator: 1, denominator: 2 };
        let mut builder = FaceTableBuilder::default();
        builder.push_face([0, 1, 3, 2].map(VertexId));
        builder.push_face([2, 1, 0].map(VertexId));
        let corners = [Some(0), Some(1), None, Some(2), Some(3), Some(4), Some(5)];
        let draft = Draft {
            vertex_sources: Sources::listed([Some(0), Some(1), Some(2), None].map(|v| v.map(VertexId))),
            created_vertices: vec![VertexDraft { position: [0.5, 0.5, 0.0], place }],
            created_corners: vec![(CornerId(2), place)],
            ..Draft::of_faces(
                &mesh,
                builder.build(4).unwrap(),
                Sources::same(2),
                Sources::listed(corners.map(|c| c.map(CornerId))),
            )
        };
        let (new, _) = mesh.rebuild(draft).unwrap();
        let layer = &new.layers()[1];
        assert_eq!(layer.domain(), Domain::Corner);
        let at_corners: Vec<_> = (0..7).map(|c| value(layer, c)).collect();
        assert_eq!(at_corners, [0.0, 1.0, 1.5, 2.0, 2.0, 1.0, 3.0].map(Some));
    }

    #[test]
    fn a_vertex_layer_stays_at_the_corners_while_some_of_a_vertex_differ() {
        let mesh = square();
        let joined = FaceTable::triangles(3, [0, 1, 2, 2, 1, 0].map(VertexId).to_vec()).unwrap();
        let draft = Draft {
            vertex_sources: Sources::same(3),
            merged_into: Some([0, 1, 2, 0].map(VertexId).to_vec()),
            ..Draft::of_faces(&mesh, joined, Sources::same(2), Sources::same(6))
        };
        let (joined, _) = mesh.rebuild(draft).unwrap();
        let again = Draft::of_faces(&joined, joined.faces().clone(), Sources::same(2), Sources::same(6));
        let (again, _) = joined.rebuild(again).unwrap();
        assert_eq!(again.layers()[1], joined.layers()[1]);
        assert_eq!(again.layers()[1].domain(), Domain::Corner);
    }

    #[test]
    fn a_draft_that_does_not_fit_is_an_error() {
        let mesh = square();
        let draft = |faces, corners| {
            Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(faces), Sources::same(corners))
        };
        let wrong = mesh.rebuild(draft(3, 6)).unwrap_err();
        assert_eq!(wrong, DraftError::Count { what: "face sources", found: 3, expected: 2 });
        assert!(mesh.rebuild(draft(2, 5)).is_err());
        let loose = square().with_loose(Vec::new(), vec![VertexId(3)]).unwrap();
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let draft = Draft {
            vertex_sources: Sources::same(3),
            ..Draft::of_faces(&loose, faces, Sources::same(1), Sources::same(3))
        };
        assert_eq!(loose.rebuild(draft).unwrap_err(), DraftError::LooseVertex(VertexId(3)));
    }

    #[test]
    fn layers_of_loose_elements_stay_with_them_or_go_with_them() {
        let layer = |domain, count| {
            Layer::direct("object", domain, 1, Carry::Copy, Values::Text(vec![b"a".to_vec(); count]))
        };
        let layers = vec![layer(Domain::LooseEdge, 2), layer(Domain::LoosePoint, 1)];
        let edges = vec![[VertexId(0), VertexId(1)], [VertexId(1), VertexId(2)]];
        let mesh = square().with_loose(edges, vec![VertexId(3)]).unwrap().with_layers(layers).unwrap();
        let rebuilt = |drop_loose| {
            let (faces, corners) = (Sources::same(2), Sources::same(6));
            let draft = Draft { drop_loose, ..Draft::of_faces(&mesh, mesh.faces().clone(), faces, corners) };
            let layers = mesh.rebuild(draft).unwrap().0.layers().to_vec();
            [layers[0].element_count(), layers[1].element_count()]
        };
        assert_eq!(rebuilt(Loose::default()), [2, 1]);
        assert_eq!(rebuilt(Loose { edges: true, points: false }), [0, 1]);
        assert_eq!(rebuilt(Loose { edges: false, points: true }), [2, 0]);
    }

    #[test]
    fn created_values_that_are_the_same_are_one_value() {
        // Three triangles round a new vertex inside the first face; its middle is a value that is there already.
        let corner = |values: Vec<f64>| {
            Layer::direct("texcoord", Domain::Corner, 1, Carry::Interpolate, Values::F64(values))
        };
        let centred = |values: Vec<f64>| {
            let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
            let mesh = PolygonMesh::new(square().positions()[..3].to_vec(), faces).unwrap();
            let mesh = mesh.with_layers(vec![corner(values)]).unwrap();
            let faces = FaceTable::triangles(4, [0, 1, 3, 1, 2, 3, 2, 0, 3].map(VertexId).to_vec()).unwrap();
            let place = Blend::Inside { face: FaceId(0) };
            let c = |corner| Some(CornerId(corner));
            let corners = [c(0), c(1), None, c(1), c(2), None, c(2), c(0), None];
            let draft = Draft {
                vertex_sources: Sources::listed(
                    [0, 1, 2].map(|v| Some(VertexId(v))).into_iter().chain([None]),
                ),
                created_vertices: vec![VertexDraft { position: [0.1; 3], place }],
                created_corners: [2, 5, 8].map(|corner| (CornerId(corner), place)).to_vec(),
                ..Draft::of_faces(
                    &mesh,
                    faces,
                    Sources::listed([Some(FaceId(0)); 3]),
                    Sources::listed(corners),
                )
            };
            let layer = mesh.rebuild(draft).unwrap().0.layers()[0].clone();
            (layer.values().len(), [2, 5, 8].map(|corner| layer.value_of(corner)))
        };
        assert_eq!(centred(vec![0.0, 3.0, 9.0]), (4, [Some(3); 3]));
        assert_eq!(centred(vec![0.0, 1.0, 0.5]), (3, [Some(2); 3]));
    }
}
