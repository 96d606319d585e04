//! The commands, one file each.

mod check;
mod completions;
mod convert;
mod explain;
mod kernels;
mod repair;

pub(crate) use kernels::Trial;

use std::path::Path;

use clap::Subcommand;
use meshmend::{ReadFile, ReadOptions};

use crate::failure::{Failure, Status};

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Repair(Box<repair::Repair>),
    Convert(convert::Convert),
    Kernels(kernels::Kernels),
    Explain(explain::Explain),
    Completions(completions::Completions),
}

impl Command {
    pub(crate) fn run(self) -> Result<Status, Failure> {
        match self {
            Command::Check(command) => command.run(),
            Command::Repair(command) => command.run(),
            Command::Convert(command) => command.run(),
            Command::Kernels(command) => command.run(),
            Command::Explain(command) => command.run(),
            Command::Completions(command) => command.run(),
        }
    }
}

/// Reads a file with the default limits.
fn read(path: &Path) -> Result<ReadFile, Failure> {
    Ok(meshmend::read(path, &ReadOptions::default())?)
}

/// What a file is called in reports and messages.
fn name(path: &Path) -> String {
    path.display().to_string()
}
