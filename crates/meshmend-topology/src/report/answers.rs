//! All questions asked of a mesh at once.

use std::convert::Infallible;
use std::sync::Arc;

use meshmend_core::{
    Cancelled, Column, Connectivity, DefectKind, KernelTask, PolygonMesh, Watch, vertex_classes,
};

use super::totals::SurfaceTotals;
use super::{DuplicateCounts, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness};
use crate::surfaces::component_kinds::{ComponentFacts, component_facts, component_kinds};
use crate::{
    Betti, ComponentId, Components, DefectList, Orientability, Patches, betti, boundary_loops, components,
    instigators, one_sided_loops, orientability, patches,
};

/// The topology of a mesh, through a kernel of its complex.
///
/// *Cost*: near-linear in the corners, but for the elimination that [`betti`] bounds; about 30 bytes a face of a
/// closed mesh while it runs, up to five times that for a soup of separate faces.
pub fn topology<K: Connectivity>(kernel: &K, mesh: &PolygonMesh) -> TopologyReport {
    let look = |_: usize| Ok::<(), Infallible>(());
    let Ok(report) = kernel.ask_of_all_vertices(AllAnswers { mesh, witness: Witness::BreadthFirst, look });
    report
}

/// The topology of a mesh, with a choice of what shows that a patch is not orientable, and for somebody who watches.
///
/// # Errors
/// [`Cancelled`] if the watch says so.
///
/// *Cost*: that of [`topology`], and for shortest witnesses that of [`one_sided_loops`].
pub fn topology_watched<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    witness: Witness,
    watch: &Watch,
) -> Result<TopologyReport, Cancelled> {
    let look = |done| watch.look("topology", done, QUESTIONS);
    kernel.ask_of_all_vertices(AllAnswers { mesh, witness, look })
}

/// Between how many groups of questions there is a look.
const QUESTIONS: usize = 5;

/// All questions, through whichever kernel, with what looks whether to go on.
struct AllAnswers<'a, L> {
    mesh: &'a PolygonMesh,
    witness: Witness,
    look: L,
}

impl<E: Send, L: Fn(usize) -> Result<(), E> + Sync> KernelTask for AllAnswers<'_, L> {
    type Output = Result<TopologyReport, E>;
    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        let AllAnswers { mesh, witness, look } = self;
        look(0)?;
        // Questions that need no other's answer are asked at the same time.
        let ((components, vertex_classes), patches) = rayon::join(
            || (components(kernel), look(1).map(|()| vertex_classes(kernel))),
            || patches(kernel),
        );
        let vertex_classes = vertex_classes?;
        look(2)?;
        let loops = boundary_loops(kernel);
        let facts = component_facts(kernel, &components, &patches, &vertex_classes, &loops);
        look(3)?;
        let (orientability, is_least) = witnesses(kernel, &patches, witness);
        look(4)?;
        let (defects, betti) = rayon::join(
            || Arc::new(DefectList::find(kernel, mesh, &vertex_classes, orientability)),
            || betti(kernel, &components, &patches),
        );
        look(QUESTIONS)?;
        let (edges, faces) = (kernel.edge_count() as u64, mesh.complex().proper_face_count() as u64);
        Ok(Answers { edges, faces, components, patches, facts, defects, betti, witness, is_least }.report())
    }
}

/// What each question was answered.
struct Answers {
    edges: u64,
    faces: u64,
    components: Components,
    patches: Patches,
    facts: Column<ComponentId, ComponentFacts>,
    defects: Arc<DefectList>,
    betti: Betti,
    witness: Witness,
    /// Whether each witness is as short as was asked for.
    is_least: bool,
}

impl Answers {
    fn report(self) -> TopologyReport {
        let Answers { edges, faces, components, patches, facts, defects, betti, witness, is_least } = self;
        let count = |kind: DefectKind| defects.count(kind) as u64;
        let vertices = components.referenced_vertices() as u64;
        let elements = [vertices, edges, faces];
        let (boundary_edges, non_manifold_edges) =
            (count(DefectKind::BoundaryEdge), count(DefectKind::NonManifoldEdge));
        let totals = SurfaceTotals::of(facts.values());
        let betti_unknown = (betti.z2.is_none() || betti.q.is_none()).then_some(Reason::EliminationBudget);
        let mut undefined = totals.undefined(components.count() > 0);
        undefined.extend(not_computed(betti_unknown, is_least));
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
            instigators: instigators(elements, components.count() as u64, betti.z2.map(|b| b[2])),
            component_kinds: component_kinds(&components, &facts),
            witness,
            undefined,
            defects,
        }
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

/// Which figures would have taken too long.
fn not_computed(betti_unknown: Option<Reason>, is_least: bool) -> impl Iterator<Item = Undefined> {
    let witness_unknown = (!is_least).then_some(Reason::SearchBudget);
    let figures = [("betti", betti_unknown), ("shortest_witness", witness_unknown)];
    figures.into_iter().filter_map(|(figure, reason)| Some(Undefined { figure, reason: reason? }))
}
