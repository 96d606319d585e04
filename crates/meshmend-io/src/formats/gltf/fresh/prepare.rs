//! What happens to a mesh before it is written: it becomes what the file will hold.

use meshmend_core::{Domain, DraftError, Layer};

use super::arrange::arrange;
use super::attributes::Kinds;
use super::{looks, values};
use crate::output::triangles::cut_polygons;
use crate::{Prepared, WriteErrorKind};

/// Rounds positions, cuts polygons, converts attributes to types of the format and moves them to the vertices, and
/// puts the elements in the order of the file.
///
/// *Cost*: linear in a mesh that fits; else that of cutting polygons and splitting vertices.
pub(in crate::formats::gltf) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    prepared.name_textures()?;
    prepared.round_positions();
    cut_polygons(prepared)?;
    convert(prepared)?;
    let attributes = Kinds::of(prepared.mesh.layers());
    let is_moved =
        |(at, layer): &(usize, &Layer)| layer.domain() == Domain::Corner && attributes.kind(*at).is_some();
    let layers = prepared.mesh.layers().iter().enumerate();
    let moved: Vec<usize> = layers.filter(is_moved).map(|(at, _)| at).collect();
    prepared.bring_to_vertices(&moved)?;
    arrange(prepared)?;
    looks::take(prepared);
    Ok(())
}

/// Converts the layers that become attributes to types of the format.
fn convert(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    let kinds = Kinds::of(prepared.mesh.layers());
    let mut layers = prepared.mesh.layers().to_vec();
    for (at, layer) in layers.iter_mut().enumerate() {
        if let Some(kind) = kinds.kind(at) {
            let (converted, losses) = values::converted(layer, kind);
            *layer = converted;
            prepared.losses.extend(losses);
        }
    }
    prepared.mesh = prepared.mesh.clone().with_layers(layers).map_err(DraftError::from)?;
    Ok(())
}
