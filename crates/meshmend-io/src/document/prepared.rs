//! A document that is ready to be written.

use std::io::{self, Write};
use std::path::Path;

use meshmend_core::Watch;

use crate::document::Placing;
use crate::output::companions::{self, Companion, write_with};
use crate::shell::{Splice, Spliced};
use crate::watched::WatchedWrite;
use crate::{
    Companions, Document, Encoding, Format, Loss, Prepared, WriteError, WriteErrorKind, WriteOptions,
};

/// A document as a file will hold it, ready to be written.
#[derive(Clone, Debug)]
pub struct PreparedDocument {
    format: Format,
    encoding: Encoding,
    content: Content,
    watch: Watch,
}

#[derive(Clone, Debug)]
enum Content {
    /// The file as it was read, with what changed.
    Spliced { spliced: Spliced, companions: Vec<Companion> },
    /// A new file of one mesh.
    New(Box<Prepared>),
}

impl PreparedDocument {
    /// Makes a document ready. The options must name a format. A file of the kind that was read keeps all that is
    /// round its meshes; in another format its parts become one mesh, placed as the options say.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    ///
    /// *Cost*: linear in the document, unless it has one mesh.
    pub fn new(document: &Document, options: &WriteOptions) -> Result<Self, WriteErrorKind> {
        PreparedDocument::placed(document, options, Placing::default())
    }

    /// The same, with a choice of how parts become one mesh in another format.
    ///
    /// # Errors
    /// As [`PreparedDocument::new`].
    pub fn placed(
        document: &Document,
        options: &WriteOptions,
        placing: Placing,
    ) -> Result<Self, WriteErrorKind> {
        let (format, encoding) = options.resolved()?;
        let watch = options.watch.clone();
        watch.look("prepare", 0, 0)?;
        if let Some(spliced) = document.shell.splice(document, &Splice { format, options }) {
            let content = Content::of_spliced(spliced?, &options.clone().with_shell(document.shell.clone()));
            return Ok(PreparedDocument { format, encoding, content, watch });
        }
        let file = document.clone().into_mesh(placing)?;
        let prepared = Prepared::new(&file.mesh, &options.clone().as_read(&file))?;
        Ok(PreparedDocument { format, encoding, content: Content::New(Box::new(prepared)), watch })
    }

    /// The format in which it will be written.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The encoding in which it will be written.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// What the file won't carry.
    ///
    /// *Cost*: that of [`Prepared::losses`].
    pub fn losses(&self) -> Vec<Loss> {
        match &self.content {
            Content::Spliced { spliced, .. } => spliced.losses.clone(),
            Content::New(prepared) => prepared.losses(),
        }
    }

    /// Writes it to a file, whole or not at all (see [`replace_file`](crate::replace_file)).
    ///
    /// # Errors
    /// As [`Prepared::write`].
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        match &self.content {
            Content::Spliced { spliced, companions } => {
                let failed = |kind| WriteError { file: path.display().to_string(), kind };
                let write = |out: &mut dyn io::Write| {
                    Ok(WatchedWrite::new(out, &self.watch).write_all(&spliced.bytes)?)
                };
                write_with(path, companions, write).map_err(failed)
            }
            Content::New(prepared) => prepared.write(path),
        }
    }

    /// Writes it to any sink.
    ///
    /// # Errors
    /// As [`Prepared::encode`].
    pub fn encode(&self, out: &mut dyn io::Write) -> Result<(), WriteError> {
        match &self.content {
            Content::Spliced { spliced, .. } => {
                let failed = |error: io::Error| WriteError { file: "output".to_owned(), kind: error.into() };
                WatchedWrite::new(out, &self.watch).write_all(&spliced.bytes).map_err(failed)
            }
            Content::New(prepared) => prepared.encode(out),
        }
    }
}

impl Content {
    /// A file that was spliced, with the files that it names: those that were made, and copies of the others.
    fn of_spliced(mut spliced: Spliced, options: &WriteOptions) -> Self {
        let named = options.shell.companions();
        let made = |name: &[u8]| spliced.companions.iter().any(|(other, _)| other == name);
        let others: Vec<&[u8]> = named.iter().map(|file| &file.name[..]).filter(|name| !made(name)).collect();
        let mut companions = options.copies(others.into_iter());
        spliced.losses.extend(options.stay_loss(&named));
        if options.companions == Companions::Copy {
            let made = spliced.companions.iter().map(|(name, bytes)| Companion {
                name: name.clone(),
                content: companions::Content::Bytes(bytes.clone().into()),
            });
            companions.extend(made);
        }
        Content::Spliced { spliced, companions }
    }
}
