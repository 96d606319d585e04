//! What readers and writers ask about attribute layers.

use meshmend_core::{Domain, Layer, PolygonMesh, Values};

/// Whether the values of a layer are numbers, not names or lists.
pub(crate) fn is_numeric(layer: &Layer) -> bool {
    !matches!(layer.values(), Values::Text(_) | Values::Lists { .. })
}

/// Whether the values of a layer are floating-point numbers.
pub(crate) fn has_fractions(layer: &Layer) -> bool {
    matches!(layer.values(), Values::F32(_) | Values::F64(_))
}

/// The first layer of a name and domain that meets a condition.
pub(crate) fn layer_of<'a>(
    mesh: &'a PolygonMesh,
    name: &str,
    domain: Domain,
    is_fit: impl Fn(&Layer) -> bool,
) -> Option<&'a Layer> {
    mesh.layers().iter().find(|layer| layer.name() == name && layer.domain() == domain && is_fit(layer))
}

/// A number of a pool; NaN if the pool holds names or lists.
#[inline]
pub(crate) fn number(values: &Values, at: usize) -> f64 {
    match values {
        Values::I8(v) => f64::from(v[at]),
        Values::U8(v) => f64::from(v[at]),
        Values::I16(v) => f64::from(v[at]),
        Values::U16(v) => f64::from(v[at]),
        Values::I32(v) => f64::from(v[at]),
        Values::U32(v) => f64::from(v[at]),
        Values::F32(v) => f64::from(v[at]),
        Values::F64(v) => v[at],
        Values::Text(_) | Values::Lists { .. } => f64::NAN,
    }
}
