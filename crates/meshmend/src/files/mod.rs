//! The repair of a file: of its mesh, or of each of its parts, for the output that it will be written to.
//!
//! A [`FileRepair`] says how; [`FileRepair::run`] takes a document that was read, and gives a [`RepairedFile`]: the meshes,
//! the report on them, and what is ready to be written. The command line, its workers and the Python package repair files
//! through it, so that their reports are equal to the byte.
//!
//! ```
//! use meshmend::files::{FileRepair, FileTarget};
//! use meshmend::mesh::Watch;
//! use meshmend::formats::read_document_bytes;
//! use meshmend::{Format, ReadOptions, WriteOptions};
//!
//! let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n";
//! let document = read_document_bytes(text, "twice.obj", &ReadOptions::default())?;
//! let options = WriteOptions::of(Format::Ply).with_shell(document.shell.clone());
//! let target = FileTarget::new("once.ply", options);
//!
//! let repaired = FileRepair::default().run("twice.obj", document, Some(&target), &Watch::NOBODY)?;
//! assert!(repaired.is_changed());
//! assert!(repaired.report_json()?.contains(r#""output":"once.ply""#));
//! let mut bytes = Vec::new();
//! repaired.prepared().ok_or("there is a target")?.encode(&mut bytes)?;
//! assert!(bytes.starts_with(b"ply\n"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod digest;
mod error;
mod face_names;
mod judging;
mod one_mesh;
mod part_choice;
mod parts;
mod prepared;
mod record;
mod repair;
mod repaired;
mod row;
mod sha256;
mod target;

pub use self::error::FileError;
pub use self::face_names::FaceNames;
pub use self::judging::Judged;
pub use self::part_choice::{NoSuchPart, PartChoice};
pub use self::parts::PART;
pub use self::prepared::PreparedFile;
pub use self::record::{KeptChecks, RepairRecord, WholeChecks};
pub use self::repair::{CutPolygons, FileRepair, Maps};
pub use self::repaired::{PartOutcome, RepairedFile, RepairedMesh, RepairedPart, RepairedParts};
pub use self::sha256::{sha256, sha256_of};
pub use self::target::FileTarget;
