//! Section 3: components, and what surface each one is.

use std::collections::BTreeSet;

use serde::Serialize;

use super::cells::{Cells, classes};
use super::patches::{is_orientable, patches};
use super::vertices::{VertexKind, vertex_kind};

/// One component, faces that hang together by shared vertices; or several that are alike in every figure.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ComponentRow {
    /// How many components the row stands for.
    pub count: usize,
    /// The name by the classification theorem; null for what is no manifold.
    pub name: Option<String>,
    /// V.
    pub vertices: usize,
    /// E.
    pub edges: usize,
    /// F.
    pub faces: usize,
    /// χ.
    pub euler_characteristic: i64,
    /// Cycles of boundary edges; null for what is no manifold.
    pub boundary_loops: Option<usize>,
    /// Whether all patches can be oriented.
    pub orientable: bool,
    /// (2 − χ − b) / 2; null for what is no manifold, or not orientable.
    pub genus: Option<usize>,
    /// 2 − χ − b; null for what is no manifold, or orientable.
    pub cross_caps: Option<usize>,
    /// Whether every edge has degree 2 or more.
    pub closed: bool,
    /// Whether every edge has degree 1 or 2 and every vertex is `disc` or `half-disc`.
    pub manifold: bool,
    /// The lowest vertex of all.
    pub first_vertex: u32,
}

/// The components, by lowest vertex.
pub(super) fn components(cells: &Cells) -> Vec<ComponentRow> {
    let proper = cells.proper();
    let labels: Vec<BTreeSet<u32>> =
        proper.iter().map(|&f| cells.faces[f].iter().copied().collect()).collect();
    let mut rows: Vec<ComponentRow> = classes(&labels)
        .into_iter()
        .map(|class| row(cells, &class.iter().map(|&i| proper[i]).collect::<Vec<_>>()))
        .collect();
    rows.sort_by_key(|row| row.first_vertex);
    rows
}

/// The components that are alike counted in one row, by lowest vertex.
pub(super) fn kinds(components: &[ComponentRow]) -> Vec<ComponentRow> {
    let mut kinds: Vec<ComponentRow> = Vec::new();
    for row in components {
        let is_alike = |kind: &&mut ComponentRow| {
            **kind == ComponentRow { count: kind.count, first_vertex: kind.first_vertex, ..row.clone() }
        };
        match kinds.iter_mut().find(is_alike) {
            Some(kind) => kind.count += 1,
            None => kinds.push(row.clone()),
        }
    }
    kinds
}

fn row(cells: &Cells, faces: &[usize]) -> ComponentRow {
    let vertices: BTreeSet<u32> = faces.iter().flat_map(|&f| cells.faces[f].clone()).collect();
    let edges: Vec<usize> = (0..cells.ends.len()).filter(|&e| vertices.contains(&cells.ends[e][0])).collect();
    let euler_characteristic = vertices.len() as i64 - edges.len() as i64 + faces.len() as i64;
    let manifold = edges.iter().all(|&e| cells.uses[e].len() <= 2)
        && vertices.iter().all(|&v| matches!(vertex_kind(cells, v), VertexKind::Disc | VertexKind::HalfDisc));
    let orientable = patches(cells)
        .iter()
        .filter(|patch| faces.contains(&patch[0]))
        .all(|patch| is_orientable(cells, patch));
    let mut row = ComponentRow {
        count: 1,
        name: None,
        vertices: vertices.len(),
        edges: edges.len(),
        faces: faces.len(),
        euler_characteristic,
        boundary_loops: None,
        orientable,
        genus: None,
        cross_caps: None,
        closed: edges.iter().all(|&e| cells.uses[e].len() >= 2),
        manifold,
        first_vertex: vertices.iter().copied().min().unwrap(),
    };
    if manifold {
        let loops = boundary_loops(cells, &edges);
        let deficit = usize::try_from(2 - euler_characteristic - loops as i64).unwrap();
        row.boundary_loops = Some(loops);
        row.genus = orientable.then_some(deficit / 2);
        row.cross_caps = (!orientable).then_some(deficit);
        row.name = Some(surface_name(row.genus.unwrap_or(0), row.cross_caps.unwrap_or(0), loops));
    }
    row
}

/// Cycles of boundary edges: classes of such edges by shared vertices.
fn boundary_loops(cells: &Cells, edges: &[usize]) -> usize {
    let boundary = edges.iter().filter(|&&e| cells.uses[e].len() == 1);
    let labels: Vec<BTreeSet<u32>> = boundary.map(|&e| cells.ends[e].into()).collect();
    classes(&labels).len()
}

/// The name of a compact connected surface, to the letter of the semantics.
pub fn surface_name(genus: usize, cross_caps: usize, holes: usize) -> String {
    match (genus, cross_caps, holes) {
        (0, 0, 1) => return "disc".into(),
        (0, 0, 2) => return "annulus".into(),
        (0, 0, 3) => return "pair of pants".into(),
        (0, 1, 1) => return "Möbius band".into(),
        _ => {}
    }
    let closed = match (genus, cross_caps) {
        (0, 0) => "sphere".into(),
        (1, 0) => "torus".into(),
        (2, 0) => "double torus".into(),
        (_, 0) => format!("genus-{genus} surface"),
        (_, 1) => "projective plane".into(),
        (_, 2) => "Klein bottle".into(),
        (_, 3) => "Dyck's surface".into(),
        _ => format!("sphere with {cross_caps} cross-caps"),
    };
    match holes {
        0 => closed,
        1 => format!("{closed} with 1 hole"),
        _ => format!("{closed} with {holes} holes"),
    }
}
