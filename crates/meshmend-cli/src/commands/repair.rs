//! `meshmend repair`: mends a mesh, and names all that it did.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use meshmend::formats::{Placing, Prepared, held_layers, replace_file, rounding_losses};
use meshmend::mesh::{Domain, DraftError, Provenance};
use meshmend::passes::{FaceStorage, Precision, Writing};
use meshmend::report::{ProvenanceDocument, RepairDocument};
use meshmend::{
    Encoding, Format, Pipeline, Plan, PolygonMesh, ReadFile, Repaired, Rules, Session, View, WriteError,
    WriteOptions,
};

use super::check::json_line;
use super::judging::Judging;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::geometry_words::GeometryWords;
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::parts::PartWords;
use crate::policies::Policies;
use crate::render::{self, Style};
use crate::streams::{
    InputWords, Report, as_one_mesh, is_stream, name, output_name, reserve, write_prepared,
};
use crate::words;

/// Mend a mesh: make it manifold, consistently oriented and free of rubbish, and name all that was done
///
/// No face is removed that is not degenerate, non-finite or there twice. The output appears whole or not at all.
#[derive(Debug, Args)]
pub(crate) struct Repair {
    #[arg(help = format_words::input_help(), value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write; it may be the input; `-` is standard output, and the report goes to standard error
    #[arg(short, long, value_name = "OUT", required_unless_present = "dry_run")]
    pub(super) output: Option<PathBuf>,
    /// Write no mesh; report what would be done
    #[arg(long)]
    pub(super) dry_run: bool,
    /// Also write the JSON report to a file
    #[arg(long, value_name = "FILE.json")]
    pub(super) report: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    pub(super) json: bool,
    /// Put into the JSON report where each vertex and face of the result came from
    #[arg(long)]
    pub(super) report_maps: bool,
    /// Print one line, and do not look at the mesh before
    #[arg(short, long, visible_alias = "no-report")]
    pub(super) quiet: bool,
    /// The structure to compute on; the result is the same, unless it can't hold the mesh
    #[arg(long, default_value = "edge-use")]
    kernel: String,
    /// How many items each list of the report shows at most, also in JSON; counts are always whole
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub(super) limit: usize,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    pub(super) parts: PartWords,
    #[command(flatten)]
    pub(super) words: OutputWords,
    #[command(flatten)]
    geometry: GeometryWords,
    #[command(flatten)]
    pub(super) policies: Policies,
}

/// A file to write, and how.
pub(super) struct Target<'a> {
    pub(super) path: &'a Path,
    pub(super) options: WriteOptions,
}

impl Target<'_> {
    /// Whether the file is the one that was read, with what changed in its meshes.
    fn is_spliced(&self) -> bool {
        self.options.format.is_some_and(|format| self.options.shell.is_spliced_into(format))
    }

    /// How precisely the file stores positions.
    fn precision(&self) -> Precision {
        match self.options.resolved() {
            // Positions stay in the type that they have.
            Ok(_) if self.is_spliced() => Precision::Double,
            Ok((Format::Stl, encoding)) if encoding != Encoding::Ascii => Precision::Single,
            Ok((Format::Glb | Format::Gltf, _)) => Precision::Single,
            _ => Precision::Double,
        }
    }

    /// A mesh that is ready to be written there.
    fn prepared(&self, mesh: &PolygonMesh) -> Result<Prepared, Failure> {
        let failed = |kind| WriteError { file: output_name(self.path), kind };
        Ok(Prepared::new(mesh, &self.options).map_err(failed)?)
    }

    /// How the file stores faces. A mesh that can't be prepared is an error only when it is written.
    fn storage(&self) -> FaceStorage {
        if self.is_spliced() {
            return FaceStorage::default().written_by(Writing::by(in_rows));
        }
        let holds_polygons = self.options.format.is_none_or(Format::holds_polygons);
        let storage = match self.options.format {
            Some(Format::Stl) => FaceStorage::apart(),
            _ => FaceStorage::default(),
        };
        let options = self.options.clone();
        storage.written_by(Writing::by(move |mesh| {
            let is_made_ready = !holds_polygons || !mesh.layers().is_empty();
            let prepared = is_made_ready.then(|| Prepared::new(mesh, &options).ok()).flatten();
            prepared.map_or(Ok(None), |prepared| prepared.as_written(mesh))
        }))
    }
}

