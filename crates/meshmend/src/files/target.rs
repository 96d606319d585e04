//! The output that a file is repaired for: what it can hold, and how it stores that.

use meshmend_core::{Domain, DraftError, PolygonMesh, Provenance};
use meshmend_io::{
    Document, Encoding, Format, Placing, Prepared, PreparedDocument, WriteError, WriteErrorKind, WriteOptions,
};
use meshmend_repair::{FaceStorage, Precision, Writing};

use super::PreparedFile;

/// The output that a file is repaired for.
#[derive(Clone, Debug)]
pub struct FileTarget {
    /// What reports and errors call it.
    pub name: String,
    /// How it is written; the shell is that of the file that was read.
    pub options: WriteOptions,
    /// Whether it will be written.
    occasion: Occasion,
}

/// What an output is made ready for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Occasion {
    Writing,
    Rehearsal,
}

impl FileTarget {
    /// An output that will be written.
    pub fn new(name: impl Into<String>, options: WriteOptions) -> Self {
        FileTarget { name: name.into(), options, occasion: Occasion::Writing }
    }

    /// The same output where it will not be written: the report names no output, and still says what would be lost.
    #[must_use]
    pub fn rehearsed(self) -> Self {
        FileTarget { occasion: Occasion::Rehearsal, ..self }
    }

    /// What the report calls the output, if it will be written.
    pub(super) fn named(&self) -> Option<String> {
        (self.occasion == Occasion::Writing).then(|| self.name.clone())
    }

    /// What readers call a file that is written so.
    pub fn variant(&self) -> Option<&'static str> {
        let (format, encoding) = self.options.resolved().ok()?;
        Some(format.variant(encoding))
    }

    /// Whether the file is the one that was read, with what changed in its meshes.
    pub(super) fn is_spliced(&self) -> bool {
        self.options.format.is_some_and(|format| self.options.shell.is_spliced_into(format))
    }

    /// How precisely the file stores positions.
    pub(super) fn precision(&self) -> Precision {
        match self.options.resolved() {
            // Positions stay in the type that they have.
            Ok(_) if self.is_spliced() => Precision::Double,
            Ok((Format::Stl, encoding)) if encoding != Encoding::Ascii => Precision::Single,
            Ok((Format::Glb | Format::Gltf, _)) => Precision::Single,
            _ => Precision::Double,
        }
    }

    /// How the file stores faces. A mesh that can't be prepared is an error only when it is written.
    pub(super) fn storage(&self) -> FaceStorage {
        if self.is_spliced() {
            return FaceStorage::default().written_by(Writing::by(in_rows));
        }
        let holds_polygons = self.options.format.is_none_or(Format::holds_polygons);
        let storage = match self.options.format {
            Some(Format::Stl) => FaceStorage::apart(),
            _ => FaceStorage::default(),
        };
        let options = self.options.clone();
        storage.written_by(Writing::by(move |mesh| {
            let is_made_ready = !holds_polygons || !mesh.layers().is_empty();
            let prepared = is_made_ready.then(|| Prepared::new(mesh, &options).ok()).flatten();
            prepared.map_or(Ok(None), |prepared| prepared.as_written(mesh))
        }))
    }

    /// A mesh that is ready to be written there.
    pub(super) fn prepared(&self, mesh: &PolygonMesh) -> Result<PreparedFile, WriteError> {
        let prepared = Prepared::new(mesh, &self.options).map_err(|kind| self.failed(kind))?;
        Ok(PreparedFile::Mesh(Box::new(prepared)))
    }

    /// A document that is ready to be written there.
    pub(super) fn prepared_document(&self, document: &Document) -> Result<PreparedFile, WriteError> {
        let prepared = PreparedDocument::placed(document, &self.options, Placing::Scene);
        prepared.map(PreparedFile::Parts).map_err(|kind| self.failed(kind))
    }

    fn failed(&self, kind: WriteErrorKind) -> WriteError {
        WriteError { file: self.name.clone(), kind }
    }
}

/// A mesh as a file of parts has it: a vertex once for each row that its corners have. `None` if each has one.
fn in_rows(mesh: &PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, DraftError> {
    let layers = mesh.layers().iter().enumerate();
    let moved =
        layers.filter(|(_, layer)| layer.home() == Domain::Vertex && layer.domain() == Domain::Corner);
    let moved: Vec<usize> = moved.map(|(at, _)| at).collect();
    if moved.is_empty() { Ok(None) } else { mesh.split_for_vertex_layers(&moved).map(Some) }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, VertexId};
    use meshmend_io::{encode, read_bytes};

    use super::*;

    #[test]
    fn what_is_written_has_the_name_that_its_reader_gives_it() {
        for &format in Format::ALL {
            for &encoding in format.encodings() {
                let options = WriteOptions::of(format).with_encoding(encoding);
                let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec());
                let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], faces.unwrap()).unwrap();
                let mut bytes = Vec::new();
                encode(&mesh, &options, &mut bytes).unwrap();
                let name = format!("a.{}", format.extensions()[0]);
                let file = read_bytes(&bytes, &name, &Default::default()).unwrap();
                assert_eq!(Some(file.variant), FileTarget::new(name, options).variant());
            }
        }
    }
}
