//! The definitions of sections 1 to 3 of the semantics, transcribed: from plain face lists, with sets, in quadratic
//! time and worse, and with nothing in common with the code that it judges.
//!
//! [`report`] gives the counts, with the names that reports use; [`findings`] gives the elements behind them, and
//! [`defects()`] what of that is wrong, in the library's vocabulary. [`contact()`] tells how two triangles meet.
//! What the page leaves open is settled here so:
//!
//! * A *same* duplicate is a face whose directed cycle an earlier face has; an *opposite* one is a face whose cycle
//!   an earlier face has the other way round, and none the same way.
//! * A component that is not orientable has no genus, and one that is has no cross-caps: both null. A total is null
//!   as soon as one component is no manifold, and where no component has the figure; but without a component there
//!   are 0 boundary loops.
//! * A mesh without a face is manifold, orientable and consistently oriented, and not closed.

mod betti;
mod cells;
mod components;
mod contact;
mod defects;
mod patches;
mod vertices;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::Soup;
use cells::Cells;
pub use components::{ComponentRow, surface_name};
pub use contact::{contact, has_no_area};
pub use defects::{defects, mendable_clashes};
pub use patches::Witness;
pub use vertices::VertexKind;

/// The counts, under the names that reports use.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the semantics")]
pub struct OracleReport {
    pub vertices: usize,
    pub edges: usize,
    pub faces: usize,
    pub unreferenced_vertices: usize,
    pub degenerate_faces: usize,
    pub non_simple_faces: usize,
    pub duplicate_faces: DuplicateCounts,
    pub boundary_edges: usize,
    pub interior_edges: usize,
    pub non_manifold_edges: usize,
    pub inconsistent_edges: usize,
    pub non_manifold_vertices: NonManifoldVertexCounts,
    pub non_finite_vertices: usize,
    pub manifold: bool,
    pub closed: bool,
    pub consistently_oriented: bool,
    pub orientable: bool,
    pub euler_characteristic: i64,
    pub components: usize,
    pub patches: usize,
    pub boundary_loops: Option<usize>,
    pub genus: Option<usize>,
    pub cross_caps: Option<usize>,
    pub betti: BettiTriples,
    pub instigators: Instigators,
    /// The components, those that are alike counted in one row, by lowest vertex.
    pub component_kinds: Vec<ComponentRow>,
}

/// Faces that an earlier face doubles.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the semantics")]
pub struct DuplicateCounts {
    pub same: usize,
    pub opposite: usize,
}

/// Vertices that are neither `disc` nor `half-disc`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the semantics")]
pub struct NonManifoldVertexCounts {
    pub pinched: usize,
    pub singular: usize,
}

/// β₀, β₁ and β₂ over two fields.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the semantics")]
pub struct BettiTriples {
    pub z2: [usize; 3],
    pub q: [usize; 3],
}

/// Elements that close a cycle when they are added, and those that don't.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the semantics")]
pub struct Instigators {
    pub v_n: usize,
    pub v_c: usize,
    pub e_n: usize,
    pub e_c: usize,
    pub f_n: usize,
    pub f_c: usize,
}

/// The elements behind the counts, each list ascending.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Findings {
    /// Vertices in no face of the complex.
    pub unreferenced_vertices: Vec<u32>,
    /// Vertices with a coordinate that is infinite or not a number.
    pub non_finite_vertices: Vec<u32>,
    /// Faces with fewer than three different vertices.
    pub degenerate_faces: Vec<u32>,
    /// Faces that come back to a vertex.
    pub non_simple_faces: Vec<u32>,
    /// Faces whose directed cycle an earlier face has.
    pub same_duplicates: Vec<u32>,
    /// Faces whose cycle an earlier face has the other way round only.
    pub opposite_duplicates: Vec<u32>,
    /// The ends of each edge, by edge number.
    pub edges: Vec<[u32; 2]>,
    /// Edges with one use.
    pub boundary_edges: Vec<u32>,
    /// Edges with two uses.
    pub interior_edges: Vec<u32>,
    /// Edges with more, and their degrees.
    pub non_manifold_edges: Vec<(u32, usize)>,
    /// Edges with two uses that run the same way.
    pub inconsistent_edges: Vec<u32>,
    /// The class of each referenced vertex.
    pub vertex_kinds: BTreeMap<u32, VertexKind>,
    /// The faces of each patch, by lowest face.
    pub patches: Vec<Vec<u32>>,
    /// For each patch that can't be oriented the witness, by lowest face of the patch.
    pub witnesses: Vec<Witness>,
    /// The components, by lowest vertex.
    pub components: Vec<ComponentRow>,
}

