//! What a file holds.

use meshmend_core::PolygonMesh;

use crate::{Format, Note, Shell};

/// What a file holds.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReadFile {
    /// The mesh.
    pub mesh: PolygonMesh,
    /// The format of the file.
    pub format: Format,
    /// The format together with the encoding, such as `ply-le` (see [`Format::variant`]).
    pub variant: &'static str,
    /// What of the file the mesh lacks, or holds in another way; sorted by kind.
    pub notes: Vec<Note>,
    /// How the file was written, for a writer of the same format.
    pub shell: Shell,
}
