//! The OBJ writer.

use std::borrow::Cow;
use std::io;

use meshmend_core::{Domain, FaceId, Id, Layer, PolygonMesh, Values};

use crate::layers::{
    absent, domain_name, has_fractions, is_numeric, layer_losses, layer_of, metadata_losses, number,
    one_line, spelling_loss,
};
use crate::obj::names::{KINDS, spelled};
use crate::sink::Sink;
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

/// Statements about the whole file, with their keys.
const STATEMENTS: [(&str, &str); 2] = [("comment", "#"), ("mtllib", "mtllib")];

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh);
    let mut sink = Sink::new(out);
    for statement in mesh.metadata() {
        let Some((_, word)) = STATEMENTS.iter().find(|(key, _)| *key == statement.key) else { continue };
        sink.bytes(word.as_bytes());
        if !statement.value.is_empty() {
            sink.byte(b' ');
        }
        sink.bytes(&one_line(&statement.value));
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    let is_written = |key: &str| STATEMENTS.iter().any(|(known, _)| *known == key);
    if mesh.positions().is_empty() && !mesh.metadata().iter().any(|statement| is_written(&statement.key)) {
        // A file without a byte could be one that something went wrong with.
        sink.bytes(b"# no vertices\n");
    }
    plan.vertices(mesh, &mut sink)?;
    pool(plan.texcoord, b"vt", &mut sink)?;
    pool(plan.normal, b"vn", &mut sink)?;
    plan.faces(mesh, &mut sink)?;
    loose(mesh, &mut sink)?;
    Ok(sink.finish()?)
}

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh);
    let mut losses = layer_losses(mesh, &plan.layers());
    losses.extend(plan.color.filter(|color| !has_fractions(color)).map(|color| {
        let count = color.element_count();
        let message = format!("colours of {count} vertices become fractions of 255");
        Loss::new(LossKind::Converted, count, message)
    }));
    losses.extend(plan.weight.and_then(|layer| {
        Loss::if_any(LossKind::AbsentValue, absent(layer), |n| {
            format!("that {n} vertices have no vertex attribute `weight`: they get 1")
        })
    }));
    losses.extend([plan.texcoord, plan.normal].into_iter().flatten().filter_map(moved_to_corners));
    losses.extend(plan.names.iter().zip(&KINDS).filter_map(|(layer, kind)| {
        let Values::Text(names) = layer.as_ref()?.values() else { return None };
        let other = names.iter().filter(|name| *spelled(kind, name) != name[..]).count();
        Loss::if_any(LossKind::Names, other, |n| {
            format!("{n} names of `{}` are spelled otherwise", kind.layer)
        })
    }));
    let keys = STATEMENTS.map(|(key, _)| key);
    losses.extend(metadata_losses(mesh, &keys));
    losses.extend(spelling_loss(mesh, &keys));
    losses
}

fn moved_to_corners(layer: &Layer) -> Option<Loss> {
    let (domain, name) = (domain_name(layer.domain()), layer.name());
    let count = if layer.domain() == Domain::Vertex { layer.element_count() } else { 0 };
    Loss::if_any(LossKind::Converted, count, |_| format!("{domain} attribute `{name}` moves to the corners"))
}

/// Which layers are written, and as what.
struct Plan<'a> {
    color: Option<&'a Layer>,
    weight: Option<&'a Layer>,
    texcoord: Option<&'a Layer>,
    normal: Option<&'a Layer>,
    names: [Option<&'a Layer>; KINDS.len()],
}

impl<'a> Plan<'a> {
    fn of(mesh: &'a PolygonMesh) -> Self {
        let indexed = |name, widths: std::ops::RangeInclusive<usize>| {
            let is_fit = |layer: &Layer| is_numeric(layer) && widths.contains(&layer.width());
            layer_of(mesh, name, Domain::Corner, is_fit)
                .or_else(|| layer_of(mesh, name, Domain::Vertex, is_fit))
        };
        let is_color = |layer: &Layer| {
            let is_known = has_fractions(layer) || matches!(layer.values(), Values::U8(_));
            is_known && (3..=4).contains(&layer.width())
        };
        let color = layer_of(mesh, "color", Domain::Vertex, is_color);
        let is_weight = |layer: &Layer| color.is_none() && has_fractions(layer) && layer.width() == 1;
        let is_text = |layer: &Layer| matches!(layer.values(), Values::Text(_)) && layer.width() == 1;
        Plan {
            color,
            weight: layer_of(mesh, "weight", Domain::Vertex, is_weight),
            texcoord: indexed("texcoord", 1..=3),
            normal: indexed("normal", 3..=3),
            names: KINDS.each_ref().map(|kind| layer_of(mesh, kind.layer, Domain::Face, is_text)),
        }
    }

