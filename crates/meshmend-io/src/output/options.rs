//! How to write.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use meshmend_core::Watch;

use crate::paths::folder_of;
use crate::{Encoding, Format, Material, ReadFile, Shell, WriteErrorKind};

/// How to write.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// The format; by default that of the file name.
    pub format: Option<Format>,
    /// How to spell numbers; by default as in the file that the mesh comes from, if it has the same format; else in
    /// the default encoding of the format.
    pub encoding: Option<Encoding>,
    /// How the file that the mesh comes from was written. A file of the same format is written likewise.
    pub shell: Shell,
    /// What becomes of a vertex whose attributes differ from corner to corner.
    pub seams: Seams,
    /// The precision of attributes that come from another format.
    pub precision: AttributePrecision,
    /// Whether meshes of a glTF that was read are to say which of their vertices are one.
    pub manifold_extension: ManifoldExtension,
    /// The folder of the output, if it is known: files that the output names stand there.
    pub folder: Option<PathBuf>,
    /// The name of the output without its extension, if it is known: files that are made beside it begin so.
    pub stem: Option<String>,
    /// What becomes of the files that the output names.
    pub companions: Companions,
    /// What materials look like; by default as the file says that the mesh comes from.
    pub materials: Option<Arc<[Material]>>,
    /// Who watches the writing, and may stop it.
    pub watch: Watch,
}

/// What becomes of the files that an output names, such as material libraries and pictures, when it is written into
/// another folder than that of the input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Companions {
    /// They are copied, and those that are made from the input are written. A different file is never overwritten.
    #[default]
    Copy,
    /// They stay where they are, and none is made.
    Skip,
}

/// What becomes of a vertex whose attributes differ from corner to corner, in a format whose programs look for
/// attributes at the vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Seams {
    /// It is written as several vertices at one place, each with its own values.
    #[default]
    Split,
    /// It is written once. The values are written at the corners if the format can do that, though other programs may
    /// not look there; else they are lost.
    Corners,
    /// The mesh is not written.
    Fail,
}

/// What becomes of `EXT_mesh_manifold`, by which a glTF says which vertices are one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ManifoldExtension {
    /// Meshes that have it keep it.
    #[default]
    AsRead,
    /// Each mesh of the file that is a closed manifold of one set of vertices has it, so that vertices that were split
    /// stay apart for those that know it.
    Add,
}

/// The precision of attributes that come from another format, in a format whose programs expect single precision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum AttributePrecision {
    /// As those programs expect: texture coordinates and normals in single precision, colours as bytes if they come
    /// from bytes. A loss names what is rounded.
    #[default]
    AsExpected,
    /// Double precision, as in the mesh.
    Double,
}

impl WriteOptions {
    /// A format in its default encoding.
    pub fn of(format: Format) -> Self {
        WriteOptions { format: Some(format), ..WriteOptions::default() }
    }

    /// These options with an encoding.
    pub fn with_encoding(self, encoding: Encoding) -> Self {
        WriteOptions { encoding: Some(encoding), ..self }
    }

    /// These options with another choice for vertices whose attributes differ from corner to corner.
    pub fn with_seams(self, seams: Seams) -> Self {
        WriteOptions { seams, ..self }
    }

    /// These options with another precision of attributes from other formats.
    pub fn with_precision(self, precision: AttributePrecision) -> Self {
        WriteOptions { precision, ..self }
    }

    /// These options with another choice for the files that the output names.
    pub fn with_companions(self, companions: Companions) -> Self {
        WriteOptions { companions, ..self }
    }

    /// These options, for a mesh whose materials look so.
    pub fn with_materials(self, materials: impl Into<Arc<[Material]>>) -> Self {
        WriteOptions { materials: Some(materials.into()), ..self }
    }

    /// These options with another choice for `EXT_mesh_manifold`.
    pub fn with_manifold_extension(self, manifold_extension: ManifoldExtension) -> Self {
        WriteOptions { manifold_extension, ..self }
    }

    /// These options for writing that is watched.
    pub fn with_watch(self, watch: &Watch) -> Self {
        WriteOptions { watch: watch.clone(), ..self }
    }

    /// These options, for a mesh that comes from a file with this shell.
    pub fn with_shell(self, shell: Shell) -> Self {
        WriteOptions { shell, ..self }
    }

    /// These options; what they leave open is done as in a file that was read, if it has the same format.
    pub fn as_read(self, file: &ReadFile) -> Self {
        WriteOptions { shell: file.shell.clone(), ..self }
    }

    /// These options with the folder of a file, and with the format of its name if they name none.
    pub fn for_path(self, path: &Path) -> Self {
        let format = self.format.or_else(|| Format::from_path(path));
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        WriteOptions { format, folder: Some(folder_of(path).to_owned()), stem, ..self }
    }

    /// The format and the encoding that follow from these options.
    ///
    /// # Errors
    /// If they name no format, or an encoding that the format lacks.
    pub fn resolved(&self) -> Result<(Format, Encoding), WriteErrorKind> {
        let format = self.format.ok_or(WriteErrorKind::UnknownFormat)?;
        let as_read = self.shell.encoding().filter(|_| self.shell.format() == Some(format));
        let usual = as_read.or_else(|| format.encodings().first().copied());
        let encoding = self.encoding.or(usual).unwrap_or(Encoding::Ascii);
        if format.encodings().contains(&encoding) {
            Ok((format, encoding))
        } else {
            Err(WriteErrorKind::NoSuchEncoding { format, encoding })
        }
    }
}
