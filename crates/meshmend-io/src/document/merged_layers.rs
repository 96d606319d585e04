//! The layers of several meshes that become one.

use std::collections::BTreeMap;

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, PolygonMesh, Role, Values};

use crate::document::Placement;
use crate::layers::is_numeric;

/// Layers that are put together. Those of one name, domain, width, type and meaning are one.
#[derive(Default)]
pub(super) struct MergedLayers {
    layers: Vec<Merged>,
    /// Where the layer of a name, of elements, a meaning and a type is.
    places: BTreeMap<Key, usize>,
}

/// What tells layers apart: the name; elements, those where it is at home, width; meaning; whether whole numbers stand for
/// fractions; type.
type Key = (String, (Domain, Domain, usize), Role, bool, Vec<u8>);

/// Where the elements of a mesh go.
pub(super) struct Elements<'a> {
    /// How many elements there are before them.
    pub(super) before: &'a dyn Fn(Domain) -> usize,
    /// The old corner of each corner, if their order changes.
    pub(super) corners: Option<&'a [u32]>,
}

struct Merged {
    /// A layer whose name, type and meaning the elements' values have. It has no value itself.
    model: Layer,
    values: Values,
    uses: Vec<u32>,
}

impl MergedLayers {
    /// Takes in the layers of a mesh that is placed somewhere, and the place's name as that of an object.
    pub(super) fn add(&mut self, mesh: &PolygonMesh, placement: &Placement, elements: &Elements<'_>) {
        for layer in mesh.layers().iter().filter(|layer| goes_along(layer.role())) {
            let values = moved_values(layer, placement);
            let order = elements.corners.filter(|_| layer.domain() == Domain::Corner);
            let uses: Vec<u32> = (0..layer.element_count())
                .map(|at| order.map_or(at, |order| order[at] as usize))
                .map(|at| layer.value_of(at).map_or(NO_VALUE, |value| value as u32))
                .collect();
            let before = (elements.before)(layer.domain());
            self.layer(layer, &values).take(before, &values, &uses);
        }
        let has_objects = mesh.layer("object", Domain::Face).is_some();
        if !placement.name.is_empty() && !has_objects {
            let name = Values::Text(vec![placement.name.clone()]);
            let layer = Layer::indexed("object", Domain::Face, 1, Carry::Copy, name.clone(), Vec::new());
            let uses = vec![0; mesh.faces().face_count()];
            self.layer(&layer, &name).take((elements.before)(Domain::Face), &name, &uses);
        }
    }

    /// The layer into which a layer with values of this type goes.
    fn layer(&mut self, like: &Layer, values: &Values) -> &mut Merged {
        let place = (like.domain(), like.home(), like.width());
        let key = (like.name().to_owned(), place, like.role(), like.is_normalized(), type_of(values));
        let next = self.layers.len();
        let at = *self.places.entry(key).or_insert(next);
        if at == next {
            let (model, values) = (like.clone(), emptied(values));
            self.layers.push(Merged { model, values, uses: Vec::new() });
        }
        &mut self.layers[at]
    }

    /// The layers, for so many elements.
    pub(super) fn finish(self, count: impl Fn(Domain) -> usize) -> Vec<Layer> {
        let layer = |Merged { model, values, mut uses }: Merged| {
            uses.resize(count(model.domain()), NO_VALUE);
            let layer =
                Layer::indexed(model.name(), model.domain(), model.width(), model.carry(), values, uses)
                    .with_role(model.role())
                    .with_normalized(model.is_normalized());
            match (model.domain(), model.home()) {
                (Domain::Corner, Domain::Vertex) => layer.at_home_on_vertices(count(Domain::Vertex)),
                _ => layer,
            }
        };
        self.layers.into_iter().map(layer).collect()
    }
}

impl Merged {
    /// Takes in values, and the uses of elements that come after so many others.
    fn take(&mut self, before: usize, values: &Values, uses: &[u32]) {
        let first = (self.values.len() / self.model.width()) as u32;
        append(&mut self.values, values);
        self.uses.resize(before, NO_VALUE);
        self.uses.extend(uses.iter().map(|&at| if at == NO_VALUE { NO_VALUE } else { at + first }));
    }
}

