//! What is to be drawn: a mesh, overlays and a camera.

pub(crate) mod camera;
pub(crate) mod diagnostic_overlays;
pub(crate) mod loop_overlays;
pub(crate) mod overlay;
pub(crate) mod scene;
