//! Scenes that were drawn, with their captions and the legend.

use meshmend_core::FaceId;

use crate::look::legend::Entry;
use crate::panels::panel::Panel;
use crate::pictures::size::Size;

/// One scene or several, drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    pub(crate) size: Size,
    pub(crate) panels: Vec<Panel>,
    /// What is above each panel.
    pub(crate) captions: Vec<String>,
    pub(crate) caption_height: f64,
    pub(crate) legend_height: f64,
    /// The entries of the legend with their places: to the right in pixels, and the row.
    pub(crate) legend: Vec<(Entry, (f64, f64))>,
}

impl Picture {
    /// Its size.
    pub fn size(&self) -> Size {
        self.size
    }

    /// What the legend says.
    pub fn legend(&self) -> Vec<&str> {
        self.legend.iter().map(|(entry, _)| entry.text.as_str()).collect()
    }

    /// For each scene, the faces that are not drawn because a corner of theirs is not finite, ascending.
    pub fn left_out(&self) -> impl ExactSizeIterator<Item = &[FaceId]> {
        self.panels.iter().map(|panel| panel.left_out.as_slice())
    }
}
