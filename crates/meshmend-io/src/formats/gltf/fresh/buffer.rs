//! The bytes of the buffer of a file.

use std::io;
use std::ops::Range;

use meshmend_core::{Id, Values, VertexId};

use super::accessors::{Content, File, View};
use super::attributes::{Attribute, Kind};
use super::normals::normals_of_faces;
use super::plan::Elements;
use crate::output::sink::Sink;

/// Writes the bytes of all views, each up to a multiple of four.
pub(super) fn write(file: &File<'_>, out: &mut dyn io::Write) -> io::Result<()> {
    let mut sink = Sink::new(out);
    let lacks_normal = |attribute: &Attribute<'_>| {
        let mut vertices = 0..file.mesh.counts().vertices;
        attribute.kind == Kind::Normal && vertices.any(|vertex| !attribute.has(vertex))
    };
    let normals = file.attributes.iter().any(lacks_normal).then(|| normals_of_faces(file.mesh));
    for view in &file.views {
        match &view.content {
            Content::Positions(vertices) => positions(file, vertices.clone(), &mut sink)?,
            Content::Values { attribute, vertices } => {
                let attribute = &file.attributes[*attribute];
                for vertex in vertices.clone() {
                    value(attribute, vertex, normals.as_deref(), &mut sink);
                    sink.checkpoint()?;
                }
            }
            Content::Picture(bytes) => sink.bytes(bytes),
            Content::Indices { elements, first } => indices(file, view, elements, *first, &mut sink)?,
        }
        let length = view.length();
        (length..length.next_multiple_of(4)).for_each(|_| sink.byte(0));
    }
    sink.finish()
}

fn positions(file: &File<'_>, vertices: Range<usize>, sink: &mut Sink<'_>) -> io::Result<()> {
    for position in &file.mesh.positions()[vertices] {
        position.iter().for_each(|&x| sink.bytes(&(x as f32).to_le_bytes()));
        sink.checkpoint()?;
    }
    Ok(())
}

/// Writes the value of a vertex, or one that stands for none: white, zeros, or the normal of a face.
fn value(attribute: &Attribute<'_>, vertex: usize, normals: Option<&[[f32; 3]]>, sink: &mut Sink<'_>) {
    let width = attribute.layer.width();
    let places = attribute.layer.value_of(vertex).map(|value| value * width..(value + 1) * width);
    match places.filter(|_| attribute.has(vertex)) {
        Some(places) => numbers(attribute.layer.values(), places, sink),
        None => {
            let normal = normals.map(|normals| normals[vertex]);
            (0..width).for_each(|axis| substitute(attribute, normal, axis, sink));
        }
    }
    (0..attribute.padding()).for_each(|_| sink.byte(0));
}

fn numbers(values: &Values, places: Range<usize>, sink: &mut Sink<'_>) {
    match values {
        Values::I8(v) => v[places].iter().for_each(|x| sink.bytes(&x.to_le_bytes())),
        Values::U8(v) => sink.bytes(&v[places]),
        Values::I16(v) => v[places].iter().for_each(|x| sink.bytes(&x.to_le_bytes())),
        Values::U16(v) => v[places].iter().for_each(|x| sink.bytes(&x.to_le_bytes())),
        Values::F32(v) => v[places].iter().for_each(|x| sink.bytes(&x.to_le_bytes())),
        // Values of other types were converted.
        _ => places.for_each(|_| sink.bytes(&[0; 4])),
    }
}

fn substitute(attribute: &Attribute<'_>, normal: Option<[f32; 3]>, axis: usize, sink: &mut Sink<'_>) {
    let is_color = matches!(attribute.kind, Kind::Color(_));
    match attribute.layer.values() {
        Values::I8(_) | Values::U8(_) => sink.byte(if is_color { u8::MAX } else { 0 }),
        Values::I16(_) | Values::U16(_) => sink.bytes(&if is_color { [u8::MAX; 2] } else { [0; 2] }),
        _ => {
            let x = match (attribute.kind, normal) {
                (Kind::Normal, Some(normal)) => normal[axis],
                (Kind::Tangent, _) if matches!(axis, 0 | 3) => 1.0,
                (Kind::Color(_), _) => 1.0,
                _ => 0.0_f32,
            };
            sink.bytes(&x.to_le_bytes());
        }
    }
}

fn indices(
    file: &File<'_>,
    view: &View,
    elements: &Elements,
    first: usize,
    sink: &mut Sink<'_>,
) -> io::Result<()> {
    let (edges, points);
    let vertices: &[VertexId] = match elements {
        Elements::Faces(faces) => &file.mesh.faces().corner_vertices()[faces.start * 3..faces.end * 3],
        Elements::LooseEdges => {
            edges = file.mesh.loose_edges().as_flattened();
            edges
        }
        Elements::LoosePoints => {
            points = file.mesh.loose_points();
            points
        }
        Elements::Vertices => &[],
    };
    for vertex in vertices {
        let index = (vertex.index() - first) as u32;
        if view.stride == 4 {
            sink.bytes(&index.to_le_bytes());
        } else {
            sink.bytes(&(index as u16).to_le_bytes());
        }
        sink.checkpoint()?;
    }
    Ok(())
}
