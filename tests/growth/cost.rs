//! What some work costs, as a process of its own tells, and how that grows.

use std::alloc::System;
use std::fmt;
use std::process::{Command, Output};

use cap::Cap;
use cpu_time::ProcessTime;
use meshmend_core::PolygonMesh;

use crate::families::Family;
use crate::work::Work;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meter {
    /// Memory alone.
    Memory,
    /// Memory, and instructions by valgrind.
    Instructions,
}

/// What some work cost.
#[derive(Clone, Debug)]
pub(crate) struct Cost {
    /// The corners of the mesh, its layers and its comments.
    size: u64,
    /// The most memory that was in use.
    peak: u64,
    /// All memory that was ever asked for, which some work does for most steps that it makes.
    allocated: u64,
    instructions: Option<u64>,
    /// Time of the processor, in seconds.
    time: f64,
}

/// Prints for the process that asked what was allocated for a mesh and the work on it, and how long that took.
pub(crate) fn print(mesh: &PolygonMesh, allocator: &Cap<System>) {
    let micros = ProcessTime::now().as_duration().as_micros();
    let size = mesh.counts().corners + mesh.layers().len() + mesh.metadata().len();
    println!("{size} {} {} {micros}", allocator.max_allocated(), allocator.total_allocated());
}

/// A cost in time tells nothing where it is less than this, in seconds: other work on the machine decides.
const LEAST_TIME: f64 = 1.0;
/// How much more time twice as much may take before its instructions are counted.
const SUSPICIOUS_GROWTH: f64 = 2.6;

/// Whether instructions can be counted here.
pub(crate) fn has_valgrind() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success())
}

impl Cost {
    /// The cost of making a mesh and of some work on it.
    pub(crate) fn of(family: &Family, size: usize, work: Work, meter: Meter) -> Self {
        let program = std::env::current_exe().expect("a test knows where it is");
        let mut command = match meter {
            Meter::Memory => Command::new(program),
            Meter::Instructions => {
                let mut valgrind = Command::new("valgrind");
                valgrind.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]);
                valgrind.arg(program);
                valgrind
            }
        };
        command.args([family.name, &size.to_string(), work.name()]).env("RAYON_NUM_THREADS", "1");
        let output = command.output().expect("the program, or valgrind, can be started");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{command:?}: {errors}");
        Self::told(&output, (meter == Meter::Instructions).then(|| instructions(&errors)))
    }

    fn told(output: &Output, instructions: Option<u64>) -> Self {
        let text = String::from_utf8_lossy(&output.stdout);
        let figures: Vec<u64> = text.split_whitespace().map_while(|figure| figure.parse().ok()).collect();
        let &[size, peak, allocated, micros] = &figures[..] else { panic!("no figures in {text:?}") };
        Cost { size, peak, allocated, instructions, time: micros as f64 * 1e-6 }
    }

    /// What was done beyond making the mesh.
    pub(crate) fn beyond(self, made: &Cost) -> Self {
        let instructions = self.instructions.zip(made.instructions).map(|(all, made)| all - made);
        let time = (self.time - made.time).max(0.0);
        Cost { allocated: self.allocated - made.allocated, instructions, time, ..self }
    }
}

/// The count in `==7== I   refs:      1,234,567`.
fn instructions(errors: &str) -> u64 {
    let line = errors.lines().find(|line| line.contains("refs:")).expect("valgrind tells instructions");
    let digits: String =
        line.rsplit(':').next().into_iter().flat_map(str::chars).filter(char::is_ascii_digit).collect();
    digits.parse().expect("a count")
}

/// The costs of some work on a mesh and on one of about twice its size; as text a row of a table.
pub(crate) struct Comparison<'a> {
    pub(crate) family: &'a Family,
    pub(crate) work: Work,
    pub(crate) costs: [Cost; 2],
}

impl Comparison<'_> {
    pub(crate) const HEAD: &'static str = "\
| family | work | corners | peak, B a corner | instructions a corner | growth: peak | allocated | instructions |
|---|---|--:|--:|--:|--:|--:|--:|";

    /// How many times as much peak memory, memory in all and instructions are taken where there is just twice as much.
    pub(crate) fn growths(&self) -> [Option<f64>; 3] {
        let [less, more] = &self.costs;
        let doublings = (more.size as f64 / less.size as f64).log2();
        let growth = |less: u64, more: u64| (more as f64 / less as f64).powf(1.0 / doublings);
        let instructions = less.instructions.zip(more.instructions);
        [
            Some(growth(less.peak, more.peak)),
            Some(growth(less.allocated, more.allocated)),
            instructions.map(|(less, more)| growth(less, more)),
        ]
    }

    /// Whether time gives a reason to count instructions.
    pub(crate) fn seems_too_slow(&self) -> bool {
        let [less, more] = &self.costs;
        let doublings = (more.size as f64 / less.size as f64).log2();
        more.time >= LEAST_TIME && (more.time / less.time).powf(1.0 / doublings) > SUSPICIOUS_GROWTH
    }
}

impl fmt::Display for Comparison<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cost = &self.costs[1];
        let a_corner = |n: u64| format!("{:.0}", n as f64 / cost.size as f64);
        let instructions = cost.instructions.map_or("–".to_owned(), a_corner);
        let (family, work, corners) = (self.family.name, self.work.name(), cost.size);
        write!(f, "| {family} | {work} | {corners} | {} | {instructions} |", a_corner(cost.peak))?;
        let word = |growth: Option<f64>| growth.map_or("–".to_owned(), |growth| format!("{growth:.2}"));
        self.growths().into_iter().try_for_each(|growth| write!(f, " {} |", word(growth)))
    }
}
