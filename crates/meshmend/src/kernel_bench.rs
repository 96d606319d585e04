//! What each way of storing connectivity costs on a mesh: to build, to hold, and to ask the usual questions.

use std::time::Duration;

use meshmend_core::{Complex, Connectivity, PolygonMesh, Refusal};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_topology::{boundary_loops, components, orientability, patches, topology};
use serde::Serialize;

/// What a kernel is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum KernelQuestion {
    /// To be built, with the table of edges if it needs that one.
    Build,
    /// For the corners round each vertex, and where their sides lead.
    OneRings,
    /// For the corners of each face, and the face across each side.
    FaceWalk,
    /// For the boundary loops.
    BoundaryWalk,
    /// For the components.
    Components,
    /// For the patches, and whether each can be oriented.
    Orientation,
    /// For the whole report on topology.
    Report,
}

/// What a kernel costs on a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct KernelCost {
    /// The kernel.
    pub kernel: KernelKind,
    /// Bytes on the heap, with those that it shares with the mesh.
    pub heap_bytes: usize,
    /// The least time that each question took, in the order of [`KernelQuestion::ALL`].
    pub times: [Duration; KernelQuestion::ALL.len()],
    /// A number that each answer comes down to: the same for every kernel.
    pub answers: [u64; KernelQuestion::ALL.len()],
}

impl KernelQuestion {
    /// Every question, in the order in which it is asked.
    pub const ALL: [Self; 7] = [
        KernelQuestion::Build,
        KernelQuestion::OneRings,
        KernelQuestion::FaceWalk,
        KernelQuestion::BoundaryWalk,
        KernelQuestion::Components,
        KernelQuestion::Orientation,
        KernelQuestion::Report,
    ];

    /// What it is called in reports, such as `one-rings`.
    pub fn name(self) -> &'static str {
        match self {
            KernelQuestion::Build => "build",
            KernelQuestion::OneRings => "one-rings",
            KernelQuestion::FaceWalk => "face-walk",
            KernelQuestion::BoundaryWalk => "boundary-walk",
            KernelQuestion::Components => "components",
            KernelQuestion::Orientation => "orientation",
            KernelQuestion::Report => "report",
        }
    }

    fn ask<K: Connectivity>(self, kernel: &K, mesh: &PolygonMesh) -> u64 {
        match self {
            KernelQuestion::Build => kernel.edge_count() as u64,
            KernelQuestion::OneRings => one_rings(kernel),
            KernelQuestion::FaceWalk => face_walk(kernel),
            KernelQuestion::BoundaryWalk => boundary_loops(kernel).count() as u64,
            KernelQuestion::Components => components(kernel).count() as u64,
            KernelQuestion::Orientation => orientability(kernel, &patches(kernel)).one_sided.len() as u64,
            KernelQuestion::Report => topology(kernel, mesh).edges,
        }
    }
}

impl KernelCost {
    /// Builds a kernel some times over a mesh and asks it everything, by a clock that tells the time since it was
    /// started. At least one run is made.
    ///
    /// ```
    /// use std::time::Instant;
    ///
    /// use meshmend::{FaceTable, KernelCost, KernelKind, KernelQuestion, PolygonMesh, VertexId};
    ///
    /// let faces = FaceTable::triangles(4, [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2].map(VertexId).to_vec())?;
    /// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], faces)?;
    /// let start = Instant::now();
    /// let cost = KernelCost::measure(KernelKind::HalfEdge, &mesh, 3, || start.elapsed())?;
    /// let time = cost.time(KernelQuestion::OneRings);
    /// assert!(time < start.elapsed());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the kernel can't hold the mesh: every reason why.
    ///
    /// *Cost*: each run that of a kernel and of [`topology`].
    pub fn measure(
        kernel: KernelKind,
        mesh: &PolygonMesh,
        runs: usize,
        clock: impl Fn() -> Duration,
    ) -> Result<Self, Refusal> {
        let mut cost = Self::run(kernel, mesh, &clock)?;
        for _ in 1..runs {
            let again = Self::run(kernel, mesh, &clock)?;
            for (least, time) in cost.times.iter_mut().zip(again.times) {
                *least = time.min(*least);
            }
        }
        Ok(cost)
    }

    /// How long a question took at least.
    pub fn time(&self, question: KernelQuestion) -> Duration {
        self.times[question as usize]
    }

