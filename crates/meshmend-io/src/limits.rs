//! How much a file may hold.

use meshmend_core::MAX_CORNERS;

use crate::text::one_or_many;

/// What a file may hold at most. The defaults are finite, and larger than what the memory of most machines can hold.
///
/// Whatever the limits are, memory grows with the bytes that are present, never with the counts that a file declares.
///
/// ```
/// let limits = meshmend_io::Limits::default().with_max_faces(1_000_000);
/// assert_eq!(limits.max_faces, 1_000_000);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Limits {
    /// Bytes of the file; 16 GiB by default.
    pub max_file_bytes: u64,
    /// Bytes of a source of unknown size, such as a pipe or a device, which may be endless; 1 GiB by default.
    pub max_stream_bytes: u64,
    /// Vertices; 2³¹ − 1 by default, which is also the most that a mesh holds.
    pub max_vertices: u64,
    /// Faces; 2³¹ − 1 by default, which is also the most that a mesh holds.
    pub max_faces: u64,
    /// Corners of all faces together; 2³¹ − 1 by default, which is also the most that a mesh holds.
    pub max_corners: u64,
    /// Comments that are kept as metadata; 10 000 by default. A note counts the others.
    pub max_comments: usize,
    /// Elements and properties that the header of a PLY file declares, together; 65 536 by default.
    pub max_declarations: u64,
    /// Bytes of the JSON text of a glTF file; 1 GiB by default.
    pub max_json_bytes: u64,
    /// How deep values of a JSON text lie within each other; 128 by default.
    pub max_json_depth: u64,
    /// Files that a file names and that are opened; 64 by default.
    pub max_companion_files: u64,
    /// Bytes of those files together; 1 GiB by default.
    pub max_companion_bytes: u64,
    /// Bytes to which the entries of an archive inflate together; 4 GiB by default.
    pub max_inflated_bytes: u64,
    /// Meshes of a file; 1 000 000 by default.
    pub max_parts: u64,
    /// Nodes of a scene, or places where objects are put; 10 000 000 by default.
    pub max_nodes: u64,
}

/// What is limited, what one of it is called, and the name of the limit.
const NAMES: [(&str, &str, &str); 13] = [
    ("bytes", "byte", "max_file_bytes"),
    (STREAM_BYTES, "byte from a source that does not tell its size", "max_stream_bytes"),
    ("vertices", "vertex", "max_vertices"),
    ("faces", "face", "max_faces"),
    ("corners", "corner", "max_corners"),
    (DECLARATIONS, "element or property", "max_declarations"),
    (JSON_BYTES, "byte of JSON", "max_json_bytes"),
    (JSON_DEPTH, "level of JSON values", "max_json_depth"),
    (COMPANION_FILES, "named file", "max_companion_files"),
    (COMPANION_BYTES, "byte of named files", "max_companion_bytes"),
    (INFLATED_BYTES, "inflated byte", "max_inflated_bytes"),
    (PARTS, "mesh", "max_parts"),
    (NODES, "node", "max_nodes"),
];

/// How many vertices, and how many corners, a file may have whose mesh is not held; the highest number of 32 bits is none.
const MOST_STREAMED: u64 = u32::MAX as u64;

/// What a source of unknown size can have too much of.
pub(crate) const STREAM_BYTES: &str = "bytes from a source that does not tell its size";

/// What the header of a PLY file can have too much of.
pub(crate) const DECLARATIONS: &str = "elements and properties";

/// What the text of a glTF file can have too much of.
pub(crate) const JSON_BYTES: &str = "bytes of JSON";

/// What else it can have too much of.
pub(crate) const JSON_DEPTH: &str = "levels of JSON values";

/// What a file can name too many of.
pub(crate) const COMPANION_FILES: &str = "named files";

/// What the named files can have too much of.
pub(crate) const COMPANION_BYTES: &str = "bytes of named files";

/// What an archive can have too much of.
pub(crate) const INFLATED_BYTES: &str = "inflated bytes";

/// What a file of several meshes can have too much of.
pub(crate) const PARTS: &str = "meshes";

/// What a scene can have too much of.
pub(crate) const NODES: &str = "nodes";

/// The name of a limit, in parentheses.
pub(crate) fn name_of_limit(what: &str) -> String {
    let found = NAMES.iter().find(|(limited, ..)| *limited == what);
    found.map_or(String::new(), |(.., name)| format!(" ({name})"))
}

