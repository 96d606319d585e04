//! What a new file won't carry.

use meshmend_core::{Domain, Layer};

use super::accessors::{File, PlacedObject};
use super::attributes::Attribute;
use super::objects::SOLID;
use crate::output::layer_losses::{absent_loss, layer_losses, losses_in};
use crate::output::statements::metadata_losses;
use crate::text::one_or_many;
use crate::{Loss, LossKind, Prepared};

/// The statement that names material libraries.
const LIBRARY: &str = "mtllib";

/// The losses of layers, names and statements.
pub(in crate::formats::gltf) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let file = File::of(prepared);
    let is_written = |at: usize| file.objects.iter().any(|placed| placed.has_attribute(at));
    let attributes = file.attributes.iter().enumerate();
    let written: Vec<&Attribute<'_>> =
        attributes.filter(|&(at, _)| is_written(at)).map(|(_, attribute)| attribute).collect();
    let names = [file.names.objects, file.names.materials];
    let of_faces = names.into_iter().flatten().map(|names| names.layer);
    let layers: Vec<&Layer> = written.iter().map(|attribute| attribute.layer).chain(of_faces).collect();
    let mut losses = layer_losses(mesh, &layers);
    losses.extend(losses_in(mesh, &[], &[Domain::LooseEdge, Domain::LoosePoint]));
    losses.extend(
        file.attributes
            .iter()
            .enumerate()
            .filter_map(|(at, attribute)| absent_loss(attribute.layer, file.substituted(at))),
    );
    let is_named =
        file.names.objects.is_none() && file.objects.iter().any(|placed| placed.object.name.is_some());
    // The members say what libraries say.
    losses.extend(metadata_losses(mesh, if is_named { &[SOLID, LIBRARY] } else { &[LIBRARY] }));
    losses.extend(name_loss(&file));
    losses
}

impl File<'_> {
    /// How many vertices get a value that they did not have, as others of their object have one.
    fn substituted(&self, attribute: usize) -> usize {
        let has_attribute = |placed: &&PlacedObject<'_>| placed.has_attribute(attribute);
        let objects = self.objects.iter().filter(has_attribute);
        let vertices = objects.flat_map(|placed| placed.object.vertices.clone());
        let layer = self.attributes[attribute].layer;
        vertices.filter(|&vertex| layer.value_of(vertex).is_none()).count()
    }
}

/// The loss of names that are not UTF-8.
fn name_loss(file: &File<'_>) -> Option<Loss> {
    let objects = file.objects.iter().filter_map(|placed| placed.object.name);
    let names = objects.chain(file.names.material_names.iter().copied());
    let other = names.filter(|name| std::str::from_utf8(name).is_err()).count();
    Loss::if_any(LossKind::Names, other, |n| {
        one_or_many(n, "name is spelled differently", "names are spelled differently")
    })
}

/// A name as text. Bytes that are not UTF-8 are replaced.
pub(super) fn utf8(name: &[u8]) -> String {
    String::from_utf8_lossy(name).into_owned()
}
