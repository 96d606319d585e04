//! `meshmend convert`: the same mesh in another format.

use std::path::PathBuf;

use clap::Args;

use super::{name, read};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::outputs::{Content, Files};
use crate::render;
use crate::words::OutputWords;

/// Write a mesh in another format, and say what that format can't carry
///
/// Nothing is repaired: what is wrong with the mesh stays as it is.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// The file to read
    #[arg(value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write; it may be the same
    #[arg(value_name = "OUT")]
    output: PathBuf,
    #[command(flatten)]
    words: OutputWords,
}

impl Convert {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let options = self.words.options(&self.output)?;
        Files::of_mesh(&self.input).writing("the output", Some(&self.output), Content::Mesh).check()?;
        let progress = console.progress(2);
        progress.step("read");
        let file = read(&self.input)?;
        progress.step("write");
        let losses = meshmend::write(&self.output, &file.mesh, &options.as_read(&file))?;
        drop(progress);
        let text = render::conversion(&name(&self.input), &name(&self.output), &file, &losses);
        console.write(&text)?;
        Ok(Status::Done)
    }
}
