//! The command line of meshmend, as a function: [`run`] does what a list of arguments says, writes to the streams that
//! it is given, and says how it ended. The program `meshmend` hands it the process's own.
//!
//! A command is one file in `commands` with its options and its work; `render` alone makes text for people; the
//! rest is what commands share.

mod batch;
mod commands;
mod console;
mod failure;
mod format_words;
mod gate_words;
mod geometry_words;
mod jobs;
mod output_words;
mod outputs;
#[cfg(feature = "report")]
mod pages;
mod parts;
mod policies;
mod progress;
mod render;
mod repair_words;
mod signals;
mod streams;
pub mod text;
mod threads;
mod words;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser};
use meshmend::passes::Passes;
use meshmend::{AnyKernel, Kernels, Rules};

pub use crate::console::Console;
pub use crate::failure::Status;
pub use crate::signals::end_cleanly;

use crate::commands::Command;
use crate::failure::Failure;
use crate::threads::Pool;

const EXIT_STATUS: &str = "\
Exit status:
  0  done; also when a repair left what it names, such as a non-orientable patch
  1  check found defects, or a file is what --fail-on names
  2  the command line or a plan is wrong, or the output's format can't be written
  3  an input can't be read, or its format is not known
  4  an output can't be written
  5  refused: a policy says `fail`, or the kernel can't hold the mesh";

/// The words of the program.
#[derive(Debug, Parser)]
#[command(name = "meshmend", version, about = about(), after_help = EXIT_STATUS)]
struct CommandLine {
    /// How many threads may work; by default as many as there are processors, and one for small files
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(subcommand)]
    command: Command,
}

/// What the program is for, and with which files.
fn about() -> String {
    let names: Vec<&str> = meshmend::Format::ALL.iter().map(|format| format.name()).collect();
    format!("Finds, explains and mends what is wrong with polygon meshes ({})", names.join(", "))
}

/// Does what a command line says, as [`Program::run`] does with what meshmend has of itself.
///
/// ```
/// let (mut out, mut errors) = (Vec::new(), Vec::new());
/// let mut console = meshmend_cli::Console::of(&mut out, &mut errors);
/// let status = meshmend_cli::run(["meshmend", "explain", "weld"], &mut console);
/// drop(console);
/// assert_eq!(status, meshmend_cli::Status::Done);
/// assert!(out.starts_with(b"weld") && errors.is_empty());
/// ```
pub fn run(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    console: &mut Console<'_>,
) -> Status {
    Program::default().run(arguments, console)
}

/// The program, with what it knows beside what meshmend has of itself.
#[derive(Clone, Copy, Debug, Default)]
pub struct Program {
    rules: Rules,
    passes: Passes,
    kernels: Kernels,
}

impl Program {
    /// The program with these kinds of defect: checks look for them, `--fail-on` takes and `explain` explains them.
    #[must_use]
    pub fn with_rules(self, rules: Rules) -> Self {
        Program { rules, ..self }
    }

    /// The program with these passes: plans may name them, `repair` has their options, and `explain` explains them.
    #[must_use]
    pub fn with_passes(self, passes: Passes) -> Self {
        Program { passes, ..self }
    }

    /// The program with these kernels: they are listed, timed, explained and checked with like meshmend's own. Repairs compute on
    /// meshmend's own alone.
    #[must_use]
    pub fn with_kernels(self, kernels: Kernels) -> Self {
        Program { kernels, ..self }
    }

    /// Does what a command line says; the first argument is the name of the program. Errors are written to the console's
    /// stream for errors.
    pub fn run(
        &self,
        arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
        console: &mut Console<'_>,
    ) -> Status {
        let outcome = match self.parse(arguments) {
            Ok(line) => Pool::start(line.threads, line.command.inputs())
                .and_then(|pool| pool.install(|| line.command.run(self, console))),
            Err(answer) => told(&answer, console),
        };
        outcome.unwrap_or_else(|failure| {
            console.complain(&failure);
            failure.status
        })
    }

    fn parse(
        &self,
        arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    ) -> clap::error::Result<CommandLine> {
        let matches = self.description().try_get_matches_from(arguments)?;
        let mut line = CommandLine::from_arg_matches(&matches)?;
        line.command.take_policies(&matches, self.passes);
        Ok(line)
    }

    fn description(&self) -> clap::Command {
        let with_options = |repair| policies::with_options(repair, self.passes);
        let report = cfg!(feature = "report").then_some("report");
        ["repair", "worker", "batch"]
            .into_iter()
            .chain(report)
            .fold(CommandLine::command(), |line, command| line.mut_subcommand(command, with_options))
    }
}

/// The whole program with more kernels than meshmend has: the `main` of a program of one's own. A name that is taken is an error, with the
/// status of a command line that is wrong.
///
/// ```no_run
/// use std::process::ExitCode;
///
/// use meshmend::AnyKernel;
/// # use meshmend::kernels::HalfEdge as WingedEdge;
///
/// fn main() -> ExitCode {
///     meshmend_cli::main_with(&[AnyKernel::of::<WingedEdge>()])
/// }
/// ```
pub fn main_with(kernels: &[AnyKernel]) -> ExitCode {
    end_cleanly();
    let mut console = Console::standard();
    // Once in a process, whose own they are to its end.
    let kernels: &'static [AnyKernel] = kernels.to_vec().leak();
    let status = match Kernels::with(kernels) {
        Ok(kernels) => Program::default().with_kernels(kernels).run(std::env::args_os(), &mut console),
        Err(error) => {
            let failure = Failure::usage(error.to_string());
            console.complain(&failure);
            failure.status
        }
    };
    status.into()
}

/// The commands and options that [`run`] takes.
pub fn description() -> clap::Command {
    Program::default().description()
}

/// Tells what the parser answers in place of a command line: help, the version, or what is wrong.
fn told(answer: &clap::Error, console: &mut Console<'_>) -> Result<Status, Failure> {
    let text = answer.render();
    if answer.use_stderr() {
        console.write_error(&text);
        return Ok(Status::Usage);
    }
    console.write_styled(&text)?;
    Ok(Status::Done)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_command_line_is_well_formed() {
        super::description().debug_assert();
    }
}
