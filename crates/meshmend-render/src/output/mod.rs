//! Pictures as pixels and as SVG.

pub(crate) mod canvas;
pub(crate) mod draw;
pub(crate) mod raster;
pub(crate) mod svg;
