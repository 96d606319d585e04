//! The commands, one file each.

mod advise;
mod batch;
mod check;
mod check_external;
mod checked_file;
#[cfg(feature = "completions")]
mod completions;
mod convert;
mod cut;
mod explain;
#[cfg(feature = "flatten")]
mod flatten;
mod incremental;
mod kernels;
#[cfg(not(all(feature = "flatten", feature = "render", feature = "report", feature = "completions")))]
mod left_out;
mod loops;
mod make;
mod matrix;
#[cfg(feature = "render")]
mod placed_overlays;
mod pointers;
mod preset;
#[cfg(feature = "render")]
mod render;
mod repair;
#[cfg(feature = "report")]
mod report;
mod worker;

pub(crate) use checked_file::{CheckedFile, json_line};

use std::path::PathBuf;
use std::slice;

use clap::{ArgMatches, Subcommand};
use meshmend::passes::Passes;

use crate::Program;
use crate::console::Console;
use crate::failure::{Failure, Status};

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Repair(Box<repair::Repair>),
    Worker(Box<worker::Worker>),
    Batch(Box<batch::Batch>),
    Convert(convert::Convert),
    Advise(advise::Advise),
    Loops(loops::Loops),
    Cut(cut::Cut),
    #[cfg(feature = "render")]
    Render(Box<render::Render>),
    /// Draw a mesh and what is wrong with it (left out of this build)
    #[cfg(not(feature = "render"))]
    Render(left_out::LeftOut),
    #[cfg(feature = "report")]
    Report(Box<report::Report>),
    /// Write a page on meshes, with the meshes in 3D (left out of this build)
    #[cfg(not(feature = "report"))]
    Report(left_out::LeftOut),
    Incremental(incremental::Incremental),
    Matrix(Box<matrix::Matrix>),
    #[cfg(feature = "flatten")]
    Flatten(flatten::Flatten),
    /// Lay surfaces out in the unit square (left out of this build)
    #[cfg(not(feature = "flatten"))]
    Flatten(left_out::LeftOut),
    Preset(preset::Preset),
    Make(make::Make),
    Pointers(pointers::Pointers),
    Kernels(kernels::KernelsCommand),
    Explain(explain::Explain),
    #[cfg(feature = "completions")]
    Completions(completions::Completions),
    /// Print the completions for a shell (left out of this build)
    #[cfg(not(feature = "completions"))]
    Completions(left_out::LeftOut),
}

impl Command {
    /// The files that it reads.
    pub(crate) fn inputs(&self) -> &[PathBuf] {
        match self {
            Command::Check(command) => &command.files,
            Command::Repair(command) => slice::from_ref(&command.input),
            Command::Convert(command) => slice::from_ref(&command.input),
            Command::Advise(command) => slice::from_ref(&command.file),
            Command::Loops(command) => slice::from_ref(&command.file),
            Command::Cut(command) => slice::from_ref(&command.input),
            #[cfg(feature = "render")]
            Command::Render(command) => slice::from_ref(&command.input),
            #[cfg(not(feature = "render"))]
            Command::Render(_) => &[],
            #[cfg(feature = "report")]
            Command::Report(command) => &command.files,
            #[cfg(not(feature = "report"))]
            Command::Report(_) => &[],
            Command::Incremental(command) => slice::from_ref(&command.file),
            Command::Matrix(command) => slice::from_ref(&command.file),
            #[cfg(feature = "flatten")]
            Command::Flatten(command) => slice::from_ref(&command.input),
            Command::Kernels(command) => command.file.as_slice(),
            Command::Pointers(command) => slice::from_ref(&command.file),
            #[cfg(not(feature = "flatten"))]
            Command::Flatten(_) => &[],
            Command::Explain(command) => command.file.as_slice(),
            Command::Preset(_)
            | Command::Worker(_)
            | Command::Batch(_)
            | Command::Make(_)
            | Command::Completions(_) => &[],
        }
    }

    /// Takes over what the command line says of the options of these passes.
    pub(crate) fn take_policies(&mut self, matches: &ArgMatches, passes: Passes) {
        let Some((_, matches)) = matches.subcommand() else { return };
        let words = match self {
            Command::Repair(command) => &mut command.words,
            #[cfg(feature = "report")]
            Command::Report(command) => &mut command.words,
            Command::Worker(command) => &mut command.words,
            Command::Batch(command) => return command.take(matches, passes),
            _ => return,
        };
        words.policies.take(matches, passes);
    }

    pub(crate) fn run(self, program: &Program, console: &mut Console<'_>) -> Result<Status, Failure> {
        let rules = program.rules;
        match self {
            Command::Check(command) => command.run(program, console),
            Command::Repair(command) => command.run(rules, console),
            Command::Convert(command) => command.run(rules, console),
            Command::Advise(command) => command.run(console),
            Command::Worker(command) => command.run(rules, console),
            Command::Batch(command) => command.run(rules, console),
            Command::Loops(command) => command.run(console),
            Command::Cut(command) => command.run(console),
            #[cfg(feature = "render")]
            Command::Render(command) => command.run(console),
            #[cfg(not(feature = "render"))]
            Command::Render(command) => command.run("render"),
            #[cfg(feature = "report")]
            Command::Report(command) => command.run(program, console),
            #[cfg(not(feature = "report"))]
            Command::Report(command) => command.run("report"),
            Command::Incremental(command) => command.run(console),
            Command::Matrix(command) => command.run(console),
            #[cfg(feature = "flatten")]
            Command::Flatten(command) => command.run(console),
            #[cfg(not(feature = "flatten"))]
            Command::Flatten(command) => command.run("flatten"),
            Command::Preset(command) => command.run(console),
            Command::Make(command) => command.run(console),
            Command::Kernels(command) => command.run(program.kernels, console),
            Command::Pointers(command) => command.run(program.kernels, console),
            Command::Explain(command) => command.run(program, console),
            #[cfg(feature = "completions")]
            Command::Completions(command) => command.run(program, console),
            #[cfg(not(feature = "completions"))]
            Command::Completions(command) => command.run("completions"),
        }
    }
}
