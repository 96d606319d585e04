//! What a kernel holds, and the list of everything in a mesh that lies outside it.

use std::fmt;

use serde::Serialize;

use crate::{
    Complex, Connectivity, Defect, EdgeClass, EdgeUse, FaceId, Id, VertexClass, distinct_count, edge_class,
    is_inconsistent, vertex_classes,
};

/// What a kernel admits, and what it offers beyond the questions that all kernels answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Capabilities {
    /// Faces that come back to a vertex.
    pub non_simple_faces: bool,
    /// Edges with three sides or more.
    pub non_manifold_edges: bool,
    /// Vertices that are neither disc nor half-disc.
    pub non_manifold_vertices: bool,
    /// Edges both of whose sides run the same way.
    pub mixed_orientation: bool,
    /// Faces with more than three corners.
    pub polygons: bool,
    /// A vertex's corners come in rotational order instead of ascending.
    pub ordered_vertex_stars: bool,
}

impl Capabilities {
    /// A kernel that holds any complex.
    pub const PERMISSIVE: Capabilities = Capabilities {
        non_simple_faces: true,
        non_manifold_edges: true,
        non_manifold_vertices: true,
        mixed_orientation: true,
        polygons: true,
        ordered_vertex_stars: false,
    };

    /// Whether every complex is admitted.
    pub fn is_permissive(&self) -> bool {
        self.non_simple_faces
            && self.non_manifold_edges
            && self.non_manifold_vertices
            && self.mixed_orientation
            && self.polygons
    }
}

/// Why a kernel can't hold a mesh: every reason, never only the first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// The kernel that refuses.
    pub kernel: &'static str,
    /// Everything in the mesh that it does not admit, by kind and then by id.
    pub defects: Vec<Defect>,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the {} kernel can't hold this mesh", self.kernel)?;
        let kinds = self.defects.chunk_by(|one, other| one.kind() == other.kind());
        for (place, run) in kinds.enumerate() {
            let before = if place == 0 { ":" } else { ";" };
            write!(f, "{before} {} {} ({})", run.len(), run[0].kind().title(), run[0])?;
        }
        Ok(())
    }
}

impl std::error::Error for Refusal {}

/// Everything in a complex that lies outside some capabilities, by kind and then by id.
///
/// *Cost*: O(n log d); nothing for a permissive kernel.
pub fn admission(complex: &Complex, capabilities: &Capabilities) -> Vec<Defect> {
    if capabilities.is_permissive() {
        return Vec::new();
    }
    let kernel = EdgeUse::assemble(complex);
    let mut defects = Vec::new();
    if !capabilities.non_simple_faces {
        defects.extend(complex.faces().faces().filter_map(|f| non_simple_face(complex, f)));
    }
    if !capabilities.polygons {
        defects.extend(complex.faces().faces().filter_map(|face| {
            let corners = complex.faces().corner_range(face).len() as u32;
            (corners > 3).then_some(Defect::PolygonFace { face, corners })
        }));
    }
    if !capabilities.non_manifold_edges {
        defects.extend(kernel.edges().filter(|&e| edge_class(&kernel, e) == EdgeClass::NonManifold).map(
            |edge| {
                let degree = kernel.edge_degree(edge) as u32;
                Defect::NonManifoldEdge { edge, ends: kernel.edge_ends(edge), degree }
            },
        ));
    }
    if !capabilities.mixed_orientation {
        let inconsistent = kernel.edges().filter(|&e| is_inconsistent(&kernel, e));
        defects
            .extend(inconsistent.map(|edge| Defect::InconsistentEdge { edge, ends: kernel.edge_ends(edge) }));
    }
    if !capabilities.non_manifold_vertices {
        defects.extend(vertex_classes(&kernel).iter().filter_map(|(vertex, &class)| match class {
            VertexClass::Pinched { umbrellas, boundary_only } => {
                Some(Defect::PinchedVertex { vertex, umbrellas, boundary_only })
            }
            VertexClass::Singular => Some(Defect::SingularVertex { vertex }),
            _ => None,
        }));
    }
    defects.sort_by_key(Defect::kind);
    defects
}

/// The defect of a face of the complex that comes back to a vertex, naming the first vertex that recurs.
fn non_simple_face(complex: &Complex, face: FaceId) -> Option<Defect> {
    let vertices = complex.faces().face_vertices(face);
    if distinct_count(vertices) == vertices.len() {
        return None;
    }
    let mut places: Vec<_> = vertices.iter().copied().zip(0..).collect::<Vec<(_, u32)>>();
    places.sort_unstable();
    let recurs = places.windows(2).filter(|pair| pair[0].0 == pair[1].0).min_by_key(|pair| pair[1].1)?;
    Some(Defect::NonSimpleFace { face: FaceId::new(face.index()), vertex: recurs[0].0 })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{DefectKind, FaceTableBuilder, VertexId};

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
            "the strict kernel can't hold this mesh: 1 pinched vertices (v0 joins 2 umbrellas, all open)";
        assert_eq!(refusal.to_string(), text);
    }

    #[test]
    fn a_face_that_comes_back_names_the_vertex_that_recurs_first() {
        let complex = complex(&[&[3, 1, 2, 1, 3, 4]]);
        assert_eq!(
            admission(&complex, &STRICT)[0],
            Defect::NonSimpleFace { face: FaceId(0), vertex: VertexId(1) }
        );
    }
}
