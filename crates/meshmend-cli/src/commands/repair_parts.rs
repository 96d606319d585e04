//! `meshmend repair` of a file of several parts: each is mended by itself, in its own space.

use meshmend::formats::{Document, Part, PartSource, PartStatus, Placing, PreparedDocument, WriteError};
use meshmend::mesh::{DraftError, Provenance};
use meshmend::passes::{Emptying, NamedPart, PassError, joined_parts, named_parts};
use meshmend::report::{PartsDocument, ProvenanceDocument, RepairDocument};
use meshmend::{KernelKind, Loss, Pipeline, Plan, PolygonMesh, Repaired, Session, View};

use super::check::json_line;
use super::judging::Judging;
use super::repair::{Repair, Target};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::parts::ByWord;
use crate::render;
use crate::streams::{name, output_name, write_document};

/// What became of the parts of a file.
pub(crate) struct RepairedFile {
    /// What the file is called.
    pub(crate) name: String,
    /// What the output is called, if there is one.
    pub(crate) output: Option<String>,
    /// The file, with the meshes that its parts have now.
    pub(crate) document: Document,
    /// The parts that were asked for, by number.
    pub(crate) parts: Vec<(usize, PartResult)>,
    /// What the output does not carry.
    pub(crate) losses: Vec<Loss>,
}

/// What became of a part.
pub(crate) enum PartResult {
    /// It was repaired.
    Repaired(Box<RepairDocument>),
    /// It can't be edited, for this reason.
    Sealed(String),
    /// It is as it was, as no face would be left of it.
    GivenBack(String),
}

/// How each part is repaired.
struct Work<'a> {
    repair: &'a Repair,
    target: Option<&'a Target<'a>>,
    plan: Plan,
    kernel: KernelKind,
    judging: Judging,
}

impl Repair {
    /// Repairs the parts of a document that are asked for, each by itself, and writes the file.
    pub(super) fn repair_parts(
        &self,
        document: Document,
        (plan, kernel, judging): (Plan, KernelKind, Judging),
        console: &mut Console<'_>,
    ) -> Result<Status, Failure> {
        let named = self.parts.by.map(|by| Named::of(by, &document, &name(&self.input))).transpose()?;
        let document = match &named {
            Some(named) => named.by.document(document, named.parts.iter()),
            None => document,
        };
        let chosen = self.parts.chosen(&document)?;
        let target = self.document_target(&document)?;
        // A file of parts can't hold one without faces: such a part is given back as it was.
        let plan = Plan { empty: Emptying::Refuse, ..plan };
        let work = Work { repair: self, target: target.as_ref(), plan, kernel, judging };
        let (mut repaired, records) = work.all(document, &chosen, console)?;
        let whole = named.as_ref().map(|named| named.joined(&repaired, &records)).transpose()?;
        let written = whole.as_ref().unwrap_or(&repaired.document);
        let prepared = target.as_ref().map(|target| prepared(target, written)).transpose()?;
        if let Some(prepared) = &prepared {
            repaired.losses = prepared.losses();
        }
        if let (Some(target), false) = (&target, self.dry_run) {
            repaired.output = Some(output_name(target.path));
        }
        self.write_parts(&repaired, target.as_ref().zip(prepared.as_ref()), console)?;
        let text = if self.json {
            json_line(&repaired.parts_document()?)?
        } else {
            render::repaired_parts(&repaired, console.style())
        };
        console.write(&text)?;
        Ok(Status::Done)
    }

    fn document_target(&self, document: &Document) -> Result<Option<Target<'_>>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        Ok(Some(Target { path, options: self.words.options_of(path, document.format, &document.shell)? }))
    }

    /// Writes the file and the report, as for a file of one mesh.
    fn write_parts(
        &self,
        repaired: &RepairedFile,
        output: Option<(&Target<'_>, &PreparedDocument)>,
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        let write = |console: &mut Console<'_>| match output {
            Some((target, prepared)) if !self.dry_run => write_document(target.path, prepared, console),
            _ => Ok(()),
        };
        match &self.report {
            None => write(console),
            Some(report) => {
                let text = json_line(&repaired.parts_document()?)?;
                self.write_report(report, &text, || write(console))
            }
        }
    }
}

fn prepared(target: &Target<'_>, document: &Document) -> Result<PreparedDocument, Failure> {
    let failed = |kind| WriteError { file: output_name(target.path), kind };
    Ok(PreparedDocument::placed(document, &target.options, Placing::Scene).map_err(failed)?)
}

/// Where the elements of each part were, for those that were repaired.
type Records = Vec<Option<Provenance>>;

/// A mesh that was taken apart by the names of its faces.
struct Named {
    by: ByWord,
    whole: PolygonMesh,
    parts: Vec<NamedPart>,
}

impl Named {
    fn of(by: ByWord, document: &Document, file: &str) -> Result<Self, Failure> {
        let whole = by.mesh(document, file)?;
        let parts = named_parts(&whole, by.layer()).map_err(|error| Failure::of_pass(file, &error.into()))?;
        Ok(Named { by, parts: parts.ok_or_else(|| by.no_names(file))?, whole })
    }

