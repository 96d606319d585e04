//! The objects of a package as the parts of a document.
//!
//! A layer of vertices and one of faces name the row of the text that each is: `row`. They ride through all passes, and
//! are how the writer finds the rows that stay.

use std::collections::BTreeMap;
use std::sync::Arc;

use meshmend_core::{Carry, Domain, FaceTable, Layer, NO_VALUE, PolygonMesh, Role, Values};

use crate::document::{Material, Part, PartSource, PartStatus};
use crate::formats::threemf::model::{BaseMaterials, Content, MeshText, Model, NONE, Object, Places};
use crate::formats::threemf::package::Fault;

/// The layer that names the row of a vertex or a face.
pub(super) const ROW: &str = "row";

/// What the writer has to know of a part beside its mesh.
#[derive(Debug)]
pub(super) struct Origin {
    /// Which of the models it is in.
    pub(super) model: usize,
    pub(super) id: u32,
    /// Its mesh as it was read.
    pub(super) mesh: PolygonMesh,
    pub(super) places: Places,
    pub(super) has_slices: bool,
}

/// The parts of all models in order, and what a writer has to know of them.
///
/// # Errors
/// If a mesh has more elements than a mesh can have.
pub(super) fn of(models: Vec<Model>) -> Result<(Vec<Part>, Vec<Origin>), Fault> {
    let (mut parts, mut origins) = (Vec::new(), Vec::new());
    for (at, model) in models.into_iter().enumerate() {
        let materials = Groups::of(&model.materials);
        for object in model.objects {
            let Object { id, name, kind, content, has_slices } = object;
            let (text, seal) = match content {
                Content::Components(_) => continue,
                Content::Mesh(mesh) => {
                    let seal = mesh.unknown.as_ref().map(|name| seal(id, name));
                    (*mesh, seal)
                }
                Content::Other(name) => (MeshText::default(), Some(format!("object {id} {name}"))),
            };
            let places = text.places.clone();
            let failed = |reason: String| Fault::of_object(&model.entry, id, reason);
            let mesh = mesh_of(text, &materials).map_err(failed)?;
            let source = PartSource::ThreeMfObject { entry: Arc::clone(&model.entry), id, kind };
            let status = seal.map_or(PartStatus::Editable, PartStatus::Sealed);
            parts.push(Part { name: name.into_bytes(), source, mesh: mesh.clone(), status });
            origins.push(Origin { model: at, id, mesh, places, has_slices });
        }
    }
    Ok((parts, origins))
}

fn seal(id: u32, name: &str) -> String {
    format!("object {id} holds `{name}`, which numbers its vertices or triangles in a way not known here")
}

fn mesh_of(text: MeshText, materials: &Groups<'_>) -> Result<PolygonMesh, String> {
    let MeshText { positions, corners, groups, members, .. } = text;
    let (vertices, triangles) = (positions.len(), corners.len() / 3);
    let faces = FaceTable::triangles(vertices, corners).map_err(|error| error.to_string())?;
    let mesh = PolygonMesh::new(positions, faces).map_err(|error| error.to_string())?;
    let mut layers = vec![rows(Domain::Vertex, vertices), rows(Domain::Face, triangles)];
    let material = material_layer(&groups, &members, materials);
    let is_told = material.as_ref().is_some_and(|material| tells_all(material, &groups, &members));
    layers.extend(material);
    // Where each triangle has a base material, its name says it all.
    if !groups.is_empty() && !is_told {
        layers.push(numbers("pid", Domain::Face, groups));
        layers.push(numbers("property", Domain::Corner, members));
    }
    mesh.with_layers(layers).map_err(|error| error.to_string())
}

fn rows(domain: Domain, count: usize) -> Layer {
    let rows = Values::U32((0..count as u32).collect());
    Layer::direct(ROW, domain, 1, Carry::Clear, rows).with_role(Role::Identity)
}

/// A layer of numbers, each of which stands once in the pool.
fn numbers(name: &str, domain: Domain, values: Vec<u32>) -> Layer {
    let mut pool = values.clone();
    pool.sort_unstable();
    pool.dedup();
    pool.retain(|&value| value != NONE);
    let place = |value: &u32| pool.binary_search(value).map_or(NO_VALUE, |place| place as u32);
    let uses = values.iter().map(place).collect();
    Layer::indexed(name, domain, 1, Carry::Copy, Values::U32(pool), uses)
}

/// Whether the names of materials say all that groups and their members do.
fn tells_all(material: &Layer, groups: &[u32], members: &[u32]) -> bool {
    groups.iter().zip(members.chunks(3)).enumerate().all(|(triangle, (&group, members))| {
        let is_uniform = members.iter().all(|&member| member == members[0]);
        group == NONE || (is_uniform && material.value_of(triangle).is_some())
    })
}

/// The base materials of a model by the ids of their groups.
pub(super) struct Groups<'a> {
    groups: BTreeMap<u32, &'a [Material]>,
}

impl<'a> Groups<'a> {
    pub(super) fn of(materials: &'a [BaseMaterials]) -> Self {
        Groups { groups: materials.iter().map(|group| (group.id, group.members.as_slice())).collect() }
    }

    fn name(&self, group: u32, member: u32) -> Option<&'a [u8]> {
        self.groups.get(&group)?.get(member as usize).map(|material| material.name.as_slice())
    }
}

/// The names of the base materials that triangles have, each member of a group once.
fn material_layer(groups: &[u32], members: &[u32], materials: &Groups<'_>) -> Option<Layer> {
    let mut known: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    let (mut names, mut uses) = (Vec::new(), Vec::with_capacity(groups.len()));
    for (&group, &member) in groups.iter().zip(members.iter().step_by(3)) {
        let Some(name) = materials.name(group, member) else {
            uses.push(NO_VALUE);
            continue;
        };
        uses.push(*known.entry((group, member)).or_insert_with(|| {
            names.push(name.to_vec());
            names.len() as u32 - 1
        }));
    }
    let has_some = !names.is_empty();
    has_some.then(|| Layer::indexed("material", Domain::Face, 1, Carry::Copy, Values::Text(names), uses))
}
