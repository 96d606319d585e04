//! The losses of attribute layers and loose elements that a format leaves out.

use meshmend_core::{Domain, Layer, PolygonMesh, counted};

use crate::{Loss, LossKind};

/// How many elements have no value in a layer.
pub(crate) fn absent(layer: &Layer) -> usize {
    (0..layer.element_count()).filter(|&element| layer.value_of(element).is_none()).count()
}

/// The loss when a format gives a value to elements that had none.
pub(crate) fn absent_loss(layer: &Layer, count: usize) -> Option<Loss> {
    Loss::if_any(LossKind::AbsentValue, count, |count| {
        let (domain, name) = (layer.domain().name(), layer.name());
        let have = if count == 1 { "has" } else { "have" };
        format!("that {} {have} no {domain} attribute `{name}`", counted(count, domain))
    })
}

/// A loss for each layer of vertices, corners and faces that is not written.
pub(crate) fn layer_losses(mesh: &PolygonMesh, written: &[&Layer]) -> Vec<Loss> {
    losses_in(mesh, written, &[Domain::Vertex, Domain::Corner, Domain::Face])
}

/// A loss for each layer of some kinds of element that is not written. Layers of loose elements have a loss only if
/// the format keeps loose elements; else the loss of the elements names them all.
pub(crate) fn losses_in(mesh: &PolygonMesh, written: &[&Layer], domains: &[Domain]) -> Vec<Loss> {
    let mut addresses: Vec<*const Layer> = written.iter().map(|&layer| std::ptr::from_ref(layer)).collect();
    addresses.sort_unstable();
    let is_written = |layer: &&Layer| addresses.binary_search(&std::ptr::from_ref(*layer)).is_ok();
    let of_domains = mesh.layers().iter().filter(|layer| domains.contains(&layer.domain()));
    let left_out = of_domains.filter(|layer| !is_written(layer));
    left_out.filter_map(|layer| layer_loss(layer, layer.element_count() - absent(layer))).collect()
}

fn layer_loss(layer: &Layer, count: usize) -> Option<Loss> {
    let (domain, name) = (layer.domain().name(), layer.name());
    let of_elements = Loss::if_any(LossKind::Layer, count, |count| {
        format!("{domain} attribute `{name}` of {}", counted(count, domain))
    });
    of_elements.or_else(|| unused_layer_loss(layer)).map(|loss| loss.of_layer(layer))
}

/// The loss of values that no element uses, in a format that stores values with elements.
fn unused_layer_loss(layer: &Layer) -> Option<Loss> {
    let (domain, name) = (layer.domain().name(), layer.name());
    // The loss of loose elements names these.
    let is_of_loose = matches!(layer.domain(), Domain::LooseEdge | Domain::LoosePoint);
    let is_unused = !is_of_loose && absent(layer) == layer.element_count();
    let values = if is_unused { layer.value_count() } else { 0 };
    Loss::if_any(LossKind::Layer, values, |count| {
        format!("{} of the {domain} attribute `{name}`, which no {domain} uses", counted(count, "value"))
    })
}

/// `vertices`, `corners`, `faces`, `loose edges` or `loose points`.
pub(crate) fn elements(layer: &Layer) -> &'static str {
    match layer.domain() {
        Domain::Vertex => "vertices",
        Domain::Corner => "corners",
        Domain::Face => "faces",
        Domain::LooseEdge => "loose edges",
        Domain::LoosePoint => "loose points",
    }
}

/// The loss of all loose edges and points.
pub(crate) fn loose_losses(mesh: &PolygonMesh) -> Vec<Loss> {
    let edges = Loss::if_any(LossKind::LooseEdges, mesh.loose_edges().len(), |n| counted(n, "loose edge"));
    edges.into_iter().chain(point_loss(mesh)).collect()
}

/// The loss of all loose points.
pub(crate) fn point_loss(mesh: &PolygonMesh) -> Option<Loss> {
    Loss::if_any(LossKind::LoosePoints, mesh.loose_points().len(), |n| counted(n, "loose point"))
}
