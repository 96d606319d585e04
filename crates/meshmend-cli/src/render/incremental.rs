//! What each cell of a mesh changed.

use meshmend::mesh::Cell;
use meshmend::report::{IncrementalDocument, RunningStep};
use meshmend::topology::Effect;

use super::table::{self, Align};
use super::{ABSENT, Style, figure, paragraph, printable, rest};

/// The report on a mesh that was put together cell by cell.
pub(crate) fn incremental(document: &IncrementalDocument, style: Style) -> String {
    let file = printable(document.file.as_deref().unwrap_or("mesh"));
    let betti = document.betti.map(figure).join(" ");
    let mut page = format!("{}\nBetti numbers mod 2 in the end: {betti}\n", style.heading(&file));
    page.push_str(&paragraph(&style.heading("cells"), cells(document)));
    page.push_str(&paragraph(&style.heading("steps"), steps(document)));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph(&style.heading("notes of the reader"), notes));
    page
}

fn cells(document: &IncrementalDocument) -> Vec<String> {
    let counts = document.instigators;
    let row =
        |cells: &str, effect: &str, count: Option<u64>| vec![format!("{cells} that {effect}"), figure(count)];
    let mut rows = vec![
        row("vertices", "start a component", Some(counts.v_c)),
        row("edges", "join components", Some(counts.e_n)),
        row("edges", "start a loop", Some(counts.e_c)),
        row("faces", "fill a loop", counts.f_n),
        row("faces", "enclose a void", counts.f_c),
    ];
    if document.betti_unknown.is_some() {
        rows.push(vec!["not computed: it would take too long".to_owned()]);
    }
    table::lines(&rows, &[Align::Left, Align::Right])
}

fn steps(document: &IncrementalDocument) -> Vec<String> {
    let heading = ["cell", "what it does", "β₀", "β₁", "β₂"].map(str::to_owned).to_vec();
    let rows: Vec<Vec<String>> =
        std::iter::once(heading).chain(document.steps.items.iter().map(row)).collect();
    let numbers = [Align::Left, Align::Left, Align::Right, Align::Right, Align::Right];
    let mut lines = table::lines(&rows, &numbers);
    lines.extend(rest(&document.steps));
    lines
}

fn row(step: &RunningStep) -> Vec<String> {
    let (id, effects) = match step.cell {
        Cell::Vertex(vertex) => (vertex.to_string(), ["starts a component", ABSENT]),
        Cell::Edge(edge) => (edge.to_string(), ["starts a loop", "joins two components"]),
        Cell::Face(face) => (face.to_string(), ["encloses a void", "fills a loop"]),
        Cell::Corner(corner) => (corner.to_string(), [ABSENT; 2]),
    };
    let effect = match step.effect {
        Some(Effect::Starts) => effects[0],
        Some(Effect::Fills) => effects[1],
        None => ABSENT,
    };
    let numbers = step.betti.map(figure);
    [id, effect.to_owned()].into_iter().chain(numbers).collect()
}
