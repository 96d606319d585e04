//! `meshmend worker`: one file after another in one process, as it is asked.

use std::io::{self, BufRead, BufReader, Read};

use clap::Args;
use meshmend::report::Row;
use meshmend::{Format, Rules};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::jobs::{Answer, Job, JobInput, Reports, Work, bind_to, cost, limit_address_space, size};
use crate::output_words::OutputWords;
use crate::repair_words::RepairWords;

/// A job is far shorter than this many bytes.
const LONGEST_LINE: u64 = 1 << 20;

/// Mend files as they are asked for: jobs as lines of JSON on standard input, a row for each on standard output
///
/// For programs that mend many files, as `batch` does: one process, one thread, one policy. It ends with the end of its input,
/// and with status 2 at a line that is not a job. docs/batch.md has the protocol.
#[derive(Debug, Args)]
pub(crate) struct Worker {
    /// Put the whole report on each file into its row
    #[arg(long)]
    reports: bool,
    /// The address space that the process may have
    #[arg(long, value_name = "SIZE", value_parser = size)]
    memory: Option<u64>,
    /// Print how many bytes of memory to set aside for a file of this size in a format, and do nothing else
    #[arg(long, value_name = "SIZE", value_parser = size, requires = "costing")]
    cost: Option<u64>,
    /// The format that --cost is asked for
    #[arg(value_name = "FORMAT", value_parser = format_words::format)]
    costing: Option<Format>,
    /// The process that started it, with which it ends, whatever it is at; on Linux
    #[arg(long, value_name = "PROCESS")]
    bound_to: Option<u32>,
    #[command(flatten)]
    to: OutputWords,
    #[command(flatten)]
    pub(super) words: RepairWords,
}

impl Worker {
    pub(crate) fn run(self, rules: Rules, console: &mut Console<'_>) -> Result<Status, Failure> {
        match (self.cost, self.costing) {
            (Some(size), Some(format)) => {
                console.write(&format!("{}\n", cost(size, format)))?;
                return Ok(Status::Done);
            }
            (None, Some(format)) => {
                return Err(Failure::usage(format!("{format} alone says nothing: --cost SIZE {format}")));
            }
            _ => {}
        }
        if let Some(process) = self.bound_to {
            console.own_process("--bound-to")?;
            bind_to(process).map_err(|reason| Failure::usage(format!("--bound-to: {reason}")))?;
        }
        if let Some(bytes) = self.memory {
            console.own_process("--memory")?;
            limit_address_space(bytes).map_err(|reason| Failure::usage(format!("--memory: {reason}")))?;
        }
        let reports = if self.reports { Reports::Whole } else { Reports::LeftOut };
        let repair = self.words.repair(rules)?;
        let to = self.to.planned(&repair.plan);
        let to = to.planned(&repair.plan);
        let work = Work { repair, to, gate: self.words.gate, reports };
        let Some(input) = console.take_input() else {
            return Err(Failure::usage("standard input can be read only once"));
        };
        let mut input = BufReader::new(input);
        while let Some(job) = next_job(&mut input)? {
            let (row, bytes) = match job.input {
                JobInput::Bytes(count) => match piped(&mut input, count)? {
                    Some(piped) => work.on(&job, &piped),
                    None => (work.without_memory(&job), None),
                },
                JobInput::Path(_) => work.on(&job, &[]),
            };
            answer(job.id, row, bytes, console)?;
            if console.is_closed() {
                break;
            }
        }
        Ok(Status::Done)
    }
}

/// Answers a job, with the bytes of the result if they were asked for.
fn answer(id: u64, row: Row, bytes: Option<Vec<u8>>, console: &mut Console<'_>) -> Result<(), Failure> {
    let line =
        super::checked_file::json_line(&Answer { id, row, bytes: bytes.as_ref().map(|it| it.len() as u64) })?;
    let sent = console.send(|out| {
        out.write_all(line.as_bytes())?;
        out.write_all(bytes.as_deref().unwrap_or_default())?;
        out.flush()
    });
    sent.map_err(|error| Failure::unwritable("standard output", error))
}

/// The next job; `None` at the end of the input.
fn next_job(input: &mut impl BufRead) -> Result<Option<Job>, Failure> {
    let mut line = Vec::new();
    input.take(LONGEST_LINE).read_until(b'\n', &mut line).map_err(broken)?;
    if line.is_empty() {
        return Ok(None);
    }
    if line.last() != Some(&b'\n') {
        return Err(broken("a line without an end, or one that is far too long"));
    }
    serde_json::from_slice(&line).map(Some).map_err(broken)
}

/// The bytes that come with a job; `None` if there is no memory for them, and they are passed over.
fn piped(input: &mut impl Read, count: u64) -> Result<Option<Vec<u8>>, Failure> {
    let mut bytes = Vec::new();
    let has_room = usize::try_from(count).is_ok_and(|room| bytes.try_reserve_exact(room).is_ok());
    let mut input = input.take(count);
    let came = match has_room {
        true => input.read_to_end(&mut bytes).map_err(broken)? as u64,
        false => io::copy(&mut input, &mut io::sink()).map_err(broken)?,
    };
    if came != count {
        return Err(broken(format!("{count} bytes were announced, and {came} came")));
    }
    Ok(has_room.then_some(bytes))
}

fn broken(reason: impl std::fmt::Display) -> Failure {
    Failure::usage(format!("standard input: not a job: {reason}"))
}
