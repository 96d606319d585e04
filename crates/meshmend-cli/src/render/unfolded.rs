//! A layout in the plane.

use meshmend::FaceId;
use meshmend::mesh::counted;
use meshmend::report::{Listing, UnfoldDocument};

use super::{Style, paragraph, printable};

/// The report on what was laid out.
pub(crate) fn unfolded(document: &UnfoldDocument, style: Style) -> String {
    let [input, output] = [&document.file, &document.output].map(|name| name.as_deref().unwrap_or("mesh"));
    let verdict = match (document.one_to_one, document.flipped.count, document.collapsed.count) {
        (true, ..) => style.good("no face is flipped or has collapsed, exactly"),
        (false, flipped, collapsed) => style.bad(&format!(
            "flipped: {}, collapsed: {}",
            counted(flipped, "face"),
            counted(collapsed, "face")
        )),
    };
    let mut page = format!(
        "{} → {}: {} on a {}, {}\n{verdict}\n",
        style.heading(&printable(input)),
        style.heading(&printable(output)),
        counted(document.discs, "disc"),
        document.boundary,
        document.weights,
    );
    page.push_str(&paragraph(&style.heading("how"), remarks(document)));
    page.push_str(&paragraph(&style.heading("flipped"), faces(&document.flipped)));
    page.push_str(&paragraph(&style.heading("collapsed"), faces(&document.collapsed)));
    let losses = document.losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph(&style.heading("what the output can't carry"), losses));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph("notes of the reader", notes));
    page
}

fn remarks(document: &UnfoldDocument) -> Vec<String> {
    let added = document.stored.after.vertices - document.stored.before.vertices;
    let opened = counted(document.opened_edges, "edge");
    let cut = format!("{opened} opened, {} added", counted(added, "vertex"));
    let evened = format!("weights evened out in {}, for room", counted(document.rounds, "round"));
    let square =
        "on a square what lies between two boundary vertices of one side collapses; a circle has no sides";
    let texcoords = "the texture coordinates that there were have been replaced";
    let remarks = [
        (document.opened_edges > 0, cut),
        (document.rounds > 0, evened),
        (document.collapsed.count > 0 && document.boundary == "square", square.to_owned()),
        (document.replaced_texcoords, texcoords.to_owned()),
    ];
    remarks.into_iter().filter(|(is_so, _)| *is_so).map(|(_, text)| text).collect()
}

fn faces(listing: &Listing<FaceId>) -> Vec<String> {
    let hidden = listing.count - listing.items.len() as u64;
    let more = (hidden > 0).then(|| format!("and {hidden} more (--limit)"));
    listing.items.iter().map(FaceId::to_string).chain(more).collect()
}
