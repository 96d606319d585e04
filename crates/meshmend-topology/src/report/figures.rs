//! From what is counted to what is reported.

use std::sync::Arc;

use meshmend_core::DefectKind;

use super::totals::SurfaceTotals;
use super::{DuplicateCounts, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness};
use crate::{Betti, ComponentKind, DefectList, instigators};

/// What is known of a mesh beside the numbers of its defects: all other figures follow from these.
#[derive(Clone, Debug)]
pub struct Figures {
    /// V, E and F.
    pub elements: [u64; 3],
    /// How many components there are.
    pub components: u64,
    /// How many patches.
    pub patches: u64,
    /// The components by kind, ordered by lowest vertex.
    pub component_kinds: Vec<ComponentKind>,
    /// The Betti numbers.
    pub betti: Betti,
    /// Which strips show that patches are not orientable.
    pub witness: Witness,
    /// Which of these strips are not there, or not of that kind, and why.
    pub witness_unknown: Option<Undefined>,
}

impl Figures {
    /// The report, by how many defects of each kind there are. Its list of them is empty.
    pub fn report(self, count: impl Fn(DefectKind) -> u64) -> TopologyReport {
        let Figures { elements, components, patches, component_kinds, betti, witness, witness_unknown } =
            self;
        let [vertices, edges, faces] = elements;
        let totals = SurfaceTotals::of(&component_kinds);
        let betti_unknown = (betti.z2.is_none() || betti.q.is_none()).then_some(Reason::EliminationBudget);
        let mut undefined = totals.undefined(components > 0);
        undefined.extend(betti_unknown.map(|reason| Undefined { figure: "betti", reason }));
        undefined.extend(witness_unknown);
        let (boundary_edges, non_manifold_edges) =
            (count(DefectKind::BoundaryEdge), count(DefectKind::NonManifoldEdge));
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
            non_manifold_vertices: NonManifoldVertexCounts {
                pinched: count(DefectKind::PinchedVertex),
                singular: count(DefectKind::SingularVertex),
            },
            manifold: component_kinds.iter().all(|kind| kind.manifold),
            closed: faces > 0 && boundary_edges == 0,
            consistently_oriented: count(DefectKind::InconsistentEdge) == 0,
            orientable: count(DefectKind::NonOrientablePatch) == 0,
            euler_characteristic: vertices as i64 - edges as i64 + faces as i64,
            components,
            patches,
            non_orientable_patches: count(DefectKind::NonOrientablePatch),
            boundary_loops: totals.boundary_loops,
            genus: totals.genus,
            cross_caps: totals.cross_caps,
            betti,
            betti_unknown,
            instigators: instigators(elements, components, betti.z2.map(|b| b[2])),
            component_kinds,
            witness,
            undefined,
            defects: Arc::new(DefectList::default()),
        }
    }
}
