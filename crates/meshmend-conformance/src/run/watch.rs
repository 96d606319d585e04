//! Whoever watches a run: when a law does not come back, that is told and the process ends.

use std::process::abort;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use super::event::{Event, Example, Finding, Manner};
use crate::guard::{At, Place};

/// How often it is looked.
const GLANCE: Duration = Duration::from_millis(5);
/// How many times as long as one law on one mesh the whole run may take.
const ALL_OF_IT: u32 = 60;

/// Watches a run from another thread, which ends with the process.
pub(crate) fn watch(
    place: &Arc<Place>,
    patience: Duration,
    example: impl Fn(u32) -> Example + Send + 'static,
    mut tell: impl FnMut(Event) + Send + 'static,
) {
    let place = Arc::clone(place);
    // Without a thread whoever began the run waits for it, and ends it.
    let _ = thread::Builder::new().spawn(move || {
        let words = stalled(&place, patience);
        let at = place.at();
        tell(Event::Found(hanging(at, example(at.mesh), words)));
        tell(Event::Stuck { law: at.law, mesh: at.mesh, query: at.query.number() });
        abort();
    });
}

/// Comes back when the run does not go on, with words for that.
fn stalled(place: &Place, patience: Duration) -> String {
    let begun = Instant::now();
    let (mut ticks, mut since) = (place.ticks(), begun);
    loop {
        thread::sleep(GLANCE);
        if place.ticks() != ticks {
            (ticks, since) = (place.ticks(), Instant::now());
        }
        if since.elapsed() >= patience {
            return format!("does not come back within {} s", patience.as_secs_f64());
        }
        if begun.elapsed() >= patience * ALL_OF_IT {
            return format!("was still asked after {} s of the run", (patience * ALL_OF_IT).as_secs_f64());
        }
    }
}

/// What is found of a question that has no answer.
pub(crate) fn hanging(at: At, example: Example, words: String) -> Finding {
    let question = at.query.about(at.element).to_string();
    Finding { law: at.law, manner: Manner::Hangs, example, question, found: words, expected: None }
}
