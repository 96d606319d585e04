//! `meshmend advise`: which weld tolerance stands out in a mesh, if one does.

use std::path::PathBuf;

use clap::Args;
use meshmend::passes::Advice;
use meshmend::report::AdviceDocument;

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, reserve, write_text};

/// Tell which weld tolerance stands out in a mesh, if one does
///
/// Vertices of boundary edges are joined in thought, nearest first. Where many lie close together and then none for a long while,
/// a crack is there that a tolerance closes without harm. `repair --weld auto` takes it. Nothing is changed.
#[derive(Debug, Args)]
pub(crate) struct Advise {
    #[arg(help = format_words::input_help(), value_name = "FILE")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    from: InputWords,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// Also draw how many vertices would be joined, and edges closed, by distance; `-` is standard output
    #[arg(long, value_name = "OUT.svg")]
    svg: Option<PathBuf>,
}

impl Advise {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        Files::of_mesh(&self.file).writing("--svg", self.svg.as_deref(), Content::Picture).check()?;
        if let Some(path) = &self.svg {
            reserve(path, Report::of(self.json), console)?;
        }
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(&self.file)));
        let file = self.from.read(&self.file, console)?;
        let advice = Advice::on(&file.mesh, &progress.watch())
            .map_err(|error| Failure::of_pass(&name(&self.file), &error))?;
        let document = AdviceDocument::new(name(&self.file), file.variant, advice);
        if let Some(path) = &self.svg {
            write_text(path, &render::advice_plot(&document), console)?;
        }
        drop(progress);
        let text = if self.json { json_line(&document)? } else { render::advice(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }
}
