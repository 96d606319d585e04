//! What a defect says of itself.

use std::fmt;

use super::{Defect, DefectKind, Detail, Element, Unjudged};
use crate::{EdgeId, FaceId, VertexId, counted};

impl Defect {
    /// A defect of a kind at an element.
    pub fn new(kind: DefectKind, at: Element) -> Self {
        Defect { kind, at, beside: None, count: 0, detail: Detail::None }
    }

    /// The defect beside another element.
    #[must_use]
    pub fn beside(self, element: Element) -> Self {
        Defect { beside: Some(element), ..self }
    }

    /// The defect with how many there are of what its kind counts.
    #[must_use]
    pub fn counting(self, count: u32) -> Self {
        Defect { count, ..self }
    }

    pub(super) fn with(self, detail: Detail) -> Self {
        Defect { detail, ..self }
    }

    /// What kind of defect this is.
    pub fn kind(&self) -> DefectKind {
        self.kind
    }

    /// The defect with other names for its vertices: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_vertices(self, name: impl Fn(VertexId) -> VertexId) -> Self {
        let beside = self.beside.map(|element| element.with_vertices(&name));
        Defect { at: self.at.with_vertices(name), beside, ..self }
    }

    /// The defect with other names for its faces: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_faces(self, name: impl Fn(FaceId) -> FaceId) -> Self {
        let beside = self.beside.map(|element| element.with_faces(&name));
        Defect { at: self.at.with_faces(name), beside, ..self }
    }

    /// The defect with other names for its edges: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_edges(self, name: impl Fn(EdgeId) -> EdgeId) -> Self {
        let beside = self.beside.map(|element| element.with_edges(&name));
        Defect { at: self.at.with_edges(name), beside, ..self }
    }

    /// What a place holder in a rule's sentence stands for; `None` if it stands for nothing that the defect has.
    fn word(&self, name: &str) -> Option<String> {
        match name {
            "at" => Some(self.at.to_string()),
            "beside" => self.beside.as_ref().map(ToString::to_string),
            "face" => self.at.face().map(|face| face.to_string()),
            "vertex" => self.at.vertex().map(|vertex| vertex.to_string()),
            "ends" => self.at.ends().map(|[a, b]| format!("{a}-{b}")),
            "count" => Some(self.count.to_string()),
            "faces" => Some(counted(self.count, "face")),
            "detail" => Some(self.detail.to_string()),
            _ => None,
        }
    }
}

/// The sentence of the kind's rule, about this defect.
impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.kind.rule().sentence;
        while let Some((text, (name, after))) =
            rest.split_once('{').and_then(|(text, after)| Some((text, after.split_once('}')?)))
        {
            f.write_str(text)?;
            f.write_str(&self.word(name).unwrap_or_else(|| format!("{{{name}}}")))?;
            rest = after;
        }
        f.write_str(rest)
    }
}

impl fmt::Display for Detail {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Detail::None | Detail::BoundaryOnly(false) => Ok(()),
            Detail::BoundaryOnly(true) => f.write_str(", all open"),
            Detail::Differs(differs) => write!(f, "{differs}"),
            Detail::Lies(lie) => f.write_str(lie.name()),
            Detail::Unjudged(Unjudged::Open) => f.write_str("is open"),
            Detail::Unjudged(Unjudged::NoVolume) => f.write_str("encloses no volume"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_defect_is_small_as_there_can_be_millions() {
        assert!(size_of::<Defect>() <= 56, "{}", size_of::<Defect>());
    }

    #[test]
    fn other_names_are_given_to_all_vertices() {
        let far = |vertex: VertexId| VertexId(vertex.0 + 10);
        let joined = Defect::coincident_vertex(VertexId(1), VertexId(0)).with_vertices(far);
        assert_eq!(joined, Defect::coincident_vertex(VertexId(11), VertexId(10)));
        let corner = Defect::non_simple_face(FaceId(1), VertexId(2)).with_vertices(far);
        assert_eq!(corner, Defect::non_simple_face(FaceId(1), VertexId(12)));
    }

    #[test]
    fn other_names_are_given_to_all_faces() {
        let far = |face: FaceId| FaceId(face.0 + 10);
        let twin = Defect::duplicate_face(FaceId(1), FaceId(0)).with_faces(far);
        assert_eq!(twin, Defect::duplicate_face(FaceId(11), FaceId(10)));
        let strip = |at| Defect::non_orientable_patch(vec![FaceId(at), FaceId(at + 1)], Vec::new());
        assert_eq!(strip(0).with_faces(far), strip(10));
    }

    #[test]
    fn other_names_are_given_to_all_edges() {
        let far = |edge: EdgeId| EdgeId(edge.0 + 10);
        let open = |at| Defect::boundary_edge(EdgeId(at), [VertexId(0), VertexId(1)]);
        assert_eq!(open(1).with_edges(far), open(11));
        let strip = |at| Defect::non_orientable_patch(vec![FaceId(0)], vec![EdgeId(at), EdgeId(at + 1)]);
        assert_eq!(strip(0).with_edges(far), strip(10));
    }
}
