//! What a file has round its mesh: what a writer of the same format needs to write the file as it was.
//!
//! A reader puts it beside the mesh ([`ReadFile::shell`](crate::ReadFile::shell)), and a writer gets it through
//! [`WriteOptions::as_read`](crate::WriteOptions::as_read). The shell of a mesh that comes from no file is empty.

use std::any::Any;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use crate::{Encoding, Format, Loss};

/// How a file was written: its format, its encoding, and what else its format lets a writer choose.
///
/// Cloning is O(1).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shell {
    file: Option<Arc<FileForm>>,
}

#[derive(Debug)]
struct FileForm {
    format: Format,
    encoding: Encoding,
    shape: Box<dyn Shape>,
}

/// The choices of a format that a file shows. Each format has its own type for them.
pub(crate) trait Shape: Any + fmt::Debug + Send + Sync {
    /// Whether another shape is of the same type and says the same.
    fn is_same(&self, other: &dyn Shape) -> bool;

    /// What the file has beside its mesh and an output won't carry.
    fn losses_in(&self, output: Output<'_>) -> Vec<Loss>;
}

/// The shape of a format without choices for a writer.
#[derive(Debug, PartialEq)]
pub(crate) struct NoChoices;

impl Shape for NoChoices {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output<'_>) -> Vec<Loss> {
        Vec::new()
    }
}

/// What is to be written from a mesh that was read from a file.
#[derive(Clone, Copy)]
pub(crate) enum Output<'a> {
    /// In its own format, in this folder if that is known.
    OfSameFormat(Option<&'a Path>),
    /// In another format.
    OfOtherFormat,
}

impl dyn Shape {
    /// The shape as the type of one format, if it is of that type.
    pub(crate) fn downcast<T: Shape>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }
}

impl PartialEq for FileForm {
    fn eq(&self, other: &Self) -> bool {
        (self.format, self.encoding) == (other.format, other.encoding) && self.shape.is_same(&*other.shape)
    }
}

impl Shell {
    pub(crate) fn of_file(format: Format, encoding: Encoding, shape: impl Shape) -> Self {
        Shell { file: Some(Arc::new(FileForm { format, encoding, shape: Box::new(shape) })) }
    }

    /// The format of the file, if there was one.
    pub fn format(&self) -> Option<Format> {
        self.file.as_ref().map(|file| file.format)
    }

    /// How the file spells its numbers, if there was one.
    pub fn encoding(&self) -> Option<Encoding> {
        self.file.as_ref().map(|file| file.encoding)
    }

    /// The choices of the file's writer, if the file has the format of this type.
    pub(crate) fn shape<T: Shape>(&self) -> Option<&T> {
        self.file.as_ref().and_then(|file| file.shape.downcast())
    }

    /// What the file has beside its mesh and a file of another kind, in this folder if it is known, won't carry.
    pub(crate) fn losses_in(&self, format: Format, folder: Option<&Path>) -> Vec<Loss> {
        let Some(file) = &self.file else { return Vec::new() };
        let output = if file.format == format { Output::OfSameFormat(folder) } else { Output::OfOtherFormat };
        file.shape.losses_in(output)
    }
}
