//! Each kind of thing that a mesh carries, from each format to each other: it is kept, converted or a named loss, and
//! nothing goes without a word. `docs/conversions.md` is made of what is found.
//!
//! `MESHMEND_WRITE=1 cargo test -p meshmend-io --test io conversions` writes it anew.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::common::with_mesh;
use meshmend_core::{Carry, Domain, FaceTable, Id, Layer, Metadata, PolygonMesh, Role, Values, VertexId};
use meshmend_io::{
    Format, Loss, NoteKind, ReadFile, ReadOptions, TextureOrigin, WriteOptions, encode, read_bytes,
};

/// Two triangles that share an edge.
fn triangles() -> PolygonMesh {
    let corners = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
    PolygonMesh::new(points(), FaceTable::triangles(4, corners).unwrap()).unwrap()
}

fn points() -> Vec<[f64; 3]> {
    vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]]
}

fn with(layer: Layer) -> PolygonMesh {
    triangles().with_layers(vec![layer]).unwrap()
}

fn direct(name: &str, domain: Domain, width: usize, values: Values) -> Layer {
    Layer::direct(name, domain, width, Carry::Copy, values)
}

/// A name for the first face and another one for the second.
fn names(name: &str) -> PolygonMesh {
    let pool = Values::Text(vec![b"one".to_vec(), b"two".to_vec()]);
    with(direct(name, Domain::Face, 1, pool))
}

