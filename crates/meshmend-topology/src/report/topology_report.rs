//! All figures of a mesh in one answer.

use std::sync::Arc;

use meshmend_core::{Connectivity, DefectKind, PolygonMesh, vertex_classes};
use serde::Serialize;

use crate::surfaces::component_kinds::{ComponentFacts, component_facts, component_kinds};
use crate::{
    Betti, ComponentKind, DefectList, Instigators, Orientability, Patches, Surface, betti, boundary_loops,
    components, instigators, one_sided_loops, orientability, patches,
};

/// The topology of a mesh: facts, sorted, without a word of text.
///
/// Vertices, edges and faces are those of the complex: referenced vertices, and no degenerate face. A figure that
/// is not defined for this mesh is absent, and [`undefined`](Self::undefined) says why.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct TopologyReport {
    /// V: vertices in some face of the complex.
    pub vertices: u64,
    /// E: unordered pairs of vertices that follow one another in some face.
    pub edges: u64,
    /// F: faces with three or more different vertices.
    pub faces: u64,
    /// Vertices in no face of the complex.
    pub unreferenced_vertices: u64,
    /// Edges that are elements of their own.
    pub loose_edges: u64,
    /// Points that are elements of their own.
    pub loose_points: u64,
    /// Vertices, unreferenced ones included, with a coordinate that is not finite.
    pub non_finite_vertices: u64,
    /// Faces with fewer than three different vertices.
    pub degenerate_faces: u64,
    /// Faces that come back to a vertex.
    pub non_simple_faces: u64,
    /// Faces that list a vertex twice in a row, or walk to a vertex and straight back.
    pub repeated_corner_faces: u64,
    /// Faces that repeat an earlier one.
    pub duplicate_faces: DuplicateCounts,
    /// Edges with one side.
    pub boundary_edges: u64,
    /// Edges with two sides.
    pub interior_edges: u64,
    /// Edges with three sides or more.
    pub non_manifold_edges: u64,
    /// Edges with two sides that run the same way.
    pub inconsistent_edges: u64,
    /// Vertices that are neither disc nor half-disc.
    pub non_manifold_vertices: NonManifoldVertexCounts,
    /// Whether every edge has one side or two and every vertex is disc or half-disc.
    pub manifold: bool,
    /// Whether there is a face and no edge has one side.
    pub closed: bool,
    /// Whether no edge is inconsistent.
    pub consistently_oriented: bool,
    /// Whether every patch is orientable.
    pub orientable: bool,
    /// χ = V − E + F.
    pub euler_characteristic: i64,
    /// s: classes of faces joined by shared vertices.
    pub components: u64,
    /// Classes of faces joined across edges with two sides.
    pub patches: u64,
    /// Patches that no flipping of faces makes consistent.
    pub non_orientable_patches: u64,
    /// b: boundary loops of all components; absent where one is not manifold.
    pub boundary_loops: Option<u64>,
    /// Handles of all orientable components; absent where a component is not manifold or none is orientable.
    pub genus: Option<u64>,
    /// Cross-caps of all non-orientable components; absent where a component is not manifold or none is
    /// non-orientable.
    pub cross_caps: Option<u64>,
    /// The Betti numbers.
    pub betti: Betti,
    /// Why a Betti number is absent.
    pub betti_unknown: Option<Reason>,
    /// Elements by what they negate and create.
    pub instigators: Instigators,
    /// The components by kind, ordered by lowest vertex.
    pub component_kinds: Vec<ComponentKind>,
    /// Which strips show that patches are not orientable.
    pub witness: Witness,
    /// Which figures are absent, and why.
    pub undefined: Vec<Undefined>,
    /// Where everything is that is wrong; apart from the figures, as it can be long.
    #[serde(skip)]
    pub defects: Arc<DefectList>,
}

/// How many faces repeat an earlier one, by the way in which they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct DuplicateCounts {
    /// With the same directed cycle.
    pub same: u64,
    /// With the reverse cycle, and none earlier the same.
    pub opposite: u64,
}

/// How many vertices are no vertices of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct NonManifoldVertexCounts {
    /// With two umbrellas or more.
    pub pinched: u64,
    /// At an edge with three sides or more.
    pub singular: u64,
}

