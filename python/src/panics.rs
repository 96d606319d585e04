//! What a panic in the threads of this package says: kept for the exception, and not printed.

use std::any::Any;
use std::backtrace::Backtrace;
use std::collections::BTreeMap;
use std::panic;
use std::sync::{Mutex, Once};
use std::thread;

use crate::pool;

/// What panics said, by the name of the pool in whose threads they were.
static SAID: Mutex<BTreeMap<String, String>> = Mutex::new(BTreeMap::new());
static KEPT: Once = Once::new();

/// From now on keeps what panics say in threads of this package. Others are told as before.
pub(crate) fn keep() {
    KEPT.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            let thread = thread::current();
            let own = thread.name().filter(|name| name.starts_with(pool::PREFIX));
            let Some(name) = own else { return before(panic) };
            let text = format!("{panic}\n{}", Backtrace::force_capture());
            if let Ok(mut said) = SAID.lock() {
                said.entry(name.to_owned()).or_insert(text);
            }
        }));
    });
}

/// What the first panic in the threads of a pool said.
pub(crate) fn take(pool: &str) -> Option<String> {
    SAID.lock().ok()?.remove(pool)
}

/// The message of a panic.
pub(crate) fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "a panic without a message".to_owned())
}
