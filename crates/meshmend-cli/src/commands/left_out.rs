//! Commands that this build of the program does not have.

use std::ffi::OsString;

use clap::Args;

use crate::failure::{Failure, Status};

/// A command that this build leaves out
#[derive(Debug, Args)]
pub(crate) struct LeftOut {
    #[arg(hide = true, trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

impl LeftOut {
    pub(crate) fn run(self, command: &str) -> Result<Status, Failure> {
        let Self { arguments: _ } = self;
        Err(Failure::usage(format!(
            "this program was built without its command `{command}`; \
             `cargo install --locked --path crates/meshmend-cli` builds it with all commands"
        )))
    }
}
