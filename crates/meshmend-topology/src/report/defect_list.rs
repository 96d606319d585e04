//! Where is everything that is wrong?
//!
//! A soup of ten million triangles has thirty million boundary edges, so the list keeps ids alone and makes
//! [`Defect`]s as they are asked for.

use meshmend_core::{
    Column, Connectivity, Defect, DefectKind, EdgeClass, EdgeId, FaceId, PolygonMesh, VertexClass, VertexId,
    edge_class, is_inconsistent,
};

use crate::{
    DuplicateFace, Likeness, OneSidedStrip, Orientability, duplicate_faces, faces_with_repeated_corners,
    non_simple_faces,
};

/// Everything that is wrong with a mesh as it is, by kind and then by id.
#[derive(Clone, Debug, Default)]
pub struct DefectList {
    degenerate_faces: Vec<FaceId>,
    non_simple_faces: Vec<(FaceId, VertexId)>,
    repeated_corners: Vec<(FaceId, VertexId)>,
    same_faces: Vec<DuplicateFace>,
    opposite_faces: Vec<DuplicateFace>,
    boundary_edges: Vec<EdgeAt>,
    non_manifold_edges: Vec<(EdgeAt, u32)>,
    inconsistent_edges: Vec<EdgeAt>,
    pinched_vertices: Vec<Pinch>,
    singular_vertices: Vec<VertexId>,
    non_finite_vertices: Vec<VertexId>,
    unreferenced_vertices: Vec<VertexId>,
    loose_edges: Vec<[VertexId; 2]>,
    loose_points: Vec<VertexId>,
    one_sided: Vec<OneSidedStrip>,
}

#[derive(Clone, Copy, Debug)]
struct EdgeAt {
    edge: EdgeId,
    ends: [VertexId; 2],
}

#[derive(Clone, Copy, Debug)]
struct Pinch {
    vertex: VertexId,
    umbrellas: u32,
    boundary_only: bool,
}

impl DefectList {
    /// Looks for every kind of defect that a mesh can have as it is.
    ///
    /// *Cost*: one pass over the elements each, and [`duplicate_faces`].
    pub(crate) fn find<K: Connectivity>(
        kernel: &K,
        mesh: &PolygonMesh,
        vertex_classes: &Column<VertexId, VertexClass>,
        orientability: Orientability,
    ) -> Self {
        let is_infinite = |&vertex: &VertexId| !mesh.is_finite(vertex);
        let (same_faces, opposite_faces) =
            duplicate_faces(kernel).into_iter().partition(|duplicate| duplicate.likeness == Likeness::Same);
        let mut list = DefectList {
            degenerate_faces: mesh.complex().degenerate_faces().to_vec(),
            non_simple_faces: non_simple_faces(kernel),
            repeated_corners: faces_with_repeated_corners(mesh),
            same_faces,
            opposite_faces,
            non_finite_vertices: kernel.vertices().filter(is_infinite).collect(),
            loose_edges: mesh.loose_edges().to_vec(),
            loose_points: mesh.loose_points().to_vec(),
            one_sided: orientability.one_sided,
            // There can be as many as corners, so room for them is made once.
            boundary_edges: Vec::with_capacity(edges_of_degree_one(kernel)),
            ..DefectList::default()
        };
        kernel.edges().for_each(|edge| list.look_at_edge(kernel, edge));
        vertex_classes.iter().for_each(|(vertex, &class)| list.look_at_vertex(vertex, class));
        list
    }

    fn look_at_edge<K: Connectivity>(&mut self, kernel: &K, edge: EdgeId) {
        let at = || EdgeAt { edge, ends: kernel.edge_ends(edge) };
        match edge_class(kernel, edge) {
            EdgeClass::Boundary => self.boundary_edges.push(at()),
            EdgeClass::Interior if is_inconsistent(kernel, edge) => self.inconsistent_edges.push(at()),
            EdgeClass::Interior => {}
            EdgeClass::NonManifold => self.non_manifold_edges.push((at(), kernel.edge_degree(edge) as u32)),
        }
    }

    fn look_at_vertex(&mut self, vertex: VertexId, class: VertexClass) {
        match class {
            VertexClass::Disc | VertexClass::HalfDisc => {}
            VertexClass::Unreferenced => self.unreferenced_vertices.push(vertex),
            VertexClass::Singular => self.singular_vertices.push(vertex),
            VertexClass::Pinched { umbrellas, boundary_only } => {
                self.pinched_vertices.push(Pinch { vertex, umbrellas, boundary_only });
            }
        }
    }

    /// How many defects of a kind there are. *Cost*: O(1).
    pub fn count(&self, kind: DefectKind) -> usize {
        self.of_kind(kind).len()
    }

