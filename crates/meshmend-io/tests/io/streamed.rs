//! Files whose rows are handed over one by one say what they say when they are read whole.

use std::fs;
use std::path::Path;

use meshmend_core::{Cancelled, FaceTableBuilder, VertexId};
use meshmend_io::{
    Announced, Encoding, Format, Limits, MeshSink, ReadError, ReadErrorKind, ReadOptions, Streamed, read,
    stream,
};

use crate::common::{Folder, shared};

/// Keeps what it is told, up to a number of faces.
#[derive(Default)]
struct Kept {
    announced: Option<Announced>,
    positions: Vec<[f64; 3]>,
    faces: Vec<Vec<VertexId>>,
    most: Option<usize>,
}

impl MeshSink for Kept {
    fn begin(&mut self, announced: &Announced) -> Result<(), Cancelled> {
        self.announced = Some(*announced);
        Ok(())
    }

    fn vertices(&mut self, positions: &[[f64; 3]]) -> Result<(), Cancelled> {
        self.positions.extend_from_slice(positions);
        Ok(())
    }

    fn face(&mut self, vertices: &[VertexId]) -> Result<(), Cancelled> {
        self.faces.push(vertices.to_vec());
        if self.most == Some(self.faces.len()) { Err(Cancelled) } else { Ok(()) }
    }
}

fn streamed(path: &Path, options: &ReadOptions) -> (Kept, Result<Streamed, ReadError>) {
    let mut kept = Kept::default();
    let streamed = stream(path, options, &mut kept);
    (kept, streamed)
}

/// Compares both ways to read a file; whether its rows can be handed over at all.
#[track_caller]
fn assert_alike(path: &Path) -> bool {
    let (options, name) = (ReadOptions::default(), path.display());
    let (kept, streamed) = streamed(path, &options);
    let whole = read(path, &options);
    match (streamed, whole) {
        (Err(ReadError { kind: ReadErrorKind::NotInRows, .. }), _) => return false,
        (Ok(streamed), Ok(whole)) => {
            assert_eq!((streamed.format, streamed.variant), (whole.format, whole.variant), "{name}");
            assert_eq!(streamed.notes, whole.notes, "{name}");
            assert_eq!(streamed.loose_edges, whole.mesh.loose_edges(), "{name}");
            let bits = |points: &[[f64; 3]]| points.iter().map(|p| p.map(f64::to_bits)).collect::<Vec<_>>();
            assert_eq!(bits(&kept.positions), bits(whole.mesh.positions()), "{name}");
            let mut faces = FaceTableBuilder::default();
            kept.faces.iter().for_each(|face| faces.push_face(face.iter().copied()));
            assert_eq!(&faces.build(kept.positions.len()).unwrap(), whole.mesh.faces(), "{name}");
            let announced = kept.announced.unwrap();
            assert_eq!(announced.vertices, kept.positions.len() as u64, "{name}");
            assert_eq!(announced.faces, kept.faces.len() as u64, "{name}");
            assert!(announced.corners >= kept.faces.iter().map(Vec::len).sum::<usize>() as u64, "{name}");
            let soup = (0..)
                .zip(&kept.faces)
                .all(|(f, face)| face[..] == [3 * f, 3 * f + 1, 3 * f + 2].map(VertexId));
            assert!(soup || !announced.is_soup, "{name}");
            let are_single = kept.positions.iter().flatten().all(|&x| x.is_nan() || f64::from(x as f32) == x);
            assert!(are_single || !announced.is_single, "{name}");
        }
        (Err(streamed), Err(whole)) => assert_eq!(streamed.to_string(), whole.to_string()),
        (streamed, whole) => panic!("{name}: {streamed:?}, {whole:?}"),
    }
    true
}

/// A PLY of these statements and bytes.
fn ply(statements: &str, rows: &[&[u8]]) -> Vec<u8> {
    [format!("ply\nformat {statements}end_header\n").as_bytes(), &rows.concat()].concat()
}

