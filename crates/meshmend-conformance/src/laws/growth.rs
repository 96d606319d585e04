//! `growth`: answers cost what `COSTS` says.
//!
//! Time is judged by how it grows. A mesh eight times as large has eight times as many elements to ask about, so asking
//! about all of them takes eight times as long where an answer takes constant time, and sixty-four times where it takes a
//! search. An answer that takes longer than the patience is judged by whoever watches.

use std::hint::black_box;
use std::time::{Duration, Instant};

use meshmend_core::{Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId, Id, VertexId};

use super::law::{Breach, Law};
use crate::guard::{Stopped, caught};

pub(super) const GROWTH: Law = Law {
    id: "growth",
    sentence: "on a fan, a strip, a polygon, a book and a torus of 20 000 faces every answer comes within the patience, and its \
        cost does not grow with the mesh, unless COSTS says that it is linear",
    why: "a structure is chosen for what its answers cost",
    often: Some("a search in the whole list"),
};

/// A mesh of a family in two sizes, the second one eight times as large.
pub(crate) struct Sizes<'a> {
    /// What it is called, such as `a fan`.
    pub(crate) family: &'a str,
    /// The complexes.
    pub(crate) complexes: [&'a Complex; 2],
    /// Whether many corners are at one element, so that an answer may take long by right.
    pub(crate) is_crowded: bool,
}

/// What takes less is not judged: a busy machine is elsewhere as long.
const NOTICEABLE: Duration = Duration::from_millis(250);
/// How many times as long the larger mesh may take.
const MOST_GROWTH: u32 = 24;
/// So many measurements must agree.
const RUNS: usize = 2;
/// Each how many elements it is looked whether the time is up.
const GLANCE: usize = 16;
/// So many elements are asked about where each answer may take long by right.
const FEW: usize = 256;

/// A kind of question: its name, where its cost is declared, and how it is asked about every so many elements until the time
/// is up.
struct Question<K> {
    name: &'static str,
    cost: fn(&Costs) -> Cost,
    ask: fn(&K, &Complex, Asking),
}

/// About every how many elements a question is asked, and until when.
#[derive(Clone, Copy)]
struct Asking {
    step: usize,
    end: Option<Instant>,
}

/// Asks kernels over the two sizes about all elements; whoever watches is told before each measurement. A question that
/// panics is another law's matter.
///
/// # Errors
/// The question whose cost grows with the mesh, though `COSTS` says that it does not; or one that is not asked any more.
pub(crate) fn growth<K: Connectivity>(
    kernels: [&K; 2],
    sizes: &Sizes<'_>,
    begins: &dyn Fn(),
) -> Result<Result<(), Breach>, Stopped> {
    for question in questions::<K>() {
        let cost = (question.cost)(&K::COSTS);
        let time = |which: usize, most: Option<Duration>| {
            begins();
            let (complex, begun) = (sizes.complexes[which], Instant::now());
            let asking = Asking {
                step: step(complex, cost, sizes.is_crowded),
                end: most.and_then(|most| begun.checked_add(most)),
            };
            match caught(|| (question.ask)(kernels[which], complex, asking)) {
                Err(Stopped::Closed(query)) => Err(Stopped::Closed(query)),
                _ => Ok(begun.elapsed()),
            }
        };
        if cost != Cost::Linear && is_slow(time)? {
            return Ok(Err(Breach {
                question: format!("the cost of {} on {}", question.name, sizes.family),
                found: "linear".to_owned(),
                expected: format!("{}, as COSTS says", said(cost)),
            }));
        }
    }
    Ok(Ok(()))
}

/// Whether the larger of two meshes takes too long beside the smaller one, in every one of several measurements.
fn is_slow(time: impl Fn(usize, Option<Duration>) -> Result<Duration, Stopped>) -> Result<bool, Stopped> {
    for _ in 0..RUNS {
        let most = NOTICEABLE.max(time(0, None)? * MOST_GROWTH);
        if time(1, Some(most))? < most {
            return Ok(false);
        }
    }
    Ok(true)
}

fn said(cost: Cost) -> &'static str {
    match cost {
        Cost::Constant => "constant",
        Cost::Degree => "of the degree",
        Cost::Linear => "linear",
    }
}

/// Every how many elements are asked about.
fn step(complex: &Complex, cost: Cost, is_crowded: bool) -> usize {
    if cost == Cost::Degree && is_crowded { (complex.faces().corner_count() / FEW).max(1) } else { 1 }
}

macro_rules! questions {
    ($kernel:ident: $($method:ident of $elements:ident costs $cost:ident $($counted:ident)?,)*) => {
        vec![$(Question {
            name: stringify!($method),
            cost: |costs| costs.$cost,
            ask: |kernel: &$kernel, complex, asking| {
                of($elements(complex), asking, |element| kernel.$method(element)$(.$counted())?);
            },
        },)*]
    };
}

fn questions<K: Connectivity>() -> Vec<Question<K>> {
    questions! {
        K:
        corner_vertex of corners costs corner,
        corner_edge of corners costs corner,
        corner_face of corners costs corner,
        next_corner of corners costs corner,
        prev_corner of corners costs corner,
        edge_ends of edges costs corner,
        across of corners costs across,
        face_corners of faces costs face_star count,
        edge_corners of edges costs edge_star count,
        vertex_corners of vertices costs vertex_star count,
    }
}

/// Asks about each element until the time is up, and has the answers made whatever the compiler thinks of it.
fn of<I, T>(elements: impl Iterator<Item = I>, asking: Asking, ask: impl Fn(I) -> T) {
    for (number, element) in elements.step_by(asking.step).enumerate() {
        black_box(ask(element));
        if number.is_multiple_of(GLANCE) && asking.end.is_some_and(|end| Instant::now() >= end) {
            break;
        }
    }
}

fn corners(complex: &Complex) -> impl Iterator<Item = CornerId> + use<> {
    (0..complex.faces().corner_count()).map(CornerId::new)
}

fn edges(complex: &Complex) -> impl Iterator<Item = EdgeId> + use<> {
    (0..complex.edges().edge_count()).map(EdgeId::new)
}

fn faces(complex: &Complex) -> impl Iterator<Item = FaceId> + use<> {
    (0..complex.faces().face_count()).map(FaceId::new)
}

fn vertices(complex: &Complex) -> impl Iterator<Item = VertexId> + use<> {
    (0..complex.faces().vertex_count()).map(VertexId::new)
}
