//! One of something is counted as one, in every message about what can't be read, is noted, or is lost.

use std::fmt::Display;

use meshmend_core::{Carry, Domain, FaceTable, Layer, Metadata, PolygonMesh, Values, VertexId};
use meshmend_io::{Format, Limits, Prepared, ReadOptions, Seams, WriteErrorKind, WriteOptions, read_bytes};
use meshmend_testkit::miscounted;

use crate::common::{try_read, written};

#[track_caller]
fn assert_counts(message: &dyn Display) {
    let message = message.to_string();
    assert_eq!(miscounted(&message), None, "{message}");
}

/// Asserts it of everything that is said of a mesh when it is written.
#[track_caller]
fn assert_losses_count(mesh: &PolygonMesh) {
    for (format, encoding) in Format::ALL.iter().flat_map(|&f| f.encodings().iter().map(move |&e| (f, e))) {
        written(mesh, format, encoding).1.iter().for_each(|loss| assert_counts(loss));
    }
}

fn mesh(faces: &[&[u32]]) -> PolygonMesh {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.5, 0.0]];
    let starts: Vec<u32> = std::iter::once(0)
        .chain(faces.iter().scan(0, |end, face| {
            *end += face.len() as u32;
            Some(*end)
        }))
        .collect();
    let corners = faces.iter().flat_map(|face| face.iter().copied().map(VertexId)).collect();
    PolygonMesh::new(positions, FaceTable::polygons(5, starts, corners).unwrap()).unwrap()
}

/// A layer in which one element has a value, or one has none, or all have one.
fn layers_of(name: &str, mesh: &PolygonMesh, domain: Domain, values: Values, width: usize) -> [Layer; 3] {
    const NONE: u32 = u32::MAX;
    let count = mesh.element_count(domain);
    let uses = [
        (0..count).map(|at| if at == 0 { 0 } else { NONE }).collect(),
        (0..count).map(|at| if at == 0 { NONE } else { 0 }).collect(),
        vec![0; count],
    ];
    uses.map(|uses| Layer::indexed(name, domain, width, Carry::Copy, values.clone(), uses))
}

#[test]
fn losses() {
    let shapes: [&[&[u32]]; 6] =
        [&[&[0, 1, 2]], &[&[0, 1, 2, 3]], &[&[0, 1]], &[&[0, 1, 2], &[0, 2, 3]], &[&[0, 1, 4, 1]], &[]];
    for faces in shapes {
        let mesh = mesh(faces);
        let mesh = mesh.with_loose(vec![[VertexId(0), VertexId(4)]], vec![VertexId(4)]).unwrap();
        let statement = |key: &str| Metadata { key: key.to_owned(), value: b"of two\nlines".to_vec() };
        for key in ["comment", "mtllib", "solid", "stl-header", "ply-property", "other"] {
            assert_losses_count(&mesh.clone().with_metadata(vec![statement(key)]));
        }
        let text = || Values::Text(vec![b"of two\nlines".to_vec()]);
        let named = ["object", "group", "material", "smoothing", "texnumber", "attribute", "quality"];
        let names = named.map(|name| (name, text(), 1)).to_vec();
        let numbers = [
            ("color", Values::F64(vec![0.3; 4]), 4),
            ("color", Values::U8(vec![3; 3]), 3),
            ("normal", Values::F64(vec![0.3; 3]), 3),
            ("texcoord", Values::F64(vec![0.3, 0.3, 0.0]), 3),
            ("texcoord", Values::F64(vec![0.3; 2]), 2),
            ("weight", Values::F64(vec![0.3]), 1),
            ("attribute", Values::U16(vec![3]), 1),
            ("texnumber", Values::U8(vec![3]), 1),
            ("two words", Values::I8(vec![3]), 1),
        ];
        for domain in [Domain::Vertex, Domain::Corner, Domain::Face, Domain::LooseEdge, Domain::LoosePoint] {
            for (name, values, width) in names.iter().cloned().chain(numbers.clone()) {
                for layer in layers_of(name, &mesh, domain, values, width) {
                    assert_losses_count(&mesh.clone().with_layers(vec![layer]).unwrap());
                }
            }
        }
    }
}

