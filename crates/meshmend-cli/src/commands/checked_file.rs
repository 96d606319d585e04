//! What a check found in a file, and how it is said.

use std::fs;
use std::path::Path;

use meshmend::formats::{Document, ElementLines};
use meshmend::report::{CheckDocument, PartsDocument, Sarif, json, placing_elements};

#[cfg(feature = "report")]
use meshmend::CheckReport;

use crate::failure::{Failure, Status};
use crate::streams::is_stream;

/// The reports on the parts of a file.
pub(crate) struct CheckedFile {
    /// What the file is called.
    pub(crate) name: String,
    /// The file; absent if it was checked piece by piece, and its report says all that is known of it.
    pub(crate) document: Option<Document>,
    /// The parts that were asked for, by number. A sealed part has no report.
    pub(crate) reports: Vec<(usize, Option<CheckDocument>)>,
    /// The reports that these are of, if a page is to have them.
    #[cfg(feature = "report")]
    pub(super) whole: Vec<Option<CheckReport>>,
    /// Whether one of them fails the check.
    pub(super) status: Status,
}

impl CheckedFile {
    /// Whether the file is one mesh.
    pub(super) fn is_whole(&self) -> bool {
        self.document.as_ref().is_none_or(Document::is_whole)
    }

    /// The report on a part, with what is known of the file.
    pub(super) fn of_file(&self, part: usize, report: &CheckDocument) -> CheckDocument {
        let Some(document) = &self.document else { return report.clone() };
        let Document { variant, notes, .. } = document;
        let title = || format!("{}, {}", self.name, document.parts[part].title());
        let name = if self.is_whole() { self.name.clone() } else { title() };
        CheckDocument { file: Some(name), format: Some(variant), notes: notes.clone(), ..report.clone() }
    }

    /// Adds its reports to a document on several files. The lines of listed elements are looked for in the file, where it is one.
    pub(super) fn add_to(&self, sarif: &mut Sarif, path: &Path) {
        let Some(document) = &self.document else {
            // A file of rows has no lines.
            let reports = self.reports.iter().filter_map(|(_, report)| report.as_ref());
            return reports.for_each(|report| sarif.add(&self.name, None, report, &ElementLines::default()));
        };
        let text = if is_stream(path) { Vec::new() } else { fs::read(path).unwrap_or_default() };
        for (number, report) in &self.reports {
            let Some(report) = report else { continue };
            let part = &document.parts[*number];
            let is_whole = self.is_whole();
            let lines = if is_whole {
                let (vertices, faces) = placing_elements(report);
                let counts = part.mesh.counts();
                let counts = (counts.vertices, counts.faces);
                ElementLines::find(&text, document.format, counts, (&vertices, &faces))
            } else {
                ElementLines::default()
            };
            let title = (!is_whole).then(|| part.title());
            sarif.add(&self.name, title.as_deref(), report, &lines);
        }
    }

    pub(super) fn into_reports(self) -> Vec<CheckDocument> {
        let reports = self.reports.iter().filter_map(|(part, report)| Some((*part, report.as_ref()?)));
        reports.map(|(part, report)| self.of_file(part, report)).collect()
    }

    /// All reports as one document.
    pub(super) fn parts_document(&self) -> Result<PartsDocument, Failure> {
        let failed = |error| Failure::unwritable("report", error);
        let mut together = PartsDocument::default();
        let Some(document) = &self.document else { return Ok(together) };
        for (number, report) in &self.reports {
            let part = &document.parts[*number];
            match report {
                Some(report) => together.add(*number, part, report).map_err(failed)?,
                None => together.add_without(*number, part, "sealed", part.seal().unwrap_or_default()),
            }
        }
        together.say("file", &self.name).map_err(failed)?;
        together.say("format", &document.variant).map_err(failed)?;
        together.say("notes", &document.notes).map_err(failed)?;
        Ok(together)
    }
}

/// A document as one line.
pub(crate) fn json_line(document: &impl serde::Serialize) -> Result<String, Failure> {
    let text = json(document).map_err(|error| Failure::unwritable("report", error))?;
    Ok(text + "\n")
}
