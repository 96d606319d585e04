//! Why a file can't be read or written, and where.

use std::{error, fmt, io};

use meshmend_core::{Cancelled, DraftError};
use serde::Serialize;
use thiserror::Error;

use crate::document::TooMuchPlaced;
use crate::limits::{name_of_limit, too_many};
use crate::text::one_or_many;
use crate::watched::cancelled_by;
use crate::{Encoding, Format};

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of a text, counted from 1.
    Line(u64),
    /// A byte, counted from 0.
    Byte(u64),
    /// A member of a JSON text, as a JSON pointer: `/accessors/3`.
    Pointer(String),
    /// An entry of an archive, and what of it: `3D/3dmodel.model#object 4`.
    Entry(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::File => f.write_str("whole file"),
            Place::Line(line) => write!(f, "line {line}"),
            Place::Byte(byte) => write!(f, "byte {byte}"),
            Place::Pointer(name) | Place::Entry(name) => f.write_str(name),
        }
    }
}

/// Why a file can't be read. Shown as `file: place: reason`. Its source is the error of the system, if that is the
/// reason.
#[derive(Debug)]
pub struct ReadError {
    /// The file, as it was named.
    pub file: String,
    /// Where in it.
    pub place: Place,
    /// What is wrong.
    pub kind: ReadErrorKind,
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}{}", self.file, shown(&self.place), self.kind)
    }
}

impl error::Error for ReadError {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        // The kind itself would be shown twice: what is shown of this error ends with it.
        error::Error::source(&self.kind)
    }
}

/// Why a file can't be read: what it is, what the system does, what its content is, or how large it is.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// Neither the name nor the content shows a format that is read here, or the content is surely something else.
    #[error("{}", unknown(.looks_like))]
    UnknownFormat {
        /// What the content surely is, if it is known.
        looks_like: Option<&'static str>,
    },
    /// The system can't read the file.
    #[error("{0}")]
    Io(#[source] io::Error),
    /// Whoever watches the reading asked to stop.
    #[error("{0}")]
    Cancelled(#[from] Cancelled),
    /// The file can't be read row by row, and that was asked for.
    #[error("only binary PLY without strips and binary STL can be read piece by piece")]
    NotInRows,
    /// The content breaks the rules of its format.
    #[error("{0}")]
    Malformed(String),
    /// The file holds more than the limits allow.
    #[error("{} more than the limit of {limit}{}", too_many(*found, what), name_of_limit(what))]
    LimitExceeded {
        /// What exceeds its limit.
        what: &'static str,
        /// How much of it was found. There may be more.
        found: u64,
        /// The limit.
        limit: u64,
    },
}

/// Why a file can't be written. Shown as `file: reason`. Its source is the error of the system or of the mesh, if one
/// of those is the reason.
#[derive(Debug)]
pub struct WriteError {
    /// The file, as it was named.
    pub file: String,
    /// What is wrong.
    pub kind: WriteErrorKind,
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.kind)
    }
}

impl error::Error for WriteError {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        error::Error::source(&self.kind)
    }
}

