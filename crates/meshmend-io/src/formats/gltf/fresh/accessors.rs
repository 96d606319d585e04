//! What lies where in the buffer of a file.

use std::ops::Range;
use std::sync::Arc;

use meshmend_core::{PolygonMesh, Values};

use super::attributes::{Attribute, Kind, attributes};
use super::json;
use super::looks::pictures;
use super::objects::FaceNames;
use super::plan::{Elements, Object, objects};
use crate::{Picture, Prepared};

/// A file: its objects, its attributes, and what its buffer holds.
pub(super) struct File<'a> {
    pub(super) mesh: &'a PolygonMesh,
    pub(super) names: FaceNames<'a>,
    pub(super) attributes: Vec<Attribute<'a>>,
    pub(super) objects: Vec<PlacedObject<'a>>,
    pub(super) views: Vec<View>,
    /// How many of the views are described by accessors.
    pub(super) accessors: usize,
    /// The length of the buffer.
    pub(super) length: u64,
}

/// An object with the places of its views.
pub(super) struct PlacedObject<'a> {
    pub(super) object: Object<'a>,
    pub(super) positions: usize,
    /// The attributes that its vertices have, by their places among those of the file, with their views.
    pub(super) attributes: Vec<(usize, usize)>,
    /// The views of the indices of its primitives.
    pub(super) indices: Vec<Option<usize>>,
}

impl PlacedObject<'_> {
    /// Whether its vertices have an attribute of the file. Those that they have stand in order.
    pub(super) fn has_attribute(&self, attribute: usize) -> bool {
        self.attributes.binary_search_by_key(&attribute, |&(at, _)| at).is_ok()
    }
}

/// A part of the buffer, which one accessor describes.
pub(super) struct View {
    pub(super) content: Content,
    pub(super) offset: u64,
    /// How many elements it has, and how many bytes lie between the starts of two of them.
    pub(super) count: usize,
    pub(super) stride: usize,
}

pub(super) enum Content {
    Positions(Range<usize>),
    /// The values of an attribute, by its place among those of the file.
    Values {
        attribute: usize,
        vertices: Range<usize>,
    },
    /// Indices from the first vertex of an object on.
    Indices {
        elements: Elements,
        first: usize,
    },
    /// The bytes of a picture, which no accessor describes. Pictures come last.
    Picture(Arc<[u8]>),
}

/// The most vertices that indices of 16 bits can tell apart. The largest number of a type is not an index.
const MOST_NARROW: usize = 65_535;

impl<'a> File<'a> {
    /// The file of a mesh that was made ready.
    ///
    /// *Cost*: linear in the faces and the vertices.
    pub(super) fn of(prepared: &'a Prepared) -> Self {
        let mesh = &prepared.mesh;
        let (names, attributes) = (FaceNames::of(mesh), attributes(mesh));
        let objects = objects(mesh, &names);
        let mut file =
            File { mesh, names, attributes, objects: Vec::new(), views: Vec::new(), accessors: 0, length: 0 };
        for object in objects {
            let placed = file.place(object);
            file.objects.push(placed);
        }
        file.accessors = file.views.len();
        for picture in pictures(&prepared.materials()) {
            if let Picture::Embedded { bytes, .. } = picture {
                file.push(Content::Picture(bytes.clone()), bytes.len(), 1);
            }
        }
        file
    }

