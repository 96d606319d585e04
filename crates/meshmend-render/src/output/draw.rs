//! What is drawn of a picture, in which order, on whatever can be drawn on.

use crate::depth::visibility::Polylines;
use crate::look::appearance::{BACK_SWATCH, Colour, FACE_OUTLINE, HATCHING, Ink, PAPER, TEXT};
use crate::look::legend::{Shape, Swatch};
use crate::panels::layers::{Label, Layer, Mark};
use crate::panels::panel::Panel;
use crate::pictures::layout::{CHARACTER, GAP, LINE, SWATCH};
use crate::pictures::picture::Picture;

/// What can be drawn on; what comes later covers what came before.
pub(crate) trait Sheet {
    /// Draws the faces of a panel.
    fn faces(&mut self, panel: &Panel);
    /// Draws paths as one.
    fn stroke(&mut self, ink: Ink, paths: &Polylines);
    /// Fills a disc.
    fn disc(&mut self, middle: [f64; 2], radius: f64, colour: Colour);
    /// Fills a convex polygon whose corners go clockwise as seen.
    fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour);
    /// Writes a text that begins, or has its middle, at a place.
    fn text(&mut self, at: [f64; 2], anchor: Anchor, text: &str);
}

/// Which part of a text is at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
}

/// Draws a picture.
pub(crate) fn draw(picture: &Picture, sheet: &mut impl Sheet) {
    for (panel, caption) in picture.panels.iter().zip(&picture.captions) {
        draw_panel(sheet, panel);
        let room = ((panel.place.width - GAP) / CHARACTER) as usize;
        let at = [panel.place.left + panel.place.width / 2.0, panel.place.top - picture.caption_height / 2.0];
        sheet.text(at, Anchor::Middle, &shortened(caption, room));
    }
    let top = f64::from(picture.size.height()) - picture.legend_height;
    for (entry, (left, row)) in &picture.legend {
        let middle = top + (row + 0.5) * LINE;
        draw_swatch(sheet, entry.swatch, [*left, middle]);
        sheet.text([left + SWATCH + GAP, middle], Anchor::Start, &entry.text);
    }
}

fn draw_panel(sheet: &mut impl Sheet, panel: &Panel) {
    let origin = [panel.place.left, panel.place.top];
    sheet.faces(panel);
    sheet.stroke(HATCHING, &panel.hatching.moved(origin));
    let (outlines, lines): (Vec<&Layer>, Vec<&Layer>) =
        panel.layers.iter().partition(|layer| layer.ink == FACE_OUTLINE);
    outlines.iter().for_each(|layer| sheet.stroke(layer.ink, &layer.lines.seen.moved(origin)));
    lines.iter().for_each(|layer| sheet.stroke(layer.ink.behind(), &layer.lines.hidden.moved(origin)));
    lines.iter().for_each(|layer| sheet.stroke(layer.ink, &layer.lines.seen.moved(origin)));
    for mark in lines.iter().flat_map(|layer| &layer.marks) {
        draw_mark(sheet, &Mark { at: moved(mark.at, origin), ..*mark });
    }
    for label in lines.iter().flat_map(|layer| &layer.labels).chain(&panel.labels) {
        draw_label(sheet, label, origin);
    }
}

/// A text of at most so many characters.
fn shortened(text: &str, room: usize) -> String {
    if text.chars().count() <= room {
        return text.to_owned();
    }
    text.chars().take(room.saturating_sub(2)).chain("..".chars()).take(room).collect()
}

fn draw_mark(sheet: &mut impl Sheet, mark: &Mark) {
    let ([x, y], reach) = (mark.at, mark.reach);
    match mark.shape {
        Shape::Disc => sheet.disc(mark.at, reach, mark.colour),
        Shape::Square => sheet.polygon(&box_around(mark.at, [reach; 2]), mark.colour),
        Shape::Arrow([along, across]) => {
            let corner = |forth: f64, aside: f64| {
                [x + reach * (forth * along - aside * across), y + reach * (forth * across + aside * along)]
            };
            sheet.polygon(&[corner(1.2, 0.0), corner(-0.9, 0.9), corner(-0.9, -0.9)], mark.colour);
        }
    }
}

/// A number on a disc, or on a rounded box where it is longer.
fn draw_label(sheet: &mut impl Sheet, label: &Label, origin: [f64; 2]) {
    let [x, y] = moved(label.at, origin);
    let half = (label.text.chars().count() as f64 - 1.0) * CHARACTER / 2.0;
    let mut middle_line = Polylines::default();
    [[x - half, y], [x + half, y]].into_iter().for_each(|end| middle_line.push(end));
    middle_line.end();
    for (colour, width) in [(TEXT, 18.0), (PAPER, 16.0)] {
        sheet.stroke(Ink { colour, width, dashes: &[] }, &middle_line);
    }
    sheet.text([x, y], Anchor::Middle, &label.text);
}

fn draw_swatch(sheet: &mut impl Sheet, swatch: Swatch, [left, middle]: [f64; 2]) {
    let centre = [left + SWATCH / 2.0, middle];
    let area = box_around(centre, [SWATCH / 2.0 - 2.0, 6.0]);
    let line = |from: [f64; 2], to: [f64; 2]| {
        let mut line = Polylines::default();
        [from, to].into_iter().for_each(|end| line.push(end));
        line.end();
        line
    };
    let across = line([left + 2.0, middle], [left + SWATCH - 2.0, middle]);
    let mut mark = |shape, reach, colour| draw_mark(sheet, &Mark { shape, at: centre, reach, colour });
    match swatch {
        Swatch::Line(ink) => sheet.stroke(ink, &across),
        Swatch::Mark(shape, colour) => mark(shape, 5.0, colour),
        Swatch::Arrow(ink) => {
            sheet.stroke(ink, &across);
            draw_mark(
                sheet,
                &Mark { shape: Shape::Arrow([1.0, 0.0]), at: centre, reach: 5.5, colour: ink.colour },
            );
        }
        Swatch::Face(colour) => sheet.polygon(&area, colour),
        Swatch::Back => {
            sheet.polygon(&area, BACK_SWATCH);
            for from in [4.0, 10.0, 16.0] {
                let hatch = line([left + from, middle + 6.0], [left + from + 12.0, middle - 6.0]);
                sheet.stroke(HATCHING, &hatch);
            }
        }
        Swatch::None => {}
    }
}

/// The corners of a box, clockwise as seen.
fn box_around([x, y]: [f64; 2], [across, down]: [f64; 2]) -> [[f64; 2]; 4] {
    [[x - across, y - down], [x + across, y - down], [x + across, y + down], [x - across, y + down]]
}

fn moved(at: [f64; 2], origin: [f64; 2]) -> [f64; 2] {
    [at[0] + origin[0], at[1] + origin[1]]
}
