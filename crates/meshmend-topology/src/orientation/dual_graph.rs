//! Faces joined two by two, each dual edge turning what crosses it or not: what is left of a patch when only its
//! sides matter.
//!
//! Each face can lie on either of two sides. A dual edge *clashes* when its two faces lie so that orientation does
//! not pass across it. Whether faces are joined by a mesh's edges or by a repair's matching makes no difference here.

use meshmend_core::{Connectivity, EdgeId, FaceId};

use crate::{PatchId, Patches};

/// Two faces joined along an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DualEdge {
    /// The two faces; a face may be joined to itself.
    pub faces: [FaceId; 2],
    /// Whether both sides run the same way, so that one of the two faces is mirrored.
    pub is_mirrored: bool,
    /// What it counts in a sum.
    pub weight: u32,
}

/// A dual edge of two faces by their places in a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SignedEdge {
    pub(crate) ends: [u32; 2],
    pub(crate) is_mirrored: bool,
    pub(crate) weight: u64,
}

/// The signed edges of each face, where faces are no more than places in a list.
#[derive(Debug)]
pub(crate) struct SignedGraph {
    signed_edges: Vec<SignedEdge>,
    starts: Vec<u32>,
    arcs: Vec<Arc>,
}

/// A way from a face across a signed edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Arc {
    pub(crate) signed_edge: u32,
    /// The face beyond.
    pub(crate) to: u32,
}

impl SignedGraph {
    /// *Cost*: linear; 40 bytes a signed edge and 4 a face.
    pub(crate) fn new(face_count: usize, signed_edges: Vec<SignedEdge>) -> Self {
        let mut starts = vec![0u32; face_count + 1];
        for_each_arc(&signed_edges, |from, _| starts[from as usize + 1] += 1);
        for place in 0..face_count {
            starts[place + 1] += starts[place];
        }
        let mut next = starts.clone();
        let mut arcs = vec![Arc { signed_edge: 0, to: 0 }; starts.last().map_or(0, |&count| count as usize)];
        for_each_arc(&signed_edges, |from, arc| {
            arcs[next[from as usize] as usize] = arc;
            next[from as usize] += 1;
        });
        SignedGraph { signed_edges, starts, arcs }
    }

    pub(crate) fn face_count(&self) -> usize {
        self.starts.len() - 1
    }

    pub(crate) fn faces(&self) -> std::ops::Range<u32> {
        0..self.face_count() as u32
    }

    pub(crate) fn signed_edges(&self) -> &[SignedEdge] {
        &self.signed_edges
    }

    #[inline]
    pub(crate) fn signed_edge(&self, signed_edge: u32) -> &SignedEdge {
        &self.signed_edges[signed_edge as usize]
    }

    pub(crate) fn arc_count(&self) -> usize {
        self.arcs.len()
    }

    /// The ways out of a face, by ascending signed edge; one for a signed edge of a face with itself.
    #[inline]
    pub(crate) fn arcs(&self, face: u32) -> &[Arc] {
        &self.arcs[self.starts[face as usize] as usize..self.starts[face as usize + 1] as usize]
    }
}

fn for_each_arc(signed_edges: &[SignedEdge], mut visit: impl FnMut(u32, Arc)) {
    for (signed_edge, &SignedEdge { ends: [one, other], .. }) in (0u32..).zip(signed_edges) {
        visit(one, Arc { signed_edge, to: other });
        if one != other {
            visit(other, Arc { signed_edge, to: one });
        }
    }
}

/// The faces that have dual edges, and their dual edges as signed edges, in the same order.
#[derive(Debug)]
pub(crate) struct DualGraph {
    /// Ascending, so that places are in the order of ids.
    faces: Vec<FaceId>,
    pub(crate) graph: SignedGraph,
}