    fn place(&mut self, object: Object<'a>) -> PlacedObject<'a> {
        let vertices = object.vertices.clone();
        let positions = self.push(Content::Positions(vertices.clone()), vertices.len(), 12);
        let has_value = |attribute: &Attribute<'_>| vertices.clone().any(|vertex| attribute.has(vertex));
        let held: Vec<usize> =
            (0..self.attributes.len()).filter(|&at| has_value(&self.attributes[at])).collect();
        let placed = held.into_iter().map(|attribute| {
            let stride = self.attributes[attribute].stride();
            let content = Content::Values { attribute, vertices: vertices.clone() };
            (attribute, self.push(content, vertices.len(), stride))
        });
        let attributes = placed.collect();
        let size = if vertices.len() > MOST_NARROW { 4 } else { 2 };
        let indices = object.primitives.iter().map(|primitive| {
            let count = match &primitive.elements {
                Elements::Faces(faces) => faces.len() * 3,
                Elements::LooseEdges => self.mesh.loose_edges().len() * 2,
                Elements::LoosePoints => self.mesh.loose_points().len(),
                Elements::Vertices => return None,
            };
            let content = Content::Indices { elements: primitive.elements.clone(), first: vertices.start };
            Some(self.push(content, count, size))
        });
        let indices = indices.collect();
        PlacedObject { object, positions, attributes, indices }
    }

    fn push(&mut self, content: Content, count: usize, stride: usize) -> usize {
        let view = View { content, offset: self.length, count, stride };
        self.length += view.length().next_multiple_of(4);
        self.views.push(view);
        self.views.len() - 1
    }

    /// How an accessor describes a view.
    pub(super) fn accessor(&self, at: usize) -> json::Accessor {
        let view = &self.views[at];
        let plain = json::Accessor {
            buffer_view: at,
            component_type: FLOAT,
            normalized: false,
            count: view.count,
            kind: "VEC3",
            min: None,
            max: None,
        };
        match &view.content {
            Content::Positions(vertices) => {
                let [min, max] = bounds(&self.mesh.positions()[vertices.clone()]);
                json::Accessor { min: Some(min), max: Some(max), ..plain }
            }
            Content::Values { attribute, .. } => {
                let attribute = &self.attributes[*attribute];
                let kind = ["SCALAR", "VEC2", "VEC3", "VEC4"][attribute.layer.width().clamp(1, 4) - 1];
                let component_type = component(attribute.layer.values()).0;
                json::Accessor { component_type, normalized: attribute.is_normalized(), kind, ..plain }
            }
            Content::Indices { .. } => {
                let component_type = if view.stride == 4 { UNSIGNED_INT } else { UNSIGNED_SHORT };
                json::Accessor { component_type, kind: "SCALAR", ..plain }
            }
            Content::Picture(_) => plain,
        }
    }

    pub(super) fn buffer_view(&self, view: &View) -> json::BufferView {
        let (target, is_padded) = match &view.content {
            Content::Positions(_) => (Some(ARRAY_BUFFER), false),
            Content::Values { attribute, .. } => {
                (Some(ARRAY_BUFFER), self.attributes[*attribute].padding() > 0)
            }
            Content::Indices { .. } => (Some(ELEMENT_ARRAY_BUFFER), false),
            Content::Picture(_) => (None, false),
        };
        json::BufferView {
            buffer: 0,
            byte_offset: view.offset,
            byte_length: view.length(),
            byte_stride: is_padded.then_some(view.stride),
            target,
        }
    }
}

impl View {
    pub(super) fn length(&self) -> u64 {
        self.count as u64 * self.stride as u64
    }
}

impl Attribute<'_> {
    /// Whether a vertex has a value. A normal of zeros is none.
    pub(super) fn has(&self, vertex: usize) -> bool {
        let Some(value) = self.layer.value_of(vertex) else { return false };
        match (self.kind, self.layer.values()) {
            (Kind::Normal, Values::F32(values)) => values[value * 3..value * 3 + 3] != [0.0; 3],
            _ => true,
        }
    }

    fn is_normalized(&self) -> bool {
        let is_color = matches!(self.kind, Kind::Color(_));
        !matches!(self.layer.values(), Values::F32(_)) && (is_color || self.layer.is_normalized())
    }

    fn size(&self) -> usize {
        self.layer.width() * component(self.layer.values()).1
    }

    fn stride(&self) -> usize {
        self.size().next_multiple_of(4)
    }

    /// How many bytes follow a value, as values begin at multiples of four bytes.
    pub(super) fn padding(&self) -> usize {
        self.stride() - self.size()
    }
}

const FLOAT: u16 = 5126;
const UNSIGNED_SHORT: u16 = 5123;
const UNSIGNED_INT: u16 = 5125;
const ARRAY_BUFFER: u16 = 34962;
const ELEMENT_ARRAY_BUFFER: u16 = 34963;

/// The number of a type in the format, and its size.
fn component(values: &Values) -> (u16, usize) {
    match values {
        Values::I8(_) => (5120, 1),
        Values::U8(_) => (5121, 1),
        Values::I16(_) => (5122, 2),
        Values::U16(_) => (UNSIGNED_SHORT, 2),
        _ => (FLOAT, 4),
    }
}

fn bounds(points: &[[f64; 3]]) -> [[f32; 3]; 2] {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points {
        for axis in 0..3 {
            min[axis] = min[axis].min(point[axis]);
            max[axis] = max[axis].max(point[axis]);
        }
    }
    [min, max].map(|corner| corner.map(|x| x as f32))
}