    /// One run over a complex of its own, so that no run profits from what another one has built.
    fn run(kernel: KernelKind, mesh: &PolygonMesh, clock: &impl Fn() -> Duration) -> Result<Self, Refusal> {
        let fresh = Complex::of(&mesh.complex().shared_faces());
        let cost = KernelCost {
            kernel,
            heap_bytes: 0,
            times: [Duration::ZERO; KernelQuestion::ALL.len()],
            answers: [0; KernelQuestion::ALL.len()],
        };
        kernel.run(&fresh, AskEverything { start: clock(), clock, mesh, cost })
    }
}

struct AskEverything<'a, C> {
    /// When the kernel began to be built.
    start: Duration,
    clock: &'a C,
    mesh: &'a PolygonMesh,
    cost: KernelCost,
}

impl<C: Fn() -> Duration> KernelTask for AskEverything<'_, C> {
    type Output = KernelCost;
    fn run<K: Connectivity>(self, kernel: &K) -> KernelCost {
        let AskEverything { mut start, clock, mesh, mut cost } = self;
        cost.heap_bytes = kernel.heap_bytes();
        for question in KernelQuestion::ALL {
            cost.answers[question as usize] = question.ask(kernel, mesh);
            cost.times[question as usize] = clock().saturating_sub(start);
            start = clock();
        }
        cost
    }
}

/// The sum of the vertices to which the sides lead that begin at each vertex.
fn one_rings<K: Connectivity>(kernel: &K) -> u64 {
    let targets =
        |vertex| kernel.vertex_corners(vertex).map(|corner| u64::from(kernel.corner_target(corner).0));
    kernel.vertices().flat_map(targets).fold(0, u64::wrapping_add)
}

/// The sum of the faces across each side of each face.
fn face_walk<K: Connectivity>(kernel: &K) -> u64 {
    let across = |corner| kernel.across(corner).map(|other| u64::from(kernel.corner_face(other).0) + 1);
    let neighbours = |face| kernel.face_corners(face).filter_map(across);
    kernel.faces().flat_map(neighbours).fold(0, u64::wrapping_add)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use meshmend_shapes::{Closed, moebius_band, surface};

    use super::*;

    /// A clock that is a second later each time it is looked at.
    fn ticking() -> impl Fn() -> Duration {
        let looks = Cell::new(0);
        move || {
            looks.set(looks.get() + 1);
            Duration::from_secs(looks.get())
        }
    }

    #[test]
    fn questions_stand_in_their_own_order_and_names_are_those_of_json() {
        for (place, question) in KernelQuestion::ALL.into_iter().enumerate() {
            assert_eq!(question as usize, place);
            assert_eq!(serde_json::to_value(question).unwrap(), question.name());
        }
    }

    #[test]
    fn every_kernel_comes_to_the_same_answers() {
        let mesh = surface(Closed::Handles(2), 3, 3).unwrap().triangulated().unwrap().mesh;
        let costs = KernelKind::ALL.iter().map(|&kernel| KernelCost::measure(kernel, &mesh, 2, ticking()));
        let costs: Vec<KernelCost> = costs.map(Result::unwrap).collect();
        for cost in &costs {
            assert_eq!(cost.answers, costs[0].answers, "{}", cost.kernel);
            assert!(cost.heap_bytes > 0);
        }
        let answer = |question: KernelQuestion| costs[0].answers[question as usize];
        let edges = mesh.complex().edges().edge_count() as u64;
        assert_eq!([answer(KernelQuestion::Build), answer(KernelQuestion::Report)], [edges; 2]);
        assert_eq!(answer(KernelQuestion::BoundaryWalk), 3);
        assert_eq!(answer(KernelQuestion::Components), 1);
        assert_eq!(answer(KernelQuestion::Orientation), 0);
        assert!(answer(KernelQuestion::OneRings) > 0 && answer(KernelQuestion::FaceWalk) > 0);
    }

    #[test]
    fn each_question_is_timed_by_the_clock_that_was_given() {
        let mesh = moebius_band(5, 2).unwrap().mesh;
        let cost = KernelCost::measure(KernelKind::EdgeUse, &mesh, 1, ticking()).unwrap();
        assert_eq!(cost.times, [Duration::from_secs(1); 7]);
        assert_eq!(cost.answers[KernelQuestion::Orientation as usize], 1);
        assert!(KernelCost::measure(KernelKind::HalfEdge, &mesh, 1, ticking()).is_err());
    }
}
