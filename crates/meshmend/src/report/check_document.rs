//! The document of a check.

use meshmend_core::{Defect, DefectKind, Severity, VertexId};
use meshmend_external::ExternalCheck;
use meshmend_io::{Note, ReadFile};
use meshmend_repair::Distance;
use meshmend_topology::TopologyReport;
use serde::Serialize;

use super::{GeometryDocument, Listing, PlacedDefect, SCHEMA};
use crate::{CheckReport, ExternalReport, KernelVerdict, StoredCounts};

/// What a check found, with every list cut to a limit. Vertices and faces have the numbers that they have as stored, also in a
/// welded view: of vertices that are one there, the lowest. Edges are numbered within the view.
#[derive(Clone, Debug, Serialize)]
pub struct CheckDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that the mesh is from, if it is from one.
    pub file: Option<String>,
    /// Which form of which format the file has, such as `ply-le`.
    pub format: Option<&'static str>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// How many vertices would be joined to others in single precision (`--weld single`), beyond those at the same position.
    pub joined_in_single: u64,
    /// How many vertices are at the position of others and yet apart, as morph targets or joints move them differently.
    pub apart_in_pose: u64,
    /// What is stored.
    pub stored: StoredCounts,
    /// The figures, each under its own key. The list of component kinds is cut to the limit.
    #[serde(flatten)]
    pub topology: TopologyReport,
    /// How many kinds of component there are in all.
    pub component_kinds_total: u64,
    /// The edges with one side that other parts use too, by their ends as stored; they are not listed as boundary. Only
    /// where a mesh was taken apart by the names of its faces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shared_edges: Option<Listing<[VertexId; 2]>>,
    /// Where the faces lie, if that was asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geometry: Option<GeometryDocument>,
    /// What is wrong, by kind.
    pub defects: Vec<DefectGroup>,
    /// Which kernels hold the mesh.
    pub kernels: Vec<KernelVerdict>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

/// The defects of one kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DefectGroup {
    /// Which kind.
    pub kind: DefectKind,
    /// Whether it fails a check.
    pub severity: Severity,
    /// How many there are in all.
    pub count: u64,
    /// The first of them, as many as the limit allows. A strip of faces is never cut: a part of it shows nothing.
    pub items: Vec<PlacedDefect>,
}

impl CheckDocument {
    /// The document of a report, with at most `limit` items in each list.
    pub fn new(report: CheckReport, limit: usize) -> Self {
        let group = |kind: DefectKind| DefectGroup::of(&report, kind, limit);
        let defects = report.listed_kinds().map(group).collect();
        let geometry = GeometryDocument::of(&report, limit);
        let mut topology = report.topology;
        // The list of all defects can be larger than the mesh, and no key of the document is made from it.
        topology.defects = Default::default();
        let component_kinds_total = topology.component_kinds.len() as u64;
        topology.component_kinds.truncate(limit);
        for kind in &mut topology.component_kinds {
            kind.first_vertex = report.vertex_sources.of(kind.first_vertex).unwrap_or(kind.first_vertex);
        }
        CheckDocument {
            schema: SCHEMA,
            file: None,
            format: None,
            view: report.view.name(),
            weld: report.view.distance(),
            joined_in_single: report.joined_in_single,
            apart_in_pose: report.apart_in_pose,
            stored: report.stored,
            topology,
            component_kinds_total,
            shared_edges: None,
            geometry,
            defects,
            kernels: report.kernels,
            notes: Vec::new(),
        }
    }

    /// The document of a report on a mesh that may be larger than memory, with at most `limit` items in each list; no more than were
    /// asked for when it was checked.
    pub fn of_external(report: &ExternalReport, name: String, limit: usize) -> Self {
        let ExternalCheck { file, stored, topology, joined_in_single, .. } = &report.found;
        let mut topology = topology.clone();
        let component_kinds_total = topology.component_kinds.len() as u64;
        topology.component_kinds.truncate(limit);
        CheckDocument {
            schema: SCHEMA,
            file: Some(name),
            format: Some(file.variant),
            view: report.view.name(),
            weld: report.view.distance(),
            joined_in_single: *joined_in_single,
            apart_in_pose: 0,
            stored: StoredCounts {
                vertices: stored[0] as usize,
                faces: stored[1] as usize,
                loose_edges: file.loose_edges.len(),
                loose_points: 0,
            },
            topology,
            component_kinds_total,
            shared_edges: None,
            geometry: None,
            defects: report
                .listed_kinds()
                .map(|kind| DefectGroup::of_external(report, kind, limit))
                .collect(),
            kernels: report.kernels.clone(),
            notes: file.notes.clone(),
        }
    }

