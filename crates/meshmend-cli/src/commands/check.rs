//! `meshmend check`: what a mesh is, and what is wrong with it and where.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::files::{FaceNames, PartChoice};
use meshmend::formats::{Document, Part};
use meshmend::report::{CheckDocument, Listing, Sarif};
use meshmend::topology::Witness;
use meshmend::{CheckOptions, CheckReport, DefectKind, View, check, check_by_name};

#[cfg(feature = "report")]
use meshmend_report::EntryOptions;

use super::check_external::MemoryWords;
use super::checked_file::{CheckedFile, json_line};
use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::gate_words::{Asks, gate_of};
use crate::geometry_words::GeometryWords;
use crate::parts::{PartWords, PlacingWord};
use crate::render;
use crate::streams::{InputWords, as_one_mesh, is_stream, name};
use crate::words::{self, Welding};
#[cfg(feature = "report")]
use crate::{
    outputs::{Content, Files},
    pages::{self, PageFile, USUAL_LIMIT},
};

/// Tell what meshes are, and what is wrong with them and where
///
/// Files are judged as stored, by index; STL, which has no indices, as welded exactly. A check changes nothing.
#[derive(Debug, Args)]
pub(crate) struct Check {
    #[arg(help = format_words::inputs_help(), required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    parts: PartWords,
    /// Judge as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal such as 0.01%
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// Judge the parts of a file as one mesh, and how they become one; by default each is judged by itself
    #[arg(long, value_enum, value_name = "HOW", conflicts_with = "parts")]
    place: Option<PlacingWord>,
    /// The structure to compute on; the answers are the same, unless it can't hold the mesh
    #[arg(long, default_value = "edge-use")]
    kernel: String,
    #[command(flatten)]
    geometry: GeometryWords,
    #[command(flatten)]
    memory: MemoryWords,
    /// Which strip of faces shows that a patch is not orientable
    #[arg(long, value_enum, default_value_t = WitnessWord::BreadthFirst)]
    witness: WitnessWord,
    /// Print one JSON object a file and line
    #[arg(long)]
    json: bool,
    /// Print two tables with a row a file: V, E, F, χ and genus; and which elements make and fill cycles, with the
    /// Betti numbers
    #[arg(long, conflicts_with = "json")]
    table: bool,
    /// Print one SARIF document on all files, with a result for each item that is listed
    #[arg(long, conflicts_with_all = ["json", "table"])]
    sarif: bool,
    /// Also write a page on the files with the meshes in 3D, as `report --check-only` does
    #[cfg(feature = "report")]
    #[arg(long, value_name = "PAGE", conflicts_with = "by")]
    html: Option<PathBuf>,
    /// How many items each list shows at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    limit: usize,
    /// Kinds of defect that fail the check beside those that always do, and are listed; `explain` lists them
    #[arg(long, value_name = "KIND", value_delimiter = ',')]
    fail_on: Vec<String>,
}

/// What shows that a patch is not orientable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum WitnessWord {
    /// The one that is found fastest
    BreadthFirst,
    /// A shortest one; on large and wide bands this takes long
    Shortest,
}

impl From<WitnessWord> for Witness {
    fn from(word: WitnessWord) -> Self {
        match word {
            WitnessWord::BreadthFirst => Witness::BreadthFirst,
            WitnessWord::Shortest => Witness::Shortest,
        }
    }
}

