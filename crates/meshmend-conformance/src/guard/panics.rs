//! Panics of a kernel, caught without a word on the screen.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use super::place::Closed;
use super::query::Query;

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Stopped {
    /// The kernel panicked, with these words.
    Panicked(String),
    /// It would have been asked a question that did not come back before.
    Closed(Query),
}

thread_local! {
    static IS_CATCHING: Cell<bool> = const { Cell::new(false) };
    static WHERE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Runs what may panic.
///
/// # Errors
/// When it does: the words of the panic, and where in the source it was.
pub(crate) fn caught<T>(run: impl FnOnce() -> T) -> Result<T, Stopped> {
    keep_quiet();
    IS_CATCHING.set(true);
    let answer = catch_unwind(AssertUnwindSafe(run));
    IS_CATCHING.set(false);
    answer.map_err(|payload| stopped(&*payload))
}

fn stopped(payload: &(dyn Any + Send)) -> Stopped {
    if let Some(&Closed(query)) = payload.downcast_ref() {
        return Stopped::Closed(query);
    }
    let words = payload.downcast_ref::<&str>().copied().map(str::to_owned);
    let words = words.or_else(|| payload.downcast_ref::<String>().cloned());
    let place = WHERE.take();
    Stopped::Panicked(words.unwrap_or_else(|| "without a word".to_owned()) + &place)
}

/// While panics are caught, the hook notes where they are; others go on to the hook that there was.
fn keep_quiet() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |info| {
            if !IS_CATCHING.get() {
                return usual(info);
            }
            let place = info.location().map(|place| format!(" ({}:{})", place.file(), place.line()));
            WHERE.set(place.unwrap_or_default());
        }));
    });
}

#[cfg(test)]
#[allow(clippy::panic, reason = "panics are what is tested")]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_its_words_and_its_place() {
        assert_eq!(caught(|| 3), Ok(3));
        let words = |run: fn()| match caught(run) {
            Err(Stopped::Panicked(words)) => words,
            other => format!("{other:?}"),
        };
        assert!(words(|| panic!("no {}", "wing")).starts_with("no wing ("));
        assert!(words(|| panic!("no wing")).contains("panics.rs:"));
        assert!(words(|| std::panic::panic_any(7)).starts_with("without a word"));
        assert_eq!(
            caught(|| std::panic::panic_any(Closed(Query::ACROSS))),
            Err(Stopped::Closed(Query::ACROSS))
        );
    }
}
