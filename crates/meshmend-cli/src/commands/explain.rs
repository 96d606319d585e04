//! `meshmend explain`: the words of reports, in sentences; and the structures, also on a mesh.

use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::words::Word;
use meshmend::{AnyKernel, Format, Kernels, View};

use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::render::{self, KernelOn, Style};
use crate::streams::{InputWords, name};
use crate::words::{self, Welding};

/// Explain a kind of defect, a pass, a kernel or a word of topology; without a name, list them all
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// The name, as it stands in reports
    #[arg(value_name = "NAME")]
    name: Option<String>,
    /// A mesh to explain a kernel on: whether the kernel holds it, and of which arrays it then consists
    #[arg(value_name = "FILE")]
    pub(super) file: Option<PathBuf>,
    /// The format of the input, whatever its name and content
    #[arg(long, value_name = "FORMAT", value_parser = format_words::format, requires = "file")]
    from: Option<Format>,
    /// Look at the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding, requires = "file")]
    weld: Option<Welding>,
}

impl Explain {
    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let Program { rules, passes, kernels } = *program;
        let style = console.style();
        let text = match self.name.as_deref() {
            None => render::glossary(rules, passes, kernels, style),
            Some(name) => match (kernels.named(name), &self.file) {
                (Some(kernel), file) => {
                    let on = match file {
                        Some(file) => Some(self.on(kernel, kernels, file, console)?),
                        None => None,
                    };
                    render::kernel(kernel, on.as_ref(), style)
                }
                (None, None) => entry(program, name, style).ok_or_else(|| Failure::usage(unknown(name)))?,
                (None, Some(_)) if entry(program, name, style).is_some() => {
                    return Err(Failure::usage(format!(
                        "`{name}` is explained without a file; kernels alone take one"
                    )));
                }
                (None, Some(_)) => return Err(Failure::usage(unknown(name))),
            },
        };
        console.write(&text)?;
        Ok(Status::Done)
    }

    /// How a kernel takes a mesh, and which others hold it.
    fn on(
        &self,
        kernel: AnyKernel,
        kernels: Kernels,
        path: &Path,
        console: &mut Console<'_>,
    ) -> Result<KernelOn, Failure> {
        let file = InputWords::of(self.from).read(path, console)?;
        let view = self.weld.map_or(View::usual_for(file.format), Welding::view);
        let mesh = view.of(&file.mesh).map_err(|error| Failure::of_pass(&name(path), &error))?;
        let holds = |other: &AnyKernel| other.heap_bytes(mesh.complex()).is_ok();
        Ok(KernelOn {
            file: name(path),
            faces: mesh.complex().proper_face_count(),
            arrays: kernel.arrays(mesh.complex()),
            holders: kernels.all().filter(holds).map(|other| other.name).collect(),
        })
    }
}

fn unknown(name: &str) -> String {
    format!("there is no kind of defect, pass, kernel or word `{name}`; `meshmend explain` lists them")
}

/// The page of what is not a kernel.
fn entry(program: &Program, name: &str, style: Style) -> Option<String> {
    let page = |heading: &str, text| render::explanation(heading, text, style);
    let defect = program.rules.kind(name).map(|kind| page(&render::defect_heading(kind), kind.explanation()));
    let pass = || program.passes.kind(name).map(|pass| page(&format!("{pass}: a pass"), pass.explanation()));
    let word = || Word::from_name(name).map(|word| render::lesson(word.text, style));
    defect.or_else(pass).or_else(word)
}
