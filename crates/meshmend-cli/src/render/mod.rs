//! Reports in words, for people. Nothing else formats text for them, and nothing here looks at a mesh.

mod advice;
mod byte_bars;
mod check;
mod conversion;
mod explained_on;
mod geometry;
mod glossary;
mod incremental;
mod kernel;
mod kernels;
mod lesson;
mod loops;
mod matrix;
mod paper_tables;
mod parts;
#[cfg(feature = "render")]
mod picture;
mod pictured;
mod pointers;
mod repair;
mod shapes;
mod step_plot;
mod style;
mod table;
#[cfg(feature = "flatten")]
mod unfolded;

pub(crate) use advice::{advice, advice_plot};
pub(crate) use byte_bars::byte_bars;
pub(crate) use check::check;
pub(crate) use conversion::conversion;
pub(crate) use explained_on::{defects_on, word_on};
pub(crate) use glossary::{defect_heading, explanation, glossary};
pub(crate) use incremental::incremental;
pub(crate) use kernel::{KernelOn, kernel};
pub(crate) use kernels::{Trial, kernel_times, kernels, trials};
pub(crate) use lesson::lesson;
pub(crate) use loops::{cut, loops};
pub(crate) use matrix::matrix;
pub(crate) use paper_tables::paper_tables;
pub(crate) use parts::{checked_parts, repaired_parts};
#[cfg(feature = "render")]
pub(crate) use picture::picture;
pub(crate) use pictured::pictured;
pub(crate) use pointers::{element_counts, permutations, records};
pub(crate) use repair::{repair, summary};
pub(crate) use shapes::{shape, shapes};
pub(crate) use step_plot::step_plot;
pub(crate) use style::Style;
#[cfg(feature = "flatten")]
pub(crate) use unfolded::unfolded;

pub(crate) use meshmend::mesh::printable;
use meshmend::report::Listing;
use meshmend::{Defect, DefectKind};
use std::collections::BTreeMap;

/// Stands where a figure is not defined.
const ABSENT: &str = "–";

/// `non-manifold edges: 3, pinched vertices: 1`.
fn kinds_with_counts(counts: impl Iterator<Item = (DefectKind, u64)>) -> String {
    let parts: Vec<String> = counts.map(|(kind, count)| format!("{}: {count}", kind.title())).collect();
    parts.join(", ")
}

/// How often each kind is in a record.
fn counts(listings: &BTreeMap<DefectKind, Listing<Defect>>) -> impl Iterator<Item = (DefectKind, u64)> + '_ {
    listings.iter().map(|(&kind, listing)| (kind, listing.count))
}

/// A figure, or the sign for an absent one.
fn figure(value: Option<impl ToString>) -> String {
    value.map_or(ABSENT.to_owned(), |value| value.to_string())
}

/// A number that adds to another, with its sign.
fn change(value: i64) -> String {
    if value == 0 { "0".to_owned() } else { format!("{value:+}") }
}

fn yes_no(answer: bool) -> &'static str {
    if answer { "yes" } else { "no" }
}

/// How many items of a list are not shown, if there are more.
fn rest<T>(listing: &Listing<T>) -> Option<String> {
    let hidden = listing.count - listing.items.len() as u64;
    (hidden > 0).then(|| format!("… and {hidden} more"))
}

/// A headed paragraph of indented lines; empty if there are no lines.
fn paragraph(heading: &str, lines: impl IntoIterator<Item = String>) -> String {
    let lines: Vec<String> = lines.into_iter().map(|line| format!("  {line}\n")).collect();
    if lines.is_empty() { String::new() } else { format!("\n{heading}\n{}", lines.concat()) }
}
