//! Which objects a new package has: one for each name of the layer `object`, or one.

use std::collections::BTreeMap;

use meshmend_core::{Domain, FaceId, Id, Layer, PolygonMesh, Values, VertexId};

use crate::layers::layer_of;

/// The objects of a new package, in the order of their first faces.
pub(super) struct Objects<'a> {
    pub(super) list: Vec<NewObject<'a>>,
    /// The layer that names them, if there is more than one, or if the one has a name.
    pub(super) layer: Option<&'a Layer>,
}

/// One object.
pub(super) struct NewObject<'a> {
    pub(super) name: &'a [u8],
    pub(super) faces: Vec<FaceId>,
    /// Its vertices in the order in which it has them.
    pub(super) vertices: Vec<VertexId>,
}

impl<'a> Objects<'a> {
    /// *Cost*: linear, and O(log n) a face in the number of objects.
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let named = text_layer(mesh, "object");
        // An empty name is none.
        let name =
            |value: usize| named.and_then(|(_, names)| names.get(value)).filter(|name| !name.is_empty());
        let value = |face: FaceId| {
            let value = named.and_then(|(layer, _)| layer.value_of(face.index()));
            value.filter(|&value| name(value).is_some())
        };
        let mut numbers: BTreeMap<Option<usize>, usize> = BTreeMap::new();
        let mut list: Vec<NewObject<'a>> = Vec::new();
        for face in mesh.faces().faces().filter(|&face| mesh.faces().corner_range(face).len() > 2) {
            let value = value(face);
            let number = *numbers.entry(value).or_insert(list.len());
            if number == list.len() {
                let name = value.and_then(name).map_or(&[][..], Vec::as_slice);
                list.push(NewObject { name, faces: Vec::new(), vertices: Vec::new() });
            }
            list[number].faces.push(face);
        }
        if list.is_empty() && !mesh.positions().is_empty() {
            list.push(NewObject { name: &[], faces: Vec::new(), vertices: Vec::new() });
        }
        match list.as_mut_slice() {
            [only] => only.vertices = (0..mesh.counts().vertices).map(VertexId::new).collect(),
            several => several.iter_mut().for_each(|object| object.collect_vertices(mesh)),
        }
        Objects { list, layer: named.map(|(layer, _)| layer) }
    }

    /// How many faces come behind one that they came before, and how many vertices do.
    pub(super) fn moved(&self) -> [usize; 2] {
        let faces = self.list.iter().flat_map(|object| &object.faces);
        let vertices = self.list.iter().flat_map(|object| &object.vertices);
        [descents(faces), descents(vertices)]
    }

    /// How many vertices the objects have together.
    pub(super) fn vertex_count(&self) -> usize {
        self.list.iter().map(|object| object.vertices.len()).sum()
    }
}

fn descents<'i, I: Ord + 'i>(ids: impl Iterator<Item = &'i I> + Clone) -> usize {
    ids.clone().zip(ids.skip(1)).filter(|(one, next)| next < one).count()
}

impl NewObject<'_> {
    fn collect_vertices(&mut self, mesh: &PolygonMesh) {
        let vertices = self.faces.iter().flat_map(|&face| mesh.faces().face_vertices(face).iter().copied());
        self.vertices = vertices.collect();
        self.vertices.sort_unstable();
        self.vertices.dedup();
    }
}

/// The materials of a new package: each name once, in the order of the faces.
pub(super) struct Materials<'a> {
    pub(super) layer: &'a Layer,
    pub(super) names: Vec<&'a [u8]>,
    /// For each value of the layer the number of its name.
    numbers: Vec<u32>,
}

impl<'a> Materials<'a> {
    /// The materials that faces of objects have.
    pub(super) fn of(mesh: &'a PolygonMesh, objects: &Objects<'a>) -> Option<Self> {
        let (layer, pool) = text_layer(mesh, "material")?;
        let mut found: BTreeMap<&[u8], u32> = BTreeMap::new();
        let (mut names, mut numbers) = (Vec::new(), vec![0; pool.len()]);
        for face in objects.list.iter().flat_map(|object| &object.faces) {
            let Some(value) = layer.value_of(face.index()) else { continue };
            let name = pool[value].as_slice();
            numbers[value] = *found.entry(name).or_insert_with(|| {
                names.push(name);
                names.len() as u32 - 1
            });
        }
        (!names.is_empty()).then_some(Materials { layer, names, numbers })
    }

    /// The number of the material of a face.
    pub(super) fn number(&self, face: FaceId) -> Option<u32> {
        self.layer.value_of(face.index()).and_then(|value| self.numbers.get(value)).copied()
    }
}

/// The layer of faces of this name whose values are names, and its names.
pub(super) fn text_layer<'a>(mesh: &'a PolygonMesh, name: &str) -> Option<(&'a Layer, &'a [Vec<u8>])> {
    let is_text = |layer: &Layer| matches!(layer.values(), Values::Text(_)) && layer.width() == 1;
    let layer = layer_of(mesh, name, Domain::Face, is_text)?;
    if let Values::Text(names) = layer.values() { Some((layer, names)) } else { None }
}