#[test]
fn small_files_of_every_shape_are_alike() {
    let folder = Folder::new("streamed");
    let points: Vec<u8> = (0..9u8).flat_map(|i| f32::from(i * i % 7).to_le_bytes()).collect();
    let vertex =
        "binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let face = "element face 2\nproperty list uchar int vertex_indices\n";
    let index = |v: i32| v.to_le_bytes();
    let triangle = |v: [i32; 3]| [&[3][..], &v.map(index).concat()].concat();
    let (one, two) = (triangle([0, 1, 2]), [&[0][..], &triangle([2, 2, 1])].concat());
    let cases: Vec<Vec<u8>> = vec![
        ply(&format!("{vertex}{face}"), &[&points, &one, &triangle([2, 1, 0])]),
        // Faces without corners, faces before vertices, an element that nobody knows, edges, bytes after the end.
        ply(
            &format!("{vertex}element face 3\nproperty list uchar int vertex_index\n"),
            &[&points, &two, &one],
        ),
        ply(
            &format!("binary_little_endian 1.0\n{face}{}", vertex.split_once('\n').unwrap().1),
            &[&one, &triangle([0, 2, 1]), &points],
        ),
        ply(
            &format!(
                "{vertex}element odd 2\nproperty short n\n{face}element edge 1\nproperty int vertex1\nproperty int vertex2\n"
            ),
            &[&points, &[1, 0, 2, 0], &one, &one, &index(2), &index(0), b"more"],
        ),
        ply(
            &format!("{vertex}element edge 1\nproperty int from\nproperty list uchar short to\n"),
            &[&points, &index(2), &[2, 1, 0, 2, 0]],
        ),
        // Lists among vertices, numbers beside the indices.
        ply(
            "binary_big_endian 1.0\nelement vertex 1\nproperty double x\nproperty list uchar uchar l\nproperty short y\nproperty uchar z\n",
            &[&1.5f64.to_be_bytes(), &[2, 8, 9], &[0, 7], &[3]],
        ),
        ply(
            &format!("{vertex}{face}property uchar red\nproperty list uchar float texcoord\n"),
            &[&points, &one, &[9, 0], &one, &[8, 1], &1f32.to_le_bytes()],
        ),
        // Not finite, and nothing at all.
        ply(vertex, &[&f32::NAN.to_le_bytes(), &points[4..]]),
        ply("binary_little_endian 1.0\n", &[]),
        // An index beyond, one below 0, one that is none, a list that is cut, a missing coordinate, a missing list.
        ply(&format!("{vertex}{face}"), &[&points, &triangle([0, 5, 2]), &triangle([9, 1, 7])]),
        ply(&format!("{vertex}{face}"), &[&points, &one, &triangle([0, -1, 7])]),
        ply(
            &format!("{vertex}element face 1\nproperty list uchar float vertex_indices\n"),
            &[&points, &[1], &0.5f32.to_le_bytes()],
        ),
        ply(&format!("{vertex}{face}"), &[&points, &one, &[200, 1]]),
        ply(&vertex.replace("float y", "float w"), &[&points]),
        ply(&format!("{vertex}element face 1\nproperty uchar n\n"), &[&points, &[1]]),
        ply(
            &format!("{vertex}element edge 1\nproperty int vertex1\nproperty int vertex2\n"),
            &[&points, &index(7), &index(0)],
        ),
    ];
    for (case, bytes) in cases.iter().enumerate() {
        let path = folder.0.join(format!("{case}.ply"));
        fs::write(&path, bytes).unwrap();
        assert!(assert_alike(&path), "case {case}");
    }
    // A name that says something else, and every place at which a file can be cut.
    let path = folder.0.join("wrong.obj");
    fs::write(&path, &cases[3]).unwrap();
    assert!(assert_alike(&path));
    for end in 0..cases[3].len() {
        fs::write(&path, &cases[3][..end]).unwrap();
        assert_alike(&path);
    }
}

#[test]
fn files_of_many_blocks_are_alike() {
    let folder = Folder::new("streamed-large");
    let mesh = crate::blocks::large();
    let mut seen = 0;
    for (format, encoding) in [
        (Format::Ply, Encoding::LittleEndian),
        (Format::Ply, Encoding::BigEndian),
        (Format::Stl, Encoding::LittleEndian),
    ] {
        let (bytes, _) = crate::common::written(&mesh, format, encoding);
        let path = folder.0.join(format!("large.{}", format.extensions()[0]));
        fs::write(&path, &bytes).unwrap();
        seen += usize::from(assert_alike(&path));
        fs::write(&path, &bytes[..bytes.len() - 3]).unwrap();
        seen += usize::from(assert_alike(&path));
    }
    assert_eq!(seen, 6);
}

#[test]
fn the_files_of_the_corpus_are_alike() {
    let mut seen = 0;
    for name in ["corpus", "torture", "field", "geometry"] {
        let Some(folder) = shared(name) else { return };
        let files = walk(&folder);
        let is_row = |path: &&std::path::PathBuf| path.extension().is_some_and(|e| e == "ply" || e == "stl");
        seen += files.iter().filter(is_row).filter(|path| assert_alike(path)).count();
    }
    assert!(seen > 100, "{seen}");
}

fn walk(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    files.into_iter().chain(folders.iter().flat_map(|folder| walk(folder))).collect()
}

#[test]
fn text_and_other_formats_are_not_read_in_rows_and_limits_hold() {
    let folder = Folder::new("streamed-refused");
    let refused = |name: &str, text: &str| {
        let path = folder.0.join(name);
        fs::write(&path, text).unwrap();
        streamed(&path, &ReadOptions::default()).1.unwrap_err().to_string()
    };
    let why = "only binary PLY without strips and binary STL can be read piece by piece";
    for (name, text) in [
        ("a.obj", "v 0 0 0\n"),
        ("a.stl", "solid a\nendsolid\n"),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"),
        ("b.ply", "ply\nformat binary_little_endian 1.0\nelement tristrips 0\nend_header\n"),
    ] {
        assert!(refused(name, text).ends_with(why), "{name}");
    }
    let path = folder.0.join("c.stl");
    fs::write(&path, [&[0; 80][..], &2u32.to_le_bytes(), &[0; 100]].concat()).unwrap();
    let limited = |limits| streamed(&path, &ReadOptions::default().with_limits(limits)).1.map(drop);
    assert!(limited(Limits::default()).is_ok());
    let error = limited(Limits::default().with_max_faces(1)).unwrap_err().to_string();
    assert!(error.ends_with("2 faces are more than the limit of 1 (max_faces)"), "{error}");
}

#[test]
fn a_sink_that_wants_no_more_gets_no_more() {
    let folder = Folder::new("streamed-stopped");
    let path = folder.0.join("a.stl");
    fs::write(&path, [&[0; 80][..], &9u32.to_le_bytes(), &[0; 450]].concat()).unwrap();
    let mut kept = Kept { most: Some(4), ..Kept::default() };
    let error = stream(&path, &ReadOptions::default(), &mut kept).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::Cancelled(_)));
    assert_eq!(kept.faces.len(), 4);
}
