//! Pixels, and lines, polygons and text on them with smooth borders.

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

use crate::depth::visibility::step_length;
use crate::look::appearance::{Colour, Ink, PAPER, mixed};

/// A picture's pixels.
pub(crate) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<Colour>,
    /// How much of each pixel is covered by what is being drawn.
    covered: Vec<u8>,
    /// The pixels with some cover, each once.
    touched: Vec<u32>,
}

/// How far a character is from the next, in pixels.
const ADVANCE: usize = get_raster_width(FontWeight::Regular, TEXT_HEIGHT);

const TEXT_HEIGHT: RasterHeight = RasterHeight::Size16;

/// What stands for a character that the font does not have.
const UNKNOWN: char = '?';

/// How wide a text is, in pixels.
pub(crate) fn text_width(text: &str) -> f64 {
    (text.chars().count() * ADVANCE) as f64
}

impl Canvas {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Canvas { width, height, pixels: vec![PAPER; count], covered: vec![0; count], touched: Vec::new() }
    }

    pub(crate) fn into_pixels(self) -> Vec<Colour> {
        self.pixels
    }

    pub(crate) fn set(&mut self, x: usize, y: usize, colour: Colour) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = colour;
        }
    }

    /// Draws paths as one: where they cross, a pixel is covered once.
    ///
    /// *Cost*: the pixels covered.
    pub(crate) fn stroke<'a>(&mut self, ink: Ink, paths: impl Iterator<Item = &'a [[f64; 2]]>) {
        for path in paths {
            each_dash(path, ink.dashes, |from, to| self.cover_line(from, to, ink.width / 2.0));
        }
        self.colour_covered(ink.colour);
    }

    /// Fills a disc.
    pub(crate) fn disc(&mut self, middle: [f64; 2], radius: f64, colour: Colour) {
        self.cover_line(middle, middle, radius);
        self.colour_covered(colour);
    }

    /// Fills a convex polygon whose corners go clockwise as seen.
    pub(crate) fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour) {
        let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
            corners.iter().map(|corner| corner[axis]).reduce(pick).unwrap_or(0.0)
        };
        for row in span(bound(1, f64::min) - 1.0, bound(1, f64::max) + 1.0, self.height) {
            for column in span(bound(0, f64::min) - 1.0, bound(0, f64::max) + 1.0, self.width) {
                let outside = outside_of(corners, [column as f64 + 0.5, row as f64 + 0.5]);
                self.cover(column, row, 0.5 - outside);
            }
        }
        self.colour_covered(colour);
    }

    /// Writes a text from the left; the place is at the middle of its height.
    pub(crate) fn text(&mut self, middle_left: [f64; 2], text: &str, colour: Colour) {
        let top = (middle_left[1] - f64::from(TEXT_HEIGHT.val() as u32) / 2.0).round().max(0.0) as usize;
        let left = middle_left[0].round().max(0.0) as usize;
        for (place, character) in text.chars().enumerate() {
            let glyph = get_raster(character, FontWeight::Regular, TEXT_HEIGHT);
            let unknown = || get_raster(UNKNOWN, FontWeight::Regular, TEXT_HEIGHT);
            let Some(glyph) = glyph.or_else(unknown) else { continue };
            for (row, line) in glyph.rows().enumerate() {
                for (column, &value) in line.iter().enumerate() {
                    self.cover(left + place * ADVANCE + column, top + row, f64::from(value) / 255.0);
                }
            }
        }
        self.colour_covered(colour);
    }

    fn cover_line(&mut self, from: [f64; 2], to: [f64; 2], reach: f64) {
        let border = reach + 1.0;
        let way = [to[0] - from[0], to[1] - from[1]];
        let square = way[0] * way[0] + way[1] * way[1];
        // What is thinner than a pixel is drawn as wide as one, and paler.
        let (half, strength) = if reach < 0.5 { (0.5, 2.0 * reach) } else { (reach, 1.0) };
        for row in span(from[1].min(to[1]) - border, from[1].max(to[1]) + border, self.height) {
            let y = row as f64 + 0.5;
            let [first, last] = columns_near(from, way, y, border);
            for column in span(first - border, last + border, self.width) {
                if self.is_covered(column, row) {
                    continue;
                }
                let off = [column as f64 + 0.5 - from[0], y - from[1]];
                let along = if square > 0.0 { (off[0] * way[0] + off[1] * way[1]) / square } else { 0.0 };
                let along = along.clamp(0.0, 1.0);
                let distance = (off[0] - along * way[0]).hypot(off[1] - along * way[1]);
                self.cover(column, row, (half + 0.5 - distance).min(1.0) * strength);
            }
        }
    }

    /// Whether a pixel can't be covered more than it is, as where very many lines cross.
    fn is_covered(&self, column: usize, row: usize) -> bool {
        column < self.width && row < self.height && self.covered[row * self.width + column] == u8::MAX
    }

    fn cover(&mut self, column: usize, row: usize, part: f64) {
        let part = (part.clamp(0.0, 1.0) * 255.0).round() as u8;
        if part == 0 || column >= self.width || row >= self.height {
            return;
        }
        let pixel = row * self.width + column;
        if self.covered[pixel] == 0 {
            self.touched.push(pixel as u32);
        }
        self.covered[pixel] = self.covered[pixel].max(part);
    }

    fn colour_covered(&mut self, colour: Colour) {
        for pixel in self.touched.drain(..) {
            let (pixel, part) = (pixel as usize, f64::from(self.covered[pixel as usize]) / 255.0);
            self.pixels[pixel] = mixed(self.pixels[pixel], colour, part);
            self.covered[pixel] = 0;
        }
    }
}

