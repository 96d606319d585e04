//! Measuring, in a process that does nothing else.

use std::path::Path;
use std::time::{Duration, Instant};

use cap::Cap;
use clap::ValueEnum;
use cpu_time::ProcessTime;
use mimalloc::MiMalloc;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::operations::{Figures, Operation};

/// What a process that measures tells the one that asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Measured {
    /// Processor time of all threads, in seconds, run by run.
    pub(crate) cpu: Vec<f64>,
    /// Time by the clock, in seconds, run by run.
    pub(crate) wall: Vec<f64>,
    /// The most bytes that were in use beyond the input and what was there before.
    pub(crate) peak: u64,
    /// What came out in the last run.
    pub(crate) figures: Figures,
}

/// Does an operation some times, each time on an input that is read anew, and measures it alone.
///
/// An input takes no more memory while it is read than when it is there, so the peak is the operation's.
pub(crate) fn measure(
    operation: &Operation,
    file: &Path,
    scratch: &Path,
    runs: usize,
    allocator: &Cap<MiMalloc>,
) -> Result<Measured, Failure> {
    let mut measured = Measured { cpu: Vec::new(), wall: Vec::new(), peak: 0, figures: Figures::default() };
    for run in 0..runs {
        let task = operation.prepared(file, scratch)?;
        let before = allocator.allocated();
        let watch = Watch::start();
        let answer = task()?;
        let (cpu, wall) = watch.stop();
        measured.cpu.push(cpu.as_secs_f64());
        measured.wall.push(wall.as_secs_f64());
        // Of the first run alone: looking at the answer may take more than the operation.
        if run == 0 {
            measured.peak = allocator.max_allocated().saturating_sub(before) as u64;
        }
        if run + 1 == runs {
            measured.figures = answer()?;
        }
    }
    Ok(measured)
}

/// Does an operation once or, with nothing to do but preparing, not at all; for who counts its instructions.
pub(crate) fn once(operation: &Operation, file: &Path, scratch: &Path, part: Part) -> Result<(), Failure> {
    let task = operation.prepared(file, scratch)?;
    match part {
        Part::Preparation => Ok(()),
        Part::All => task().map(drop),
    }
}

/// How much of an operation is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Part {
    /// Its input is read.
    Preparation,
    /// The operation as well.
    All,
}

/// Two clocks.
struct Watch {
    cpu: ProcessTime,
    wall: Instant,
}

impl Watch {
    fn start() -> Self {
        Watch { cpu: ProcessTime::now(), wall: Instant::now() }
    }

    fn stop(self) -> (Duration, Duration) {
        (self.cpu.elapsed(), self.wall.elapsed())
    }
}
