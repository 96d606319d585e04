//! Meshes of other formats become new GLB and glTF files that the validator of glTF's makers takes, with the faces that
//! they had.

use std::fs;

use meshmend_io::{Format, LossKind, ReadOptions, WriteOptions, read, write};
use meshmend_tests::corpus::corpus;
use meshmend_tests::gltf_judges::validated;
use meshmend_tests::scratch::Scratch;

/// Larger files take the validator long.
const MOST_BYTES: u64 = 1 << 21;

#[test]
fn new_files_of_the_corpus_are_valid_and_have_its_faces() {
    let Some(entries) = corpus() else { return };
    let scratch = Scratch::new();
    let (mut files, mut triangles) = (Vec::new(), Vec::new());
    let is_small = |path: &std::path::Path| fs::metadata(path).is_ok_and(|status| status.len() <= MOST_BYTES);
    for (number, entry) in
        entries.iter().filter(|entry| entry.is_well_formed() && is_small(&entry.path)).enumerate()
    {
        let Ok(file) = read(&entry.path, &ReadOptions::default()) else { continue };
        if matches!(file.format, Format::Glb | Format::Gltf) {
            continue;
        }
        for format in [Format::Glb, Format::Gltf] {
            let folder = scratch.path().join(number.to_string());
            fs::create_dir_all(&folder).unwrap();
            let path = folder.join(format!("new.{}", format.extensions()[0]));
            let losses = write(&path, &file.mesh, &WriteOptions::default().as_read(&file)).unwrap();
            let again = read(&path, &ReadOptions::default()).unwrap();
            let is_whole = !losses.iter().any(|loss| {
                matches!(loss.kind, LossKind::Polygons | LossKind::ShortFaces | LossKind::NonFiniteFaces)
            });
            if is_whole {
                assert_eq!(again.mesh.counts().faces, file.mesh.counts().faces, "{}", entry.name);
            }
            triangles.push(again.mesh.counts().faces as u64);
            files.push(path);
        }
    }
    assert!(files.len() > 200, "only {} files", files.len());
    let Some(answers) = validated(&files) else { return };
    for ((file, answer), triangles) in files.iter().zip(answers).zip(triangles) {
        assert_eq!(answer.errors, [""; 0], "{}", file.display());
        assert_eq!(answer.triangles.unwrap_or(0), triangles, "{}", file.display());
    }
}
