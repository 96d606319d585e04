//! `meshmend flatten`: surfaces laid out in the plane.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::flatten::{Boundary, Flatten as Request, Weights, svg};
use meshmend::io::replace_file;
use meshmend::report::UnfoldDocument;
use meshmend::{LoopOptions, UnfoldError, UnfoldOptions, Unfolded, View, WriteOptions, unfold};

use super::check::json_line;
use super::{loops, name, read};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::outputs::{Content, Files};
use crate::render;
use crate::words::OutputWords;

/// Lay surfaces out in the unit square, cut open where they are no discs
///
/// An OBJ gets the layout as its texture coordinates, an SVG shows it. Whether a face is flipped or has collapsed is
/// found exactly, and told. STL, which has no indices, is taken as welded exactly.
#[derive(Debug, Args)]
pub(crate) struct Flatten {
    /// The mesh file: OBJ, PLY, STL or OFF
    #[arg(value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write: a mesh, or a picture named `.svg`
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Where the boundary goes
    #[arg(long, value_enum, default_value_t = BoundaryWord::Circle)]
    boundary: BoundaryWord,
    /// What holds the other vertices
    #[arg(long, value_enum, default_value_t = WeightsWord::Tutte)]
    weights: WeightsWord,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// How many items each list of the report shows at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    limit: usize,
    #[command(flatten)]
    words: OutputWords,
}

/// Where the boundary goes.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum BoundaryWord {
    /// On a circle
    Circle,
    /// On a square; a closed torus is cut so that opposite sides match
    Square,
}

/// What holds the vertices.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum WeightsWord {
    /// Equal weights: no face is flipped
    Tutte,
    /// Cotangents: angles change least, and faces may be flipped
    Harmonic,
}

/// What is written.
enum Target {
    Mesh(WriteOptions),
    Picture,
}

impl Target {
    fn content(&self) -> Content {
        match self {
            Target::Mesh(_) => Content::Mesh,
            Target::Picture => Content::Picture,
        }
    }
}

impl Flatten {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let target = self.target()?;
        Files::of_mesh(&self.input).writing("--output", Some(&self.output), target.content()).check()?;
        let progress = console.progress(3);
        progress.step("read");
        let file = read(&self.input)?;
        let target = match target {
            Target::Mesh(options) => Target::Mesh(options.as_read(&file)),
            Target::Picture => target,
        };
        progress.step("flatten");
        let view = View::usual_for(file.format);
        let request = self.request();
        let options =
            UnfoldOptions { flatten: request, loops: LoopOptions { view, ..LoopOptions::default() } };
        let unfolded = unfold(&file.mesh, &options).map_err(|error| failure(&name(&self.input), error))?;
        progress.step("write");
        let mut document = UnfoldDocument::new(&unfolded, &request, view, self.limit);
        document.file = Some(name(&self.input));
        document.output = Some(name(&self.output));
        document.notes = file.notes.clone();
        match target {
            Target::Mesh(options) => {
                let options = options.as_read(&file);
                document.losses = meshmend::write(&self.output, &unfolded.mesh, &options)?;
            }
            Target::Picture => write_picture(&self.output, &unfolded)?,
        }
        drop(progress);
        let text =
            if self.json { json_line(&document)? } else { render::unfolded(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }

    fn target(&self) -> Result<Target, Failure> {
        let is_picture = self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"));
        if is_picture { Ok(Target::Picture) } else { self.words.options(&self.output).map(Target::Mesh) }
    }

    fn request(&self) -> Request {
        Request {
            boundary: match self.boundary {
                BoundaryWord::Circle => Boundary::Circle,
                BoundaryWord::Square => Boundary::Square,
            },
            weights: match self.weights {
                WeightsWord::Tutte => Weights::Uniform,
                WeightsWord::Harmonic => Weights::Cotangent,
            },
        }
    }
}

fn failure(file: &str, error: UnfoldError) -> Failure {
    match error {
        UnfoldError::Cut(error) => loops::failure(file, error),
        UnfoldError::Flatten(_) | UnfoldError::Mesh(_) => {
            Failure { status: Status::Refused, message: format!("{file}: {error}") }
        }
    }
}

fn write_picture(path: &Path, unfolded: &Unfolded) -> Result<(), Failure> {
    let text = svg(&unfolded.mesh, &unfolded.layout);
    let written: std::io::Result<()> = replace_file(path, |out| {
        out.write_all(text.as_bytes())?;
        out.flush()
    });
    written.map_err(|error| Failure::unwritable(&name(path), error))
}
