//! Files of several meshes: any bytes end in a document or in an error, and a document is written as it was read.

use meshmend_io::{
    Format, Limits, PreparedDocument, ReadErrorKind, ReadOptions, WriteOptions, read_document_bytes,
};

use crate::compare::{assert_located, assert_well_formed};

/// The bytes as a glTF file, as JSON or as GLB.
pub fn gltf(data: &[u8]) {
    let options = ReadOptions::default().with_format(Format::Gltf);
    let document = match read_document_bytes(data, "mesh", &options) {
        Ok(document) => document,
        Err(error) => return assert_located(&error, data),
    };
    document.parts.iter().for_each(|part| assert_well_formed(&part.mesh));
    let counts = document.parts.iter().map(|part| part.mesh.counts());
    let [faces, corners] =
        counts.fold([0, 0], |[f, c], part| [f + part.faces as u64, c + part.corners as u64]);
    let read = |limits| read_document_bytes(data, "mesh", &options.clone().with_limits(limits));
    if faces > 0 {
        let error = read(Limits::default().with_max_faces(faces - 1)).expect_err("a limit is exceeded");
        assert!(matches!(error.kind, ReadErrorKind::LimitExceeded { .. }), "{error}");
    }
    assert!(read(Limits::default().with_max_faces(faces).with_max_corners(corners)).is_ok());
    for format in [Format::Glb, Format::Gltf] {
        let Ok(prepared) = PreparedDocument::new(&document, &WriteOptions::of(format)) else { continue };
        let mut bytes = Vec::new();
        prepared.encode(&mut bytes).expect("bytes take all that is written");
    }
}
