//! The repair of a file of several parts: each is repaired by itself, in its own space.

use meshmend_core::{DraftError, PolygonMesh, Provenance, Watch};
use meshmend_io::{Document, Part, PartSource, PartStatus};
use meshmend_repair::{Emptying, NamedPart, PassError, Plan, Session, joined_parts, named_parts};

use super::{
    FaceNames, FileError, FileRepair, FileTarget, Judged, KeptChecks, Maps, PartOutcome, RepairedPart,
    RepairedParts,
};
use crate::View;
use crate::report::{ProvenanceDocument, RepairDocument};

impl FileRepair {
    /// Repairs the parts of a document that are chosen, each by itself.
    pub(super) fn run_by_parts(
        &self,
        name: &str,
        document: Document,
        target: Option<&FileTarget>,
        watch: &Watch,
    ) -> Result<RepairedParts, FileError> {
        let named = self.parts.by.map(|names| Named::of(names, &document, name)).transpose()?;
        let document = match &named {
            Some(named) => named.names.document(document, named.parts.iter()),
            None => document,
        };
        let chosen = self.parts.chosen(&document)?;
        // A file of parts can't hold one without faces: such a part is given back as it was.
        let plan = Plan { empty: Emptying::Refuse, ..self.plan.clone() };
        let judged = if self.judged == Judged::Neither { Judged::After } else { self.judged };
        let work = Work { repair: &FileRepair { plan, judged, ..self.clone() }, name, target, watch };
        let mut repaired = work.all(document, &chosen)?;
        repaired.whole = named.as_ref().map(|named| named.joined(&repaired)).transpose()?;
        if let Some(target) = target {
            let prepared = target.prepared_document(repaired.written())?;
            repaired.losses = prepared.losses();
            repaired.output = target.named();
            repaired.prepared = Some(prepared);
        }
        Ok(repaired)
    }
}

impl FileRepair {
    /// Repairs a part of a file, or a mesh that is from none, for an output. It is judged before the repair in a view.
    ///
    /// # Errors
    /// When a policy says so, a kernel can't hold the mesh, or no face would be left.
    ///
    /// *Cost*: that of the passes; linear beside that.
    pub fn run_mesh(
        &self,
        mesh: &PolygonMesh,
        view: View,
        target: Option<&FileTarget>,
        watch: &Watch,
    ) -> Result<RepairedPart, PassError> {
        let judging = self.judging();
        let pipeline = self.pipeline(mesh, target);
        let mut session = Session::begin(mesh).with_watch(watch);
        let mut before = None;
        if self.judged == Judged::BeforeAndAfter {
            session = session.with_figures();
            before = Some(judging.before(&mut session, view)?);
        }
        let mut repaired = pipeline.run_in(session.with_kernel(self.kernel))?;
        let mut report = RepairDocument::new(mesh, &repaired, self.limit);
        if self.maps == Maps::Whole {
            report.provenance = Some(ProvenanceDocument::new(&repaired.provenance));
        }
        let checks = match self.judged {
            Judged::Neither => KeptChecks::default(),
            _ => judging.add(before, &mut repaired, &mut report, watch)?,
        };
        Ok(RepairedPart { stored: mesh.clone(), repaired, report, checks })
    }
}

/// What the work on a part is called to whoever watches: its place is that among those that are chosen.
pub const PART: &str = "part";

/// How each part is repaired.
struct Work<'a> {
    repair: &'a FileRepair,
    name: &'a str,
    target: Option<&'a FileTarget>,
    watch: &'a Watch,
}

impl Work<'_> {
    fn all(&self, mut document: Document, chosen: &[usize]) -> Result<RepairedParts, FileError> {
        let (mut parts, mut emptied) = (Vec::new(), None);
        for (place, &number) in chosen.iter().enumerate() {
            let part = &document.parts[number];
            let look = self.watch.look(PART, place, chosen.len());
            look.map_err(|stopped| FileError::of_pass(self.name, stopped))?;
            if let Some(reason) = part.seal() {
                parts.push((number, PartOutcome::Sealed(reason.to_owned())));
                continue;
            }
            let view = View::usual_for_part(document.format, part);
            match self.repair.run_mesh(&part.mesh, view, self.target, self.watch) {
                Ok(repaired) => {
                    document.parts[number].mesh = repaired.repaired.mesh.clone();
                    parts.push((number, PartOutcome::Repaired(Box::new(repaired))));
                }
                Err(error @ PassError::Emptied(_)) => {
                    parts.push((number, PartOutcome::GivenBack(error.to_string())));
                    emptied = Some(error);
                }
                Err(error) => {
                    return Err(FileError::of_pass(&format!("{}: {}", self.name, part.title()), error));
                }
            }
        }
        if let Some(error) = emptied.filter(|_| !parts.iter().any(|(_, outcome)| outcome.has_faces())) {
            return Err(FileError::NoPartLeft { file: self.name.to_owned(), error });
        }
        Ok(RepairedParts::new(self.name, document, parts))
    }
}

/// A mesh that was taken apart by the names of its faces.
struct Named {
    names: FaceNames,
    whole: PolygonMesh,
    parts: Vec<NamedPart>,
}

impl Named {
    fn of(names: FaceNames, document: &Document, file: &str) -> Result<Self, FileError> {
        let whole = names.mesh(document, file)?;
        let parts = named_parts(&whole, names.layer()).map_err(|error| FileError::of_pass(file, error))?;
        Ok(Named { names, parts: parts.ok_or_else(|| names.missing(file))?, whole })
    }

    /// The file with the whole mesh again, in which the parts are as they are now.
    fn joined(&self, repaired: &RepairedParts) -> Result<Document, FileError> {
        let mut records: Vec<Provenance> =
            self.parts.iter().map(|part| Provenance::same(part.mesh.counts())).collect();
        for (number, outcome) in &repaired.parts {
            if let PartOutcome::Repaired(part) = outcome {
                records[*number] = part.repaired.provenance.clone();
            }
        }
        let now = self.parts.iter().zip(&repaired.document.parts).zip(&records);
        let now: Vec<_> = now.map(|((named, part), record)| (named, &part.mesh, record)).collect();
        let failed = |error: DraftError| FileError::of_pass(&repaired.name, error);
        let (mesh, _) = joined_parts(&self.whole, &now).map_err(failed)?;
        let part = Part { name: Vec::new(), source: PartSource::Whole, mesh, status: PartStatus::Editable };
        Ok(repaired.document.clone().with_parts(vec![part]))
    }
}