    /// The document with what is known of the file that the mesh was read from.
    pub fn of_file(self, name: String, file: &ReadFile) -> Self {
        let format = Some(file.variant);
        CheckDocument { file: Some(name), format, notes: file.notes.clone(), ..self }
    }

    /// The defects of a kind.
    pub fn group(&self, kind: DefectKind) -> Option<&DefectGroup> {
        self.defects.iter().find(|group| group.kind == kind)
    }
}

impl DefectGroup {
    fn of(report: &CheckReport, kind: DefectKind, limit: usize) -> Self {
        let items = report.defects_of_kind(kind).take(limit);
        DefectGroup {
            kind,
            severity: kind.severity(),
            count: report.count(kind) as u64,
            items: items.map(|defect| PlacedDefect::of_report(defect, report, limit)).collect(),
        }
    }

    fn of_external(report: &ExternalReport, kind: DefectKind, limit: usize) -> Self {
        let ExternalCheck { defects, excerpt, .. } = &report.found;
        let (count, first) = defects.get(&kind).map_or((0, &[][..]), |(count, first)| (*count, &first[..]));
        let placed = |defect: &Defect| PlacedDefect::of_excerpt(defect.clone(), excerpt, limit);
        let items = first.iter().take(limit).map(placed).collect();
        DefectGroup { kind, severity: kind.severity(), count, items }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, PolygonMesh, VertexId};
    use serde_json::Value;

    use super::*;
    use crate::report::json;
    use crate::{CheckOptions, check};

    fn document(limit: usize) -> Value {
        let faces = [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1, 5, 6, 7].map(VertexId).to_vec();
        let mut positions: Vec<[f64; 3]> = (0..8).map(|i| [f64::from(i), 0.5, -0.0]).collect();
        positions[7][1] = f64::NAN;
        let mesh = PolygonMesh::new(positions, FaceTable::triangles(8, faces).unwrap()).unwrap();
        let report = check(&mesh, &CheckOptions::default()).unwrap();
        serde_json::from_str(&json(&CheckDocument::new(report, limit)).unwrap()).unwrap()
    }

    fn group<'a>(document: &'a Value, kind: &str) -> &'a Value {
        document["defects"].as_array().unwrap().iter().find(|group| group["kind"] == kind).unwrap()
    }

    #[test]
    fn the_figures_are_keys_of_the_document() {
        let document = document(10);
        assert_eq!((&document["schema"], &document["view"]), (&2.into(), &"indexed".into()));
        assert_eq!(document["vertices"], 8);
        assert_eq!(document["stored"]["faces"], 6);
        assert_eq!(document["betti"]["z2"], serde_json::json!([2, 1, 0]));
        assert_eq!(document["component_kinds"][0]["name"], "Möbius band");
    }

    #[test]
    fn defects_have_places_and_what_is_not_finite_is_null() {
        let document = document(10);
        let infinite = &group(&document, "non-finite-vertex")["items"][0];
        assert_eq!(infinite["vertex"], 7);
        assert_eq!(infinite["positions"], serde_json::json!([[7.0, null, 0.0]]));
        let strip = &group(&document, "non-orientable-patch")["items"][0];
        assert_eq!(strip["faces"].as_array().unwrap().len(), 5);
        assert_eq!(strip["edge_ends"].as_array().unwrap().len(), 5);
    }

    #[test]
    fn the_limit_cuts_lists_and_no_count() {
        let document = document(1);
        let boundary = group(&document, "boundary-edge");
        assert_eq!((boundary["count"].as_u64(), boundary["items"].as_array().unwrap().len()), (Some(8), 1));
        assert_eq!(document["component_kinds"].as_array().unwrap().len(), 1);
        assert_eq!(document["component_kinds_total"], 2);
    }
}
