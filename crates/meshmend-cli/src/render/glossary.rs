//! Words explained.

use meshmend::passes::Passes;
use meshmend::words::WORDS;
use meshmend::{AnyView, DefectKind, Kernels, Rules, Severity};

use super::lesson::{WIDTH, wrapped};
use super::table;
use super::{Style, paragraph};

/// A kind of defect, as the heading of its explanation.
pub(crate) fn defect_heading(kind: DefectKind) -> String {
    let severity = match kind.severity() {
        Severity::Defect => "a defect: it fails a check",
        Severity::Note => "a note: it fails a check only when --fail-on names it",
    };
    format!("{kind}: {} ({severity})", kind.title())
}

/// A word with its explanation.
pub(crate) fn explanation(heading: &str, text: &str, style: Style) -> String {
    let mut page = style.heading(heading);
    page.push('\n');
    for line in wrapped(text, WIDTH) {
        page.push_str(&format!("  {line}\n"));
    }
    page
}

/// All words that can be explained.
pub(crate) fn glossary(
    rules: Rules,
    passes: Passes,
    kernels: Kernels,
    laws: Vec<String>,
    style: Style,
) -> String {
    let severity = |kind: DefectKind| match kind.severity() {
        Severity::Defect => "defect".to_owned(),
        Severity::Note => "note".to_owned(),
    };
    let kind = |kind: DefectKind| vec![kind.code().to_owned(), severity(kind), kind.title().to_owned()];
    let kinds: Vec<Vec<String>> = rules.kinds().map(kind).collect();
    let passes = passes.kinds().into_iter().map(|pass| pass.name().to_owned());
    let kernels = kernels.all().map(|kernel| kernel.name.to_owned());
    let words = WORDS.iter().map(|word| word.name.to_owned());
    let page = [
        paragraph(&style.heading("kinds of defect"), table::lines(&kinds, &[])),
        paragraph(&style.heading("passes, in their usual order"), passes),
        paragraph(&style.heading("kernels"), kernels),
        paragraph(&style.heading("views"), AnyView::ALL.iter().map(|view| view.name.to_owned())),
        paragraph(&style.heading("words of topology"), words),
        paragraph(&style.heading("laws of kernels"), laws),
    ];
    page.concat().trim_start().to_owned()
}