/// The elements behind the counts.
pub fn findings(soup: &Soup) -> Findings {
    let cells = Cells::of(soup);
    let is_finite = |v: &usize| soup.positions[*v].iter().all(|x| x.is_finite());
    let vertices = 0..soup.vertex_count();
    let (same, opposite) = cells.duplicates();
    let branching = cells.edges_where(|degree| degree > 2);
    let patches = patches::patches(&cells);
    Findings {
        unreferenced_vertices: short(vertices.clone().filter(|v| !cells.referenced.contains(&(*v as u32)))),
        non_finite_vertices: short(vertices.filter(|v| !is_finite(v))),
        degenerate_faces: short((0..cells.faces.len()).filter(|&f| cells.faces[f].is_empty())),
        non_simple_faces: short(cells.non_simple()),
        same_duplicates: short(same),
        opposite_duplicates: short(opposite),
        boundary_edges: short(cells.edges_where(|degree| degree == 1)),
        interior_edges: short(cells.edges_where(|degree| degree == 2)),
        non_manifold_edges: branching.iter().map(|&e| (e as u32, cells.uses[e].len())).collect(),
        inconsistent_edges: short((0..cells.ends.len()).filter(|&e| cells.is_inconsistent(e))),
        vertex_kinds: cells.referenced.iter().map(|&v| (v, vertices::vertex_kind(&cells, v))).collect(),
        witnesses: patches
            .iter()
            .filter(|patch| !patches::is_orientable(&cells, patch))
            .map(|patch| patches::witness(&cells, patch).expect("some edge contradicts the tree"))
            .collect(),
        patches: patches.into_iter().map(short).collect(),
        components: components::components(&cells),
        edges: cells.ends,
    }
}

/// The counts.
pub fn report(soup: &Soup) -> OracleReport {
    let cells = Cells::of(soup);
    let found = findings(soup);
    let (vertices, edges, faces) = (cells.referenced.len(), cells.ends.len(), cells.proper().len());
    let components = found.components.len();
    let betti = BettiTriples { z2: betti::betti_z2(&cells), q: betti::betti_q(&cells) };
    let kinds = || found.vertex_kinds.values();
    let pinched = kinds().filter(|kind| matches!(kind, VertexKind::Pinched { .. })).count();
    let singular = kinds().filter(|&&kind| kind == VertexKind::Singular).count();
    let is_surface = found.components.iter().all(|row| row.manifold);
    let total = |figure: fn(&ComponentRow) -> Option<usize>| {
        let figures: Vec<usize> = found.components.iter().filter_map(figure).collect();
        (is_surface && !figures.is_empty()).then(|| figures.iter().sum())
    };
    OracleReport {
        vertices,
        edges,
        faces,
        unreferenced_vertices: found.unreferenced_vertices.len(),
        degenerate_faces: found.degenerate_faces.len(),
        non_simple_faces: found.non_simple_faces.len(),
        duplicate_faces: DuplicateCounts {
            same: found.same_duplicates.len(),
            opposite: found.opposite_duplicates.len(),
        },
        boundary_edges: found.boundary_edges.len(),
        interior_edges: found.interior_edges.len(),
        non_manifold_edges: found.non_manifold_edges.len(),
        inconsistent_edges: found.inconsistent_edges.len(),
        non_manifold_vertices: NonManifoldVertexCounts { pinched, singular },
        non_finite_vertices: found.non_finite_vertices.len(),
        manifold: found.non_manifold_edges.is_empty() && pinched + singular == 0,
        closed: faces > 0 && found.boundary_edges.is_empty(),
        consistently_oriented: found.inconsistent_edges.is_empty(),
        orientable: found.witnesses.is_empty(),
        euler_characteristic: vertices as i64 - edges as i64 + faces as i64,
        components,
        patches: found.patches.len(),
        boundary_loops: total(|row| row.boundary_loops).or((components == 0).then_some(0)),
        genus: total(|row| row.genus),
        cross_caps: total(|row| row.cross_caps),
        instigators: Instigators {
            v_n: 0,
            v_c: vertices,
            e_n: vertices - components,
            e_c: edges + components - vertices,
            f_n: faces - betti.z2[2],
            f_c: betti.z2[2],
        },
        betti,
        component_kinds: components::kinds(&found.components),
    }
}

/// Whether faces and edges are a simple closed strip, each two neighbours sharing the edge of degree 2 between them,
/// that reverses orientation once round.
///
/// # Errors
/// What is wrong with it.
pub fn check_witness(soup: &Soup, faces: &[u32], edges: &[u32]) -> Result<(), String> {
    patches::check_witness(&Cells::of(soup), faces, edges)
}

fn short(places: impl IntoIterator<Item = usize>) -> Vec<u32> {
    places.into_iter().map(|place| place as u32).collect()
}

#[cfg(test)]
mod tests;
