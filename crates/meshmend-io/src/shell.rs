//! What a file has round its mesh: what a writer of the same format needs to write the file as it was.
//!
//! A reader puts it beside the mesh ([`ReadFile::shell`](crate::ReadFile::shell)), and a writer gets it through
//! [`WriteOptions::as_read`](crate::WriteOptions::as_read). The shell of a mesh that comes from no file is empty.

use std::any::Any;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use crate::document::{Document, Placement};
use crate::{Encoding, Format, Loss, Material, WriteErrorKind, WriteOptions};

/// How a file was written: its format, its encoding, and what else its format lets a writer choose.
///
/// Cloning is O(1).
#[derive(Clone, Debug, Default)]
pub struct Shell {
    file: Option<Arc<FileForm>>,
    /// The folder of the file, if it was read from one.
    folder: Option<Arc<PathBuf>>,
}

/// Two shells are equal when their files were written alike, wherever they are.
impl PartialEq for Shell {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file
    }
}

#[derive(Debug)]
struct FileForm {
    format: Format,
    encoding: Encoding,
    shape: Box<dyn Shape>,
    /// What the materials look like, once that was asked for.
    materials: OnceLock<Arc<[Material]>>,
}

/// The choices of a format that a file shows. Each format has its own type for them.
pub(crate) trait Shape: Any + fmt::Debug + Send + Sync {
    /// Whether another shape is of the same type and says the same.
    fn is_same(&self, other: &dyn Shape) -> bool;

    /// What the file has beside its mesh and an output won't carry.
    fn losses_in(&self, output: Output) -> Vec<Loss>;

    /// What the materials that the file names look like.
    fn materials(&self) -> Vec<Material> {
        Vec::new()
    }

    /// The files in its folder that it names and that exist.
    fn companions(&self) -> Vec<NamedFile> {
        Vec::new()
    }

    /// Where the file puts its parts, one entry for each time that it does, in file order. `None`: each part stands
    /// once, as it is.
    fn placements(&self) -> Option<Vec<Placement>> {
        None
    }

    /// Whether a file of a format is written as this one was read, with what changed.
    fn is_spliced_into(&self, _: Format) -> bool {
        false
    }

    /// The file as it was read, with the meshes that its parts have now. `None`: the format asked for is another kind
    /// of file, or a file of this kind is made of its mesh alone.
    fn splice(&self, _: &Document, _: &Splice<'_>) -> Option<Result<Spliced, WriteErrorKind>> {
        None
    }
}

/// A file that another one names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct NamedFile {
    /// Its name, as a path below the folder.
    pub(crate) name: Vec<u8>,
    pub(crate) content: NamedContent,
}

/// What a named file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NamedContent {
    /// What materials look like.
    Materials,
    /// A picture.
    Picture,
    /// Numbers of the meshes.
    Buffer,
}

/// What a file that is written from the one that was read is to be.
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
    pub(crate) companions: Vec<(Vec<u8>, Vec<u8>)>,
}

/// The shape of a format without choices for a writer.
#[derive(Debug, PartialEq)]
pub(crate) struct NoChoices;

impl Shape for NoChoices {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output) -> Vec<Loss> {
        Vec::new()
    }
}

/// The shape of a mesh that was made of all that a file places: what is lost by that.
#[derive(Debug, PartialEq)]
struct Scene {
    losses: Vec<Loss>,
    materials: Vec<Material>,
    companions: Vec<NamedFile>,
}

impl Shape for Scene {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output) -> Vec<Loss> {
        self.losses.clone()
    }

    fn materials(&self) -> Vec<Material> {
        self.materials.clone()
    }

    fn companions(&self) -> Vec<NamedFile> {
        self.companions.clone()
    }
}

/// What is to be written from a mesh that was read from a file.
#[derive(Clone, Copy)]
pub(crate) enum Output {
    /// In its own format.
    OfSameFormat,
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
        let (shape, materials) = (Box::new(shape), OnceLock::new());
        Shell { file: Some(Arc::new(FileForm { format, encoding, shape, materials })), folder: None }
    }

    /// This shell, for a file in a folder.
    pub(crate) fn in_folder(self, folder: Option<PathBuf>) -> Self {
        Shell { folder: folder.map(Arc::new), ..self }
    }

    /// The folder of the file, if it was read from one.
    pub(crate) fn folder(&self) -> Option<&Path> {
        self.folder.as_ref().map(|folder| &***folder)
    }

    /// The shell of one mesh of all that a file places: no file of the format can be spliced from it, and what else
    /// the file holds is lost in every format.
    pub(crate) fn of_scene(shell: &Shell) -> Self {
        let Some(file) = &shell.file else { return Shell::default() };
        let scene = Scene {
            losses: file.shape.losses_in(Output::OfOtherFormat),
            materials: shell.materials().to_vec(),
            companions: file.shape.companions(),
        };
        Shell { folder: shell.folder.clone(), ..Shell::of_file(file.format, file.encoding, scene) }
    }

    /// What the materials that the file names look like.
    ///
    /// *Cost*: constant, but for the first time.
    pub(crate) fn materials(&self) -> Arc<[Material]> {
        let of_file =
            |file: &Arc<FileForm>| file.materials.get_or_init(|| file.shape.materials().into()).clone();
        self.file.as_ref().map(of_file).unwrap_or_default()
    }

    /// The files in its folder that it names and that exist.
    pub(crate) fn companions(&self) -> Vec<NamedFile> {
        self.file.as_ref().map_or_else(Vec::new, |file| file.shape.companions())
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

    /// Whether a file of a format is written as the one that was read, with what changed in its meshes; else it is a
    /// new file of one mesh.
    pub fn is_spliced_into(&self, format: Format) -> bool {
        self.file.as_ref().is_some_and(|file| file.shape.is_spliced_into(format))
    }

    /// The file as it was read, with the meshes that its parts have now.
    pub(crate) fn splice(
        &self,
        document: &Document,
        splice: &Splice<'_>,
    ) -> Option<Result<Spliced, WriteErrorKind>> {
        self.file.as_ref().and_then(|file| file.shape.splice(document, splice))
    }

    /// What the file has beside its mesh and a file of another kind won't carry.
    pub(crate) fn losses_in(&self, format: Format) -> Vec<Loss> {
        let Some(file) = &self.file else { return Vec::new() };
        let output = if file.format == format { Output::OfSameFormat } else { Output::OfOtherFormat };
        file.shape.losses_in(output)
    }
}
