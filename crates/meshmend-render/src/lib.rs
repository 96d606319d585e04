//! Pictures of polygon meshes: what they look like, what is wrong with them, and the loops on them.
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

mod appearance;
mod camera;
mod canvas;
mod chains;
mod depth;
mod draw;
mod frame;
mod layers;
mod layout;
mod legend;
mod loops;
mod occlusion;
mod overlay;
mod painting;
mod panel;
mod picture;
mod raster;
mod scene;
mod shade;
mod sight;
mod survey;
mod svg;
mod vector;

pub use camera::{Camera, NoDirection, Projection};
pub use loops::{LoopOverlays, MOST_GENERATORS, loops, seam};
pub use overlay::{NoSuchElement, Overlay, OverlayKind};
pub use picture::{Fit, Picture, RenderError, Size, contact_sheet, render};
pub use scene::{Outlines, Scene};
pub use survey::{boundary, components, inconsistent, non_manifold, witness};
