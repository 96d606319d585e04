//! What the work on a file takes, where the system tells.

use std::fs;
use std::time::Instant;

use cpu_time::ProcessTime;
use meshmend::report::Row;

/// What is measured from the beginning of a job on.
pub(crate) struct Meter {
    begin: Instant,
    processor: Option<ProcessTime>,
}

impl Meter {
    pub(crate) fn start() -> Self {
        // From now on the system keeps the most that the process has at once.
        fs::write("/proc/self/clear_refs", "5").ok();
        Meter { begin: Instant::now(), processor: ProcessTime::try_now().ok() }
    }

    /// A row with what the work took.
    pub(crate) fn told_in(&self, row: Row) -> Row {
        let elapsed = |begin: &ProcessTime| begin.try_elapsed().ok().map(|time| time.as_secs_f64());
        Row {
            seconds: self.begin.elapsed().as_secs_f64(),
            cpu_seconds: self.processor.as_ref().and_then(elapsed),
            peak_bytes: peak(),
            ..row
        }
    }
}

/// The most memory that the process has had.
fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes << 10)
}

/// What this machine is called.
pub(crate) fn host() -> String {
    #[cfg(unix)]
    {
        rustix::system::uname().nodename().to_string_lossy().into_owned()
    }
    #[cfg(not(unix))]
    std::env::var("COMPUTERNAME").unwrap_or_default()
}
