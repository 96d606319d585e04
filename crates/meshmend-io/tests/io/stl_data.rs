//! What an STL file has beside its triangles: numbers of any size, names of any words, headers, normals, attributes.

use crate::common::{faces, layer, names, note, read as read_as, written};
use meshmend_core::{Domain, Metadata, PolygonMesh, Values};
use meshmend_io::{
    ColorElements, Encoding, Format, LossKind, NoteKind, Place, ReadFile, ReadOptions, decode_stl_colors,
    read_bytes,
};

fn read(bytes: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Stl, bytes)
}

const FACET: &str =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

fn solid(name: &str) -> String {
    format!("solid {name}\n{FACET}endsolid {name}\n")
}

/// A binary file of facets: a normal, in the plane z = 0 from (0, 0) by (1, 0) to (0, 1), an attribute.
fn binary(header: &[u8], facets: &[([f32; 3], u16)]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, 0);
    bytes.extend((facets.len() as u32).to_le_bytes());
    for (normal, attribute) in facets {
        let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        bytes.extend(normal.iter().chain(&corners).flat_map(|x: &f32| x.to_le_bytes()));
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

const UP: [f32; 3] = [0.0, 0.0, 1.0];

fn count_of(file: &ReadFile, kind: NoteKind) -> u64 {
    file.notes.iter().filter(|note| note.kind == kind).map(|note| note.count).sum()
}

/// Coordinates of surveys have more digits than single precision holds.
#[test]
fn text_is_read_and_written_in_double_precision() {
    let survey = "548123.410000 5801234.570000 33.1";
    for (text, expected) in [
        (survey, [548_123.41, 5_801_234.57, 33.1]),
        ("1e39 -1e300 1e-300", [1e39, -1e300, 1e-300]),
        ("1e400 5e-324 -0", [f64::INFINITY, 5e-324, -0.0]),
    ] {
        let file = read(format!("solid\n{}endsolid\n", FACET.replace("1 0 0", text)));
        assert_eq!(file.mesh.positions()[1], expected);
        let is_infinite = expected.iter().any(|x| x.is_infinite());
        assert_eq!(count_of(&file, NoteKind::NonFinite), u64::from(is_infinite), "{text}");
        let again = read(written(&file.mesh, Format::Stl, Encoding::Ascii).0).mesh;
        assert_eq!(again.positions(), file.mesh.positions());
        let losses = written(&file.mesh, Format::Stl, Encoding::Ascii).1;
        assert!(losses.iter().all(|loss| loss.kind != LossKind::Precision), "{losses:?}");
    }
}

#[test]
fn a_name_may_hold_any_words() {
    for name in [
        "a facet of the part",
        "facet",
        "facet normal",
        "facet normal 0 0 1",
        "x facet normal 0 0 1 outer",
        "facet outer loop vertex",
        "my endsolid part",
        "endsolid",
        "a endsolid b facet c",
        "solid",
        "a solid b",
        "endsolid a solid b",
        "vertex outer loop",
        "FACET EndSolid SOLID",
        "two  blanks\tand a tabulator",
        "",
    ] {
        for text in [solid(name), solid(name).replace('\n', "\r\n"), solid(name).replace('\n', "\n \t\n")] {
            let mesh = read(&text).mesh;
            assert_eq!(faces(&mesh), [[0, 1, 2]], "{name}");
            assert_eq!(mesh.metadata().first().map_or("".as_bytes(), |m| &m.value), name.as_bytes());
            let (bytes, losses) = written(&mesh, Format::Stl, Encoding::Ascii);
            assert!(losses.is_empty(), "{name}: {losses:?}");
            assert_eq!(read(&bytes).mesh.metadata(), mesh.metadata());
        }
        let several = read([solid("first"), solid(name), solid("last")].concat()).mesh;
        let expected = [Some("first"), Some(name).filter(|name| !name.is_empty()), Some("last")];
        assert_eq!(
            names(layer(&several, "object", Domain::Face)),
            expected.map(|name| name.map(str::to_owned))
        );
        let again = read(written(&several, Format::Stl, Encoding::Ascii).0).mesh;
        assert_eq!(again.layers(), several.layers(), "{name}");
    }
}

/// All in one line, a name ends where a facet begins.
#[test]
fn names_in_one_line_end_where_a_facet_begins() {
    for name in ["a", "a facet of it", "", "a solid b"] {
        let line = [solid("first"), solid(name), solid("last")].concat().replace('\n', " ");
        let found = names(layer(&read(&line).mesh, "object", Domain::Face));
        let expected = [Some("first"), Some(name).filter(|name| !name.is_empty()), Some("last")];
        assert_eq!(found, expected.map(|name| name.map(str::to_owned)), "{name}");
    }
    // What would be read as a facet is spelled differently.
    let name = b"facet normal 0 0 1 outer loop vertex 0 0 0".to_vec();
    let mesh = read(solid("x")).mesh.with_metadata(vec![Metadata { key: "solid".to_owned(), value: name }]);
    let (bytes, losses) = written(&mesh, Format::Stl, Encoding::Ascii);
    assert_eq!(losses.iter().map(|loss| loss.kind).collect::<Vec<_>>(), [LossKind::Names]);
    assert!(read(bytes).mesh.metadata()[0].value.starts_with(b"_acet normal"));
}

#[test]
fn solids_without_facets_end_in_their_line_or_the_next() {
    let text = format!("solid a endsolid a\nsolid b\nendsolid b\nsolid d\n{FACET}endsolid d\n");
    let file = read(text);
    assert_eq!((faces(&file.mesh).len(), count_of(&file, NoteKind::UnusedName)), (1, 2));
    assert_eq!(file.mesh.metadata()[0].value, b"d");
    let line = format!("{}{}", "solid a endsolid a ".repeat(20_000), solid("b").replace('\n', " "));
    assert_eq!(count_of(&read(line), NoteKind::UnusedName), 20_000);
}

#[test]
fn names_need_not_be_utf_8() {
    let name = b"caf\xe9 \xff\x80\x85\xa0\xc3(";
    let text = [b"solid ", &name[..], b"\n", FACET.as_bytes(), b"endsolid ", name, b"\n"].concat();
    for file in [read(&text), read_bytes(&text, "nameless", &ReadOptions::default()).unwrap()] {
        assert_eq!((&file.mesh.metadata()[0].value[..], file.variant), (&name[..], "stl-ascii"));
        assert_eq!(
            read(written(&file.mesh, Format::Stl, Encoding::Ascii).0).mesh.metadata(),
            file.mesh.metadata()
        );
    }
}

#[test]
fn text_is_told_by_its_content_however_it_is_laid_out() {
    let text = solid("part");
    for text in [
        text.to_ascii_uppercase(),
        text.replace(' ', "  "),
        text.replace(' ', "\t"),
        text.replace('\n', "\r"),
    ] {
        assert_eq!(
            read_bytes(text.as_bytes(), "nameless", &ReadOptions::default()).unwrap().variant,
            "stl-ascii"
        );
    }
}

#[test]
fn headers_are_kept_to_the_byte() {
    let mut full = [b'x'; 80];
    full[40] = 0;
    let headers: [&[u8]; 8] = [
        b"HDR",
        b"name   ",
        b"zeros\0\0 within\0\t",
        &[b' '; 80],
        &full,
        b"solid name",
        b"\xef\xbb\xbfSolid name\nendsolid",
        b"solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0",
    ];
    for header in headers {
        let bytes = binary(header, &[(UP, 0), (UP, 7)]);
        let file = read(&bytes);
        assert_eq!((file.variant, faces(&file.mesh).len()), ("stl-binary", 2));
        let (again, losses) = written(&file.mesh, Format::Stl, Encoding::LittleEndian);
        assert!(losses.iter().all(|loss| loss.kind == LossKind::SharedVertices), "{losses:?}");
        assert_eq!(again, bytes, "{header:?}");
        let named = read_bytes(&bytes, "nameless", &ReadOptions::default()).unwrap();
        assert_eq!(named.variant, "stl-binary");
    }
}

#[test]
fn stored_normals_that_point_elsewhere_are_noted() {
    let tilted = |angle: f32| [angle.sin(), 0.0, angle.cos()];
    let facets = [
        (UP, 0),
        (tilted(0.9e-3), 0),
        ([0.0; 3], 0),
        ([f32::NAN; 3], 0),
        (tilted(1.1e-3), 0),
        ([0.0, 0.0, -2.0], 0),
        ([0.0, 0.0, 1e-30], 0),
    ];
    let file = read(binary(b"", &facets));
    let noted = note(&file, NoteKind::NormalsRecomputed);
    assert_eq!((noted.count, noted.first.clone()), (2, Place::Byte(84 + 4 * 50)));
    let text: String = facets
        .iter()
        .map(|(normal, _)| FACET.replace("0 0 1", &normal.map(|x| format!("{x:e}")).join(" ")))
        .collect();
    // As usual, and as only the reader itself understands it.
    for text in [text.clone(), text.replace("outer loop\n", "outer\nloop "), text.to_ascii_uppercase()] {
        let file = read(format!("solid\n{text}endsolid\n"));
        let noted = note(&file, NoteKind::NormalsRecomputed);
        assert_eq!((noted.count, noted.first.clone()), (2, Place::Line(2 + 4 * 7)), "{text}");
    }
    let sound = read(solid("x"));
    assert_eq!(count_of(&sound, NoteKind::NormalsRecomputed), 0);
    // What is written has the right ones.
    for &encoding in Format::Stl.encodings() {
        let again = read(written(&file.mesh, Format::Stl, encoding).0);
        assert_eq!(count_of(&again, NoteKind::NormalsRecomputed), 0);
    }
}

/// Each face's colour.
fn colors(mesh: &PolygonMesh, domain: Domain) -> Vec<Option<[u8; 3]>> {
    let layer = layer(mesh, "color", domain);
    let Values::U8(values) = layer.values() else { panic!("{:?}", layer.values()) };
    let color = |value: usize| [0, 1, 2].map(|i| values[3 * value + i]);
    (0..layer.element_count()).map(|element| layer.value_of(element).map(color)).collect()
}

const RED: Option<[u8; 3]> = Some([255, 0, 0]);
const GREEN: Option<[u8; 3]> = Some([0, 255, 0]);
const BLUE: Option<[u8; 3]> = Some([0, 0, 255]);

#[test]
fn attributes_are_colours_in_two_ways() {
    let facets = [0x001f, 0x03e0, 0x7c00, 0x8000, 0x801f].map(|attribute| (UP, attribute));
    let magics = read(binary(b"COLOR=\xa9\xa9\xff\xff,MATERIAL=...", &facets));
    let decoded = decode_stl_colors(&magics.mesh, ColorElements::Faces).unwrap();
    let whole = Some([169, 169, 255]);
    assert_eq!(colors(&decoded, Domain::Face), [RED, GREEN, BLUE, whole, whole]);
    assert_eq!((decoded.layers().len(), count_of(&magics, NoteKind::PerhapsColors)), (1, 5));
    let viscam =
        read(binary(b"no sign", &[0x801f, 0x83e0, 0xfc00, 0x7fff, 0].map(|attribute| (UP, attribute))));
    let decoded = decode_stl_colors(&viscam.mesh, ColorElements::Faces).unwrap();
    assert_eq!(colors(&decoded, Domain::Face), [BLUE, GREEN, RED, None, None]);
    assert_eq!(count_of(&viscam, NoteKind::PerhapsColors), 3);
    let of_vertices = decode_stl_colors(&viscam.mesh, ColorElements::Vertices).unwrap();
    assert_eq!(colors(&of_vertices, Domain::Vertex)[..7], [BLUE, BLUE, BLUE, GREEN, GREEN, GREEN, RED]);
    // Numbers without a sign of either are no colours to be named, and nothing is there to be decoded.
    let numbers = read(binary(b"", &[(UP, 1), (UP, 2)]));
    assert_eq!(count_of(&numbers, NoteKind::PerhapsColors), 0);
    let plain = read(solid("x")).mesh;
    assert_eq!(decode_stl_colors(&plain, ColorElements::Faces).unwrap().layers(), plain.layers());
}

/// A header that is cut after its sign says no colour.
#[test]
fn a_sign_at_the_end_of_a_header_is_none() {
    let mut header = [b' '; 80];
    header[73..79].copy_from_slice(b"COLOR=");
    let file = read(binary(&header, &[(UP, 0x8000)]));
    let decoded = decode_stl_colors(&file.mesh, ColorElements::Faces).unwrap();
    assert_eq!(colors(&decoded, Domain::Face), [Some([0, 0, 0])]);
}
