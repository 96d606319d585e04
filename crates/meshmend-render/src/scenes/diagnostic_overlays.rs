//! The overlays that follow from a mesh alone.

use meshmend_core::{
    Connectivity, EdgeClass, EdgeId, EdgeUse, Id, PolygonMesh, VertexClass, VertexId, edge_class,
    is_inconsistent, vertex_classes,
};
use meshmend_topology::{components as find_components, orientability, patches};

use crate::Overlay;

/// Where a mesh is open: its edges with one face.
///
/// *Cost*: linear in the corners.
pub fn boundary(mesh: &PolygonMesh) -> Overlay {
    Overlay::Boundary {
        edges: edges_that(mesh, |kernel, edge| edge_class(kernel, edge) == EdgeClass::Boundary),
    }
}

/// Where a mesh is not a surface: its edges with three faces or more, and the vertices that join several umbrellas. A
/// vertex that is singular for such an edge alone is not named again.
///
/// *Cost*: O(Σ d log d) over the vertices' degrees d.
pub fn non_manifold(mesh: &PolygonMesh) -> Overlay {
    let kernel = EdgeUse::assemble(mesh.complex());
    let classes = vertex_classes(&kernel);
    let pinched = classes.iter().filter(|(_, class)| matches!(class, VertexClass::Pinched { .. }));
    let vertices = pinched.map(|(vertex, _)| vertex).collect();
    let edges = kernel.edges().filter(|&edge| edge_class(&kernel, edge) == EdgeClass::NonManifold).collect();
    Overlay::NonManifold { edges, vertices }
}

/// Where neighbours disagree which side is the front: edges of two faces that both run along them the same way.
///
/// *Cost*: linear in the corners.
pub fn inconsistent(mesh: &PolygonMesh) -> Overlay {
    Overlay::Inconsistent { edges: edges_that(mesh, is_inconsistent) }
}

/// The witnesses that show which patches have one side only.
///
/// *Cost*: as [`orientability`].
pub fn witness(mesh: &PolygonMesh) -> Overlay {
    let kernel = EdgeUse::assemble(mesh.complex());
    Overlay::Witness { strips: orientability(&kernel, &patches(&kernel)).one_sided }
}

/// The components, by shared vertices.
///
/// *Cost*: near-linear in the corners.
pub fn components(mesh: &PolygonMesh) -> Overlay {
    let kernel = EdgeUse::assemble(mesh.complex());
    let found = find_components(&kernel);
    let number = |vertex: VertexId| found.of_vertex(vertex).map(|component| component.index() as u32);
    Overlay::Components { of_vertex: kernel.vertices().map(number).collect() }
}

fn edges_that(mesh: &PolygonMesh, is_one: impl Fn(&EdgeUse, EdgeId) -> bool) -> Vec<EdgeId> {
    let kernel = EdgeUse::assemble(mesh.complex());
    kernel.edges().filter(|&edge| is_one(&kernel, edge)).collect()
}
