//! `meshmend kernels`: the ways of storing connectivity, and how they take a mesh.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use meshmend::core::{Complex, Connectivity};
use meshmend::{KernelKind, KernelTask, Refusal, View};

use super::{name, read};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::render;
use crate::words::{self, Welding};

/// List the kernels and what each holds; with a file, what each costs for it, or why it refuses
#[derive(Debug, Args)]
pub(crate) struct Kernels {
    /// The mesh file
    #[arg(value_name = "FILE")]
    file: Option<PathBuf>,
    /// Look at the mesh as welded: none, exact, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding, requires = "file")]
    weld: Option<Welding>,
}

/// How a kernel took a mesh.
pub(crate) struct Trial {
    pub(crate) kernel: KernelKind,
    /// Bytes on the heap and the time to build, or why not.
    pub(crate) result: Result<(usize, Duration), Refusal>,
}

impl Kernels {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let mut text = render::kernels(console.style());
        if let Some(path) = &self.file {
            let file = read(path)?;
            let view = self.weld.map_or(View::usual_for(file.format), Welding::view);
            let mesh = view.of(&file.mesh).map_err(|error| Failure::of_pass(&name(path), &error))?;
            let trials: Vec<Trial> =
                KernelKind::ALL.iter().map(|&kernel| trial(kernel, mesh.complex())).collect();
            text.push('\n');
            text.push_str(&render::trials(&name(path), mesh.complex().proper_face_count(), &trials));
        }
        console.write(&text)?;
        Ok(Status::Done)
    }
}

/// Builds a kernel over a complex of its own, so that none profits from what another one had made.
fn trial(kernel: KernelKind, complex: &Complex) -> Trial {
    let fresh = Complex::of(&complex.shared_faces());
    let start = Instant::now();
    let result = kernel.run(&fresh, HeapBytes).map(|bytes| (bytes, start.elapsed()));
    Trial { kernel, result }
}

struct HeapBytes;

impl KernelTask for HeapBytes {
    type Output = usize;
    fn run<K: Connectivity>(self, kernel: &K) -> usize {
        kernel.heap_bytes()
    }
}
