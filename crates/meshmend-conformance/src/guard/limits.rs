//! How much memory a process may take, so that a kernel that takes it without end harms no other program.

/// Takes from this process the right to more data than a kernel over small meshes needs.
///
/// Where the system has no such limit, nothing is limited.
#[cfg(unix)]
pub(crate) fn limit_memory() {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

    // What Linux counts as data is what can be written to; reserved addresses are free.
    let kind = if cfg!(target_os = "linux") { Resource::Data } else { Resource::As };
    let most = if cfg!(target_os = "linux") { 160 << 20 } else { 2 << 30 };
    let current = getrlimit(kind).current.map_or(most, |current| current.min(most));
    // A system that does not limit memory leaves a kernel that takes it to the patience.
    let _ = setrlimit(kind, Rlimit { current: Some(current), maximum: Some(current) });
}

#[cfg(not(unix))]
pub(crate) fn limit_memory() {}