/// Which strip of faces shows that a patch is not orientable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Witness {
    /// The one that is read off a breadth-first tree, in near-linear time.
    #[default]
    BreadthFirst,
    /// A shortest one.
    Shortest,
}

/// A figure that is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Undefined {
    /// Its key in the report.
    pub figure: &'static str,
    /// Why it is absent.
    pub reason: Reason,
}

/// Why a figure is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// A component is no surface, and only surfaces have the figure.
    NonManifoldComponent,
    /// There is no face that bounds anything, and so no surface.
    NoFaces,
    /// Only orientable components have the figure, and there is none.
    NoOrientableComponent,
    /// Only non-orientable components have the figure, and there is none.
    NoNonOrientableComponent,
    /// Elimination would touch more than [`ELIMINATION_BUDGET`](crate::ELIMINATION_BUDGET) matrix entries, or a
    /// reduction more than [`REDUCTION_BUDGET`](crate::REDUCTION_BUDGET).
    EliminationBudget,
    /// The search would look more than [`ONE_SIDED_BUDGET`](crate::ONE_SIDED_BUDGET) times at a side.
    SearchBudget,
}

/// The topology of a mesh, through a kernel of its complex.
///
/// *Cost*: near-linear in the corners, but for the elimination that [`betti`] bounds; about 30 bytes a face of a
/// closed mesh while it runs, up to five times that for a soup of separate faces.
pub fn topology<K: Connectivity>(kernel: &K, mesh: &PolygonMesh) -> TopologyReport {
    topology_with(kernel, mesh, Witness::BreadthFirst)
}

/// The topology of a mesh, with a choice of what shows that a patch is not orientable.
///
/// *Cost*: that of [`topology`], and for shortest witnesses that of [`one_sided_loops`].
pub fn topology_with<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, witness: Witness) -> TopologyReport {
    // Questions that need no other's answer are asked at the same time.
    let ((components, vertex_classes), patches) =
        rayon::join(|| (components(kernel), vertex_classes(kernel)), || patches(kernel));
    let facts = component_facts(kernel, &components, &patches, &vertex_classes, &boundary_loops(kernel));
    let (orientability, is_least) = witnesses(kernel, &patches, witness);
    let (defects, betti) = rayon::join(
        || Arc::new(DefectList::find(kernel, mesh, &vertex_classes, orientability)),
        || betti(kernel, &components, &patches),
    );

    let count = |kind: DefectKind| defects.count(kind) as u64;
    let vertices = components.referenced_vertices() as u64;
    let edges = kernel.edge_count() as u64;
    let faces = mesh.complex().proper_face_count() as u64;
    let non_manifold_vertices = NonManifoldVertexCounts {
        pinched: count(DefectKind::PinchedVertex),
        singular: count(DefectKind::SingularVertex),
    };
    let (boundary_edges, non_manifold_edges) =
        (count(DefectKind::BoundaryEdge), count(DefectKind::NonManifoldEdge));
    let totals = SurfaceTotals::of(facts.values());
    let mut undefined = totals.undefined(components.count() > 0);
    let betti_unknown = (betti.z2.is_none() || betti.q.is_none()).then_some(Reason::EliminationBudget);
    undefined.extend(betti_unknown.map(|reason| Undefined { figure: "betti", reason }));
    let witness_unknown = (!is_least).then_some(Reason::SearchBudget);
    undefined.extend(witness_unknown.map(|reason| Undefined { figure: "shortest_witness", reason }));
    TopologyReport {
        vertices,
        edges,
        faces,
        unreferenced_vertices: count(DefectKind::UnreferencedVertex),
        loose_edges: count(DefectKind::LooseEdge),
        loose_points: count(DefectKind::LoosePoint),
        non_finite_vertices: count(DefectKind::NonFiniteVertex),
        degenerate_faces: count(DefectKind::DegenerateFace),
        non_simple_faces: count(DefectKind::NonSimpleFace),
        repeated_corner_faces: count(DefectKind::RepeatedCorner),
        duplicate_faces: DuplicateCounts {
            same: count(DefectKind::DuplicateFace),
            opposite: count(DefectKind::OppositeFace),
        },
        boundary_edges,
        interior_edges: edges - boundary_edges - non_manifold_edges,
        non_manifold_edges,
        inconsistent_edges: count(DefectKind::InconsistentEdge),
        non_manifold_vertices,
        manifold: facts.values().iter().all(|component| component.is_manifold),
        closed: faces > 0 && boundary_edges == 0,
        consistently_oriented: count(DefectKind::InconsistentEdge) == 0,
        orientable: count(DefectKind::NonOrientablePatch) == 0,
        euler_characteristic: vertices as i64 - edges as i64 + faces as i64,
        components: components.count() as u64,
        patches: patches.count() as u64,
        non_orientable_patches: count(DefectKind::NonOrientablePatch),
        boundary_loops: totals.boundary_loops,
        genus: totals.genus,
        cross_caps: totals.cross_caps,
        betti,
        betti_unknown,
        instigators: instigators([vertices, edges, faces], components.count() as u64, betti.z2.map(|b| b[2])),
        component_kinds: component_kinds(&components, &facts),
        witness,
        undefined,
        defects,
    }
}

