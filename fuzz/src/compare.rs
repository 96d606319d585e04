//! What two meshes have in common, where numbers are the same when they are equal to the bit or both no number; and what
//! any mesh that is read and any error has to be.

use meshmend_core::{Layer, PolygonMesh, Role, Values};
use meshmend_io::{Place, ReadError};
use meshmend_testkit::laws::{Entry, layer_entries, number_key};

/// The points of a mesh, comparable.
pub(crate) fn position_keys(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    mesh.positions().iter().map(|point| point.map(number_key)).collect()
}

/// Whether two meshes have the same values under a name; elements without any value are the same as no layer, and a
/// colour that is opaque is the same with its alpha and without.
pub(crate) fn same_layer(one: &Layer, other: &PolygonMesh) -> bool {
    let entries = layer_entries(one);
    match other.layer(one.name(), one.domain()) {
        Some(layer) if is_opaque(one) && layer.width() == 3 => layer_entries(layer) == without_alpha(entries),
        Some(layer) => layer_entries(layer) == entries,
        None => entries.iter().all(Option::is_none),
    }
}

/// Whether a layer has colours with an alpha that is full in each.
fn is_opaque(layer: &Layer) -> bool {
    let full = if matches!(layer.values(), Values::F32(_) | Values::F64(_)) { 1.0 } else { 255.0 };
    let full = Entry::Number(number_key(full));
    layer.role() == Role::Color
        && layer.width() == 4
        && layer_entries(layer).iter().flatten().all(|color| color[3] == full)
}

fn without_alpha(mut colors: Vec<Option<Vec<Entry>>>) -> Vec<Option<Vec<Entry>>> {
    colors.iter_mut().flatten().for_each(|color| color.truncate(3));
    colors
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
        let elements = mesh.element_count(layer.domain());
        assert_eq!(layer.element_count(), elements, "elements of layer {:?}", layer.name());
        assert_eq!(layer_entries(layer).len(), elements);
    }
    assert_eq!(mesh.complex().faces().face_count(), counts.faces);
}

/// An error says where in the file it is, or that it is about all of it, on one line of text.
pub(crate) fn assert_located(error: &ReadError, data: &[u8]) {
    let lines = data.iter().filter(|b| matches!(b, b'\n' | b'\r')).count() as u64 + 1;
    match &error.place {
        Place::File => {}
        Place::Line(line) => assert!((1..=lines).contains(line), "{error}: there are {lines} lines"),
        Place::Byte(byte) => assert!(*byte <= data.len() as u64, "{error}: there are {} bytes", data.len()),
        Place::Pointer(pointer) => assert!(pointer.starts_with('/'), "{error}"),
        place => assert!(!place.to_string().is_empty(), "{error}"),
    }
    assert!(!error.to_string().contains('\n'), "{error}");
}
