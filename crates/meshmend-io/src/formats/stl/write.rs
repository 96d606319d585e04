//! The STL writer.

use std::io;

use meshmend_core::{Domain, FaceId, Id, Layer, PolygonMesh, Values, VertexId, counted};
use meshmend_geometry::coincident::each_shared_place;

use crate::formats::stl::form::{ATTRIBUTE, HEAD, HEADER, SOLID};
use crate::formats::stl::normals::unit_normal;
use crate::formats::stl::solid_names;
use crate::layers::layer_of;
use crate::output::layer_losses::{absent, absent_loss, layer_losses, loose_losses};
use crate::output::sink::Sink;
use crate::output::statements::metadata_losses;
use crate::text::{one_or_many, trimmed};
use crate::{Encoding, Loss, LossKind, Prepared, WriteErrorKind};

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let mesh = &prepared.mesh;
    let mut sink = Sink::new(out);
    match prepared.encoding {
        Encoding::Ascii => write_text(mesh, &mut sink)?,
        _ => write_binary(mesh, &mut sink)?,
    }
    Ok(sink.finish()?)
}

fn write_binary(mesh: &PolygonMesh, sink: &mut Sink<'_>) -> Result<(), WriteErrorKind> {
    let faces = mesh.faces();
    // A mesh has fewer than 2³¹ corners, and more of them than triangles.
    let count = faces.faces().filter(|&face| triangle(mesh, face).is_some()).count() as u32;
    sink.bytes(&header(mesh));
    sink.bytes(&count.to_le_bytes());
    let attribute = attribute_layer(mesh);
    for face in faces.faces() {
        let attribute = attribute.and_then(|(layer, values)| Some(values[layer.value_of(face.index())?]));
        if let Some([a, b, c]) = triangle(mesh, face) {
            let points = [single(mesh, a), single(mesh, b), single(mesh, c)];
            let normal = unit_normal(points.map(|point| point.map(f64::from))).map(|x| x as f32);
            sink.bytes(&facet(normal, points, attribute.unwrap_or(0)));
        }
        sink.checkpoint()?;
    }
    Ok(())
}

fn facet(normal: [f32; 3], points: [[f32; 3]; 3], attribute: u16) -> [u8; 50] {
    let mut bytes = [0; 50];
    let ([i, j, k], [[a, b, c], [d, e, f], [g, h, l]]) = (normal, points);
    let numbers = [i, j, k, a, b, c, d, e, f, g, h, l];
    for (slot, number) in bytes.chunks_exact_mut(4).zip(numbers) {
        slot.copy_from_slice(&number.to_le_bytes());
    }
    bytes[48..].copy_from_slice(&attribute.to_le_bytes());
    bytes
}

/// The stored header to the byte, or an empty one.
fn header(mesh: &PolygonMesh) -> [u8; HEAD - 4] {
    let stored = mesh.metadata().iter().find(|m| m.key == HEADER).map_or(&[][..], |m| &m.value);
    let mut header = [0; HEAD - 4];
    header.iter_mut().zip(stored).for_each(|(slot, byte)| *slot = *byte);
    header
}

fn write_text(mesh: &PolygonMesh, sink: &mut Sink<'_>) -> Result<(), WriteErrorKind> {
    let objects = object_layer(mesh);
    let single_name = mesh.metadata().iter().find(|m| m.key == SOLID).map_or(&b""[..], |m| &m.value);
    let name_of = |face: FaceId| match objects {
        Some((layer, names)) => layer.value_of(face.index()).map_or(&b""[..], |value| &names[value]),
        None => single_name,
    };
    let mut open: Option<&[u8]> = None;
    for face in mesh.faces().faces().filter(|&f| mesh.faces().corner_range(f).len() > 2) {
        let name = name_of(face);
        if open != Some(name) {
            open.iter().for_each(|open| statement(sink, b"endsolid", open));
            statement(sink, b"solid", name);
            open = Some(name);
        }
        if let Some(triangle) = triangle(mesh, face) {
            text_facet(sink, triangle.map(|v| mesh.position(v)));
        }
        sink.checkpoint()?;
    }
    if open.is_none() {
        statement(sink, b"solid", single_name);
    }
    statement(sink, b"endsolid", open.unwrap_or(single_name));
    Ok(())
}

fn statement(sink: &mut Sink<'_>, word: &[u8], name: &[u8]) {
    sink.bytes(word);
    let name = solid_name(name);
    if !name.is_empty() {
        sink.byte(b' ');
        sink.bytes(&name);
    }
    sink.byte(b'\n');
}

/// A name that is read back as one name: on one line, without the beginning of a facet.
fn solid_name(name: &[u8]) -> Vec<u8> {
    const FACET: &[u8] = b"facet";
    let safe = |b: &u8| if matches!(b, b'\n' | b'\r' | 0) { b' ' } else { *b };
    let line: Vec<u8> = name.iter().map(safe).collect();
    let mut spelled = trimmed(&line).to_vec();
    if solid_names::holds_facet(&spelled) {
        for at in 0..=spelled.len() - FACET.len() {
            if spelled[at..at + FACET.len()].eq_ignore_ascii_case(FACET) {
                spelled[at] = b'_';
            }
        }
    }
    spelled
}

