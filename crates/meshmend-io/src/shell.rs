//! What a file has round its mesh: what a writer of the same format needs to write the file as it was.
//!
//! A reader puts it beside the mesh ([`ReadFile::shell`](crate::ReadFile::shell)), and a writer gets it through
//! [`WriteOptions::as_read`](crate::WriteOptions::as_read). The shell of a mesh that comes from no file is empty.

use std::any::Any;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use crate::document::{Document, Placement};
use crate::{Encoding, Format, Loss, WriteErrorKind, WriteOptions};

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

    /// Where the file puts its parts, one entry for each time that it does, in file order. `None`: each part stands
    /// once, as it is.
    fn placements(&self) -> Option<Vec<Placement>> {
        None
    }

    /// The file as it was read, with the meshes that its parts have now. `None`: the format asked for is another kind
    /// of file, or a file of this kind is made of its mesh alone.
    fn splice(&self, _: &Document, _: &Splice<'_>) -> Option<Result<Spliced, WriteErrorKind>> {
        None
    }
}

/// What a file that is written from the one that was read is to be.
#[expect(dead_code, reason = "formats of several parts ask for it")]
pub(crate) struct Splice<'a> {
    /// Its format.
    pub(crate) format: Format,
    /// How it is written.
    pub(crate) options: &'a WriteOptions,
}

/// A file that is written from the one that was read.
#[derive(Clone, Debug)]
pub(crate) struct Spliced {
    /// The file.
    pub(crate) bytes: Vec<u8>,
    /// What it does not carry.
    pub(crate) losses: Vec<Loss>,
    /// The files that must stand beside it: their names below the folder, and what is in them.
    #[expect(dead_code, reason = "written by formats of several files")]
    pub(crate) companions: Vec<(Vec<u8>, Vec<u8>)>,
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

/// The shape of a mesh that was made of all that a file places: what is lost by that.
#[derive(Debug, PartialEq)]
struct Scene(Vec<Loss>);

impl Shape for Scene {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output<'_>) -> Vec<Loss> {
        self.0.clone()
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

    /// The shell of one mesh of all that a file places: no file of the format can be spliced from it, and what else
    /// the file holds is lost in every format.
    pub(crate) fn of_scene(shell: &Shell) -> Self {
        let Some(file) = &shell.file else { return Shell::default() };
        Shell::of_file(file.format, file.encoding, Scene(file.shape.losses_in(Output::OfOtherFormat)))
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

    /// Where the file puts its parts.
    pub(crate) fn placements(&self) -> Option<Vec<Placement>> {
        self.file.as_ref().and_then(|file| file.shape.placements())
    }

    /// The file as it was read, with the meshes that its parts have now.
    pub(crate) fn splice(
        &self,
        document: &Document,
        splice: &Splice<'_>,
    ) -> Option<Result<Spliced, WriteErrorKind>> {
        self.file.as_ref().and_then(|file| file.shape.splice(document, splice))
    }

    /// What the file has beside its mesh and a file of another kind, in this folder if it is known, won't carry.
    pub(crate) fn losses_in(&self, format: Format, folder: Option<&Path>) -> Vec<Loss> {
        let Some(file) = &self.file else { return Vec::new() };
        let output = if file.format == format { Output::OfSameFormat(folder) } else { Output::OfOtherFormat };
        file.shape.losses_in(output)
    }
}
