//! `meshmend repair`: mends a mesh, and names all that it did.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::files::{FileRepair, FileTarget, Judged, RepairedFile};
use meshmend::formats::{Document, ElementLines, replace_file};
use meshmend::maps::MapsFile;
use meshmend::report::{RepairDocument, Sarif};
use meshmend::{Plan, Rules};

use super::checked_file::json_line;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::gate_words;
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::parts::PartWords;
use crate::render::{self, Style};
use crate::repair_words::RepairWords;
use crate::streams::{InputWords, Report, is_stream, name, output_name, reserve, write_repaired};

/// Mend a mesh: make it manifold, consistently oriented and free of rubbish, and name all that was done
///
/// No face is removed that is not degenerate, non-finite or there twice. The output appears whole or not at all.
#[derive(Debug, Args)]
pub(crate) struct Repair {
    #[arg(help = format_words::input_help(), value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write; it may be the input; `-` is standard output, and the report goes to standard error
    #[arg(short, long, value_name = "OUT", required_unless_present = "dry_run")]
    output: Option<PathBuf>,
    /// Write no mesh; report what would be done
    #[arg(long)]
    dry_run: bool,
    /// Also write the JSON report to a file
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
    /// Also write to a file where each vertex, face and corner came from, what became of each, and why: arrays for numpy, or JSON
    #[arg(long, value_name = "FILE.npz|FILE.json")]
    maps: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// Print what is left as a SARIF document, with a result for each item that is listed
    #[arg(long, conflicts_with = "json")]
    sarif: bool,
    /// Print one line, and do not look at the mesh before
    #[arg(short, long, visible_alias = "no-report")]
    quiet: bool,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    parts: PartWords,
    #[command(flatten)]
    to: OutputWords,
    #[command(flatten)]
    pub(super) words: RepairWords,
}

impl Repair {
    pub(crate) fn run(self, rules: Rules, console: &mut Console<'_>) -> Result<Status, Failure> {
        self.check_output()?;
        let repair = self.repair(rules)?;
        self.check_files()?;
        self.reserve_output(console)?;

        let progress = console.progress(repair.plan.passes.len() + 4);
        progress.step("read");
        let document = self.from.read_to_weld(&self.input, console)?;
        let target = self.target(&document, &repair.plan)?;
        let mut repaired = repair.run(&name(&self.input), document, target.as_ref(), &progress.watch())?;
        let is_withheld = self.words.gate.withholds(repaired.failing());
        if is_withheld {
            repaired.withhold();
        }
        self.write(&repaired, is_withheld, console)?;
        drop(progress);
        console.write(&self.text(&repaired, repair.rules, console.style())?)?;
        let is_written = !is_withheld && !self.dry_run;
        Ok(gate_words::judged(&name(&self.input), repaired.failing(), is_written, console))
    }

    /// How the file is repaired. What is wrong with the command line is told before anything is read.
    fn repair(&self, rules: Rules) -> Result<FileRepair, Failure> {
        let mut repair = self.words.repair(rules)?;
        repair.parts = self.parts.choice();
        let is_judged = self.makes_json() || self.sarif || repair.gate.asks_of_result();
        repair.judged = match (self.quiet, is_judged) {
            (false, _) => Judged::BeforeAndAfter,
            (true, true) => Judged::After,
            (true, false) => Judged::Neither,
        };
        Ok(repair)
    }

    /// Fails when the output can't be written as it is asked for, as far as that can be known yet.
    fn check_output(&self) -> Result<(), Failure> {
        self.output.as_deref().map_or(Ok(()), |output| self.to.check(output))
    }

    /// Gives standard output over to the mesh if that goes there.
    fn reserve_output(&self, console: &mut Console<'_>) -> Result<(), Failure> {
        match &self.output {
            Some(output) if !self.dry_run => reserve(output, Report::of(self.json), console),
            _ => Ok(()),
        }
    }

