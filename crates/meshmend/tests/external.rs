//! A check within a bound of memory says what a check in memory says, byte for byte, in any number of parts.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use std::fs;
use std::path::{Path, PathBuf};

use meshmend::formats::{ReadErrorKind, write};
use meshmend::mesh::PolygonMesh;
use meshmend::report::{CheckDocument, json};
use meshmend::{
    CheckOptions, DefectKind, Distance, Encoding, ExternalError, ExternalOptions, Format, Kernels,
    ReadOptions, View, WriteOptions, check, check_external, read,
};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::catalogue;
use meshmend_testkit::worlds::{any_table, damaged_shape, triangle_soup};
use proptest::prelude::*;

/// A file that is removed again.
struct File(PathBuf);

impl File {
    fn new(name: &str) -> Self {
        File(std::env::temp_dir().join(format!("meshmend-external-{}-{name}", std::process::id())))
    }

    /// The file of a mesh.
    fn of(name: &str, mesh: &PolygonMesh, format: Format, encoding: Encoding) -> Self {
        let file = File::new(&format!("{name}.{}", format.extensions()[0]));
        write(&file.0, mesh, &WriteOptions::of(format).with_encoding(encoding)).unwrap();
        file
    }
}

impl Drop for File {
    fn drop(&mut self) {
        fs::remove_file(&self.0).ok();
    }
}

const LIMIT: usize = 4;

/// Every kind that is listed on request alone is asked for.
const ASKED: [DefectKind; 2] = [DefectKind::PolygonFace, DefectKind::NonFiniteFace];

/// What a check in memory says.
fn in_memory(path: &Path, view: View) -> String {
    let file = read(path, &ReadOptions::default()).unwrap();
    let report = check(&file.mesh, &CheckOptions::default().with_view(view)).unwrap().listing(&ASKED);
    json(&CheckDocument::new(report, LIMIT).of_file(path.display().to_string(), &file)).unwrap()
}

fn options(is_welded: impl Into<Option<bool>>, parts: Option<usize>) -> ExternalOptions {
    let mut options = ExternalOptions::within(1 << 30);
    (options.is_welded, options.limit, options.parts) = (is_welded.into(), LIMIT, parts);
    options
}

fn external(path: &Path, options: &ExternalOptions) -> Result<String, ExternalError> {
    let report = check_external(path, options, Kernels::builtin())?.listing(&ASKED);
    Ok(json(&CheckDocument::of_external(&report, path.display().to_string(), LIMIT)).unwrap())
}

/// Compares both checks of a file; whether its rows can be read one by one.
fn assert_alike(path: &Path, parts: &[Option<usize>]) -> bool {
    for (is_welded, view) in [(false, View::Indexed), (true, View::Welded(Distance::Exact))] {
        let mut expected = None;
        for &parts in parts {
            match external(path, &options(is_welded, parts)) {
                Err(ExternalError::Read(_)) => return false,
                Err(error) => panic!("{}: {error}", path.display()),
                Ok(found) => {
                    let expected = expected.get_or_insert_with(|| in_memory(path, view));
                    assert!(
                        &found == expected,
                        "{} in {parts:?} parts:\n{found}\n{expected}",
                        path.display()
                    );
                }
            }
        }
    }
    true
}

/// Compares both checks of a mesh, as PLY and as STL.
fn assert_alike_as_files(name: &str, mesh: &PolygonMesh, parts: &[Option<usize>]) {
    for (format, encoding) in [(Format::Ply, Encoding::LittleEndian), (Format::Stl, Encoding::LittleEndian)] {
        assert!(assert_alike(&File::of(name, mesh, format, encoding).0, parts), "{name}");
    }
}

/// How many parts each mesh is put in: as many as fit, one, some, and more than it has vertices.
const PARTS: [Option<usize>; 4] = [None, Some(1), Some(7), Some(64)];

#[test]
fn shapes_with_known_answers_are_alike_in_any_number_of_parts() {
    for (number, shape) in catalogue().iter().enumerate() {
        assert_alike_as_files(&format!("shape-{number}"), &shape.soup.mesh(), &PARTS);
    }
}

#[test]
fn every_file_of_the_corpus_is_alike() {
    let mut seen = 0;
    for name in ["corpus", "torture", "field", "geometry"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared").join(name);
        if !folder.exists() {
            println!("skipped: there is no {}", folder.display());
            return;
        }
        for path in files(&folder) {
            seen += usize::from(assert_alike(&path, &[Some(1), Some(7)]));
            // What is text, or in another format, is written as rows first.
            let Ok(file) = read(&path, &ReadOptions::default()) else { continue };
            if file.mesh.counts().faces < 20_000 {
                let file = File::of(&format!("corpus-{seen}"), &file.mesh, Format::Ply, Encoding::BigEndian);
                seen += usize::from(assert_alike(&file.0, &[Some(3)]));
            }
        }
    }
    assert!(seen > 400, "{seen}");
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    files.into_iter().chain(folders.iter().flat_map(|folder| self::files(folder))).collect()
}

fn assert_random(name: &str, soup: &Soup, parts: usize) -> Result<(), TestCaseError> {
    assert_alike_as_files(name, &soup.mesh(), &[Some(parts)]);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn tables_of_any_shape_are_alike(soup in any_table(12), parts in 1..6usize) {
        assert_random("any", &soup, parts)?;
    }

    #[test]
    fn dense_soups_are_alike(soup in triangle_soup(40), parts in 1..6usize) {
        assert_random("dense", &soup, parts)?;
    }

    #[test]
    fn damaged_shapes_are_alike((_, _, soup) in damaged_shape(), parts in 1..9usize) {
        assert_random("damaged", &soup, parts)?;
    }
}

/// The memory decides on the parts, and parts that are too large are put in parts again.
#[test]
fn a_small_bound_is_enough_for_a_mesh_of_some_size() {
    let shape = meshmend::shapes::torus(400, 300).unwrap().mesh;
    assert_alike_as_files("torus", &shape, &[None]);
    let mut small = options(false, None);
    small.memory = 40 << 20;
    let file = File::of("bounded", &shape, Format::Ply, Encoding::LittleEndian);
    assert_eq!(external(&file.0, &small).unwrap(), in_memory(&file.0, View::Indexed));
}

#[test]
fn what_does_not_fit_and_what_is_not_in_rows_is_said() {
    let mesh = catalogue()[0].soup.mesh();
    let file = File::of("little", &mesh, Format::Ply, Encoding::LittleEndian);
    let mut little = options(false, None);
    little.memory = 1 << 20;
    let error = external(&file.0, &little).unwrap_err();
    assert!(matches!(error, ExternalError::Memory { .. }), "{error}");
    assert!(error.to_string().contains("more than the 1.0 MiB that may be used"), "{error}");
    let text = File::of("text", &mesh, Format::Ply, Encoding::Ascii);
    match external(&text.0, &options(false, None)).unwrap_err() {
        ExternalError::Read(error) => assert!(matches!(error.kind, ReadErrorKind::NotInRows)),
        other => panic!("{other}"),
    }
    let mut nowhere = options(false, None);
    nowhere.folder = "no/such/folder".into();
    assert!(external(&file.0, &nowhere).unwrap_err().to_string().starts_with("no/such/folder: "));
}
