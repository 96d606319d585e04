//! The process in which a kernel's laws are asked.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::event::{Event, Example, Job};
use super::tally::Results;
use super::watch::watch;
use crate::guard::{Place, limit_memory};
use crate::worlds::{FAMILIES, World};

/// In the environment of a child: the folder of its run.
pub(crate) const RUN: &str = "MESHMEND_CONFORMANCE_RUN";
/// The files of a run.
pub(crate) const JOB: &str = "job.json";
pub(crate) const EVENTS: &str = "events.jsonl";
pub(crate) const PLACE: &str = "place";
pub(crate) const WORDS: &str = "stderr";

/// What is asked: a job at a place, over a world, with someone to tell.
pub(crate) type Ask = dyn Fn(&Job, &Arc<Place>, &World, &mut dyn FnMut(Event)) + Send + Sync;

/// The folder of the run, in a child.
pub(crate) fn folder() -> Option<PathBuf> {
    std::env::var_os(RUN).map(PathBuf::from)
}

/// Runs a job, watched and with little memory.
///
/// # Errors
/// When the job can't be read, or nobody can be told.
pub(crate) fn run(folder: &Path, ask: &Ask) -> Result<(), String> {
    let told = |error: std::io::Error| format!("{}: {error}", folder.display());
    let job = fs::read(folder.join(JOB)).map_err(told)?;
    let job: Job = serde_json::from_slice(&job).map_err(|error| error.to_string())?;
    let place = if job.is_recorded {
        Place::recorded(File::create(folder.join(PLACE)).map_err(told)?)
    } else {
        Place::default()
    };
    let place = Arc::new(place);
    let world = Arc::new(World::of(job.effort));
    limit_memory();
    let (watched, is_of_size) = (Arc::clone(&world), job.is_of_size);
    let example = move |mesh| example_of(&watched, mesh, is_of_size);
    watch(&place, Duration::from_millis(job.patience), example, teller(folder).map_err(told)?);
    ask(&job, &place, &world, &mut teller(folder).map_err(told)?);
    Ok(())
}

/// Runs a job in this process, with neither watch nor limit.
pub(crate) fn asked_here(job: &Job, ask: &Ask) -> Results {
    let (place, world, mut results) = (Arc::default(), World::of(job.effort), Results::default());
    ask(job, &place, &world, &mut |event| results.take(event));
    results
}

/// The mesh of a number, as it is shown.
pub(crate) fn example_of(world: &World, mesh: u32, is_of_size: bool) -> Example {
    let past = (mesh as usize).checked_sub(world.len());
    match past.and_then(|past| FAMILIES.get(past)) {
        _ if is_of_size => Example::of_family(format!("mesh {mesh} of those that are measured")),
        Some(family) => Example::of_family(family.said()),
        None => Example::of(&world.mesh(mesh as usize).soup),
    }
}

/// Writes events at the end of the file, each in one piece.
fn teller(folder: &Path) -> std::io::Result<impl FnMut(Event) + Send + use<>> {
    let mut file = OpenOptions::new().append(true).create(true).open(folder.join(EVENTS))?;
    Ok(move |event| {
        if let Ok(mut line) = serde_json::to_string(&event) {
            line.push('\n');
            // Who can't be told reads it off the end of the process.
            let _ = file.write_all(line.as_bytes());
        }
    })
}
