//! `meshmend completions`: what a shell needs to complete commands and options.

use clap::Args;
use clap_complete::Shell;

use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};

/// Print the completions for a shell
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut program.description(), "meshmend", &mut script);
        console.write(&String::from_utf8_lossy(&script))?;
        Ok(Status::Done)
    }
}