/// Whether values of a role mean the same in one mesh of all parts.
fn goes_along(role: Role) -> bool {
    matches!(role, Role::Plain | Role::Normal | Role::Tangent | Role::TexCoord | Role::Color)
}

/// The values of a layer where its mesh is placed: directions move with it.
fn moved_values(layer: &Layer, placement: &Placement) -> Values {
    let is_direction = matches!(layer.role(), Role::Normal | Role::Tangent);
    if !is_direction || placement.matrix == Placement::STILL || layer.width() < 3 || !is_numeric(layer) {
        return layer.values().clone();
    }
    let step = layer.values().largest().unwrap_or(1.0);
    let width = layer.width();
    let number = |at: usize| layer.values().number(at).unwrap_or(f64::NAN) / step;
    let mut moved = Vec::with_capacity(layer.values().len());
    for at in (0..layer.value_count()).map(|value| value * width) {
        let old = [number(at), number(at + 1), number(at + 2)];
        let new = match layer.role() {
            Role::Normal => placement.moved_normal(old),
            _ => placement.moved_direction(old),
        };
        let length = new.map(|x| x * x).iter().sum::<f64>().sqrt();
        moved.extend(if length > 0.0 { new.map(|x| x / length) } else { old });
        moved.extend((3..width).map(|place| number(at + place) * placement.handedness()));
    }
    match layer.values() {
        Values::F64(_) => Values::F64(moved),
        _ => Values::F32(moved.into_iter().map(|x| x as f32).collect()),
    }
}

/// The types of values: lists are told by those of their items.
fn type_of(values: &Values) -> Vec<u8> {
    let tag = match values {
        Values::I8(_) => 0,
        Values::U8(_) => 1,
        Values::I16(_) => 2,
        Values::U16(_) => 3,
        Values::I32(_) => 4,
        Values::U32(_) => 5,
        Values::F32(_) => 6,
        Values::F64(_) => 7,
        Values::Text(_) => 8,
        Values::Lists { items, .. } => return [vec![9], type_of(items)].concat(),
    };
    vec![tag]
}

/// No values, of the type of others.
fn emptied(values: &Values) -> Values {
    match values {
        Values::I8(_) => Values::I8(Vec::new()),
        Values::U8(_) => Values::U8(Vec::new()),
        Values::I16(_) => Values::I16(Vec::new()),
        Values::U16(_) => Values::U16(Vec::new()),
        Values::I32(_) => Values::I32(Vec::new()),
        Values::U32(_) => Values::U32(Vec::new()),
        Values::F32(_) => Values::F32(Vec::new()),
        Values::F64(_) => Values::F64(Vec::new()),
        Values::Text(_) => Values::Text(Vec::new()),
        Values::Lists { items, .. } => Values::Lists { starts: vec![0], items: Box::new(emptied(items)) },
    }
}

/// Appends values of the same type.
fn append(to: &mut Values, values: &Values) {
    match (to, values) {
        (Values::I8(to), Values::I8(values)) => to.extend_from_slice(values),
        (Values::U8(to), Values::U8(values)) => to.extend_from_slice(values),
        (Values::I16(to), Values::I16(values)) => to.extend_from_slice(values),
        (Values::U16(to), Values::U16(values)) => to.extend_from_slice(values),
        (Values::I32(to), Values::I32(values)) => to.extend_from_slice(values),
        (Values::U32(to), Values::U32(values)) => to.extend_from_slice(values),
        (Values::F32(to), Values::F32(values)) => to.extend_from_slice(values),
        (Values::F64(to), Values::F64(values)) => to.extend_from_slice(values),
        (Values::Text(to), Values::Text(values)) => to.extend_from_slice(values),
        (Values::Lists { starts, items }, Values::Lists { starts: more, items: values }) => {
            let first = items.len() as u32;
            starts.extend(more.iter().skip(1).map(|start| start + first));
            append(items, values);
        }
        _ => {}
    }
}