/// The whole numbers from one place to another, within `0..end`.
fn span(from: f64, to: f64, end: usize) -> std::ops::Range<usize> {
    // Casting puts what is below zero to zero.
    (from.floor() as usize).min(end)..(to.ceil() as usize).min(end)
}

/// Where the part of a line that is within a border of a height begins and ends, from left to right.
fn columns_near(from: [f64; 2], way: [f64; 2], y: f64, border: f64) -> [f64; 2] {
    let part = |y: f64| if way[1] == 0.0 { f64::NAN } else { ((y - from[1]) / way[1]).clamp(0.0, 1.0) };
    let (above, below) = (part(y - border), part(y + border));
    if above.is_nan() {
        return [from[0].min(from[0] + way[0]), from[0].max(from[0] + way[0])];
    }
    let (one, other) = (from[0] + above * way[0], from[0] + below * way[0]);
    [one.min(other), one.max(other)]
}

/// How far a place is outside of a convex polygon that goes clockwise as seen; less than zero inside.
fn outside_of(corners: &[[f64; 2]], place: [f64; 2]) -> f64 {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let distances = sides.map(|(from, to)| {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = way[0].hypot(way[1]).max(f64::MIN_POSITIVE);
        ((place[0] - from[0]) * way[1] - (place[1] - from[1]) * way[0]) / length
    });
    distances.fold(f64::NEG_INFINITY, f64::max)
}

