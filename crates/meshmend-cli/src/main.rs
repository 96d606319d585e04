//! The command line of meshmend.
//!
//! A command is one file in `commands` with its options and its work; `render` alone makes text for people; the
//! rest is what commands share. Exit statuses are those of [`failure::Status`].

mod commands;
mod console;
mod failure;
mod policies;
mod progress;
mod render;
mod words;

use std::process::ExitCode;

use clap::Parser;

use crate::commands::Command;

const EXIT_STATUS: &str = "\
Exit status:
  0  done; also when a repair left what it names, such as a non-orientable patch
  1  check: defects were found, or what --fail-on names
  2  the command line or a plan is wrong, or the output's format can't be written
  3  an input can't be read, or its format is not known
  4  an output can't be written
  5  refused: a policy says `fail`, or the kernel can't hold the mesh";

/// Finds, explains and mends what is wrong with polygon meshes (OBJ, PLY, STL, OFF)
#[derive(Debug, Parser)]
#[command(name = "meshmend", version, after_help = EXIT_STATUS)]
struct CommandLine {
    /// How many threads may work; by default as many as there are processors
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    let line = CommandLine::parse();
    let outcome = with_threads(line.threads).and_then(|()| line.command.run());
    match outcome {
        Ok(status) => status.into(),
        Err(failure) => {
            console::complain(&failure);
            failure.status.into()
        }
    }
}

fn with_threads(threads: Option<u16>) -> Result<(), failure::Failure> {
    let Some(threads) = threads else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global();
    pool.map_err(|error| failure::Failure::usage(format!("--threads {threads}: {error}")))
}

/// The command line's description, for completions.
fn description() -> clap::Command {
    <CommandLine as clap::CommandFactory>::command()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_command_line_is_well_formed() {
        super::description().debug_assert();
    }
}
