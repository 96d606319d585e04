//! The STL writer.

use std::io;

use meshmend_core::{Domain, FaceId, Id, Layer, PolygonMesh, Values, VertexId};

use crate::layers::{absent, absent_loss, layer_losses, layer_of, loose_losses, metadata_losses};
use crate::sink::Sink;
use crate::stl::{HEAD, HEADER, SOLID};
use crate::text::{trimmed, without_mark};
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
            sink.bytes(&facet(normal(points), points, attribute.unwrap_or(0)));
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

/// The stored header, or an empty one. None begins with `solid`, also after a byte order mark, as a reader may take that
/// for text.
fn header(mesh: &PolygonMesh) -> [u8; HEAD - 4] {
    let stored = mesh.metadata().iter().find(|m| m.key == HEADER).map_or(&[][..], |m| &m.value);
    let prefix: &[u8] = if is_misleading(stored) { b"binary " } else { b"" };
    let mut header = [0; HEAD - 4];
    for (slot, byte) in header.iter_mut().zip(prefix.iter().chain(stored)) {
        *slot = *byte;
    }
    header
}

fn is_misleading(header: &[u8]) -> bool {
    trimmed(without_mark(header)).get(..5).is_some_and(|start| start.eq_ignore_ascii_case(b"solid"))
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
            text_facet(sink, triangle.map(|v| single(mesh, v)));
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

/// A name that is read back as one: one line, and none of the words that end a name.
fn solid_name(name: &[u8]) -> Vec<u8> {
    let safe = |b: &u8| if matches!(b, b'\n' | b'\r' | 0) { b' ' } else { *b };
    let line: Vec<u8> = name.iter().map(safe).collect();
    let mut spelled = trimmed(&line).to_vec();
    for word in [&b"facet"[..], b"endsolid"] {
        for at in 0..spelled.len().saturating_sub(word.len() - 1) {
            if spelled[at..at + word.len()].eq_ignore_ascii_case(word) {
                spelled[at] = b'_';
            }
        }
    }
    spelled
}

fn text_facet(sink: &mut Sink<'_>, points: [[f32; 3]; 3]) {
    sink.bytes(b"facet normal");
    numbers(sink, normal(points));
    sink.bytes(b"outer loop\n");
    for point in points {
        sink.bytes(b"vertex");
        numbers(sink, point);
    }
    sink.bytes(b"endloop\nendfacet\n");
}

fn numbers(sink: &mut Sink<'_>, numbers: [f32; 3]) {
    for number in numbers {
        sink.byte(b' ');
        sink.single(number);
    }
    sink.byte(b'\n');
}

/// The vertices of a face, unless it has fewer than three corners.
fn triangle(mesh: &PolygonMesh, face: FaceId) -> Option<[VertexId; 3]> {
    mesh.faces().face_vertices(face).try_into().ok()
}

fn single(mesh: &PolygonMesh, vertex: VertexId) -> [f32; 3] {
    let [x, y, z] = mesh.position(vertex);
    [x as f32, y as f32, z as f32]
}

/// The unit normal of a triangle; zero where it has none. The products of differences of single-precision
/// numbers neither overflow nor vanish in a double.
fn normal(points: [[f32; 3]; 3]) -> [f32; 3] {
    let way = |to: [f32; 3], from: [f32; 3]| {
        let along = |axis: usize| f64::from(to[axis]) - f64::from(from[axis]);
        [along(0), along(1), along(2)]
    };
    let (u, v) = (way(points[1], points[0]), way(points[2], points[0]));
    let [x, y, z] = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let scale = 1.0 / (x * x + y * y + z * z).sqrt();
    if scale.is_finite() { [(x * scale) as f32, (y * scale) as f32, (z * scale) as f32] } else { [0.0; 3] }
}

/// The layer whose numbers are written. Zeros alone are what a file without attributes has, and would be read as none.
fn attribute_layer(mesh: &PolygonMesh) -> Option<(&Layer, &[u16])> {
    let layer = layer_of(mesh, "attribute", Domain::Face, |layer| {
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
    let mut losses = geometry_losses(mesh);
    losses.extend(layer_losses(mesh, written.as_slice()));
    // A facet without a number of its own has 0.
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
        headers.filter(|m| is_misleading(&m.value) || m.value.len() > HEAD - 4).count()
    };
    Loss::if_any(LossKind::Names, other, |n| format!("{n} names are spelled otherwise"))
}

fn geometry_losses(mesh: &PolygonMesh) -> Vec<Loss> {
    let faces = mesh.faces();
    let sizes = faces.faces().map(|face| faces.corner_range(face).len());
    let mut used = vec![false; mesh.counts().vertices];
    let kept = faces.faces().filter(|&face| faces.corner_range(face).len() > 2);
    kept.for_each(|face| faces.face_vertices(face).iter().for_each(|v| used[v.index()] = true));
    let unused = used.iter().filter(|&&used| !used).count();
    let positions = || mesh.positions().iter().zip(&used).filter(|&(_, &used)| used).map(|(p, _)| p);
    let total = mesh.counts().vertices;
    let is_rounded = |p: &&[f64; 3]| p.iter().any(|&x| f64::from(x as f32) != x && !x.is_nan());
    let rounded = positions().filter(is_rounded).count();
    [
        Loss::if_any(LossKind::ShortFaces, sizes.filter(|&n| n < 3).count(), |n| {
            format!("{n} faces of fewer than three corners")
        }),
        Loss::if_any(LossKind::UnusedVertices, unused, |n| format!("{n} vertices that no face uses")),
        Loss::if_any(LossKind::Precision, rounded, |n| {
            format!("positions rounded to single precision: {n} of {total}")
        }),
        Loss::if_any(LossKind::SharedVertices, coincident(positions()), |n| {
            format!(
                "that {n} vertices are not those at the same point: without indices they become one again"
            )
        }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// How many vertices have the same position, in single precision, as an earlier one.
fn coincident<'a>(positions: impl Iterator<Item = &'a [f64; 3]>) -> usize {
    let bits = |x: f64| u128::from((x as f32 + 0.0).to_bits());
    let finite = positions.filter(|p| p.iter().all(|x| x.is_finite()));
    let mut keys: Vec<u128> = finite.map(|&[x, y, z]| bits(x) << 64 | bits(y) << 32 | bits(z)).collect();
    keys.sort_unstable();
    keys.windows(2).filter(|pair| pair[0] == pair[1]).count()
}
