//! The two tables by which a paper tells meshes apart: their figures, and their elements by what they do.
//!
//! *Source*: A. Bærentzen, *On the Topology of Polygonal Meshes*, 2025, tables 1 and 2.

use meshmend::report::CheckDocument;

use super::table::{self, Align};
use super::{Style, figure, paragraph, printable};

/// Both tables, a row each mesh.
pub(crate) fn paper_tables(documents: &[CheckDocument], style: Style) -> String {
    let figures = rows(&["", "V", "E", "F", "χ", "s", "b", "genus", "cross-caps"], documents, |document| {
        let report = &document.topology;
        vec![
            report.vertices.to_string(),
            report.edges.to_string(),
            report.faces.to_string(),
            report.euler_characteristic.to_string(),
            report.components.to_string(),
            figure(report.boundary_loops),
            figure(report.genus),
            figure(report.cross_caps),
        ]
    });
    let heads = ["", "V_N", "V_C", "E_N", "E_C", "F_C", "F_N", "β₀", "β₁", "β₂"];
    let instigators = rows(&heads, documents, |document| {
        let (counts, betti) = (document.topology.instigators, document.topology.betti.z2);
        let betti = [0, 1, 2].map(|dimension| figure(betti.map(|numbers| numbers[dimension])));
        let [v_n, v_c, e_n, e_c] = [counts.v_n, counts.v_c, counts.e_n, counts.e_c].map(|n| n.to_string());
        [v_n, v_c, e_n, e_c, figure(counts.f_c), figure(counts.f_n)].into_iter().chain(betti).collect()
    });
    let page = paragraph(&style.heading("Euler characteristic and genus"), figures);
    let heading = "elements that negate (N) and create (C) a cycle, and Betti numbers mod 2";
    page.trim_start().to_owned() + &paragraph(&style.heading(heading), instigators)
}

fn rows(
    heads: &[&str],
    documents: &[CheckDocument],
    cells: impl Fn(&CheckDocument) -> Vec<String>,
) -> Vec<String> {
    let head = heads.iter().map(|&head| head.to_owned()).collect();
    let row = |document: &CheckDocument| {
        let name = printable(document.file.as_deref().unwrap_or("mesh"));
        std::iter::once(name).chain(cells(document)).collect()
    };
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(documents.iter().map(row)).collect();
    let alignment: Vec<Align> =
        (0..heads.len()).map(|column| if column == 0 { Align::Left } else { Align::Right }).collect();
    table::lines(&rows, &alignment)
}
