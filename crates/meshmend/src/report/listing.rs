//! Lists that are cut to a limit, and defects with the points at which they are.

use meshmend_core::{Defect, Element, FaceId, PolygonMesh, VertexId};
use meshmend_external::Excerpt;
use serde::Serialize;

use crate::CheckReport;

/// How many of a defect's vertices are given with their positions at most. Few faces have more corners.
pub const MOST_POSITIONS: usize = 16;

/// How many there are, and the first of them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Listing<T> {
    /// How many there are in all.
    pub count: u64,
    /// The first of them, as many as the limit allows.
    pub items: Vec<T>,
}

impl<T> Default for Listing<T> {
    fn default() -> Self {
        Listing { count: 0, items: Vec::new() }
    }
}

impl<T> Listing<T> {
    /// The first `limit` of some things, and the number of all of them.
    pub fn cut(things: impl ExactSizeIterator<Item = T>, limit: usize) -> Self {
        Listing { count: things.len() as u64, items: things.take(limit).collect() }
    }

    /// Counts one more thing, and keeps it while there is room.
    pub(crate) fn add(&mut self, limit: usize, thing: impl FnOnce() -> T) {
        self.count += 1;
        if self.items.len() < limit {
            self.items.push(thing());
        }
    }
}

/// A defect with its place in space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlacedDefect {
    /// The defect, by ids.
    #[serde(flatten)]
    pub defect: Defect,
    /// The vertices of the element, at most [`MOST_POSITIONS`]; for a strip of faces the first one of each face.
    pub vertices: Vec<VertexId>,
    /// Where those are.
    pub positions: Vec<[f64; 3]>,
    /// The faces along an edge or round a vertex; absent for other elements.
    #[serde(flatten)]
    pub round: Option<FacesRound>,
    /// The ends of each edge that the defect names by id alone: of those that a strip crosses.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edge_ends: Vec<[VertexId; 2]>,
}

/// The faces along an edge or round a vertex. A face that runs along the edge twice is one face.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FacesRound {
    /// How many there are in all.
    pub face_count: u64,
    /// The first of them by id, as many as the limit allows.
    pub faces: Vec<FaceId>,
}

impl PlacedDefect {
    /// The defect of a mesh with its place in that mesh, and at most `limit` of the faces round it.
    ///
    /// *Cost*: that of [`faces_round`](meshmend_core::Element::faces_round).
    pub fn new(defect: Defect, mesh: &PolygonMesh, limit: usize) -> Self {
        let vertices: Vec<VertexId> = defect.vertices(mesh, MOST_POSITIONS);
        let crossed = match &defect.at {
            Element::Strip(strip) => strip.edges.as_slice(),
            _ => &[],
        };
        PlacedDefect {
            positions: vertices.iter().map(|&vertex| mesh.position(vertex)).collect(),
            vertices,
            round: defect.at.faces_round(mesh).map(|faces| FacesRound::cut(faces, limit)),
            edge_ends: crossed.iter().map(|&edge| mesh.complex().edges().ends(edge)).collect(),
            defect,
        }
    }

    /// A defect that a check found with its place, as [`CheckDocument`](super::CheckDocument) lists it.
    ///
    /// *Cost*: that of [`faces_round`](meshmend_core::Element::faces_round).
    pub fn of_report(defect: Defect, report: &CheckReport, limit: usize) -> Self {
        let placed = PlacedDefect::new(defect, &report.mesh, limit);
        placed.named(|vertex| report.stored_vertex(vertex), |face| report.stored_face(face))
    }

    /// A defect of an excerpt with its place, as [`CheckDocument`](super::CheckDocument) lists it.
    ///
    /// *Cost*: that of [`faces_round`](meshmend_core::Element::faces_round).
    pub(super) fn of_excerpt(defect: Defect, excerpt: &Excerpt, limit: usize) -> Self {
        let placed = PlacedDefect::new(defect, &excerpt.mesh, limit);
        let placed = placed.named(|vertex| excerpt.stored_vertex(vertex), |face| excerpt.stored_face(face));
        PlacedDefect { defect: placed.defect.with_edges(|edge| excerpt.whole_edge(edge)), ..placed }
    }

    /// The defect with other numbers for its vertices and faces: those as stored.
    fn named(
        mut self,
        vertex_name: impl Fn(VertexId) -> VertexId,
        face_name: impl Fn(FaceId) -> FaceId,
    ) -> Self {
        self.vertices.iter_mut().for_each(|vertex| *vertex = vertex_name(*vertex));
        self.edge_ends.iter_mut().for_each(|ends| *ends = ends.map(&vertex_name));
        self.round.iter_mut().flat_map(|round| &mut round.faces).for_each(|face| *face = face_name(*face));
        PlacedDefect { defect: self.defect.with_vertices(vertex_name).with_faces(face_name), ..self }
    }
}

