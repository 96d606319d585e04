//! All questions asked of a mesh at once.

use std::convert::Infallible;
use std::sync::Arc;

use meshmend_core::{Cancelled, Connectivity, KernelTask, PolygonMesh, Watch, vertex_classes};

use super::{Figures, Reason, TopologyReport, Undefined, Witness};
use crate::surfaces::component_kinds::{component_facts, component_kinds};
use crate::{
    DefectList, Orientability, Patches, betti, boundary_loops, components, one_sided_loops, orientability,
    patches,
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
        let figures = Figures {
            elements: [components.referenced_vertices() as u64, edges, faces],
            components: components.count() as u64,
            patches: patches.count() as u64,
            component_kinds: component_kinds(&components, &facts),
            betti,
            witness,
            witness_unknown: (!is_least)
                .then_some(Undefined { figure: "shortest_witness", reason: Reason::SearchBudget }),
        };
        Ok(TopologyReport {
            defects: Arc::clone(&defects),
            ..figures.report(|kind| defects.count(kind) as u64)
        })
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
