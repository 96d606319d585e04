//! The text of a new model.

use std::borrow::Cow;
use std::io;

use meshmend_core::{Id, PolygonMesh};

use super::objects::{Materials, NewObject, Objects};
use crate::formats::threemf::model::color_text;
use crate::formats::threemf::xml::escaped;
use crate::output::sink::Sink;
use crate::{Material, Prepared};

const HEAD: &[u8] = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <model unit=\"millimeter\" xml:lang=\"en-US\" \
    xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
    <resources>\n";

/// The id of the group of materials. Those of the objects follow.
const MATERIALS: usize = 1;

/// Writes the text of a model that has this mesh.
///
/// *Cost*: linear.
pub(super) fn write(prepared: &Prepared, out: &mut dyn io::Write) -> io::Result<()> {
    let mesh = prepared.mesh();
    let (mut sink, objects) = (Sink::new(out), Objects::of(mesh));
    sink.bytes(HEAD);
    let materials = Materials::of(mesh, &objects);
    if let Some(materials) = &materials {
        write_materials(&materials.names, &prepared.materials(), &mut sink);
    }
    let mut numbers = vec![0; mesh.counts().vertices];
    for (place, object) in objects.list.iter().enumerate() {
        sink.bytes(b"<object id=\"");
        sink.integer(id(place));
        sink.bytes(b"\" type=\"model\"");
        if !object.name.is_empty() {
            write_name(object.name, &mut sink);
        }
        sink.bytes(b">\n<mesh>\n");
        write_vertices(mesh, object, &mut numbers, &mut sink)?;
        write_triangles(mesh, object, materials.as_ref(), &numbers, &mut sink)?;
        sink.bytes(b"</mesh>\n</object>\n");
    }
    sink.bytes(b"</resources>\n<build>\n");
    for place in 0..objects.list.len() {
        sink.bytes(b"<item objectid=\"");
        sink.integer(id(place));
        sink.bytes(b"\"/>\n");
        sink.checkpoint()?;
    }
    sink.bytes(b"</build>\n</model>\n");
    sink.finish()
}

/// The id of an object by its place among them.
fn id(place: usize) -> i64 {
    (MATERIALS + 1 + place) as i64
}

fn write_materials(names: &[&[u8]], known: &[Material], sink: &mut Sink<'_>) {
    sink.bytes(b"<basematerials id=\"");
    sink.integer(MATERIALS as i64);
    sink.bytes(b"\">\n");
    for name in names {
        sink.bytes(b"<base");
        write_name(name, sink);
        sink.bytes(b" displaycolor=\"");
        let material = known.iter().find(|material| material.name == *name);
        sink.bytes(color_text(material).as_bytes());
        sink.bytes(b"\"/>\n");
    }
    sink.bytes(b"</basematerials>\n");
}

fn write_name(name: &[u8], sink: &mut Sink<'_>) {
    sink.bytes(b" name=\"");
    sink.bytes(escaped(&spelled(name).text).as_bytes());
    sink.byte(b'"');
}

/// A name as XML can spell it.
pub(super) struct Spelled<'a> {
    pub(super) text: Cow<'a, str>,
    /// Whether it reads back to the same bytes.
    pub(super) is_exact: bool,
}

pub(super) fn spelled(name: &[u8]) -> Spelled<'_> {
    let text = String::from_utf8_lossy(name);
    let is_spelled = |c: char| {
        matches!(c, '\t' | '\n' | '\r') || !(c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'))
    };
    let is_exact = matches!(text, Cow::Borrowed(_)) && text.chars().all(is_spelled);
    Spelled { text, is_exact }
}

/// Writes the vertices of an object, and notes the number that each has there.
fn write_vertices(
    mesh: &PolygonMesh,
    object: &NewObject<'_>,
    numbers: &mut [u32],
    sink: &mut Sink<'_>,
) -> io::Result<()> {
    sink.bytes(b"<vertices>\n");
    for (number, &vertex) in (0..).zip(&object.vertices) {
        numbers[vertex.index()] = number;
        for (name, x) in [&b"<vertex x=\""[..], b"\" y=\"", b"\" z=\""].into_iter().zip(mesh.position(vertex))
        {
            sink.bytes(name);
            sink.real(x);
        }
        sink.bytes(b"\"/>\n");
        sink.checkpoint()?;
    }
    sink.bytes(b"</vertices>\n");
    Ok(())
}

fn write_triangles(
    mesh: &PolygonMesh,
    object: &NewObject<'_>,
    materials: Option<&Materials<'_>>,
    numbers: &[u32],
    sink: &mut Sink<'_>,
) -> io::Result<()> {
    sink.bytes(b"<triangles>\n");
    for &face in &object.faces {
        let corners = mesh.faces().face_vertices(face);
        for (name, vertex) in [&b"<triangle v1=\""[..], b"\" v2=\"", b"\" v3=\""].into_iter().zip(corners) {
            sink.bytes(name);
            sink.integer(numbers[vertex.index()].into());
        }
        if let Some(material) = materials.and_then(|materials| materials.number(face)) {
            sink.bytes(b"\" pid=\"");
            sink.integer(MATERIALS as i64);
            sink.bytes(b"\" p1=\"");
            sink.integer(material.into());
        }
        sink.bytes(b"\"/>\n");
        sink.checkpoint()?;
    }
    sink.bytes(b"</triangles>\n");
    Ok(())
}
