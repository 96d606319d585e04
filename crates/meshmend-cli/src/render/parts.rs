//! Reports on files of several parts: a line each.

use meshmend::files::{PartOutcome, RepairedParts};
use meshmend::formats::Document;
use meshmend::mesh::counted;
use meshmend::report::CheckDocument;
use meshmend::{Note, Severity};

use super::check::{defects, which};
use super::repair::changes;
use super::table::{self, Align};
use super::{Style, kinds_with_counts, paragraph, printable};
use crate::commands::CheckedFile;

/// The reports on the parts of a file, a line each.
pub(crate) fn checked_parts(checked: &CheckedFile, document: &Document, style: Style) -> String {
    let sealed = checked.reports.iter().filter(|(_, report)| report.is_none()).count();
    let mut heading = vec![document.variant.to_owned(), counted(checked.reports.len(), "part")];
    heading.extend((sealed > 0).then(|| format!("{sealed} sealed")));
    let mut page = format!("{}: {}\n", style.heading(&printable(&checked.name)), heading.join(", "));
    let titles = ["part", "vertices", "faces", "which", "what is wrong"].map(str::to_owned).to_vec();
    let rows = checked.reports.iter().map(|(part, report)| {
        let part = &document.parts[*part];
        let title = printable(&part.title());
        match report {
            Some(report) => row(title, report, style),
            None => {
                let reason = printable(part.seal().unwrap_or_default());
                vec![title, String::new(), String::new(), String::new(), format!("sealed: {reason}")]
            }
        }
    });
    let rows: Vec<Vec<String>> =
        std::iter::once(titles).chain(rows).filter(|_| !checked.reports.is_empty()).collect();
    let lines = table::lines(&rows, &[Align::Left, Align::Right, Align::Right, Align::Left, Align::Left]);
    page.push_str(&paragraph(&style.heading("parts"), lines));
    page.push_str(&notes(&document.notes, style));
    if checked.reports.len() > 1 {
        page.push_str("\n--part NAME shows a part in full\n");
    }
    page
}

/// What a repair did to the parts of a file, a line each.
pub(crate) fn repaired_parts(repaired: &RepairedParts, style: Style) -> String {
    let document = &repaired.document;
    let input = printable(&repaired.name);
    let target = match &repaired.output {
        Some(output) => format!("{input} → {}", printable(output)),
        None => format!("{input}, nothing written"),
    };
    let reports = repaired.parts.iter().filter_map(|(_, outcome)| outcome.report());
    let changed = reports.filter(|report| report.changed).count();
    let mut page = format!("{target}: {}, {changed} changed\n", counted(repaired.parts.len(), "part"));
    let rows = repaired.parts.iter().map(|(part, outcome)| {
        let title = printable(&document.parts[*part].title());
        let what = match outcome {
            PartOutcome::Repaired(part) => changes(&part.report),
            PartOutcome::Sealed(reason) => format!("sealed: {}", printable(reason)),
            PartOutcome::GivenBack(reason) => format!("given back as it was: {}", printable(reason)),
        };
        vec![title, what]
    });
    let lines = table::lines(&rows.collect::<Vec<_>>(), &[Align::Left, Align::Left]);
    page.push_str(&paragraph(&style.heading("parts"), lines));
    let wrong = repaired.parts.iter().filter_map(|(part, outcome)| {
        let wrong = defects(outcome.report()?.after.as_ref()?, Severity::Defect);
        let title = printable(&document.parts[*part].title());
        (!wrong.is_empty())
            .then(|| std::iter::once(title).chain(wrong.into_iter().map(|line| format!("  {line}"))))
    });
    page.push_str(&paragraph(&style.heading("still wrong"), wrong.flatten()));
    let losses = repaired.losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph(&style.heading("what the output can't carry"), losses));
    page.push_str(&notes(&document.notes, style));
    page
}

fn row(title: String, report: &CheckDocument, style: Style) -> Vec<String> {
    let wrong = report.defects.iter().filter(|group| group.severity == Severity::Defect);
    let verdict = match wrong.clone().count() {
        0 if report.topology.faces == 0 => "there are no faces".to_owned(),
        0 => style.good("nothing"),
        _ => style.bad(&kinds_with_counts(wrong.map(|group| (group.kind, group.count)))),
    };
    let shared = report.shared_edges.as_ref().map_or(0, |shared| shared.count);
    let verdict = match shared {
        0 => verdict,
        1 => format!("{verdict}; 1 edge is shared with other parts"),
        _ => format!("{verdict}; {shared} edges are shared with other parts"),
    };
    let figures = [report.topology.vertices, report.topology.faces].map(|figure| figure.to_string());
    let [vertices, faces] = figures;
    vec![title, vertices, faces, which(report), verdict]
}

fn notes(notes: &[Note], style: Style) -> String {
    let notes = notes.iter().map(|note| printable(&note.to_string()));
    paragraph(&style.heading("notes of the reader"), notes)
}
