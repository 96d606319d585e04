//! A file that was repaired: its meshes, the report on them, and what is ready to be written.

use meshmend_core::PolygonMesh;
use meshmend_io::{Document, Loss, ReadFile, WriteError};
use meshmend_repair::Repaired;
use serde::Serialize;

use super::{FileTarget, KeptChecks, Maps, PreparedFile, RepairRecord};
use crate::report::{PartsDocument, RepairDocument, json};
use crate::{Criterion, Failing, Gate};

/// A file that was repaired.
#[derive(Debug)]
pub enum RepairedFile {
    /// It is one mesh.
    Mesh(Box<RepairedMesh>),
    /// Its parts were repaired each by itself.
    Parts(Box<RepairedParts>),
}

/// A file of one mesh that was repaired.
#[derive(Debug)]
#[non_exhaustive]
pub struct RepairedMesh {
    /// The file as it was read.
    pub file: ReadFile,
    /// The mesh as it is now, and the record. The topology of the result is in the report, if that was asked for.
    pub repaired: Repaired,
    /// The report.
    pub report: RepairDocument,
    /// The checks of which the report shows the beginning, if they were kept.
    pub checks: KeptChecks,
    /// The mesh ready to be written, if there is a target.
    pub prepared: Option<PreparedFile>,
}

/// A file whose parts were repaired each by itself.
#[derive(Debug)]
#[non_exhaustive]
pub struct RepairedParts {
    /// What the file is called.
    pub name: String,
    /// What the output is called, if one will be written.
    pub output: Option<String>,
    /// The file, with the meshes that its parts have now.
    pub document: Document,
    /// What became of the parts that were chosen, by number.
    pub parts: Vec<(usize, PartOutcome)>,
    /// What the output does not carry.
    pub losses: Vec<Loss>,
    /// What of it fails the run.
    pub failing: Vec<Failing>,
    /// The file with its one mesh again, where that was taken apart by the names of its faces.
    pub whole: Option<Document>,
    /// The file ready to be written, if there is a target.
    pub prepared: Option<PreparedFile>,
}

/// What became of a part.
#[derive(Debug)]
pub enum PartOutcome {
    /// It was repaired.
    Repaired(Box<RepairedPart>),
    /// It can't be edited, for this reason.
    Sealed(String),
    /// It is as it was, as no face would be left of it.
    GivenBack(String),
}

/// A part of a file, or a mesh that is from none, that was repaired.
#[derive(Debug)]
#[non_exhaustive]
pub struct RepairedPart {
    /// The mesh as it was read.
    pub stored: PolygonMesh,
    /// The mesh as it is now, and the record.
    pub repaired: Repaired,
    /// The report.
    pub report: RepairDocument,
    /// The checks of which the report shows the beginning, if they were kept.
    pub checks: KeptChecks,
}

impl RepairedFile {
    /// Whether what is written differs from what was read, apart from the format.
    pub fn is_changed(&self) -> bool {
        match self {
            RepairedFile::Mesh(mesh) => mesh.report.changed,
            RepairedFile::Parts(parts) => parts.is_changed(),
        }
    }

    /// The report as one line of JSON.
    ///
    /// # Errors
    /// When a report can't be written as JSON. None is known that can't.
    pub fn report_json(&self) -> Result<String, serde_json::Error> {
        match self {
            RepairedFile::Mesh(mesh) => json(&mesh.report),
            RepairedFile::Parts(parts) => json(&parts.document()?),
        }
    }

    /// The report as one line of JSON, with at most `limit` items in each list, with the maps or without.
    ///
    /// # Errors
    /// When a report can't be written as JSON. None is known that can't.
    ///
    /// *Cost*: that of the lists.
    pub fn report_json_within(&self, limit: usize, maps: Maps) -> Result<String, serde_json::Error> {
        match self {
            RepairedFile::Mesh(mesh) => json(&mesh.record().document(limit, maps)),
            RepairedFile::Parts(parts) => {
                json(&parts.document_of(|part| part.record().document(limit, maps))?)
            }
        }
    }

    /// What the output does not carry.
    pub fn losses(&self) -> &[Loss] {
        match self {
            RepairedFile::Mesh(mesh) => &mesh.report.losses,
            RepairedFile::Parts(parts) => &parts.losses,
        }
    }

    /// The reports on the meshes: one, or one for each part that was repaired.
    pub fn reports(&self) -> Vec<&RepairDocument> {
        match self {
            RepairedFile::Mesh(mesh) => vec![&mesh.report],
            RepairedFile::Parts(parts) => {
                parts.parts.iter().filter_map(|(_, outcome)| outcome.report()).collect()
            }
        }
    }

    /// What of it fails the run, by the gate that it was repaired for.
    pub fn failing(&self) -> &[Failing] {
        match self {
            RepairedFile::Mesh(mesh) => &mesh.report.failing,
            RepairedFile::Parts(parts) => &parts.failing,
        }
    }

    /// Finds what of it fails the run.
    pub(super) fn pass_through(&mut self, gate: &Gate) {
        let failing = gate.failing(|criterion| self.count(criterion));
        match self {
            RepairedFile::Mesh(mesh) => mesh.report.failing = failing,
            RepairedFile::Parts(parts) => parts.failing = failing,
        }
    }

