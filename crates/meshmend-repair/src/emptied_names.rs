//! Groups, objects and materials of which a repair left nothing.

use std::collections::BTreeMap;
use std::fmt;

use meshmend_core::{DefectKind, Domain, Layer, PolygonMesh, Values};

use crate::Repaired;

/// The layers whose names stand for parts of a mesh.
const NAMED: [&str; 5] = ["object", "group", "material", "solid", "part"];

/// A name that elements had as stored, and no element of the result has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmptiedName {
    /// What it names: `object`, `group`, `material`, `solid` or `part`.
    pub layer: String,
    /// The name, as bytes: files need not be UTF-8.
    pub name: Vec<u8>,
    /// How many faces had it.
    pub faces: u64,
    /// How many of these went for each reason.
    pub by_reason: BTreeMap<DefectKind, u64>,
    /// How many loose edges had it.
    pub loose_edges: u64,
    /// How many loose points had it.
    pub loose_points: u64,
}

/// The names that lost all their elements in a repair, by layer and in the order of its pool.
///
/// *Cost*: constant if no element went; else linear in the elements, and a sort of the names.
pub fn emptied_names(stored: &PolygonMesh, repaired: &Repaired) -> Vec<EmptiedName> {
    let lost_edges = stored.loose_edges().len() > repaired.mesh.loose_edges().len();
    let lost_points = stored.loose_points().len() > repaired.mesh.loose_points().len();
    if repaired.removed_faces.is_empty() && !lost_edges && !lost_points {
        return Vec::new();
    }
    NAMED.iter().flat_map(|kind| emptied_of(kind, stored, repaired)).collect()
}

/// What became of the elements of one name.
#[derive(Default)]
struct Fate {
    emptied: Option<EmptiedName>,
    is_left: bool,
}

fn emptied_of(kind: &str, stored: &PolygonMesh, repaired: &Repaired) -> Vec<EmptiedName> {
    let mut fates: BTreeMap<&[u8], Fate> = BTreeMap::new();
    let mut order: Vec<&[u8]> = Vec::new();
    let mut note = |name, element: Element| {
        let fate = fates.entry(name).or_default();
        match element {
            Element::Left => fate.is_left = true,
            gone => {
                let emptied = fate.emptied.get_or_insert_with(|| {
                    order.push(name);
                    EmptiedName::none_of(kind, name)
                });
                emptied.count(gone);
            }
        }
    };
    if let Some((layer, names)) = names_of(stored, kind, Domain::Face) {
        let mut removed = repaired.removed_faces.iter().peekable();
        for face in stored.faces().faces() {
            let gone = removed.next_if(|removed| removed.face == face);
            let element = gone.map_or(Element::Left, |removed| Element::Face(removed.reason));
            layer.value_of(face.0 as usize).into_iter().for_each(|value| note(&names[value], element));
        }
    }
    for (domain, gone, is_gone) in [
        (Domain::LooseEdge, Element::Edge, repaired.mesh.loose_edges().is_empty()),
        (Domain::LoosePoint, Element::Point, repaired.mesh.loose_points().is_empty()),
    ] {
        let Some((layer, names)) = names_of(stored, kind, domain) else { continue };
        let element = if is_gone { gone } else { Element::Left };
        let values = (0..layer.element_count()).filter_map(|at| layer.value_of(at));
        values.for_each(|value| note(&names[value], element));
    }
    let emptied = |name| fates.remove(name).filter(|fate| !fate.is_left)?.emptied;
    order.into_iter().filter_map(emptied).collect()
}

/// What became of one element.
#[derive(Clone, Copy)]
enum Element {
    Left,
    Face(DefectKind),
    Edge,
    Point,
}

fn names_of<'a>(mesh: &'a PolygonMesh, kind: &str, domain: Domain) -> Option<(&'a Layer, &'a [Vec<u8>])> {
    let layer = mesh.layer(kind, domain)?;
    match layer.values() {
        Values::Text(names) if layer.width() == 1 => Some((layer, names)),
        _ => None,
    }
}

impl EmptiedName {
    fn none_of(kind: &str, name: &[u8]) -> Self {
        let (layer, name) = (kind.to_owned(), name.to_vec());
        EmptiedName { layer, name, faces: 0, by_reason: BTreeMap::new(), loose_edges: 0, loose_points: 0 }
    }

    fn count(&mut self, element: Element) {
        match element {
            Element::Left => {}
            Element::Face(reason) => {
                self.faces += 1;
                *self.by_reason.entry(reason).or_default() += 1;
            }
            Element::Edge => self.loose_edges += 1,
            Element::Point => self.loose_points += 1,
        }
    }
}

