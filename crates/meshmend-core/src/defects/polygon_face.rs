//! A face with more than three corners.

use super::{Defect, DefectKind, Defects, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, PolygonMesh};

pub(super) const RULE: Rule = Rule {
    code: "polygon-face",
    title: "faces with more than three corners",
    severity: Severity::Note,
    explanation: "Only a kernel for triangles minds. `triangulate` with `all` cuts polygons into triangles.",
    found: Found::InMesh(find),
    listed: Listed::OnRequest,
    counts: Some("corners"),
    sentence: "{at} has {count} corners",
};

impl Defect {
    /// A face with more than three corners.
    pub fn polygon_face(face: FaceId, corners: u32) -> Self {
        Defect::new(DefectKind::PolygonFace, Element::Face(face)).counting(corners)
    }
}

fn find(mesh: &PolygonMesh) -> Defects<'_> {
    let faces = mesh.complex().faces();
    let corners = move |face: FaceId| faces.corner_range(face).len() as u32;
    let polygons = faces.faces().filter(move |&face| corners(face) > 3);
    Box::new(polygons.map(move |face| Defect::polygon_face(face, corners(face))))
}
