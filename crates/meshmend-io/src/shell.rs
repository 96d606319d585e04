//! What a file has round its mesh: what a writer of the same format needs to give the file back as it was.
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

/// What a format lets a writer choose, as a file has it. Each format has a type of its own for that.
pub(crate) trait Shape: Any + fmt::Debug + Send + Sync {
    /// Whether another shape is of the same type and says the same.
    fn is_same(&self, other: &dyn Shape) -> bool;

    /// What the file has beside its mesh that an output won't carry.
    fn losses_in(&self, output: Output<'_>) -> Vec<Loss>;
}

/// The shape of a format that leaves a writer nothing to choose.
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

/// Where a file is to be written again.
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

    /// What the file's writer chose, if there was a file of the format whose choices have this type.
    pub(crate) fn shape<T: Shape>(&self) -> Option<&T> {
        self.file.as_ref().and_then(|file| file.shape.downcast())
    }

    /// What the file has beside its mesh that a file of a format, in a folder if that is known, won't carry.
    pub(crate) fn losses_in(&self, format: Format, folder: Option<&Path>) -> Vec<Loss> {
        let Some(file) = &self.file else { return Vec::new() };
        let output = if file.format == format { Output::OfSameFormat(folder) } else { Output::OfOtherFormat };
        file.shape.losses_in(output)
    }
}
