//! All faces, edges and vertices looked at once, for every kind of defect that shows in the connectivity.

use meshmend_core::{
    Column, Connectivity, DefectKind, EdgeClass, EdgeId, PolygonMesh, VertexClass, VertexId, edge_class,
    is_inconsistent,
};

use super::items::{EdgeAt, Items, Pinch};
use crate::{Likeness, Orientability, duplicate_faces, faces_with_repeated_corners, non_simple_faces};

/// The items of each kind that the survey finds, in the order of kinds.
///
/// *Cost*: one pass over the elements each, and [`duplicate_faces`].
pub(super) fn survey<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    vertex_classes: &Column<VertexId, VertexClass>,
    orientability: Orientability,
) -> Vec<(DefectKind, Items)> {
    let (same, opposite) =
        duplicate_faces(kernel).into_iter().partition(|duplicate| duplicate.likeness == Likeness::Same);
    let edges = Edges::of(kernel);
    let vertices = Vertices::of(vertex_classes);
    let is_infinite = |&vertex: &VertexId| !mesh.is_finite(vertex);
    let mut columns = vec![
        (DefectKind::DegenerateFace, Items::Faces(mesh.complex().degenerate_faces().to_vec())),
        (DefectKind::NonSimpleFace, Items::Corners(non_simple_faces(kernel))),
        (DefectKind::RepeatedCorner, Items::Corners(faces_with_repeated_corners(mesh))),
        (DefectKind::DuplicateFace, Items::Repeats(same)),
        (DefectKind::OppositeFace, Items::Repeats(opposite)),
        (DefectKind::BoundaryEdge, Items::Edges(edges.boundary, 1)),
        (DefectKind::NonManifoldEdge, Items::EdgesOfDegree(edges.non_manifold)),
        (DefectKind::InconsistentEdge, Items::Edges(edges.inconsistent, 2)),
        (DefectKind::PinchedVertex, Items::Pinches(vertices.pinched)),
        (DefectKind::SingularVertex, Items::Vertices(vertices.singular)),
        (DefectKind::NonFiniteVertex, Items::Vertices(kernel.vertices().filter(is_infinite).collect())),
        (DefectKind::UnreferencedVertex, Items::Vertices(vertices.unreferenced)),
        (DefectKind::LooseEdge, Items::LooseEdges(mesh.loose_edges().to_vec())),
        (DefectKind::LoosePoint, Items::LoosePoints(mesh.loose_points().to_vec())),
        (DefectKind::NonOrientablePatch, Items::Strips(orientability.one_sided)),
    ];
    columns.retain(|(_, items)| items.len() > 0);
    columns.sort_by_key(|&(kind, _)| kind);
    columns
}

struct Edges {
    boundary: Vec<EdgeAt>,
    non_manifold: Vec<(EdgeAt, u32)>,
    inconsistent: Vec<EdgeAt>,
}

impl Edges {
    fn of<K: Connectivity>(kernel: &K) -> Self {
        let is_boundary = |&edge: &EdgeId| edge_class(kernel, edge) == EdgeClass::Boundary;
        // There can be as many as corners, so room for them is made once.
        let boundary = Vec::with_capacity(kernel.edges().filter(is_boundary).count());
        let mut edges = Edges { boundary, non_manifold: Vec::new(), inconsistent: Vec::new() };
        kernel.edges().for_each(|edge| edges.look_at(kernel, edge));
        edges
    }

    fn look_at<K: Connectivity>(&mut self, kernel: &K, edge: EdgeId) {
        let at = || EdgeAt { edge, ends: kernel.edge_ends(edge) };
        match edge_class(kernel, edge) {
            EdgeClass::Boundary => self.boundary.push(at()),
            EdgeClass::Interior if is_inconsistent(kernel, edge) => self.inconsistent.push(at()),
            EdgeClass::Interior => {}
            EdgeClass::NonManifold => self.non_manifold.push((at(), kernel.edge_degree(edge) as u32)),
        }
    }
}

#[derive(Default)]
struct Vertices {
    pinched: Vec<Pinch>,
    singular: Vec<VertexId>,
    unreferenced: Vec<VertexId>,
}

impl Vertices {
    fn of(classes: &Column<VertexId, VertexClass>) -> Self {
        let mut vertices = Vertices::default();
        classes.iter().for_each(|(vertex, &class)| vertices.look_at(vertex, class));
        vertices
    }

    fn look_at(&mut self, vertex: VertexId, class: VertexClass) {
        match class {
            VertexClass::Disc | VertexClass::HalfDisc => {}
            VertexClass::Unreferenced => self.unreferenced.push(vertex),
            VertexClass::Singular => self.singular.push(vertex),
            VertexClass::Pinched { umbrellas, boundary_only } => {
                self.pinched.push(Pinch { vertex, umbrellas, boundary_only });
            }
        }
    }
}
