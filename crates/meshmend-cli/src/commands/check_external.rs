//! The words of a check within a bound of memory, and the check.

use std::env;
use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::report::CheckDocument;
use meshmend::{Distance, ExternalOptions, View, check_external};

use super::check::Asked;
use super::checked_file::CheckedFile;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::jobs::size;
use crate::streams::{InputWords, is_stream, name};
use crate::words::Welding;

/// How much memory a check may use.
#[derive(Debug, Args)]
pub(crate) struct MemoryWords {
    /// Check binary PLY or STL within so much memory, such as 1GiB, however large it is; the answers are the same
    #[arg(long, value_name = "SIZE", value_parser = size)]
    #[arg(conflicts_with_all = ["parts", "by", "place", "kernel", "geometry", "witness"])]
    #[cfg_attr(feature = "report", arg(conflicts_with = "html"))]
    pub(super) memory: Option<u64>,
    /// The folder for what does not fit the memory; by default that of the system for temporary files
    #[arg(long, value_name = "DIR", requires = "memory")]
    spill: Option<PathBuf>,
}

impl MemoryWords {
    /// Refuses a check that takes a mesh in memory.
    pub(super) fn refuse(&self, why: &str) -> Result<(), Failure> {
        self.memory.map_or(Ok(()), |_| Err(Failure::usage(format!("--memory: {why}"))))
    }

    /// The report on a file, of which no more than so much is in memory at a time.
    pub(super) fn check(
        &self,
        path: &Path,
        (from, weld, (memory, limit)): (InputWords, Option<Welding>, (u64, usize)),
        asked: &Asked,
        console: &mut Console<'_>,
    ) -> Result<CheckedFile, Failure> {
        if is_stream(path) {
            return Err(Failure::usage(
                "--memory reads a file several times, and standard input can be read once",
            ));
        }
        let progress = console.progress(1);
        progress.step(&format!("check {}", name(path)));
        let mut options = ExternalOptions::within(memory);
        options.limit = limit;
        options.folder = self.spill.clone().unwrap_or_else(env::temp_dir);
        options.read = from.options();
        options.is_welded = match weld.map(Welding::view) {
            None => None,
            Some(View::Indexed) => Some(false),
            Some(View::Welded(Distance::Exact)) => Some(true),
            Some(_) => return Err(Failure::usage("--memory takes --weld none or exact")),
        };
        let report = check_external(path, &options, asked.options.kernels)
            .map_err(|error| Failure::of_external(&name(path), error))?
            .listing(&asked.fail_on);
        let is_failing = !report.is_sound() || asked.fail_on.iter().any(|&kind| report.count(kind) > 0);
        Ok(CheckedFile {
            name: name(path),
            document: None,
            reports: vec![(0, Some(CheckDocument::of_external(&report, name(path), limit)))],
            #[cfg(feature = "report")]
            whole: Vec::new(),
            status: if is_failing { Status::Failing } else { Status::Done },
        })
    }
}