impl FacesRound {
    fn cut(mut faces: Vec<FaceId>, limit: usize) -> Self {
        let face_count = faces.len() as u64;
        faces.truncate(limit);
        FacesRound { face_count, faces }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{DefectKind, Differences, EdgeId, FaceTable, Lie, Unjudged};

    use super::*;

    fn mesh() -> PolygonMesh {
        let positions: Vec<[f64; 3]> = (0..6).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let corners = [0, 1, 2, 3, 4, 5].map(VertexId).to_vec();
        PolygonMesh::new(positions, FaceTable::triangles(6, corners).unwrap()).unwrap()
    }

    /// A defect of each kind, with the vertices at which it is.
    fn cases() -> Vec<(Defect, Vec<u32>)> {
        let (face, edge, original, vertex) = (FaceId(1), EdgeId(0), VertexId(0), VertexId(4));
        let (whole_face, ends) = (vec![3, 4, 5], [VertexId(1), VertexId(2)]);
        let strip = Defect::non_orientable_patch(vec![FaceId(0), face], vec![edge]);
        vec![
            (Defect::degenerate_face(face), whole_face.clone()),
            (Defect::non_simple_face(face, vertex), whole_face.clone()),
            (Defect::face_with_hole(face, vertex), whole_face.clone()),
            (Defect::crossing_face(face, vertex), whole_face.clone()),
            (Defect::repeated_corner(face, vertex), whole_face.clone()),
            (Defect::duplicate_face(face, FaceId(0)), whole_face.clone()),
            (Defect::opposite_face(face, FaceId(0)), whole_face.clone()),
            (Defect::differing_face(face, FaceId(0), Differences::default()), whole_face.clone()),
            (Defect::polygon_face(face, 4), whole_face.clone()),
            (Defect::unjudged_patch(face, 1, Unjudged::Open), whole_face.clone()),
            (Defect::turned_cavity(face, 1), whole_face.clone()),
            (Defect::crossing_faces(face, FaceId(2), Lie::Overlapping), whole_face.clone()),
            (Defect::coincident_faces(face, FaceId(0)), whole_face.clone()),
            (Defect::touching_faces(face, FaceId(2), Lie::EdgeFace), whole_face.clone()),
            (Defect::self_crossing_face(face), whole_face.clone()),
            (Defect::internal_face(face), whole_face.clone()),
            (Defect::internal_component(face, 1), whole_face.clone()),
            (Defect::zero_area_face(face), whole_face.clone()),
            (Defect::sliver_face(face, Lie::Cap), whole_face.clone()),
            (Defect::t_junction(vertex, edge, ends, true), vec![4]),
            (Defect::inside_out_component(face, 1), whole_face.clone()),
            (Defect::solid_within(face, 1), whole_face.clone()),
            (Defect::no_volume(face, 1), whole_face.clone()),
            (Defect::undecided_component(face, 1), whole_face.clone()),
            (Defect::small_component(face, 1), whole_face.clone()),
            (Defect::non_finite_face(face, vertex), whole_face),
            (Defect::boundary_edge(edge, ends), vec![1, 2]),
            (Defect::non_manifold_edge(edge, ends, 3), vec![1, 2]),
            (Defect::inconsistent_edge(edge, ends), vec![1, 2]),
            (Defect::seam_edge(edge, ends), vec![1, 2]),
            (Defect::coincident_edges(ends), vec![1, 2]),
            (Defect::loose_edge(0, ends), vec![1, 2]),
            (Defect::coincident_vertex(vertex, original), vec![4, 0]),
            (Defect::pinched_vertex(vertex, 2, true), vec![4]),
            (Defect::singular_vertex(vertex), vec![4]),
            (Defect::non_finite_vertex(vertex), vec![4]),
            (Defect::unreferenced_vertex(vertex), vec![4]),
            (Defect::loose_point(0, vertex), vec![4]),
            (strip, vec![0, 3]),
        ]
    }

    #[test]
    fn every_defect_is_where_its_vertices_are() {
        let (mesh, cases) = (mesh(), cases());
        for (defect, expected) in cases {
            let placed = PlacedDefect::new(defect, &mesh, 1);
            assert_eq!(placed.vertices.iter().map(|v| v.0).collect::<Vec<_>>(), expected, "{placed:?}");
            let at: Vec<[f64; 3]> = expected.iter().map(|&v| [f64::from(v), 0.0, 0.0]).collect();
            assert_eq!(placed.positions, at);
            let is_surrounded = matches!(placed.defect.at, Element::Vertex(_) | Element::Edge { .. });
            assert_eq!(placed.round.is_some(), is_surrounded, "{placed:?}");
            let crosses_edges = placed.defect.kind() == DefectKind::NonOrientablePatch;
            assert_eq!(placed.edge_ends.len(), usize::from(crosses_edges));
        }
    }

    /// What is said of the keys in `docs/json.md`, as a row for each kind.
    #[test]
    fn the_page_on_the_form_names_the_keys_of_every_kind() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/json.md");
        let Ok(page) = std::fs::read_to_string(path) else {
            println!("skipped: there is no {path}");
            return;
        };
        let common = ["kind", "element", "message", "vertices", "positions"];
        let rows = cases().into_iter().map(|(defect, _)| {
            let item = serde_json::to_value(PlacedDefect::new(defect, &mesh(), 1)).unwrap();
            let keys = item.as_object().unwrap().keys().filter(|key| !common.contains(&key.as_str()));
            let keys: Vec<String> = keys.map(|key| format!("`{key}`")).collect();
            format!("| {} | {} |", item["kind"].as_str().unwrap(), keys.join(", "))
        });
        let missing: Vec<String> = rows.filter(|row| !page.contains(row)).collect();
        assert!(missing.is_empty(), "{}", missing.join("\n"));
    }
}
