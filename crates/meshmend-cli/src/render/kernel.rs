//! One kernel: its lesson, and how it takes a mesh.

use meshmend::mesh::{Array, Per, counted};
use meshmend::{AnyKernel, DefectKind, Refusal};

use super::lesson::{WIDTH, wrapped};
use super::{Style, lesson, printable};

/// How a kernel takes a mesh, and which others do.
pub(crate) struct KernelOn {
    pub(crate) file: String,
    /// How many proper faces the mesh has.
    pub(crate) faces: usize,
    /// The kernel's arrays, or why it refuses.
    pub(crate) arrays: Result<Vec<Array>, Refusal>,
    /// The kernels that hold the mesh.
    pub(crate) holders: Vec<&'static str>,
}

/// How wide the names of the facts are.
const NAMES: usize = 18;

/// The lesson of a kernel, and how it takes a mesh.
pub(crate) fn kernel(kernel: AnyKernel, on: Option<&KernelOn>, style: Style) -> String {
    let mut page = style.heading(&format!("{kernel}: a kernel"));
    page.push_str("\n\n");
    page.push_str(&lesson(kernel.lesson, style));
    if let Some(on) = on {
        page.push('\n');
        facts(kernel, on).into_iter().for_each(|(name, text)| page.push_str(&fact(&name, &text)));
    }
    page
}

fn facts(kernel: AnyKernel, on: &KernelOn) -> Vec<(String, String)> {
    let file = printable(&on.file);
    let name = format!("on {file}");
    let refusal = match &on.arrays {
        Ok(arrays) => {
            let bytes: usize = arrays.iter().map(Array::bytes).sum();
            let a_face = bytes as f64 / on.faces.max(1) as f64;
            let listed: Vec<String> =
                arrays.iter().filter(|array| array.count > 0).map(array_words).collect();
            let holds = format!("holds it: {}, {a_face:.1} bytes a face", counted(on.faces, "face"));
            return vec![(name, holds), ("  arrays".to_owned(), listed.join(", "))];
        }
        Err(refusal) => refusal,
    };
    let mut facts = vec![(name, format!("refuses: {}", reasons(refusal)))];
    let mut kinds: Vec<DefectKind> = refusal.defects.iter().map(|defect| defect.kind).collect();
    kinds.dedup();
    let whys: Vec<String> = kinds.iter().filter_map(|&kind| kernel.why_refused(kind)).collect();
    if !whys.is_empty() {
        facts.push(("  why".to_owned(), whys.join(" ")));
    }
    facts.push(("  who holds it".to_owned(), on.holders.join(" ")));
    let overlay = if kinds.contains(&DefectKind::InconsistentEdge) { "witness" } else { "defects" };
    facts.push(("  try".to_owned(), format!("meshmend render {file} --overlay {overlay} -o picture.svg")));
    facts
}

/// The first defect of each kind, with how many more there are.
fn reasons(refusal: &Refusal) -> String {
    let kinds = refusal.defects.chunk_by(|one, other| one.kind == other.kind);
    let reason = |run: &[meshmend::Defect]| match run.len() {
        1 => run[0].to_string(),
        count => format!("{} (and {} more)", run[0], count - 1),
    };
    kinds.map(reason).collect::<Vec<_>>().join("; ")
}

/// `next 4 a corner`.
fn array_words(array: &Array) -> String {
    let shared = if array.shared { " (shared)" } else { "" };
    let article = if array.per == Per::Edge { "an" } else { "a" };
    format!("{} {} {article} {}{shared}", array.name, array.each, array.per.name())
}

/// A fact with its name, on as many lines as it takes.
fn fact(name: &str, text: &str) -> String {
    let width = NAMES.max(name.chars().count());
    let lines = wrapped(text, WIDTH.saturating_sub(width).max(40));
    let line = |(place, line): (usize, &String)| {
        let name = if place == 0 { name } else { "" };
        format!("{name:<width$} {line}\n")
    };
    lines.iter().enumerate().map(line).collect()
}
