//! The document of a repair.

use std::collections::BTreeMap;

use meshmend_core::{
    Aspect, Blend, DefectKind, Differences, Domain, FaceId, Id, Layer, PolygonMesh, Provenance, Severity,
    Sources, Values, VertexId,
};
use meshmend_io::{Loss, Note};
use meshmend_repair::{EmptiedName, PassKind, RemovedFace, Repaired, Rounding, emptied_names};
use serde::Serialize;

use super::{CheckDocument, Listing, PassDocument, SCHEMA};
use crate::{Criterion, Failing, GeometryChanges, StoredCounts};

/// What a repair did, with every list cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct RepairDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that was read, if one was.
    pub file: Option<String>,
    /// The file that was written, if one was.
    pub output: Option<String>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
    /// Whether what is written differs from what was read, apart from the format.
    pub changed: bool,
    /// How many vertices were joined to others and are apart again in the result, each in its own place.
    pub stitched: u64,
    /// What was stored, and what the result stores.
    pub stored: BeforeAndAfter,
    /// The mesh before, if it was looked at.
    pub before: Option<CheckDocument>,
    /// The mesh after, if it was looked at.
    pub after: Option<CheckDocument>,
    /// What rounding all positions to the output's precision did before the first pass, where that moved any.
    pub rounding: Option<RoundingFigures>,
    /// What each pass did, in order.
    pub passes: Vec<PassDocument>,
    /// The stored faces of which nothing is left.
    pub removed_faces: RemovedFaces,
    /// The groups, objects and materials of which nothing is left.
    pub emptied_names: Listing<EmptiedNameDocument>,
    /// The faces of the result that run the other way round than as stored.
    pub flipped_faces: Listing<FaceId>,
    /// How many stored normals turned with their faces.
    pub turned_normals: u64,
    /// The vertices of the result that were not stored.
    pub created_vertices: Listing<VertexId>,
    /// The faces of the result that were not stored, and why they are there.
    #[serde(skip_serializing_if = "has_none")]
    pub created_faces: Listing<CreatedFace>,
    /// What the written format can't carry.
    pub losses: Vec<Loss>,
    /// What of the result fails the run, if anything was to.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failing: Vec<Failing>,
    /// Where each element came from, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub provenance: Option<ProvenanceDocument>,
    /// What became of the defects of each kind that positions tell, if that was asked; null where a search stopped at its budget.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geometry_changes: Option<GeometryChanges>,
}

/// How many elements there were, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct BeforeAndAfter {
    /// As stored.
    pub before: StoredCounts,
    /// In the result.
    pub after: StoredCounts,
}

/// What rounding all positions did.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RoundingFigures {
    /// How many vertices moved.
    pub moved: usize,
    /// How many vertices came to be where a lower one is, and were not before.
    pub joined: usize,
    /// How many faces lost their area.
    pub emptied: usize,
}

impl From<Rounding> for RoundingFigures {
    fn from(Rounding { moved, joined, emptied }: Rounding) -> Self {
        RoundingFigures { moved, joined, emptied }
    }
}

/// The stored faces of which nothing is left.
#[derive(Clone, Debug, Serialize)]
pub struct RemovedFaces {
    /// How many.
    pub count: u64,
    /// How many for each reason.
    pub by_reason: BTreeMap<DefectKind, u64>,
    /// How many differed from the face that they repeated.
    pub differing: u64,
    /// The first of them, as many as the limit allows.
    pub items: Vec<NamedFace>,
}

/// A stored face that is gone, and why.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NamedFace {
    /// Its id as stored.
    pub face: FaceId,
    /// The pass that removed it.
    pub pass: PassKind,
    /// Why.
    pub reason: DefectKind,
    /// In what it differed from the face that it repeated, if it did.
    #[serde(skip_serializing_if = "is_nothing")]
    pub differed: Differences,
    /// The names that it had in that.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub had: BTreeMap<&'static str, String>,
}

/// A group, an object or a material that lost all its elements, and why.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct EmptiedNameDocument {
    /// Always `emptied-name`.
    pub kind: &'static str,
    /// What it names: `object`, `group`, `material`, `solid` or `part`.
    pub layer: String,
    /// The name; what is not UTF-8 in it is replaced.
    pub name: String,
    /// How many faces had it.
    pub faces: u64,
    /// How many of these went for each reason.
    pub by_reason: BTreeMap<DefectKind, u64>,
    /// How many loose edges had it.
    pub loose_edges: u64,
    /// How many loose points had it.
    pub loose_points: u64,
    /// All of this for people.
    pub message: String,
}

