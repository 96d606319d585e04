//! What is said of a pass: all that plans, the command line, `explain` and reports know of it.

use std::any::Any;
use std::fmt;

use serde::Serialize;
use serde::de::DeserializeOwned;
use toml::Table;

use crate::{AnyPass, Pass, PassKind};

/// All that is said of a pass: a row of the registry.
#[derive(Clone, Copy, Debug)]
pub struct PassRow {
    /// The name in plans, reports and on the command line.
    pub name: &'static str,
    /// What the pass does, why and how.
    pub explanation: &'static str,
    /// Whether the default pipeline has the pass.
    pub is_default: bool,
    /// The pass of meshmend's own before which this one has its usual place; without one it comes last. The rows of
    /// meshmend's own passes stand in order, and do not say it.
    pub before: Option<PassKind>,
    /// What can be chosen.
    pub options: &'static [PassOption],
    /// How the options stand in a plan.
    pub form: Form,
}

/// An option of a pass, on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassOption {
    /// Its name, without dashes. An option with the name of its pass also takes the word `off`, which leaves the pass out.
    pub name: &'static str,
    /// What it decides, in a line.
    pub help: &'static str,
    /// The keys of the pass's table in a plan that it sets. An option without keys says only that the pass runs.
    pub sets: &'static [&'static str],
    /// What it can be.
    pub values: OptionValues,
}

/// What an option can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptionValues {
    /// One of these words.
    Words(&'static [Word]),
    /// A [`Distance`](crate::Distance).
    Distance,
    /// [`FillLoops`](crate::FillLoops).
    Limits,
    /// [`SmallComponents`](crate::SmallComponents).
    ComponentLimit,
    /// A finite number of 1 or more.
    Aspect,
    /// A [`Reach`](crate::Reach).
    Reach,
    /// It has no word; a plan has this one where it is given.
    Flag(&'static str),
}

/// A word of the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word.
    pub name: &'static str,
    /// What a plan has in its place.
    pub value: &'static str,
    /// What it means, in a line.
    pub help: &'static str,
}

impl Word {
    /// A word that a plan has too.
    pub const fn new(name: &'static str, help: &'static str) -> Self {
        Word { name, value: name, help }
    }

    /// A word for which a plan has another one.
    pub const fn standing_for(name: &'static str, value: &'static str, help: &'static str) -> Self {
        Word { name, value, help }
    }
}

/// How the options of a pass stand in a plan: as a table, by serde.
#[derive(Clone, Copy)]
pub struct Form {
    defaults: fn() -> AnyPass,
    read: fn(Table) -> Result<AnyPass, String>,
    write: fn(&dyn Pass) -> Result<Table, String>,
}

impl Form {
    /// The form of a pass that is its options.
    pub const fn of<P: Pass + Default + Serialize + DeserializeOwned>() -> Self {
        Form { defaults: || P::default().into(), read: read::<P>, write: write::<P> }
    }

    /// The pass with its default options.
    pub(crate) fn defaults(&self) -> AnyPass {
        (self.defaults)()
    }

    /// The pass with the options of a table.
    pub(crate) fn read(&self, options: Table) -> Result<AnyPass, String> {
        (self.read)(options)
    }

    /// The options of a pass.
    pub(crate) fn write(&self, pass: &dyn Pass) -> Result<Table, String> {
        (self.write)(pass)
    }
}

fn read<P: Pass + DeserializeOwned>(options: Table) -> Result<AnyPass, String> {
    let pass: P = options.try_into().map_err(|error: toml::de::Error| error.message().to_owned())?;
    Ok(pass.into())
}

fn write<P: Pass + Serialize>(pass: &dyn Pass) -> Result<Table, String> {
    let pass: &dyn Any = pass;
    let pass = pass.downcast_ref::<P>().ok_or("the row is that of another pass")?;
    Table::try_from(pass).map_err(|error| error.to_string())
}

impl fmt::Debug for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Form")
    }
}
