//! The kernels, and how they took a mesh.

use std::time::Duration;

use meshmend::mesh::{Array, Capabilities, counted};
use meshmend::report::{KernelTrial, KernelsDocument};
use meshmend::{AnyKernel, AnyView, KernelQuestion, Kernels, LINEAR_LIMIT, Refusal};

use super::table::{self, Align};
use super::{Style, paragraph};

/// How a kernel took a mesh.
pub(crate) struct Trial {
    pub(crate) kernel: AnyKernel,
    /// Bytes on the heap and the time to build, or why not.
    pub(crate) result: Result<(usize, Duration), Refusal>,
}

/// The list of kernels.
pub(crate) fn kernels(kernels: Kernels, style: Style) -> String {
    let row = |kernel: AnyKernel| vec![kernel.name.to_owned(), holds(&kernel.capabilities)];
    let rows: Vec<Vec<String>> = kernels.all().map(row).collect();
    let mut list = paragraph(&style.heading("kernels and what they hold"), table::lines(&rows, &[]));
    let view = |view: AnyView| vec![view.name.to_owned(), view.rung.lacks().unwrap_or_default().to_owned()];
    let views: Vec<Vec<String>> = AnyView::ALL.into_iter().map(view).collect();
    list.push_str(&paragraph(
        &style.heading("views, which hold anything and say less"),
        table::lines(&views, &[]),
    ));
    list.trim_start().to_owned()
}

fn holds(able: &Capabilities) -> String {
    let needs = able.needs();
    if needs.is_empty() { "anything".to_owned() } else { format!("needs {}", needs.join(", ")) }
}

/// How each kernel took a mesh.
pub(crate) fn trials(file: &str, faces: usize, trials: &[Trial]) -> String {
    let row = |trial: &Trial| match &trial.result {
        Ok((bytes, time)) => vec![
            trial.kernel.name.to_owned(),
            format!("{:.1}", *bytes as f64 / faces.max(1) as f64),
            format!("{:.3} ms", time.as_secs_f64() * 1e3),
        ],
        Err(_) => vec![trial.kernel.name.to_owned(), "refuses".to_owned()],
    };
    let heading = ["kernel", "bytes a face", "built in"].map(str::to_owned).to_vec();
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(trials.iter().map(row)).collect();
    let heading = format!("{}: {}", super::printable(file), counted(faces, "face"));
    let mut page = paragraph(&heading, table::lines(&rows, &[Align::Left, Align::Right, Align::Right]));
    let refusals = trials.iter().filter_map(|trial| trial.result.as_ref().err());
    page.push_str(&paragraph("refusals", refusals.map(ToString::to_string)));
    page.trim_start().to_owned()
}

/// What each kernel costs on a mesh, in nanoseconds a face; and of which arrays it consists.
pub(crate) fn kernel_times(document: &KernelsDocument) -> String {
    let KernelsDocument { file, faces, runs, kernels, views, .. } = document;
    let structures = || kernels.iter().chain(views);
    let heading = ["kernel", "bytes a face"].into_iter().chain(KernelQuestion::ALL.map(KernelQuestion::name));
    let heading = heading.map(str::to_owned).collect();
    let rows = structures().map(|trial| times_of(trial, *faces));
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(rows).collect();
    let mut alignment = vec![Align::Right; KernelQuestion::ALL.len() + 2];
    alignment[0] = Align::Left;
    let file = file.as_deref().map(|file| format!("{}: ", super::printable(file))).unwrap_or_default();
    let heading = format!("{file}{}, ns a face by the clock, best of {runs}", counted(*faces, "face"));
    let mut page = paragraph(&heading, table::lines(&rows, &alignment));
    let arrays =
        kernels.iter().filter(|trial| !trial.arrays.is_empty()).map(|trial| arrays_of(trial, *faces));
    page.push_str(&paragraph("bytes a face by array", table::lines(&arrays.collect::<Vec<_>>(), &[])));
    if kernels.iter().any(|trial| !trial.linear.is_empty()) {
        let note = format!("not asked above {LINEAR_LIMIT} faces: a star takes this kernel linear time");
        page.push_str(&paragraph("linear", [note]));
    }
    page.push_str(&paragraph("refusals", kernels.iter().filter_map(|trial| trial.refusal.clone())));
    page.trim_start().to_owned()
}

/// A structure's name, its bytes a face, and its times.
fn times_of(trial: &KernelTrial, faces: usize) -> Vec<String> {
    let bytes = trial.bytes_a_face.map_or("refuses".to_owned(), |bytes| format!("{bytes:.1}"));
    let time = |question| match trial.seconds.get(&question) {
        Some(seconds) => format!("{:.1}", seconds * 1e9 / faces.max(1) as f64),
        None if trial.linear.contains(&question) => "linear".to_owned(),
        None => match trial.rung.lacks().filter(|_| !trial.answers.contains(&question)) {
            Some(lacking) => format!("– ({lacking})"),
            None => "–".to_owned(),
        },
    };
    [trial.name.to_owned(), bytes].into_iter().chain(KernelQuestion::ALL.map(time)).collect()
}

/// A structure's name, and the bytes a face of each of its arrays.
fn arrays_of(trial: &KernelTrial, faces: usize) -> Vec<String> {
    let of_array = |array: &Array| {
        let bytes = array.bytes() as f64 / faces.max(1) as f64;
        let shared = if array.shared { " (shared)" } else { "" };
        format!("{} {bytes:.1}{shared}", array.name)
    };
    let arrays: Vec<String> = trial.arrays.iter().filter(|array| array.count > 0).map(of_array).collect();
    vec![trial.name.to_owned(), arrays.join(" · ")]
}
