//! What structures take of memory, as a drawing: a bar for each, made of its arrays.

use std::fmt::Write;

use meshmend::mesh::{Array, counted};
use meshmend::report::{KernelTrial, KernelsDocument};

use super::step_plot::escaped;

/// Places and sizes, in user units.
const LEFT: f64 = 170.0;
const WIDTH: f64 = 900.0;
const TOP: f64 = 60.0;
const HEIGHT: f64 = 26.0;
const GAP: f64 = 12.0;

/// The fills of neighbouring arrays, which differ in grey too.
const FILLS: [&str; 3] = ["#c9dcec", "#8fb8d8", "#e8eef3"];

/// The bytes a face of each structure that holds the mesh, by array, as SVG.
pub(crate) fn byte_bars(document: &KernelsDocument) -> String {
    let trials = || document.kernels.iter().chain(&document.views).filter(|trial| !trial.arrays.is_empty());
    let most = trials().filter_map(|trial| trial.bytes_a_face).fold(1.0, f64::max);
    let height = TOP + trials().count() as f64 * (HEIGHT + GAP) + 10.0;
    let file = document.file.as_deref().map(|file| format!("{}: ", escaped(file))).unwrap_or_default();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {height}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
         <text x=\"20\" y=\"28\" font-size=\"15\">{file}bytes a face by array, {}</text>\n",
        LEFT + WIDTH + 80.0,
        counted(document.faces, "face")
    );
    for (place, trial) in trials().enumerate() {
        let top = TOP + place as f64 * (HEIGHT + GAP);
        bar(&mut svg, trial, document.faces, top, WIDTH / most);
    }
    svg.push_str("</svg>\n");
    svg
}

/// A structure's name, its arrays beside one another, and their sum.
fn bar(svg: &mut String, trial: &KernelTrial, faces: usize, top: f64, scale: f64) {
    let middle = top + 0.5 * HEIGHT + 4.5;
    // Writing to a text can't fail.
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{middle:.1}\" text-anchor=\"end\">{}</text>",
        LEFT - 10.0,
        trial.name
    );
    let mut left = LEFT;
    for (place, array) in trial.arrays.iter().filter(|array| array.count > 0).enumerate() {
        let width = scale * array.bytes() as f64 / faces.max(1) as f64;
        let _ = writeln!(
            svg,
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{HEIGHT}\" fill=\"{}\" stroke=\"#456\"{}>\
             <title>{}</title></rect>",
            FILLS[place % FILLS.len()],
            if array.shared { " stroke-dasharray=\"4 3\"" } else { "" },
            said(array)
        );
        // A name is written where there is room for it.
        if width > 7.0 * array.name.chars().count() as f64 {
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{middle:.1}\" font-size=\"11\" text-anchor=\"middle\">{}</text>",
                left + 0.5 * width,
                escaped(array.name)
            );
        }
        left += width;
    }
    let bytes = trial.bytes_a_face.unwrap_or_default();
    let _ = writeln!(svg, "<text x=\"{:.1}\" y=\"{middle:.1}\">{bytes:.1}</text>", left + 8.0);
}

/// `next: 4 bytes a corner`.
fn said(array: &Array) -> String {
    let shared = if array.shared { ", shared with the mesh" } else { "" };
    format!("{}: {} a {}{shared}", escaped(array.name), counted(array.each, "byte"), array.per.name())
}
