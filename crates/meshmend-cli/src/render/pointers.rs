//! Records of kernels, and half-edges as permutations.

use meshmend::AnyKernel;
use meshmend::mesh::{Cell, Connectivity, EdgeUse, Pointer, counted};
use meshmend::topology::Permutations;

use super::{Style, paragraph, table};

/// The records of some elements, field by field.
pub(crate) fn records(kernel: AnyKernel, cells: &[Cell], records: &[Vec<Pointer>], style: Style) -> String {
    let mut page = String::new();
    for (cell, record) in cells.iter().zip(records) {
        let row = |pointer: &Pointer| vec![pointer.field.to_owned(), format!("→ {}", pointer.to)];
        let rows: Vec<Vec<String>> = record.iter().map(row).collect();
        page.push_str(&paragraph(&style.heading(&format!("{cell} in {kernel}")), table::lines(&rows, &[])));
    }
    match (page.is_empty(), cells) {
        (false, _) => page.trim_start().to_owned(),
        (true, [cell]) => format!("{kernel} has no record for {}\n", kind_of(*cell)),
        (true, _) => format!("{kernel} does not name the fields of its records\n"),
    }
}

fn kind_of(cell: Cell) -> &'static str {
    match cell {
        Cell::Vertex(_) => "a vertex",
        Cell::Edge(_) => "an edge",
        Cell::Face(_) => "a face",
        Cell::Corner(_) => "a corner",
    }
}

/// How many elements of each kind a mesh has.
pub(crate) fn element_counts(kernel: &EdgeUse) -> String {
    let counts = [
        counted(kernel.vertex_count(), "vertex"),
        counted(kernel.edge_count(), "edge"),
        counted(kernel.face_count(), "face"),
        counted(kernel.corner_count(), "corner"),
    ];
    counts.join(", ")
}

/// The three permutations, each in cycles.
pub(crate) fn permutations(permutations: &Permutations) -> String {
    let Permutations { corner_count, dart_count, around_vertices, along_edges, around_faces } = permutations;
    let boundary = dart_count - corner_count;
    let mut page = format!(
        "{}, the corners first{}\n",
        counted(*dart_count, "half-edge"),
        if boundary == 0 { String::new() } else { format!(", then {boundary} along the boundary") }
    );
    for (name, cycles) in [
        ("σ, round each vertex", around_vertices),
        ("α, along each edge", along_edges),
        ("φ, round each face", around_faces),
    ] {
        let cycle = |cycle: &Vec<u32>| {
            let numbers: Vec<String> = cycle.iter().map(u32::to_string).collect();
            format!("({})", numbers.join(" "))
        };
        let cycles: Vec<String> = cycles.iter().map(cycle).collect();
        let heading = format!("{name}: {}", counted(cycles.len(), "cycle"));
        page.push_str(&paragraph(&heading, super::lesson::wrapped(&cycles.join(" "), super::lesson::WIDTH)));
    }
    page
}
