//! `meshmend batch`: mends many files, whatever happens to any of them.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::available_parallelism;
use std::time::Duration;

#[cfg(feature = "report")]
use std::collections::BTreeMap;

use clap::{ArgMatches, Args, parser::ValueSource};
use meshmend::passes::Passes;
use meshmend::report::{BatchDocument, Row, RowStatus};
use meshmend::{Format, Rules};
#[cfg(feature = "report")]
use meshmend_report::{Entry, EntryOptions};

use super::worker::Worker;
use crate::batch::{Ledger, Limits, Listed, Stop, Supervisor, Task, Tree, listed, of_line};
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::jobs::{Job, JobInput, JobOutput, Reports, Work, cost, size};
use crate::output_words::OutputWords;
#[cfg(feature = "report")]
use crate::outputs::{Content, Files};
#[cfg(feature = "report")]
use crate::pages::{self, PageFile};
use crate::policies;
use crate::repair_words::RepairWords;
use crate::streams::is_stream;

/// What the ledger is called, if nothing else is said.
const LEDGER: &str = "batch.jsonl";

/// Mend many files: each into its place below a folder, with a row for each in a ledger
///
/// A file that crashes, hangs or needs too much memory is a row, and the others are mended all the same. docs/batch.md has the
/// ledger and the statuses.
#[derive(Debug, Args)]
pub(crate) struct Batch {
    /// Files, folders (files with the name of a mesh; links are not followed), patterns, or `-` for a list on standard input
    #[arg(value_name = "IN", required_unless_present = "from")]
    inputs: Vec<PathBuf>,
    /// A file of inputs, a path a line, or `-` for standard input
    #[arg(long, value_name = "LIST")]
    from: Option<PathBuf>,
    /// The folder of the results, a tree like that of the inputs
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// How many files are worked on at a time; by default as many as there are processors
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// The memory that all together may have, as estimated
    #[arg(long, value_name = "SIZE", value_parser = size, default_value = "4GiB")]
    memory: u64,
    /// The address space that one file may have
    #[arg(long, value_name = "SIZE", value_parser = size, default_value = "2GiB")]
    memory_per_file: u64,
    /// How long one file may take
    #[arg(long, value_name = "TIME", value_parser = humantime::parse_duration, default_value = "60s")]
    timeout: Duration,
    /// Go on where an earlier run with this ledger ended: files that are done and have not changed are passed over
    #[arg(long)]
    resume: bool,
    /// Do these again too, of the files that were done and failed
    #[arg(long, value_name = "STATUS", value_delimiter = ',', value_parser = status, requires = "resume")]
    retry: Vec<RowStatus>,
    /// Where the rows go, a line each; by default batch.jsonl in the folder of the results
    #[arg(long, value_name = "FILE")]
    ledger: Option<PathBuf>,
    /// Also write a page with a row for each file, to be sorted and filtered
    #[cfg(feature = "report")]
    #[arg(long, value_name = "PAGE")]
    html: Option<PathBuf>,
    /// What stands in the names of results before the extension
    #[arg(long, value_name = "S", default_value = "")]
    suffix: String,
    /// Put the whole report on each file into its row
    #[arg(long)]
    reports: bool,
    /// Print the counts as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    to: OutputWords,
    #[command(flatten)]
    words: RepairWords,
    #[arg(skip)]
    forwarded: Vec<OsString>,
}

impl Batch {
    /// Takes over what the command line says of the options of these passes, and what it says to workers.
    pub(super) fn take(&mut self, matches: &ArgMatches, passes: Passes) {
        self.words.policies.take(matches, passes);
        let worker = policies::with_options(Worker::augment_args(clap::Command::new("worker")), passes);
        let own = ["memory", "cost", "costing", "bound_to"];
        for argument in worker.get_arguments().filter(|argument| !own.contains(&argument.get_id().as_str())) {
            let (id, Some(long)) = (argument.get_id().as_str(), argument.get_long()) else { continue };
            if matches.value_source(id) != Some(ValueSource::CommandLine) {
                continue;
            }
            if !argument.get_action().takes_values() {
                self.forwarded.push(format!("--{long}").into());
                continue;
            }
            for value in matches.get_raw(id).into_iter().flatten() {
                let mut word = OsString::from(format!("--{long}="));
                word.push(value);
                self.forwarded.push(word);
            }
        }
    }

