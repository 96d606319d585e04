//! The discs of a mesh as triangles that all run the same way round, and the rim of each.

use meshmend_core::{Connectivity, EdgeUse, FaceId, Id, PolygonMesh, VertexId, vertex_classes};
use meshmend_topology::{
    Side, boundary_loops, component_facts, components, non_simple_faces, patches, surface_name,
};

use crate::error::FlattenError;

/// Components that are all discs; a *node* is a vertex of the mesh, or the centre of a polygon.
#[derive(Debug)]
pub(crate) struct Discs {
    /// Where each node is in space: those of the vertices, and after them the centres.
    pub(crate) places: Vec<[f64; 3]>,
    /// Nodes, the way round in which the lowest face of the disc runs.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The face that each triangle is or is a part of, ascending.
    pub(crate) face_of: Vec<FaceId>,
    /// The boundary of each disc, the way round in which its faces run, lowest node first.
    pub(crate) rims: Vec<Vec<u32>>,
}

impl Discs {
    pub(crate) fn of(mesh: &PolygonMesh) -> Result<Self, FlattenError> {
        let kernel = EdgeUse::assemble(mesh.complex());
        let (components, patches) = (components(&kernel), patches(&kernel));
        let classes = vertex_classes(&kernel);
        let loops = boundary_loops(&kernel);
        let facts = component_facts(&kernel, &components, &patches, &classes, &loops);
        for (component, facts) in facts.iter() {
            let surface = facts.surface();
            let is_disc = surface.is_some_and(|surface| surface.genus() == Some(0) && surface.holes() == 1);
            if !is_disc {
                let vertex = components.lowest_vertex(component);
                return Err(FlattenError::NotADisc { vertex, name: surface.map(surface_name) });
            }
        }
        if let Some(&(face, _)) = non_simple_faces(&kernel).first() {
            return Err(FlattenError::NonSimpleFace { face });
        }
        let runs_back = |face| patches.side(face) == Side::Reversed;
        let mut discs = Discs {
            places: mesh.positions().to_vec(),
            triangles: Vec::new(),
            face_of: Vec::new(),
            rims: rims(&kernel, runs_back),
        };
        for face in kernel.faces().filter(|&face| kernel.is_proper_face(face)) {
            discs.add_face(face, kernel.face_vertices(face), runs_back(face));
        }
        Ok(discs)
    }

    /// The length in space of the edge from each node of a rim to the next.
    pub(crate) fn rim_lengths(&self, rim: &[u32]) -> Vec<f64> {
        rim.iter().zip(rim.iter().cycle().skip(1)).map(|(&a, &b)| norm(self.vector(a, b))).collect()
    }

    /// From one node to another, in space.
    pub(crate) fn vector(&self, from: u32, to: u32) -> [f64; 3] {
        let [p, q] = [from, to].map(|node| self.places[node as usize]);
        [0, 1, 2].map(|axis| q[axis] - p[axis])
    }

    /// Each node of a rim with the place of its disc.
    pub(crate) fn rim_nodes(&self) -> impl Iterator<Item = (u32, u32)> {
        self.rims.iter().zip(0..).flat_map(|(rim, disc)| rim.iter().map(move |&node| (node, disc)))
    }

    fn add_face(&mut self, face: FaceId, vertices: impl Iterator<Item = VertexId>, runs_back: bool) {
        let mut vertices: Vec<u32> = vertices.map(|v| v.0).collect();
        if runs_back {
            vertices.reverse();
        }
        if let [a, b, c] = *vertices {
            self.triangles.push([a, b, c]);
            self.face_of.push(face);
            return;
        }
        let centre = self.places.len() as u32;
        let sum = |axis: usize| vertices.iter().map(|&v| self.places[v as usize][axis]).sum::<f64>();
        self.places.push([0, 1, 2].map(|axis| sum(axis) / vertices.len() as f64));
        let next = vertices.iter().cycle().skip(1);
        self.triangles.extend(vertices.iter().zip(next).map(|(&a, &b)| [a, b, centre]));
        self.face_of.resize(self.triangles.len(), face);
    }
}

/// The length of a vector.
pub(crate) fn norm(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The boundaries of discs, ordered by lowest vertex.
fn rims(kernel: &EdgeUse, runs_back: impl Fn(FaceId) -> bool) -> Vec<Vec<u32>> {
    const NONE: u32 = u32::MAX;
    let mut next = vec![NONE; kernel.vertex_count()];
    for edge in kernel.edges() {
        let mut sides = kernel.edge_corners(edge);
        if let (Some(side), None) = (sides.next(), sides.next()) {
            let ends = [kernel.corner_vertex(side), kernel.corner_target(side)];
            let [from, to] = if runs_back(kernel.corner_face(side)) { [ends[1], ends[0]] } else { ends };
            next[from.index()] = to.0;
        }
    }
    let mut rims = Vec::new();
    for lowest in 0..next.len() {
        let mut rim = Vec::new();
        let mut at = lowest;
        while next[at] != NONE {
            rim.push(at as u32);
            at = std::mem::replace(&mut next[at], NONE) as usize;
        }
        if !rim.is_empty() {
            rims.push(rim);
        }
    }
    rims
}
