//! What a conversion did.

use meshmend::mesh::counted;
use meshmend::{Loss, ReadFile};

use super::{paragraph, printable};

/// One line, and what was lost.
pub(crate) fn conversion(input: &str, output: &str, file: &ReadFile, losses: &[Loss]) -> String {
    let counts = file.mesh.counts();
    let (input, output) = (printable(input), printable(output));
    let mut page = format!(
        "{input} → {output}: {}, {}\n",
        counted(counts.vertices, "vertex"),
        counted(counts.faces, "face")
    );
    let losses = losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph("what the output can't carry", losses));
    let notes = file.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph("notes of the reader", notes));
    page
}
