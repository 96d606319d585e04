//! What a file has round its mesh: what a writer of the same format needs to give the file back as it was.
//!
//! A reader puts it beside the mesh ([`ReadFile::shell`](crate::ReadFile::shell)), and a writer is given it with
//! [`WriteOptions::as_read`](crate::WriteOptions::as_read). A mesh that comes from no file has an empty one.

use std::sync::Arc;

use crate::formats::obj::ObjShape;
use crate::formats::obj::companions::Companions;
use crate::formats::off::OffShape;
use crate::formats::ply::PlyShape;
use crate::formats::stl::StlShape;
use crate::{Encoding, Format};

/// How a file was written: its format, its encoding, and what else its format lets a writer choose.
///
/// Cloning is O(1).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shell {
    file: Option<Arc<FileForm>>,
    companions: Option<Arc<Companions>>,
}

#[derive(Debug, PartialEq)]
struct FileForm {
    format: Format,
    encoding: Encoding,
    shape: Shape,
}

/// What a format lets a writer choose, as a file has it.
#[derive(Debug, PartialEq)]
pub(crate) enum Shape {
    Obj(ObjShape),
    Ply(PlyShape),
    Stl(StlShape),
    Off(OffShape),
}

impl Shell {
    pub(crate) fn of_file(encoding: Encoding, shape: Shape) -> Self {
        let format = match shape {
            Shape::Obj(_) => Format::Obj,
            Shape::Ply(_) => Format::Ply,
            Shape::Stl(_) => Format::Stl,
            Shape::Off(_) => Format::Off,
        };
        Shell { file: Some(Arc::new(FileForm { format, encoding, shape })), companions: None }
    }

    /// The shell of a file that names others.
    pub(crate) fn with_companions(self, companions: Companions) -> Self {
        Shell { companions: Some(Arc::new(companions)), ..self }
    }

    /// The files that the file names, if it names any that are there.
    pub(crate) fn companions(&self) -> Option<&Companions> {
        self.companions.as_deref()
    }

    /// The format of the file, if there was one.
    pub fn format(&self) -> Option<Format> {
        self.file.as_ref().map(|file| file.format)
    }

    /// How the file spells its numbers, if there was one.
    pub fn encoding(&self) -> Option<Encoding> {
        self.file.as_ref().map(|file| file.encoding)
    }

    /// What the file's writer chose, if there was one.
    pub(crate) fn shape(&self) -> Option<&Shape> {
        self.file.as_ref().map(|file| &file.shape)
    }
}
