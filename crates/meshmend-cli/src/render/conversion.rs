//! What a conversion did.

use meshmend::Loss;
use meshmend::formats::Document;
use meshmend::mesh::{Counts, counted};

use super::{paragraph, printable};

/// One line, and what was lost.
pub(crate) fn conversion(input: &str, output: &str, document: &Document, losses: &[Loss]) -> String {
    let of_parts = |count: fn(&Counts) -> usize| -> usize {
        document.parts.iter().map(|part| count(&part.mesh.counts())).sum()
    };
    let (input, output) = (printable(input), printable(output));
    let mut page = format!(
        "{input} → {output}: {}, {}\n",
        counted(of_parts(|counts| counts.vertices), "vertex"),
        counted(of_parts(|counts| counts.faces), "face")
    );
    let losses = losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph("what the output can't carry", losses));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph("notes of the reader", notes));
    page
}
