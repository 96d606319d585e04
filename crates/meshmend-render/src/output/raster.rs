//! A picture as pixels.

use std::io::{self, Write};

use crate::depth::buffer::NOTHING;
use crate::depth::visibility::Polylines;
use crate::look::appearance::{Colour, Ink, PAPER, TEXT};
use crate::output::canvas::{Canvas, text_width};
use crate::output::draw::{Anchor, Sheet, draw};
use crate::panels::panel::Panel;
use crate::pictures::picture::Picture;

impl Picture {
    /// The colours of the pixels, row by row: red, green and blue.
    ///
    /// *Cost*: the samples, and the pixels that lines cover.
    pub fn pixels(&self) -> Vec<[u8; 3]> {
        let mut canvas = Canvas::new(self.size.width() as usize, self.size.height() as usize);
        draw(self, &mut canvas);
        canvas.into_pixels()
    }

    /// Writes the picture as PNG, eight bits a channel.
    ///
    /// # Errors
    /// When writing fails.
    ///
    /// *Cost*: as [`pixels`](Self::pixels), and compressing them.
    pub fn write_png(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(out, self.size.width(), self.size.height());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels().as_flattened())?;
        Ok(writer.finish()?)
    }
}

impl Sheet for Canvas {
    /// Each pixel is the mean of its samples.
    fn faces(&mut self, panel: &Panel) {
        let (density, columns) = (panel.buffer.density(), panel.buffer.columns());
        let (width, height) = (panel.place.width as usize, panel.place.height as usize);
        let (owners, count) = (panel.buffer.owners(), (density * density) as u32);
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let rows = (0..density).map(|row| (y * density + row) * columns + x * density);
            let mut sum = [count / 2; 3];
            for &owner in rows.flat_map(|start| &owners[start..start + density]) {
                let colour = if owner == NOTHING { PAPER } else { panel.tones[owner as usize].colour };
                sum = [0, 1, 2].map(|part| sum[part] + u32::from(colour[part]));
            }
            let (x, y) = (panel.place.left as usize + x, panel.place.top as usize + y);
            self.set(x, y, sum.map(|part| (part / count) as u8));
        }
    }

    fn stroke(&mut self, ink: Ink, paths: &Polylines) {
        self.stroke(ink, paths.iter());
    }

    fn disc(&mut self, middle: [f64; 2], radius: f64, colour: Colour) {
        self.disc(middle, radius, colour);
    }

    fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour) {
        self.polygon(corners, colour);
    }

    fn text(&mut self, at: [f64; 2], anchor: Anchor, text: &str) {
        let left = match anchor {
            Anchor::Start => at[0],
            Anchor::Middle => at[0] - text_width(text) / 2.0,
        };
        self.text([left, at[1]], text, TEXT);
    }
}
