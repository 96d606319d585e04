//! `meshmend kernels`: the ways of storing connectivity, and how they take a mesh.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use meshmend::mesh::Complex;
use meshmend::report::{KernelTrial, KernelsDocument};
use meshmend::{AnyKernel, AnyView, Format, Kernels, PolygonMesh};

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render::{self, Trial};
use crate::streams::{InputWords, Report, name, reserve, write_text};
use crate::words::{self, Welding};

/// List the kernels and what each holds; with a file, what each costs for it, or why it refuses
#[derive(Debug, Args)]
pub(crate) struct KernelsCommand {
    /// The mesh file; `-` is standard input
    #[arg(value_name = "FILE")]
    pub(super) file: Option<PathBuf>,
    /// The format of the input, whatever its name and content
    #[arg(long, value_name = "FORMAT", value_parser = format_words::format, requires = "file")]
    from: Option<Format>,
    /// Look at the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding, requires = "file")]
    weld: Option<Welding>,
    /// Time each kernel: built, and asked the usual questions
    #[arg(long, requires = "file")]
    bench: bool,
    /// How often each kernel is timed; the best times are reported
    #[arg(long, value_name = "N", default_value = "3", requires = "bench")]
    runs: NonZeroUsize,
    /// Print the times as JSON
    #[arg(long, requires = "bench")]
    json: bool,
    /// Also draw the bytes a face of each structure, by array; `-` is standard output
    #[arg(long, value_name = "OUT.svg", requires = "bench")]
    svg: Option<PathBuf>,
}

impl KernelsCommand {
    pub(crate) fn run(self, kernels: Kernels, console: &mut Console<'_>) -> Result<Status, Failure> {
        let Some(path) = &self.file else {
            console.write(&render::kernels(kernels, console.style()))?;
            return Ok(Status::Done);
        };
        Files::of_mesh(path).writing("--svg", self.svg.as_deref(), Content::Picture).check()?;
        if let Some(picture) = &self.svg {
            reserve(picture, Report::of(self.json), console)?;
        }
        let file = InputWords::of(self.from).read(path, console)?;
        let mesh = words::viewed(self.weld, &file, path)?;
        drop(file);
        let text = if self.bench {
            self.bench(kernels, path, &mesh, console)?
        } else {
            tried(kernels, path, &mesh, console)
        };
        console.write(&text)?;
        Ok(Status::Done)
    }

    /// What each kernel and each view costs by the clock.
    fn bench(
        &self,
        kernels: Kernels,
        path: &Path,
        mesh: &PolygonMesh,
        console: &mut Console<'_>,
    ) -> Result<String, Failure> {
        let (start, faces) = (Instant::now(), mesh.complex().proper_face_count());
        let trial = |kernel: AnyKernel| {
            let cost = kernel.cost(mesh, self.runs.get(), &|| start.elapsed());
            KernelTrial::new(kernel.name, faces, &cost)
        };
        let kernels = kernels.all().map(trial).collect();
        let view = |view: AnyView| {
            let cost = view.cost(mesh, self.runs.get(), &|| start.elapsed());
            KernelTrial::of_view(&view, faces, &cost)
        };
        let views = AnyView::ALL.into_iter().map(view).collect();
        let mut document = KernelsDocument::new(faces, self.runs.get(), kernels, views);
        document.file = Some(name(path));
        if let Some(path) = &self.svg {
            let bars = render::byte_bars(&document);
            write_text(path, &bars, console)?;
        }
        if self.json { json_line(&document) } else { Ok(render::kernel_times(&document)) }
    }
}

/// The list of kernels, and how each takes a mesh.
fn tried(kernels: Kernels, path: &Path, mesh: &PolygonMesh, console: &Console<'_>) -> String {
    let trials: Vec<Trial> = kernels.all().map(|kernel| trial(kernel, mesh.complex())).collect();
    let list = render::kernels(kernels, console.style());
    format!("{list}\n{}", render::trials(&name(path), mesh.complex().proper_face_count(), &trials))
}

/// Builds a kernel over a complex of its own, so that no kernel profits from what another one has built.
fn trial(kernel: AnyKernel, complex: &Complex) -> Trial {
    let fresh = Complex::of(&complex.shared_faces());
    let start = Instant::now();
    let result = kernel.heap_bytes(&fresh).map(|bytes| (bytes, start.elapsed()));
    Trial { kernel, result }
}
