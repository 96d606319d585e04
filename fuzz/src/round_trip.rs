//! Writers: a mesh with everything reads back from every format, and what is not the same is named as a loss.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{Domain, Layer, PolygonMesh};
use meshmend_io::{Encoding, Format, Loss, LossKind, WriteOptions, encode, losses};
use meshmend_testkit::laws::{Entry, layer_entries, number_key};

use crate::compare::{assert_well_formed, position_keys, same_layer};
use crate::input::DressedMesh;
use crate::readers::read_as;

/// A small mesh with loose elements, attributes and statements, through every format in every encoding.
pub fn round_trip(data: &[u8]) {
    let Ok(DressedMesh(mesh)) = DressedMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            through(&mesh, format, encoding);
        }
    }
}

fn through(mesh: &PolygonMesh, format: Format, encoding: Encoding) {
    let options = WriteOptions::of(format).with_encoding(encoding);
    let mut bytes = Vec::new();
    let named = encode(mesh, &options, &mut bytes).expect("a small mesh can be written");
    assert_eq!(named, losses(mesh, &options), "losses without writing");
    let text = || String::from_utf8_lossy(&bytes);
    let again = match read_as(format, &bytes) {
        Ok(file) => file.mesh,
        Err(error) => panic!("{format} {encoding}: {error} in\n{}", text()),
    };
    assert_well_formed(&again);
    if is_scene(format) {
        return assert_same_faces(mesh, &again, &named);
    }
    for Difference { what, excuses } in differences(mesh, &again, format) {
        let excused = |loss: &Loss| {
            excuses.iter().any(|excuse| excuse.kind == loss.kind && loss.message.contains(&excuse.name))
        };
        assert!(
            named.iter().any(excused),
            "{format} {encoding}: {what} changed, but named are {named:?}\n{}",
            text()
        );
    }
    assert_stable(&again, format, options);
}

/// Whether a format places several meshes in a scene, so that one mesh comes back in another order.
fn is_scene(format: Format) -> bool {
    matches!(format, Format::Glb | Format::Gltf)
}

/// The same faces in any order, unless a loss says what became of them.
fn assert_same_faces(old: &PolygonMesh, new: &PolygonMesh, named: &[Loss]) {
    use LossKind::{NonFiniteFaces, Polygons, Precision, ShortFaces};
    if named.iter().any(|loss| [NonFiniteFaces, Polygons, Precision, ShortFaces].contains(&loss.kind)) {
        return;
    }
    let sorted = |mesh: &PolygonMesh| {
        let mut points = corner_points(mesh);
        points.sort();
        points
    };
    assert_eq!(sorted(old), sorted(new), "{named:?}");
}

/// What was read from a file of this program is written and read without any further change.
fn assert_stable(mesh: &PolygonMesh, format: Format, options: WriteOptions) {
    let write = |mesh: &PolygonMesh| {
        let mut bytes = Vec::new();
        encode(mesh, &options, &mut bytes).expect("a small mesh can be written");
        bytes
    };
    let once = write(mesh);
    let twice = write(&read_as(format, &once).expect("what was written can be read").mesh);
    let [one, other] = [&once, &twice].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(once == twice, "{format} is written otherwise each time:\n{one}\n{other}");
}

/// Something that is not the same after writing and reading.
struct Difference {
    what: String,
    /// The losses any of which says so.
    excuses: Vec<Excuse>,
}

/// A loss of a kind whose message has a name in it.
struct Excuse {
    kind: LossKind,
    name: String,
}

impl Difference {
    fn of(what: impl Into<String>, kinds: &[LossKind]) -> Self {
        Difference { what: what.into(), excuses: Vec::new() }.or(kinds, "")
    }

    fn or(mut self, kinds: &[LossKind], name: &str) -> Self {
        self.excuses.extend(kinds.iter().map(|&kind| Excuse { kind, name: name.to_owned() }));
        self
    }
}