/// Where each element of the result came from: whole lists, whatever the limit.
#[derive(Clone, Debug, Serialize)]
pub struct ProvenanceDocument {
    /// For each vertex of the result the stored vertex whose place it has; `null` for a created one.
    pub vertex_sources: Sources<VertexId>,
    /// For each face of the result the stored face that it is, or is a part of.
    pub face_sources: Sources<FaceId>,
    /// The faces of the result that run the other way round than as stored.
    pub flipped: Vec<FaceId>,
    /// The created vertices.
    pub created: Vec<CreatedVertex>,
}

/// A face that a repair created.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct CreatedFace {
    /// Its id in the result.
    pub face: FaceId,
    /// Why it is there: `filled`, or the name of a pass of another crate.
    pub cause: &'static str,
}

/// A vertex that a repair created.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct CreatedVertex {
    /// Its id in the result.
    pub vertex: VertexId,
    /// Where it is in terms of the stored mesh, where its neighbours were stored.
    pub place: Option<Blend>,
}

impl RepairDocument {
    /// The document of the repair of a mesh as stored, with at most `limit` items in each list. What only the caller knows (files,
    /// the state before and after, losses) is absent, and can be filled in.
    pub fn new(stored: &PolygonMesh, repaired: &Repaired, limit: usize) -> Self {
        let created = repaired.provenance.created.iter();
        RepairDocument {
            schema: SCHEMA,
            file: None,
            output: None,
            notes: Vec::new(),
            changed: repaired.is_changed(),
            stitched: repaired.stitched as u64,
            stored: BeforeAndAfter {
                before: StoredCounts::of(stored),
                after: StoredCounts::of(&repaired.mesh),
            },
            before: None,
            after: None,
            rounding: repaired.rounding.map(RoundingFigures::from),
            passes: repaired.passes.iter().map(|record| PassDocument::new(record, limit)).collect(),
            removed_faces: RemovedFaces::new(stored, &repaired.removed_faces, limit),
            emptied_names: Listing::cut(
                emptied_names(stored, repaired).into_iter().map(EmptiedNameDocument::from),
                limit,
            ),
            flipped_faces: Listing::cut(repaired.provenance.flipped.iter().copied(), limit),
            turned_normals: repaired.turned_normals as u64,
            created_vertices: Listing::cut(created.map(|&(vertex, _)| vertex), limit),
            created_faces: Listing::cut(created_faces(repaired), limit),
            losses: Vec::new(),
            failing: Vec::new(),
            provenance: None,
            geometry_changes: None,
        }
    }
}

impl RepairDocument {
    /// How much meets a criterion of a gate. Defects are those of the result; it must have been judged.
    pub fn count(&self, criterion: Criterion) -> u64 {
        match criterion {
            Criterion::Defect(kind) => {
                self.after.as_ref().and_then(|after| after.group(kind)).map_or(0, |group| group.count)
            }
            Criterion::Loss(_) => criterion.count_in(&self.losses),
            Criterion::Removed => self.removed_faces.count,
            Criterion::Changed => self.changed.into(),
            Criterion::Left => self.left(),
        }
    }

    /// How many defects are left, or where the result was not judged, how many the passes say that they left. Notes don't count.
    pub fn left(&self) -> u64 {
        let is_defect = |kind: DefectKind| kind.severity() == Severity::Defect;
        let after = self.after.iter().flat_map(|after| &after.defects);
        let defects: u64 = after.filter(|group| is_defect(group.kind)).map(|group| group.count).sum();
        let named = self.passes.iter().flat_map(|pass| &pass.left);
        let named: u64 = named.filter(|(kind, _)| is_defect(**kind)).map(|(_, left)| left.count).sum();
        if defects > 0 { defects } else { named }
    }
}

impl From<EmptiedName> for EmptiedNameDocument {
    fn from(emptied: EmptiedName) -> Self {
        let message = emptied.to_string();
        let EmptiedName { layer, name, faces, by_reason, loose_edges, loose_points } = emptied;
        let name = String::from_utf8_lossy(&name).into_owned();
        let kind = "emptied-name";
        EmptiedNameDocument { kind, layer, name, faces, by_reason, loose_edges, loose_points, message }
    }
}

impl RemovedFaces {
    fn new(stored: &PolygonMesh, removed: &[RemovedFace], limit: usize) -> Self {
        let mut by_reason = BTreeMap::new();
        for face in removed {
            *by_reason.entry(face.reason).or_insert(0) += 1;
        }
        let named = |removed: &RemovedFace| NamedFace {
            face: removed.face,
            pass: removed.pass,
            reason: removed.reason,
            differed: removed.differed,
            had: names_of(stored, removed),
        };
        RemovedFaces {
            count: removed.len() as u64,
            by_reason,
            differing: removed.iter().filter(|removed| !removed.differed.is_empty()).count() as u64,
            items: removed.iter().take(limit).map(named).collect(),
        }
    }
}

