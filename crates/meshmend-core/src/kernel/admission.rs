//! The list of everything in a mesh that lies outside what a kernel holds.

use std::cell::OnceCell;
use std::fmt;
use std::sync::Arc;

use crate::{
    Capabilities, Column, Complex, Connectivity, Defect, DefectKind, EdgeClass, EdgeUse, FaceId, FaceTable,
    VertexClass, VertexId, distinct_count, edge_class, is_inconsistent, vertex_classes,
};

/// Why a kernel can't hold a mesh: every reason, never only the first.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Refusal {
    /// The kernel that refuses.
    pub kernel: &'static str,
    /// Everything in the mesh that it does not admit, by kind and then by id.
    pub defects: Vec<Defect>,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the {} kernel can't hold this mesh", self.kernel)?;
        let kinds = self.defects.chunk_by(|one, other| one.kind == other.kind);
        for (place, run) in kinds.enumerate() {
            let before = if place == 0 { ":" } else { ";" };
            write!(f, "{before} {}: {} ({})", run[0].kind.title(), run.len(), run[0])?;
        }
        Ok(())
    }
}

impl std::error::Error for Refusal {}

/// A kind of defect that a kernel may refuse to hold: by which capability it is admitted, and how it is found.
struct Admitted {
    kind: DefectKind,
    by: fn(&Capabilities) -> bool,
    find: fn(&Look) -> Vec<Defect>,
}

/// All kinds that a kernel may refuse to hold, in the order of kinds.
const ADMITTED: [Admitted; 6] = [
    Admitted {
        kind: DefectKind::NonSimpleFace,
        by: |able| able.non_simple_faces,
        find: Look::non_simple_faces,
    },
    Admitted { kind: DefectKind::PolygonFace, by: |able| able.polygons, find: Look::polygons },
    Admitted {
        kind: DefectKind::NonManifoldEdge,
        by: |able| able.non_manifold_edges,
        find: Look::non_manifold_edges,
    },
    Admitted {
        kind: DefectKind::InconsistentEdge,
        by: |able| able.mixed_orientation,
        find: Look::inconsistent_edges,
    },
    Admitted {
        kind: DefectKind::PinchedVertex,
        by: |able| able.non_manifold_vertices,
        find: Look::pinched_vertices,
    },
    Admitted {
        kind: DefectKind::SingularVertex,
        by: |able| able.non_manifold_vertices,
        find: Look::singular_vertices,
    },
];

impl Capabilities {
    /// The kinds of defect that are not admitted, in order.
    pub fn refused_kinds(&self) -> impl Iterator<Item = DefectKind> {
        ADMITTED.iter().filter(|row| !(row.by)(self)).map(|row| row.kind)
    }
}

/// Everything in a complex that lies outside some capabilities, by kind and then by id.
///
/// *Cost*: O(n log d); nothing for a permissive kernel.
pub fn admission(complex: &Complex, capabilities: &Capabilities) -> Vec<Defect> {
    if capabilities.is_permissive() {
        return Vec::new();
    }
    let look = Look {
        faces: complex.shared_faces(),
        kernel: EdgeUse::assemble(complex),
        vertex_classes: OnceCell::new(),
    };
    let refused = ADMITTED.iter().filter(|row| !(row.by)(capabilities));
    refused.flat_map(|row| (row.find)(&look)).collect()
}

/// A complex that is looked at, with what several kinds are read off.
struct Look {
    faces: Arc<FaceTable>,
    kernel: EdgeUse,
    vertex_classes: OnceCell<Column<VertexId, VertexClass>>,
}

impl Look {
    fn non_simple_faces(&self) -> Vec<Defect> {
        self.faces.faces().filter_map(|face| non_simple_face(&self.faces, face)).collect()
    }

    fn polygons(&self) -> Vec<Defect> {
        let corners = |face| self.faces.corner_range(face).len() as u32;
        let polygons = self.faces.faces().filter(|&face| corners(face) > 3);
        polygons.map(|face| Defect::polygon_face(face, corners(face))).collect()
    }

    fn non_manifold_edges(&self) -> Vec<Defect> {
        let kernel = &self.kernel;
        let branching = kernel.edges().filter(|&edge| edge_class(kernel, edge) == EdgeClass::NonManifold);
        let defect =
            |edge| Defect::non_manifold_edge(edge, kernel.edge_ends(edge), kernel.edge_degree(edge) as u32);
        branching.map(defect).collect()
    }

    fn inconsistent_edges(&self) -> Vec<Defect> {
        let kernel = &self.kernel;
        let inconsistent = kernel.edges().filter(|&edge| is_inconsistent(kernel, edge));
        inconsistent.map(|edge| Defect::inconsistent_edge(edge, kernel.edge_ends(edge))).collect()
    }

