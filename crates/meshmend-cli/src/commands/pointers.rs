//! `meshmend pointers`: the record that stands for an element, field by field.

use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::mesh::{Cell, Connectivity, EdgeUse, Pointer};
use meshmend::{AnyKernel, Kernels, PolygonMesh};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render;
#[cfg(feature = "render")]
use crate::streams::write_text;
use crate::streams::{InputWords, Report, name, reserve};
use crate::words::{self, Welding};

/// Show the record that stands for an element in a structure: each field with what it leads to
#[derive(Debug, Args)]
pub(crate) struct Pointers {
    #[arg(help = format_words::input_help(), value_name = "FILE")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    from: InputWords,
    /// Take the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// The structure
    #[arg(long, default_value = "edge-use")]
    kernel: String,
    /// The element: v, e, f or c and its number
    #[arg(long, value_name = "CELL", required_unless_present_any = ["all", "permutations"])]
    at: Option<Cell>,
    /// The records of all elements
    #[arg(long, conflicts_with = "at")]
    all: bool,
    /// The mesh as three permutations of its half-edges, in cycles: round each vertex, along each edge, round each face
    #[arg(long, conflicts_with_all = ["at", "all"])]
    permutations: bool,
    /// Also draw the record on the mesh, each pointer an arrow; `-` is standard output
    #[cfg(feature = "render")]
    #[arg(short, long, value_name = "OUT.svg", requires = "at", conflicts_with_all = ["all", "permutations"])]
    output: Option<PathBuf>,
}

impl Pointers {
    pub(crate) fn run(self, kernels: Kernels, console: &mut Console<'_>) -> Result<Status, Failure> {
        let kernel = words::any_kernel(kernels, &self.kernel)?;
        let picture = self.picture();
        Files::of_mesh(&self.file).writing("--output", picture, Content::Picture).check()?;
        if let Some(path) = picture {
            reserve(path, Report::of(false), console)?;
        }
        let file = self.from.read(&self.file, console)?;
        let mesh = words::viewed(self.weld, &file, &self.file)?;
        if self.permutations {
            let permutations = meshmend::topology::permutations(mesh.complex());
            let permutations = permutations.map_err(|refusal| self.refused(&refusal.to_string()))?;
            console.write(&render::permutations(&permutations))?;
            return Ok(Status::Done);
        }
        let cells = self.cells(&mesh)?;
        let records = kernel.pointers(mesh.complex(), &cells);
        let records = records.map_err(|refusal| self.refused(&refusal.to_string()))?;
        if let (Some(path), [cell], [record]) = (picture, &cells[..], &records[..]) {
            self.draw(path, kernel, &mesh, (*cell, record), console)?;
        }
        console.write(&render::records(kernel, &cells, &records, console.style()))?;
        Ok(Status::Done)
    }

    #[cfg(feature = "render")]
    fn picture(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    #[cfg(not(feature = "render"))]
    fn picture(&self) -> Option<&Path> {
        None
    }

    /// The elements whose records are wanted, all of which the mesh has.
    fn cells(&self, mesh: &PolygonMesh) -> Result<Vec<Cell>, Failure> {
        let kernel = EdgeUse::assemble(mesh.complex());
        match self.at {
            None => {
                let vertices = kernel.vertices().map(Cell::Vertex);
                let (edges, faces) = (kernel.edges().map(Cell::Edge), kernel.faces().map(Cell::Face));
                Ok(vertices.chain(edges).chain(faces).chain(kernel.corners().map(Cell::Corner)).collect())
            }
            Some(at) if at.is_in(&kernel) => Ok(vec![at]),
            Some(at) => {
                let counts = render::element_counts(&kernel);
                Err(Failure::usage(format!("{} has no {at}: it has {counts}", name(&self.file))))
            }
        }
    }

    fn refused(&self, refusal: &str) -> Failure {
        Failure { status: Status::Refused, message: format!("{}: {refusal}", name(&self.file)) }
    }

    #[cfg(feature = "render")]
    fn draw(
        &self,
        path: &Path,
        kernel: AnyKernel,
        mesh: &PolygonMesh,
        (at, record): (Cell, &[Pointer]),
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        let title = format!("{at} in the {kernel} structure: {}", name(&self.file));
        let picture = meshmend_render::pointer_picture(mesh, at, record, &title);
        let picture = picture.map_err(|error| Failure::usage(format!("{}: {error}", name(&self.file))))?;
        write_text(path, &picture, console)
    }

    #[cfg(not(feature = "render"))]
    fn draw(
        &self,
        _: &Path,
        _: AnyKernel,
        _: &PolygonMesh,
        _: (Cell, &[Pointer]),
        _: &mut Console<'_>,
    ) -> Result<(), Failure> {
        Ok(())
    }
}
