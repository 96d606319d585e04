//! Section 2: umbrellas, and the class of each vertex.

use std::collections::BTreeSet;

use super::cells::{Cells, classes};

/// The class of a referenced vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexKind {
    /// One closed umbrella.
    Disc,
    /// One open fan.
    HalfDisc,
    /// Two or more umbrellas, each closed or open.
    Pinched {
        /// How many.
        umbrellas: usize,
        /// Whether all of them are open.
        boundary_only: bool,
    },
    /// Some edge here has three uses or more.
    Singular,
}

/// The class of a vertex that is in some face.
pub(super) fn vertex_kind(cells: &Cells, vertex: u32) -> VertexKind {
    let mut stars: Vec<BTreeSet<usize>> = Vec::new();
    for (face, word) in cells.faces.iter().enumerate() {
        for place in (0..word.len()).filter(|&place| word[place] == vertex) {
            let before = (place + word.len() - 1) % word.len();
            stars.push([cells.edge(face, before), cells.edge(face, place)].into());
        }
    }
    let degree = |edge: &usize| cells.uses[*edge].len();
    if stars.iter().flatten().any(|edge| degree(edge) > 2) {
        return VertexKind::Singular;
    }
    let umbrellas = classes(&stars);
    let is_open = |umbrella: &Vec<usize>| {
        let edges: BTreeSet<usize> = umbrella.iter().flat_map(|&corner| stars[corner].clone()).collect();
        edges.iter().filter(|edge| degree(edge) == 1).count() == 2
    };
    match umbrellas.as_slice() {
        [one] if is_open(one) => VertexKind::HalfDisc,
        [_] => VertexKind::Disc,
        several => {
            VertexKind::Pinched { umbrellas: several.len(), boundary_only: several.iter().all(is_open) }
        }
    }
}
