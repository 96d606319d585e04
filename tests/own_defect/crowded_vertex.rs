//! A vertex with more corners than renderers like.

use meshmend_core::{
    Defect, DefectKind, Defects, Element, Found, Id, Listed, PolygonMesh, Rule, Severity, VertexId,
};

/// How many corners may be at a vertex.
const MOST: u32 = 12;

pub(crate) const RULE: Rule = Rule {
    code: "crowded-vertex",
    title: "crowded vertices",
    severity: Severity::Note,
    explanation: "More than twelve corners are at the vertex, so the faces round it are thin. Nothing mends it.",
    found: Found::InMesh(find),
    listed: Listed::Unasked,
    counts: Some("corners"),
    sentence: "{at} has {count} corners",
};

fn find(mesh: &PolygonMesh) -> Defects<'_> {
    let faces = mesh.complex().faces();
    let mut corners = vec![0; faces.vertex_count()];
    faces.corner_vertices().iter().for_each(|vertex| corners[vertex.index()] += 1);
    let crowded = corners.into_iter().enumerate().filter(|&(_, count)| count > MOST);
    Box::new(crowded.map(|(vertex, count)| {
        Defect::new(DefectKind::Own(&RULE), Element::Vertex(VertexId::new(vertex))).counting(count)
    }))
}