    fn pinched_vertices(&self) -> Vec<Defect> {
        let pinched = |(vertex, &class): (VertexId, &VertexClass)| match class {
            VertexClass::Pinched { umbrellas, boundary_only } => {
                Some(Defect::pinched_vertex(vertex, umbrellas, boundary_only))
            }
            _ => None,
        };
        self.vertex_classes().iter().filter_map(pinched).collect()
    }

    fn singular_vertices(&self) -> Vec<Defect> {
        let singular = self.vertex_classes().iter().filter(|&(_, &class)| class == VertexClass::Singular);
        singular.map(|(vertex, _)| Defect::singular_vertex(vertex)).collect()
    }

    fn vertex_classes(&self) -> &Column<VertexId, VertexClass> {
        self.vertex_classes.get_or_init(|| vertex_classes(&self.kernel))
    }
}

/// The defect of a face of the complex that comes back to a vertex, naming the first vertex that recurs.
fn non_simple_face(faces: &FaceTable, face: FaceId) -> Option<Defect> {
    let vertices = faces.face_vertices(face);
    if distinct_count(vertices) == vertices.len() {
        return None;
    }
    let mut places: Vec<_> = vertices.iter().copied().zip(0..).collect::<Vec<(_, u32)>>();
    places.sort_unstable();
    let recurs = places.windows(2).filter(|pair| pair[0].0 == pair[1].0).min_by_key(|pair| pair[1].1)?;
    Some(Defect::non_simple_face(face, recurs[0].0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceTableBuilder;

    fn complex(faces: &[&[u32]]) -> Complex {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        Complex::of(&Arc::new(builder.build(9).unwrap()))
    }

    /// A kernel that holds nothing but closed triangle surfaces whose faces agree.
    const STRICT: Capabilities = Capabilities {
        non_simple_faces: false,
        non_manifold_edges: false,
        non_manifold_vertices: false,
        mixed_orientation: false,
        polygons: false,
        ordered_vertex_stars: true,
    };

    #[test]
    fn every_reason_is_listed_by_kind() {
        // A book of three pages, a square, a face that comes back to a vertex, and a clash along an edge.
        let complex =
            complex(&[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[5, 6, 7, 8], &[5, 6, 2, 5, 7], &[0, 0, 1]]);
        let kinds: Vec<DefectKind> = admission(&complex, &STRICT).iter().map(Defect::kind).collect();
        let count = |kind| kinds.iter().filter(|&&k| k == kind).count();
        assert_eq!(count(DefectKind::NonSimpleFace), 1);
        assert_eq!(count(DefectKind::PolygonFace), 2);
        assert_eq!(count(DefectKind::NonManifoldEdge), 1);
        assert_eq!(count(DefectKind::InconsistentEdge), 1);
        assert_eq!(count(DefectKind::SingularVertex), 2);
        assert!(kinds.is_sorted());
        assert!(admission(&complex, &Capabilities::PERMISSIVE).is_empty());
    }

    #[test]
    fn each_capability_answers_for_its_own_kinds() {
        use DefectKind::*;
        let complex = complex(&[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[5, 6, 7, 8], &[5, 6, 2, 5, 7]]);
        let all = Capabilities::PERMISSIVE;
        let cases = [
            (Capabilities { non_simple_faces: false, ..all }, vec![NonSimpleFace]),
            (Capabilities { polygons: false, ..all }, vec![PolygonFace, PolygonFace]),
            (Capabilities { non_manifold_edges: false, ..all }, vec![NonManifoldEdge]),
            (Capabilities { mixed_orientation: false, ..all }, vec![InconsistentEdge]),
            (Capabilities { non_manifold_vertices: false, ..all }, vec![PinchedVertex, SingularVertex]),
        ];
        for (capabilities, expected) in cases {
            let mut kinds: Vec<_> = admission(&complex, &capabilities).iter().map(Defect::kind).collect();
            if expected.contains(&SingularVertex) {
                kinds.dedup();
            }
            assert_eq!(kinds, expected, "{capabilities:?}");
        }
    }

    #[test]
    fn a_refusal_says_how_many_of_what_and_where() {
        let complex = complex(&[&[0, 1, 2], &[0, 3, 4]]);
        let refusal = Refusal { kernel: "strict", defects: admission(&complex, &STRICT) };
        let text =
            "the strict kernel can't hold this mesh: pinched vertices: 1 (v0 joins 2 umbrellas, all open)";
        assert_eq!(refusal.to_string(), text);
    }

    #[test]
    fn a_face_that_comes_back_names_the_vertex_that_recurs_first() {
        let complex = complex(&[&[3, 1, 2, 1, 3, 4]]);
        assert_eq!(admission(&complex, &STRICT)[0], Defect::non_simple_face(FaceId(0), VertexId(1)));
    }
}
