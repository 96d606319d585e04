//! Which object and which material an element belongs to.

use std::collections::BTreeMap;

use meshmend_core::{Domain, Layer, PolygonMesh, Values};

use crate::layers::layer_of;

/// The statement that names the only solid of an STL file.
pub(super) const SOLID: &str = "solid";

/// The names of faces of one kind: their layer and its pool.
#[derive(Clone, Copy)]
pub(super) struct Names<'a> {
    pub(super) layer: &'a Layer,
    pub(super) pool: &'a [Vec<u8>],
}

/// The objects and the materials of faces.
pub(super) struct FaceNames<'a> {
    pub(super) objects: Option<Names<'a>>,
    pub(super) materials: Option<Names<'a>>,
    /// For each value in the pool of materials the number of its name. Equal names have one number.
    material_numbers: Vec<usize>,
    /// The different names of materials, by number.
    pub(super) material_names: Vec<&'a [u8]>,
    /// What an STL file calls its only solid.
    solid: Option<&'a [u8]>,
}

/// What tells in which mesh and in which primitive a face is: the value of its object and the number of its material.
pub(super) type Key = (Option<usize>, Option<usize>);

impl<'a> FaceNames<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let (objects, materials) = (Names::of(mesh, "object"), Names::of(mesh, "material"));
        let (mut material_numbers, mut material_names) = (Vec::new(), Vec::new());
        let mut numbers = BTreeMap::new();
        for name in materials.map_or(&[][..], |materials| materials.pool) {
            let number = *numbers.entry(&name[..]).or_insert(material_names.len());
            if number == material_names.len() {
                material_names.push(&name[..]);
            }
            material_numbers.push(number);
        }
        let solid = mesh.metadata().iter().find(|statement| statement.key == SOLID);
        let solid = solid.map(|solid| &solid.value[..]).filter(|_| objects.is_none());
        FaceNames { objects, materials, material_numbers, material_names, solid }
    }

    /// Whether all faces have one key, whatever they are.
    pub(super) fn are_absent(&self) -> bool {
        self.objects.is_none() && self.materials.is_none()
    }

    pub(super) fn key(&self, face: usize) -> Key {
        let object = self.objects.and_then(|objects| objects.layer.value_of(face));
        let material = self.materials.and_then(|materials| materials.layer.value_of(face));
        (object, material.map(|value| self.material_numbers[value]))
    }

    /// The names of the materials that some of so many faces have.
    pub(super) fn used_materials(&self, faces: usize) -> Vec<&'a [u8]> {
        let mut is_used = vec![false; self.material_names.len()];
        let faces = if self.materials.is_some() { 0..faces } else { 0..0 };
        faces.filter_map(|face| self.key(face).1).for_each(|number| is_used[number] = true);
        let names = self.material_names.iter().zip(is_used);
        names.filter(|(_, is_used)| *is_used).map(|(name, _)| *name).collect()
    }

    /// The name of an object. Without objects it is that of the solid.
    pub(super) fn object_name(&self, object: Option<usize>) -> Option<&'a [u8]> {
        match self.objects {
            Some(objects) => Some(&objects.pool[object?]),
            None => self.solid,
        }
    }
}

impl<'a> Names<'a> {
    fn of(mesh: &'a PolygonMesh, name: &str) -> Option<Self> {
        let is_text = |layer: &Layer| matches!(layer.values(), Values::Text(_)) && layer.width() == 1;
        let layer = layer_of(mesh, name, Domain::Face, is_text)?;
        if let Values::Text(pool) = layer.values() { Some(Names { layer, pool }) } else { None }
    }
}