impl DualGraph {
    /// *Cost*: O(n log n).
    pub(crate) fn of(dual_edges: &[DualEdge]) -> Self {
        let mut faces: Vec<FaceId> = dual_edges.iter().flat_map(|dual_edge| dual_edge.faces).collect();
        faces.sort_unstable();
        faces.dedup();
        let mut tied = DualGraph { graph: SignedGraph::new(0, Vec::new()), faces };
        let signed_edge = |dual_edge: &DualEdge| SignedEdge {
            ends: dual_edge.faces.map(|face| tied.place(face)),
            is_mirrored: dual_edge.is_mirrored,
            weight: u64::from(dual_edge.weight),
        };
        let signed_edges = dual_edges.iter().map(signed_edge).collect();
        tied.graph = SignedGraph::new(tied.faces.len(), signed_edges);
        tied
    }

    /// The face at a place.
    pub(crate) fn face(&self, place: u32) -> FaceId {
        self.faces[place as usize]
    }

    /// The place of a face that has a dual edge.
    pub(crate) fn place(&self, face: FaceId) -> u32 {
        self.faces.partition_point(|&other| other < face) as u32
    }
}

/// The dual edges of the patches that are not orientable, by ascending edge.
#[derive(Debug, Default)]
pub(crate) struct TwistedPatches {
    pub(crate) patches: Vec<PatchId>,
    pub(crate) dual_edges: Vec<DualEdge>,
    /// The edge of each dual edge.
    pub(crate) edges: Vec<EdgeId>,
}

impl TwistedPatches {
    /// *Cost*: constant if all patches are orientable; else one pass over the edges.
    pub(crate) fn of<K: Connectivity>(
        kernel: &K,
        patches: &Patches,
        length: Option<&dyn Fn(EdgeId) -> f64>,
    ) -> Self {
        let patches_of: Vec<PatchId> = patches.ids().filter(|&patch| !patches.is_orientable(patch)).collect();
        if patches_of.is_empty() {
            return TwistedPatches::default();
        }
        let mut found = TwistedPatches { patches: patches_of, ..TwistedPatches::default() };
        for edge in kernel.edges() {
            let Some(corner) = kernel.edge_corners(edge).next() else { continue };
            let Some(crossing) = patches.crossings().across(corner) else { continue };
            let faces = [corner, crossing.opposite].map(|corner| kernel.corner_face(corner));
            let is_twisted = patches.of_face(faces[0]).is_some_and(|patch| !patches.is_orientable(patch));
            if is_twisted {
                found.dual_edges.push(DualEdge { faces, is_mirrored: crossing.is_mirrored, weight: 1 });
                found.edges.push(edge);
            }
        }
        if let Some(length) = length {
            found.measure(patches, length);
        }
        found
    }

    /// What the dual edges along some edges count together.
    pub(crate) fn length(&self, edges: &[EdgeId]) -> u64 {
        let dual_edge = |edge: &EdgeId| self.edges.binary_search(edge).ok();
        edges.iter().filter_map(dual_edge).map(|dual_edge| u64::from(self.dual_edges[dual_edge].weight)).sum()
    }

    /// Gives each dual edge its edge's length as weight, in whole steps, so that sums are exact and equal sums are
    /// equal: the longest one of a patch has 2³¹ steps, and none has less than one. A patch in which a length is no
    /// number from 0 on, or in which all are 0, stays measured in dual edges.
    fn measure(&mut self, patches: &Patches, length: &dyn Fn(EdgeId) -> f64) {
        let patch = |dual_edge: &DualEdge| patches.of_face(dual_edge.faces[0]);
        let mut longest = vec![0.0f64; self.patches.len()];
        let place =
            |dual_edge: &DualEdge| patch(dual_edge).and_then(|patch| self.patches.binary_search(&patch).ok());
        let places: Vec<usize> = self.dual_edges.iter().filter_map(place).collect();
        for (&place, &edge) in places.iter().zip(&self.edges) {
            let length = length(edge);
            longest[place] = longest[place].max(if length >= 0.0 { length } else { f64::INFINITY });
        }
        for ((&place, &edge), dual_edge) in places.iter().zip(&self.edges).zip(&mut self.dual_edges) {
            let longest = longest[place];
            if longest > 0.0 && longest.is_finite() {
                dual_edge.weight = (length(edge) / longest * f64::from(1u32 << 31)).max(1.0) as u32;
            }
        }
    }
}