/// What shows that patches are not orientable, and whether it is as short as was asked for.
fn witnesses<K: Connectivity>(kernel: &K, patches: &Patches, witness: Witness) -> (Orientability, bool) {
    match witness {
        Witness::BreadthFirst => (orientability(kernel, patches), true),
        Witness::Shortest => {
            let loops = one_sided_loops(kernel, patches);
            let is_least = loops.iter().all(|found| found.is_shortest);
            (Orientability { one_sided: loops.into_iter().map(|found| found.strip).collect() }, is_least)
        }
    }
}

/// The figures that only surfaces have, summed over the components.
struct SurfaceTotals {
    boundary_loops: Option<u64>,
    genus: Option<u64>,
    cross_caps: Option<u64>,
}

impl SurfaceTotals {
    fn of(components: &[ComponentFacts]) -> Self {
        let surfaces = || components.iter().map(ComponentFacts::surface);
        if surfaces().any(|surface| surface.is_none()) {
            return SurfaceTotals { boundary_loops: None, genus: None, cross_caps: None };
        }
        let total = |figure: fn(Surface) -> Option<u64>| {
            surfaces()
                .flatten()
                .filter_map(figure)
                .fold(None, |sum: Option<u64>, one| Some(sum.unwrap_or(0) + one))
        };
        SurfaceTotals {
            boundary_loops: Some(surfaces().flatten().map(Surface::holes).sum()),
            genus: total(Surface::genus),
            cross_caps: total(Surface::cross_caps),
        }
    }

    /// Which of them are absent, and why.
    fn undefined(&self, has_components: bool) -> Vec<Undefined> {
        let not_all_manifold = self.boundary_loops.is_none();
        let why = |otherwise| match (has_components, not_all_manifold) {
            (false, _) => Reason::NoFaces,
            (true, true) => Reason::NonManifoldComponent,
            (true, false) => otherwise,
        };
        let figures = [
            ("boundary_loops", self.boundary_loops, Reason::NonManifoldComponent),
            ("genus", self.genus, why(Reason::NoOrientableComponent)),
            ("cross_caps", self.cross_caps, why(Reason::NoNonOrientableComponent)),
        ];
        let absent = figures.into_iter().filter(|(_, value, _)| value.is_none());
        absent.map(|(figure, _, reason)| Undefined { figure, reason }).collect()
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Defect, EdgeUse};
    use serde_json::{Value, json};

    use super::*;
    use crate::shapes::{self, Random, Shape};

    #[track_caller]
    fn assert_surface(shape: &Shape, elements: [u64; 3], name: &str) {
        let report = shape.report();
        assert_eq!([report.vertices, report.edges, report.faces], elements, "{name}");
        assert!(report.manifold);
        let names: Vec<_> = report.component_kinds.iter().map(|k| k.name.as_deref()).collect();
        assert_eq!(names, [Some(name)]);
    }

    #[test]
    fn the_platonic_solids_of_table_1() {
        let cube = Shape::of(&[
            &[0, 3, 2, 1],
            &[4, 5, 6, 7],
            &[0, 1, 5, 4],
            &[1, 2, 6, 5],
            &[2, 3, 7, 6],
            &[3, 0, 4, 7],
        ]);
        let icosahedron = icosahedron();
        assert_surface(&shapes::tetrahedron(), [4, 6, 4], "sphere");
        assert_surface(&cube, [8, 12, 6], "sphere");
        assert_surface(&dual(&cube), [6, 12, 8], "sphere");
        assert_surface(&icosahedron, [12, 30, 20], "sphere");
        assert_surface(&dual(&icosahedron), [20, 30, 12], "sphere");
    }

