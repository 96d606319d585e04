//! `meshmend matrix`: the boundary matrices and the adjacency matrix of a mesh, and what they say.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::matrices::{Field, MatrixMarket, Operator};
use meshmend::mesh::Cell;
use meshmend::report::MatrixDocument;
use meshmend::{Format, MatrixAnswers, MatrixError, MatrixQuestions, Neighbourhood, VertexId};

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, reserve, write_with};
use crate::words::{self, Welding};

/// Show the boundary matrices and the adjacency matrix of a mesh, and what follows from them
///
/// ∂₁ has a row for each vertex and a column for each edge, ∂₂ a row for each edge and a column for each face; their
/// ranks give the Betti numbers. The adjacency matrix A knows which vertices are joined, and nothing of faces. Several
/// questions may be asked at once. Cells are named as in reports: v3, e7, f0.
#[derive(Debug, Args)]
pub(crate) struct Matrix {
    #[arg(help = format_words::input_help(), value_name = "FILE")]
    pub(super) file: PathBuf,
    /// The format of the input, whatever its name and content
    #[arg(long = "format", value_name = "FORMAT", value_parser = format_words::format)]
    input_format: Option<Format>,
    /// Take the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// Count the walks of this length from a vertex to each other one: a row of Aᴺ
    #[arg(long, value_name = "N", requires = "from")]
    walks: Option<u32>,
    /// The vertex where the walks begin, such as v0
    #[arg(long, value_name = "V", value_parser = words::vertex, requires = "walks")]
    from: Option<VertexId>,
    /// Find so many eigenvalues, at most 32: the largest ones of A, or the smallest ones of the Laplacian
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u8).range(1..=32))]
    spectrum: Option<u8>,
    /// Find the ranks of ∂₁ and ∂₂ over fields: primes, and Q for the rationals
    #[arg(long, value_name = "FIELDS", value_delimiter = ',', value_parser = words::field)]
    rank: Vec<Field>,
    #[command(flatten)]
    round: NeighbourhoodWords,
    /// The matrix that --spectrum and --matrix-market are about; by default the adjacency matrix
    #[arg(long, value_name = "MATRIX")]
    of: Option<MatrixWord>,
    /// Write the matrix as a file of the Matrix Market, for numerical programs; `-` is standard output
    #[arg(long, value_name = "OUT.mtx")]
    matrix_market: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// How many items of a list are shown at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 20)]
    limit: usize,
}

/// Round which cells to look.
#[derive(Debug, Args)]
struct NeighbourhoodWords {
    /// List the star of cells: all that contains one of them
    #[arg(long, value_name = "CELLS", value_delimiter = ',', value_parser = words::cell)]
    star: Vec<Cell>,
    /// List the closure of cells: all that they contain
    #[arg(long, value_name = "CELLS", value_delimiter = ',', value_parser = words::cell)]
    closure: Vec<Cell>,
    /// List the link of cells: the closure of the star without the star of the closure
    #[arg(long, value_name = "CELLS", value_delimiter = ',', value_parser = words::cell)]
    link: Vec<Cell>,
    /// List the boundary of the closure of faces or edges
    #[arg(long, value_name = "CELLS", value_delimiter = ',', value_parser = words::cell)]
    boundary: Vec<Cell>,
}

/// A matrix by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MatrixWord {
    /// The adjacency matrix A
    Adjacency,
    /// The Laplacian L = D − A, with the degrees D
    Laplacian,
    /// ∂₁, from edges to vertices
    D1,
    /// ∂₂, from faces to edges
    D2,
}

impl Matrix {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let questions = self.questions()?;
        let market = self.matrix_market.as_deref();
        Files::of_mesh(&self.file).writing("--matrix-market", market, Content::Report).check()?;
        if let Some(path) = market {
            reserve(path, Report::of(self.json), console)?;
        }
        let progress = console.progress(2);
        progress.step(&format!("read {}", name(&self.file)));
        let file = InputWords::of(self.input_format).read_told_by("--format", &self.file, console)?;
        progress.step("matrices");
        let mesh = words::viewed(self.weld, &file, &self.file)?;
        let answers = questions.ask(mesh.complex()).map_err(|error| self.failure(&error))?;
        if let Some(path) = market {
            self.write(path, &answers, console)?;
        }
        let document =
            MatrixDocument::new(&mesh, words::view(self.weld, &file), &questions, &answers, self.limit);
        let document = document.of_file(name(&self.file), &file);
        drop(progress);
        let text = if self.json { json_line(&document)? } else { render::matrix(&document, console.style()) };
        console.write(&text)?;
        Ok(Status::Done)
    }

    fn questions(&self) -> Result<MatrixQuestions, Failure> {
        let mut questions = MatrixQuestions::default().with_fields(self.rank.clone());
        if let (Some(length), Some(from)) = (self.walks, self.from) {
            questions = questions.with_walks(length, from);
        }
        if self.of.is_some() && self.spectrum.is_none() && self.matrix_market.is_none() {
            return Err(Failure::usage(
                "--of says what --spectrum or --matrix-market is about, and neither is given",
            ));
        }
        if let Some(count) = self.spectrum {
            questions = questions.with_spectrum(self.operator()?, count.into());
        }
        let round = &self.round;
        for (which, cells) in [
            (Neighbourhood::Star, &round.star),
            (Neighbourhood::Closure, &round.closure),
            (Neighbourhood::Link, &round.link),
            (Neighbourhood::Boundary, &round.boundary),
        ] {
            if !cells.is_empty() {
                questions = questions.with_neighbourhood(which, cells.clone());
            }
        }
        Ok(questions)
    }

    /// The square matrix of which eigenvalues are found.
    fn operator(&self) -> Result<Operator, Failure> {
        match self.of {
            None | Some(MatrixWord::Adjacency) => Ok(Operator::Adjacency),
            Some(MatrixWord::Laplacian) => Ok(Operator::Laplacian),
            Some(MatrixWord::D1 | MatrixWord::D2) => Err(Failure::usage(
                "--spectrum finds eigenvalues of square matrices: --of adjacency or --of laplacian",
            )),
        }
    }

    fn write(&self, path: &Path, answers: &MatrixAnswers, console: &mut Console<'_>) -> Result<(), Failure> {
        let matrix = match self.of {
            None | Some(MatrixWord::Adjacency) => MatrixMarket::OfGraph(&answers.graph, Operator::Adjacency),
            Some(MatrixWord::Laplacian) => MatrixMarket::OfGraph(&answers.graph, Operator::Laplacian),
            Some(MatrixWord::D1) => MatrixMarket::Boundary1(&answers.incidence),
            Some(MatrixWord::D2) => MatrixMarket::Boundary2(&answers.incidence),
        };
        write_with(path, console, |out| {
            matrix.write(out)?;
            out.flush()
        })
    }

    /// The failure that says why the mesh of the file has no answer.
    fn failure(&self, error: &MatrixError) -> Failure {
        let status = match error {
            MatrixError::NoSuchCell { .. } | MatrixError::Degenerate { .. } | MatrixError::NoBoundary => {
                Status::Usage
            }
            _ => Status::Refused,
        };
        Failure { status, message: format!("{}: {error}", name(&self.file)) }
    }
}
