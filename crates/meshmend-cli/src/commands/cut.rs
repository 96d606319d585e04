//! `meshmend cut`: opens surfaces into discs.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use meshmend::cutting::CutAlong;
use meshmend::report::CutDocument;
use meshmend::{CutOptions, View, cut};

use super::checked_file::json_line;
use super::loops::{LoopWords, failure};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, output_name, reserve, write_mesh};

/// Cut every surface open into a disc, and say how its rim is glued to itself
///
/// Faces, corners and their attributes stay as they are; vertices on the cut are doubled. A component that is no
/// surface is refused. STL, which has no indices, is taken as welded exactly.
#[derive(Debug, Args)]
pub(crate) struct Cut {
    #[arg(help = crate::format_words::input_help(), value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write; it may be the input; `-` is standard output
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Along what to cut
    #[arg(long, value_enum, default_value_t = AlongWord::CutGraph)]
    along: AlongWord,
    #[command(flatten)]
    loops: LoopWords,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// How many items each list of the report shows at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    limit: usize,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    words: OutputWords,
}

/// Along what to cut.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum AlongWord {
    /// A graph beside which every component is a disc
    CutGraph,
    /// The paths round handles and cross-caps; for closed surfaces
    Generators,
}

impl Cut {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        self.words.check(&self.output)?;
        Files::of_mesh(&self.input).writing("--output", Some(&self.output), Content::Mesh).check()?;
        reserve(&self.output, Report::of(self.json), console)?;
        let along = match self.along {
            AlongWord::CutGraph => CutAlong::CutGraph,
            AlongWord::Generators => CutAlong::Generators,
        };
        let progress = console.progress(3);
        progress.step("read");
        let file = self.from.read(&self.input, console)?;
        let options = self.words.options_for(&self.output, &file)?;
        progress.step("cut");
        let cut_options = CutOptions::default()
            .with_view(View::usual_for(file.format))
            .with_along(along)
            .with_paths(self.loops.paths());
        let report = cut(&file.mesh, &cut_options).map_err(|error| failure(&name(&self.input), error))?;
        progress.step("write");
        let mut document = CutDocument::new(&report, along, self.limit);
        document.file = Some(name(&self.input));
        document.output = Some(output_name(&self.output));
        document.notes = file.notes;
        document.losses = write_mesh(&self.output, &report.discs.mesh, &options, console)?;
        drop(progress);
        let text = if self.json { json_line(&document)? } else { render::cut(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }
}