    fn icosahedron() -> Shape {
        let (top, upper, lower, bottom) = (0, |i| 1 + i % 5, |i| 6 + i % 5, 11);
        let column = |i: u32| {
            [
                vec![top, upper(i), upper(i + 1)],
                vec![upper(i), lower(i), upper(i + 1)],
                vec![upper(i + 1), lower(i), lower(i + 1)],
                vec![lower(i), bottom, lower(i + 1)],
            ]
        };
        Shape((0..5).flat_map(column).collect())
    }

    /// A closed, consistently oriented surface with a vertex for each face and a face for each vertex.
    fn dual(shape: &Shape) -> Shape {
        let kernel = shape.kernel();
        let round = |vertex| {
            let first = kernel.vertex_corners(vertex).next().unwrap();
            let next =
                |&corner: &_| kernel.across(kernel.prev_corner(corner)).filter(|&corner| corner != first);
            let corners = std::iter::successors(Some(first), next);
            corners.map(|corner| kernel.corner_face(corner).0).collect()
        };
        Shape(kernel.vertices().map(round).collect())
    }

    #[test]
    fn surfaces_by_name() {
        assert_surface(&shapes::torus(4, 3), [12, 24, 12], "torus");
        assert_surface(&shapes::klein_bottle(4, 5), [20, 40, 20], "Klein bottle");
        assert_surface(&shapes::projective_plane(), [6, 15, 10], "projective plane");
        assert_surface(&shapes::moebius_band(5), [10, 15, 5], "Möbius band");
        assert_surface(&shapes::annulus(6), [12, 18, 6], "annulus");
        assert_surface(&Shape::of(&[&[0, 1, 2, 3, 4, 5]]), [6, 6, 1], "disc");
        // One face, glued to itself along an edge both of whose sides are its own.
        assert_surface(&Shape::of(&[&[0, 1, 2, 0, 3, 4, 5, 3]]), [6, 7, 1], "annulus");
    }

    #[test]
    fn what_has_faces_and_no_edge_of_degree_one_is_closed() {
        for closed in [shapes::tetrahedron(), shapes::klein_bottle(4, 5), shapes::sphere_with_membrane()] {
            assert!(closed.report().closed, "{closed:?}");
        }
        for open in [shapes::annulus(6), shapes::bow_tie(), Shape::of(&[&[0, 1]])] {
            assert!(!open.report().closed, "{open:?}");
        }
    }

