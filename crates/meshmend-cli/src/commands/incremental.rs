//! `meshmend incremental`: the Betti numbers as a mesh is put together cell by cell.

use std::path::PathBuf;

use clap::Args;
use meshmend::report::IncrementalDocument;

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, reserve, write_text};
use crate::words::{self, Welding};

/// Tell what each vertex, edge and face changes when they are added one after another
///
/// Face by face in the order of the file, each after those of its vertices and edges that are not there yet. A vertex
/// starts a component; an edge joins two components or starts a loop; a face fills a loop or encloses a void. The
/// numbers are the Betti numbers mod 2 of what is there, and in the end those that `check` gives.
#[derive(Debug, Args)]
pub(crate) struct Incremental {
    #[arg(help = format_words::input_help(), value_name = "FILE")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    from: InputWords,
    /// Take the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// Also draw the numbers over the steps; `-` is standard output
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,
    /// How many steps are listed at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    limit: usize,
}

impl Incremental {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        Files::of_mesh(&self.file).writing("--plot", self.plot.as_deref(), Content::Picture).check()?;
        if let Some(path) = &self.plot {
            reserve(path, Report::of(self.json), console)?;
        }
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(&self.file)));
        let file = self.from.read(&self.file, console)?;
        progress.step("add cells");
        let view = words::view(self.weld, &file);
        let built = IncrementalDocument::new(&file.mesh, view, self.limit);
        let (document, built) = built.map_err(|error| Failure::of_pass(&name(&self.file), &error))?;
        let document = document.of_file(name(&self.file), &file);
        if let Some(path) = &self.plot {
            let picture = render::step_plot(&name(&self.file), &built);
            write_text(path, &picture, console)?;
        }
        drop(progress);
        let text =
            if self.json { json_line(&document)? } else { render::incremental(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }
}
