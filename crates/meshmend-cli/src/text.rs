//! Reports as the command prints them for people, without colours.

use meshmend::files::RepairedFile;
use meshmend::report::{CheckDocument, CutDocument, LoopsDocument, RepairDocument};

use crate::render::{self, Style};

/// The report of a check.
pub fn check(document: &CheckDocument) -> String {
    render::check(document, Style::Plain)
}

/// The report of a repair.
pub fn repair(document: &RepairDocument) -> String {
    render::repair(document, Style::Plain)
}

/// The report of the repair of a file.
pub fn repaired(file: &RepairedFile) -> String {
    match file {
        RepairedFile::Mesh(mesh) => repair(&mesh.report),
        RepairedFile::Parts(parts) => render::repaired_parts(parts, Style::Plain),
    }
}

/// The report on closed paths.
pub fn loops(document: &LoopsDocument) -> String {
    render::loops(document, Style::Plain)
}

/// The report of a cut.
pub fn cut(document: &CutDocument) -> String {
    render::cut(document, Style::Plain)
}
