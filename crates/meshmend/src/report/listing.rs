//! Lists that are cut to a limit, and defects with the points at which they are.

use meshmend_core::{Defect, PolygonMesh, VertexId};
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
    /// The ends of each edge that the defect names by id alone: of those that a strip crosses.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edge_ends: Vec<[VertexId; 2]>,
}

impl PlacedDefect {
    /// The defect of a mesh with its place in that mesh.
    pub fn new(defect: Defect, mesh: &PolygonMesh) -> Self {
        let vertices: Vec<VertexId> = vertices(&defect, mesh);
        PlacedDefect {
            positions: vertices.iter().map(|&vertex| mesh.position(vertex)).collect(),
            vertices,
            edge_ends: match &defect {
                Defect::NonOrientablePatch { edges, .. } => {
                    edges.iter().map(|&edge| mesh.complex().edges().ends(edge)).collect()
                }
                _ => Vec::new(),
            },
            defect,
        }
    }
}

impl PlacedDefect {
    /// The defect with the numbers that its vertices have as stored.
    pub(crate) fn named_as_stored(mut self, report: &CheckReport) -> Self {
        let name = |vertex: VertexId| report.stored_vertex(vertex);
        self.vertices.iter_mut().for_each(|vertex| *vertex = name(*vertex));
        self.edge_ends.iter_mut().for_each(|ends| *ends = ends.map(name));
        PlacedDefect { defect: self.defect.with_vertices(name), ..self }
    }
}

fn vertices(defect: &Defect, mesh: &PolygonMesh) -> Vec<VertexId> {
    match defect {
        Defect::DegenerateFace { face }
        | Defect::NonSimpleFace { face, .. }
        | Defect::FaceWithHole { face, .. }
        | Defect::CrossingFace { face, .. }
        | Defect::RepeatedCorner { face, .. }
        | Defect::DuplicateFace { face, .. }
        | Defect::OppositeFace { face, .. }
        | Defect::DifferingFace { face, .. }
        | Defect::PolygonFace { face, .. }
        | Defect::NonFiniteFace { face, .. }
        | Defect::UnjudgedPatch { face, .. }
        | Defect::TurnedCavity { face, .. } => {
            mesh.faces().face_vertices(*face).iter().copied().take(MOST_POSITIONS).collect()
        }
        Defect::BoundaryEdge { ends, .. }
        | Defect::NonManifoldEdge { ends, .. }
        | Defect::InconsistentEdge { ends, .. }
        | Defect::SeamEdge { ends, .. }
        | Defect::CoincidentEdges { ends }
        | Defect::LooseEdge { ends, .. } => ends.to_vec(),
        Defect::CoincidentVertex { vertex, original } => vec![*vertex, *original],
        Defect::PinchedVertex { vertex, .. }
        | Defect::SingularVertex { vertex }
        | Defect::NonFiniteVertex { vertex }
        | Defect::UnreferencedVertex { vertex }
        | Defect::LoosePoint { vertex, .. } => vec![*vertex],
        Defect::NonOrientablePatch { faces, .. } => {
            let firsts = faces.iter().filter_map(|&face| mesh.faces().face_vertices(face).first().copied());
            firsts.take(MOST_POSITIONS).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use meshmend_core::{DefectKind, Differences, EdgeId, FaceId, FaceTable, PolygonMesh, Unjudged};

    use super::*;

    #[test]
    fn every_defect_is_where_its_vertices_are() {
        let positions: Vec<[f64; 3]> = (0..6).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let corners = [0, 1, 2, 3, 4, 5].map(VertexId).to_vec();
        let mesh = PolygonMesh::new(positions, FaceTable::triangles(6, corners).unwrap()).unwrap();
        let (face, edge, original, vertex) = (FaceId(1), EdgeId(0), VertexId(0), VertexId(4));
        let (whole_face, ends) = (vec![3, 4, 5], [VertexId(1), VertexId(2)]);
        let pinched = Defect::PinchedVertex { vertex, umbrellas: 2, boundary_only: true };
        let strip = Defect::NonOrientablePatch { faces: vec![FaceId(0), face], edges: vec![edge] };
        let cases = [
            (Defect::DegenerateFace { face }, whole_face.clone()),
            (Defect::NonSimpleFace { face, vertex }, whole_face.clone()),
            (Defect::FaceWithHole { face, vertex }, whole_face.clone()),
            (Defect::CrossingFace { face, vertex }, whole_face.clone()),
            (Defect::RepeatedCorner { face, vertex }, whole_face.clone()),
            (Defect::DuplicateFace { face, original: FaceId(0) }, whole_face.clone()),
            (Defect::OppositeFace { face, original: FaceId(0) }, whole_face.clone()),
            (
                Defect::DifferingFace { face, original: FaceId(0), differs: Differences::default() },
                whole_face.clone(),
            ),
            (Defect::PolygonFace { face, corners: 4 }, whole_face.clone()),
            (Defect::UnjudgedPatch { face, faces: 1, reason: Unjudged::Open }, whole_face.clone()),
            (Defect::TurnedCavity { face, faces: 1 }, whole_face.clone()),
            (Defect::NonFiniteFace { face, vertex }, whole_face),
            (Defect::BoundaryEdge { edge, ends }, vec![1, 2]),
            (Defect::NonManifoldEdge { edge, ends, degree: 3 }, vec![1, 2]),
            (Defect::InconsistentEdge { edge, ends }, vec![1, 2]),
            (Defect::SeamEdge { edge, ends }, vec![1, 2]),
            (Defect::CoincidentEdges { ends }, vec![1, 2]),
            (Defect::LooseEdge { index: 0, ends }, vec![1, 2]),
            (Defect::CoincidentVertex { vertex, original }, vec![4, 0]),
            (pinched, vec![4]),
            (Defect::SingularVertex { vertex }, vec![4]),
            (Defect::NonFiniteVertex { vertex }, vec![4]),
            (Defect::UnreferencedVertex { vertex }, vec![4]),
            (Defect::LoosePoint { index: 0, vertex }, vec![4]),
            (strip, vec![0, 3]),
        ];
        let kinds: BTreeSet<DefectKind> = cases.iter().map(|(defect, _)| defect.kind()).collect();
        assert_eq!(kinds.len(), DefectKind::ALL.len());
        for (defect, expected) in cases {
            let placed = PlacedDefect::new(defect, &mesh);
            assert_eq!(placed.vertices.iter().map(|v| v.0).collect::<Vec<_>>(), expected, "{placed:?}");
            let at: Vec<[f64; 3]> = expected.iter().map(|&v| [f64::from(v), 0.0, 0.0]).collect();
            assert_eq!(placed.positions, at);
            let crosses_edges = placed.defect.kind() == DefectKind::NonOrientablePatch;
            assert_eq!(placed.edge_ends.len(), usize::from(crosses_edges));
        }
    }
}