/// How much was found: `1 face is`, `2 faces are`.
pub(crate) fn too_many(found: u64, what: &str) -> String {
    let one = NAMES.iter().find(|(limited, ..)| *limited == what).map_or(what, |(_, one, _)| one);
    one_or_many(found, &format!("{one} is"), &format!("{what} are"))
}

impl Default for Limits {
    fn default() -> Self {
        let most = MAX_CORNERS as u64 - 1;
        Limits {
            max_file_bytes: 16 << 30,
            max_stream_bytes: 1 << 30,
            max_vertices: most,
            max_faces: most,
            max_corners: most,
            max_comments: 10_000,
            max_declarations: 1 << 16,
            max_json_bytes: 1 << 30,
            max_json_depth: 128,
            max_companion_files: 64,
            max_companion_bytes: 1 << 30,
            max_inflated_bytes: 4 << 30,
            max_parts: 1_000_000,
            max_nodes: 10_000_000,
        }
    }
}

macro_rules! with_limit {
    ($($with:ident $limit:ident: $number:ty,)*) => {
        impl Limits {
            $(
                #[doc = concat!("These limits with another [`", stringify!($limit), "`](Self::", stringify!($limit), ").")]
                pub fn $with(self, $limit: $number) -> Self {
                    Limits { $limit, ..self }
                }
            )*
        }
    };
}

with_limit! {
    with_max_file_bytes max_file_bytes: u64,
    with_max_stream_bytes max_stream_bytes: u64,
    with_max_vertices max_vertices: u64,
    with_max_faces max_faces: u64,
    with_max_corners max_corners: u64,
    with_max_comments max_comments: usize,
    with_max_declarations max_declarations: u64,
    with_max_json_bytes max_json_bytes: u64,
    with_max_json_depth max_json_depth: u64,
    with_max_companion_files max_companion_files: u64,
    with_max_companion_bytes max_companion_bytes: u64,
    with_max_inflated_bytes max_inflated_bytes: u64,
    with_max_parts max_parts: u64,
    with_max_nodes max_nodes: u64,
}

impl Limits {
    /// These limits, narrowed to what a mesh can hold.
    pub(crate) fn within_a_mesh(self) -> Self {
        let most = Limits::default();
        Limits {
            max_vertices: self.max_vertices.min(most.max_vertices),
            max_faces: self.max_faces.min(most.max_faces),
            max_corners: self.max_corners.min(most.max_corners),
            ..self
        }
    }

    /// These limits for a file whose mesh is not held: those that are as wide as a mesh become as wide as numbers of 32 bits.
    pub(crate) fn within_a_stream(self) -> Self {
        let usual = Limits::default();
        let widened = |limit, usual, most| if limit == usual { most } else { limit };
        Limits {
            max_file_bytes: widened(self.max_file_bytes, usual.max_file_bytes, u64::MAX),
            max_vertices: widened(self.max_vertices, usual.max_vertices, MOST_STREAMED).min(MOST_STREAMED),
            max_faces: self.max_faces.min(usual.max_faces),
            max_corners: widened(self.max_corners, usual.max_corners, MOST_STREAMED).min(MOST_STREAMED),
            ..self
        }
    }

    /// Whether a mesh of so many vertices, faces and corners is within the limits.
    pub(crate) fn hold(&self, vertices: usize, faces: usize, corners: usize) -> bool {
        vertices as u64 <= self.max_vertices
            && faces as u64 <= self.max_faces
            && corners as u64 <= self.max_corners
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_mesh_holds_bounds_wider_limits_and_leaves_narrower_ones() {
        let endless = Limits {
            max_file_bytes: u64::MAX,
            max_stream_bytes: u64::MAX,
            max_vertices: u64::MAX,
            max_faces: u64::MAX,
            max_corners: u64::MAX,
            max_comments: usize::MAX,
            max_declarations: u64::MAX,
            ..Limits::default()
        };
        let bounded = endless.within_a_mesh();
        let of_a_mesh = [bounded.max_vertices, bounded.max_faces, bounded.max_corners];
        assert_eq!(of_a_mesh, [(1 << 31) - 1; 3]);
        assert_eq!((bounded.max_file_bytes, bounded.max_comments), (u64::MAX, usize::MAX));
        let narrow = Limits { max_vertices: 1, max_faces: 2, max_corners: 3, ..endless };
        assert_eq!(narrow.within_a_mesh(), narrow);
    }
}
