//! The meshes and the primitives of a file, from a mesh whose elements are in the order of the file.

use std::ops::Range;

use meshmend_core::{Id, PolygonMesh, VertexId};

use super::objects::{FaceNames, Key};

/// A node with its mesh.
pub(super) struct Object<'a> {
    pub(super) name: Option<&'a [u8]>,
    pub(super) vertices: Range<usize>,
    pub(super) primitives: Vec<Primitive>,
}

/// Elements with one material.
pub(super) struct Primitive {
    pub(super) elements: Elements,
    /// The number of the name of the material.
    pub(super) material: Option<usize>,
}

#[derive(Clone)]
pub(super) enum Elements {
    Faces(Range<usize>),
    LooseEdges,
    LoosePoints,
    /// All vertices of the object.
    Vertices,
}

/// The objects of a file.
///
/// *Cost*: linear in the faces.
pub(super) fn objects<'a>(mesh: &PolygonMesh, names: &FaceNames<'a>) -> Vec<Object<'a>> {
    let counts = mesh.counts();
    let mut objects = objects_of_faces(mesh, names);
    let loose = loose(mesh);
    match &mut objects[..] {
        [] if loose.is_empty() && counts.vertices == 0 => {}
        [] => {
            let primitives = if loose.is_empty() { vec![Primitive::of(Elements::Vertices)] } else { loose };
            objects.push(Object { name: None, vertices: 0..counts.vertices, primitives });
        }
        [only] => {
            only.vertices = 0..counts.vertices;
            only.primitives.extend(loose);
        }
        _ if loose.is_empty() => {}
        several => {
            let vertices = 0..several.iter().map(|object| object.vertices.start).min().unwrap_or(0);
            objects.insert(0, Object { name: None, vertices, primitives: loose });
        }
    }
    objects
}

impl Primitive {
    fn of(elements: Elements) -> Self {
        Primitive { elements, material: None }
    }
}

fn loose(mesh: &PolygonMesh) -> Vec<Primitive> {
    let edges = (!mesh.loose_edges().is_empty()).then(|| Primitive::of(Elements::LooseEdges));
    let points = (!mesh.loose_points().is_empty()).then(|| Primitive::of(Elements::LoosePoints));
    edges.into_iter().chain(points).collect()
}

fn objects_of_faces<'a>(mesh: &PolygonMesh, names: &FaceNames<'a>) -> Vec<Object<'a>> {
    let count = mesh.counts().faces;
    let mut objects: Vec<Object<'a>> = Vec::new();
    let mut last: Option<Key> = None;
    let mut first = 0;
    while first < count {
        let key = names.key(first);
        let end = if names.are_absent() { count } else { end_of_run(names, key, first, count) };
        let vertices = vertices_of(mesh, first..end);
        let primitive = Primitive { elements: Elements::Faces(first..end), material: key.1 };
        match objects.last_mut().filter(|_| last.is_some_and(|last| last.0 == key.0)) {
            Some(object) => {
                let all = &object.vertices;
                object.vertices = all.start.min(vertices.start)..all.end.max(vertices.end);
                object.primitives.push(primitive);
            }
            None => {
                let name = names.object_name(key.0);
                objects.push(Object { name, vertices, primitives: vec![primitive] });
            }
        }
        (last, first) = (Some(key), end);
    }
    objects
}

fn end_of_run(names: &FaceNames<'_>, key: Key, first: usize, count: usize) -> usize {
    (first + 1..count).find(|&face| names.key(face) != key).unwrap_or(count)
}

/// The range of vertices that some faces use.
fn vertices_of(mesh: &PolygonMesh, faces: Range<usize>) -> Range<usize> {
    let corners: &[VertexId] = &mesh.faces().corner_vertices()[faces.start * 3..faces.end * 3];
    let numbers = || corners.iter().map(|vertex| vertex.index());
    numbers().min().unwrap_or(0)..numbers().max().map_or(0, |last| last + 1)
}