    #[test]
    fn nothing_is_manifold_and_open() {
        let report = Shape::of(&[]).report();
        assert!(report.manifold && !report.closed && report.consistently_oriented && report.orientable);
        assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (Some(0), None, None));
        assert_eq!(report.betti, Betti { z2: Some([0; 3]), q: Some([0; 3]) });
        assert_eq!(report.undefined.iter().map(|u| u.reason).collect::<Vec<_>>(), [Reason::NoFaces; 2]);
    }

    #[test]
    fn totals_sum_over_the_components_that_have_the_figure() {
        let parts =
            [shapes::torus(3, 3), shapes::klein_bottle(4, 4), shapes::torus(3, 4), shapes::moebius_band(5)];
        let report = Shape::side_by_side(&parts).report();
        assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (Some(1), Some(2), Some(3)));
        assert!(report.undefined.is_empty() && report.manifold && !report.orientable);
        assert_eq!((report.components, report.non_orientable_patches), (4, 2));
    }

    #[test]
    fn one_bad_component_leaves_the_totals_undefined() {
        let report = Shape::side_by_side(&[shapes::tetrahedron(), shapes::bow_tie()]).report();
        assert!(!report.manifold);
        assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (None, None, None));
        assert!(report.undefined.iter().all(|u| u.reason == Reason::NonManifoldComponent));
        assert_eq!(report.undefined.len(), 3);
        assert_eq!(report.non_manifold_vertices, NonManifoldVertexCounts { pinched: 1, singular: 0 });
    }

    #[test]
    fn the_json_says_what_is_absent() {
        let value = serde_json::to_value(shapes::bow_tie().report()).unwrap();
        assert_eq!(value["genus"], Value::Null);
        assert_eq!(value["undefined"][1], json!({"figure": "genus", "reason": "non-manifold-component"}));
        assert_eq!(value["betti"], json!({"z2": [1, 0, 0], "q": [1, 0, 0]}));
        assert_eq!(value["betti_unknown"], Value::Null);
        assert_eq!(value["non_manifold_vertices"], json!({"pinched": 1, "singular": 0}));
        assert_eq!(value["duplicate_faces"], json!({"same": 0, "opposite": 0}));
        assert_eq!(value["instigators"]["f_n"], 2);
        assert_eq!(value["component_kinds"][0]["name"], Value::Null);
        assert!(value.get("defects").is_none());
    }

    #[test]
    fn names_orders_and_first_corners_do_not_matter() {
        let mut random = Random(21);
        for round in 0..1000 {
            let shape = Shape(random.soup(4 + round % 7, 12, 7));
            let original = figures(&shape);
            let names = random.permutation(12);
            let order = random.permutation(shape.0.len());
            let renamed = order.iter().map(|&face| {
                let mut face: Vec<u32> = shape.0[face as usize].iter().map(|&v| names[v as usize]).collect();
                let places = random.below(face.len());
                face.rotate_left(places);
                face
            });
            let mut renamed = figures(&Shape(renamed.collect()));
            // How many of the vertices are in no face depends on how many there are.
            renamed["unreferenced_vertices"] = original["unreferenced_vertices"].clone();
            assert_eq!(original, renamed, "{shape:?}");
        }
    }

    /// The report but for the vertices and the order that it names.
    fn figures(shape: &Shape) -> Value {
        let mut value = serde_json::to_value(shape.report()).unwrap();
        let kinds = value["component_kinds"].as_array_mut().unwrap();
        kinds.iter_mut().for_each(|kind| kind["first_vertex"] = Value::Null);
        kinds.sort_by_key(Value::to_string);
        value
    }

    #[test]
    fn figures_fit_together_on_random_soups() {
        let mut random = Random(22);
        for round in 0..2000 {
            let report = Shape(random.soup(4 + round % 9, 14, 8)).report();
            let betti = report.betti.z2.unwrap().map(|b| b as i64);
            assert_eq!(betti[0] - betti[1] + betti[2], report.euler_characteristic);
            let i = report.instigators;
            assert_eq!(i.v_c - i.e_n, report.components);
            assert_eq!(i.e_c - i.f_n.unwrap(), report.betti.z2.unwrap()[1]);
            let no_bad_element = report.non_manifold_edges == 0
                && report.non_manifold_vertices == NonManifoldVertexCounts { pinched: 0, singular: 0 };
            assert_eq!(report.manifold, no_bad_element);
            assert_eq!(report.boundary_loops.is_some(), report.manifold);
            for kind in report.component_kinds.iter().filter(|kind| kind.manifold) {
                let twice = 2 * kind.genus.unwrap_or(0) + kind.cross_caps.unwrap_or(0);
                let holes = kind.boundary_loops.unwrap();
                assert_eq!(2 - kind.euler_characteristic, (twice + holes) as i64);
                assert_eq!(kind.closed, holes == 0);
            }
        }
    }

    #[test]
    fn a_shortest_witness_is_given_when_it_is_asked_for() {
        let shape = shapes::klein_bottle(5, 12);
        let mesh = shape.mesh();
        let kernel = EdgeUse::build(mesh.complex()).unwrap();
        let [usual, shortest] = [Witness::BreadthFirst, Witness::Shortest].map(|witness| {
            let report = topology_with(&kernel, &mesh, witness);
            assert!(report.witness == witness && report.undefined.iter().all(|u| u.figure == "genus"));
            let defect = report.defects.of_kind(DefectKind::NonOrientablePatch).next().unwrap();
            let Defect::NonOrientablePatch { faces, .. } = defect else { panic!("{defect:?}") };
            faces.len()
        });
        assert!(usual >= 6 && shortest == 6);
    }

    #[test]
    fn a_coordinate_that_is_no_number_is_told() {
        let mesh = shapes::tetrahedron().mesh();
        let mut positions = mesh.positions().to_vec();
        positions[2][1] = f64::INFINITY;
        let mesh = mesh.with_positions(positions).unwrap();
        let report = topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh);
        assert_eq!(report.non_finite_vertices, 1);
    }
}