    /// The output, if there is one.
    fn target(&self, document: &Document, plan: &Plan) -> Result<Option<FileTarget>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        let options = self.to.planned(plan).options_of(path, document.format, &document.shell)?;
        let target = FileTarget::new(output_name(path), options);
        Ok(Some(if self.dry_run { target.rehearsed() } else { target }))
    }

    fn makes_json(&self) -> bool {
        self.json || self.report.is_some()
    }

    /// Fails when options about the report contradict the others, or a file would take the place of another.
    fn check_files(&self) -> Result<(), Failure> {
        if self.words.report_maps && !self.makes_json() {
            return Err(Failure::usage("--report-maps needs --json or --report"));
        }
        if let Some(maps) = &self.maps {
            maps_form(maps)?;
        }
        if self.report.as_deref().is_some_and(is_stream) {
            return Err(Failure::usage(
                "--report writes a file; --json prints the report to standard output",
            ));
        }
        Files::of_mesh(&self.input)
            .reading("--plan", self.words.policies.plan_file(), Content::Plan)
            .writing("--output", self.output.as_deref(), Content::Mesh)
            .writing("--report", self.report.as_deref(), Content::Report)
            .writing("--maps", self.maps.as_deref(), Content::Report)
            .check()
    }

    /// Writes the mesh, the report and the maps, or in a dry run these alone. What is said about a mesh is written first and takes
    /// its place last: there is no report on a mesh that was not written, and no mesh where the report can't be.
    fn write(
        &self,
        repaired: &RepairedFile,
        is_withheld: bool,
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        let text = self.report.is_some().then(|| report_line(repaired)).transpose()?;
        let mut write_mesh = || if is_withheld { Ok(()) } else { self.write_mesh(repaired, console) };
        let mut write_maps = || match &self.maps {
            Some(path) => {
                let (maps, form) = (MapsFile::of(repaired), maps_form(path)?);
                write_round(path, |out| form.write(&maps, out), &mut write_mesh)
            }
            None => write_mesh(),
        };
        match self.report.as_ref().zip(text) {
            Some((path, text)) => write_round(path, |out| out.write_all(text.as_bytes()), write_maps),
            None => write_maps(),
        }
    }

    fn write_mesh(&self, repaired: &RepairedFile, console: &mut Console<'_>) -> Result<(), Failure> {
        match (&self.output, repaired.prepared()) {
            (Some(path), Some(prepared)) if !self.dry_run => write_repaired(path, prepared, console),
            _ => Ok(()),
        }
    }

    /// What is left, at its place in the output.
    fn sarif(&self, repaired: &RepairedFile) -> Sarif {
        let file = self.output.as_deref().map_or_else(|| name(&self.input), output_name);
        let (mut sarif, unknown) = (Sarif::default(), ElementLines::default());
        let mut add = |part: Option<String>, report: &RepairDocument| {
            report.after.iter().for_each(|after| sarif.add(&file, part.as_deref(), after, &unknown));
        };
        match repaired {
            RepairedFile::Mesh(mesh) => add(None, &mesh.report),
            RepairedFile::Parts(parts) => parts.parts.iter().for_each(|(number, outcome)| {
                let title = parts.document.parts[*number].title();
                outcome.report().into_iter().for_each(|report| add(Some(title.clone()), report));
            }),
        }
        sarif
    }

    fn text(&self, repaired: &RepairedFile, rules: Rules, style: Style) -> Result<String, Failure> {
        if self.sarif {
            return json_line(&self.sarif(repaired).document(rules));
        }
        if self.json {
            return report_line(repaired);
        }
        Ok(match repaired {
            RepairedFile::Mesh(mesh) if self.quiet => render::summary(&mesh.report),
            RepairedFile::Mesh(mesh) => render::repair(&mesh.report, style),
            RepairedFile::Parts(parts) => render::repaired_parts(parts, style),
        })
    }
}

/// The report as one line.
fn report_line(repaired: &RepairedFile) -> Result<String, Failure> {
    let text = repaired.report_json().map_err(|error| Failure::unwritable("report", error))?;
    Ok(text + "\n")
}

/// How maps are written.
#[derive(Clone, Copy)]
enum MapsForm {
    Npz,
    Json,
}

impl MapsForm {
    fn write(self, maps: &MapsFile, out: &mut dyn Write) -> io::Result<()> {
        match self {
            MapsForm::Npz => maps.npz(out),
            MapsForm::Json => maps.json(out),
        }
    }
}

/// How maps are written to a file of this name.
fn maps_form(path: &Path) -> Result<MapsForm, Failure> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        _ if is_stream(path) => Err(Failure::usage("--maps writes a file")),
        Some("npz") => Ok(MapsForm::Npz),
        Some("json") => Ok(MapsForm::Json),
        _ => Err(Failure::usage(format!("--maps {}: the name has to end in .npz or .json", path.display()))),
    }
}

/// Writes a file round the writing of what it is about.
fn write_round(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    write: impl FnOnce() -> Result<(), Failure>,
) -> Result<(), Failure> {
    let written = replace_file(path, |out| -> Result<(), Interrupted> {
        content(out)?;
        out.flush()?;
        write().map_err(Interrupted::Mesh)
    });
    written.map_err(|interrupted| match interrupted {
        Interrupted::Mesh(failure) => failure,
        Interrupted::Report(error) => Failure::unwritable(&name(path), error),
    })
}

/// What went wrong while a report was written.
enum Interrupted {
    Mesh(Failure),
    Report(io::Error),
}

impl From<io::Error> for Interrupted {
    fn from(error: io::Error) -> Self {
        Interrupted::Report(error)
    }
}
