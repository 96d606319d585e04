//! `growth`: answers cost what `COSTS` says.
//!
//! Time is judged by how it grows. A mesh eight times as large has eight times as many elements to ask about, so asking
//! about all of them takes eight times as long where an answer takes constant time, and sixty-four times where it takes a
//! search. An answer that takes longer than the patience is judged by whoever watches.

use std::hint::black_box;
use std::time::{Duration, Instant};

use meshmend_core::{Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId, Id, VertexId};

use super::law::{Breach, Law};

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
/// So many elements are asked about where each answer may take long by right.
const FEW: usize = 256;

/// A kind of question: its name, where its cost is declared, and how it is asked about every so many elements.
struct Question<K> {
    name: &'static str,
    cost: fn(&Costs) -> Cost,
    ask: fn(&K, &Complex, usize),
}

/// Asks kernels over the two sizes about all elements; whoever watches is told before each measurement.
///
/// # Errors
/// The question whose cost grows with the mesh, though `COSTS` says that it does not.
pub(crate) fn growth<K: Connectivity>(
    kernels: [&K; 2],
    sizes: &Sizes<'_>,
    begins: &dyn Fn(),
) -> Result<(), Breach> {
    for question in questions::<K>() {
        let cost = (question.cost)(&K::COSTS);
        if cost == Cost::Linear {
            continue;
        }
        let seconds = |which: usize| {
            begins();
            let complex = sizes.complexes[which];
            let begun = Instant::now();
            (question.ask)(kernels[which], complex, step(complex, cost, sizes.is_crowded));
            begun.elapsed()
        };
        let is_slow = |time: Duration| time >= NOTICEABLE && time > seconds(0) * MOST_GROWTH;
        if (0..RUNS).all(|_| is_slow(seconds(1))) {
            return Err(Breach {
                question: format!("the cost of {} on {}", question.name, sizes.family),
                found: "linear".to_owned(),
                expected: format!("{}, as COSTS says", said(cost)),
            });
        }
    }
    Ok(())
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

fn questions<K: Connectivity>() -> Vec<Question<K>> {
    vec![
        Question {
            name: "corner_vertex",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(corners(c, n), |at| k.corner_vertex(at)),
        },
        Question {
            name: "corner_edge",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(corners(c, n), |at| k.corner_edge(at)),
        },
        Question {
            name: "corner_face",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(corners(c, n), |at| k.corner_face(at)),
        },
        Question {
            name: "next_corner",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(corners(c, n), |at| k.next_corner(at)),
        },
        Question {
            name: "prev_corner",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(corners(c, n), |at| k.prev_corner(at)),
        },
        Question {
            name: "edge_ends",
            cost: |costs| costs.corner,
            ask: |k, c, n| of(edges(c, n), |at| k.edge_ends(at)),
        },
        Question {
            name: "across",
            cost: |costs| costs.across,
            ask: |k, c, n| of(corners(c, n), |at| k.across(at)),
        },
        Question {
            name: "face_corners",
            cost: |costs| costs.face_star,
            ask: |k, c, n| of(faces(c, n), |at| k.face_corners(at).count()),
        },
        Question {
            name: "edge_corners",
            cost: |costs| costs.edge_star,
            ask: |k, c, n| of(edges(c, n), |at| k.edge_corners(at).count()),
        },
        Question {
            name: "vertex_corners",
            cost: |costs| costs.vertex_star,
            ask: |k, c, n| of(vertices(c, n), |at| k.vertex_corners(at).count()),
        },
    ]
}

/// Asks about each element, and has the answers made whatever the compiler thinks of it.
fn of<I, T>(elements: impl Iterator<Item = I>, ask: impl Fn(I) -> T) {
    elements.for_each(|element| {
        black_box(ask(element));
    });
}

fn corners(complex: &Complex, step: usize) -> impl Iterator<Item = CornerId> + use<> {
    every(complex.faces().corner_count(), step)
}

fn edges(complex: &Complex, step: usize) -> impl Iterator<Item = EdgeId> + use<> {
    every(complex.edges().edge_count(), step)
}

fn faces(complex: &Complex, step: usize) -> impl Iterator<Item = FaceId> + use<> {
    every(complex.faces().face_count(), step)
}

fn vertices(complex: &Complex, step: usize) -> impl Iterator<Item = VertexId> + use<> {
    every(complex.faces().vertex_count(), step)
}

fn every<I: Id>(count: usize, step: usize) -> impl Iterator<Item = I> + use<I> {
    (0..count).step_by(step).map(I::new)
}