/// Each dash of a path, straight piece by straight piece. The pattern begins anew with each path.
fn each_dash(path: &[[f64; 2]], dashes: &[f64], mut draw: impl FnMut([f64; 2], [f64; 2])) {
    if dashes.is_empty() {
        path.windows(2).for_each(|pair| draw(pair[0], pair[1]));
        return;
    }
    let (mut part, mut rest) = (0, dashes[0]);
    for pair in path.windows(2) {
        let length = step_length(pair);
        let at = |distance: f64| {
            let along = if length > 0.0 { distance / length } else { 0.0 };
            [0, 1].map(|axis| pair[0][axis] + (pair[1][axis] - pair[0][axis]) * along)
        };
        let mut walked = 0.0;
        while walked + rest <= length {
            if part % 2 == 0 {
                draw(at(walked), at(walked + rest));
            }
            walked += rest;
            part = (part + 1) % dashes.len();
            rest = dashes[part];
        }
        if part % 2 == 0 && walked < length {
            draw(at(walked), at(length));
        }
        rest -= length - walked;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Colour = [0, 0, 0];

    fn dark(canvas: &Canvas) -> Vec<(usize, usize)> {
        let dark = canvas.pixels.iter().enumerate().filter(|(_, colour)| colour[0] < 128);
        dark.map(|(pixel, _)| (pixel % canvas.width, pixel / canvas.width)).collect()
    }

    fn ink(width: f64, dashes: &'static [f64]) -> Ink {
        Ink { colour: INK, width, dashes }
    }

    #[test]
    fn a_line_covers_the_pixels_within_half_its_width() {
        let mut canvas = Canvas::new(20, 9);
        canvas.stroke(ink(3.0, &[]), std::iter::once(&[[5.0, 4.5], [15.0, 4.5]][..]));
        let dark = dark(&canvas);
        assert!((5..15).all(|x| (3..6).all(|y| dark.contains(&(x, y)))));
        assert!(dark.iter().all(|&(x, y)| (3..17).contains(&x) && (3..6).contains(&y)));
    }

    #[test]
    fn a_steep_line_is_without_gaps() {
        let mut canvas = Canvas::new(30, 30);
        canvas.stroke(ink(2.0, &[]), std::iter::once(&[[3.0, 2.0], [9.0, 28.0]][..]));
        let rows: std::collections::BTreeSet<_> = dark(&canvas).iter().map(|pixel| pixel.1).collect();
        assert!((2..28).all(|row| rows.contains(&row)));
    }

    #[test]
    fn dashes_go_on_round_corners() {
        let path = [[0.0, 0.0], [3.0, 0.0], [3.0, 7.0]];
        let mut drawn = Vec::new();
        each_dash(&path, &[4.0, 2.0], |from, to| drawn.push((from, to)));
        assert_eq!(drawn, [([0.0, 0.0], [3.0, 0.0]), ([3.0, 0.0], [3.0, 1.0]), ([3.0, 3.0], [3.0, 7.0])]);
        drawn.clear();
        each_dash(&path, &[], |from, to| drawn.push((from, to)));
        assert_eq!(drawn.len(), 2);
    }

    #[test]
    fn dots_are_dashes_of_no_length() {
        let mut dots = 0;
        each_dash(&[[0.0, 0.0], [10.0, 0.0]], &[0.0, 5.0], |from, to| dots += usize::from(from == to));
        assert_eq!(dots, 3);
    }

    #[test]
    fn polygons_and_discs_have_their_areas() {
        let mut canvas = Canvas::new(20, 20);
        canvas.polygon(&[[4.0, 4.0], [10.0, 4.0], [10.0, 8.0], [4.0, 8.0]], INK);
        assert_eq!(dark(&canvas).len(), 24);
        let mut canvas = Canvas::new(20, 20);
        canvas.disc([10.0, 10.0], 5.0, INK);
        let area = dark(&canvas).len() as f64;
        assert!((area - std::f64::consts::PI * 25.0).abs() < 6.0, "{area}");
    }

    #[test]
    fn text_is_drawn_within_its_characters_and_past_the_border_not_at_all() {
        let mut canvas = Canvas::new(40, 20);
        canvas.text([2.0, 10.0], "H", INK);
        let dark = dark(&canvas);
        assert!(!dark.is_empty() && dark.iter().all(|&(x, _)| (2..2 + ADVANCE).contains(&x)));
        let [mut unknown, mut question] = [Canvas::new(40, 20), Canvas::new(40, 20)];
        unknown.text([2.0, 10.0], "\u{3a9}", INK);
        question.text([2.0, 10.0], "?", INK);
        assert_eq!(unknown.pixels, question.pixels);
        canvas.text([-50.0, -50.0], "far away and longer than the canvas is wide", INK);
        canvas.stroke(ink(3.0, &[]), std::iter::once(&[[-500.0, 4.5], [900.0, 4.5]][..]));
    }

    #[test]
    fn a_line_thinner_than_a_pixel_is_pale() {
        let mut canvas = Canvas::new(10, 5);
        canvas.stroke(ink(0.5, &[]), std::iter::once(&[[0.0, 2.5], [10.0, 2.5]][..]));
        assert_eq!(canvas.pixels[2 * 10 + 5], [127, 127, 127]);
    }
}
