//! What commands read and write: files, and for `-` the standard streams.
//!
//! A standard output that carries a mesh or a picture carries nothing else: reports then go to the stream for errors.

use std::io::Write;
use std::path::Path;

use meshmend::files::PreparedFile;
use meshmend::formats::{
    Document, Placing, Prepared, PreparedDocument, ReadErrorKind, WriteError, read_document,
    read_document_stream, replace_file,
};
use meshmend::{Format, Loss, PolygonMesh, ReadFile, ReadOptions, WriteOptions};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;

/// What stands for a standard stream on the command line.
pub(crate) const STREAM: &str = "-";
/// What standard input is called in reports and messages.
const INPUT: &str = "standard input";
/// What standard output is called in reports and messages.
const OUTPUT: &str = "standard output";

/// In which format a file is read; by default in that of its content and name.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct InputWords {
    /// The format of the input, whatever its name and content
    #[arg(long = "from", value_name = "FORMAT", value_parser = format_words::format)]
    from: Option<Format>,
}

impl InputWords {
    pub(crate) fn of(from: Option<Format>) -> Self {
        InputWords { from }
    }

    /// How a file is read so.
    pub(crate) fn options(self) -> ReadOptions {
        ReadOptions::default().with_format(self.from)
    }

    /// Reads a file, or standard input, with the default limits, as one mesh.
    pub(crate) fn read(self, path: &Path, console: &mut Console<'_>) -> Result<ReadFile, Failure> {
        self.read_told_by("--from", path, console)
    }

    /// Reads a file, or standard input, with the default limits, with all its parts.
    pub(crate) fn read_document(self, path: &Path, console: &mut Console<'_>) -> Result<Document, Failure> {
        self.document_told_by("--from", path, &ReadOptions::default(), console)
    }

    /// Reads a document whose meshes will be welded, as [`read_document`](Self::read_document) does.
    pub(crate) fn read_to_weld(self, path: &Path, console: &mut Console<'_>) -> Result<Document, Failure> {
        self.document_told_by("--from", path, &ReadOptions::default().with_shared_places(), console)
    }

    /// Reads as [`read`](Self::read) does, for a command that is told the format by another option.
    pub(crate) fn read_told_by(
        self,
        option: &str,
        path: &Path,
        console: &mut Console<'_>,
    ) -> Result<ReadFile, Failure> {
        let document = self.document_told_by(option, path, &ReadOptions::default(), console)?;
        as_one_mesh(document, Placing::Scene, path)
    }

    fn document_told_by(
        self,
        option: &str,
        path: &Path,
        options: &ReadOptions,
        console: &mut Console<'_>,
    ) -> Result<Document, Failure> {
        let options = options.clone().with_format(self.from);
        if !is_stream(path) {
            return Ok(read_document(path, &options)?);
        }
        let Some(input) = console.take_input() else {
            return Err(Failure::usage("standard input can be read only once"));
        };
        read_document_stream(input, INPUT, &options).map_err(|error| {
            let is_unknown = matches!(error.kind, ReadErrorKind::UnknownFormat { looks_like: None });
            let failure = Failure::from(error);
            let hint = if is_unknown { format!("; {option} tells it") } else { String::new() };
            Failure { message: failure.message + &hint, ..failure }
        })
    }
}

/// The parts of a document as one mesh.
pub(crate) fn as_one_mesh(document: Document, placing: Placing, path: &Path) -> Result<ReadFile, Failure> {
    let failed =
        |reason| Failure { status: Status::Unreadable, message: format!("{}: {reason}", name(path)) };
    document.into_mesh(placing).map_err(failed)
}

/// Whether a name stands for a standard stream.
pub(crate) fn is_stream(path: &Path) -> bool {
    path.as_os_str() == STREAM
}

/// What an input is called in reports and messages.
pub(crate) fn name(path: &Path) -> String {
    if is_stream(path) { INPUT.to_owned() } else { path.display().to_string() }
}

/// What an output is called in reports and messages.
pub(crate) fn output_name(path: &Path) -> String {
    if is_stream(path) { OUTPUT.to_owned() } else { path.display().to_string() }
}

/// Whether a report is printed as JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Report {
    Text,
    Json,
}

impl Report {
    pub(crate) fn of(json: bool) -> Self {
        if json { Report::Json } else { Report::Text }
    }
}

/// Gives standard output over to what a command writes, if that goes there.
///
/// # Errors
/// When a report as JSON belongs there too.
pub(crate) fn reserve(output: &Path, report: Report, console: &mut Console<'_>) -> Result<(), Failure> {
    if !is_stream(output) {
        return Ok(());
    }
    if report == Report::Json {
        let reason = "--json prints to standard output, which carries what is written to `-`; write one of them to a file";
        return Err(Failure::usage(reason));
    }
    console.reserve_output();
    Ok(())
}

/// Writes a mesh to a file, whole or not at all, or to standard output, and says what is lost.
pub(crate) fn write_mesh(
    output: &Path,
    mesh: &PolygonMesh,
    options: &WriteOptions,
    console: &mut Console<'_>,
) -> Result<Vec<Loss>, Failure> {
    let failed = |kind| WriteError { file: output_name(output), kind };
    let prepared = Prepared::new(mesh, options).map_err(failed)?;
    write_prepared(output, &prepared, console)?;
    Ok(prepared.losses())
}

/// Writes a mesh that is ready to a file, whole or not at all, or to standard output.
pub(crate) fn write_prepared(
    output: &Path,
    prepared: &Prepared,
    console: &mut Console<'_>,
) -> Result<(), Failure> {
    write_ready(output, console, |path| prepared.write(path), |out| prepared.encode(out))
}

/// Writes a repaired file that is ready to a file, whole or not at all, or to standard output.
pub(crate) fn write_repaired(
    output: &Path,
    prepared: &PreparedFile,
    console: &mut Console<'_>,
) -> Result<(), Failure> {
    write_ready(output, console, |path| prepared.write(path), |out| prepared.encode(out))
}

/// Writes a document that is ready to a file, whole or not at all, or to standard output.
pub(crate) fn write_document(
    output: &Path,
    prepared: &PreparedDocument,
    console: &mut Console<'_>,
) -> Result<(), Failure> {
    write_ready(output, console, |path| prepared.write(path), |out| prepared.encode(out))
}

fn write_ready(
    output: &Path,
    console: &mut Console<'_>,
    write: impl FnOnce(&Path) -> Result<(), WriteError>,
    encode: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), Failure> {
    if !is_stream(output) {
        return Ok(write(output)?);
    }
    Ok(console.send(encode).map_err(|error| WriteError { file: OUTPUT.to_owned(), ..error })?)
}

/// Writes a text, as [`write_with`] writes.
pub(crate) fn write_text(output: &Path, text: &str, console: &mut Console<'_>) -> Result<(), Failure> {
    write_with(output, console, |out| {
        out.write_all(text.as_bytes())?;
        out.flush()
    })
}

/// Writes something else to a file, whole or not at all, or to standard output.
pub(crate) fn write_with(
    output: &Path,
    console: &mut Console<'_>,
    write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let written = if is_stream(output) { console.send(write) } else { replace_file(output, write) };
    written.map_err(|error| Failure::unwritable(&output_name(output), error))
}
