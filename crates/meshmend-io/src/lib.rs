//! Reads and writes mesh files: OBJ, PLY, STL, OFF, GLB, glTF and 3MF.
//!
//! A reader turns the bytes of a file into a [`PolygonMesh`]. It keeps all that a mesh can hold: faces of any size,
//! degenerate faces, loose edges and points, attributes in the type in which they are stored, comments. [`Note`]s
//! name what a mesh can't hold. A malformed file is a [`ReadError`] with the line or the byte. A writer makes a file
//! that reads back to the same bits, and its [`Loss`]es name what the format can't carry.
//!
//! ```
//! use meshmend_io::{Format, ReadOptions, WriteOptions, encode, read_bytes};
//!
//! let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
//! let file = read_bytes(text, "triangle.obj", &ReadOptions::default())?;
//! assert_eq!(file.mesh.counts().faces, 1);
//!
//! let mut off = Vec::new();
//! let losses = encode(&file.mesh, &WriteOptions::of(Format::Off), &mut off)?;
//! assert!(losses.is_empty());
//! assert_eq!(off, b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The only other files that are opened are the material libraries that an OBJ file names within its own folder, to
//! see whether they and their images are there. What a file says about other files (`mtllib`) is kept as metadata.
//!
//! A format is one folder and one row of the registry (`formats/rows.rs`).
//!
//! [`PolygonMesh`]: meshmend_core::PolygonMesh

mod binary;
mod document;
mod element_lines;
mod error;
mod formats;
mod input;
mod layers;
mod limits;
mod loss;
mod note;
mod output;
mod paths;
mod read;
mod shell;
mod text;
mod watched;
mod write;

pub use document::{
    Document, Material, ObjectKind, Part, PartSource, PartStatus, Picture, Placement, Placing,
    PreparedDocument, TooMuchPlaced,
};
pub use element_lines::ElementLines;
pub use error::{Place, ReadError, ReadErrorKind, WriteError, WriteErrorKind};
pub use formats::encoding::Encoding;
pub use formats::facts::TextureOrigin;
pub use formats::format::Format;
pub use formats::gltf::base64::encode as base64;
pub use formats::stl::colors::{ColorElements, decode_stl_colors};
pub use input::options::ReadOptions;
pub use input::read_file::ReadFile;
pub use input::streamed::{Announced, MeshSink, Streamed};
pub use limits::Limits;
pub use loss::{Loss, LossKind, LostLayer};
pub use note::{Note, NoteKind};
pub use output::atomic::{abandon_temporary_files, replace_file, target_of};
pub use output::held::held_layers;
pub use output::options::{AttributePrecision, Companions, ManifoldExtension, Seams, WriteOptions};
pub use output::prepared::Prepared;
pub use output::rounding::rounding_losses;
pub use read::{
    read, read_bytes, read_document, read_document_bytes, read_document_stream, read_stream, stream,
};
pub use shell::Shell;
pub use write::{encode, losses, write, write_document};