    /// The file with the whole mesh again, in which the parts are as they are now.
    fn joined(&self, repaired: &RepairedFile, records: &Records) -> Result<Document, Failure> {
        let same: Vec<Provenance> =
            self.parts.iter().map(|part| Provenance::same(part.mesh.counts())).collect();
        let now = self.parts.iter().zip(&repaired.document.parts).zip(records.iter().zip(&same));
        let now: Vec<_> = now
            .map(|((named, part), (record, same))| (named, &part.mesh, record.as_ref().unwrap_or(same)))
            .collect();
        let failed = |error: DraftError| Failure::of_pass(&repaired.name, &error.into());
        let (mesh, _) = joined_parts(&self.whole, &now).map_err(failed)?;
        let part = Part { name: Vec::new(), source: PartSource::Whole, mesh, status: PartStatus::Editable };
        Ok(repaired.document.clone().with_parts(vec![part]))
    }
}

impl Work<'_> {
    fn all(
        &self,
        mut document: Document,
        chosen: &[usize],
        console: &mut Console<'_>,
    ) -> Result<(RepairedFile, Records), Failure> {
        let (mut parts, mut emptied) = (Vec::new(), None);
        let mut records: Records = vec![None; document.parts.len()];
        let progress = console.progress(chosen.len());
        for &number in chosen {
            let part = &document.parts[number];
            progress.step(&part.title());
            if let Some(reason) = part.seal() {
                parts.push((number, PartResult::Sealed(reason.to_owned())));
                continue;
            }
            let view = View::usual_for_part(document.format, part);
            match self.part(&part.mesh, view) {
                Ok((report, mesh, record)) => {
                    records[number] = Some(record);
                    parts.push((number, PartResult::Repaired(Box::new(report))));
                    document.parts[number].mesh = mesh;
                }
                Err(error @ PassError::Emptied(_)) => {
                    parts.push((number, PartResult::GivenBack(error.to_string())));
                    emptied = Some(error);
                }
                Err(error) => return Err(Failure::of_pass(&self.called(&document, number), &error)),
            }
        }
        let is_left = |(_, result): &(usize, PartResult)| matches!(result, PartResult::Repaired(report) if report.stored.after.faces > 0);
        if let Some(error) = emptied.filter(|_| !parts.iter().any(is_left)) {
            return Err(Failure::of_part(&name(&self.repair.input), &error));
        }
        let name = name(&self.repair.input);
        Ok((RepairedFile { name, output: None, document, parts, losses: Vec::new() }, records))
    }

    fn called(&self, document: &Document, part: usize) -> String {
        format!("{}: {}", name(&self.repair.input), document.parts[part].title())
    }

    /// Repairs a mesh.
    fn part(
        &self,
        mesh: &PolygonMesh,
        view: View,
    ) -> Result<(RepairDocument, PolygonMesh, Provenance), PassError> {
        let repair = self.repair;
        let pipeline = self.pipeline(mesh);
        let mut session = Session::begin(mesh);
        let mut before = None;
        if !repair.quiet {
            session = session.with_figures();
            before = Some(self.judging.before(&mut session, view)?);
        }
        let mut repaired = pipeline.run_in(session.with_kernel(self.kernel))?;
        let mut report = RepairDocument::new(mesh, &repaired, repair.limit);
        report.provenance = repair.report_maps.then(|| ProvenanceDocument::new(&repaired.provenance));
        self.judging.add(before, &mut repaired, &mut report)?;
        let Repaired { mesh, provenance, .. } = repaired;
        Ok((report, mesh, provenance))
    }

    fn pipeline(&self, mesh: &PolygonMesh) -> Pipeline {
        self.repair.pipeline(self.plan.clone(), mesh, self.target)
    }
}

impl RepairedFile {
    /// All reports as one document.
    fn parts_document(&self) -> Result<PartsDocument, Failure> {
        let failed = |error| Failure::unwritable("report", error);
        let mut together = PartsDocument::default();
        for (number, result) in &self.parts {
            let part = &self.document.parts[*number];
            match result {
                PartResult::Repaired(report) => together.add(*number, part, report).map_err(failed)?,
                PartResult::Sealed(reason) => together.add_without(*number, part, "sealed", reason),
                PartResult::GivenBack(reason) => together.add_without(*number, part, "given_back", reason),
            }
        }
        let is_changed = |(_, result): &(usize, PartResult)| matches!(result, PartResult::Repaired(report) if report.changed);
        together.say("changed", &self.parts.iter().any(is_changed)).map_err(failed)?;
        together.say("file", &self.name).map_err(failed)?;
        together.say("output", &self.output).map_err(failed)?;
        together.say("notes", &self.document.notes).map_err(failed)?;
        together.say("losses", &self.losses).map_err(failed)?;
        Ok(together)
    }
}
