//! Where things are in a picture: panels in a grid, a caption over each, a legend below all.

use crate::look::legend::Entry;
use crate::panels::frame::Rectangle;
use crate::pictures::size::Size;

/// The height of a line of text, in pixels.
pub(crate) const LINE: f64 = 20.0;

/// What a character takes at most, in pixels.
pub(crate) const CHARACTER: f64 = 8.0;

/// The width of the sample before a legend's text.
pub(crate) const SWATCH: f64 = 30.0;

/// Between things, and round the picture.
pub(crate) const GAP: f64 = 8.0;

/// The rectangles of a picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Layout {
    /// One a scene, in rows; whole numbers of pixels.
    pub(crate) panels: Vec<Rectangle>,
    /// How much of the picture's height the legend has.
    pub(crate) legend_height: f64,
    /// How much is above each panel.
    pub(crate) caption_height: f64,
}

impl Layout {
    /// The layout for so many scenes, with room for these entries in the legend and for captions where there are any.
    /// The legend has at most a third of the height. The grid is the one in which what is as wide and high as `shape`
    /// is largest.
    pub(crate) fn new(
        size: Size,
        count: usize,
        shape: [f64; 2],
        entries: &[Entry],
        has_captions: bool,
    ) -> Self {
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        let rows = arranged(entries, width).last().map_or(0.0, |place| place.1 + 1.0);
        let legend_height = (rows * LINE).min((height / 3.0 / LINE).floor() * LINE);
        let caption_height = if has_captions { LINE } else { 0.0 };
        let (columns, rows) = grid(count, [width, height - legend_height], shape, caption_height);
        let across = (width / columns as f64).floor();
        let down = ((height - legend_height) / rows as f64).floor();
        let panel = |k: usize| Rectangle {
            left: (k % columns) as f64 * across,
            top: (k / columns) as f64 * down + caption_height,
            width: across,
            height: down - caption_height,
        };
        Layout { panels: (0..count).map(panel).collect(), legend_height, caption_height }
    }

    /// The smallest side of a panel.
    pub(crate) fn smallest_side(&self) -> f64 {
        self.panels.iter().fold(f64::INFINITY, |least, panel| least.min(panel.width).min(panel.height))
    }
}

/// Columns and rows for so many cells in some room, such that a shape is as large as can be below its caption.
fn grid(count: usize, room: [f64; 2], shape: [f64; 2], caption: f64) -> (usize, usize) {
    // Of what is thin beyond measure the other side decides.
    let longest = shape[0].max(shape[1]).max(f64::MIN_POSITIVE);
    let shape = shape.map(|side| (side / longest).max(1e-3));
    let mut best = (1, count.max(1), f64::NEG_INFINITY);
    for columns in 1..=count.max(1) {
        let rows = count.div_ceil(columns).max(1);
        let (across, down) = (room[0] / columns as f64, room[1] / rows as f64 - caption);
        let scale = (across / shape[0]).min(down / shape[1]);
        if scale > best.2 {
            best = (columns, rows, scale);
        }
    }
    (best.0, best.1)
}

/// Where each entry begins: how far to the right in pixels, and in which row.
pub(crate) fn arranged(entries: &[Entry], width: f64) -> Vec<(f64, f64)> {
    let (mut x, mut row) = (GAP, 0.0);
    let place = |entry: &Entry| {
        let length = SWATCH + GAP + CHARACTER * entry.text.chars().count() as f64;
        if x > GAP && x + length > width - GAP {
            (x, row) = (GAP, row + 1.0);
        }
        let place = (x, row);
        x += length + 2.0 * GAP;
        place
    };
    entries.iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::look::legend::Swatch;

    fn entries(count: usize) -> Vec<Entry> {
        (0..count).map(|k| Entry::new(Swatch::None, format!("entry {k}"))).collect()
    }

    #[test]
    fn panels_lie_in_a_grid_above_the_legend() {
        let layout = Layout::new(Size::new(400, 320).unwrap(), 6, [1.0, 1.0], &entries(3), true);
        assert_eq!((layout.legend_height, layout.caption_height), (20.0, 20.0));
        assert_eq!(layout.panels.len(), 6);
        let last = layout.panels[5];
        assert_eq!(last, Rectangle { left: 266.0, top: 170.0, width: 133.0, height: 130.0 });
        assert_eq!(layout.smallest_side(), 130.0);
    }

    #[test]
    fn a_picture_alone_has_all_the_room() {
        let layout = Layout::new(Size::new(100, 80).unwrap(), 1, [0.0, 0.0], &[], false);
        assert_eq!(layout.panels, [Rectangle { left: 0.0, top: 0.0, width: 100.0, height: 80.0 }]);
    }

    #[test]
    fn pictures_are_side_by_side_where_that_is_larger() {
        let square = |count, room| grid(count, room, [1.0, 1.0], 0.0);
        assert_eq!((square(2, [800.0, 400.0]), square(2, [400.0, 800.0])), ((2, 1), (1, 2)));
        assert_eq!((square(0, [10.0, 10.0]), square(5, [500.0, 100.0])), ((1, 1), (5, 1)));
    }

    #[test]
    fn what_is_broad_gets_broad_places() {
        assert_eq!(grid(4, [400.0, 400.0], [4.0, 1.0], 0.0), (1, 4));
        assert_eq!(grid(4, [400.0, 400.0], [1.0, 4.0], 0.0), (4, 1));
        assert_eq!(grid(4, [400.0, 400.0], [0.0, 0.0], 0.0), (2, 2));
    }

    #[test]
    fn entries_go_on_in_the_next_row_where_they_do_not_fit() {
        let places = arranged(&entries(4), 250.0);
        assert_eq!(places.iter().map(|place| place.1).collect::<Vec<_>>(), [0.0, 0.0, 1.0, 1.0]);
        let layout = Layout::new(Size::new(250, 90).unwrap(), 1, [1.0, 1.0], &entries(40), false);
        assert_eq!(layout.legend_height, 20.0, "the legend leaves room for the picture");
    }
}
