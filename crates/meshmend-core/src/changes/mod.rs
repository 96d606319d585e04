//! How a mesh is changed, and the record of it.

mod anchors;
mod blend;
mod carry;
mod draft;
mod filled;
mod influences;
mod provenance;
mod rebuild;
mod render_vertices;
mod sources;

pub use blend::Blend;
pub use draft::{Draft, DraftError, Loose, VertexDraft};
pub use filled::FilledHole;
pub use provenance::Provenance;
pub use sources::Sources;

#[cfg(test)]
mod tests;
