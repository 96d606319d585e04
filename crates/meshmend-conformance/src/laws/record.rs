//! `arrays` and `pointers`: what a kernel says of its own record.

use std::collections::BTreeSet;

use meshmend_core::{Array, Cell, Connectivity, CornerId, Id, Pointer, Target};

use super::asked::Asked;
use super::law::{Breach, Law, same};

pub(super) const ARRAYS: Law = Law {
    id: "arrays",
    sentence: "the arrays that a kernel names are together its heap_bytes, and no two have one name",
    why: "tables and pictures of what a structure costs are made of them",
    often: Some("an array that was added to the struct and not to the list"),
};

pub(super) fn arrays<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let arrays = asked.kernel.arrays();
    let total: usize = arrays.iter().map(Array::bytes).sum();
    same(|| "the sum of arrays()".to_owned(), &total, &asked.kernel.heap_bytes())?;
    let mut names = BTreeSet::new();
    match arrays.iter().find(|array| !names.insert(array.name)) {
        None => Ok(()),
        Some(twice) => Err(Breach {
            question: format!("the number of arrays that are called `{}`", twice.name),
            found: arrays.iter().filter(|array| array.name == twice.name).count().to_string(),
            expected: "1".to_owned(),
        }),
    }
}

pub(super) const POINTERS: Law = Law {
    id: "pointers",
    sentence: "each named pointer leads to an element that exists, and `next`, `prev` and `twin` of a corner agree with the \
        answers",
    why: "pictures of the live record are made of them",
    often: None,
};

pub(super) fn pointers<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let right = asked.expected;
    let cells = (right.vertices().map(Cell::Vertex))
        .chain(right.all_edges().map(Cell::Edge))
        .chain(right.all_faces().map(Cell::Face))
        .chain(right.corners().map(Cell::Corner));
    for cell in cells {
        for pointer in asked.kernel.pointers(cell) {
            exists(asked, cell, pointer)?;
            if let Cell::Corner(corner) = cell {
                agrees(asked, corner, pointer)?;
            }
        }
    }
    Ok(())
}

fn exists<K: Connectivity>(asked: &Asked<'_, K>, of: Cell, pointer: Pointer) -> Result<(), Breach> {
    let (right, Target::Cell(to)) = (asked.expected, pointer.to) else { return Ok(()) };
    let (index, count, kind) = match to {
        Cell::Vertex(vertex) => (vertex.index(), right.stars.len(), "a vertex"),
        Cell::Edge(edge) => (edge.index(), right.edges.len(), "an edge"),
        Cell::Face(face) => (face.index(), right.faces.len(), "a face"),
        Cell::Corner(corner) => (corner.index(), right.vertex.len(), "a corner"),
    };
    if index < count {
        return Ok(());
    }
    Err(Breach {
        question: format!("`{}` in pointers({of})", pointer.field),
        found: to.to_string(),
        expected: format!("{kind} below {count}"),
    })
}

/// Whether a corner's own `next`, `prev` and `twin` lead to the corners that are the answers.
fn agrees<K: Connectivity>(asked: &Asked<'_, K>, corner: CornerId, pointer: Pointer) -> Result<(), Breach> {
    let right = asked.expected;
    let expected = match pointer.field {
        "next" => Some(right.next[corner.index()]),
        "prev" => Some(right.prev[corner.index()]),
        "twin" => right.across(corner),
        _ => return Ok(()),
    };
    let question = || format!("`{}` in pointers({corner})", pointer.field);
    match (pointer.to, expected) {
        // A field that leads to a record of another kind is that kernel's own matter.
        (Target::Cell(Cell::Corner(found)), expected) => same(question, &Some(found), &expected),
        (Target::Hole | Target::Nothing, Some(_)) => same(question, &None, &expected),
        _ => Ok(()),
    }
}
