//! `meshmend check`: what a mesh is, and what is wrong with it and where.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::report::{CheckDocument, json};
use meshmend::topology::Witness;
use meshmend::{CheckOptions, CheckReport, DefectKind, check};

use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::render;
use crate::streams::{InputWords, name};
use crate::words::{self, Welding};

/// Tell what meshes are, and what is wrong with them and where
///
/// Files are judged as stored, by index; STL, which has no indices, as welded exactly. A check changes nothing.
#[derive(Debug, Args)]
pub(crate) struct Check {
    #[arg(help = format_words::inputs_help(), required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    #[command(flatten)]
    from: InputWords,
    /// Judge as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal such as 0.01%
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// The structure to compute on; the answers are the same, unless it can't hold the mesh
    #[arg(long, default_value = "edge-use")]
    kernel: String,
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
        let fail_on: Result<Vec<_>, _> =
            self.fail_on.iter().map(|word| words::defect_kind(program.rules, word)).collect();
        let options = CheckOptions::default()
            .with_kernel(words::any_kernel(program.kernels, &self.kernel)?)
            .with_kernels(program.kernels)
            .with_witness(self.witness.into())
            .with_rules(program.rules);
        let asked = Asked { options, fail_on: fail_on? };
        let (mut status, mut rows) = (Status::Done, Vec::new());
        for (place, file) in self.files.iter().enumerate() {
            if console.is_closed() {
                break;
            }
            match self.check_file(file, &asked, console) {
                Ok((document, found)) => {
                    status = status.and(found);
                    if self.table {
                        rows.push(document);
                        continue;
                    }
                    let gap = if place > 0 && !self.json { "\n" } else { "" };
                    let text = self.text(&document, console)?;
                    console.write(&format!("{gap}{text}"))?;
                }
                Err(failure) if failure.status == Status::Usage => return Err(failure),
                Err(failure) => {
                    console.complain(&failure);
                    status = status.and(failure.status);
                }
            }
        }
        if !rows.is_empty() {
            console.write(&render::paper_tables(&rows, console.style()))?;
        }
        Ok(status)
    }

    /// The report on one file, and whether it fails.
    fn check_file(
        &self,
        path: &Path,
        asked: &Asked,
        console: &mut Console<'_>,
    ) -> Result<(CheckDocument, Status), Failure> {
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(path)));
        let file = self.from.read(path, console)?;
        progress.step(&format!("check {}", name(path)));
        let view = words::view(self.weld, &file);
        let report = check(&file.mesh, &asked.options.with_view(view))
            .map_err(|error| Failure::of_pass(&name(path), &error))?;
        let status = if asked.is_failing(&report) { Status::DefectsFound } else { Status::Done };
        let document =
            CheckDocument::new(report.listing(&asked.fail_on), self.limit).of_file(name(path), &file);
        Ok((document, status))
    }

    fn text(&self, document: &CheckDocument, console: &Console<'_>) -> Result<String, Failure> {
        if self.json { json_line(document) } else { Ok(render::check(document, console.style())) }
    }
}

/// How it is looked, and what of what is found fails a check beside what always does.
struct Asked {
    options: CheckOptions,
    fail_on: Vec<DefectKind>,
}

impl Asked {
    fn is_failing(&self, report: &CheckReport) -> bool {
        !report.is_sound() || self.fail_on.iter().any(|&kind| report.count(kind) > 0)
    }
}

/// A document as one line.
pub(super) fn json_line(document: &impl serde::Serialize) -> Result<String, Failure> {
    let text = json(document).map_err(|error| Failure::unwritable("report", error))?;
    Ok(text + "\n")
}
