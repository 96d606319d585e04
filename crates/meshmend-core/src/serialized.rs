//! The forms that go into JSON reports, with the feature `serde`. What is not written here is derived.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::{
    Aspect, CornerId, Defect, DefectKind, Detail, Differences, EdgeId, Element, FaceId, Id, Sources, VertexId,
};

macro_rules! as_numbers {
    ($($id:ident)*) => {
        $(impl Serialize for $id {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_u32(self.0)
            }
        })*
    };
}

as_numbers!(VertexId EdgeId FaceId CornerId);

impl<I: Id> Serialize for Sources<I> {
    // A list with the old index of each new element, `null` for a created one.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter().map(|(_, old)| old.map(|o| o.index())))
    }
}

impl Serialize for Differences {
    /// A list of names.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter().map(Aspect::name))
    }
}

impl Serialize for DefectKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.code())
    }
}

// One flat map: the kind, the keys of the element, what is beside it as a map of its own, the count under the name that
// the rule gives it, and the sentence as `message`.
impl Serialize for Defect {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("kind", &self.kind)?;
        serialize_element(&self.at, &mut map)?;
        if let Some(beside) = &self.beside {
            map.serialize_entry("beside", &Beside(beside))?;
        }
        if let Some(name) = self.kind.rule().counts {
            map.serialize_entry(name, &self.count)?;
        }
        match &self.detail {
            Detail::None => {}
            Detail::BoundaryOnly(answer) => map.serialize_entry("boundary_only", answer)?,
            Detail::Differs(differs) => map.serialize_entry("differs", differs)?,
            Detail::Unjudged(reason) => map.serialize_entry("reason", reason)?,
            Detail::Lies(lie) => map.serialize_entry("how", lie.name())?,
        }
        map.serialize_entry("message", &self.to_string())?;
        map.end()
    }
}

struct Beside<'a>(&'a Element);

impl Serialize for Beside<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        serialize_element(self.0, &mut map)?;
        map.end()
    }
}

/// Writes an element's keys into a map: what it is called, and its ids.
fn serialize_element<M: SerializeMap>(element: &Element, map: &mut M) -> Result<(), M::Error> {
    map.serialize_entry("element", element.name())?;
    match element {
        Element::Vertex(vertex) => map.serialize_entry("vertex", vertex),
        Element::Edge { edge, ends } => {
            map.serialize_entry("edge", edge)?;
            map.serialize_entry("ends", ends)
        }
        Element::Face(face) | Element::Patch(face) | Element::Component(face) => {
            map.serialize_entry("face", face)
        }
        Element::Corner { face, vertex } => {
            map.serialize_entry("face", face)?;
            map.serialize_entry("vertex", vertex)
        }
        Element::LooseEdge { index, ends } => {
            map.serialize_entry("index", index)?;
            map.serialize_entry("ends", ends)
        }
        Element::LoosePoint { index, vertex } => {
            map.serialize_entry("index", index)?;
            map.serialize_entry("vertex", vertex)
        }
        Element::Strip(strip) => {
            map.serialize_entry("faces", &strip.faces)?;
            map.serialize_entry("edges", &strip.edges)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_is_its_code() {
        for kind in DefectKind::ALL {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.code());
        }
    }

    #[test]
    fn differences_are_a_list_of_names() {
        let two: Differences = [Aspect::FaceColor, Aspect::Object].into_iter().collect();
        assert_eq!(serde_json::to_value(two).unwrap(), serde_json::json!(["object", "face color"]));
    }

    #[test]
    fn the_serialised_form_has_the_keys_of_its_element() {
        let ends = [VertexId(1), VertexId(4)];
        let edge = serde_json::to_value(Defect::non_manifold_edge(EdgeId(2), ends, 3)).unwrap();
        let message = "e2 v1-v4 has 3 sides";
        let expected = serde_json::json!({
            "kind": "non-manifold-edge", "element": "edge", "edge": 2, "ends": [1, 4], "degree": 3, "message": message,
        });
        assert_eq!(edge, expected);
        let repeat = serde_json::to_value(Defect::duplicate_face(FaceId(3), FaceId(0))).unwrap();
        assert_eq!(repeat["beside"], serde_json::json!({"element": "face", "face": 0}));
    }
}