    pub(crate) fn run(self, rules: Rules, console: &mut Console<'_>) -> Result<Status, Failure> {
        console.own_process("batch")?;
        let repair = self.words.repair(rules)?;
        let to = self.to.planned(&repair.plan);
        let work = Work { repair, to, gate: self.words.gate.clone(), reports: Reports::LeftOut };
        let files = self.files(console)?;
        let tree = Tree { root: &self.output, suffix: &self.suffix, format: self.to.format_named() };
        let path = self.ledger.clone().unwrap_or_else(|| self.output.join(LEDGER));
        let list = self.from.as_deref().filter(|list| !is_stream(list));
        let outputs = tree.outputs(&files, list, &path)?;
        #[cfg(feature = "report")]
        self.check_page(&files, &path)?;

        fs::create_dir_all(&self.output)
            .map_err(|error| Failure::unwritable(&self.output.display().to_string(), error))?;
        let (mut ledger, rows) = Ledger::open(&path)?;
        if rows.broken > 0 {
            console.note(&format!(
                "{}: lines that are no row are passed over: {}",
                path.display(),
                rows.broken
            ));
        }
        let mut counts = BatchDocument::new(files.len() as u64, path.display().to_string());
        let mut all = AllRows::default();
        let mut tasks = Vec::new();
        for (at, (file, output)) in files.iter().zip(&outputs).enumerate() {
            match self.task(at as u64, file, output, &work) {
                Ok(task) => {
                    match rows.by_path.get(&task.row.path).filter(|row| self.is_done(row, &task.row, output))
                    {
                        Some(row) => {
                            counts.add_done_before(row);
                            all.keep(row);
                        }
                        None => tasks.push(task),
                    }
                }
                Err(row) => {
                    ledger.add(&row)?;
                    counts.add(&row);
                    all.keep(&row);
                }
            }
        }
        self.supervise(tasks, (&mut ledger, &mut counts, &mut all), console)?;
        #[cfg(feature = "report")]
        if let Some(html) = &self.html {
            all.page(rules, &files).write(html, console)?;
        }
        let text = if self.json { super::checked_file::json_line(&counts)? } else { told(&counts) };
        console.write(&text)?;
        Ok(if counts.failed() > 0 { Status::Failing } else { Status::Done })
    }

    /// Fails when the page would take the place of something else.
    #[cfg(feature = "report")]
    fn check_page(&self, files: &[Listed], ledger: &Path) -> Result<(), Failure> {
        let Some(html) = &self.html else { return Ok(()) };
        if is_stream(html) {
            return Err(Failure::usage("--html writes a file"));
        }
        let taken = Files::default().writing("--ledger", Some(ledger), Content::Report);
        let taken = taken.reading_meshes(files.iter().map(|file| file.path.as_path()));
        taken.writing("--html", Some(html), Content::Report).check()
    }

    fn files(&self, console: &mut Console<'_>) -> Result<Vec<Listed>, Failure> {
        let mut files = Vec::new();
        for word in self.inputs.iter().filter(|word| !is_stream(word)) {
            files.extend(listed(word, &self.output)?);
        }
        for list in self.inputs.iter().filter(|word| is_stream(word)).chain(&self.from) {
            for line in lines_of(list, console)? {
                files.extend(of_line(&line, &self.output)?);
            }
        }
        Ok(files)
    }

    /// What is to be done for a file; its row at once if a worker can't be asked for it.
    fn task(&self, id: u64, file: &Listed, output: &Path, work: &Work) -> Result<Task, Box<Row>> {
        let name = file.path.display().to_string();
        let row = Row { size: file.size, mtime: file.mtime.clone(), ..Row::of(&name) };
        let (Some(path), Some(to)) = (file.path.to_str(), output.to_str()) else {
            return Err(Box::new(row.failed(RowStatus::Unreadable, "its name is not UTF-8")));
        };
        let (input, to) = (JobInput::Path(path.to_owned()), JobOutput::Path(to.to_owned()));
        let job = Job { id, name, input, output: Some(to), format: None };
        let digest = work.options(&job).and_then(|options| work.digest(options.as_ref()));
        let row = Row { plan_digest: digest.unwrap_or_default(), ..row };
        let format = Format::from_path(&file.path).unwrap_or(Format::Obj);
        let cost = cost(file.size.unwrap_or(0), format).min(self.memory_per_file);
        Ok(Task { job, row, cost })
    }

