//! Structures that say less than a kernel, measured beside the kernels.

use std::time::Duration;

use meshmend_core::{Adjacency, Array, Complex, Per, PolygonMesh};
use meshmend_topology::matrices::{Graph, IncidenceMatrices};

use super::question::{edge_walk, vertex_neighbours};
use super::{KernelCost, KernelQuestion, Rung};

/// A structure that says less than a kernel: it can't be asked what a kernel is, only measured at what it answers.
///
/// ```
/// use meshmend::{AnyView, Rung};
///
/// let rungs: Vec<Rung> = AnyView::ALL.iter().map(|view| view.rung).collect();
/// assert_eq!(rungs, [Rung::Incidence, Rung::Adjacency, Rung::None]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct AnyView {
    /// What it is called in commands and reports.
    pub name: &'static str,
    /// How much it can say.
    pub rung: Rung,
    /// What it is, in a few sentences.
    pub explanation: &'static str,
    measure: fn(&PolygonMesh, &dyn Fn() -> Duration) -> KernelCost,
}

impl AnyView {
    /// All views, from the one that says most.
    pub const ALL: [AnyView; 3] = [
        AnyView {
            name: IncidenceMatrices::VIEW,
            rung: Rung::Incidence,
            explanation: "The boundary of each edge and of each face as two sparse matrices with entries -1, 0 and +1. They say which \
                vertices, edges and faces touch, and their ranks are the Betti numbers. They have no corners: not the order round a \
                face that comes back to a vertex, and not which corner is the first. `meshmend matrix` asks them. Source: \
                H. Poincaré, Complément à l'Analysis Situs, 1899.",
            measure: |mesh, clock| {
                let (matrices, built) = built(mesh, clock, IncidenceMatrices::of);
                let cost = cost(IncidenceMatrices::VIEW, matrices.arrays(), built);
                let cost =
                    asked(cost, KernelQuestion::VertexNeighbours, clock, || vertex_neighbours(&matrices));
                asked(cost, KernelQuestion::EdgeWalk, clock, || edge_walk(&matrices))
            },
        },
        AnyView {
            name: Graph::VIEW,
            rung: Rung::Adjacency,
            explanation: "Which vertices are joined, as a sparse symmetric matrix of zeros and ones. Its powers count walks, and its \
                eigenvalues are those of the graph. It has no faces: a tetrahedron and a tetrahedron without one of its faces have the \
                same matrix. `meshmend matrix` asks it. Source: course notes on the storage of polygonal meshes.",
            measure: |mesh, clock| {
                let (graph, built) = built(mesh, clock, Graph::of);
                let cost = cost(Graph::VIEW, graph.arrays(), built);
                asked(cost, KernelQuestion::VertexNeighbours, clock, || vertex_neighbours(&graph))
            },
        },
        AnyView {
            name: INDEPENDENT_FACES,
            rung: Rung::None,
            explanation: "Each face with the coordinates of its corners, and nothing else: what an STL file holds. No vertex is shared, so \
                not even their number is known before a weld makes a face-vertex table of it (`--weld exact`).",
            measure: |mesh, clock| {
                let (points, built) = built(mesh, clock, |complex| {
                    let corners = complex.faces().corner_vertices().iter();
                    corners.map(|vertex| mesh.positions()[vertex.0 as usize]).collect::<Vec<[f64; 3]>>()
                });
                let points = Array::new("points", Per::Corner, size_of::<[f64; 3]>(), points.len());
                cost(INDEPENDENT_FACES, vec![points], built)
            },
        },
    ];

    /// The view with a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|view| view.name == name)
    }

    /// What it costs on a mesh, measured as kernels are ([`KernelCost::of`]). Questions beyond its rung have no time and no answer.
    ///
    /// *Cost*: each run that of building it, and of its questions.
    pub fn cost(&self, mesh: &PolygonMesh, runs: usize, clock: &dyn Fn() -> Duration) -> KernelCost {
        let first = (self.measure)(mesh, clock);
        (1..runs).fold(first, |least, _| least.or_faster((self.measure)(mesh, clock)))
    }

    /// Whether it can answer a question.
    pub fn answers(&self, question: KernelQuestion) -> bool {
        question.rung() <= self.rung
    }
}

const INDEPENDENT_FACES: &str = "independent-faces";

/// A structure made of a complex of its own, and how long that took.
fn built<T>(
    mesh: &PolygonMesh,
    clock: &dyn Fn() -> Duration,
    build: impl FnOnce(&Complex) -> T,
) -> (T, Duration) {
    let fresh = Complex::of(&mesh.complex().shared_faces());
    let start = clock();
    let structure = build(&fresh);
    (structure, clock().saturating_sub(start))
}

fn cost(name: &'static str, arrays: Vec<Array>, built: Duration) -> KernelCost {
    let mut cost = KernelCost::unasked(name);
    cost.heap_bytes = arrays.iter().map(Array::bytes).sum();
    cost.arrays = arrays;
    cost.times[KernelQuestion::Build as usize] = Some(built);
    cost
}

fn asked(
    mut cost: KernelCost,
    question: KernelQuestion,
    clock: &dyn Fn() -> Duration,
    ask: impl FnOnce() -> u64,
) -> KernelCost {
    let start = clock();
    cost.answers[question as usize] = Some(ask());
    cost.times[question as usize] = Some(clock().saturating_sub(start));
    cost
}

#[cfg(test)]
mod tests {
    use meshmend_core::EdgeUse;
    use meshmend_shapes::{Closed, surface};

    use super::*;

    #[test]
    fn views_answer_as_kernels_do_and_only_what_their_rung_can() {
        let mesh = surface(Closed::Handles(1), 2, 3).unwrap().triangulated().unwrap().mesh;
        let wanted = KernelCost::of::<EdgeUse>(&mesh, 1, || Duration::ZERO).unwrap();
        for view in AnyView::ALL {
            let cost = view.cost(&mesh, 2, &|| Duration::ZERO);
            for question in KernelQuestion::ALL {
                assert_eq!(
                    cost.time(question).is_some(),
                    view.answers(question),
                    "{} {question:?}",
                    view.name
                );
                let answer = cost.answers[question as usize];
                assert!(answer.is_none() || answer == wanted.answers[question as usize], "{}", view.name);
            }
            assert!(cost.heap_bytes > 0 && AnyView::named(view.name).is_some());
        }
        assert!(AnyView::named("edge-use").is_none());
    }
}
