//! The work on one file: read, mended, written, and its row.

use std::fs::{self, Metadata};
use std::io;
use std::path::Path;

use meshmend::files::{FileRepair, FileTarget, RepairedFile, sha256, sha256_of};
use meshmend::formats::{Document, Place, ReadErrorKind, WriteErrorKind, read_document, read_document_bytes};
use meshmend::mesh::Watch;
use meshmend::report::{Row, RowStatus};
use meshmend::{ReadError, ReadOptions, WriteError, WriteOptions};

use super::meter::{Meter, host};
use super::{Job, JobInput, JobOutput};
use crate::failure::Failure;
use crate::gate_words::GateWords;
use crate::output_words::OutputWords;

/// The policy of a worker.
pub(crate) struct Work {
    pub(crate) repair: FileRepair,
    pub(crate) to: OutputWords,
    pub(crate) gate: GateWords,
    pub(crate) reports: Reports,
}

/// Whether rows have the whole report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reports {
    LeftOut,
    Whole,
}

/// A result to send, with the row of its file.
type Done = (Row, Option<Vec<u8>>);

/// Why a file ends early: its row says it.
type Ended = Box<Row>;

impl Work {
    /// Works on a file. `piped` is what came with the job.
    pub(crate) fn on(&self, job: &Job, piped: &[u8]) -> Done {
        let meter = Meter::start();
        let row = Row { host: host(), ..Row::of(&job.name) };
        let (row, bytes) = match self.done(job, piped, row) {
            Ok(done) => done,
            Err(row) => (*row, None),
        };
        (meter.told_in(row), bytes)
    }

    /// The row of a file that came with its job and for which there is no memory.
    pub(crate) fn without_memory(&self, job: &Job) -> Row {
        let row = Row { host: host(), ..Row::of(&job.name) };
        let plan_digest = self.options(job).and_then(|options| self.digest(options.as_ref()));
        let row = Row { plan_digest: plan_digest.unwrap_or_default(), ..row };
        row.failed(RowStatus::Memory, "there is no memory for the bytes of the file")
    }

    /// The digest that the rows of a job have.
    pub(crate) fn digest(&self, options: Option<&WriteOptions>) -> Result<String, Failure> {
        self.repair.digest(options).map_err(|error| Failure::usage(error.to_string()))
    }

    /// How the output of a job is written, if it has one.
    pub(crate) fn options(&self, job: &Job) -> Result<Option<WriteOptions>, Failure> {
        let to = self.to.in_format_named(job.format.as_deref())?;
        match &job.output {
            None | Some(JobOutput::Bytes(false)) => Ok(None),
            Some(JobOutput::Bytes(true)) => to.options_of_bytes(Path::new(&job.name)).map(Some),
            Some(JobOutput::Path(path)) => to.options(Path::new(path)).map(Some),
        }
    }

    fn done(&self, job: &Job, piped: &[u8], row: Row) -> Result<Done, Ended> {
        let refused =
            |row: Row, failure: Failure| Box::new(row.failed(RowStatus::Unwritable, &failure.message));
        let options = self.options(job).map_err(|failure| refused(row.clone(), failure))?;
        let plan_digest = self.digest(options.as_ref()).map_err(|failure| refused(row.clone(), failure))?;
        let row = Row { plan_digest, ..row };
        let (document, row) = read(job, piped, row)?;
        let target = options.map(|options| {
            let path = match &job.output {
                Some(JobOutput::Path(path)) => path.as_str(),
                _ => job.name.as_str(),
            };
            FileTarget::new(path, options.with_shell(document.shell.clone()))
        });
        let format_in = Some(document.variant.to_owned());
        let repaired = match self.repair.run(&job.name, document, target.as_ref(), &Watch::NOBODY) {
            Ok(repaired) => repaired,
            Err(error) => return Err(Box::new(error.told_in(Row { format_in, ..row }))),
        };
        let row = repaired.told_in(row);
        let (mut row, bytes) = match self.gate.withholds(repaired.failing()) {
            true => (row, None),
            false => written(job, &repaired, target.as_ref(), row)?,
        };
        if self.reports == Reports::Whole {
            row.report = repaired.report_json().ok();
        }
        Ok((row, bytes))
    }
}

/// Reads the file of a job, and says in the row what was read.
fn read(job: &Job, piped: &[u8], row: Row) -> Result<(Document, Row), Ended> {
    let options = ReadOptions::default().with_shared_places();
    let unreadable = |error: ReadError| Box::new(row.clone().unreadable(&error));
    let (document, digest, size) = match &job.input {
        JobInput::Bytes(size) => {
            let digest = sha256(piped);
            (read_document_bytes(piped, &job.name, &options), digest, *size)
        }
        JobInput::Path(path) => {
            let (path, failed) = (Path::new(path), |error| of_system(&job.name, error));
            let before = fs::metadata(path).map_err(|error| unreadable(failed(error)))?;
            let digest = if before.is_file() {
                sha256_of(path).map_err(|error| unreadable(failed(error)))?
            } else {
                let error = io::Error::new(io::ErrorKind::InvalidInput, "it is not a file");
                return Err(unreadable(failed(error)));
            };
            let document = read_document(path, &options);
            let after = fs::metadata(path).map_err(|error| unreadable(failed(error)))?;
            if !is_same(&before, &after) {
                let error = io::Error::other("the file was changed while it was read");
                return Err(unreadable(failed(error)));
            }
            (document, digest, before.len())
        }
    };
    let row = Row { input_sha256: Some(digest), size: Some(size), ..row.clone() };
    match document {
        Ok(document) => Ok((document, row)),
        Err(error) => Err(Box::new(row.unreadable(&ReadError { file: job.name.clone(), ..error }))),
    }
}

/// Writes a result where the job says, and says so in the row.
fn written(job: &Job, repaired: &RepairedFile, target: Option<&FileTarget>, row: Row) -> Result<Done, Ended> {
    let (Some(prepared), Some(target)) = (repaired.prepared(), target) else { return Ok((row, None)) };
    let failed = |error: WriteError| Box::new(row.clone().failed(RowStatus::Unwritable, &error.to_string()));
    let of_system = |error| failed(WriteError { file: target.name.clone(), kind: WriteErrorKind::Io(error) });
    let format_out = target.variant().map(str::to_owned);
    if let Some(JobOutput::Path(output)) = &job.output {
        let path = Path::new(output);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(of_system)?;
        }
        prepared.write(path).map_err(failed)?;
        let output_sha256 = Some(sha256_of(path).map_err(of_system)?);
        return Ok((Row { output: Some(output.clone()), output_sha256, format_out, ..row.clone() }, None));
    }
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).map_err(failed)?;
    let output_sha256 = Some(sha256(&bytes));
    Ok((Row { output_sha256, format_out, ..row.clone() }, Some(bytes)))
}

fn of_system(file: &str, error: io::Error) -> ReadError {
    ReadError { file: file.to_owned(), place: Place::File, kind: ReadErrorKind::Io(error) }
}

/// Whether a file is as it was.
fn is_same(one: &Metadata, other: &Metadata) -> bool {
    one.len() == other.len() && one.modified().ok() == other.modified().ok()
}