fn text_facet(sink: &mut Sink<'_>, points: [[f64; 3]; 3]) {
    sink.bytes(b"facet normal");
    for number in unit_normal(points) {
        sink.byte(b' ');
        sink.single(number as f32);
    }
    sink.bytes(b"\nouter loop\n");
    for point in points {
        sink.bytes(b"vertex");
        for number in point {
            sink.byte(b' ');
            sink.real(number);
        }
        sink.byte(b'\n');
    }
    sink.bytes(b"endloop\nendfacet\n");
}

/// The vertices of a face, unless it has fewer than three corners.
fn triangle(mesh: &PolygonMesh, face: FaceId) -> Option<[VertexId; 3]> {
    mesh.faces().face_vertices(face).try_into().ok()
}

fn single(mesh: &PolygonMesh, vertex: VertexId) -> [f32; 3] {
    let [x, y, z] = mesh.position(vertex);
    [x as f32, y as f32, z as f32]
}

/// The layer whose numbers are written. Zeros alone would be read as no attributes, so they do not count.
fn attribute_layer(mesh: &PolygonMesh) -> Option<(&Layer, &[u16])> {
    let layer = layer_of(mesh, ATTRIBUTE, Domain::Face, |layer| {
        matches!(layer.values(), Values::U16(_)) && layer.width() == 1
    })?;
    let Values::U16(values) = layer.values() else { return None };
    let is_set = |face| layer.value_of(face).is_some_and(|value| values[value] != 0);
    (0..layer.element_count()).any(is_set).then_some((layer, values))
}

fn object_layer(mesh: &PolygonMesh) -> Option<(&Layer, &[Vec<u8>])> {
    let layer = layer_of(mesh, "object", Domain::Face, |layer| {
        matches!(layer.values(), Values::Text(_)) && layer.width() == 1
    })?;
    if let Values::Text(names) = layer.values() { Some((layer, names)) } else { None }
}

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let (mesh, is_text) = (&prepared.mesh, prepared.encoding == Encoding::Ascii);
    let written =
        if is_text { object_layer(mesh).map(|(l, _)| l) } else { attribute_layer(mesh).map(|(l, _)| l) };
    let mut losses = geometry_losses(prepared);
    losses.extend(layer_losses(mesh, written.as_slice()));
    // A facet without an attribute gets 0.
    losses.extend(written.filter(|_| !is_text).and_then(|layer| absent_loss(layer, absent(layer))));
    losses.extend(loose_losses(mesh));
    let written_keys: &[&str] = match (is_text, written) {
        (false, _) => &[HEADER],
        (true, None) => &[SOLID],
        (true, Some(_)) => &[],
    };
    losses.extend(metadata_losses(mesh, written_keys));
    losses.extend(name_losses(mesh, is_text));
    losses
}

fn name_losses(mesh: &PolygonMesh, is_text: bool) -> Option<Loss> {
    let other = if is_text {
        let names = object_layer(mesh).map_or(&[][..], |(_, names)| names).iter();
        let single = mesh.metadata().iter().filter(|m| m.key == SOLID).map(|m| &m.value);
        names.chain(single).filter(|name| solid_name(name) != ***name).count()
    } else {
        let headers = mesh.metadata().iter().filter(|m| m.key == HEADER);
        headers.filter(|m| m.value.len() > HEAD - 4).count()
    };
    Loss::if_any(LossKind::Names, other, |n| {
        one_or_many(n, "name is spelled differently", "names are spelled differently")
    })
}

fn geometry_losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let faces = mesh.faces();
    let sizes = faces.faces().map(|face| faces.corner_range(face).len());
    let mut uses = vec![0_u32; mesh.counts().vertices];
    let kept = faces.faces().filter(|&face| faces.corner_range(face).len() > 2);
    kept.for_each(|face| faces.face_vertices(face).iter().for_each(|v| uses[v.index()] += 1));
    let unused = uses.iter().filter(|&&uses| uses == 0).count();
    [
        Loss::if_any(LossKind::ShortFaces, sizes.filter(|&n| n < 3).count(), |n| {
            format!("{} of fewer than three corners", counted(n, "face"))
        }),
        Loss::if_any(LossKind::UnusedVertices, unused, |n| {
            format!("{} that no face uses", counted(n, "vertex"))
        }),
        Loss::if_any(LossKind::SharedVertices, parted_vertices(prepared, &uses), |n| {
            let (vertices, those) =
                (counted(n, "vertex"), if n == 1 { "is not the one" } else { "are not those" });
            format!("that {vertices} {those} at the same point: without indices they become one again (repair --apart nudge keeps them apart)")
        }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// How many vertices are at the place of an earlier one, and differ from it by index alone. In a mesh as read from a
/// format without indices, in which each corner has its own vertex, that difference has no meaning. Another loss
/// counts the vertices that rounding joins.
fn parted_vertices(prepared: &Prepared, uses: &[u32]) -> usize {
    let is_without_indices = prepared.options.shell.format().is_some_and(|format| !format.has_indices());
    if is_without_indices && uses.iter().all(|&uses| uses < 2) {
        return 0;
    }
    let mut coincident = 0;
    each_shared_place(
        prepared.mesh.positions(),
        |vertex| uses[vertex] > 0,
        |place| coincident += place.len() - 1,
    );
    let joined = prepared.losses.iter().filter(|loss| loss.kind == LossKind::JoinedVertices);
    coincident.saturating_sub(joined.map(|loss| loss.count as usize).sum())
}
