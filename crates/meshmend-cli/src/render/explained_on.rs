//! What of a word or of a kind of defect there is in a mesh.

use meshmend::topology::TopologyReport;
use meshmend::{CheckReport, DefectKind};

use super::check::{figures, verdicts};
use super::{Style, figure, paragraph, printable};

/// How many places are shown.
const MOST: usize = 10;

/// Where a kind of defect is in a mesh.
pub(crate) fn defects_on(file: &str, kind: DefectKind, report: &CheckReport, style: Style) -> String {
    let count = report.count(kind);
    let heading = style.heading(&format!("on {}: {count}", printable(file)));
    let mut lines: Vec<String> =
        report.defects_of_kind(kind).take(MOST).map(|defect| defect.to_string()).collect();
    if count > lines.len() {
        lines.push(format!("and {} more", count - lines.len()));
    }
    if lines.is_empty() { format!("\n{heading}\n") } else { paragraph(&heading, lines) }
}

/// The figures of a mesh that a word is about.
pub(crate) fn word_on(file: &str, word: &str, report: &TopologyReport, style: Style) -> String {
    let labels: &[&str] = match word {
        "euler-characteristic" => &["vertices", "edges", "faces", "Euler characteristic"],
        "genus" => &["genus", "cross-caps", "boundary loops"],
        "manifold" | "umbrella" => &["manifold"],
        "orientable" => &["patches", "orientable"],
        _ => &["components", "boundary loops", "Betti numbers"],
    };
    let lines = figures(report).into_iter().chain(verdicts(report, style));
    let mut lines: Vec<String> =
        lines.filter(|line| labels.iter().any(|label| line.starts_with(label))).collect();
    if word == "instigator" {
        lines.extend(instigators(report));
    }
    paragraph(&style.heading(&format!("on {}", printable(file))), lines)
}

fn instigators(report: &TopologyReport) -> [String; 3] {
    let found = &report.instigators;
    [
        format!("vertices  {} negate, {} create", found.v_n, found.v_c),
        format!("edges     {} negate, {} create", found.e_n, found.e_c),
        format!("faces     {} negate, {} create", figure(found.f_n), figure(found.f_c)),
    ]
}
