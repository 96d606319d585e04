//! Meshes read and written, and the values of their layers as texts.

use std::collections::BTreeSet;

use meshmend_core::{CornerId, Domain, FaceId, Id, Layer, PolygonMesh, Role, Values};
use meshmend_io::{Encoding, Format, Loss, ReadOptions, Seams, WriteOptions, encode, read_bytes};
use meshmend_repair::{PassKind, Pipeline, Repaired};
use meshmend_tests::corpus::Entry;

/// Two tetrahedra that share an edge and have to be split there, one of them with a vertex stored twice that has to be
/// welded; corners have texture coordinates and normals, faces an object, groups, a material and a smoothing group.
pub(crate) const TWO_TETRAHEDRA: &str = "\
mtllib paint.mtl
v 0 0 0
v 0 0 1
v 1 0 0
v 1 1 0
v 1 1 0
v -1 0 0
v -1 -1 0
vt 0 0
vt 0 1
vt 1 0
vt 1 1
vt 0.5 0.25
vn 0 0 1
vn 0 1 0
o first
g lower
usemtl red
s 1
f 1/1/1 2/2/1 3/3/2
f 2/2/2 1/4/1 4/5/1
usemtl green
f 1/1/1 3/2/1 5/4/2
s off
f 2/5/2 4/3/1 3/1/1
o second
g upper front
usemtl blue
f 1/5/1 6/2/1 2/3/2
f 1/3/1 2/4/1 7/1/2
f 1/2/1 7/3/1 6/4/1
usemtl red
f 2/1/1 6/2/1 7/5/2
";

pub(crate) fn read(text: &[u8], name: &str) -> PolygonMesh {
    read_bytes(text, name, &ReadOptions::default()).unwrap().mesh
}

/// A format in one of its encodings, and how vertices are written whose attributes differ from face to face.
#[derive(Clone, Copy)]
pub(crate) struct Target {
    pub(crate) format: Format,
    pub(crate) encoding: Encoding,
    pub(crate) seams: Seams,
}

impl Target {
    /// All but files of several meshes, whose elements come back in another order.
    pub(crate) fn all() -> impl Iterator<Item = Target> {
        let formats = Format::ALL.iter().filter(|format| !matches!(format, Format::Glb | Format::Gltf));
        let encodings = formats.flat_map(|&format| format.encodings().iter().map(move |&e| (format, e)));
        encodings.flat_map(|(format, encoding)| {
            [Seams::Split, Seams::Corners].map(|seams| Target { format, encoding, seams })
        })
    }
}

pub(crate) fn written(mesh: &PolygonMesh, target: Target) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let options = WriteOptions::of(target.format).with_seams(target.seams);
    let losses = encode(mesh, &options.with_encoding(target.encoding), &mut bytes).unwrap();
    (bytes, losses)
}

/// The mesh as it is read again from a file of a format; welded where the format has no shared vertices.
pub(crate) fn converted(mesh: &PolygonMesh, target: Target) -> (PolygonMesh, Vec<Loss>) {
    let format = target.format;
    let (bytes, losses) = written(mesh, target);
    let again = read(&bytes, &format!("converted.{}", format.extensions()[0]));
    match format {
        Format::Stl => (Pipeline::new([PassKind::Weld.with_defaults()]).run(&again).unwrap().mesh, losses),
        _ => (again, losses),
    }
}

/// One value of a layer, as text that differs where a bit does.
pub(crate) fn value(layer: &Layer, element: usize) -> Option<String> {
    let at = layer.value_of(element)? * layer.width();
    Some(entries(layer.values(), at, layer.width()))
}

pub(crate) fn entries(values: &Values, at: usize, width: usize) -> String {
    let range = at..at + width;
    match values {
        Values::I8(v) => format!("{:?}", &v[range]),
        Values::U8(v) => format!("{:?}", &v[range]),
        Values::I16(v) => format!("{:?}", &v[range]),
        Values::U16(v) => format!("{:?}", &v[range]),
        Values::I32(v) => format!("{:?}", &v[range]),
        Values::U32(v) => format!("{:?}", &v[range]),
        // In double precision, as a text keeps the number and not its type.
        Values::F32(v) => format!("{:?}", v[range].iter().map(|&x| f64::from(x)).collect::<Vec<_>>()),
        Values::F64(v) => format!("{:?}", &v[range]),
        Values::Text(v) => {
            format!("{:?}", v[range].iter().map(|t| String::from_utf8_lossy(t)).collect::<Vec<_>>())
        }
        Values::Lists { starts, items } => {
            let list = |i: usize| (starts[i] as usize, (starts[i + 1] - starts[i]) as usize);
            range.map(list).map(|(start, length)| entries(items, start, length)).collect()
        }
    }
}

