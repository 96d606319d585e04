//! What two meshes have in common, where numbers are the same when they are equal to the bit or both no number.

use meshmend_core::{Domain, Layer, PolygonMesh, Values};

/// A number by which it can be compared: all that are no number are one.
pub(crate) fn number_key(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

/// The points of a mesh, comparable.
pub(crate) fn position_keys(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    mesh.positions().iter().map(|point| point.map(number_key)).collect()
}

/// One entry of a layer's value, comparable.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entry {
    Number(u64),
    Text(Vec<u8>),
    List(Vec<Entry>),
}

fn entry(values: &Values, at: usize) -> Entry {
    let number = |x: f64| Entry::Number(number_key(x));
    match values {
        Values::I8(v) => number(v[at].into()),
        Values::U8(v) => number(v[at].into()),
        Values::I16(v) => number(v[at].into()),
        Values::U16(v) => number(v[at].into()),
        Values::I32(v) => number(v[at].into()),
        Values::U32(v) => number(v[at].into()),
        Values::F32(v) => number(v[at].into()),
        Values::F64(v) => number(v[at]),
        Values::Text(v) => Entry::Text(v[at].clone()),
        Values::Lists { starts, items } => {
            Entry::List((starts[at]..starts[at + 1]).map(|item| entry(items, item as usize)).collect())
        }
    }
}

/// The value that each element has in a layer.
pub(crate) fn layer_entries(layer: &Layer) -> Vec<Option<Vec<Entry>>> {
    let width = layer.width();
    let value =
        |value: usize| (value * width..(value + 1) * width).map(|at| entry(layer.values(), at)).collect();
    (0..layer.element_count()).map(|element| layer.value_of(element).map(value)).collect()
}

/// Whether two meshes have the same values under a name; elements without any value are the same as no layer.
pub(crate) fn same_layer(one: &Layer, other: &PolygonMesh) -> bool {
    let entries = layer_entries(one);
    match other.layer(one.name(), one.domain()) {
        Some(layer) => layer_entries(layer) == entries,
        None => entries.iter().all(Option::is_none),
    }
}

/// Panics unless a mesh is what it claims to be: every index within range, every layer as long as it has to be.
pub(crate) fn assert_well_formed(mesh: &PolygonMesh) {
    let counts = mesh.counts();
    assert_eq!(mesh.positions().len(), counts.vertices);
    let exists = |v: u32| (v as usize) < counts.vertices;
    for face in mesh.faces().faces() {
        assert!(
            mesh.faces().face_vertices(face).iter().all(|v| exists(v.0)),
            "{face} names a vertex that is not there"
        );
    }
    assert!(mesh.loose_edges().iter().flatten().chain(mesh.loose_points()).all(|v| exists(v.0)));
    for layer in mesh.layers() {
        let elements = match layer.domain() {
            Domain::Vertex => counts.vertices,
            Domain::Corner => counts.corners,
            Domain::Face => counts.faces,
        };
        assert_eq!(layer.element_count(), elements, "elements of layer {:?}", layer.name());
        assert_eq!(layer_entries(layer).len(), elements);
    }
    assert_eq!(mesh.complex().faces().face_count(), counts.faces);
}
