//! Gives each of the edges that would coincide a vertex of its own.
//!
//! Two different matched edges, or free uses, may join the same two new vertices, because their umbrellas are connected
//! elsewhere. By index they would be one edge again. Then every edge at that place is subdivided, each by a vertex of its
//! own, all of them at the first free point between the lower and the higher vertex.
//!
//! In formats that tell vertices apart by their places alone, as STL, each of them gets a free point of its own. Else the
//! edges would be one again when they are read, and would be subdivided again.

use meshmend_core::{Blend, Complex, Connectivity, CornerId, EdgeId, PolygonMesh, VertexDraft};
use meshmend_geometry::FreePoints;
use smallvec::SmallVec;

use super::new_vertices::NewVertices;
use crate::matching::Matching;
use crate::{Context, PassError, Subdivision, Unused};

/// What is inserted into the sides of edges.
#[derive(Default)]
pub(crate) struct Inserted {
    /// The new vertices, in order; the first follows the last vertex of the result so far.
    pub(crate) vertices: Vec<VertexDraft>,
    /// For each side that gets one, by ascending corner: the place of its new vertex in that list, and where it lies.
    pub(crate) sides: Vec<(CornerId, u32, Blend)>,
    /// The edges that were subdivided, ascending.
    pub(crate) edges: Vec<EdgeId>,
}

/// Finds the edges that would coincide, and subdivides them.
///
/// *Cost*: O(Σ d log d) over the degrees d of edges with more than two uses or unmatched ones. The positions are
/// sorted only if an edge is subdivided.
pub(crate) fn subdivide<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    matching: &Matching,
    vertices: &NewVertices,
    context: &Context<'_>,
) -> Result<Inserted, PassError> {
    let edges: Vec<EdgeId> =
        kernel.edges().filter(|&edge| coincide(kernel, matching, vertices, edge)).collect();
    let mut inserted = Inserted { vertices: Vec::new(), sides: Vec::new(), edges };
    if inserted.edges.is_empty() {
        return Ok(inserted);
    }
    let clearance = context.clearance;
    let has_own_points = clearance.subdivision == Subdivision::InOwnPoints
        || context.storage.map_or(Ok(false), |storage| storage.takes_apart(mesh))?;
    let complex = mesh.complex();
    // A vertex that `compact` removes, since no face uses it, must not decide where others go.
    let is_in_result = |v| clearance.unused == Unused::Kept || kernel.is_referenced(v);
    let parts = vertices.present.iter().zip(&vertices.positions).filter(|(v, _)| is_in_result(**v));
    let mut free = FreePoints::beside(clearance.spacing(), parts.map(|(_, &position)| position));
    for edge in inserted.edges.clone() {
        let ends = kernel.edge_ends(edge).map(|v| mesh.position(v));
        let mut shared = None;
        for corner in kernel.edge_corners(edge) {
            let mate = matching.mate(corner);
            if mate.is_some_and(|mate| mate < corner) {
                continue;
            }
            let (position, ratio) = match shared {
                Some(point) if !has_own_points => point,
                _ => *shared.insert(free.on_edge(ends)),
            };
            let place = inserted.vertices.len() as u32;
            let place_on_side = Some(blend(kernel, complex, corner, ratio));
            inserted.vertices.push(VertexDraft { position, place: place_on_side });
            for side in [Some(corner), mate].into_iter().flatten() {
                inserted.sides.push((side, place, blend(kernel, complex, side, ratio)));
            }
        }
    }
    inserted.sides.sort_unstable_by_key(|(corner, _, _)| *corner);
    Ok(inserted)
}

/// Whether two different edges of the result along one edge of the mesh join the same two vertices.
fn coincide<K: Connectivity>(kernel: &K, matching: &Matching, vertices: &NewVertices, edge: EdgeId) -> bool {
    let mut uses = kernel.edge_corners(edge);
    match (uses.next(), uses.next(), uses.next()) {
        (Some(one), Some(other), None) if matching.mate(one) == Some(other) => return false,
        (_, None, _) => return false,
        _ => {}
    }
    let is_first = |c: &CornerId| matching.mate(*c).is_none_or(|mate| *c < mate);
    let ends_of = |c: CornerId| {
        let (a, b) = (vertices.of_corner[c], vertices.of_corner[kernel.next_corner(c)]);
        (a.min(b), a.max(b))
    };
    let mut ends: SmallVec<[_; 4]> = kernel.edge_corners(edge).filter(is_first).map(ends_of).collect();
    ends.sort_unstable();
    ends.windows(2).any(|pair| pair[0] == pair[1])
}

/// The place of a point between an edge's lower and higher vertex, as seen along one of its sides, in terms of corners as
/// stored.
fn blend<K: Connectivity>(
    kernel: &K,
    complex: &Complex,
    side: CornerId,
    (numerator, denominator): (u32, u32),
) -> Blend {
    let ends = [side, kernel.next_corner(side)].map(|corner| complex.stored_corner(corner));
    let [from, to] = if kernel.is_forward(side) { ends } else { [ends[1], ends[0]] };
    Blend::Along { from, to, numerator, denominator }
}