/// What is looked at in a mesh.
#[derive(Clone, Copy)]
enum Probe {
    Layer(&'static str, Domain),
    Faces,
    ShortFaces,
    Positions,
    UnusedVertices,
    LooseEdges,
    LoosePoints,
    Statement(&'static str),
}

/// A kind of thing that a mesh carries.
struct Kind {
    what: &'static str,
    mesh: PolygonMesh,
    probe: Probe,
}

fn kinds() -> Vec<Kind> {
    let kind = |what, probe, mesh| Kind { what, mesh, probe };
    let mut kinds = kinds_of_shape();
    kinds.extend(kinds_of_vertices());
    kinds.extend([
        kind(
            "numbers of faces",
            Probe::Layer("label", Domain::Face),
            with(direct("label", Domain::Face, 1, Values::U16(vec![7, 8]))),
        ),
        kind(
            "attribute bytes of facets",
            Probe::Layer("attribute", Domain::Face),
            with(direct("attribute", Domain::Face, 1, Values::U16(vec![7, 8]))),
        ),
        kind(
            "colours of faces, bytes",
            Probe::Layer("color", Domain::Face),
            with(direct("color", Domain::Face, 3, Values::U8(vec![1, 2, 3, 4, 5, 6])).with_role(Role::Color)),
        ),
        kind("objects", Probe::Layer("object", Domain::Face), names("object")),
        kind("groups", Probe::Layer("group", Domain::Face), names("group")),
        kind("names of materials", Probe::Layer("material", Domain::Face), names("material")),
        kind("smoothing groups", Probe::Layer("smoothing", Domain::Face), names("smoothing")),
        kind("comments", Probe::Statement("comment"), stating("comment")),
        kind("the name of the only solid", Probe::Statement("solid"), stating("solid")),
    ]);
    kinds
}

fn stating(key: &str) -> PolygonMesh {
    triangles().with_metadata(vec![Metadata { key: key.to_owned(), value: b"words".to_vec() }])
}

fn kinds_of_shape() -> Vec<Kind> {
    let kind = |what, probe, mesh| Kind { what, mesh, probe };
    let square = FaceTable::polygons(4, vec![0, 4], [0, 1, 3, 2].map(VertexId).to_vec()).unwrap();
    let short = FaceTable::polygons(4, vec![0, 3, 5], [0, 1, 2, 1, 3].map(VertexId).to_vec()).unwrap();
    let mut precise = points();
    precise[3] = [0.1, 1.0 / 3.0, 1e-9 + 1.0];
    let mut more = points();
    more.push([5.0, 6.0, 7.0]);
    let unused = FaceTable::triangles(5, [0, 1, 2, 2, 1, 3].map(VertexId).to_vec()).unwrap();
    let loose = |edges, points| triangles().with_loose(edges, points).unwrap();
    vec![
        kind("triangles", Probe::Faces, triangles()),
        kind("larger faces", Probe::Faces, PolygonMesh::new(points(), square).unwrap()),
        kind("faces of two corners", Probe::ShortFaces, PolygonMesh::new(points(), short).unwrap()),
        kind("positions in double precision", Probe::Positions, triangles().with_positions(precise).unwrap()),
        kind("vertices that no face uses", Probe::UnusedVertices, PolygonMesh::new(more, unused).unwrap()),
        kind("loose edges", Probe::LooseEdges, loose(vec![[VertexId(0), VertexId(3)]], Vec::new())),
        kind("loose points", Probe::LoosePoints, loose(Vec::new(), vec![VertexId(3)])),
    ]
}

fn kinds_of_vertices() -> Vec<Kind> {
    let vertex = |what, name, width, values, role| {
        let mesh = with(direct(name, Domain::Vertex, width, values).with_role(role));
        Kind { what, mesh, probe: Probe::Layer(name, Domain::Vertex) }
    };
    let corner = |what, name, width, values, role| {
        let layer = Layer::indexed(name, Domain::Corner, width, Carry::Copy, values, vec![0, 0, 1, 0, 1, 1]);
        Kind { what, mesh: with(layer.with_role(role)), probe: Probe::Layer(name, Domain::Corner) }
    };
    let (u8s, f32s) = (
        |n: u8| Values::U8((1..=n).collect()),
        |n: u8| Values::F32((1..=n).map(|x| f32::from(x) / 16.0).collect()),
    );
    vec![
        vertex(
            "normals of vertices",
            "normal",
            3,
            Values::F32([0.0, 0.0, 1.0, 0.0, 1.0, 0.0].repeat(2)),
            Role::Normal,
        ),
        corner(
            "normals of corners",
            "normal",
            3,
            Values::F64(vec![0.0, 0.0, 1.0, 0.0, 0.6, 0.8]),
            Role::Normal,
        ),
        vertex("texture coordinates of vertices, exact", "texcoord", 2, f32s(8), Role::TexCoord),
        vertex(
            "texture coordinates of vertices, doubles",
            "texcoord",
            2,
            Values::F64((1..=8).map(|x| f64::from(x) / 10.0).collect()),
            Role::TexCoord,
        ),
        corner("texture coordinates of corners", "texcoord", 2, f32s(4), Role::TexCoord),
        vertex("further texture coordinates", "texcoord_1", 2, f32s(8), Role::TexCoord),
        vertex("colours of vertices, bytes", "color", 3, u8s(12), Role::Color),
        vertex("colours of vertices with alpha, bytes", "color", 4, u8s(16), Role::Color),
        vertex("colours of vertices, fractions", "color", 3, f32s(12), Role::Color),
        vertex("tangents", "tangent", 4, Values::F32([1.0, 0.0, 0.0, -1.0].repeat(4)), Role::Tangent),
        vertex("numbers of vertices, single precision", "quality", 1, f32s(4), Role::Plain),
        vertex(
            "numbers of vertices, double precision",
            "quality",
            1,
            Values::F64(vec![0.1, 0.2, 0.3, 0.4]),
            Role::Plain,
        ),
        vertex(
            "whole numbers of vertices, 32 bits",
            "quality",
            1,
            Values::I32(vec![-1, 2, 3, 4]),
            Role::Plain,
        ),
        vertex("weights of points", "weight", 1, Values::F64(vec![0.5, 1.0, 1.0, 2.0]), Role::Plain),
    ]
}

/// What is seen in a mesh, in an order that does not depend on that of its elements; `None` if nothing is.
fn seen(file: &ReadFile, probe: Probe) -> Option<Vec<String>> {
    let mesh = &file.mesh;
    let place = |vertex: VertexId| format!("{:?}", mesh.position(vertex).map(|x| x as f32));
    let mut seen: Vec<String> = match probe {
        Probe::Layer(name, domain) => of_layer(file, name, domain)?,
        Probe::Faces => mesh.faces().faces().map(|face| face_key(mesh, face.index())).collect(),
        Probe::ShortFaces => {
            let is_short = |face: &meshmend_core::FaceId| mesh.faces().corner_range(*face).len() < 3;
            mesh.faces().faces().filter(is_short).map(|face| face_key(mesh, face.index())).collect()
        }
        Probe::Positions => mesh.positions().iter().map(|position| format!("{position:?}")).collect(),
        Probe::UnusedVertices => {
            let mut is_used = vec![false; mesh.counts().vertices];
            mesh.faces().corner_vertices().iter().for_each(|vertex| is_used[vertex.index()] = true);
            (0..is_used.len()).filter(|&at| !is_used[at]).map(|at| place(VertexId::new(at))).collect()
        }
        Probe::LooseEdges => mesh.loose_edges().iter().map(|ends| format!("{:?}", ends.map(place))).collect(),
        Probe::LoosePoints => mesh.loose_points().iter().map(|&point| place(point)).collect(),
        Probe::Statement(key) => {
            let statements = mesh.metadata().iter().filter(|statement| statement.kind() == key);
            statements.map(|statement| String::from_utf8_lossy(&statement.value).into_owned()).collect()
        }
    };
    seen.sort();
    seen.dedup();
    (!seen.is_empty()).then_some(seen)
}

/// What is seen in another place: the only solid of a text is an object where there are several, and in PLY one property
/// may have a part of each value.
fn seen_otherwise(file: &ReadFile, probe: Probe) -> Option<Vec<String>> {
    match probe {
        Probe::Statement("solid") => match file.mesh.layer("object", Domain::Face)?.values() {
            Values::Text(names) => {
                Some(names.iter().map(|n| String::from_utf8_lossy(n).into_owned()).collect())
            }
            _ => None,
        },
        Probe::Layer(name, domain) => of_layer(file, &format!("{name}_0"), domain),
        _ => None,
    }
}

fn face_key(mesh: &PolygonMesh, face: usize) -> String {
    let vertices = mesh.faces().face_vertices(meshmend_core::FaceId::new(face));
    let mut places: Vec<String> =
        vertices.iter().map(|&vertex| format!("{:?}", mesh.position(vertex).map(|x| x as f32))).collect();
    places.sort();
    places.concat()
}

/// The values of a layer, by the faces and the places of their corners. Texture coordinates count from the lower left.
fn of_layer(file: &ReadFile, name: &str, domain: Domain) -> Option<Vec<String>> {
    let mesh = &file.mesh;
    // A name of one's own begins with `_` in glTF.
    let own = format!("_{name}");
    let is_named = |layer: &&Layer| [name, &own].contains(&layer.name());
    let is_of_faces = domain == Domain::Face;
    let is_fit = |layer: &&Layer| (layer.domain() == Domain::Face) == is_of_faces;
    let layer = mesh.layers().iter().filter(is_fit).find(is_named)?;
    let is_turned =
        layer.role() == Role::TexCoord && file.format.texture_origin() == TextureOrigin::UpperLeft;
    let shown = |value: usize| -> Vec<String> {
        let places = value * layer.width()..(value + 1) * layer.width();
        let one = one(layer);
        let entry = |(at, place): (usize, usize)| match layer.values() {
            Values::Text(texts) => String::from_utf8_lossy(&texts[place]).into_owned(),
            values => {
                let x = values.number(place).unwrap_or(f64::NAN) / one;
                if is_turned && at == 1 { (1.0 - x).to_string() } else { x.to_string() }
            }
        };
        let mut entries: Vec<String> = places.enumerate().map(entry).collect();
        // An opaque colour is the same with its alpha and without.
        if layer.role() == Role::Color && entries.get(3).is_some_and(|alpha| alpha == "1") {
            entries.pop();
        }
        entries
    };
    let corners = mesh.faces().corners().zip(layer.corner_values(mesh.faces()));
    let corner = |(corner, value): (meshmend_core::CornerId, Option<usize>)| {
        let face = face_key(mesh, mesh.faces().corner_face(corner).index());
        let place = if is_of_faces {
            String::new()
        } else {
            format!("{:?}", mesh.position(mesh.faces().corner_vertex(corner)))
        };
        Some(format!("{face} {place}: {:?}", shown(value?)))
    };
    Some(corners.filter_map(corner).collect())
}

/// The number that stands for 1: of a colour in bytes that is 255.
fn one(layer: &Layer) -> f64 {
    match layer.values() {
        Values::U8(_) if layer.role() == Role::Color => 255.0,
        Values::U16(_) if layer.role() == Role::Color => 65535.0,
        _ => 1.0,
    }
}

/// What becomes of something.
fn verdict(kind: &Kind, given: &ReadFile, to: Format) -> Result<&'static str, String> {
    let before = seen(given, kind.probe);
    let mut bytes = Vec::new();
    let losses =
        encode(&given.mesh, &WriteOptions::of(to).as_read(given), &mut bytes).map_err(|e| e.to_string())?;
    let again =
        read_bytes(&bytes, "a", &ReadOptions::default().with_format(to)).map_err(|e| e.to_string())?;
    let after = seen(&again, kind.probe);
    let is_named = losses.iter().any(|loss| is_of(loss, kind.probe));
    // Lines and points of glTF stay in the file, and a note says so.
    let is_noted = again.notes.iter().any(|note| note.kind == NoteKind::SkippedElement);
    if is_noted && matches!(kind.probe, Probe::LooseEdges | Probe::LoosePoints) {
        return Ok("kept");
    }
    let after = after.or_else(|| seen_otherwise(&again, kind.probe));
    match (after == before, after.is_some(), is_named) {
        (true, ..) => Ok("kept"),
        (false, true, true) => Ok("converted"),
        (false, false, true) => Ok("lost"),
        _ => Err(format!(
            "{}: {} to {to}: {before:?} became {after:?}, named {losses:?}",
            kind.what, given.format
        )),
    }
}

/// Whether a loss speaks of what is looked at.
fn is_of(loss: &Loss, probe: Probe) -> bool {
    use meshmend_io::LossKind as K;
    match probe {
        Probe::Layer(name, _) => {
            (loss.message.contains(&format!("`{name}`")) || loss.message.contains(&format!("`_{name}`")))
                || loss.message.contains("texture coordinate")
                || loss.message.contains("colours of")
        }
        Probe::Faces => loss.kind == K::Polygons,
        Probe::ShortFaces => loss.kind == K::ShortFaces,
        Probe::Positions => loss.kind == K::Precision,
        Probe::UnusedVertices => loss.kind == K::UnusedVertices,
        Probe::LooseEdges => loss.kind == K::LooseEdges,
        Probe::LoosePoints => loss.kind == K::LoosePoints,
        Probe::Statement(key) => matches!(loss.kind, K::Metadata) && loss.message.contains(key),
    }
}

/// The mesh of a kind as a file of a format has it; `None` if the format can't hold it.
fn given(kind: &Kind, from: Format) -> Option<ReadFile> {
    let encoding = from.encodings().iter().rev().copied().find(|&encoding| {
        let mut bytes = Vec::new();
        let options = WriteOptions::of(from).with_encoding(encoding);
        encode(&kind.mesh, &options, &mut bytes).is_ok()
            && read_bytes(&bytes, "a", &ReadOptions::default().with_format(from))
                .is_ok_and(|file| holds(kind, &file))
    })?;
    let mut bytes = Vec::new();
    encode(&kind.mesh, &WriteOptions::of(from).with_encoding(encoding), &mut bytes).ok()?;
    read_bytes(&bytes, "a", &ReadOptions::default().with_format(from)).ok()
}

/// Whether a file has what a kind is about.
fn holds(kind: &Kind, file: &ReadFile) -> bool {
    let original = with_mesh(file.clone(), kind.mesh.clone());
    match kind.probe {
        Probe::Faces | Probe::Positions => seen(file, kind.probe) == seen(&original, kind.probe),
        _ => seen(file, kind.probe).is_some(),
    }
}

const HEAD: &str = "\
# Conversions

What becomes of what a mesh carries when it is written in another format. This page is made by a test
(`crates/meshmend-io/tests/io/conversions.rs`), which fails if anything is lost without a word.

* **kept**: what is read from the output is what was in the input, to the bit.
* **converted**: the output has it in another way, such as in another precision, and the report says so.
* **lost**: the output does not have it, and the report says so.

A table has a row for each thing that a file of its format can hold, and a column for each format of the output, in its
usual encoding. A text STL holds doubles and names, a binary one attribute bytes; the input is of the kind that holds
the thing.

Beyond the tables:

* Texture coordinates count from the lower left corner of a picture, but from the upper left one in glTF. They are turned
  where the two meet.
* A vertex whose corners differ in attributes is written several times in formats that have attributes at vertices alone
  (`--seams`).
* The colours, opacity, light, metal, roughness and pictures of materials go from the libraries of an OBJ to glTF, and from
  glTF to a library beside an OBJ. The words of one that the other does not know, such as `Ks`, `Ns` and `illum`, are
  named. No colour is converted: glTF means linear numbers, and many programs write those of the screen (sRGB) to MTL.
* Lines and points of a glTF are in the file, but not in the mesh that is read of it; a note says how many.
* Pictures that the output names are copied beside it, and those within a GLB become files beside an OBJ
  (`--companions`).
";

#[test]
fn what_becomes_of_everything_in_every_format_is_what_the_page_says() {
    let mut page = HEAD.to_owned();
    let mut wrong = Vec::new();
    for &from in Format::ALL {
        let columns: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
        write!(
            page,
            "\n## From {from}\n\n| | {} |\n|---|{}\n",
            columns.join(" | "),
            "---|".repeat(columns.len())
        )
        .unwrap();
        for kind in kinds() {
            let Some(given) = given(&kind, from) else { continue };
            let cells = Format::ALL.iter().map(|&to| {
                verdict(&kind, &given, to).unwrap_or_else(|reason| {
                    wrong.push(reason);
                    "?"
                })
            });
            let cells: Vec<&str> = cells.collect();
            writeln!(page, "| {} | {} |", kind.what, cells.join(" | ")).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/conversions.md");
    if std::env::var_os("MESHMEND_WRITE").is_some() {
        fs::write(path, page).unwrap();
        return;
    }
    let stored = fs::read_to_string(path).unwrap_or_default();
    assert_eq!(
        stored, page,
        "write it anew: MESHMEND_WRITE=1 cargo test -p meshmend-io --test io conversions"
    );
}
