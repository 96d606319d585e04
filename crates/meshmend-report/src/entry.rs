//! A mesh of a page: what is said of it, and what it looks like.

use std::sync::Arc;

use meshmend::files::{PartOutcome, RepairRecord, RepairedFile};
use meshmend::report::CheckDocument;
use meshmend::{CheckReport, PolygonMesh};
use serde::Serialize;
use serde_json::{Value, json};

use crate::mesh::middle;
use crate::packed::Packed;
use crate::state::State;
use crate::verdict::Verdict;

/// What of meshes is put into a page.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct EntryOptions {
    /// A mesh of more faces is shown by its defects, what is round them, and its shape.
    pub max_faces: usize,
}

impl Default for EntryOptions {
    fn default() -> Self {
        EntryOptions { max_faces: 2_000_000 }
    }
}

impl EntryOptions {
    /// These options with another number of faces up to which a mesh is whole in the page.
    #[must_use]
    pub fn with_max_faces(self, max_faces: usize) -> Self {
        EntryOptions { max_faces }
    }
}

/// A mesh of a page: a file, or a part of one.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    name: String,
    /// What of its file it is, where that has several parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<String>,
    pub(crate) verdict: Verdict,
    /// `check`, `repair`, `batch`, or null where there is no report.
    pub(crate) command: Option<&'static str>,
    /// The document of the check or the repair, or what a row says.
    pub(crate) report: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    before: Option<State>,
    #[serde(skip_serializing_if = "Option::is_none")]
    after: Option<State>,
    #[serde(skip_serializing_if = "Option::is_none")]
    changes: Option<Changes>,
}

/// What a repair changed, whole, by ids.
#[derive(Clone, Debug, Serialize)]
struct Changes {
    /// Faces as stored that are gone, by reason.
    removed: Vec<(String, Packed)>,
    /// Faces of the result that run the other way round than as stored.
    flipped: Packed,
    /// Faces of the result that were not stored.
    created: Packed,
}

impl Entry {
    /// A mesh as stored with the report of a check on it, and the document of that report.
    ///
    /// # Errors
    /// When the document can't be written as JSON. None is known that can't.
    ///
    /// *Cost*: that of drawing the mesh once; near-linear beside that.
    pub fn of_check(
        name: &str,
        (stored, report): (&PolygonMesh, &CheckReport),
        document: &CheckDocument,
        options: &EntryOptions,
    ) -> Result<Self, serde_json::Error> {
        Ok(Entry {
            name: name.to_owned(),
            part: None,
            verdict: Verdict::of_check(document),
            command: Some("check"),
            report: serde_json::to_value(document)?,
            before: Some(State::of((stored, report), middle(stored.positions()), options)),
            after: None,
            changes: None,
        })
    }

    /// The meshes of a file that was repaired, whose checks were [kept](meshmend::files::WholeChecks::Kept): one, or one for each
    /// part.
    ///
    /// # Errors
    /// When a document can't be written as JSON. None is known that can't.
    ///
    /// *Cost*: that of drawing each mesh twice; near-linear beside that.
    pub fn of_repair(
        name: &str,
        repaired: &RepairedFile,
        options: &EntryOptions,
    ) -> Result<Vec<Self>, serde_json::Error> {
        let parts = match repaired {
            RepairedFile::Mesh(mesh) => return Ok(vec![Self::of_record(name, mesh.record(), options)?]),
            RepairedFile::Parts(parts) => parts,
        };
        let entry = |(number, outcome): &(usize, PartOutcome)| {
            let entry = match outcome {
                PartOutcome::Repaired(part) => Self::of_record(name, part.record(), options)?,
                PartOutcome::Sealed(reason) | PartOutcome::GivenBack(reason) => Self::without(name, reason),
            };
            Ok(entry.of_part(parts.document.parts[*number].title()))
        };
        parts.parts.iter().map(entry).collect()
    }

    /// A file of which there is only a reason why nothing is said of it.
    pub fn without(name: &str, reason: &str) -> Self {
        Entry {
            name: name.to_owned(),
            part: None,
            verdict: Verdict { state: "unread", sentence: reason.to_owned() },
            command: None,
            report: Value::Null,
            before: None,
            after: None,
            changes: None,
        }
    }

    /// The entry as that of a part of a file.
    #[must_use]
    pub fn of_part(self, title: String) -> Self {
        Entry { part: Some(title), ..self }
    }

    /// What the mesh is called: its file, and which part of it it is.
    pub fn title(&self) -> String {
        match &self.part {
            Some(part) => format!("{}, {part}", self.name),
            None => self.name.clone(),
        }
    }

    /// What became of the mesh, in one sentence.
    pub fn verdict(&self) -> &str {
        &self.verdict.sentence
    }

    fn of_record(
        name: &str,
        record: RepairRecord<'_>,
        options: &EntryOptions,
    ) -> Result<Self, serde_json::Error> {
        let checks = record.checks;
        let origin = middle(record.stored.positions());
        let state =
            |mesh: &PolygonMesh, report: &Arc<CheckReport>| State::of((mesh, report), origin, options);
        let before = checks.before.as_ref().map(|report| state(record.stored, report));
        let after = checks.after.as_ref().map(|report| state(&record.repaired.mesh, report));
        let mut report = serde_json::to_value(record.report)?;
        if report["file"].is_null() {
            report["file"] = json!(name);
        }
        Ok(Entry {
            name: name.to_owned(),
            part: None,
            verdict: Verdict::of_repair(record.report),
            command: Some("repair"),
            report,
            before,
            after,
            changes: Some(Changes::of(&record)),
        })
    }
}

impl Changes {
    fn of(record: &RepairRecord<'_>) -> Self {
        let mut removed: Vec<(String, Vec<u32>)> = Vec::new();
        for face in &record.repaired.removed_faces {
            let reason = face.reason.code();
            match removed.iter_mut().find(|(known, _)| known == reason) {
                Some((_, faces)) => faces.push(face.face.0),
                None => removed.push((reason.to_owned(), vec![face.face.0])),
            }
        }
        Changes {
            removed: removed.into_iter().map(|(reason, faces)| (reason, Packed::Numbers(faces))).collect(),
            flipped: record.repaired.provenance.flipped.iter().map(|face| face.0).collect(),
            created: record.repaired.created_faces.iter().map(|(face, _)| face.0).collect(),
        }
    }
}
