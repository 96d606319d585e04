//! Which vertices of the boundary lie on which of its edges.

use meshmend_core::{Cancelled, Id, VertexId, Watch};
use meshmend_geometry::vector::Point;
use rayon::prelude::*;

use super::STEP;
use super::boundary::Boundary;
use super::place::is_on;
use super::point_tree::PointTree;

/// Edges between two looks.
const CHUNK: usize = 1024;

/// Pairs of an edge of the boundary and a vertex that lies on it.
pub(crate) struct OnEdges {
    /// Ascending.
    pairs: Vec<(u32, VertexId)>,
}

/// The vertices of a boundary that lie on its edges, within a distance: on edges of faces that they are no corners of.
///
/// # Errors
/// When whoever watches stops it.
///
/// *Cost*: O(n log n + pairs), on all threads; 100 bytes an edge and 8 a pair.
pub(crate) fn vertices_on_edges(
    positions: &[Point],
    boundary: &Boundary,
    within: f64,
    watch: &Watch,
) -> Result<OnEdges, Cancelled> {
    let count = boundary.edges().len();
    watch.look(STEP, 0, count)?;
    let vertices = boundary.vertices();
    let points = vertices.iter().map(|vertex| positions[vertex.index()]);
    let tree = PointTree::watched(points, &|| watch.look(STEP, 0, count))?;
    let of_edge = |edge: u32| {
        let ends = boundary.edges()[edge as usize].ends.map(|end| positions[end.index()]);
        let mut found = Vec::new();
        tree.visit_near(ends, within, |number| {
            let vertex = vertices[number as usize];
            if is_on(positions[vertex.index()], ends, within) && !boundary.is_corner(edge, vertex) {
                found.push((edge, vertex));
            }
        });
        found.sort_unstable();
        found
    };
    let chunks = (0..count.div_ceil(CHUNK)).into_par_iter().map(|chunk| {
        let edges = chunk * CHUNK..count.min((chunk + 1) * CHUNK);
        watch.look(STEP, edges.start, count)?;
        Ok(edges.flat_map(|edge| of_edge(edge as u32)).collect::<Vec<_>>())
    });
    let found = chunks.collect::<Result<Vec<_>, Cancelled>>()?;
    watch.look(STEP, count, count)?;
    Ok(OnEdges { pairs: found.concat() })
}

impl OnEdges {
    /// All pairs, ascending.
    pub(crate) fn pairs(&self) -> &[(u32, VertexId)] {
        &self.pairs
    }

    /// Whether a vertex lies on an edge.
    fn contains(&self, edge: u32, vertex: VertexId) -> bool {
        self.pairs.binary_search(&(edge, vertex)).is_ok()
    }

    /// Whether one of the boundary edges of a vertex that lies on an edge runs along that edge.
    ///
    /// *Cost*: logarithmic for each boundary edge of the vertex.
    pub(crate) fn is_aligned(&self, boundary: &Boundary, edge: u32, vertex: VertexId) -> bool {
        let ends = boundary.edges()[edge as usize].ends;
        boundary.edges_at(vertex).filter(|&other| other != edge).any(|other| {
            let others = boundary.edges()[other as usize].ends;
            let far = if others[0] == vertex { others[1] } else { others[0] };
            ends.contains(&far)
                || self.contains(edge, far)
                || ends.iter().any(|&end| self.contains(other, end))
        })
    }
}
