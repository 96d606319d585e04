//! Where the defects of a mesh are, kind by kind, as the viewer draws them: all of them, while reports list the first ones.

use std::collections::BTreeMap;

use meshmend::mesh::Element;
use meshmend::{CheckReport, Defect, DefectKind, FaceId, VertexId};
use serde::Serialize;

use crate::packed::Packed;

/// So many defects of a kind are drawn.
const MOST_DRAWN: usize = 200_000;

/// Where the defects of one kind are, by ids as stored.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Marks {
    /// How many defects there are.
    count: usize,
    /// How many of them are drawn.
    drawn: usize,
    vertices: Packed,
    /// Edges by their ends.
    edges: Packed,
    faces: Packed,
    /// Closed strips of faces, with the edges that they cross by their ends.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    strips: Vec<StripData>,
}

#[derive(Clone, Debug, Serialize)]
struct StripData {
    faces: Vec<u32>,
    edges: Vec<[u32; 2]>,
}

#[derive(Default)]
struct Found {
    vertices: Vec<VertexId>,
    edges: Vec<[VertexId; 2]>,
    faces: Vec<FaceId>,
    strips: Vec<StripData>,
}

impl Marks {
    /// The marks of all kinds that a report lists.
    ///
    /// *Cost*: linear in the defects, of at most [`MOST_DRAWN`] of each kind.
    pub(crate) fn of(report: &CheckReport) -> BTreeMap<&'static str, Marks> {
        report.listed_kinds().map(|kind| (kind.code(), Marks::of_kind(report, kind))).collect()
    }

    fn of_kind(report: &CheckReport, kind: DefectKind) -> Self {
        let (mut found, mut drawn) = (Found::default(), 0);
        for defect in report.defects_of_kind(kind).take(MOST_DRAWN) {
            found.add(report, &defect);
            drawn += 1;
        }
        Marks {
            count: report.count(kind),
            drawn,
            vertices: found.vertices.iter().map(|&vertex| report.stored_vertex(vertex).0).collect(),
            edges: found.edges.iter().flatten().map(|&end| report.stored_vertex(end).0).collect(),
            faces: found.faces.iter().map(|&face| report.stored_face(face).0).collect(),
            strips: found.strips,
        }
    }
}

impl Found {
    fn add(&mut self, report: &CheckReport, defect: &Defect) {
        for element in [Some(&defect.at), defect.beside.as_ref()].into_iter().flatten() {
            self.vertices.extend(element.vertex());
            self.edges.extend(element.ends());
            if let Element::Strip(strip) = element {
                let ends = |edge| report.mesh.complex().edges().ends(edge);
                let stored = |end: VertexId| report.stored_vertex(end).0;
                self.strips.push(StripData {
                    faces: strip.faces.iter().map(|&face| report.stored_face(face).0).collect(),
                    edges: strip.edges.iter().map(|&edge| ends(edge).map(stored)).collect(),
                });
            } else {
                self.faces.extend(element.face());
            }
        }
    }
}

/// The faces at any vertex that is marked, ascending, while they are at most `most`.
///
/// *Cost*: linear in the corners.
pub(crate) fn faces_near(report: &CheckReport, most: usize) -> Vec<FaceId> {
    let mesh = &report.mesh;
    let mut is_near = vec![false; mesh.counts().vertices];
    let mut found = Found::default();
    for kind in report.listed_kinds() {
        report.defects_of_kind(kind).take(MOST_DRAWN).for_each(|defect| {
            if let Element::Strip(strip) = &defect.at {
                found.faces.extend(&strip.faces);
            }
            found.add(report, &defect);
        });
    }
    let of_faces = found.faces.iter().flat_map(|&face| mesh.faces().face_vertices(face));
    let marked = found.vertices.iter().chain(found.edges.iter().flatten()).chain(of_faces);
    for vertex in marked {
        if let Some(near) = is_near.get_mut(vertex.0 as usize) {
            *near = true;
        }
    }
    let at_mark = |face: &FaceId| mesh.faces().face_vertices(*face).iter().any(|v| is_near[v.0 as usize]);
    mesh.faces().faces().filter(at_mark).take(most).collect()
}
