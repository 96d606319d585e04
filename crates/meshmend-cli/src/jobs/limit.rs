//! The limits of a worker: its memory, and the life of who started it.

/// Limits the address space of this process: what it can't get then is an error of the reader, or ends it.
///
/// The program is begun anew under the limit, unless it has it already: an allocator sets address space aside before anything
/// else runs, and what it has can't be taken back.
///
/// # Errors
/// If the system has no such limit, or refuses it.
#[cfg(unix)]
pub(crate) fn limit_address_space(bytes: u64) -> Result<(), String> {
    use std::os::unix::process::CommandExt;
    use std::process::Command;

    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

    let Rlimit { current, maximum } = getrlimit(Resource::As);
    if current.is_some_and(|current| current <= bytes) {
        return Ok(());
    }
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    // A thread that began under the limit might not get its stack.
    crate::signals::wait_until_heard();
    let limit = Rlimit { current: Some(maximum.map_or(bytes, |most| most.min(bytes))), maximum };
    setrlimit(Resource::As, limit).map_err(|error| error.to_string())?;
    let mut words = std::env::args_os();
    let mut again = Command::new(program);
    // By its own name: an interpreter knows by that to which environment it belongs.
    if let Some(name) = words.next() {
        again.arg0(name);
    }
    Err(again.args(words).exec().to_string())
}

/// Says that there is no such limit.
#[cfg(not(unix))]
pub(crate) fn limit_address_space(bytes: u64) -> Result<(), String> {
    Err(format!("this system limits no process to {bytes} bytes"))
}

/// Has this process end with the one that started it, which has this number.
///
/// # Errors
/// If the system refuses it, or that process has ended already.
#[cfg(target_os = "linux")]
pub(crate) fn bind_to(process: u32) -> Result<(), String> {
    use rustix::process::{Signal, getppid, set_parent_process_death_signal};

    set_parent_process_death_signal(Some(Signal::KILL)).map_err(|error| error.to_string())?;
    let is_there =
        getppid().is_some_and(|parent| u32::try_from(parent.as_raw_nonzero().get()) == Ok(process));
    if is_there { Ok(()) } else { Err(format!("process {process} did not start this one, or has ended")) }
}

/// Says that the system can't do that.
#[cfg(not(target_os = "linux"))]
pub(crate) fn bind_to(process: u32) -> Result<(), String> {
    Err(format!("this system binds no process to {process}"))
}
