//! Commands that this build of the program does not have.

use std::ffi::OsString;

use clap::Args;

use crate::failure::{Failure, Status};

/// Lay surfaces out in the unit square (not in this build: it was made without the feature `flatten`)
#[derive(Debug, Args)]
pub(crate) struct LeftOut {
    #[arg(hide = true, trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

impl LeftOut {
    pub(crate) fn run(self) -> Result<Status, Failure> {
        let Self { arguments: _ } = self;
        Err(Failure::usage(
            "this program was built without its command `flatten`; \
             `cargo install --locked --path crates/meshmend-cli` builds it with all commands",
        ))
    }
}
