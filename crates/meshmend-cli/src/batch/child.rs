//! A worker and the pipes to it.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child as Process, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use meshmend::report::Row;

use crate::jobs::{Answer, Job};

/// How much is kept of what a worker says on standard error.
const KEPT: usize = 4096;

/// A worker that waits for jobs. It ends with the value.
pub(crate) struct Child {
    process: Process,
    jobs: Option<ChildStdin>,
    lines: Receiver<String>,
    said: Option<JoinHandle<Vec<u8>>>,
}

/// How a job ended.
pub(crate) enum Ended {
    /// With a row.
    Row(Box<Row>),
    /// Not in time; the worker was killed.
    TooLate,
    /// With the worker, which said this last.
    Died(Option<ExitStatus>, String),
}

impl Child {
    pub(crate) fn start(program: &Path, arguments: &[OsString]) -> io::Result<Self> {
        let mut command = Command::new(program);
        command.arg("worker").args(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // What a terminal sends to the batch is for the batch to pass on.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut process = command.spawn()?;
        let (jobs, answers, errors) = (process.stdin.take(), process.stdout.take(), process.stderr.take());
        let (sender, lines) = channel();
        thread::spawn(move || {
            let lines = answers.into_iter().flat_map(|answers| BufReader::new(answers).lines());
            for line in lines.map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let said = thread::spawn(move || errors.map(last_bytes).unwrap_or_default());
        Ok(Child { process, jobs, lines, said: Some(said) })
    }

    /// Hands in a job, and waits so long for its row. Unless there is one, the worker is dead.
    pub(crate) fn ask(&mut self, job: &Job, patience: Duration) -> Ended {
        let line = serde_json::to_string(job).unwrap_or_default() + "\n";
        let is_sent = self.jobs.as_mut().is_some_and(|jobs| jobs.write_all(line.as_bytes()).is_ok());
        let told =
            if is_sent { self.lines.recv_timeout(patience) } else { Err(RecvTimeoutError::Disconnected) };
        match told.map(|line| serde_json::from_str::<Answer>(&line)) {
            Ok(Ok(answer)) if answer.id == job.id => Ended::Row(Box::new(answer.row)),
            Err(RecvTimeoutError::Timeout) => {
                self.kill();
                self.process.wait().ok();
                Ended::TooLate
            }
            Err(RecvTimeoutError::Disconnected) => self.last_words(),
            Ok(_) => {
                self.kill();
                self.last_words()
            }
        }
    }

    fn last_words(&mut self) -> Ended {
        self.jobs = None;
        let status = self.process.wait().ok();
        let said = self.said.take().and_then(|said| said.join().ok()).unwrap_or_default();
        Ended::Died(status, String::from_utf8_lossy(&said).trim().to_owned())
    }

    /// Kills the worker, and what it may have started.
    fn kill(&mut self) {
        #[cfg(unix)]
        kill_group(self.process.id());
        self.process.kill().ok();
    }

    /// The number of the worker's process, which is that of its group.
    pub(super) fn id(&self) -> u32 {
        self.process.id()
    }

    /// How much memory it has now, where the system tells.
    pub(crate) fn resident(&self) -> Option<u64> {
        let text = std::fs::read_to_string(format!("/proc/{}/statm", self.process.id())).ok()?;
        text.split_whitespace().nth(1)?.parse().ok()
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        // The end of its input ends it.
        self.jobs = None;
        self.process.wait().ok();
    }
}

/// Kills a group of processes.
#[cfg(unix)]
pub(super) fn kill_group(group: u32) {
    use rustix::process::{Pid, Signal, kill_process_group};

    if let Some(group) = i32::try_from(group).ok().and_then(Pid::from_raw) {
        kill_process_group(group, Signal::KILL).ok();
    }
}

/// The last of what a stream says.
fn last_bytes(mut stream: impl Read) -> Vec<u8> {
    let (mut kept, mut block) = (Vec::new(), [0; KEPT]);
    while let Ok(count @ 1..) = stream.read(&mut block) {
        kept.extend_from_slice(block.get(..count).unwrap_or_default());
        let surplus = kept.len().saturating_sub(KEPT);
        kept.drain(..surplus);
    }
    kept
}
