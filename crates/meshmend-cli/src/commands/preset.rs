//! `meshmend preset`: the plan for a purpose, to read, to change and to give back.

use clap::Args;

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::policies::preset_names;

/// Print the plan for a purpose, as `repair --preset` takes it
///
/// It is a TOML file as `repair --plan` reads it, with its reasons as comments.
#[derive(Debug, Args)]
pub(crate) struct Preset {
    /// Which one
    #[arg(value_name = "NAME", value_parser = preset_names())]
    name: String,
}

impl Preset {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        // The parser has refused each name that is none.
        if let Some(preset) = meshmend::passes::Preset::from_name(&self.name) {
            console.write(preset.toml)?;
        }
        Ok(Status::Done)
    }
}
