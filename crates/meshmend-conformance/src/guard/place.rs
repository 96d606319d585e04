//! Where a run is: on which mesh, under which law, and what the kernel is asked.

use std::fs::File;
use std::io::{Seek, Write};
use std::panic::resume_unwind;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use super::query::Query;

/// Where a run is, to be read by whoever watches it.
#[derive(Debug, Default)]
pub(crate) struct Place {
    /// The mesh in the upper half, the law in the lower one; and how often these were set.
    mesh_and_law: AtomicU64,
    ticks: AtomicU64,
    /// The question in the upper half, the element in the lower one.
    question: AtomicU64,
    /// The questions that are not asked any more, one bit each.
    closed: AtomicU64,
    /// Where each step is written down before it is taken, if anywhere.
    record: Option<Mutex<File>>,
}

/// A place in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct At {
    /// The number of the mesh.
    pub(crate) mesh: u32,
    /// The number of the law.
    pub(crate) law: u32,
    /// What the kernel was asked, and about which element.
    pub(crate) query: Query,
    pub(crate) element: u32,
}

/// What a question that is not asked any more panics with.
pub(crate) struct Closed(pub(crate) Query);

impl Place {
    /// A place that writes each step into a file.
    pub(crate) fn recorded(file: File) -> Self {
        Place { record: Some(Mutex::new(file)), ..Place::default() }
    }

    /// Goes on to a mesh and a law, from where on these questions are not asked any more.
    pub(crate) fn go_on(&self, mesh: u32, law: u32, closed: u64) {
        self.mesh_and_law.store(u64::from(mesh) << 32 | u64::from(law), Relaxed);
        self.closed.store(closed, Relaxed);
        self.question.store(0, Relaxed);
        self.ticks.fetch_add(1, Relaxed);
        self.write_down();
    }

    /// Says that the run is alive.
    pub(crate) fn tick(&self) {
        self.ticks.fetch_add(1, Relaxed);
    }

    pub(crate) fn ticks(&self) -> u64 {
        self.ticks.load(Relaxed)
    }

    /// Notes what the kernel is asked next.
    #[inline]
    pub(crate) fn ask(&self, query: Query, element: u32) {
        self.question.store(u64::from(query.number()) << 32 | u64::from(element), Relaxed);
        if self.closed.load(Relaxed) >> query.number() & 1 == 1 {
            resume_unwind(Box::new(Closed(query)));
        }
        if self.record.is_some() {
            self.write_down();
        }
    }

    pub(crate) fn at(&self) -> At {
        At::of_words([self.mesh_and_law.load(Relaxed), self.question.load(Relaxed)])
    }

    fn write_down(&self) {
        let Some(mut file) = self.record.as_ref().and_then(|file| file.lock().ok()) else { return };
        let words = [self.mesh_and_law.load(Relaxed), self.question.load(Relaxed)];
        // What can't be written down is found on the way that was.
        let _ = file.rewind().and_then(|()| file.write_all(words.map(u64::to_le_bytes).as_flattened()));
    }
}

impl At {
    /// The place that was written down last.
    pub(crate) fn written(bytes: &[u8]) -> Option<Self> {
        let word = |at: usize| Some(u64::from_le_bytes(bytes.get(at..at + 8)?.try_into().ok()?));
        Some(At::of_words([word(0)?, word(8)?]))
    }

    fn of_words([mesh_and_law, question]: [u64; 2]) -> Self {
        let halves = |word: u64| ((word >> 32) as u32, word as u32);
        let ((mesh, law), (query, element)) = (halves(mesh_and_law), halves(question));
        At { mesh, law, query: Query::of_number(query as u8), element }
    }
}
