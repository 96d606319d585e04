//! The Betti numbers over the steps in which a mesh is put together, as a drawing.
//!
//! Three plots stand over one another, each with its own height: β₀ counts to the number of vertices where β₂ counts to
//! one. A column of the drawing holds many steps of a large mesh, and shows all values from the least to the greatest
//! there.

use std::fmt::Write;

use meshmend::mesh::counted;
use meshmend::topology::Incremental;

/// The size of each of the three plots, in user units, and what is round them.
const WIDTH: usize = 960;
const HEIGHT: usize = 140;
const LEFT: usize = 70;
const TOP: usize = 50;
const GAP: usize = 40;

/// The curves in the order of their dimensions: name, colour, and what is counted.
const CURVES: [(&str, &str, &str); 3] =
    [("β₀", "#1b6ca8", "components"), ("β₁", "#b3541e", "loops"), ("β₂", "#3a7d44", "voids")];

/// The drawing, as SVG.
pub(crate) fn step_plot(title: &str, built: &Incremental) -> String {
    let steps = built.steps().len();
    let (width, height) = (LEFT + WIDTH + 30, TOP + CURVES.len() * (HEIGHT + GAP) + 10);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{LEFT}\" y=\"24\" font-size=\"15\">{}: {}</text>\n",
        escaped(title),
        counted(steps, "step")
    );
    for (dimension, (name, colour, counted)) in CURVES.iter().enumerate() {
        let columns = Columns::of(built, dimension);
        let top = TOP + dimension * (HEIGHT + GAP);
        let bottom = top + HEIGHT;
        let axes = format!("M{LEFT} {top}V{bottom}H{}", LEFT + WIDTH);
        // Writing to a text can't fail.
        let _ = write!(
            svg,
            "<path d=\"{axes}\" fill=\"none\" stroke=\"#888\"/>\n\
             <text x=\"{LEFT}\" y=\"{}\">{name} ({counted})</text>\n\
             <text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n\
             <text x=\"{}\" y=\"{bottom}\" text-anchor=\"end\">0</text>\n\
             <path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>\n",
            top - 8,
            LEFT - 8,
            top + 10,
            columns.greatest,
            LEFT - 8,
            columns.path(bottom),
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// The values of one number, by columns of the drawing.
struct Columns {
    greatest: u64,
    /// For each column with a step: its place, and the first, least, greatest and last value in it.
    values: Vec<(f64, [u64; 4])>,
}

impl Columns {
    fn of(built: &Incremental, dimension: usize) -> Self {
        let count = built.steps().len();
        let mut columns = Columns { greatest: 0, values: Vec::new() };
        let mut last_column = None;
        for (step, numbers) in built.running_betti().enumerate() {
            let Some(value) = numbers[dimension] else { break };
            columns.greatest = columns.greatest.max(value);
            // As many columns as there are user units, or one a step.
            let column = if count > WIDTH { step * WIDTH / count } else { step };
            let place = column as f64 * WIDTH as f64 / count.min(WIDTH) as f64;
            match columns.values.last_mut().filter(|_| last_column == Some(column)) {
                Some((_, [_, least, greatest, last])) => {
                    (*least, *greatest, *last) = ((*least).min(value), (*greatest).max(value), value);
                }
                None => columns.values.push((place, [value; 4])),
            }
            last_column = Some(column);
        }
        columns
    }

    /// The curve as steps: level to each column, then over all of its values.
    fn path(&self, bottom: usize) -> String {
        let scale = HEIGHT as f64 / self.greatest.max(1) as f64;
        let y = |value: u64| bottom as f64 - value as f64 * scale;
        let mut path = String::new();
        for (place, [first, least, greatest, last]) in &self.values {
            let x = LEFT as f64 + place;
            let _ = if path.is_empty() {
                write!(path, "M{x:.2} {:.2}", y(*first))
            } else {
                write!(path, "H{x:.2}V{:.2}", y(*first))
            };
            if least < greatest {
                let _ = write!(path, "V{:.2}V{:.2}V{:.2}", y(*least), y(*greatest), y(*last));
            }
        }
        if !path.is_empty() {
            let _ = write!(path, "H{}", LEFT + WIDTH);
        }
        path
    }
}

/// A text that stands for itself in XML.
pub(super) fn escaped(text: &str) -> String {
    super::printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use meshmend::mesh::{Connectivity, EdgeUse};
    use meshmend::topology::{incremental, patches};
    use meshmend::{FaceTable, PolygonMesh, VertexId};

    use super::*;

    fn plot(corners: &[u32]) -> String {
        let count = corners.iter().max().map_or(0, |&v| v as usize + 1);
        let table = FaceTable::triangles(count, corners.iter().copied().map(VertexId).collect()).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3]; count], table).unwrap();
        let kernel = EdgeUse::assemble(mesh.complex());
        step_plot("a<b>&c", &incremental(&kernel, &patches(&kernel)))
    }

    #[test]
    fn the_curve_goes_through_each_step() {
        let svg = plot(&[0, 1, 2]);
        assert!(svg.contains("a&lt;b&gt;&amp;c: 7 steps"));
        // β₀ is 1 2 3 2 1 1 1, over a height of 140 from 190 up.
        let numbers =
            [1.0, 2.0, 3.0, 2.0, 1.0, 1.0, 1.0].map(|b: f64| format!("{:.2}", 190.0 - b * 140.0 / 3.0));
        let places =
            [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(|step: f64| format!("{:.2}", 70.0 + step * 960.0 / 7.0));
        let mut path = format!("M{} {}", places[0], numbers[0]);
        places[1..].iter().zip(&numbers[1..]).for_each(|(x, y)| path.push_str(&format!("H{x}V{y}")));
        assert!(svg.contains(&path), "{path}\n{svg}");
    }

    #[test]
    fn large_meshes_make_no_larger_drawings_and_nothing_an_empty_one() {
        let corners: Vec<u32> = (0..30_000).collect();
        let svg = plot(&corners);
        assert!(svg.len() < 200_000 && svg.contains(">10002<"), "{}", svg.len());
        assert!(plot(&[]).contains("d=\"\""));
    }
}
