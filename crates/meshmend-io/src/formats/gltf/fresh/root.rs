//! What the text of a file says.

use std::io;

use super::accessors::{File, PlacedObject};
use super::json;
use super::losses::utf8;
use super::materials::{Members, members};
use super::plan::{Elements, Primitive};
use crate::{Prepared, WriteErrorKind};

/// The text of a file whose buffer is elsewhere, or in a URI that begins so.
pub(super) fn text_of(
    prepared: &Prepared,
    file: &File<'_>,
    uri: Option<&'static str>,
) -> Result<Vec<u8>, WriteErrorKind> {
    let places = MaterialPlaces::of(file);
    let meshes = file.objects.iter().map(|placed| json::Mesh {
        name: placed.object.name.map(utf8),
        primitives: primitives(file, placed, &places),
    });
    let nodes = file.objects.iter().zip(0..);
    let nodes = nodes.map(|(placed, mesh)| json::Node { name: placed.object.name.map(utf8), mesh });
    let buffer = json::Buffer { byte_length: file.length, uri };
    let names = places.used.iter().map(|&at| file.names.material_names[at]);
    let Members { materials, textures, images } = members(prepared, names, file.accessors);
    let has_objects = !file.objects.is_empty();
    let root = json::Root {
        asset: json::Asset { version: "2.0", generator: "meshmend" },
        scene: has_objects.then_some(0),
        scenes: has_objects
            .then(|| json::Scene { nodes: (0..file.objects.len()).collect() })
            .into_iter()
            .collect(),
        nodes: nodes.collect(),
        meshes: meshes.collect(),
        materials,
        textures,
        images,
        accessors: (0..file.accessors).map(|at| file.accessor(at)).collect(),
        buffer_views: file.views.iter().map(|view| file.buffer_view(view)).collect(),
        buffers: has_objects.then_some(buffer).into_iter().collect(),
    };
    Ok(serde_json::to_vec(&root).map_err(io::Error::from)?)
}

fn primitives<'a>(
    file: &'a File<'_>,
    placed: &PlacedObject<'_>,
    places: &MaterialPlaces,
) -> Vec<json::Primitive<'a>> {
    let of_attributes = placed.attributes.iter().map(|&(at, view)| (&*file.attributes[at].semantic, view));
    let attributes: Vec<(&str, usize)> =
        [("POSITION", placed.positions)].into_iter().chain(of_attributes).collect();
    let primitives = placed.object.primitives.iter().zip(&placed.indices);
    let primitive = |(primitive, &indices): (&Primitive, &Option<usize>)| json::Primitive {
        attributes: attributes.clone(),
        indices,
        material: primitive.material.and_then(|number| places.of_number[number]),
        mode: primitive.elements.mode(),
    };
    primitives.map(primitive).collect()
}

impl Elements {
    fn mode(&self) -> u8 {
        match self {
            Self::Faces(_) => json::TRIANGLES,
            Self::LooseEdges => json::LINES,
            Self::LoosePoints | Self::Vertices => json::POINTS,
        }
    }
}

/// Which materials a file has: those that faces use.
struct MaterialPlaces {
    used: Vec<usize>,
    of_number: Vec<Option<usize>>,
}

impl MaterialPlaces {
    fn of(file: &File<'_>) -> Self {
        let mut of_number = vec![None; file.names.material_names.len()];
        let primitives = file.objects.iter().flat_map(|placed| &placed.object.primitives);
        primitives.filter_map(|primitive| primitive.material).for_each(|number| of_number[number] = Some(0));
        let used: Vec<usize> = (0..of_number.len()).filter(|&number| of_number[number].is_some()).collect();
        used.iter().enumerate().for_each(|(place, &number)| of_number[number] = Some(place));
        MaterialPlaces { used, of_number }
    }
}
