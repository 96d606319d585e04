//! Whatever is parsed ahead, and wherever chunks end, the result is that of the sequential reader alone.

use meshmend_core::Watch;

use super::random::Random;
use crate::formats::drivers::driver;
use crate::input::source::Source;
use crate::text::speculative_parse::Pace;
use crate::{Format, Limits};

/// In how many lines there is one that is rare, and one that is wrong.
#[derive(Clone, Copy)]
pub(super) struct Oddity {
    pub(super) rare: usize,
    pub(super) wrong: usize,
}

const ODDITIES: [Oddity; 5] = [
    Oddity { rare: 0, wrong: 0 },
    Oddity { rare: 12, wrong: 0 },
    Oddity { rare: 2, wrong: 0 },
    Oddity { rare: 12, wrong: 30 },
    Oddity { rare: 0, wrong: 40 },
];

/// The result of a reader, down to the bits of each number.
fn outcome(format: Format, text: &str, pace: Pace, limits: &Limits) -> String {
    let source = Source {
        bytes: text.as_bytes(),
        length: text.len(),
        name: "text",
        pace,
        folder: None,
        shared_places: false,
        watch: &Watch::NOBODY,
    };
    match (driver(format).read)(&source, limits) {
        Ok(parsed) => {
            format!("{:?} {:?} {:?}", parsed.parts[0].mesh, parsed.shell.encoding(), parsed.notes.into_list())
        }
        Err(error) => format!("{error:?}"),
    }
}

fn assert_as_alone(format: Format, text: &str, chunks: &[usize]) {
    for limits in limits_of(format, text) {
        let alone = outcome(format, text, Pace::NONE, &limits);
        for &chunk in chunks {
            for chunks in [1, 3] {
                let early = outcome(format, text, Pace { chunk, chunks }, &limits);
                assert_eq!(early, alone, "{chunks} chunks of {chunk} bytes, {limits:?}: {text:?}");
            }
        }
    }
}

/// The usual limits, and for each count what a text has, and one less.
fn limits_of(format: Format, text: &str) -> Vec<Limits> {
    let usual = Limits::default();
    let source = Source {
        bytes: text.as_bytes(),
        length: text.len(),
        name: "text",
        pace: Pace::NONE,
        folder: None,
        shared_places: false,
        watch: &Watch::NOBODY,
    };
    let Ok(parsed) = (driver(format).read)(&source, &usual) else { return vec![usual] };
    let counts = parsed.parts[0].mesh.counts();
    let corners = parsed.parts[0].mesh.faces().corner_count() as u64;
    let [vertices, faces] = [counts.vertices, counts.faces].map(|count| count as u64);
    let exact = Limits { max_vertices: vertices, max_faces: faces, max_corners: corners, ..usual };
    let limits = [
        usual,
        exact,
        Limits { max_vertices: vertices.saturating_sub(1), ..usual },
        Limits { max_faces: faces.saturating_sub(1), ..usual },
        Limits { max_corners: corners.saturating_sub(1), ..usual },
        Limits { max_comments: 1, ..usual },
    ];
    limits.to_vec()
}

/// Texts of every oddity, small ones in tiny chunks and larger ones in small chunks.
pub(super) fn assert_all_as_alone(format: Format, text: impl Fn(&mut Random, usize, Oddity) -> String) {
    let (small, large) = (120, 8);
    let mut random = Random(1);
    for oddity in ODDITIES {
        for _ in 0..small {
            let lines = 1 + random.below(40);
            let text = text(&mut random, lines, oddity);
            assert_as_alone(format, &text, &[1, 2, 5, 17, 64, 300]);
        }
        for _ in 0..large {
            let text = text(&mut random, 1500, oddity);
            assert_as_alone(format, &text, &[1000, 10_000]);
        }
    }
}
