//! Colours in the two bytes that end each facet of a binary file.
//!
//! Two conventions are in use, and they contradict each other:
//!
//! | | bit 15 | bits 14 to 10 | bits 9 to 5 | bits 4 to 0 | all others have |
//! |---|---|---|---|---|---|
//! | Materialise Magics | 0: a colour of its own | blue | green | red | that of the header: `COLOR=` and four bytes |
//! | VisCAM, SolidView | 1: a colour of its own | red | green | blue | none |
//!
//! A header with `COLOR=` shows the first. There is no sign of the second, so colours are read only on request.

use meshmend_core::{Carry, Domain, FaceId, Layer, MeshError, NO_VALUE, PolygonMesh, Role, Values};

use crate::formats::stl::form::{ATTRIBUTE, HEADER};
use crate::input::notes::Notes;
use crate::layers::layer_of;
use crate::{NoteKind, Place};

/// The elements that get the colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorElements {
    /// The faces.
    Faces,
    /// The vertices. In a mesh as read from STL, each vertex belongs to one face. A vertex of several faces gets the
    /// colour of the last of them.
    Vertices,
}

/// The convention that a file follows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Convention {
    /// That of Materialise Magics, with the colour of the whole mesh.
    Magics([u8; 3]),
    VisCam,
}

const OWN_OR_NOT: u16 = 1 << 15;

impl Convention {
    fn of(header: &[u8]) -> Self {
        const SIGN: &[u8] = b"COLOR=";
        let sign = header.windows(SIGN.len()).position(|bytes| bytes == SIGN);
        match sign.and_then(|at| header.get(at + SIGN.len()..at + SIGN.len() + 3)) {
            Some(&[red, green, blue]) => Convention::Magics([red, green, blue]),
            _ => Convention::VisCam,
        }
    }

    /// The colour of an attribute, if it has one.
    fn color(self, attribute: u16) -> Option<[u8; 3]> {
        let is_set = attribute & OWN_OR_NOT != 0;
        let [low, middle, high] = [0, 5, 10].map(|bits| in_bytes(attribute >> bits & 31));
        match self {
            Convention::Magics(whole) => Some(if is_set { whole } else { [low, middle, high] }),
            Convention::VisCam => is_set.then_some([high, middle, low]),
        }
    }
}

/// The byte nearest to a fraction of 31.
fn in_bytes(part: u16) -> u8 {
    ((part * 255 + 15) / 31) as u8
}

/// How many facets may be coloured.
#[derive(Default)]
pub(super) struct Colored {
    /// The facets up to the last one whose attribute is not 0.
    up_to_last: u64,
    /// Those with the bit that says whether they have a colour of their own.
    with_bit: u64,
}

impl Colored {
    #[inline]
    pub(super) fn see(&mut self, face: usize, attribute: u16) {
        if attribute != 0 {
            self.up_to_last = face as u64 + 1;
            self.with_bit += u64::from(attribute & OWN_OR_NOT != 0);
        }
    }

    /// Notes attributes that are colours, or may be colours.
    pub(super) fn note(&self, header: &[u8], notes: &mut Notes) {
        let (message, count) = match Convention::of(header) {
            Convention::Magics(_) => (
                "attribute bytes that are colours, as the header says in the way of Materialise Magics",
                self.up_to_last,
            ),
            Convention::VisCam => {
                ("attribute bytes that are colours perhaps, in the way of VisCAM", self.with_bit)
            }
        };
        notes.add_many(NoteKind::PerhapsColors, message, count, || Place::File);
    }
}

/// A mesh in which the attribute bytes of facets, as binary STL has them, have become colours. A mesh without such
/// attributes is returned as it is.
///
/// A header with `COLOR=` says that they follow Materialise Magics; else they are taken for those of VisCAM. Facets
/// without a colour of their own have that of the header, or none.
///
/// # Errors
/// If the mesh can't hold the layer.
///
/// *Cost*: linear.
pub fn decode_stl_colors(mesh: &PolygonMesh, elements: ColorElements) -> Result<PolygonMesh, MeshError> {
    let is_fit = |layer: &Layer| matches!(layer.values(), Values::U16(_)) && layer.width() == 1;
    let Some(layer) = layer_of(mesh, ATTRIBUTE, Domain::Face, is_fit) else { return Ok(mesh.clone()) };
    let Values::U16(attributes) = layer.values() else { return Ok(mesh.clone()) };
    let header = mesh.metadata().iter().find(|statement| statement.key == HEADER);
    let convention = Convention::of(header.map_or(&[], |header| &header.value));
    let colors: Vec<Option<[u8; 3]>> =
        attributes.iter().map(|&attribute| convention.color(attribute)).collect();
    let color_of = |face: FaceId| layer.value_of(face.0 as usize).and_then(|value| colors[value]);
    let faces = mesh.faces();
    let (domain, of_elements) = match elements {
        ColorElements::Faces => (Domain::Face, faces.faces().map(color_of).collect()),
        ColorElements::Vertices => {
            let mut of_vertices = vec![None; mesh.counts().vertices];
            for face in faces.faces() {
                let color = color_of(face);
                faces.face_vertices(face).iter().for_each(|vertex| of_vertices[vertex.0 as usize] = color);
            }
            (Domain::Vertex, of_vertices)
        }
    };
    let decoded = color_layer(domain, &of_elements);
    let others = mesh.layers().iter().filter(|other| !std::ptr::eq(*other, layer)).cloned();
    mesh.clone().with_layers(others.chain([decoded]).collect())
}

fn color_layer(domain: Domain, colors: &[Option<[u8; 3]>]) -> Layer {
    let (mut values, mut uses) = (Vec::new(), Vec::with_capacity(colors.len()));
    for color in colors {
        uses.push(color.map_or(NO_VALUE, |_| (values.len() / 3) as u32));
        values.extend(color.iter().flatten());
    }
    Layer::indexed("color", domain, 3, Carry::Copy, Values::U8(values), uses).with_role(Role::Color)
}