    /// The defects of a kind, by ascending id.
    pub fn of_kind(&self, kind: DefectKind) -> impl ExactSizeIterator<Item = Defect> + '_ {
        match kind {
            DefectKind::DegenerateFace => {
                each(&self.degenerate_faces, |&face| Defect::DegenerateFace { face })
            }
            DefectKind::NonSimpleFace => {
                each(&self.non_simple_faces, |&(face, vertex)| Defect::NonSimpleFace { face, vertex })
            }
            DefectKind::RepeatedCorner => {
                each(&self.repeated_corners, |&(face, vertex)| Defect::RepeatedCorner { face, vertex })
            }
            DefectKind::DuplicateFace => {
                each(&self.same_faces, |&DuplicateFace { face, original, .. }| Defect::DuplicateFace {
                    face,
                    original,
                })
            }
            DefectKind::OppositeFace => {
                each(&self.opposite_faces, |&DuplicateFace { face, original, .. }| Defect::OppositeFace {
                    face,
                    original,
                })
            }
            DefectKind::BoundaryEdge => {
                each(&self.boundary_edges, |&EdgeAt { edge, ends }| Defect::BoundaryEdge { edge, ends })
            }
            DefectKind::NonManifoldEdge => {
                each(&self.non_manifold_edges, |&(EdgeAt { edge, ends }, degree)| Defect::NonManifoldEdge {
                    edge,
                    ends,
                    degree,
                })
            }
            DefectKind::InconsistentEdge => each(&self.inconsistent_edges, |&EdgeAt { edge, ends }| {
                Defect::InconsistentEdge { edge, ends }
            }),
            DefectKind::PinchedVertex => {
                each(&self.pinched_vertices, |&Pinch { vertex, umbrellas, boundary_only }| {
                    Defect::PinchedVertex { vertex, umbrellas, boundary_only }
                })
            }
            DefectKind::SingularVertex => {
                each(&self.singular_vertices, |&vertex| Defect::SingularVertex { vertex })
            }
            DefectKind::NonFiniteVertex => {
                each(&self.non_finite_vertices, |&vertex| Defect::NonFiniteVertex { vertex })
            }
            DefectKind::UnreferencedVertex => {
                each(&self.unreferenced_vertices, |&vertex| Defect::UnreferencedVertex { vertex })
            }
            DefectKind::LooseEdge => {
                numbered(&self.loose_edges, |index, &ends| Defect::LooseEdge { index, ends })
            }
            DefectKind::LoosePoint => {
                numbered(&self.loose_points, |index, &vertex| Defect::LoosePoint { index, vertex })
            }
            DefectKind::NonOrientablePatch => each(&self.one_sided, |strip| strip.clone().into()),
            // What only some kernel, some pass or a look at positions finds.
            DefectKind::DifferingFace
            | DefectKind::PolygonFace
            | DefectKind::NonFiniteFace
            | DefectKind::FaceWithHole
            | DefectKind::CrossingFace
            | DefectKind::SeamEdge
            | DefectKind::CoincidentEdges
            | DefectKind::CoincidentVertex
            | DefectKind::UnjudgedPatch
            | DefectKind::TurnedCavity => Box::new(std::iter::empty()),
        }
    }

    /// All defects, by kind and then by id.
    pub fn iter(&self) -> impl Iterator<Item = Defect> + '_ {
        DefectKind::ALL.iter().flat_map(|&kind| self.of_kind(kind))
    }
}

type Defects<'a> = Box<dyn ExactSizeIterator<Item = Defect> + 'a>;

fn each<'a, T>(list: &'a [T], defect: impl Fn(&T) -> Defect + 'a) -> Defects<'a> {
    Box::new(list.iter().map(defect))
}

/// Elements that have no id of their own but a place in their list.
fn numbered<'a, T>(list: &'a [T], defect: impl Fn(u32, &T) -> Defect + 'a) -> Defects<'a> {
    Box::new(list.iter().enumerate().map(move |(place, item)| defect(place as u32, item)))
}

fn edges_of_degree_one<K: Connectivity>(kernel: &K) -> usize {
    kernel.edges().filter(|&edge| edge_class(kernel, edge) == EdgeClass::Boundary).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology;
    use meshmend_core::EdgeUse;

    #[test]
    fn every_kind_is_listed_in_order() {
        let faces: &[&[u32]] = &[
            &[0, 1, 2], // three on an edge, one of them twice, one reversed
            &[1, 2, 0],
            &[2, 1, 0],
            &[3, 4],                   // degenerate
            &[5, 6, 7, 5, 8, 9],       // non-simple, which pinches v5
            &[10, 11, 12, 12],         // a repeated corner
            &[10, 11, 13],             // runs along v10-v11 the same way
            &[15, 16, 17, 15, 16, 18], // a Möbius band of one face
        ];
        let mesh = crate::shapes::mesh(20, faces);
        let mut positions = mesh.positions().to_vec();
        positions[19] = [0.0, f64::NAN, 0.0];
        let mesh = mesh.with_positions(positions).unwrap();
        let mesh = mesh.with_loose(vec![[VertexId(3), VertexId(4)]], vec![VertexId(14)]).unwrap();
        let report = topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh);
        let kinds: Vec<DefectKind> = report.defects.iter().map(|d| d.kind()).collect();
        assert!(kinds.is_sorted());
        for (kind, count) in [
            (DefectKind::DegenerateFace, 1),
            (DefectKind::DuplicateFace, 1),
            (DefectKind::OppositeFace, 1),
            (DefectKind::RepeatedCorner, 1),
            (DefectKind::NonManifoldEdge, 3),
            (DefectKind::SingularVertex, 3),
            (DefectKind::NonSimpleFace, 2),
            (DefectKind::InconsistentEdge, 2),
            (DefectKind::NonOrientablePatch, 1),
            (DefectKind::NonFiniteVertex, 1),
            (DefectKind::UnreferencedVertex, 4),
            (DefectKind::LooseEdge, 1),
            (DefectKind::LoosePoint, 1),
            (DefectKind::CoincidentVertex, 0),
        ] {
            assert_eq!(report.defects.of_kind(kind).count(), count, "{kind}");
            assert_eq!(report.defects.count(kind), count, "{kind}");
        }
        let pinched = report.defects.of_kind(DefectKind::PinchedVertex).next();
        let expected = Defect::PinchedVertex { vertex: VertexId(5), umbrellas: 2, boundary_only: true };
        assert_eq!(pinched, Some(expected));
    }
}