fn differences(old: &PolygonMesh, new: &PolygonMesh, format: Format) -> Vec<Difference> {
    let mut found = differences_of_shape(old, new, format);
    if old.loose_edges() != new.loose_edges() {
        found.push(Difference::of("loose edges", &[LossKind::LooseEdges]));
    }
    if old.loose_points() != new.loose_points() {
        found.push(Difference::of("loose points", &[LossKind::LoosePoints]));
    }
    // A file without a vertex has a comment that says so.
    let says_nothing = old.counts().vertices == 0 && old.metadata().is_empty();
    // The only solid's name is the file's.
    let is_renamed = format == Format::Stl && old.layer("object", Domain::Face).is_some();
    if !says_nothing && !is_renamed && old.metadata() != new.metadata() {
        found.push(Difference::of("metadata", &[LossKind::Metadata, LossKind::Names]));
    }
    let unnamed = [LossKind::Converted, LossKind::Names, LossKind::Polygons, LossKind::ShortFaces];
    for layer in old
        .layers()
        .iter()
        .filter(|layer| !(is_renamed && layer.name() == "object"))
        .filter(|layer| has_values(layer) && !same_layer(layer, new) && !is_spread(layer, new))
    {
        let difference = Difference::of(format!("{layer:?}"), &unnamed);
        let difference =
            difference.or(&[LossKind::Layer, LossKind::AbsentValue], &format!("`{}`", layer.name()));
        let alpha = [LossKind::Layer];
        let alpha = if is_without_alpha(layer, new) { &alpha[..] } else { &[] };
        found.push(difference.or(alpha, "the alpha of the colours of"));
    }
    for layer in new.layers().iter().filter(|layer| has_values(layer)) {
        let is_old = |name: &str| old.layer(name, layer.domain()).is_some();
        let stem = layer.name().rsplit_once('_').map_or("", |(stem, _)| stem);
        if !is_old(layer.name()) && !is_old(stem) {
            found.push(Difference::of(format!("new {layer:?}"), &[LossKind::Converted, LossKind::Names]));
        }
    }
    found
}

fn differences_of_shape(old: &PolygonMesh, new: &PolygonMesh, format: Format) -> Vec<Difference> {
    use LossKind::{Converted, Polygons, Precision, SharedVertices, ShortFaces, UnusedVertices};
    if format == Format::Stl {
        // Without indices: each face has vertices of its own.
        let differs = corner_points(old) != corner_points(new);
        let kinds = [Precision, SharedVertices, UnusedVertices, Polygons, ShortFaces];
        return differs.then(|| Difference::of("the shape", &kinds)).into_iter().collect();
    }
    if format == Format::ThreeMf {
        // Objects of several names have vertices of their own, and their faces follow one another.
        let differs = position_keys(old) != position_keys(new) || old.faces() != new.faces();
        let kinds = [Converted, SharedVertices, UnusedVertices, Polygons, ShortFaces];
        return differs.then(|| Difference::of("the shape", &kinds)).into_iter().collect();
    }
    let of_positions = (position_keys(old) != position_keys(new)).then(|| Difference::of("positions", &[]));
    let of_faces = (old.faces() != new.faces()).then(|| Difference::of("faces", &[]));
    of_positions.into_iter().chain(of_faces).collect()
}

/// Whether any element has a value; an empty list is none.
fn has_values(layer: &Layer) -> bool {
    let is_value = |entry: &Entry| !matches!(entry, Entry::List(list) if list.is_empty());
    layer_entries(layer).iter().flatten().flatten().any(is_value)
}

/// Whether a layer of colours lost nothing but how far they are opaque.
fn is_without_alpha(layer: &Layer, new: &PolygonMesh) -> bool {
    let opaque = |layer: &Layer| -> Vec<Option<Vec<Entry>>> {
        let values = layer_entries(layer).into_iter();
        values.map(|value| value.map(|value| value.into_iter().take(3).collect())).collect()
    };
    let colors = new.layer("color", layer.domain()).filter(|colors| colors.width() == 3);
    layer.name() == "color"
        && layer.width() == 4
        && colors.is_some_and(|colors| opaque(colors) == opaque(layer))
}

/// Whether a layer of several numbers a value became one layer for each of them.
fn is_spread(layer: &Layer, new: &PolygonMesh) -> bool {
    let entries = layer_entries(layer);
    let component = |i: usize| -> Vec<Option<Vec<Entry>>> {
        entries.iter().map(|value| value.as_ref().map(|value| vec![value[i].clone()])).collect()
    };
    let is_kept = |i: usize| {
        let single = new.layer(&format!("{}_{i}", layer.name()), layer.domain());
        single.is_some_and(|single| layer_entries(single) == component(i))
    };
    layer.width() > 1 && (0..layer.width()).all(is_kept)
}

/// The points of each face's corners.
fn corner_points(mesh: &PolygonMesh) -> Vec<Vec<[u64; 3]>> {
    let points =
        |face| mesh.faces().face_vertices(face).iter().map(|&v| mesh.position(v).map(number_key)).collect();
    mesh.faces().faces().map(points).collect()
}
