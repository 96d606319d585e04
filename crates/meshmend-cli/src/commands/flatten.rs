//! `meshmend flatten`: surfaces laid out in the plane.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::flatten::{Boundary, Flatten as Request, Weights, svg};
use meshmend::report::UnfoldDocument;
use meshmend::{UnfoldError, UnfoldOptions, Unfolded, View, unfold};

use super::checked_file::json_line;
use super::loops;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, output_name, reserve, write_mesh, write_text};

/// Lay surfaces out in the unit square, cut open where they are not discs
///
/// An OBJ gets the layout as its texture coordinates, an SVG shows it. Whether a face is flipped or has collapsed is
/// found exactly, and told. STL, which has no indices, is taken as welded exactly.
#[derive(Debug, Args)]
pub(crate) struct Flatten {
    #[arg(help = crate::format_words::input_help(), value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write: a mesh, or a picture named `.svg`; `-` is standard output, for a mesh
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
    from: InputWords,
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

impl Flatten {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let target = self.target()?;
        let content = if target.is_some() { Content::Mesh } else { Content::Picture };
        Files::of_mesh(&self.input).writing("--output", Some(&self.output), content).check()?;
        reserve(&self.output, Report::of(self.json), console)?;
        let progress = console.progress(3);
        progress.step("read");
        let file = self.from.read(&self.input, console)?;
        let target = target.map(|words| words.options_for(&self.output, &file)).transpose()?;
        progress.step("flatten");
        let view = View::usual_for(file.format);
        let request = self.request();
        let options = UnfoldOptions::default().with_view(view).with_flatten(request);
        let unfolded = unfold(&file.mesh, &options).map_err(|error| failure(&name(&self.input), error))?;
        progress.step("write");
        let mut document = UnfoldDocument::new(&unfolded, &request, view, self.limit);
        document.file = Some(name(&self.input));
        document.output = Some(output_name(&self.output));
        document.notes = file.notes;
        match target {
            Some(options) => {
                document.losses = write_mesh(&self.output, &unfolded.mesh, &options, console)?;
            }
            None => write_picture(&self.output, &unfolded, console)?,
        }
        drop(progress);
        let text =
            if self.json { json_line(&document)? } else { render::unfolded(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }

    /// How to write a mesh; `None` for a picture.
    fn target(&self) -> Result<Option<OutputWords>, Failure> {
        let is_picture = self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"));
        if is_picture {
            return Ok(None);
        }
        self.words.check(&self.output).map(|()| Some(self.words))
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

fn write_picture(path: &Path, unfolded: &Unfolded, console: &mut Console<'_>) -> Result<(), Failure> {
    let text = svg(&unfolded.mesh, &unfolded.layout);
    write_text(path, &text, console)
}