#[test]
fn rounding_and_seams() {
    let mut points = mesh(&[&[0, 1, 2]]).positions().to_vec();
    points[0] = [1e-20, 0.1, 1.0];
    points[3] = [0.0, 0.1, 1.0];
    points[4] = [1.0, 1.0 + 1e-12, 0.0];
    for faces in [&[&[0_u32, 1, 2][..]][..], &[&[0, 3, 1]], &[&[2, 4, 1]]] {
        assert_losses_count(&mesh(faces).with_positions(points.clone()).unwrap());
    }
    let two = mesh(&[&[0, 1, 2], &[0, 2, 3]]);
    let values = Values::U8((0..9).collect());
    let seams = Layer::indexed("color", Domain::Corner, 3, Carry::Copy, values, vec![0, 1, 2, 1, 2, 2]);
    let seams = two.with_layers(vec![seams]).unwrap();
    assert_losses_count(&seams);
    for vertices in [1, 2] {
        assert_counts(&WriteErrorKind::Seams { vertices });
    }
    let options = WriteOptions::of(Format::Off).with_seams(Seams::Fail);
    if let Err(error) = Prepared::new(&seams, &options) {
        assert_counts(&error);
    }
}

/// Texts with one of something wrong, too little or too much.
const TEXTS: [&str; 28] = [
    "OFF\n1 1 0\n",
    "OFF\n1 1 0\n0 0 0\n3 0 1 2\n",
    "OFF\n1 1 0\n0 0 0\n1 0 0 0\n",
    "OFF\n1 1 0\n0 0 0\n9999 0\n",
    "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n",
    "OFF\n3 1 0\n0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n",
    "v 0 0 0\nf 1\n",
    "v 0 0 0\nf 2 3 4\n",
    "v 0 0 0\nf -2 1 1\n",
    "v 0 0 0\nf 1/2 1/2 1/2\n",
    "v 0 0 0 1\nv 0 0 0 1 2 3 4\nl 1\np 1\n",
    "v 0 0 0\nl 1 1\np 1\no a\ng b\nusemtl c\nodd\n",
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n",
    "solid a\nfacet normal 0 0 1\nouter loop\nendloop\nendfacet\nendsolid\n",
    "solid a\nendsolid a\nsolid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0\n",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0 0\n",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0\n0 0\n",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0\n",
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n",
    "ply\nformat ascii 1.0\nelement thing 1\nproperty list uchar int x\nend_header\n1\n",
    "ply\nformat ascii 1.0\nelement thing 2\nproperty int x\nend_header\n1 2\n3\n",
    "ply\nformat ascii 1.0\nelement thing 1\nproperty int x\nend_header\n1\n1\n",
    "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n0",
    "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n0000",
    "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n\u{1}",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement thing 1\nproperty int face_index\nend_header\n0 0 0\n0\n",
];

#[test]
fn errors_and_notes() {
    let mut refused = 0;
    for (text, &format) in TEXTS.iter().flat_map(|text| Format::ALL.iter().map(move |format| (text, format)))
    {
        match try_read(format, text) {
            Ok(file) => {
                file.notes.iter().for_each(|note| assert_counts(note));
                assert_losses_count(&file.mesh);
            }
            Err(error) => {
                refused += 1;
                assert_counts(&error);
            }
        }
    }
    assert!(refused > 20, "only {refused} errors");
    for (announced, there) in [(1, 0), (0, 1), (1, 2), (2, 1)] {
        let mut bytes = vec![0; 84 + 50 * there];
        bytes[80] = announced;
        try_read(Format::Stl, bytes).err().iter().for_each(|error| assert_counts(error));
    }
}

#[test]
fn limits_of_nothing() {
    let most = Limits::default();
    let none = most.with_max_vertices(0).with_max_faces(0).with_max_corners(0);
    let none = none.with_max_declarations(0).with_max_file_bytes(0);
    let narrow = [
        most.with_max_vertices(0),
        most.with_max_faces(0),
        most.with_max_corners(0),
        most.with_max_declarations(0),
        none,
    ];
    for limits in narrow {
        for (text, &format) in
            TEXTS.iter().chain([&"x"]).flat_map(|text| Format::ALL.iter().map(move |format| (text, format)))
        {
            let options = ReadOptions::default().with_format(format).with_limits(limits);
            let error = read_bytes(text.as_bytes(), "test", &options).err();
            error.iter().for_each(|error| assert_counts(error));
        }
    }
    let one = read_bytes(b"x", "test.obj", &ReadOptions::default().with_limits(most.with_max_file_bytes(0)));
    assert_eq!(one.unwrap_err().to_string(), "test.obj: 1 byte is more than the limit of 0 (max_file_bytes)");
}
