//! A picture as SVG.

use std::fmt::Write as _;
use std::io::{self, Write};

use meshmend_core::{FaceId, Id};

use crate::depth::buffer::NOTHING;
use crate::depth::visibility::Polylines;
use crate::look::appearance::{Colour, Ink, TEXT};
use crate::output::draw::{Anchor, Sheet, draw};
use crate::panels::panel::Panel;
use crate::pictures::picture::Picture;

impl Picture {
    /// Writes the picture as SVG, of the same content. Faces of which no sample is seen are left out, and the others
    /// are drawn from the farthest middle to the nearest, so that where a large face passes over and under its
    /// neighbours a wrong one may cover the other; PNG has no such limit. Lines are cut as in PNG.
    ///
    /// # Errors
    /// When writing fails.
    ///
    /// *Cost*: O(n log n) for n seen faces, and what the lines have of points.
    pub fn write_svg(&self, out: &mut dyn Write) -> io::Result<()> {
        let (width, height) = (self.size.width(), self.size.height());
        let mut svg = Svg(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
        ));
        draw(self, &mut svg);
        svg.0.push_str("</svg>\n");
        out.write_all(svg.0.as_bytes())?;
        out.flush()
    }
}

struct Svg(String);

/// The border of a face in its own colour, in pixels: without it light shines through between neighbours.
const FACE_BORDER: &str = "0.6";

impl Svg {
    fn push(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing to a string can't fail.
        self.0.write_fmt(text).ok();
    }

    /// A path's points as `M…L…`.
    fn points(&mut self, points: impl Iterator<Item = [f64; 2]>) {
        for (place, [x, y]) in points.enumerate() {
            self.0.push(if place == 0 { 'M' } else { ' ' });
            self.number(x);
            self.0.push(' ');
            self.number(y);
        }
    }

    /// A length to a hundredth of a pixel.
    fn number(&mut self, value: f64) {
        let hundredths = (value * 100.0).round() as i64;
        let (sign, whole, rest) = (
            if hundredths < 0 { "-" } else { "" },
            hundredths.unsigned_abs() / 100,
            hundredths.unsigned_abs() % 100,
        );
        match rest {
            0 => self.push(format_args!("{sign}{whole}")),
            rest if rest % 10 == 0 => self.push(format_args!("{sign}{whole}.{}", rest / 10)),
            rest => self.push(format_args!("{sign}{whole}.{rest:02}")),
        }
    }

    fn colour(&mut self, [red, green, blue]: Colour) {
        self.push(format_args!("#{red:02x}{green:02x}{blue:02x}"));
    }

    fn escaped(&mut self, text: &str) {
        self.0.push_str(&escaped(text));
    }
}

/// A text without what XML does not allow or takes for markup.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::new();
    for character in meshmend_core::printable(text).chars() {
        match character {
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '&' => safe.push_str("&amp;"),
            '\u{fffe}' | '\u{ffff}' => safe.push(char::REPLACEMENT_CHARACTER),
            other => safe.push(other),
        }
    }
    safe
}

impl Sheet for Svg {
    /// Faces from the farthest middle to the nearest; those that own no sample are covered by others.
    fn faces(&mut self, panel: &Panel) {
        let faces = panel.mesh.complex().faces();
        let mut last_colour = None;
        self.push(format_args!(
            "<g stroke-width=\"{FACE_BORDER}\" stroke-linejoin=\"round\" fill-rule=\"evenodd\">"
        ));
        for face in far_to_near(panel) {
            let colour = panel.tones[face.index()].colour;
            if last_colour != Some(colour) {
                self.0.push_str(if last_colour.is_some() { "\"/>\n" } else { "\n" });
                self.0.push_str("<path fill=\"");
                self.colour(colour);
                self.0.push_str("\" stroke=\"");
                self.colour(colour);
                self.0.push_str("\" d=\"");
            }
            last_colour = Some(colour);
            let corners = faces.face_vertices(face).iter().map(|v| panel.placed[v.index()]);
            self.points(corners.map(|[x, y, _]| [x + panel.place.left, y + panel.place.top]));
            self.0.push('Z');
        }
        self.0.push_str(if last_colour.is_some() { "\"/>\n</g>\n" } else { "</g>\n" });
    }

    fn stroke(&mut self, ink: Ink, paths: &Polylines) {
        if paths.is_empty() {
            return;
        }
        self.0.push_str("<path fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke=\"");
        self.colour(ink.colour);
        self.0.push_str("\" stroke-width=\"");
        self.number(ink.width);
        if !ink.dashes.is_empty() {
            let lengths: Vec<String> = ink.dashes.iter().map(|length| length.to_string()).collect();
            self.push(format_args!("\" stroke-dasharray=\"{}", lengths.join(" ")));
        }
        self.0.push_str("\" d=\"");
        paths.iter().for_each(|path| self.points(path.iter().copied()));
        self.0.push_str("\"/>\n");
    }

    fn disc(&mut self, middle: [f64; 2], radius: f64, colour: Colour) {
        self.0.push_str("<circle cx=\"");
        self.number(middle[0]);
        self.0.push_str("\" cy=\"");
        self.number(middle[1]);
        self.0.push_str("\" r=\"");
        self.number(radius);
        self.0.push_str("\" fill=\"");
        self.colour(colour);
        self.0.push_str("\"/>\n");
    }

    fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour) {
        self.0.push_str("<path fill=\"");
        self.colour(colour);
        self.0.push_str("\" d=\"");
        self.points(corners.iter().copied());
        self.0.push_str("Z\"/>\n");
    }

    fn text(&mut self, at: [f64; 2], anchor: Anchor, text: &str) {
        if text.is_empty() {
            return;
        }
        self.0.push_str("<text x=\"");
        self.number(at[0]);
        self.0.push_str("\" y=\"");
        // The middle of small letters is above their foot by this much.
        self.number(at[1] + 5.0);
        self.0.push_str(if anchor == Anchor::Middle { "\" text-anchor=\"middle" } else { "" });
        self.0.push_str("\" fill=\"");
        self.colour(TEXT);
        self.0.push_str("\">");
        self.escaped(text);
        self.0.push_str("</text>\n");
    }
}

/// The faces of which a sample is seen, in painter's order.
fn far_to_near(panel: &Panel) -> Vec<FaceId> {
    let faces = panel.mesh.complex().faces();
    let mut is_seen = vec![false; faces.face_count()];
    let owners = panel.buffer.owners().iter().filter(|&&owner| owner != NOTHING);
    owners.for_each(|&owner| is_seen[owner as usize] = true);
    let nearness = |face: FaceId| {
        let vertices = faces.face_vertices(face);
        vertices.iter().map(|v| panel.placed[v.index()][2]).sum::<f64>() / vertices.len() as f64
    };
    let seen = faces.faces().filter(|face| is_seen[face.index()]);
    let mut order: Vec<(f64, FaceId)> = seen.map(|face| (nearness(face), face)).collect();
    // Of equally near ones the lower is seen, as it is in the depth buffer.
    order.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(other.1.cmp(&one.1)));
    order.into_iter().map(|(_, face)| face).collect()
}