impl Check {
    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let fail_on = gate_of(&self.fail_on, program.rules, Asks::Defects)?.defects();
        let options = CheckOptions::default()
            .with_kernel(words::any_kernel(program.kernels, &self.kernel)?)
            .with_kernels(program.kernels)
            .with_witness(self.witness.into())
            .with_rules(program.rules);
        let geometry = self.geometry.options(&fail_on, self.limit)?;
        if geometry.is_some() || program.rules.own().next().is_some() {
            self.memory.refuse("where faces lie, and kinds of defect of one's own, take a mesh in memory")?;
        }
        let options = options.with_geometry(geometry);
        let asked = Asked { options, fail_on };
        #[cfg(feature = "report")]
        let mut page = self.page(program)?;
        let (mut status, mut rows, mut sarif) = (Status::Done, Vec::new(), Sarif::default());
        for (place, file) in self.files.iter().enumerate() {
            if console.is_closed() {
                break;
            }
            match self.check_file(file, &asked, console) {
                Ok(checked) => {
                    status = status.and(checked.status);
                    #[cfg(feature = "report")]
                    if let Some(page) = &mut page {
                        self.add_to_page(file, &checked, page)?;
                    }
                    if self.table {
                        rows.extend(checked.into_reports());
                        continue;
                    }
                    if self.sarif {
                        checked.add_to(&mut sarif, file);
                        continue;
                    }
                    let gap = if place > 0 && !self.json { "\n" } else { "" };
                    let text = self.text(&checked, console)?;
                    console.write(&format!("{gap}{text}"))?;
                }
                Err(failure) if failure.status == Status::Usage => return Err(failure),
                Err(failure) => {
                    console.complain(&failure);
                    sarif.add_failure(&failure.message);
                    #[cfg(feature = "report")]
                    if let Some(page) = &mut page {
                        page.add_failure(file, &failure);
                    }
                    status = status.and(failure.status);
                }
            }
        }
        #[cfg(feature = "report")]
        if let Some((page, path)) = page.zip(self.html.as_deref()) {
            page.write(path, console)?;
        }
        if self.sarif {
            console.write(&json_line(&sarif.document(program.rules))?)?;
        }
        if !rows.is_empty() {
            console.write(&render::paper_tables(&rows, console.style()))?;
        }
        Ok(status)
    }

    /// The page that was asked for. What is wrong with its name is told before anything is read.
    #[cfg(feature = "report")]
    fn page(&self, program: &Program) -> Result<Option<PageFile>, Failure> {
        let Some(path) = &self.html else { return Ok(None) };
        if is_stream(path) {
            return Err(Failure::usage(
                "--html writes a file; `report --check-only -o -` writes to standard output",
            ));
        }
        let inputs = Files::default().reading_meshes(self.files.iter().map(PathBuf::as_path));
        inputs.writing("--html", Some(path), Content::Report).check()?;
        Ok(Some(PageFile::of(&pages::title(None, &self.files), program.rules, EntryOptions::default())))
    }

    /// Puts a file into the page, whose lists are longer than those that are printed.
    #[cfg(feature = "report")]
    fn add_to_page(&self, file: &Path, checked: &CheckedFile, page: &mut PageFile) -> Result<(), Failure> {
        let limit = self.limit.max(USUAL_LIMIT);
        for ((number, _), whole) in checked.reports.iter().zip(&checked.whole) {
            let Some(document) = &checked.document else { continue };
            page.add_part((file, document, *number), whole.as_ref(), limit)?;
        }
        Ok(())
    }

    /// The reports on the parts of one file, and whether they fail.
    fn check_file(
        &self,
        path: &Path,
        asked: &Asked,
        console: &mut Console<'_>,
    ) -> Result<CheckedFile, Failure> {
        if let Some(memory) = &self.memory.memory {
            let limits = (*memory, self.limit);
            return self.memory.check(path, (self.from, self.weld, limits), asked, console);
        }
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(path)));
        let mut document = self.from.read_to_weld(path, console)?;
        if let Some(place) = self.place {
            document = as_one_mesh(document, place.into(), path)?.into();
        }
        progress.step(&format!("check {}", name(path)));
        let parts = self.parts.choice();
        if let Some(names) = parts.by {
            let options = asked.options.clone().with_view(words::view_of(self.weld, document.format));
            return self.check_by((names, &parts), path, document, (&options, asked));
        }
        let (mut status, mut reports) = (Status::Done, Vec::new());
        #[cfg(feature = "report")]
        let mut whole = Vec::new();
        for part in parts.chosen(&document)? {
            if document.parts[part].seal().is_some() {
                reports.push((part, None));
                #[cfg(feature = "report")]
                whole.push(None);
                continue;
            }
            let usual = View::usual_for_part(document.format, &document.parts[part]);
            let options = asked.options.clone().with_view(self.weld.map_or(usual, Welding::view));
            let report = check(&document.parts[part].mesh, &options)
                .map_err(|error| Failure::of_pass(&name(path), &error))?;
            let fail_on = asked.failing_kinds(&document.parts[part]);
            status = status.and(status_of(&report, &fail_on));
            let report = report.listing(&fail_on);
            #[cfg(feature = "report")]
            whole.push(self.html.is_some().then(|| report.clone()));
            reports.push((part, Some(CheckDocument::new(report, self.limit))));
        }
        Ok(CheckedFile {
            name: name(path),
            document: Some(document),
            reports,
            #[cfg(feature = "report")]
            whole,
            status,
        })
    }

    /// The reports on the parts of a mesh by the names of its faces.
    fn check_by(
        &self,
        (names, parts): (FaceNames, &PartChoice),
        path: &Path,
        document: Document,
        (options, asked): (&CheckOptions, &Asked),
    ) -> Result<CheckedFile, Failure> {
        let name = name(path);
        let mesh = names.mesh(&document, &name)?;
        let reports = check_by_name(&mesh, names.layer(), options)
            .map_err(|error| Failure::of_pass(&name, &error))?
            .ok_or_else(|| names.missing(&name))?;
        let document = names.document(document, reports.iter().map(|named| &named.part));
        let chosen = parts.chosen(&document)?;
        let (mut status, mut kept) = (Status::Done, Vec::new());
        for (number, named) in
            reports.into_iter().enumerate().filter(|(number, _)| chosen.binary_search(number).is_ok())
        {
            status = status.and(status_of(&named.report, &asked.fail_on));
            let shared = Listing::cut(named.shared_edges.into_iter(), self.limit);
            let mut report = CheckDocument::new(named.report.listing(&asked.fail_on), self.limit);
            report.shared_edges = Some(shared);
            kept.push((number, Some(report)));
        }
        Ok(CheckedFile {
            name,
            document: Some(document),
            reports: kept,
            #[cfg(feature = "report")]
            whole: Vec::new(),
            status,
        })
    }

    fn text(&self, checked: &CheckedFile, console: &Console<'_>) -> Result<String, Failure> {
        match (&checked.reports[..], self.json) {
            ([(0, Some(report))], true) if checked.is_whole() => json_line(&checked.of_file(0, report)),
            (_, true) => json_line(&checked.parts_document()?),
            ([(part, Some(report))], false) => {
                Ok(render::check(&checked.of_file(*part, report), console.style()))
            }
            (_, false) => {
                let parts = |document| render::checked_parts(checked, document, console.style());
                Ok(checked.document.as_ref().map(parts).unwrap_or_default())
            }
        }
    }
}

/// How it is looked, and what of what is found fails a check beside what always does.
pub(super) struct Asked {
    pub(super) options: CheckOptions,
    pub(super) fail_on: Vec<DefectKind>,
}

impl Asked {
    /// The kinds of defect that fail a part beside those that always do.
    fn failing_kinds(&self, part: &Part) -> Vec<DefectKind> {
        let mut kinds = self.fail_on.clone();
        if part.must_be_closed() && !kinds.contains(&DefectKind::BoundaryEdge) {
            kinds.push(DefectKind::BoundaryEdge);
        }
        kinds
    }
}

/// Whether a mesh fails a check, by its defects and these kinds.
pub(super) fn status_of(report: &CheckReport, fail_on: &[DefectKind]) -> Status {
    let is_failing = !report.is_sound() || fail_on.iter().any(|&kind| report.count(kind) > 0);
    if is_failing { Status::Failing } else { Status::Done }
}