/// A mesh as a file of parts has it: a vertex once for each row that its corners have. `None` if each has one.
fn in_rows(mesh: &PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, DraftError> {
    let layers = mesh.layers().iter().enumerate();
    let moved =
        layers.filter(|(_, layer)| layer.home() == Domain::Vertex && layer.domain() == Domain::Corner);
    let moved: Vec<usize> = moved.map(|(at, _)| at).collect();
    if moved.is_empty() { Ok(None) } else { mesh.split_for_vertex_layers(&moved).map(Some) }
}

impl Repair {
    pub(crate) fn run(self, rules: Rules, console: &mut Console<'_>) -> Result<Status, Failure> {
        self.check_output()?;
        // What is wrong with the command line is told before anything is read.
        let plan = self.policies.plan()?;
        let kernel = words::kernel(&self.kernel)?;
        let judging = self.judging(rules)?;
        self.check_files()?;
        self.reserve_output(console)?;

        let progress = console.progress(plan.passes.len() + 4);
        progress.step("read");
        let document = self.from.read_document(&self.input, console)?;
        if !document.is_whole() || self.parts.by.is_some() {
            drop(progress);
            return self.repair_parts(document, (plan, kernel, judging), console);
        }
        self.parts.chosen(&document)?;
        let file = as_one_mesh(document, Placing::Parts, &self.input)?;
        let target = self.target(&file)?;
        let pipeline = self.pipeline(plan, &file.mesh, target.as_ref());
        let failed = |error| Failure::of_pass(&name(&self.input), &error);
        progress.step("check");
        let mut session = Session::begin(&file.mesh);
        let mut before = None;
        if !self.quiet {
            session = session.with_figures();
            let view = View::usual_for(file.format);
            let mut judged = judging.before(&mut session, view).map_err(failed)?;
            judged.document = judged.document.of_file(name(&self.input), &file);
            before = Some(judged);
        }
        let session = session.with_kernel(kernel).with_progress(|pass| progress.step(pass.name()));
        let mut repaired = pipeline.run_in(session).map_err(failed)?;
        progress.step("report");
        let mut document = RepairDocument::new(&file.mesh, &repaired, self.limit);
        document.file = Some(name(&self.input));
        document.notes = file.notes;
        document.provenance = self.report_maps.then(|| ProvenanceDocument::new(&repaired.provenance));
        if !self.quiet || self.makes_json() {
            judging.add(before, &mut repaired, &mut document).map_err(failed)?;
        }
        progress.step("write");
        let prepared = target.as_ref().map(|target| target.prepared(&repaired.mesh)).transpose()?;
        self.name_output(target.as_ref(), prepared.as_ref(), &repaired, &mut document);
        self.write(target.as_ref().zip(prepared.as_ref()), &document, console)?;
        drop(progress);
        console.write(&self.text(&document, console.style())?)?;
        Ok(Status::Done)
    }

    /// Fails when the output can't be written as it is asked for, as far as that can be known yet.
    fn check_output(&self) -> Result<(), Failure> {
        self.output.as_deref().map_or(Ok(()), |output| self.words.check(output))
    }

    /// Gives standard output over to the mesh if that goes there.
    fn reserve_output(&self, console: &mut Console<'_>) -> Result<(), Failure> {
        match &self.output {
            Some(output) if !self.dry_run => reserve(output, Report::of(self.json), console),
            _ => Ok(()),
        }
    }

    fn target(&self, file: &ReadFile) -> Result<Option<Target<'_>>, Failure> {
        let Some(path) = self.output.as_deref() else { return Ok(None) };
        Ok(Some(Target { path, options: self.words.options_for(path, file)? }))
    }

    /// The passes of a plan, for what an output can hold.
    pub(super) fn pipeline(&self, plan: Plan, mesh: &PolygonMesh, target: Option<&Target<'_>>) -> Pipeline {
        let format = target.and_then(|target| target.options.format);
        let plan = match format {
            Some(format) if !format.holds_polygons() => self.policies.for_triangles(plan),
            _ => plan,
        };
        let pipeline = plan.pipeline();
        let Some(target) = target else { return pipeline.in_precision(Precision::Double) };
        let held = match target.is_spliced() {
            true => vec![true; mesh.layers().len()],
            false => held_layers(mesh, &target.options),
        };
        pipeline.for_layers(held).in_precision(target.precision()).storing(target.storage())
    }

    fn makes_json(&self) -> bool {
        self.json || self.report.is_some()
    }

    /// Fails when options about the report contradict the others, or a file would take the place of another.
    fn check_files(&self) -> Result<(), Failure> {
        if self.report_maps && !self.makes_json() {
            return Err(Failure::usage("--report-maps needs --json or --report"));
        }
        if self.report.as_deref().is_some_and(is_stream) {
            return Err(Failure::usage(
                "--report writes a file; --json prints the report to standard output",
            ));
        }
        Files::of_mesh(&self.input)
            .reading("--plan", self.policies.plan_file(), Content::Plan)
            .writing("--output", self.output.as_deref(), Content::Mesh)
            .writing("--report", self.report.as_deref(), Content::Report)
            .check()
    }

    /// How the mesh is judged before and after.
    fn judging(&self, rules: Rules) -> Result<Judging, Failure> {
        Ok(Judging { rules, limit: self.limit, geometry: self.geometry.options(&[], usize::MAX)? })
    }

    /// Says in the report what will be written, and what is lost by it.
    fn name_output(
        &self,
        target: Option<&Target<'_>>,
        prepared: Option<&Prepared>,
        repaired: &Repaired,
        document: &mut RepairDocument,
    ) {
        let (Some(Target { path, options }), Some(prepared)) = (target, prepared) else { return };
        let vertices = document.stored.before.vertices;
        document.losses =
            repaired.rounding.map_or(Vec::new(), |rounding| rounding_losses(rounding, vertices));
        document.losses.extend(prepared.losses());
        if self.dry_run {
            return;
        }
        document.output = Some(output_name(path));
        if let Some(after) = &mut document.after {
            (after.file, after.format) = (document.output.clone(), format_words::variant(options));
        }
    }

    /// Writes the mesh and the report, or in a dry run the report alone. The report is written first and takes its
    /// place last: there is no report on a mesh that was not written, and no mesh where the report can't be.
    fn write(
        &self,
        output: Option<(&Target<'_>, &Prepared)>,
        document: &RepairDocument,
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        let Some(report) = &self.report else { return self.write_mesh(output, console) };
        self.write_report(report, &json_line(document)?, || self.write_mesh(output, console))
    }

    /// Writes a report round the writing of what it is about.
    pub(super) fn write_report(
        &self,
        report: &Path,
        text: &str,
        write: impl FnOnce() -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let written = replace_file(report, |out| -> Result<(), Interrupted> {
            out.write_all(text.as_bytes())?;
            out.flush()?;
            write().map_err(Interrupted::Mesh)
        });
        written.map_err(|interrupted| match interrupted {
            Interrupted::Mesh(failure) => failure,
            Interrupted::Report(error) => Failure::unwritable(&name(report), error),
        })
    }

    fn write_mesh(
        &self,
        output: Option<(&Target<'_>, &Prepared)>,
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        match output {
            Some((target, prepared)) if !self.dry_run => write_prepared(target.path, prepared, console),
            _ => Ok(()),
        }
    }

    fn text(&self, document: &RepairDocument, style: Style) -> Result<String, Failure> {
        if self.json {
            json_line(document)
        } else if self.quiet {
            Ok(render::summary(document))
        } else {
            Ok(render::repair(document, style))
        }
    }
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