/// Why a mesh can't be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteErrorKind {
    /// Neither the options nor the name of the file show a format that is written here.
    #[error("the format is not known; known are {}", Format::names())]
    UnknownFormat,
    /// The format has no such encoding.
    #[error("{format} has no encoding `{encoding}`")]
    NoSuchEncoding {
        /// The format.
        format: Format,
        /// The encoding that the options ask for.
        encoding: Encoding,
    },
    /// The mesh has vertices whose attributes differ from face to face, and the options forbid to write such a mesh.
    #[error("{}: seams are not to be written", seam_vertices(*vertices))]
    Seams {
        /// How many vertices.
        vertices: u64,
    },
    /// A file that is to stand beside the output has the name of another one, which is not overwritten.
    #[error("`{name}` beside it is another file, and is not overwritten")]
    Occupied {
        /// Its name.
        name: String,
    },
    /// The file would hold more elements than a mesh can.
    #[error("{0}")]
    TooLarge(#[from] DraftError),
    /// The file that was read places its meshes too often to make one of them.
    #[error("{0}")]
    Placed(#[from] TooMuchPlaced),
    /// The system can't write the bytes.
    #[error("{0}")]
    Io(#[source] io::Error),
    /// Whoever watches the writing asked to stop.
    #[error("{0}")]
    Cancelled(#[from] Cancelled),
}

impl From<io::Error> for ReadErrorKind {
    fn from(error: io::Error) -> Self {
        cancelled_by(&error).map_or_else(|| ReadErrorKind::Io(error), ReadErrorKind::Cancelled)
    }
}

impl From<io::Error> for WriteErrorKind {
    fn from(error: io::Error) -> Self {
        cancelled_by(&error).map_or_else(|| WriteErrorKind::Io(error), WriteErrorKind::Cancelled)
    }
}

fn seam_vertices(count: u64) -> String {
    let of_vertices = one_or_many(count, "vertex has", "vertices have");
    format!("{of_vertices} attributes that differ from face to face")
}

fn shown(place: &Place) -> String {
    match place {
        Place::File => String::new(),
        place => format!("{place}: "),
    }
}

fn unknown(looks_like: &Option<&str>) -> String {
    match looks_like {
        Some(name) => format!("looks like {name}; the formats that are read are {}", Format::names()),
        None => format!("the format is not known; known are {}", Format::names()),
    }
}

#[cfg(test)]
mod tests {
    use std::error::Error as _;
    use std::ops::ControlFlow;
    use std::path::Path;

    use meshmend_core::{Carry, Domain, FaceTable, Layer, MAX_CORNERS, PolygonMesh, Values, VertexId, Watch};
    use meshmend_testkit::assert_every_variant;

    use super::*;
    use crate::{Limits, ReadOptions, Seams, WriteOptions, encode, read, read_bytes, write};

    fn stop() -> Watch {
        Watch::new(|_| ControlFlow::Break(()))
    }

    fn unread(bytes: &[u8], options: ReadOptions) -> ReadErrorKind {
        read_bytes(bytes, "mesh", &options).unwrap_err().kind
    }

    #[test]
    fn every_reason_why_a_file_is_not_read_says_what_is_wrong() {
        let unknown = format!("the format is not known; known are {}", Format::names());
        let obj = ReadOptions { format: Some(Format::Obj), ..ReadOptions::default() };
        let stopped = obj.clone().with_watch(&stop());
        let small = Limits { max_file_bytes: 7, ..Limits::default() };
        let cases = vec![
            (unread(b"hello", ReadOptions::default()), unknown.as_str()),
            (read(Path::new("."), &obj).unwrap_err().kind, "is a directory"),
            (unread(b"f 1\n", stopped), "cancelled"),
            (
                ReadErrorKind::NotInRows,
                "only binary PLY without strips and binary STL can be read piece by piece",
            ),
            (unread(b"f 1\n", obj.clone()), "vertex 1 does not exist: the file has 0 vertices"),
            (
                unread(b"v 0 0 0\n", ReadOptions { limits: small, ..obj }),
                "8 bytes are more than the limit of 7 (max_file_bytes)",
            ),
        ];
        assert_every_variant!(
            cases,
            ReadErrorKind { UnknownFormat, Io, Cancelled, NotInRows, Malformed, LimitExceeded }
        );
    }

    #[test]
    fn every_reason_why_a_file_is_not_written_says_what_is_wrong() {
        let unknown = format!("the format is not known; known are {}", Format::names());
        // A vertex that is red in one triangle and blue in the other.
        let faces = FaceTable::triangles(5, [0, 1, 2, 0, 3, 4].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3]; 5], faces).unwrap();
        let values = Values::U8(vec![255, 0, 0, 0, 0, 255]);
        let color = Layer::indexed("color", Domain::Corner, 3, Carry::Copy, values, vec![0, 0, 0, 1, 1, 1]);
        let mesh = mesh.with_layers(vec![color.at_home_on_vertices(5)]).unwrap();
        let unwritten = |options| encode(&mesh, &options, &mut io::sink()).unwrap_err().kind;
        let stopped = WriteOptions::of(Format::Obj).with_watch(&stop());
        let big = WriteOptions::of(Format::Obj).with_encoding(Encoding::BigEndian);
        let cases = vec![
            (unwritten(WriteOptions::default()), unknown.as_str()),
            (unwritten(stopped), "cancelled"),
            (unwritten(big), "OBJ has no encoding `big-endian`"),
            (
                write(Path::new("."), &mesh, &WriteOptions::of(Format::Off)).unwrap_err().kind,
                "is a directory",
            ),
            (
                unwritten(WriteOptions { seams: Seams::Fail, ..WriteOptions::of(Format::Off) }),
                "1 vertex has attributes that differ from face to face: seams are not to be written",
            ),
            (
                DraftError::from(FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err()).into(),
                "2147483648 vertices are more than the 2147483648 that a table holds",
            ),
            (
                WriteErrorKind::Occupied { name: "a.mtl".to_owned() },
                "`a.mtl` beside it is another file, and is not overwritten",
            ),
            (
                TooMuchPlaced { present: 6, placed: 18_000_000 }.into(),
                "its meshes have 6 vertices and corners, but 18000000 as often as they are placed: too many for one mesh",
            ),
        ];
        assert_every_variant!(
            cases,
            WriteErrorKind {
                UnknownFormat,
                NoSuchEncoding,
                Seams,
                Occupied,
                TooLarge,
                Placed,
                Io,
                Cancelled
            }
        );
    }

    #[test]
    fn an_error_of_the_system_is_the_source_of_what_it_causes() {
        let kind_of =
            |error: &dyn error::Error| error.source()?.downcast_ref::<io::Error>().map(io::Error::kind);
        let read = read(Path::new("no/such/mesh.obj"), &ReadOptions::default()).unwrap_err();
        assert_eq!(kind_of(&read), Some(io::ErrorKind::NotFound));
        assert_eq!(kind_of(&read.kind), Some(io::ErrorKind::NotFound));
        let faces = FaceTable::triangles(0, Vec::new()).unwrap();
        let mesh = PolygonMesh::new(Vec::new(), faces).unwrap();
        let written = write(Path::new("no/such/mesh.obj"), &mesh, &WriteOptions::default()).unwrap_err();
        assert_eq!(kind_of(&written), Some(io::ErrorKind::NotFound));
        let mut full: &mut [u8] = &mut [];
        let written = encode(&mesh, &WriteOptions::of(Format::Obj), &mut full).unwrap_err();
        assert_eq!(kind_of(&written), Some(io::ErrorKind::WriteZero));
        // What is wrong with the bytes has no other cause.
        let malformed = read_bytes(b"f 1\n", "mesh.obj", &ReadOptions::default()).unwrap_err();
        assert!(malformed.source().is_none() && malformed.kind.source().is_none());
        let too_large = WriteErrorKind::from(DraftError::from(
            FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err(),
        ));
        let too_large = WriteError { file: "mesh".to_owned(), kind: too_large };
        assert!(too_large.source().is_some_and(|source| source.is::<DraftError>()));
    }

    #[test]
    fn a_place_is_shown_between_file_and_reason() {
        let shown = |place| {
            let kind = ReadErrorKind::UnknownFormat { looks_like: None };
            ReadError { file: "mesh.ply".into(), place, kind }.to_string()
        };
        assert!(shown(Place::File).starts_with("mesh.ply: the format"));
        assert!(shown(Place::Line(4)).starts_with("mesh.ply: line 4: the format"));
        assert!(shown(Place::Byte(9)).starts_with("mesh.ply: byte 9: the format"));
        assert_eq!(Place::File.to_string(), "whole file");
    }
}
