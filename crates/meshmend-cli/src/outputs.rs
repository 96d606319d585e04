//! Which files a command may write: the one place that decides it, before anything is read.
//!
//! A mesh may take the place of a mesh, the input's too. Nothing else may: a picture or a report does not take the place
//! of a mesh, nor a mesh that of a plan, and no two outputs are one file. Files are compared, not names: links, `./a` and
//! `a` lead to one file, and so may `a` and `A`. `-` is a standard stream and no file, whatever the folder holds.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use meshmend::Format;
use meshmend::formats::target_of;

use crate::failure::Failure;
use crate::streams::is_stream;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    Mesh,
    Picture,
    Report,
    Plan,
}

/// The files that a command reads and writes.
#[derive(Debug, Default)]
pub(crate) struct Files<'a> {
    inputs: Vec<Named<'a>>,
    outputs: Vec<Named<'a>>,
}

/// A file with what says it on the command line.
#[derive(Clone, Copy, Debug)]
struct Named<'a> {
    option: &'static str,
    path: &'a Path,
    content: Content,
}

impl<'a> Files<'a> {
    /// The files of a command that reads a mesh.
    pub(crate) fn of_mesh(input: &'a Path) -> Self {
        Files::default().reading_meshes([input])
    }

    /// These files and one more that is read.
    pub(crate) fn reading(mut self, option: &'static str, path: Option<&'a Path>, content: Content) -> Self {
        self.inputs.extend(path.filter(|path| !is_stream(path)).map(|path| Named { option, path, content }));
        self
    }

    /// These files and meshes that are read.
    pub(crate) fn reading_meshes(self, paths: impl IntoIterator<Item = &'a Path>) -> Self {
        paths.into_iter().fold(self, |files, path| files.reading("the input", Some(path), Content::Mesh))
    }

    /// These files and one more that is written.
    pub(crate) fn writing(mut self, option: &'static str, path: Option<&'a Path>, content: Content) -> Self {
        self.outputs.extend(path.filter(|path| !is_stream(path)).map(|path| Named { option, path, content }));
        self
    }

    /// Fails when a file would take the place of one of another kind, or two outputs that of one another.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        for (place, output) in self.outputs.iter().enumerate() {
            if let Some(identity) = Identity::of(output.path) {
                let is_same = |other: &&Named<'_>| Identity::of(other.path).as_ref() == Some(&identity);
                if let Some(other) = self.outputs[..place].iter().find(is_same) {
                    return Err(
                        output.refused(&format!("would overwrite {}: they are one file", other.shown()))
                    );
                }
                let mut others = self.inputs.iter().filter(|input| input.content != output.content);
                if let Some(input) = others.find(is_same) {
                    return Err(output.refused(&format!("would overwrite {}", input.shown())));
                }
            }
            output.check_name()?;
            output.check_place()?;
        }
        Ok(())
    }
}

impl Named<'_> {
    fn shown(&self) -> String {
        format!("{} {}", self.option, self.path.display())
    }

    fn refused(&self, reason: &str) -> Failure {
        Failure::usage(format!("{} {reason}", self.shown()))
    }

    /// Fails when a picture or a report has the name of a mesh.
    fn check_name(&self) -> Result<(), Failure> {
        match Format::from_path(self.path) {
            Some(format) if self.content != Content::Mesh => {
                let ending = self.path.extension().unwrap_or_default().to_string_lossy();
                Err(self.refused(&format!("has the name of a mesh: .{ending} stands for {format}")))
            }
            _ => Ok(()),
        }
    }

    /// Fails when a picture or a report would take the place of a mesh.
    fn check_place(&self) -> Result<(), Failure> {
        match format_of_content(self.path) {
            Some(format) if self.content != Content::Mesh => {
                Err(self.refused(&format!("would overwrite a mesh ({format})")))
            }
            _ => Ok(()),
        }
    }
}

/// The format that a file surely has by its first bytes; `None` if it is not a regular file, or can't be read.
fn format_of_content(path: &Path) -> Option<Format> {
    const HEAD: u64 = 1 << 16;
    let is_file = fs::metadata(path).is_ok_and(|status| status.is_file());
    let file = is_file.then(|| File::open(path).ok()).flatten()?;
    let mut head = Vec::new();
    file.take(HEAD).read_to_end(&mut head).ok()?;
    Format::from_content(&head)
}

/// What two names have in common that lead to one file.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Identity {
    /// A file that is there, by the numbers of its device and of itself, or else by its whole name.
    There(u64, u64, PathBuf),
    /// A file that is still to be made, by its folder and its name. Names that differ only in case count as one,
    /// which they are to some file systems.
    New(Box<Identity>, String),
}

impl Identity {
    /// The identity of a file that holds what is written to it; `None` for devices and pipes.
    fn of(path: &Path) -> Option<Self> {
        match fs::metadata(path) {
            Ok(status) if status.is_file() => Some(Self::there(path, &status)),
            Ok(_) => None,
            Err(_) => Self::new(&target_of(path)),
        }
    }

    fn new(path: &Path) -> Option<Self> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let status = fs::metadata(folder).ok()?;
        let name = path.file_name()?.to_string_lossy().to_lowercase();
        Some(Identity::New(Box::new(Self::there(folder, &status)), name))
    }

    #[cfg(unix)]
    fn there(_: &Path, status: &fs::Metadata) -> Self {
        use std::os::unix::fs::MetadataExt;
        Identity::There(status.dev(), status.ino(), PathBuf::new())
    }

    #[cfg(not(unix))]
    fn there(path: &Path, _: &fs::Metadata) -> Self {
        Identity::There(0, 0, path.canonicalize().unwrap_or_else(|_| path.to_owned()))
    }
}