fn created_faces(repaired: &Repaired) -> impl ExactSizeIterator<Item = CreatedFace> {
    repaired.created_faces.iter().map(|&(face, pass)| {
        let cause = if pass == PassKind::Fill { "filled" } else { pass.name() };
        CreatedFace { face, cause }
    })
}

fn has_none<T>(listing: &Listing<T>) -> bool {
    listing.count == 0
}

fn is_nothing(differences: &Differences) -> bool {
    differences.is_empty()
}

/// The names that a face had in what it differed in.
fn names_of(stored: &PolygonMesh, removed: &RemovedFace) -> BTreeMap<&'static str, String> {
    let name = |layer: &Layer| {
        let aspect =
            Aspect::of_layer(layer).filter(|&aspect| removed.differed.iter().any(|a| a == aspect))?;
        let Values::Text(names) = layer.values() else { return None };
        let name =
            names.get(layer.value_of(removed.face.index()).filter(|_| layer.domain() == Domain::Face)?)?;
        Some((aspect.name(), String::from_utf8_lossy(name).into_owned()))
    };
    stored.layers().iter().filter_map(name).collect()
}

impl ProvenanceDocument {
    /// The maps of a repair.
    pub fn new(provenance: &Provenance) -> Self {
        let created = |&(vertex, place): &_| CreatedVertex { vertex, place };
        ProvenanceDocument {
            vertex_sources: provenance.vertices.clone(),
            face_sources: provenance.faces.clone(),
            flipped: provenance.flipped.clone(),
            created: provenance.created.iter().map(created).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::FaceTable;
    use meshmend_repair::Pipeline;
    use serde_json::{Value, json};

    use super::*;
    use crate::Session;

    #[test]
    fn a_repair_is_told_pass_by_pass() {
        let positions =
            [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0; 3]];
        let faces = [0, 1, 2, 3, 4, 5, 0, 1, 1, 0, 0, 0].map(VertexId).to_vec();
        let mesh = PolygonMesh::new(positions.to_vec(), FaceTable::triangles(6, faces).unwrap()).unwrap();
        let repaired = Pipeline::default().run_in(Session::begin(&mesh).with_figures()).unwrap();
        let mut document = RepairDocument::new(&mesh, &repaired, 1);
        document.provenance = Some(ProvenanceDocument::new(&repaired.provenance));
        let document: Value = serde_json::to_value(document).unwrap();
        assert_eq!(document["passes"][0]["mended"]["coincident-vertex"]["count"], 2);
        let items = &document["passes"][0]["mended"]["coincident-vertex"]["items"];
        assert_eq!(items.as_array().unwrap().len(), 1);
        let delta = json!({"euler_characteristic": -1, "components": -1, "boundary_loops": -1});
        assert_eq!(document["passes"][0]["delta"], delta);
        let gone = json!({
            "count": 2,
            "by_reason": {"degenerate-face": 2},
            "differing": 0,
            "items": [{"face": 2, "pass": "clean", "reason": "degenerate-face"}],
        });
        assert_eq!(document["removed_faces"], gone);
        assert_eq!(document["flipped_faces"], json!({"count": 1, "items": [1]}));
        assert_eq!(document["provenance"]["vertex_sources"], json!([0, 1, 2, 5]));
        assert_eq!(document["provenance"]["face_sources"], json!([0, 1]));
    }

    #[test]
    fn a_name_of_which_nothing_is_left_is_told() {
        use meshmend_core::{Carry, Domain, Layer, Values};

        let faces = FaceTable::triangles(3, [0, 1, 2, 0, 1, 1, 0, 2, 2].map(VertexId).to_vec()).unwrap();
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let names = Values::Text([&b"kept"[..], b"go\xffne", b"gone too"].map(<[u8]>::to_vec).to_vec());
        let layer = Layer::direct("material", Domain::Face, 1, Carry::Copy, names);
        let mesh = PolygonMesh::new(points, faces).unwrap().with_layers(vec![layer]).unwrap();
        let repaired = Pipeline::default().run(&mesh).unwrap();
        let document: Value = serde_json::to_value(RepairDocument::new(&mesh, &repaired, 1)).unwrap();
        let name = json!({
            "kind": "emptied-name",
            "layer": "material",
            "name": "go\u{fffd}ne",
            "faces": 1,
            "by_reason": {"degenerate-face": 1},
            "loose_edges": 0,
            "loose_points": 0,
            "message": "material `go\u{fffd}ne` has no face left: its 1 face was degenerate",
        });
        assert_eq!(document["emptied_names"], json!({"count": 2, "items": [name]}));
    }
}
