//! What the STL readers and writers promise.

use crate::common::{
    assert_kept, faces, layer, names, note, read as read_as, refused as refused_as, try_read, written,
};
use meshmend_core::{Carry, Domain, FaceTable, Layer, Metadata, NO_VALUE, PolygonMesh, Values, VertexId};
use meshmend_io::{
    Encoding, Format, Limits, Loss, LossKind, NoteKind, Place, ReadErrorKind, ReadFile, ReadOptions,
    read_bytes,
};

fn read(bytes: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Stl, bytes)
}

fn refused(bytes: impl AsRef<[u8]>) -> (Place, String) {
    refused_as(Format::Stl, bytes)
}

/// A binary file with a header, a count, and facets of which each has its own number as attribute.
fn binary(header: &str, count: u32, facets: usize) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for facet in 0..facets {
        let numbers = [f32::NAN, f32::INFINITY, 0.0, facet as f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.1];
        bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend((facet as u16).to_le_bytes());
    }
    bytes
}

const FACET: &str =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

#[test]
fn binary_facets_have_their_own_vertices_and_single_coordinates() {
    let file = read(binary("a header", 2, 2));
    assert_eq!((file.variant, file.notes.len()), ("stl-binary", 0));
    assert_eq!(faces(&file.mesh), [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(file.mesh.positions()[2], [0.0, 1.0, f64::from(0.1_f32)]);
    assert_eq!(file.mesh.positions()[3], [1.0, 0.0, 0.0]);
    assert_eq!(layer(&file.mesh, "attribute", Domain::Face).values(), &Values::U16(vec![0, 1]));
    let plain = read(binary(&"\0".repeat(80), 1, 1)).mesh;
    assert_eq!((plain.layers(), plain.metadata()), (&[][..], &[][..]));
}

#[test]
fn a_file_of_its_own_exact_size_is_binary_whatever_its_header_says() {
    assert_eq!(read(binary("solid like text\nfacet normal 0 0 0", 3, 3)).variant, "stl-binary");
    let text = format!("solid {}\n{FACET}endsolid\n", "x".repeat(1000));
    // Cut the name so that the size is 84 + 50 n, which could also be a binary file of that size.
    let surplus = (text.len() - 84) % 50;
    let text = text.replacen(&"x".repeat(surplus), "", 1);
    assert_eq!((text.len() - 84) % 50, 0);
    assert_eq!(read(text).variant, "stl-ascii");
}

#[test]
fn a_count_that_does_not_fit_the_size_is_refused() {
    assert_eq!(
        refused(binary("", 3, 2)),
        (Place::Byte(184), "3 facets are announced, there is room for 2".to_owned())
    );
    assert_eq!(refused(binary("", u32::MAX, 2)).1, "4294967295 facets are announced, there is room for 2");
    assert_eq!(
        refused(binary("", 1, 2)),
        (Place::Byte(80), "1 facet is announced, but 2 are there".to_owned())
    );
    assert_eq!(refused(&binary("", 2, 2)[..183]).1, "2 facets are announced, there is room for 1");
    assert_eq!(refused(&binary("", 2, 2)[..83]).0, Place::Byte(83));
    assert_eq!(refused([]).1, "the file is empty");
}

/// Only control characters where the count would be tell binary content.
#[test]
fn wrong_text_with_a_control_character_in_its_name_is_refused_as_text() {
    let name = "a\u{1}".to_owned() + &"x".repeat(100);
    let text = format!("solid {name}\n{}endsolid\n", FACET.replace("outer", "inner"));
    assert_eq!(refused(text), (Place::Line(3), "`inner` where `outer` belongs".to_owned()));
}

#[test]
fn a_few_surplus_bytes_are_noted_also_after_a_header_like_text() {
    for header in ["", "solid x"] {
        let mut bytes = binary(header, 2, 2);
        bytes.extend([0; 3]);
        let file = read(bytes);
        let surplus = note(&file, NoteKind::SurplusData);
        assert_eq!((surplus.count, surplus.first.clone(), file.variant), (3, Place::Byte(184), "stl-binary"));
    }
}

#[test]
fn text_is_read_in_any_case_and_layout() {
    let plain = format!("solid name\n{FACET}endsolid name\n");
    for text in [
        plain.to_ascii_uppercase(),
        plain.replace('\n', "\r\n"),
        plain.replace('\n', " "),
        plain.replace('\n', "\r"),
        plain.replace(' ', " \t "),
        format!("\u{feff}{plain}"),
        format!("  \n{plain}"),
        plain.replace("0 0 1\n", "nan -nan(ind) 1.#QNAN\n"),
        plain.replace("normal 0 0 1\n", "\n"),
    ] {
        let file = read(&text);
        assert_eq!((faces(&file.mesh), file.variant), (vec![vec![0, 1, 2]], "stl-ascii"), "{text:?}");
        assert_eq!(file.mesh.positions(), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    }
}

#[test]
fn one_name_is_of_the_file_and_several_are_of_the_faces() {
    let mesh = read(b"solid caf\xe9 au lait\nendsolid\n").mesh;
    assert_eq!(
        (mesh.metadata()[0].key.as_str(), &mesh.metadata()[0].value[..]),
        ("solid", &b"caf\xe9 au lait"[..])
    );
    let solid = |name: &str| format!("solid {name}\n{FACET}{FACET}endsolid {name}\n");
    let mesh = read([solid("a"), solid(""), solid("b c"), solid("a")].concat()).mesh;
    let of_faces = names(layer(&mesh, "object", Domain::Face));
    let expected = ["a", "a", "", "", "b c", "b c", "a", "a"];
    assert_eq!(of_faces, expected.map(|name| (!name.is_empty()).then(|| name.to_owned())));
    let on_one_line = [solid("a"), solid("b")].concat().replace('\n', " ");
    assert_eq!(names(layer(&read(on_one_line).mesh, "object", Domain::Face)).len(), 4);
}

#[test]
fn solids_without_a_facet_are_noted_and_the_rest_are_as_if_alone() {
    let text = format!("solid a\nendsolid\nsolid b\n{FACET}endsolid\nsolid c\nendsolid\n");
    let file = read(text);
    assert_eq!(note(&file, NoteKind::UnusedName).count, 2);
    assert_eq!((file.mesh.layers(), &file.mesh.metadata()[0].value[..]), (&[][..], &b"b"[..]));
    assert_eq!(
        read("solid a\nendsolid\n").notes.iter().filter(|n| n.kind == NoteKind::UnusedName).count(),
        0
    );
}

#[test]
fn facets_of_more_vertices_are_polygons_and_of_fewer_are_refused() {
    let with = |vertices: &str| format!("solid\n{}endsolid\n", FACET.replace("vertex 1 0 0\n", vertices));
    assert_eq!(faces(&read(with("vertex 1 0 0\nvertex 1 1 0\n")).mesh), [[0, 1, 2, 3]]);
    assert_eq!(refused(with("")), (Place::Line(2), "a facet with 2 vertices".to_owned()));
}

#[test]
fn text_that_is_cut_or_wrong_is_refused_with_its_line() {
    let text = format!("solid x\n{FACET}{FACET}endsolid x\n");
    let whole_facets = ["solid x\n".len() + FACET.len(), text.len() - "endsolid x\n".len()];
    for length in 1..text.len() - "solid x\n".len() {
        let result = try_read(Format::Stl, &text[..length]);
        // After a whole facet, or within or after the last word that is needed, nothing is lost.
        let is_whole = whole_facets.iter().any(|&end| (end - 1..=end).contains(&length));
        assert_eq!(result.is_ok(), is_whole, "{length}: {:?}", &text[..length]);
    }
    assert_eq!(
        refused(text.replace("0 1 0", "0 1,5 0")),
        (Place::Line(6), "`1,5` where a number belongs".to_owned())
    );
    assert_eq!(refused(text.replace("outer", "inner")).1, "`inner` where `outer` belongs");
    let file = read(&text[..whole_facets[1]]);
    assert_eq!(note(&file, NoteKind::MissingEnd).count, 1);
}

#[test]
fn what_is_written_reads_back() {
    let text = read(format!("solid a\n{FACET}endsolid\nsolid b\n{FACET}endsolid\n")).mesh;
    let binary = read(binary("some header", 2, 2)).mesh;
    for (mesh, encoding) in [(&text, Encoding::Ascii), (&binary, Encoding::LittleEndian)] {
        let (bytes, losses) = written(mesh, Format::Stl, encoding);
        assert!(losses.iter().all(|loss| loss.kind == LossKind::SharedVertices), "{losses:?}");
        let again = read(bytes).mesh;
        assert_eq!((again.positions(), again.faces()), (mesh.positions(), mesh.faces()));
        assert_eq!((again.layers(), again.metadata()), (mesh.layers(), mesh.metadata()));
    }
    let single = read(format!("solid only\n{FACET}endsolid\n")).mesh;
    assert_kept(&single, Format::Stl, Encoding::Ascii);
}

#[test]
fn normals_are_computed() {
    let positions = vec![[0.0, 0.0, 0.0], [1e-40, 0.0, 0.0], [0.0, 3e38, 0.0], [0.0, 0.0, 0.0]];
    let corners = [0, 1, 2, 0, 3, 0].map(VertexId).to_vec();
    let mesh = PolygonMesh::new(positions, FaceTable::triangles(4, corners).unwrap()).unwrap();
    let (bytes, _) = written(&mesh, Format::Stl, Encoding::Ascii);
    let text = String::from_utf8(bytes).unwrap();
    let normals: Vec<&str> = text.lines().filter(|line| line.starts_with("facet")).collect();
    assert_eq!(normals, ["facet normal 0 0 1", "facet normal 0 0 0"]);
}

#[test]
fn what_stl_can_not_carry_is_named() {
    let positions =
        vec![[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, -0.0, 0.0], [9.0; 3]];
    let table =
        FaceTable::polygons(6, vec![0, 4, 7, 9], [0, 1, 2, 3, 0, 4, 2, 0, 1].map(VertexId).to_vec()).unwrap();
    let mesh = PolygonMesh::new(positions, table)
        .unwrap()
        .with_loose(vec![[VertexId(0); 2]], vec![VertexId(1)])
        .unwrap();
    for &encoding in Format::Stl.encodings() {
        let (bytes, losses) = written(&mesh, Format::Stl, encoding);
        let found: Vec<(LossKind, u64)> = losses.iter().map(|loss| (loss.kind, loss.count)).collect();
        let expected = [
            (LossKind::Precision, 1),
            (LossKind::Polygons, 1),
            (LossKind::ShortFaces, 1),
            (LossKind::UnusedVertices, 1),
            (LossKind::SharedVertices, 1),
            (LossKind::LooseEdges, 1),
            (LossKind::LoosePoints, 1),
        ];
        // Text has double precision.
        let rounded = usize::from(encoding == Encoding::Ascii);
        assert_eq!(found, expected[rounded..]);
        assert!(rounded == 1 || losses[0].message == "positions rounded to single precision: 1 of 6");
        assert_eq!(read(bytes).mesh.counts().faces, 3);
    }
}

/// A file has a number for every facet, so zeros alone say nothing.
#[test]
fn attributes_that_are_all_zero_are_named_as_lost() {
    let attributes = |second| {
        let layer = Layer::direct("attribute", Domain::Face, 1, Carry::Copy, Values::U16(vec![0, second]));
        read(binary("", 2, 2)).mesh.with_layers(vec![layer]).unwrap()
    };
    let is_lost = |losses: &[Loss]| losses.iter().any(|loss| loss.kind == LossKind::Layer);
    let (bytes, losses) = written(&attributes(0), Format::Stl, Encoding::LittleEndian);
    assert_eq!((is_lost(&losses), read(bytes).mesh.layers()), (true, &[][..]));
    let (bytes, losses) = written(&attributes(7), Format::Stl, Encoding::LittleEndian);
    assert_eq!((is_lost(&losses), read(bytes).mesh.layers()), (false, attributes(7).layers()));
    // A face without a number has to have one.
    let some =
        Layer::indexed("attribute", Domain::Face, 1, Carry::Copy, Values::U16(vec![7]), vec![NO_VALUE, 0]);
    let mesh = read(binary("", 2, 2)).mesh.with_layers(vec![some]).unwrap();
    let (bytes, losses) = written(&mesh, Format::Stl, Encoding::LittleEndian);
    assert!(losses.iter().any(|loss| loss.kind == LossKind::AbsentValue), "{losses:?}");
    assert_eq!(read(bytes).mesh.layers(), attributes(7).layers());
}

#[test]
fn a_header_beyond_its_place_is_named() {
    for (length, is_lost) in [(80, false), (81, true)] {
        let header = Metadata { key: "stl-header".to_owned(), value: vec![b'x'; length] };
        let mesh = read(binary("", 1, 1)).mesh.with_metadata(vec![header]);
        let (bytes, losses) = written(&mesh, Format::Stl, Encoding::LittleEndian);
        let kinds: Vec<LossKind> = losses.iter().map(|loss| loss.kind).collect();
        assert_eq!(kinds, if is_lost { vec![LossKind::Names] } else { vec![] }, "{length}");
        assert_eq!(read(bytes).mesh.metadata()[0].value, [b'x'; 80]);
    }
}

#[test]
fn stl_io_reads_what_is_written() {
    let mesh = read(format!("solid a\n{FACET}{FACET}endsolid\n")).mesh;
    for &encoding in Format::Stl.encodings() {
        let (bytes, _) = written(&mesh, Format::Stl, encoding);
        let mut cursor = std::io::Cursor::new(bytes);
        let triangles = stl_io::create_stl_reader(&mut cursor).unwrap();
        let triangles: Vec<stl_io::Triangle> = triangles.map(Result::unwrap).collect();
        assert_eq!(triangles.len(), 2);
        let expected = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(triangles[1].vertices.map(|vertex| [vertex[0], vertex[1], vertex[2]]), expected);
        assert_eq!(triangles[1].normal[2], 1.0);
    }
}

#[test]
fn a_facet_counts_three_vertices_against_the_limit() {
    let bytes = binary("", 2, 2);
    for most in 5..=6 {
        let limits = Limits::default().with_max_vertices(most);
        let result =
            read_bytes(&bytes, "two", &ReadOptions::default().with_format(Format::Stl).with_limits(limits));
        match result.map_err(|error| error.kind) {
            Ok(_) => assert_eq!(most, 6),
            Err(ReadErrorKind::LimitExceeded { what: "vertices", found: 6, limit: 5 }) => assert_eq!(most, 5),
            Err(other) => panic!("{other}"),
        }
    }
}

/// Text that is too long must not be tried as binary, where the reason would be another one.
#[test]
fn a_limit_that_text_exceeds_is_the_error() {
    let text = format!("solid\n{}endsolid\n", FACET.repeat(3));
    let limits = Limits::default().with_max_faces(2);
    let options = ReadOptions::default().with_format(Format::Stl).with_limits(limits);
    let error = read_bytes(text.as_bytes(), "long", &options).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::LimitExceeded { .. }), "{error}");
}
