//! Inputs as files in a folder, each made once.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use meshmend::{Encoding, Format, WriteOptions, write};

use super::Input;
use crate::failure::Failure;

/// In which form a mesh is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Form {
    PlyBinary,
    PlyAscii,
    Obj,
    Off,
    StlBinary,
    StlAscii,
    Glb,
}

impl Form {
    pub(crate) const ALL: [Form; 7] =
        [Form::PlyBinary, Form::PlyAscii, Form::Obj, Form::Off, Form::StlBinary, Form::StlAscii, Form::Glb];

    /// The end of a file's name.
    pub(crate) fn extension(self) -> &'static str {
        match self {
            Form::PlyBinary => "ply",
            Form::PlyAscii => "ascii.ply",
            Form::Obj => "obj",
            Form::Off => "off",
            Form::StlBinary => "stl",
            Form::StlAscii => "ascii.stl",
            Form::Glb => "glb",
        }
    }

    /// How to write it.
    pub(crate) fn options(self) -> WriteOptions {
        let (format, encoding) = match self {
            Form::PlyBinary => (Format::Ply, Encoding::LittleEndian),
            Form::PlyAscii => (Format::Ply, Encoding::Ascii),
            Form::Obj => (Format::Obj, Encoding::Ascii),
            Form::Off => (Format::Off, Encoding::Ascii),
            Form::StlBinary => (Format::Stl, Encoding::LittleEndian),
            Form::StlAscii => (Format::Stl, Encoding::Ascii),
            Form::Glb => (Format::Glb, Encoding::LittleEndian),
        };
        WriteOptions::of(format).with_encoding(encoding)
    }
}

/// Where inputs are kept.
#[derive(Debug)]
pub(crate) struct Folder {
    path: PathBuf,
    is_temporary: bool,
}

impl Folder {
    /// A folder that stays, with what is in it.
    pub(crate) fn kept(path: &Path) -> Result<Self, Failure> {
        Self::made(path.to_owned(), false)
    }

    /// A folder that goes when it is dropped.
    pub(crate) fn temporary() -> Result<Self, Failure> {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("meshmend-bench-{}-{number}", std::process::id());
        Self::made(std::env::temp_dir().join(name), true)
    }

    fn made(path: PathBuf, is_temporary: bool) -> Result<Self, Failure> {
        std::fs::create_dir_all(&path).map_err(|error| Failure::io(&path, error))?;
        Ok(Folder { path, is_temporary })
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The file of an input, which is written if it is not there.
    pub(crate) fn file(&self, input: &Input, form: Form) -> Result<PathBuf, Failure> {
        let Input { content, order, faces } = input;
        let name = format!("{}-{}-{faces}.{}", content.name(), order.name(), form.extension());
        let path = self.path.join(name);
        if !path.exists() {
            write(&path, &input.mesh()?, &form.options())?;
        }
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if self.is_temporary {
            // What can't be removed now is left to the system.
            let _ = std::fs::remove_dir_all(&self.path);
        }
    }
}