/// What a corner has in a layer that is on the corners, or on the vertices and seen from the corner.
pub(crate) fn corner_value(mesh: &PolygonMesh, layer: &str, corner: CornerId) -> Option<String> {
    match mesh.layer(layer, Domain::Corner) {
        Some(layer) => value(layer, corner.index()),
        None => value(mesh.layer(layer, Domain::Vertex)?, mesh.faces().corner_vertex(corner).index()),
    }
}

/// A layer with the opposite sign, if it holds normals; else as it is.
pub(crate) fn turned(layer: &Layer) -> Layer {
    let values = match layer.values() {
        _ if layer.role() != Role::Normal => return layer.clone(),
        Values::F32(v) => Values::F32(v.iter().map(|x| -x).collect()),
        Values::F64(v) => Values::F64(v.iter().map(|x| -x).collect()),
        Values::I8(v) => Values::I8(v.iter().map(|x| x.saturating_neg()).collect()),
        Values::I16(v) => Values::I16(v.iter().map(|x| x.saturating_neg()).collect()),
        Values::I32(v) => Values::I32(v.iter().map(|x| x.saturating_neg()).collect()),
        _ => return layer.clone(),
    };
    layer.clone().with_pool(layer.width(), values)
}

pub(crate) fn face_value(mesh: &PolygonMesh, layer: &str, face: FaceId) -> Option<String> {
    value(mesh.layer(layer, Domain::Face)?, face.index())
}

/// The names of the layers that corners have values in, and of those that faces have.
pub(crate) fn layer_names(mesh: &PolygonMesh) -> [BTreeSet<String>; 2] {
    let names = |of_faces: bool| {
        let layers = mesh.layers().iter().filter(|layer| (layer.domain() == Domain::Face) == of_faces);
        layers.map(|layer| layer.name().to_owned()).collect()
    };
    [names(false), names(true)]
}

/// The first corner or face of a repaired mesh that has another value than the one that it was as stored; the normals of
/// flipped faces have the opposite sign.
pub(crate) fn first_changed_value(
    stored: &PolygonMesh,
    repaired: &Repaired,
    result: &PolygonMesh,
) -> Option<String> {
    let opposite = stored.clone().with_layers(stored.layers().iter().map(turned).collect()).unwrap();
    let flipped: BTreeSet<FaceId> = repaired.provenance.flipped.iter().copied().collect();
    let source = |face: FaceId| if flipped.contains(&face) { &opposite } else { stored };
    let [of_corners, of_faces] = layer_names(stored);
    for name in &of_corners {
        for (new, old) in repaired.provenance.corners.iter() {
            let Some(old) = old else { continue };
            let before = corner_value(source(result.faces().corner_face(new)), name, old);
            let now = corner_value(result, name, new);
            if now != before {
                return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
            }
        }
    }
    for name in &of_faces {
        for (new, old) in repaired.provenance.faces.iter() {
            let Some(old) = old else { continue };
            let [now, before] = [face_value(result, name, new), face_value(source(new), name, old)];
            if now != before {
                return Some(format!("`{name}` of {new} is {now:?}, was {before:?}"));
            }
        }
    }
    None
}

/// Each face as its corners' positions and values in order from the least, with the values of the face; sorted.
///
/// It says what a mesh looks like, and nothing of how it is stored.
pub(crate) fn appearance(mesh: &PolygonMesh) -> Vec<String> {
    let [of_corners, of_faces] = layer_names(mesh);
    let corner = |corner: CornerId| {
        let values: Vec<_> = of_corners.iter().map(|name| corner_value(mesh, name, corner)).collect();
        format!("{:?} {values:?}", mesh.position(mesh.faces().corner_vertex(corner)))
    };
    let face = |face: FaceId| {
        let corners: Vec<String> = mesh.faces().face_corners(face).map(corner).collect();
        let least = (0..corners.len()).min_by_key(|&i| &corners[i]).unwrap_or(0);
        let values: Vec<_> = of_faces.iter().map(|name| face_value(mesh, name, face)).collect();
        format!("{:?} {values:?}", [&corners[least..], &corners[..least]].concat())
    };
    let mut faces: Vec<String> = mesh.faces().faces().map(face).collect();
    faces.sort();
    faces
}

pub(crate) fn readable(entries: &[Entry]) -> Vec<(&Entry, PolygonMesh)> {
    let here = entries.iter().filter(|entry| entry.is_read_here());
    let mesh = |entry: &Entry| Some(meshmend_io::read(&entry.path, &ReadOptions::default()).ok()?.mesh);
    here.filter_map(|entry| Some((entry, mesh(entry)?))).collect()
}
