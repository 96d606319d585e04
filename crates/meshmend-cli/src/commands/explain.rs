//! `meshmend explain`: the words of reports, in sentences; and what of it there is in a mesh.

use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::mesh::admission;
use meshmend::words::Word;
use meshmend::{
    AnyKernel, AnyView, CheckOptions, CheckReport, DefectKind, Format, GeometryOptions, Kernels, PassKind,
    PolygonMesh, Question, check,
};

use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::render::{self, KernelOn, Style};
use crate::streams::{InputWords, name};
use crate::words::{self, Welding};

/// Explain a kind of defect, a pass, a kernel, a law of kernels or a word of topology; without a name, list them all
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// The name, as it stands in reports; a law of kernels as `law:next-and-prev`
    #[arg(value_name = "NAME")]
    name: Option<String>,
    /// A mesh: whether a kernel holds it and of which arrays it then consists, or where a kind of defect or what of a word is
    /// there
    #[arg(value_name = "FILE")]
    pub(super) file: Option<PathBuf>,
    /// The format of the input, whatever its name and content
    #[arg(long, value_name = "FORMAT", value_parser = format_words::format, requires = "file")]
    from: Option<Format>,
    /// Look at the mesh as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding, requires = "file")]
    weld: Option<Welding>,
}

/// What is explained.
enum Entry {
    Kernel(AnyKernel),
    Defect(DefectKind),
    Word(Word),
    /// What no mesh has anything of: the whole page.
    Page(String),
}

impl Entry {
    fn named(program: &Program, name: &str, style: Style) -> Option<Self> {
        let page = |heading: &str, text: &str| Entry::Page(render::explanation(heading, text, style));
        let kernel = program.kernels.named(name).map(Entry::Kernel);
        let defect = || program.rules.kind(name).map(Entry::Defect);
        let word = || Word::from_name(name).map(Entry::Word);
        let pass = |kind: PassKind| {
            let text = render::explanation(&format!("{kind}: a pass"), kind.explanation(), style);
            Entry::Page(render::pictured(text, kind.name()))
        };
        let pass = || program.passes.kind(name).map(pass);
        let view = || {
            let heading = |view: &AnyView| format!("{name}: a view, {}", view.rung.name());
            AnyView::named(name).map(|view| page(&heading(&view), view.explanation))
        };
        let law = || law(name, style).map(Entry::Page);
        kernel.or_else(defect).or_else(word).or_else(pass).or_else(view).or_else(law)
    }
}

impl Explain {
    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let style = console.style();
        let Some(word) = self.name.as_deref() else {
            let glossary = render::glossary(program.rules, program.passes, program.kernels, laws(), style);
            console.write(&glossary)?;
            return Ok(Status::Done);
        };
        let entry = Entry::named(program, word, style).ok_or_else(|| Failure::usage(unknown(word)))?;
        let text = match &self.file {
            None => page(&entry, style),
            Some(file) => self.page_on(file, word, &entry, program, console)?,
        };
        console.write(&text)?;
        Ok(Status::Done)
    }

    /// The page of an entry, and what of it there is in a mesh.
    fn page_on(
        &self,
        file: &Path,
        word: &str,
        entry: &Entry,
        program: &Program,
        console: &mut Console<'_>,
    ) -> Result<String, Failure> {
        let style = console.style();
        let on = match entry {
            Entry::Page(_) => {
                return Err(Failure::usage(format!(
                    "`{word}` is explained without a file: no mesh has anything of it"
                )));
            }
            Entry::Kernel(kernel) => {
                let mesh = self.mesh(file, console)?;
                return Ok(render::kernel(
                    *kernel,
                    Some(&taken(*kernel, program.kernels, name(file), &mesh)),
                    style,
                ));
            }
            Entry::Defect(kind) => {
                let report = self.checked(file, Question::about(*kind), program, console)?;
                render::defects_on(&name(file), *kind, &report, style)
            }
            Entry::Word(word) => {
                let report = self.checked(file, None, program, console)?;
                render::word_on(&name(file), word.name, &report.topology, style)
            }
        };
        Ok(page(entry, style) + &on)
    }

    /// What a check finds, with a question about where the faces lie if that is needed.
    fn checked(
        &self,
        path: &Path,
        question: Option<Question>,
        program: &Program,
        console: &mut Console<'_>,
    ) -> Result<CheckReport, Failure> {
        let geometry = |question| GeometryOptions::default().asking(std::iter::once(question).collect());
        let options = CheckOptions::default().with_rules(program.rules);
        let options = options.with_geometry(question.map(geometry));
        check(&self.mesh(path, console)?, &options).map_err(|error| Failure::of_pass(&name(path), &error))
    }

    fn mesh(&self, path: &Path, console: &mut Console<'_>) -> Result<PolygonMesh, Failure> {
        let file = InputWords::of(self.from).read(path, console)?;
        words::viewed(self.weld, &file, path)
    }
}

/// The page of an entry.
fn page(entry: &Entry, style: Style) -> String {
    match entry {
        Entry::Kernel(kernel) => render::kernel(*kernel, None, style),
        Entry::Defect(kind) => {
            let page = render::explanation(&render::defect_heading(*kind), kind.explanation(), style);
            render::pictured(page, kind.code())
        }
        Entry::Word(word) => render::lesson(word.text, style),
        Entry::Page(page) => page.clone(),
    }
}

/// How a kernel takes a mesh, and which others hold it.
fn taken(kernel: AnyKernel, kernels: Kernels, file: String, mesh: &PolygonMesh) -> KernelOn {
    let holds = |other: &AnyKernel| admission(mesh.complex(), &other.capabilities).is_empty();
    KernelOn {
        file,
        faces: mesh.complex().proper_face_count(),
        arrays: kernel.arrays(mesh.complex()),
        holders: kernels.all().filter(holds).map(|other| other.name).collect(),
    }
}

fn unknown(name: &str) -> String {
    if cfg!(not(feature = "laws")) && name.starts_with("law:") {
        return "this program was built without the laws of kernels; \
                `cargo install --locked --path crates/meshmend-cli` builds it with everything"
            .to_owned();
    }
    format!("there is no kind of defect, pass, kernel, law or word `{name}`; `meshmend explain` lists them")
}

/// The page of a law of kernels.
#[cfg(feature = "laws")]
fn law(name: &str, style: Style) -> Option<String> {
    let law = meshmend_conformance::law(name.strip_prefix("law:")?)?;
    let often = law.often.map(|often| format!("\n*Often*: {often}.\n")).unwrap_or_default();
    let text = format!(
        "# {name}\n\nA law of kernels: {}.\n\n*Why*: {}.\n{often}\n*Try*: one line of test, \
         `meshmend_conformance::kernel!(mine: MyKernel);`, and then\n\n```sh\ncargo test {}\n```\n",
        law.sentence,
        law.why,
        law.id.replace('-', "_")
    );
    Some(render::lesson(&text, style))
}

/// The names of all laws of kernels.
#[cfg(feature = "laws")]
fn laws() -> Vec<String> {
    meshmend_conformance::LAWS.iter().map(|law| format!("law:{}", law.id)).collect()
}

#[cfg(not(feature = "laws"))]
fn laws() -> Vec<String> {
    Vec::new()
}

#[cfg(not(feature = "laws"))]
fn law(_: &str, _: Style) -> Option<String> {
    None
}
