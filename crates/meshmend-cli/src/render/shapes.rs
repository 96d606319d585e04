//! Shapes with known answers.

use meshmend::Loss;
use meshmend::shapes::{NAMED_SHAPES, NamedShape, Shape};

use super::table::{self, Align};
use super::{Style, figure, paragraph, printable, yes_no};

/// The list of shapes with their sizes.
pub(crate) fn shapes(style: Style) -> String {
    let row = |shape: &NamedShape| {
        let sizes = shape.parameters();
        let sizes: Vec<String> = sizes.iter().map(|(size, usual)| format!("--{size} {usual}")).collect();
        vec![shape.name.to_owned(), shape.summary.to_owned(), sizes.join(" ")]
    };
    let rows: Vec<Vec<String>> = NAMED_SHAPES.iter().map(row).collect();
    let lines = table::lines(&rows, &[]);
    paragraph(&style.heading("shapes, with the sizes that they have unless others are given"), lines)
        .trim_start()
        .to_owned()
}

/// What is known of a shape that was written.
pub(crate) fn shape(output: &str, shape: &Shape, losses: &[Loss]) -> String {
    let truth = &shape.truth;
    let betti = truth.betti_z2.map(|number| number.to_string()).join(" ");
    let rows = [
        ("vertices", truth.vertices.to_string()),
        ("edges", truth.edges.to_string()),
        ("faces", truth.faces.to_string()),
        ("Euler characteristic", truth.euler_characteristic().to_string()),
        ("components", truth.components.to_string()),
        ("boundary loops", figure(truth.boundary_loops)),
        ("genus", figure(truth.genus)),
        ("cross-caps", figure(truth.cross_caps)),
        ("Betti numbers mod 2", betti),
        ("Betti numbers over Q", truth.betti_q.map(|number| number.to_string()).join(" ")),
        ("manifold", yes_no(truth.manifold).to_owned()),
        ("orientable", yes_no(truth.orientable).to_owned()),
    ];
    let rows = rows.map(|(label, value)| vec![label.to_owned(), value]);
    let heading = format!("{}: {}", printable(output), shape.name);
    let mut page =
        paragraph(&heading, table::lines(&rows, &[Align::Left, Align::Right])).trim_start().to_owned();
    page.push_str(&paragraph(
        "what the output can't carry",
        losses.iter().map(|loss| printable(&loss.to_string())),
    ));
    page
}
