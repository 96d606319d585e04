//! The command line.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand};
use meshmend::KernelKind;

use crate::chart::Chart;
use crate::failure::Failure;
use crate::inputs::{Content, FEWEST_FACES, Folder, Form, Input, MOST_FACES, Order};
use crate::measure::{Part, measure, once};
use crate::operations::{OPERATIONS, Operation};
use crate::rows::{Conditions, rows};
use crate::{ALLOCATOR, instructions, kernels, stops, table};

/// Measures what meshmend takes: time, memory and instructions, each in a process of its own
#[derive(Debug, Parser)]
pub(crate) enum Command {
    /// Measure operations and print a table
    Run(Run),
    /// Measure the kernels and print tables
    Kernels(Kernels),
    /// Write the inputs to files, and what is right to say of them
    Inputs(Inputs),
    /// Measure how soon work stops when it is told to, and print a table
    Stops(Stops),
    /// Name the operations
    List,
    /// Count instructions and compare them with those in a file
    Instructions(Instructions),
    /// Draw bars that are described as JSON
    Chart {
        /// The description
        #[arg(value_name = "FILE.json")]
        from: PathBuf,
        /// The picture
        #[arg(value_name = "FILE.svg")]
        to: PathBuf,
    },
    #[command(flatten)]
    Own(Own),
}

/// What the program asks itself for.
#[derive(Debug, Subcommand)]
pub(crate) enum Own {
    /// Measure one operation in this process
    #[command(hide = true)]
    Measure {
        operation: String,
        file: PathBuf,
        scratch: PathBuf,
        #[arg(long)]
        runs: NonZeroUsize,
    },
    /// Measure one kernel in this process
    #[command(hide = true)]
    MeasureKernel {
        #[arg(value_parser = kernel)]
        kernel: KernelKind,
        file: PathBuf,
        #[arg(long)]
        runs: NonZeroUsize,
    },
    /// Watch one piece of work in this process
    #[command(hide = true)]
    MeasureStops { work: String, file: PathBuf, scratch: PathBuf },
    /// Do one operation, or prepare it
    #[command(hide = true)]
    Once {
        operation: String,
        file: PathBuf,
        scratch: PathBuf,
        #[arg(long, value_enum)]
        part: Part,
    },
}

#[derive(Debug, Args)]
pub(crate) struct Run {
    /// The operations, all if none is named
    operations: Vec<String>,
    /// How many faces, each in turn
    #[arg(long, value_delimiter = ',', default_value = "100000", value_parser = face_count)]
    faces: Vec<usize>,
    #[command(flatten)]
    how: How,
    /// How many threads, each in turn
    #[arg(long, value_delimiter = ',', default_value = "1")]
    threads: Vec<NonZeroUsize>,
}

