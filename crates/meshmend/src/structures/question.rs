//! What structures are asked when they are compared.

use meshmend_core::{Adjacency, Connectivity, Cost, Costs, EdgeId, Id, Incidence, PolygonMesh, VertexId};
use meshmend_topology::{boundary_loops, components, orientability, patches, topology};
use serde::Serialize;

/// What a structure is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum KernelQuestion {
    /// To be built, with the table of edges if it needs that one.
    Build,
    /// For the vertices to which the sides run that begin at each vertex.
    OneRings,
    /// For the different neighbours of each vertex.
    VertexNeighbours,
    /// For the corners of each face, and the face across each side.
    FaceWalk,
    /// For the two ends of each edge, and the faces along it.
    EdgeWalk,
    /// For the boundary loops.
    BoundaryWalk,
    /// For the components.
    Components,
    /// For the patches, and whether each can be oriented.
    Orientation,
    /// For the whole report on topology.
    Report,
}

/// How much a structure can say, from least to most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rung {
    /// Nothing, before something is made of it: faces that share no vertex.
    None,
    /// Which vertices are joined.
    Adjacency,
    /// Which vertices, edges and faces touch, as sets.
    Incidence,
    /// Everything, corner by corner.
    Connectivity,
}

impl KernelQuestion {
    /// Every question, in the order in which it is asked.
    pub const ALL: [Self; 9] = [
        KernelQuestion::Build,
        KernelQuestion::OneRings,
        KernelQuestion::VertexNeighbours,
        KernelQuestion::FaceWalk,
        KernelQuestion::EdgeWalk,
        KernelQuestion::BoundaryWalk,
        KernelQuestion::Components,
        KernelQuestion::Orientation,
        KernelQuestion::Report,
    ];

    /// What it is called in reports, such as `one-rings`.
    pub fn name(self) -> &'static str {
        match self {
            KernelQuestion::Build => "build",
            KernelQuestion::OneRings => "one-rings",
            KernelQuestion::VertexNeighbours => "vertex-neighbours",
            KernelQuestion::FaceWalk => "face-walk",
            KernelQuestion::EdgeWalk => "edge-walk",
            KernelQuestion::BoundaryWalk => "boundary-walk",
            KernelQuestion::Components => "components",
            KernelQuestion::Orientation => "orientation",
            KernelQuestion::Report => "report",
        }
    }

    /// The least rung that can answer it.
    pub fn rung(self) -> Rung {
        match self {
            KernelQuestion::Build => Rung::None,
            KernelQuestion::VertexNeighbours => Rung::Adjacency,
            KernelQuestion::EdgeWalk => Rung::Incidence,
            _ => Rung::Connectivity,
        }
    }

    /// Whether a kernel of these costs needs time in proportion to the square of the mesh for it.
    pub fn is_quadratic(self, costs: &Costs) -> bool {
        let Costs { corner, face_star, edge_star, vertex_star, across } = *costs;
        let asked = match self {
            KernelQuestion::Build => return false,
            KernelQuestion::OneRings | KernelQuestion::VertexNeighbours => vec![corner, vertex_star],
            KernelQuestion::FaceWalk => vec![corner, face_star, across],
            KernelQuestion::EdgeWalk | KernelQuestion::BoundaryWalk => vec![corner, edge_star],
            KernelQuestion::Components => vec![corner, face_star, vertex_star],
            // The report groups the corners of a kernel that would search for those of each vertex.
            KernelQuestion::Orientation | KernelQuestion::Report => vec![corner, face_star, edge_star],
        };
        asked.contains(&Cost::Linear)
    }

    /// Asks a kernel, whose answer comes down to a number that is the same from every structure.
    ///
    /// *Cost*: what the question takes.
    pub fn ask<K: Connectivity>(self, kernel: &K, mesh: &PolygonMesh) -> u64 {
        match self {
            KernelQuestion::Build => kernel.edge_count() as u64,
            KernelQuestion::OneRings => one_rings(kernel),
            KernelQuestion::VertexNeighbours => vertex_neighbours(kernel),
            KernelQuestion::FaceWalk => face_walk(kernel),
            KernelQuestion::EdgeWalk => edge_walk(kernel),
            KernelQuestion::BoundaryWalk => boundary_loops(kernel).count() as u64,
            KernelQuestion::Components => components(kernel).count() as u64,
            KernelQuestion::Orientation => orientability(kernel, &patches(kernel)).one_sided.len() as u64,
            KernelQuestion::Report => topology(kernel, mesh).edges,
        }
    }
}

impl Rung {
    /// What it is called in reports, such as `incidence`.
    pub fn name(self) -> &'static str {
        match self {
            Rung::None => "none",
            Rung::Adjacency => "adjacency",
            Rung::Incidence => "incidence",
            Rung::Connectivity => "connectivity",
        }
    }

    /// What a structure of this rung lacks to answer more: `None` where nothing is lacking.
    pub fn lacks(self) -> Option<&'static str> {
        match self {
            Rung::None => Some("weld first"),
            Rung::Adjacency => Some("no faces"),
            Rung::Incidence => Some("no corners"),
            Rung::Connectivity => None,
        }
    }
}

/// The sum of the vertices to which the sides lead that begin at each vertex.
fn one_rings<K: Connectivity>(kernel: &K) -> u64 {
    let targets = |vertex| kernel.vertex_ring(vertex).map(|target| u64::from(target.0));
    kernel.vertices().flat_map(targets).fold(0, u64::wrapping_add)
}

/// The sum of the different neighbours of each vertex.
pub(super) fn vertex_neighbours<A: Adjacency>(graph: &A) -> u64 {
    let neighbours = |vertex| graph.neighbours(VertexId::new(vertex)).map(|other| u64::from(other.0));
    (0..graph.graph_counts()[0]).flat_map(neighbours).fold(0, u64::wrapping_add)
}

/// The sum of the ends of each edge, and of the faces along it.
pub(super) fn edge_walk<I: Incidence>(cells: &I) -> u64 {
    let around = |edge| {
        let ends = cells.ends(edge).into_iter().map(|end| u64::from(end.0));
        ends.chain(cells.faces_along(edge).map(|face| u64::from(face.0) + 1))
    };
    (0..cells.cell_counts()[1]).map(EdgeId::new).flat_map(around).fold(0, u64::wrapping_add)
}

/// The sum of the faces across each side of each face.
fn face_walk<K: Connectivity>(kernel: &K) -> u64 {
    let across = |corner| kernel.across(corner).map(|other| u64::from(kernel.corner_face(other).0) + 1);
    let neighbours = |face| kernel.face_corners(face).filter_map(across);
    kernel.faces().flat_map(neighbours).fold(0, u64::wrapping_add)
}
