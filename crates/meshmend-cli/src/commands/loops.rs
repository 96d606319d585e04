//! `meshmend loops`: the closed paths that generate a surface.

use std::num::NonZeroU32;
use std::path::PathBuf;

use clap::Args;
use meshmend::cutting::CutError;
use meshmend::report::LoopsDocument;
use meshmend::topology::{CoTree, GeneratorError, Measure, Roots};
use meshmend::{LoopError, LoopOptions, PathOptions, VertexId, View, loops};

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::render;
use crate::streams::{InputWords, name};

/// Show the closed paths that generate each surface: its handles, cross-caps and holes
///
/// A path is listed with its vertices, its length, and whether it has two sides. A component that is not a surface has no
/// paths, and the report says why. STL, which has no indices, is taken as welded exactly.
#[derive(Debug, Args)]
pub(crate) struct Loops {
    #[arg(help = crate::format_words::input_help(), value_name = "FILE")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    words: LoopWords,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// How many components are shown at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    limit: usize,
}

/// How to look for the closed paths of surfaces.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct LoopWords {
    /// Find the shortest system of paths that all begin at the root
    #[arg(long)]
    greedy: bool,
    /// Begin at this vertex in its component, in place of the lowest
    #[arg(long, value_name = "V")]
    root: Option<u32>,
    /// Try so many vertices of each component, spread evenly, and keep the one with the shortest paths
    #[arg(long, value_name = "N", conflicts_with = "root")]
    roots: Option<NonZeroU32>,
    /// Count edges in place of measuring them
    #[arg(long)]
    hops: bool,
}

impl LoopWords {
    pub(super) fn paths(self) -> PathOptions {
        let root = self.root.map_or(Roots::Lowest, |vertex| Roots::At(VertexId(vertex)));
        PathOptions::default()
            .with_measure(if self.hops { Measure::Hops } else { Measure::Length })
            .with_co_tree(if self.greedy { CoTree::Greedy } else { CoTree::Lowest })
            .with_roots(self.roots.map_or(root, Roots::Best))
    }
}

impl Loops {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let progress = console.progress(2);
        progress.step("read");
        let file = self.from.read(&self.file, console)?;
        progress.step("loops");
        let view = View::usual_for(file.format);
        let options = LoopOptions::default().with_view(view).with_paths(self.words.paths());
        let report = loops(&file.mesh, &options).map_err(|error| failure(&name(&self.file), error))?;
        let document = LoopsDocument::new(&report, self.limit).of_file(name(&self.file), &file);
        drop(progress);
        let text = if self.json { json_line(&document)? } else { render::loops(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }
}

/// Why there are no paths or no cut, for the mesh of a file.
pub(super) fn failure(file: &str, error: LoopError) -> Failure {
    let status = match &error {
        LoopError::Pass(error) => return Failure::of_pass(file, error),
        LoopError::Generators(error) | LoopError::Cut(CutError::Generators(error)) => match error {
            GeneratorError::NoSuchRoot(_) => Status::Usage,
            _ => Status::Refused,
        },
        LoopError::Cut(_) => Status::Refused,
    };
    Failure { status, message: format!("{file}: {error}") }
}
