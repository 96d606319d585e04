//! A face with a corner whose position is not finite.

use super::{Defect, DefectKind, Defects, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, PolygonMesh, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "non-finite-face",
    title: "faces with non-finite corners",
    severity: Severity::Defect,
    explanation: "A corner's position is infinite or no number, so the face has no shape. `clean` drops it unless \
        `--non-finite` says `keep` or `fail`.",
    found: Found::InMesh(find),
    listed: Listed::AlreadyBy(DefectKind::NonFiniteVertex),
    counts: None,
    sentence: "{face} uses {vertex}, which is not finite",
};

impl Defect {
    /// A face with a corner whose position is not finite.
    pub fn non_finite_face(face: FaceId, vertex: VertexId) -> Self {
        Defect::new(DefectKind::NonFiniteFace, Element::Corner { face, vertex })
    }
}

fn find(mesh: &PolygonMesh) -> Defects<'_> {
    let faces = mesh.faces();
    Box::new(faces.faces().filter_map(move |face| {
        let vertex = *faces.face_vertices(face).iter().find(|&&vertex| !mesh.is_finite(vertex))?;
        Some(Defect::non_finite_face(face, vertex))
    }))
}
