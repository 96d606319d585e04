//! Pictures of polygon meshes: what they look like, what is wrong with them, the loops on them, and the records that store them.
//!
//! A [`Scene`] is a mesh with [overlays](Overlay), seen by a [`Camera`]. [`render`] draws it, [`contact_sheet`] draws
//! several in a grid, and the [`Picture`] is written as PNG or SVG.
//!
//! ```text
//! Scene ── place vertices ── depth buffer ──┬── which parts of lines are seen ── Panel ──┬── pixels ── PNG
//!                                           └── which faces are seen ────────────────────┴── paths ─── SVG
//! ```
//!
//! One depth buffer decides in both formats what is nearest; SVG draws whole faces from far to near all the
//! same, see [`Picture::write_svg`]. What differs in colour differs in dashes, width, hatching, a mark or a number
//! too, so that pictures can be printed in grey. The same scenes give the same bytes.

mod depth;
mod look;
mod output;
mod panels;
mod pictures;
mod pointers;
mod scenes;
mod vector;

pub use pictures::contact_sheet::{Fit, contact_sheet, render};
pub use pictures::error::RenderError;
pub use pictures::picture::Picture;
pub use pictures::size::Size;
pub use pointers::{MOST_ARROWS, PointerPictureError, pointer_picture};
pub use scenes::camera::{Camera, NoDirection, Projection};
pub use scenes::diagnostic_overlays::{boundary, components, inconsistent, non_manifold, witness};
pub use scenes::loop_overlays::{LoopOverlays, MOST_GENERATORS, loops, seam};
pub use scenes::overlay::{NoSuchElement, Overlay, OverlayKind, Placed};
pub use scenes::scene::{Outlines, Scene};
