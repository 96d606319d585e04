//! Lists that are cut to a limit, and defects with the points at which they are.

use meshmend_core::{Defect, PolygonMesh, VertexId};
use serde::Serialize;

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

fn vertices(defect: &Defect, mesh: &PolygonMesh) -> Vec<VertexId> {
    match defect {
        Defect::DegenerateFace { face }
        | Defect::NonSimpleFace { face, .. }
        | Defect::RepeatedCorner { face, .. }
        | Defect::DuplicateFace { face, .. }
        | Defect::OppositeFace { face, .. }
        | Defect::PolygonFace { face, .. }
        | Defect::NonFiniteFace { face, .. } => {
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
