//! The matrices of a mesh, and what they say.

use meshmend::report::{
    EdgeDocument, Listing, LostSideDocument, MatrixDocument, MatrixSize, NeighbourhoodDocument, WalksDocument,
};

use super::table::{self, Align};
use super::{Style, figure, paragraph, printable, rest};

/// The report on the matrices of a mesh.
pub(crate) fn matrix(document: &MatrixDocument, style: Style) -> String {
    let mut page = format!("{}\n", style.heading(&printable(document.file.as_deref().unwrap_or("mesh"))));
    let mut add =
        |heading: &str, lines: Vec<String>| page.push_str(&paragraph(&style.heading(heading), lines));
    add("matrices", sizes(document));
    add("what they say", facts(document));
    add("sides that cancel in ∂₂", listed(&document.lost_sides, lost_side));
    add("ranks", ranks(document));
    if let Some(walks) = &document.walks {
        add(&format!("walks of length {} from {}", walks.length, walks.from), walk_counts(walks));
    }
    if let Some(spectrum) = &document.spectrum {
        let what = if spectrum.of == "laplacian" {
            "smallest eigenvalues of the Laplacian"
        } else {
            "largest eigenvalues of the adjacency matrix"
        };
        add(what, eigenvalues(document));
    }
    for round in &document.neighbourhoods {
        add(&format!("{} of {}", round.kind, round.of.join(", ")), neighbourhood(round));
    }
    add("notes of the reader", document.notes.iter().map(|note| printable(&note.to_string())).collect());
    page
}

fn sizes(document: &MatrixDocument) -> Vec<String> {
    let bytes =
        |arrays: &[meshmend::mesh::Array]| arrays.iter().map(meshmend::mesh::Array::bytes).sum::<usize>();
    let row = |name: &str, size: MatrixSize, bytes: String| {
        let entries = format!("{} not 0", size.entries);
        vec![name.to_owned(), format!("{} × {}", size.rows, size.columns), entries, bytes]
    };
    let (incidence, adjacency) = (bytes(&document.arrays.incidence), bytes(&document.arrays.adjacency));
    let rows = [
        row("∂₁", document.d1, format!("{incidence} bytes with ∂₂")),
        row("∂₂", document.d2, String::new()),
        row("A", document.adjacency, format!("{adjacency} bytes")),
    ];
    table::lines(&rows, &[Align::Left, Align::Right, Align::Right, Align::Left])
}

fn facts(document: &MatrixDocument) -> Vec<String> {
    let is_zero = if document.boundary_of_boundary_is_zero { "0" } else { "not 0" };
    let mut rows = vec![
        vec!["∂₁∂₂".to_owned(), is_zero.to_owned()],
        vec!["cycles of three edges, tr A³ / 6".to_owned(), document.three_cycles.to_string()],
        vec!["faces with three sides".to_owned(), document.triangles.to_string()],
    ];
    if document.lone_vertices > 0 {
        rows.push(vec!["vertices without a neighbour".to_owned(), document.lone_vertices.to_string()]);
    }
    table::lines(&rows, &[Align::Left, Align::Right])
}

fn ranks(document: &MatrixDocument) -> Vec<String> {
    if document.ranks.is_empty() {
        return Vec::new();
    }
    let heading = ["over", "rank ∂₁", "rank ∂₂", "β₀", "β₁", "β₂"].map(str::to_owned).to_vec();
    let row = |rank: &meshmend::report::RankDocument| {
        let numbers = [rank.d1, rank.d2].into_iter().chain(rank.betti).map(|number| number.to_string());
        std::iter::once(rank.field.clone()).chain(numbers).collect()
    };
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(document.ranks.iter().map(row)).collect();
    table::lines(&rows, &[Align::Left, Align::Right, Align::Right, Align::Right, Align::Right, Align::Right])
}

fn walk_counts(walks: &WalksDocument) -> Vec<String> {
    if walks.to.count == 0 {
        return vec!["none".to_owned()];
    }
    let rows: Vec<Vec<String>> =
        walks.to.items.iter().map(|to| vec![format!("to {}", to.vertex), to.walks.clone()]).collect();
    with_rest(table::lines(&rows, &[Align::Left, Align::Right]), &walks.to)
}

fn eigenvalues(document: &MatrixDocument) -> Vec<String> {
    let values = document.spectrum.iter().flat_map(|spectrum| &spectrum.values);
    let row = |value: &meshmend::report::EigenvalueDocument| {
        // A zero has no sign.
        let shown = format!("{:.9}", value.value);
        let shown = if shown == "-0.000000000" { "0.000000000".to_owned() } else { shown };
        vec![shown, format!("within {:.0e}", value.residual)]
    };
    table::lines(&values.map(row).collect::<Vec<_>>(), &[Align::Right, Align::Left])
}

fn neighbourhood(round: &NeighbourhoodDocument) -> Vec<String> {
    let what = match (round.is_complex, round.pure_dimension) {
        (false, _) => "not a complex".to_owned(),
        (true, None) => "a complex".to_owned(),
        (true, Some(dimension)) => format!("a complex of dimension {dimension}"),
    };
    let rows = [
        cells("vertices", &round.vertices, |vertex| vertex.to_string()),
        cells("edges", &round.edges, |edge: &EdgeDocument| {
            let [low, high] = edge.ends;
            format!("{} {low}-{high}", edge.edge)
        }),
        cells("faces", &round.faces, |face| face.to_string()),
    ];
    let mut lines = table::lines(&rows, &[Align::Left, Align::Right]);
    lines.push(what);
    lines
}

fn cells<T>(kind: &str, listing: &Listing<T>, shown: impl Fn(&T) -> String) -> Vec<String> {
    let mut names: Vec<String> = listing.items.iter().map(shown).collect();
    names.extend(rest(listing));
    vec![kind.to_owned(), figure(Some(listing.count)), names.join(", ")]
}

fn lost_side(lost: &LostSideDocument) -> String {
    let times = if lost.pairs == 1 { String::new() } else { format!(", {} times", lost.pairs) };
    format!("{} runs along {} {}-{} both ways{times}", lost.face, lost.edge, lost.ends[0], lost.ends[1])
}

fn listed<T>(listing: &Listing<T>, shown: impl Fn(&T) -> String) -> Vec<String> {
    with_rest(listing.items.iter().map(shown).collect(), listing)
}

fn with_rest<T>(mut lines: Vec<String>, listing: &Listing<T>) -> Vec<String> {
    lines.extend(rest(listing));
    lines
}
