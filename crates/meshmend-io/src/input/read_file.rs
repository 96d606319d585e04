//! What a file holds.

use meshmend_core::PolygonMesh;

use crate::{Format, Note, Shell};

/// What a file holds.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReadFile {
    /// The mesh.
    pub mesh: PolygonMesh,
    /// The format that the file has.
    pub format: Format,
    /// Which form of it: `obj`, `off`, `ply-ascii`, `ply-le`, `ply-be`, `stl-ascii` or `stl-binary`.
    pub variant: &'static str,
    /// What in the file is not in the mesh, or not as the file has it; sorted by kind.
    pub notes: Vec<Note>,
    /// How the file was written, for a writer of the same format.
    pub shell: Shell,
}
