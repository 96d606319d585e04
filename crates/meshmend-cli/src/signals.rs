//! Signals that ask the program to end: what it is writing goes first.

/// From now on a process that is asked to end (by SIGINT, SIGTERM or SIGHUP) removes the files that it has begun and that
/// have not taken the place of their targets, and then ends as it would have ended by that signal. A signal that the
/// process was started to ignore is still ignored.
///
/// For the program alone. Where no thread can be started to wait for signals, they end the process as ever, and the next
/// run removes what was left.
pub fn end_cleanly() {
    #[cfg(unix)]
    unix::wait_in_a_thread();
}

/// Has a command hear the signals that ask the program to end, with their numbers, before they end it. One that it takes over, by
/// `true`, does not.
#[cfg(unix)]
pub(crate) fn hear_first(takes_over: impl Fn(i32) -> bool + Send + 'static) {
    unix::hear_first(Box::new(takes_over));
}

/// Ends the process as a signal does that a command took over.
#[cfg(unix)]
pub(crate) fn end_by(signal: i32) -> ! {
    unix::end_by(signal)
}

/// Returns when the thread that waits for signals does so, if there is one.
#[cfg(unix)]
pub(crate) fn wait_until_heard() {
    unix::wait_until_heard();
}

#[cfg(unix)]
mod unix {
    use std::fs;
    use std::process;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::{Mutex, OnceLock, PoisonError};
    use std::thread;

    use meshmend::formats::abandon_temporary_files;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    /// Waiting takes little.
    const STACK_BYTES: usize = 64 << 10;

    /// What a shell adds to the number of a signal in the status of what it ended.
    const ENDED_BY_A_SIGNAL: i32 = 128;

    /// A command that hears signals first.
    type Hearer = Box<dyn Fn(i32) -> bool + Send>;
    static HEARER: Mutex<Option<Hearer>> = Mutex::new(None);

    pub(super) fn hear_first(hearer: Hearer) {
        *HEARER.lock().unwrap_or_else(PoisonError::into_inner) = Some(hearer);
    }

    /// Whether there is a thread that waits for signals.
    static HAS_THREAD: AtomicBool = AtomicBool::new(false);
    /// Set when it runs.
    static RUNS: OnceLock<()> = OnceLock::new();

    pub(super) fn wait_in_a_thread() {
        let thread = thread::Builder::new().name("signals".to_owned()).stack_size(STACK_BYTES).spawn(wait);
        HAS_THREAD.store(thread.is_ok(), Ordering::Relaxed);
    }

    pub(super) fn wait_until_heard() {
        if HAS_THREAD.load(Ordering::Relaxed) {
            RUNS.wait();
        }
    }

    fn wait() {
        RUNS.get_or_init(|| ());
        let ignored = ignored_signals();
        let is_heard = |signal: &i32| ignored & (1 << (signal - 1)) == 0;
        let Ok(mut signals) =
            Signals::new([SIGHUP, SIGINT, SIGTERM].iter().filter(|signal| is_heard(signal)))
        else {
            return;
        };
        for signal in signals.forever() {
            let hearer = HEARER.lock().unwrap_or_else(PoisonError::into_inner);
            if !hearer.as_ref().is_some_and(|takes_over| takes_over(signal)) {
                end_by(signal);
            }
        }
    }

    pub(super) fn end_by(signal: i32) -> ! {
        abandon_temporary_files(|| {
            emulate_default_handler(signal).ok();
            // The first process of a container is not ended by a signal of its own.
            process::exit(ENDED_BY_A_SIGNAL + signal)
        })
    }

    /// The signals that the process was started to ignore, as bits from that of signal 1 on: all that `nohup` and shells
    /// without job control say. If the system does not say, only SIGHUP counts as ignored, which `nohup` is for.
    fn ignored_signals() -> u64 {
        let told = fs::read_to_string("/proc/self/status").ok().and_then(|status| {
            let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
            u64::from_str_radix(mask.trim(), 16).ok()
        });
        told.unwrap_or(1 << (SIGHUP - 1))
    }
}
