//! `meshmend-bench`: what meshmend takes, and what it is compared with.
//!
//! `run` measures operations, `kernels` the ways of storing connectivity, `instructions` counts; `inputs` writes what
//! other programs are measured on. Every figure is of a process of its own, which is this program started once more.

mod chart;
mod command;
mod failure;
mod inputs;
mod instructions;
mod kernels;
mod measure;
mod operations;
mod random;
mod rows;
mod stops;
mod table;

use std::process::ExitCode;

use cap::Cap;
use clap::Parser;
use mimalloc::MiMalloc;

use command::Command;

/// That of the command line, counted.
#[global_allocator]
static ALLOCATOR: Cap<MiMalloc> = Cap::new(MiMalloc, usize::MAX);

fn main() -> ExitCode {
    match Command::parse().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("meshmend-bench: {failure}");
            ExitCode::FAILURE
        }
    }
}
