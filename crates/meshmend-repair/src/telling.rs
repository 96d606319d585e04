//! What tells a face from another one over the same vertices: a material, an object, a colour, texture coordinates.
//!
//! A face that repeats another one is rubbish, unless it looks different or belongs to something else. Layers are compared
//! by the bits of their values, whatever pools these are in. A mesh without layers that count costs no time.

use meshmend_core::{
    Aspect, CornerId, Differences, Domain, FaceId, Id, Layer, PolygonMesh, Values, VertexId,
};

/// Which layers of a mesh tell its faces apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TellingLayers<'a> {
    /// All that [`Aspect::of_layer`] knows.
    #[default]
    All,
    /// Those of them for which the list says `true`, by their place in the mesh. A layer beyond its end is left out.
    Only(&'a [bool]),
}

impl TellingLayers<'_> {
    fn hold(&self, layer: usize) -> bool {
        match self {
            TellingLayers::All => true,
            TellingLayers::Only(layers) => layers.get(layer) == Some(&true),
        }
    }
}

/// The corners of a face, each with its vertex.
pub(crate) type FaceCorners = Vec<(VertexId, CornerId)>;

/// A face with its corners, as it is compared.
pub(crate) struct Looks {
    face: FaceId,
    corners: FaceCorners,
}

impl Looks {
    /// Faces that are compared have the same vertices, in whichever direction they run.
    pub(crate) fn new(face: FaceId, mut corners: FaceCorners) -> Self {
        corners.sort_unstable();
        Looks { face, corners }
    }
}

/// The layers of a mesh that tell its faces apart.
pub(crate) struct Telling<'a> {
    layers: Vec<(Aspect, &'a Layer)>,
}

impl<'a> Telling<'a> {
    /// Returns `None` if there are none. Layers of vertices are left out: faces that are compared have the same vertices.
    pub(crate) fn of(mesh: &'a PolygonMesh, telling: TellingLayers<'_>) -> Option<Self> {
        let layers = mesh
            .layers()
            .iter()
            .enumerate()
            .filter(|(place, layer)| telling.hold(*place) && layer.domain() != Domain::Vertex);
        let layers: Vec<_> =
            layers.filter_map(|(_, layer)| Some((Aspect::of_layer(layer)?, layer))).collect();
        (!layers.is_empty()).then_some(Telling { layers })
    }

    /// For each of some faces over the same vertices, the place of the first one from which it does not differ.
    ///
    /// *Cost*: O(n log n) comparisons of what the faces have in the layers.
    pub(crate) fn first_alike(&self, faces: &[Looks]) -> Vec<usize> {
        let values: Vec<Vec<u8>> = faces.iter().map(|face| self.values_of(face)).collect();
        let mut order: Vec<usize> = (0..faces.len()).collect();
        order.sort_unstable_by_key(|&place| (&values[place], place));
        let mut first = vec![0; faces.len()];
        for alike in order.chunk_by(|&one, &other| values[one] == values[other]) {
            alike.iter().for_each(|&place| first[place] = alike[0]);
        }
        first
    }

    /// In what two faces over the same vertices differ.
    pub(crate) fn differences(&self, one: &Looks, other: &Looks) -> Differences {
        let value = |layer: &Layer, face: &Looks| {
            let mut bytes = Vec::new();
            push_values(layer, face, &mut bytes);
            bytes
        };
        let differing = self.layers.iter().filter(|(_, layer)| value(layer, one) != value(layer, other));
        differing.map(|&(aspect, _)| aspect).collect()
    }

    fn values_of(&self, face: &Looks) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.layers.iter().for_each(|(_, layer)| push_values(layer, face, &mut bytes));
        bytes
    }
}

/// What a face has in a layer, as bytes that are equal only for equal values.
fn push_values(layer: &Layer, face: &Looks, bytes: &mut Vec<u8>) {
    match layer.domain() {
        Domain::Face => push_value(layer, face.face.index(), bytes),
        Domain::Corner => {
            face.corners.iter().for_each(|(_, corner)| push_value(layer, corner.index(), bytes));
        }
        _ => {}
    }
}

fn push_value(layer: &Layer, element: usize, bytes: &mut Vec<u8>) {
    let value = layer.value_of(element);
    bytes.push(u8::from(value.is_some()));
    if let Some(value) = value {
        push_entries(layer.values(), value * layer.width()..(value + 1) * layer.width(), bytes);
    }
}

fn push_entries(values: &Values, range: std::ops::Range<usize>, bytes: &mut Vec<u8>) {
    match values {
        Values::I8(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::U8(v) => bytes.extend(&v[range]),
        Values::I16(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::U16(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::I32(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::U32(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::F32(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::F64(v) => v[range].iter().for_each(|x| bytes.extend(x.to_ne_bytes())),
        Values::Text(v) => v[range].iter().for_each(|text| {
            bytes.extend(text.len().to_ne_bytes());
            bytes.extend(text);
        }),
        Values::Lists { starts, items } => range.for_each(|list| {
            let items_of = starts[list] as usize..starts[list + 1] as usize;
            bytes.extend(items_of.len().to_ne_bytes());
            push_entries(items, items_of, bytes);
        }),
    }
}