impl fmt::Display for EmptiedName {
    /// ``material `red` has no face left: its 6 faces repeated others``.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = String::from_utf8_lossy(&self.name);
        let what = if self.faces > 0 { "face" } else { "element" };
        write!(f, "{} `{name}` has no {what} left: ", self.layer)?;
        let mut causes: Vec<String> = Vec::new();
        let of =
            |count: u64, one: &str| if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") };
        for (&reason, &count) in &self.by_reason {
            causes.push(format!("{} {}", of(count, "face"), went(reason, count)));
        }
        for (count, one) in [(self.loose_edges, "loose edge"), (self.loose_points, "loose point")] {
            let were = if count == 1 { "was" } else { "were" };
            causes.extend((count > 0).then(|| format!("{} {were} removed", of(count, one))));
        }
        match causes.as_slice() {
            [only] => write!(f, "its {only}"),
            _ => write!(f, "{}", causes.join(", ")),
        }
    }
}

/// Why faces went, as the end of a sentence.
fn went(reason: DefectKind, count: u64) -> &'static str {
    match (reason, count) {
        (DefectKind::DegenerateFace, 1) => "was degenerate",
        (DefectKind::DegenerateFace, _) => "were degenerate",
        (DefectKind::DuplicateFace, 1) => "repeated another",
        (DefectKind::DuplicateFace, _) => "repeated others",
        (DefectKind::DifferingFace, 1) => "repeated another that differs from it",
        (DefectKind::DifferingFace, _) => "repeated others that differ from them",
        (DefectKind::OppositeFace, 1) => "repeated another the other way round",
        (DefectKind::OppositeFace, _) => "repeated others the other way round",
        (DefectKind::NonFiniteFace, 1) => "had a corner that is not finite",
        (DefectKind::NonFiniteFace, _) => "had corners that are not finite",
        (_, 1) => "was removed",
        (_, _) => "were removed",
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, FaceTable, NO_VALUE, VertexId};

    use super::*;
    use crate::Pipeline;

    /// Names of the faces and of the loose edge; triangles over four points of a tetrahedron.
    fn emptied(faces: &[[u32; 3]], names: &[Option<u32>], edge: Option<u32>) -> Vec<String> {
        let corners = faces.iter().flatten().copied().map(VertexId).collect();
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [f64::NAN; 3]];
        let mesh = PolygonMesh::new(points, FaceTable::triangles(5, corners).unwrap()).unwrap();
        let mesh = mesh.with_loose(vec![[VertexId(0), VertexId(1)]], Vec::new()).unwrap();
        let pool = Values::Text([&b"a"[..], b"b", b"a", b"c"].map(<[u8]>::to_vec).to_vec());
        let layer = |domain, uses: &[Option<u32>]| {
            let uses = uses.iter().map(|value| value.unwrap_or(NO_VALUE)).collect();
            Layer::indexed("material", domain, 1, Carry::Copy, pool.clone(), uses)
        };
        let layers = vec![layer(Domain::Face, names), layer(Domain::LooseEdge, &[edge])];
        let mesh = mesh.with_layers(layers).unwrap();
        let repaired = Pipeline::default().run(&mesh).unwrap();
        emptied_names(&mesh, &repaired).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_name_that_lost_all_its_elements_is_told_with_what_became_of_them() {
        let line = "material `c` has no element left: its 1 loose edge was removed";
        let none: [&str; 0] = [];
        // Two values are one name, and one face of it is left.
        assert_eq!(emptied(&[[0, 1, 2], [1, 1, 2]], &[Some(0), Some(2)], None), none);
        assert_eq!(emptied(&[[0, 1, 2]], &[None], Some(3)), [line]);
        let gone = emptied(&[[0, 1, 2], [1, 1, 2]], &[Some(0), Some(1)], Some(0));
        assert_eq!(gone, ["material `b` has no face left: its 1 face was degenerate"]);
        let gone = emptied(
            &[[0, 1, 2], [1, 1, 2], [3, 3, 1], [0, 1, 4], [0, 2, 4]],
            &[Some(0), Some(1), Some(1), Some(1), Some(3)],
            Some(3),
        );
        let expected = [
            "material `b` has no face left: 2 faces were degenerate, 1 face had a corner that is not finite",
            "material `c` has no face left: 1 face had a corner that is not finite, 1 loose edge was removed",
        ];
        assert_eq!(gone, expected);
    }
}
