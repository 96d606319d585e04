//! The kernels, and how they took a mesh.

use meshmend::KernelKind;
use meshmend::core::Capabilities;

use super::table::{self, Align};
use super::{Style, paragraph};
use crate::commands::Trial;

/// The list of kernels.
pub(crate) fn kernels(style: Style) -> String {
    let row = |kernel: &KernelKind| vec![kernel.name().to_owned(), holds(&kernel.capabilities())];
    let rows: Vec<Vec<String>> = KernelKind::ALL.iter().map(row).collect();
    let list = paragraph(&style.heading("kernels and what they hold"), table::lines(&rows, &[]));
    list.trim_start().to_owned()
}

fn holds(able: &Capabilities) -> String {
    if able.is_permissive() {
        return "anything".to_owned();
    }
    let needs = [
        (able.non_simple_faces, "no face that comes back to a vertex"),
        (able.polygons, "triangles"),
        (able.non_manifold_edges, "no edge with three faces or more"),
        (able.non_manifold_vertices, "no pinched vertex"),
        (able.mixed_orientation, "neighbours that agree on their side"),
    ];
    let needs: Vec<&str> = needs.iter().filter(|(is_able, _)| !is_able).map(|(_, need)| *need).collect();
    format!("needs {}", needs.join(", "))
}

/// How each kernel took a mesh.
pub(crate) fn trials(file: &str, faces: usize, trials: &[Trial]) -> String {
    let row = |trial: &Trial| match &trial.result {
        Ok((bytes, time)) => vec![
            trial.kernel.name().to_owned(),
            format!("{:.1}", *bytes as f64 / faces.max(1) as f64),
            format!("{:.3} ms", time.as_secs_f64() * 1e3),
        ],
        Err(_) => vec![trial.kernel.name().to_owned(), "refuses".to_owned()],
    };
    let heading = ["kernel", "bytes a face", "built in"].map(str::to_owned).to_vec();
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(trials.iter().map(row)).collect();
    let heading = format!("{}: {faces} faces", super::printable(file));
    let mut page = paragraph(&heading, table::lines(&rows, &[Align::Left, Align::Right, Align::Right]));
    let refusals = trials.iter().filter_map(|trial| trial.result.as_ref().err());
    page.push_str(&paragraph("refusals", refusals.map(ToString::to_string)));
    page.trim_start().to_owned()
}
