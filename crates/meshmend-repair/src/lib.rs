//! Repairs of polygon meshes, as passes that run alone or in a pipeline.
//!
//! A [`Pass`] takes a mesh and gives a mesh with its provenance: nothing is removed or changed that the record does
//! not name. A [`Pipeline`] runs passes one after another; the default one makes any mesh manifold, consistently
//! oriented where that can be, and free of rubbish, without deleting a face that is not degenerate, non-finite or
//! there twice:
//!
//! [`Weld`] → [`Clean`] → [`Orient`] → [`Split`] → [`Triangulate`] → [`Compact`] → [`Verify`]
//!
//! Unasked, no pass turns whole components outward; [`Outward`] does.
//!
//! A [`Plan`] says the same in a file.

mod advice;
mod apart;
mod clearance;
mod copies;
mod emptied;
mod emptied_names;
mod fates;
mod figures;
mod fixed;
mod matching;
mod named_parts;
mod pass;
mod pass_row;
mod passes;
mod pipeline;
mod plan;
mod presets;
mod session;
mod sewing;
mod stored_vertices;
mod telling;
mod tolerance;
mod turned;

pub use advice::{Advice, BINS_A_DECADE, Bin, Tolerance};
pub use clearance::{Clearance, Subdivision, Unused};
pub use emptied::{Emptied, Emptying, EmptyingCause};
pub use emptied_names::{EmptiedName, emptied_names};
pub use figures::Figures;
pub use fixed::Fixed;
pub use meshmend_geometry::Precision;
pub use meshmend_geometry::rounding::Rounding;
pub use named_parts::{NamedPart, joined_parts, named_parts};
pub use pass::{Context, History, Outcome, Pass, PassError};
pub use pass_row::{Form, OptionValues, PassOption, PassRow, Word};
pub use passes::*;
pub use pipeline::{FaceStorage, PassRecord, Pipeline, RemovedFace, Repaired, Writing};
pub use plan::{FilePolicies, PlanError, Said, SayingError, WrittenSeams};
pub use presets::{PRESETS, Preset};
pub use session::{Looked, Session};
pub use telling::TellingLayers;