#[derive(Debug, Args)]
pub(crate) struct Kernels {
    /// How many faces
    #[arg(long, default_value = "100000", value_parser = face_count)]
    faces: usize,
    #[command(flatten)]
    how: How,
    /// Also draw bars
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// How to measure and tell.
#[derive(Debug, Args)]
pub(crate) struct How {
    /// In which order vertices and faces are stored, each in turn
    #[arg(long, value_enum, value_delimiter = ',', default_value = "mesh")]
    order: Vec<Order>,
    /// How many times each thing is done
    #[arg(long, default_value = "5")]
    runs: NonZeroUsize,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Keep the inputs in a folder, and use those that are there
    #[arg(long, value_name = "DIR")]
    inputs: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Inputs {
    /// Where to
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// How many faces
    #[arg(long, default_value = "100000", value_parser = face_count)]
    faces: usize,
    /// In which order vertices and faces are stored
    #[arg(long, value_enum, default_value = "mesh")]
    order: Order,
}

#[derive(Debug, Args)]
pub(crate) struct Stops {
    /// How many faces
    #[arg(long, default_value = "1000000", value_parser = face_count)]
    faces: usize,
    /// In which order vertices and faces are stored
    #[arg(long, value_enum, default_value = "mesh")]
    order: Order,
    /// How many threads
    #[arg(long, default_value = "1")]
    threads: NonZeroUsize,
    /// Keep the inputs in a folder, and use those that are there
    #[arg(long, value_name = "DIR")]
    inputs: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Instructions {
    /// The counts
    #[arg(value_name = "FILE")]
    counts: PathBuf,
    /// Write what is counted to the file
    #[arg(long)]
    update: bool,
}

impl Command {
    /// Does what is asked for.
    pub(crate) fn run(self) -> Result<(), Failure> {
        match self {
            Command::Run(run) => run.run(),
            Command::Kernels(kernels) => kernels.run(),
            Command::Inputs(inputs) => inputs.run(),
            Command::Stops(stops) => stops.run(),
            Command::List => OPERATIONS.iter().try_for_each(|operation| print(operation.name)),
            Command::Instructions(instructions) => instructions.run(),
            Command::Chart { from, to } => {
                let text = std::fs::read_to_string(&from).map_err(|error| Failure::io(&from, error))?;
                draw(&serde_json::from_str(&text)?, &to)
            }
            Command::Own(own) => own.run(),
        }
    }
}

impl Own {
    fn run(self) -> Result<(), Failure> {
        match self {
            Own::Measure { operation, file, scratch, runs } => {
                let operation = Operation::named(&operation)?;
                let measured = measure(operation, &file, &scratch, runs.get(), &ALLOCATOR)?;
                print(&serde_json::to_string(&measured)?)
            }
            Own::MeasureKernel { kernel, file, runs } => {
                print(&serde_json::to_string(&kernels::measure(kernel, &file, runs.get())?)?)
            }
            Own::MeasureStops { work, file, scratch } => {
                print(&serde_json::to_string(&stops::measure(&work, &file, &scratch)?)?)
            }
            Own::Once { operation, file, scratch, part } => {
                once(Operation::named(&operation)?, &file, &scratch, part)
            }
        }
    }
}

impl Run {
    fn run(self) -> Result<(), Failure> {
        let operations = Operation::all_named(&self.operations)?;
        let conditions = Conditions {
            faces: self.faces,
            orders: self.how.order.clone(),
            threads: self.threads.into_iter().map(NonZeroUsize::get).collect(),
            runs: self.how.runs.get(),
        };
        let folder = self.how.folder()?;
        if !self.how.json {
            print(table::HEAD)?;
        }
        let mut said = Ok(());
        let rows = rows(&operations, &conditions, &folder, |row| {
            if !self.how.json && said.is_ok() {
                said = print(&table::line(row));
            }
        })?;
        said?;
        if self.how.json { print(&serde_json::to_string(&rows)?) } else { Ok(()) }
    }
}

impl Kernels {
    fn run(self) -> Result<(), Failure> {
        let folder = self.how.folder()?;
        let trials = |order: &Order| kernels::trials(*order, self.faces, self.how.runs.get(), &folder);
        let trials = self.how.order.iter().map(trials).collect::<Result<Vec<_>, _>>()?;
        if let Some(path) = &self.svg {
            draw(&kernels::chart(&trials), path)?;
        }
        if self.how.json {
            return print(&serde_json::to_string(&trials)?);
        }
        trials.iter().try_for_each(|trials| print(&trials.table()))
    }
}

impl Stops {
    fn run(self) -> Result<(), Failure> {
        let folder = self.inputs.as_deref().map_or_else(Folder::temporary, Folder::kept)?;
        print(stops::HEAD)?;
        let conditions = (self.order, self.faces, self.threads.get());
        stops::stretches(conditions, &folder, |stretch| print(&stretch.line()))
    }
}

impl How {
    fn folder(&self) -> Result<Folder, Failure> {
        self.inputs.as_deref().map_or_else(Folder::temporary, Folder::kept)
    }
}

impl Inputs {
    /// Writes the inputs of all operations, and for each operation its file and what is right to say of it.
    fn run(self) -> Result<(), Failure> {
        let folder = Folder::kept(&self.folder)?;
        let of = |content| Input { content, order: self.order, faces: self.faces };
        for content in Content::ALL {
            folder.file(&of(content), Form::PlyBinary)?;
        }
        let mut known = serde_json::Map::new();
        for operation in OPERATIONS {
            let input = operation.input(self.order, self.faces);
            let entry = serde_json::json!({
                "file": folder.file(&input, operation.form())?,
                "faces": input.known().faces,
                "expected": operation.expected(&input),
            });
            known.insert(operation.name.to_owned(), entry);
        }
        for form in Form::ALL {
            folder.file(&of(Content::Indexed), form)?;
        }
        let path = folder.path().join(format!("known-{}-{}.json", self.order.name(), self.faces));
        std::fs::write(&path, format!("{:#}\n", serde_json::Value::from(known)))
            .map_err(|error| Failure::io(&path, error))
    }
}

impl Instructions {
    fn run(self) -> Result<(), Failure> {
        if !instructions::can_count() {
            return print("skipped: valgrind, which counts instructions, is not here");
        }
        let before = if self.counts.exists() { instructions::read_counts(&self.counts)? } else { Vec::new() };
        let folder = Folder::temporary()?;
        let mut said = Ok(());
        let counts = instructions::count_all(&before, &folder, |count| {
            if said.is_ok() {
                said = print(&count.line());
            }
        })?;
        said?;
        if self.update {
            return instructions::write_counts(&self.counts, &counts);
        }
        match counts.iter().filter(|count| count.is_worth_a_warning()).count() {
            0 => Ok(()),
            changed => print(&format!("{changed} of {} differ by more than 3 %", counts.len())),
        }
    }
}

fn draw(chart: &Chart, path: &Path) -> Result<(), Failure> {
    std::fs::write(path, chart.svg()).map_err(|error| Failure::io(path, error))
}

fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    writeln!(out, "{text}")
        .and_then(|()| out.flush())
        .map_err(|error| Failure::io(Path::new("output"), error))
}

fn face_count(word: &str) -> Result<usize, String> {
    match word.parse() {
        Ok(count) if (FEWEST_FACES..=MOST_FACES).contains(&count) => Ok(count),
        _ => Err(format!("expected a number from {FEWEST_FACES} to {MOST_FACES}")),
    }
}

fn kernel(word: &str) -> Result<KernelKind, String> {
    KernelKind::from_name(word).ok_or_else(|| "expected the name of a kernel".to_owned())
}