    /// How many elements meet a criterion. Defects are those of the result; it must have been judged.
    pub fn count(&self, criterion: Criterion) -> u64 {
        match criterion {
            Criterion::Defect(_) | Criterion::Removed => {
                self.reports().iter().map(|report| report.count(criterion)).sum()
            }
            Criterion::Loss(_) => criterion.count_in(self.losses()),
            Criterion::Changed => self.is_changed().into(),
            Criterion::Left => self.left(),
        }
    }

    /// How much is named as left: defects of the result, what passes say that they could not mend where no defect tells of it,
    /// and parts that were not repaired.
    pub fn left(&self) -> u64 {
        let unrepaired = match self {
            RepairedFile::Mesh(_) => 0,
            RepairedFile::Parts(parts) => {
                parts.parts.iter().filter(|(_, part)| part.report().is_none()).count()
            }
        };
        self.reports().iter().map(|report| report.left()).sum::<u64>() + unrepaired as u64
    }

    /// Says that the output is not written after all.
    pub fn withhold(&mut self) {
        match self {
            RepairedFile::Mesh(mesh) => {
                let report = &mut mesh.report;
                report.output = None;
                if let Some(after) = &mut report.after {
                    (after.file, after.format) = (None, None);
                }
            }
            RepairedFile::Parts(parts) => parts.output = None,
        }
    }

    /// What is ready to be written, if there was a target.
    pub fn prepared(&self) -> Option<&PreparedFile> {
        match self {
            RepairedFile::Mesh(mesh) => mesh.prepared.as_ref(),
            RepairedFile::Parts(parts) => parts.prepared.as_ref(),
        }
    }

    /// The result made ready for an output that it was not repaired for. The report does not tell of it; what the output does
    /// not carry, [`PreparedFile::losses`] tells.
    ///
    /// # Errors
    /// If it can't be written as the target says.
    ///
    /// *Cost*: linear.
    pub fn prepared_for(&self, target: &FileTarget) -> Result<PreparedFile, WriteError> {
        match self {
            RepairedFile::Mesh(mesh) => target.prepared(&mesh.repaired.mesh),
            RepairedFile::Parts(parts) => target.prepared_document(parts.written()),
        }
    }
}

impl RepairedMesh {
    /// What is known of the mesh.
    pub fn record(&self) -> RepairRecord<'_> {
        RepairRecord {
            stored: &self.file.mesh,
            repaired: &self.repaired,
            report: &self.report,
            checks: &self.checks,
        }
    }
}

impl RepairedPart {
    /// What is known of the part.
    pub fn record(&self) -> RepairRecord<'_> {
        let RepairedPart { stored, repaired, report, checks } = self;
        RepairRecord { stored, repaired, report, checks }
    }
}

impl RepairedParts {
    pub(super) fn new(name: &str, document: Document, parts: Vec<(usize, PartOutcome)>) -> Self {
        let (name, losses) = (name.to_owned(), Vec::new());
        let failing = Vec::new();
        RepairedParts { name, output: None, document, parts, losses, failing, whole: None, prepared: None }
    }

    /// The document that is written.
    pub fn written(&self) -> &Document {
        self.whole.as_ref().unwrap_or(&self.document)
    }

    /// Whether a part changed.
    pub fn is_changed(&self) -> bool {
        self.parts.iter().any(|(_, outcome)| outcome.report().is_some_and(|report| report.changed))
    }

    /// All reports as one document.
    ///
    /// # Errors
    /// When a report can't be written as JSON. None is known that can't.
    pub fn document(&self) -> Result<PartsDocument, serde_json::Error> {
        self.document_of(|part| &part.report)
    }

    /// All reports as one document, each as it is made of its part.
    fn document_of<'a, R: Serialize>(
        &'a self,
        report: impl Fn(&'a RepairedPart) -> R,
    ) -> Result<PartsDocument, serde_json::Error> {
        let mut together = PartsDocument::default();
        for (number, outcome) in &self.parts {
            let part = &self.document.parts[*number];
            match outcome {
                PartOutcome::Repaired(repaired) => together.add(*number, part, &report(repaired))?,
                PartOutcome::Sealed(reason) => together.add_without(*number, part, "sealed", reason),
                PartOutcome::GivenBack(reason) => together.add_without(*number, part, "given_back", reason),
            }
        }
        together.say("changed", &self.is_changed())?;
        together.say("file", &self.name)?;
        together.say("output", &self.output)?;
        together.say("notes", &self.document.notes)?;
        together.say("losses", &self.losses)?;
        if !self.failing.is_empty() {
            together.say("failing", &self.failing)?;
        }
        Ok(together)
    }
}

impl PartOutcome {
    /// The report, if the part was repaired.
    pub fn report(&self) -> Option<&RepairDocument> {
        match self {
            PartOutcome::Repaired(part) => Some(&part.report),
            PartOutcome::Sealed(_) | PartOutcome::GivenBack(_) => None,
        }
    }

    /// Whether it was repaired, and a face is left.
    pub(super) fn has_faces(&self) -> bool {
        self.report().is_some_and(|report| report.stored.after.faces > 0)
    }
}
