//! The vertices that come apart: each is a star of corners, and its parts are the corners that stay together there.
//!
//! Two corners stay together when they meet across matched sides. A disc or half-disc of which no side was parted is
//! always one part, so only the other vertices are looked at, each by itself.

use meshmend_core::{Classes, Connectivity, CornerId, EdgeId, VertexClass, VertexId, umbrellas};

use crate::matching::{Matching, run_the_same_way};

/// A vertex with its class.
pub(crate) type ClassedVertex = (VertexId, VertexClass);

/// The corners of some vertices, by the parts that they belong to.
pub(crate) struct VertexParts {
    /// The vertices that may have come apart, ascending, each with the class that it had.
    pub(crate) vertices: Vec<ClassedVertex>,
    /// All parts, by vertex, then by lowest corner.
    pub(crate) parts: Vec<Part>,
    /// Each corner of these vertices, with the place of its part.
    pub(crate) corners: Vec<(CornerId, u32)>,
}

/// A part of a vertex.
pub(crate) struct Part {
    pub(crate) vertex: VertexId,
    pub(crate) lowest_corner: CornerId,
}

impl VertexParts {
    /// The parts of vertices. Sides are joined if they are matched or listed in `joined`.
    ///
    /// *Cost*: O(Σ d log d) over the vertices' degrees d.
    pub(crate) fn of<K: Connectivity>(
        kernel: &K,
        matching: &Matching,
        joined: &[(CornerId, CornerId)],
        vertices: Vec<ClassedVertex>,
    ) -> Self {
        let mut joined: Vec<_> =
            joined.iter().flat_map(|&(one, other)| [(one, other), (other, one)]).collect();
        joined.sort_unstable();
        let mut found = VertexParts { vertices: Vec::new(), parts: Vec::new(), corners: Vec::new() };
        let mut star = Star::default();
        for &(vertex, _) in &vertices {
            star.join(kernel, vertex, |side| {
                let further = &joined[joined.partition_point(|(one, _)| *one < side)..];
                let further =
                    further.iter().take_while(move |(one, _)| *one == side).map(|(_, other)| *other);
                matching.mate(side).into_iter().chain(further)
            });
            found.add(vertex, &mut star);
        }
        VertexParts { vertices, ..found }
    }

    fn add(&mut self, vertex: VertexId, star: &mut Star) {
        for place in 0..star.corners.len() {
            let (corner, root) = (star.corners[place], star.classes.root(place as u32));
            // A root is the lowest of its class, so it comes first.
            if root == place as u32 {
                star.part[place] = self.parts.len() as u32;
                self.parts.push(Part { vertex, lowest_corner: corner });
            }
            self.corners.push((corner, star.part[root as usize]));
        }
    }
}

/// Vertices and the ends of edges that are cut, ascending, each with its class.
pub(crate) fn with_ends<K: Connectivity>(
    kernel: &K,
    mut vertices: Vec<ClassedVertex>,
    cut: &[EdgeId],
) -> Vec<ClassedVertex> {
    let ends = cut.iter().flat_map(|&edge| kernel.edge_ends(edge));
    vertices.extend(ends.map(|vertex| (vertex, umbrellas(kernel, vertex).class())));
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

/// The corners at each end of an edge that are one vertex when two of its sides are joined.
pub(crate) fn corners_that_meet<K: Connectivity>(
    kernel: &K,
    one: CornerId,
    other: CornerId,
) -> [(CornerId, CornerId); 2] {
    let (after_one, after_other) = (kernel.next_corner(one), kernel.next_corner(other));
    if run_the_same_way(kernel, one, other) {
        [(one, other), (after_one, after_other)]
    } else {
        [(one, after_other), (after_one, other)]
    }
}

/// The corners at a vertex, by what stays together; reused from vertex to vertex.
#[derive(Default)]
struct Star {
    /// Ascending.
    corners: Vec<CornerId>,
    classes: Classes,
    part: Vec<u32>,
}

impl Star {
    /// Joins the corners of a vertex across the sides that `partners` gives for each side.
    fn join<K: Connectivity, I: Iterator<Item = CornerId>>(
        &mut self,
        kernel: &K,
        vertex: VertexId,
        partners: impl Fn(CornerId) -> I,
    ) {
        self.corners.clear();
        self.corners.extend(kernel.vertex_corners(vertex));
        self.corners.sort_unstable();
        self.classes.reset(self.corners.len());
        self.part.clear();
        self.part.resize(self.corners.len(), 0);
        for place in 0..self.corners.len() {
            let corner = self.corners[place];
            for partner in partners(corner) {
                self.union(place, corners_that_meet(kernel, corner, partner)[0].1);
            }
            let before = kernel.prev_corner(corner);
            for partner in partners(before) {
                self.union(place, corners_that_meet(kernel, before, partner)[1].1);
            }
        }
    }

    fn union(&mut self, place: usize, other: CornerId) {
        // Partners run along the same edge, so the other corner is at the same vertex.
        let Ok(other) = self.corners.binary_search(&other) else { return };
        self.classes.join(place as u32, other as u32);
    }
}