    /// Whether an earlier run has done a file as this one would, and its result is still there.
    fn is_done(&self, done: &Row, due: &Row, output: &Path) -> bool {
        let same = |row: &Row| (row.size, row.mtime.clone(), row.plan_digest.clone(), row.version.clone());
        let is_there = match done.status.is_failure() {
            true => !self.retry.contains(&done.status),
            false => done.output.is_none() || (done.output.as_deref() == output.to_str() && output.exists()),
        };
        self.resume && is_there && same(done) == same(due)
    }

    fn supervise(
        &self,
        tasks: Vec<Task>,
        (ledger, counts, all): (&mut Ledger, &mut BatchDocument, &mut AllRows),
        console: &mut Console<'_>,
    ) -> Result<(), Failure> {
        let program = std::env::current_exe().map_err(|error| Failure::usage(error.to_string()))?;
        let mut arguments = self.forwarded.clone();
        if cfg!(target_os = "linux") {
            arguments.push(format!("--bound-to={}", std::process::id()).into());
        }
        if cfg!(all(unix, not(target_os = "macos"))) {
            arguments.push(format!("--memory={}", self.memory_per_file).into());
        }
        let processors = || available_parallelism().map_or(1, usize::from);
        let jobs = self.jobs.map_or_else(processors, usize::from).clamp(1, tasks.len().max(1));
        let limits = Limits { jobs, memory: self.memory, patience: self.timeout };
        let progress = console.progress(tasks.len()).of_files();
        let mut tell = |row: &Row| {
            progress.step(&row.path);
            counts.add(row);
            all.keep(row);
            ledger.add(row)
        };
        let stop = Arc::new(Stop::default());
        stop.on_signals();
        Supervisor { program, arguments, limits, stop: Arc::clone(&stop) }.run(tasks, &mut tell)?;
        #[cfg(unix)]
        if let Some(signal) = stop.signal() {
            drop(progress);
            console.note("asked to end: what is done has its row, and --resume goes on");
            crate::signals::end_by(signal);
        }
        Ok(())
    }
}

/// The rows of a run that are to be shown on a page.
#[derive(Default)]
struct AllRows {
    #[cfg(feature = "report")]
    by_path: BTreeMap<String, Row>,
}

impl AllRows {
    #[cfg(feature = "report")]
    fn keep(&mut self, row: &Row) {
        self.by_path.insert(row.path.clone(), Row { report: None, ..row.clone() });
    }

    #[cfg(not(feature = "report"))]
    fn keep(&mut self, _: &Row) {}

    /// The page, with the files in the order in which they are listed.
    #[cfg(feature = "report")]
    fn page(&self, rules: Rules, files: &[Listed]) -> PageFile {
        let paths: Vec<PathBuf> = files.iter().map(|file| file.path.clone()).collect();
        let mut page = PageFile::of(&pages::title(None, &paths), rules, EntryOptions::default());
        let rows = paths.iter().filter_map(|path| self.by_path.get(&path.display().to_string()));
        page.page.entries.extend(rows.map(|row| Entry::of_row(row, rules)));
        page
    }
}

/// The lines of a list that say something.
fn lines_of(list: &Path, console: &mut Console<'_>) -> Result<Vec<String>, Failure> {
    let (name, input): (_, Box<dyn Read + '_>) = if is_stream(list) {
        let Some(input) = console.take_input() else {
            return Err(Failure::usage("standard input can be read only once"));
        };
        ("standard input".to_owned(), Box::new(input))
    } else {
        let name = list.display().to_string();
        let file = File::open(list).map_err(|error| Failure::usage(format!("{name}: {error}")))?;
        (name, Box::new(file))
    };
    let lines = BufReader::new(input).lines().filter(|line| !line.as_ref().is_ok_and(String::is_empty));
    lines.collect::<Result<_, _>>().map_err(|error| Failure::usage(format!("{name}: {error}")))
}

/// The counts for people.
fn told(counts: &BatchDocument) -> String {
    let mut text = format!("files: {}", counts.files);
    if counts.done_before > 0 {
        text += &format!(", done before: {}", counts.done_before);
    }
    text.push('\n');
    for (status, count) in counts.statuses.iter().filter(|(_, count)| **count > 0) {
        text += &format!("  {status:<10} {count}\n");
    }
    text + &format!("rows: {}\n", counts.ledger)
}

fn status(word: &str) -> Result<RowStatus, String> {
    let failures = || RowStatus::ALL.into_iter().filter(|status| status.is_failure());
    failures().find(|status| status.name() == word).ok_or_else(|| {
        let names: Vec<&str> = failures().map(RowStatus::name).collect();
        format!("the statuses are {}", names.join(", "))
    })
}
