//! `meshmend check`: what a mesh is, and what is wrong with it and where.

use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::report::{CheckDocument, json};
use meshmend::{CheckOptions, CheckReport, DefectKind, KernelKind, View, check};

use super::{name, read};
use crate::console::{Console, complain};
use crate::failure::{Failure, Status};
use crate::progress::Progress;
use crate::render;
use crate::words::{self, Welding};

/// Tell what meshes are, and what is wrong with them and where
///
/// Files are judged as stored, by index; STL, which has no indices, as welded exactly. A check changes nothing.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// The mesh files: OBJ, PLY, STL or OFF
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Judge as welded: none, exact, a length, or a percentage of the bounding box's diagonal such as 0.01%
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// The structure to compute on; the answers are the same, unless it can't hold the mesh
    #[arg(long, default_value = "edge-use", value_parser = words::kernel)]
    kernel: KernelKind,
    /// Print one JSON object a file and line
    #[arg(long)]
    json: bool,
    /// How many items each list shows at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    limit: usize,
    /// Kinds of defect that fail the check beside those that always do; `explain` lists them
    #[arg(long, value_name = "KIND", value_delimiter = ',', value_parser = words::defect_kind)]
    fail_on: Vec<DefectKind>,
}

impl Check {
    pub(crate) fn run(self) -> Result<Status, Failure> {
        let mut console = Console::open();
        let mut status = Status::Done;
        for (place, file) in self.files.iter().enumerate() {
            if console.is_closed() {
                break;
            }
            match self.check_file(file) {
                Ok((text, found)) => {
                    let gap = if place > 0 && !self.json { "\n" } else { "" };
                    console.write(&format!("{gap}{text}"))?;
                    status = status.and(found);
                }
                Err(failure) if failure.status == Status::Usage => return Err(failure),
                Err(failure) => {
                    complain(&failure);
                    status = status.and(failure.status);
                }
            }
        }
        Ok(status)
    }

    /// The report on one file as text, and whether it fails.
    fn check_file(&self, path: &Path) -> Result<(String, Status), Failure> {
        let progress = Progress::in_steps(2);
        progress.step(&format!("read {}", path.display()));
        let file = read(path)?;
        progress.step(&format!("check {}", path.display()));
        let view = self.weld.map_or(View::usual_for(file.format), Welding::view);
        let options = CheckOptions { view, kernel: self.kernel };
        let report = check(&file.mesh, &options).map_err(|error| Failure::of_pass(&name(path), &error))?;
        let status = if self.is_failing(&report) { Status::DefectsFound } else { Status::Done };
        let document = CheckDocument::new(report, self.limit).of_file(name(path), &file);
        drop(progress);
        let text = if self.json { json_line(&document)? } else { render::check(&document, Console::style()) };
        Ok((text, status))
    }

    fn is_failing(&self, report: &CheckReport) -> bool {
        !report.is_sound() || self.fail_on.iter().any(|&kind| report.count(kind) > 0)
    }
}

/// A document as one line.
pub(super) fn json_line(document: &impl serde::Serialize) -> Result<String, Failure> {
    let text = json(document).map_err(|error| Failure::unwritable("report", error))?;
    Ok(text + "\n")
}
