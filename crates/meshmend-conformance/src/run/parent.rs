//! The process that begins runs, and goes on after one that ended badly.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use super::child::{EVENTS, JOB, PLACE, RUN, WORDS, example_of};
use super::event::{Event, Finding, Job, Manner};
use super::folder::Scratch;
use super::tally::Results;
use crate::guard::{At, Query};
use crate::laws::{LAWS, number};
use crate::worlds::World;

/// How the child is begun: this program again, with these arguments.
pub(crate) type Arguments = Vec<String>;

/// Runs a job in children, until every law is asked on every mesh or known to be broken.
///
/// # Errors
/// When no child can be begun, or it does not know the kernel.
pub(crate) fn guarded(kernel: &str, arguments: &Arguments, mut job: Job) -> Result<Results, String> {
    let scratch = Scratch::new(kernel).map_err(|error| format!("no folder for the run: {error}"))?;
    let (world, mut results) = (World::of(job.effort), Results::default());
    // Each run that does not get through leaves a law out of the next one.
    for _ in 0..=LAWS.len() {
        let run = Run::begin(&scratch.0, arguments, &job)?;
        run.events.iter().cloned().for_each(|event| results.take(event));
        if run.is_done() {
            return Ok(results);
        }
        let stuck = match run.stuck() {
            Some(stuck) => stuck,
            None => post_mortem(&scratch.0, arguments, &job, &run, &world, &mut results)?,
        };
        if !leave_out(stuck, &mut job, &world, &mut results) {
            break;
        }
    }
    Ok(results)
}

/// Where a run could not go on.
#[derive(Clone, Copy)]
struct Stuck {
    law: u32,
    mesh: u32,
    query: u8,
}

/// Runs once more from where a run was seen last, with each step written down, and finds where it ended.
fn post_mortem(
    folder: &Path,
    arguments: &Arguments,
    job: &Job,
    run: &Run,
    world: &World,
    results: &mut Results,
) -> Result<Stuck, String> {
    let from = run.last_mesh().unwrap_or(job.from);
    let again = Run::begin(folder, arguments, &Job { from, is_recorded: true, ..job.clone() })?;
    again
        .events
        .iter()
        .filter(|event| !matches!(event, Event::Done { .. }))
        .cloned()
        .for_each(|event| results.take(event));
    if let Some(stuck) = again.stuck() {
        return Ok(stuck);
    }
    // A run that ends now and then, and not this time, was seen last under the first law of all.
    let unsteady = At { mesh: from, law: number("assembly"), query: Query::ASSEMBLE, element: 0 };
    let written = fs::read(folder.join(PLACE)).ok().and_then(|bytes| At::written(&bytes));
    let at = written.filter(|_| !again.is_done()).unwrap_or(unsteady);
    let example = example_of(world, at.mesh, job.is_of_size);
    let (manner, found) = if again.is_done() { run.end() } else { again.end() };
    let question = at.query.about(at.element).to_string();
    results.find(Finding { law: at.law, manner, example, question, found, expected: None });
    Ok(Stuck { law: at.law, mesh: at.mesh, query: at.query.number() })
}

/// Leaves a law out of the runs to come, and the question that stopped it from that mesh on. Returns whether anything is
/// left to ask.
fn leave_out(stuck: Stuck, job: &mut Job, world: &World, results: &mut Results) -> bool {
    let assembly = number("assembly");
    let is_family = stuck.mesh as usize >= world.len();
    if stuck.law != assembly {
        let is_new = !job.shut.contains(&stuck.law);
        job.shut.push(stuck.law);
        if stuck.query != Query::NONE.number() {
            job.closed.push((stuck.query, stuck.mesh));
        }
        return is_new;
    }
    // Where a mesh is not assembled no law is asked.
    let left = if is_family { vec![number("growth")] } else { asked_on_meshes() };
    let Some(cause) = results.findings.get(&assembly).cloned() else { return false };
    for law in left {
        let found = format!("{}, so this law is not asked from that mesh on", cause.found);
        results.find(Finding { law, found, ..cause.clone() });
    }
    let goes_on = is_family && !job.shut.contains(&number("growth"));
    job.shut.push(number("growth"));
    goes_on
}

/// The laws that need a kernel over a mesh.
fn asked_on_meshes() -> Vec<u32> {
    let others = ["refusal", "assembly", "capacity", "size"].map(number);
    (0..LAWS.len() as u32).filter(|law| !others.contains(law)).collect()
}

/// A run that is over.
struct Run {
    events: Vec<Event>,
    status: Option<ExitStatus>,
    words: String,
}

impl Run {
    fn begin(folder: &Path, arguments: &Arguments, job: &Job) -> Result<Self, String> {
        let told = |error: std::io::Error| {
            format!(
                "the laws can't be asked in a process of their own: {error}; MESHMEND_IN_PROCESS=1 asks them in this one"
            )
        };
        for old in [EVENTS, PLACE] {
            // What is not there need not go.
            let _ = fs::remove_file(folder.join(old));
        }
        let job_text = serde_json::to_string(job).map_err(|error| error.to_string())?;
        fs::write(folder.join(JOB), job_text).map_err(told)?;
        let child = Command::new(std::env::current_exe().map_err(told)?)
            .args(arguments)
            .env(RUN, folder)
            .env("RAYON_NUM_THREADS", "1")
            .env("RUST_BACKTRACE", "0")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(File::create(folder.join(WORDS)).map_err(told)?)
            .spawn()
            .map_err(told)?;
        // Whoever watches inside the child ends it first.
        let longest = Duration::from_millis(job.patience).saturating_mul(61) + Duration::from_secs(20);
        let status = awaited(child, longest);
        let lines = fs::read_to_string(folder.join(EVENTS)).unwrap_or_default();
        let events: Vec<Event> = lines.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        let words = fs::read(folder.join(WORDS)).unwrap_or_default();
        let run = Run { events, status, words: String::from_utf8_lossy(&words).into_owned() };
        if run.events.is_empty() {
            return Err(format!(
                "the process that should ask the laws did not ({}): {}",
                run.end().1,
                run.words
            ));
        }
        Ok(run)
    }

    fn is_done(&self) -> bool {
        self.events.iter().any(|event| matches!(event, Event::Done { .. }))
    }

    fn stuck(&self) -> Option<Stuck> {
        self.events.iter().find_map(|event| match *event {
            Event::Stuck { law, mesh, query } => Some(Stuck { law, mesh, query }),
            _ => None,
        })
    }

    fn last_mesh(&self) -> Option<u32> {
        self.events.iter().rev().find_map(|event| match event {
            Event::At(mesh) => Some(*mesh),
            _ => None,
        })
    }

    /// How it ended, in words.
    fn end(&self) -> (Manner, String) {
        if self.words.contains("memory allocation of") {
            (Manner::Hangs, "takes memory without end".to_owned())
        } else if self.words.contains("overflowed its stack") {
            (Manner::Panics, "calls itself until its stack is full".to_owned())
        } else if let Some(words) = self.words.split("panicked at ").nth(1) {
            (Manner::Panics, format!("panics: {}", words.trim_end()))
        } else if let Some(status) = self.status {
            (Manner::Panics, format!("ends the process ({status})"))
        } else {
            (Manner::Hangs, "does not come back".to_owned())
        }
    }
}

/// Waits for a child, and ends one that takes too long; `None` for such a one.
fn awaited(mut child: Child, longest: Duration) -> Option<ExitStatus> {
    let begun = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) if begun.elapsed() < longest => thread::sleep(Duration::from_millis(3)),
            _ => {
                // A child that is gone already can't be ended, and need not be.
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
        }
    }
}
