//! What each structure costs on a mesh: to build, to hold, and to ask the usual questions.

use std::time::Duration;

use meshmend_core::{Array, Build, Complex, Connectivity, PolygonMesh, Refusal};

use super::KernelQuestion;

/// The most proper faces of a mesh for which a kernel is asked what takes it quadratic time.
pub const LINEAR_LIMIT: usize = 10_000;

/// What a kernel costs on a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct KernelCost {
    /// The kernel's name.
    pub kernel: &'static str,
    /// The arrays that it consists of.
    pub arrays: Vec<Array>,
    /// Bytes on the heap, with those that it shares with the mesh.
    pub heap_bytes: usize,
    /// The least time that each question took, in the order of [`KernelQuestion::ALL`]; `None` where it was not asked,
    /// since a star takes the kernel linear time and the mesh has more than [`LINEAR_LIMIT`] faces.
    pub times: [Option<Duration>; KernelQuestion::ALL.len()],
    /// A number that each answer comes down to: the same for every kernel.
    pub answers: [Option<u64>; KernelQuestion::ALL.len()],
}

impl KernelCost {
    /// Builds a kernel some times over a mesh and asks it everything, by a clock that tells the time since it was
    /// started. At least one run is made.
    ///
    /// ```
    /// use std::time::Instant;
    ///
    /// use meshmend::kernels::HalfEdge;
    /// use meshmend::{KernelCost, KernelQuestion, PolygonMesh};
    ///
    /// let mesh = PolygonMesh::from_triangles(&[[0.0; 3]; 4], &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])?;
    /// let start = Instant::now();
    /// let cost = KernelCost::of::<HalfEdge>(&mesh, 3, || start.elapsed())?;
    /// let time = cost.time(KernelQuestion::OneRings);
    /// assert!(time.is_some_and(|time| time < start.elapsed()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the kernel can't hold the mesh: every reason why.
    ///
    /// *Cost*: each run that of a kernel and of [`topology`](meshmend_topology::topology()).
    pub fn of<K: Connectivity>(
        mesh: &PolygonMesh,
        runs: usize,
        clock: impl Fn() -> Duration,
    ) -> Result<Self, Refusal> {
        let first = Self::of_run::<K>(mesh, &clock)?;
        (1..runs).try_fold(first, |least, _| Ok(least.or_faster(Self::of_run::<K>(mesh, &clock)?)))
    }

    /// A structure that has not been asked anything.
    pub(super) fn unasked(kernel: &'static str) -> Self {
        KernelCost {
            kernel,
            arrays: Vec::new(),
            heap_bytes: 0,
            times: [None; KernelQuestion::ALL.len()],
            answers: [None; KernelQuestion::ALL.len()],
        }
    }

    /// Of two runs the lesser time for each question.
    #[must_use]
    pub(super) fn or_faster(mut self, other: Self) -> Self {
        for (least, time) in self.times.iter_mut().zip(other.times) {
            *least = time.min(*least);
        }
        self
    }

    /// How long a question took at least; `None` where it was not asked.
    pub fn time(&self, question: KernelQuestion) -> Option<Duration> {
        self.times[question as usize]
    }

    /// One run over a complex of its own, so that no run profits from what another one has built.
    fn of_run<K: Connectivity>(mesh: &PolygonMesh, clock: &impl Fn() -> Duration) -> Result<Self, Refusal> {
        let fresh = Complex::of(&mesh.complex().shared_faces());
        let is_large = mesh.complex().proper_face_count() > LINEAR_LIMIT;
        let mut start = clock();
        let kernel = K::build(&fresh)?;
        let mut cost = Self::unasked(K::NAME);
        for question in KernelQuestion::ALL {
            if !(is_large && question.is_quadratic(&K::COSTS)) {
                cost.answers[question as usize] = Some(question.ask(&kernel, mesh));
                cost.times[question as usize] = Some(clock().saturating_sub(start));
            }
            start = clock();
        }
        (cost.heap_bytes, cost.arrays) = (kernel.heap_bytes(), kernel.arrays());
        Ok(cost)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use meshmend_core::EdgeUse;
    use meshmend_kernels::HalfEdge;
    use meshmend_shapes::{Closed, moebius_band, surface};

    use super::*;
    use crate::Kernels;

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
        let costs = Kernels::builtin().all().map(|kernel| kernel.cost(&mesh, 2, &ticking()));
        let costs: Vec<KernelCost> = costs.map(Result::unwrap).collect();
        for cost in &costs {
            assert_eq!(cost.answers, costs[0].answers, "{}", cost.kernel);
            assert!(cost.heap_bytes > 0);
        }
        let answer = |question: KernelQuestion| costs[0].answers[question as usize].unwrap();
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
        let cost = KernelCost::of::<EdgeUse>(&mesh, 1, ticking()).unwrap();
        assert_eq!(cost.times, [Some(Duration::from_secs(1)); KernelQuestion::ALL.len()]);
        assert_eq!(cost.answers[KernelQuestion::Orientation as usize], Some(1));
        assert!(KernelCost::of::<HalfEdge>(&mesh, 1, ticking()).is_err());
    }
}
