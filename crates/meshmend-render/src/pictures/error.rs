//! Why there is no picture.

use thiserror::Error;

use crate::scenes::overlay::NoSuchElement;

/// Neither side of a picture is shorter than this, in pixels.
pub(crate) const SMALLEST: u32 = 32;

/// Neither side of a picture is longer than this, in pixels.
pub(crate) const LARGEST: u32 = 8192;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RenderError {
    /// A picture can't have that size.
    #[error("a picture of {width}x{height} pixels: each side must be from {SMALLEST} to {LARGEST}")]
    Size {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
    },
    /// The pictures of a sheet would be too small to show anything.
    #[error("{count} pictures do not fit into {width}x{height} pixels")]
    Crowded {
        /// How many there are.
        count: usize,
        /// The width of the sheet.
        width: u32,
        /// The height of the sheet.
        height: u32,
    },
    /// An overlay is for another mesh.
    #[error(transparent)]
    NoSuchElement(#[from] NoSuchElement),
}
