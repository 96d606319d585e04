//! How large a picture is.

use crate::pictures::error::{LARGEST, RenderError, SMALLEST};

/// A picture has no more samples than this, unless it has more pixels.
const MOST_SAMPLES: usize = 40_000_000;

/// Samples a pixel along each axis, at most.
const FINEST: usize = 3;

/// How large a picture is, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// A width and a height.
    ///
    /// # Errors
    /// When one of them is below 32 or above 8192 pixels.
    pub fn new(width: u32, height: u32) -> Result<Self, RenderError> {
        let allowed = SMALLEST..=LARGEST;
        if allowed.contains(&width) && allowed.contains(&height) {
            Ok(Size { width, height })
        } else {
            Err(RenderError::Size { width, height })
        }
    }

    /// The width in pixels.
    pub fn width(self) -> u32 {
        self.width
    }

    /// The height in pixels.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Samples a pixel along each axis.
    pub(crate) fn density(self) -> usize {
        let pixels = self.width as usize * self.height as usize;
        (1..=FINEST).rev().find(|density| pixels * density * density <= MOST_SAMPLES).unwrap_or(1)
    }
}