    fn layers(&self) -> Vec<&'a Layer> {
        let single = [self.color, self.weight, self.texcoord, self.normal];
        single.into_iter().chain(self.names).flatten().collect()
    }

    fn vertices(&self, mesh: &PolygonMesh, sink: &mut Sink<'_>) -> io::Result<()> {
        for (vertex, position) in mesh.positions().iter().enumerate() {
            sink.byte(b'v');
            position.iter().for_each(|&x| spaced(sink, x));
            if let Some(layer) = self.weight {
                spaced(sink, layer.value_of(vertex).map_or(1.0, |value| number(layer.values(), value)));
            }
            if let Some((layer, value)) = self.color.and_then(|layer| Some((layer, layer.value_of(vertex)?)))
            {
                let scale = if has_fractions(layer) { 1.0 } else { 255.0 };
                let width = layer.width();
                (0..width).for_each(|i| spaced(sink, number(layer.values(), value * width + i) / scale));
            }
            sink.byte(b'\n');
            sink.checkpoint()?;
        }
        Ok(())
    }

    fn faces(&self, mesh: &PolygonMesh, sink: &mut Sink<'_>) -> io::Result<()> {
        let mut current = [None; KINDS.len()];
        for face in mesh.faces().faces() {
            self.names_before(face, &mut current, sink);
            sink.byte(b'f');
            for corner in mesh.faces().corner_range(face) {
                let vertex = mesh.faces().corner_vertices()[corner].index();
                let value = |layer: Option<&Layer>| match layer?.domain() {
                    Domain::Vertex => layer?.value_of(vertex),
                    _ => layer?.value_of(corner),
                };
                sink.byte(b' ');
                sink.integer(vertex as i64 + 1);
                attributes(sink, value(self.texcoord), value(self.normal));
            }
            sink.byte(b'\n');
            sink.checkpoint()?;
        }
        Ok(())
    }

    /// The statements that give a face other names than the face before it has.
    fn names_before(&self, face: FaceId, current: &mut [Option<usize>; KINDS.len()], sink: &mut Sink<'_>) {
        for ((layer, kind), current) in self.names.iter().zip(&KINDS).zip(current) {
            let Some(layer) = layer else { continue };
            let (Values::Text(names), name) = (layer.values(), layer.value_of(face.index())) else {
                continue;
            };
            if name == std::mem::replace(current, name) {
                continue;
            }
            let name = name.map_or(Cow::Borrowed(kind.none), |name| spelled(kind, &names[name]));
            sink.bytes(kind.statement);
            if !name.is_empty() {
                sink.byte(b' ');
                sink.bytes(&name);
            }
            sink.byte(b'\n');
        }
    }
}

#[inline]
fn attributes(sink: &mut Sink<'_>, texcoord: Option<usize>, normal: Option<usize>) {
    match (texcoord, normal) {
        (None, None) => {}
        (Some(texcoord), None) => {
            sink.byte(b'/');
            sink.integer(texcoord as i64 + 1);
        }
        (texcoord, Some(normal)) => {
            sink.byte(b'/');
            texcoord.iter().for_each(|&texcoord| sink.integer(texcoord as i64 + 1));
            sink.byte(b'/');
            sink.integer(normal as i64 + 1);
        }
    }
}

fn pool(layer: Option<&Layer>, statement: &[u8], sink: &mut Sink<'_>) -> io::Result<()> {
    let Some(layer) = layer else { return Ok(()) };
    for value in 0..layer.value_count() {
        sink.bytes(statement);
        let width = layer.width();
        (0..width).for_each(|i| spaced(sink, number(layer.values(), value * width + i)));
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    Ok(())
}

fn loose(mesh: &PolygonMesh, sink: &mut Sink<'_>) -> io::Result<()> {
    let edges = mesh.loose_edges().iter().map(|ends| (b'l', &ends[..]));
    let points = mesh.loose_points().iter().map(|point| (b'p', std::slice::from_ref(point)));
    for (statement, vertices) in edges.chain(points) {
        sink.byte(statement);
        for vertex in vertices {
            sink.byte(b' ');
            sink.integer(vertex.index() as i64 + 1);
        }
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    Ok(())
}

#[inline]
fn spaced(sink: &mut Sink<'_>, value: f64) {
    sink.byte(b' ');
    sink.real(value);
}
