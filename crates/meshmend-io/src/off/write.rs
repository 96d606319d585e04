//! The OFF writer.

use std::io;

use meshmend_core::{Domain, Id, Layer, PolygonMesh, Values};

use crate::layers::{
    absent, absent_loss, has_fractions, is_numeric, layer_losses, layer_of, loose_losses, metadata_losses,
    number, one_line, spelling_loss,
};
use crate::sink::Sink;
use crate::{Loss, Prepared, WriteErrorKind};

/// Which layers are written.
struct Plan<'a> {
    normal: Option<&'a Layer>,
    texcoord: Option<&'a Layer>,
    vertex_color: Option<&'a Layer>,
    face_color: Option<&'a Layer>,
}

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh);
    let mut sink = Sink::new(out);
    sink.bytes(plan.header().as_bytes());
    for statement in mesh.metadata().iter().filter(|statement| statement.key == "comment") {
        sink.bytes(b"# ");
        sink.bytes(&one_line(&statement.value));
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    let counts = mesh.counts();
    sink.bytes(format!("{} {} 0\n", counts.vertices, counts.faces).as_bytes());
    for (vertex, [x, y, z]) in mesh.positions().iter().enumerate() {
        sink.real(*x);
        spaced(&mut sink, *y);
        spaced(&mut sink, *z);
        plan.vertex_columns(vertex, &mut sink);
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    for face in mesh.faces().faces() {
        let vertices = mesh.faces().face_vertices(face);
        sink.integer(vertices.len() as i64);
        for vertex in vertices {
            sink.byte(b' ');
            sink.integer(vertex.index() as i64);
        }
        color(plan.face_color, face.index(), &mut sink);
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    Ok(sink.finish()?)
}

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh);
    let written = [plan.normal, plan.texcoord, plan.vertex_color, plan.face_color];
    let written: Vec<&Layer> = written.into_iter().flatten().collect();
    let mut losses = layer_losses(mesh, &written);
    for layer in [plan.normal, plan.texcoord].into_iter().flatten() {
        losses.extend(absent_loss(layer, absent(layer)));
    }
    losses.extend(loose_losses(mesh));
    losses.extend(metadata_losses(mesh, &["comment"]));
    losses.extend(spelling_loss(mesh, &["comment"]));
    losses
}

impl<'a> Plan<'a> {
    fn of(mesh: &'a PolygonMesh) -> Self {
        // Letters in the header promise columns; without a vertex there is none to tell their kind by.
        let on_vertices = |name, is_wanted: &dyn Fn(&Layer) -> bool| {
            layer_of(mesh, name, Domain::Vertex, is_wanted).filter(|_| mesh.counts().vertices > 0)
        };
        let vertex = |name, width| on_vertices(name, &|layer| is_numeric(layer) && layer.width() == width);
        let (normal, vertex_color) = (vertex("normal", 3), on_vertices("color", &is_color));
        // Headers that join `ST` with other letters are legal, but many programs don't read them.
        let texcoord = vertex("texcoord", 2).filter(|_| normal.is_none() && vertex_color.is_none());
        Plan { normal, texcoord, vertex_color, face_color: layer_of(mesh, "color", Domain::Face, is_color) }
    }

    fn header(&self) -> String {
        let letters = [(self.texcoord, "ST"), (self.vertex_color, "C"), (self.normal, "N")];
        let letters = letters.iter().filter(|(layer, _)| layer.is_some()).map(|(_, letters)| *letters);
        letters.chain(["OFF\n"]).collect()
    }

    fn vertex_columns(&self, vertex: usize, sink: &mut Sink<'_>) {
        numbers(self.normal, vertex, sink);
        color(self.vertex_color, vertex, sink);
        numbers(self.texcoord, vertex, sink);
    }
}

/// Bytes, fractions, or text that is a line's worth of words.
fn is_color(layer: &Layer) -> bool {
    match layer.values() {
        Values::U8(_) => (3..=4).contains(&layer.width()),
        Values::Text(texts) => {
            let is_safe = |text: &Vec<u8>| !text.iter().any(|b| matches!(b, b'\n' | b'\r' | b'#' | 0));
            layer.width() == 1 && texts.iter().all(is_safe)
        }
        _ => has_fractions(layer) && (3..=4).contains(&layer.width()),
    }
}

/// The numbers of a value; NaN where there is none.
fn numbers(layer: Option<&Layer>, element: usize, sink: &mut Sink<'_>) {
    let Some(layer) = layer else { return };
    let (width, value) = (layer.width(), layer.value_of(element));
    for i in 0..width {
        spaced(sink, value.map_or(f64::NAN, |value| number(layer.values(), value * width + i)));
    }
}

/// A colour, in which whole fractions have a point that tells them from bytes.
fn color(layer: Option<&Layer>, element: usize, sink: &mut Sink<'_>) {
    let Some((layer, value)) = layer.and_then(|layer| Some((layer, layer.value_of(element)?))) else {
        return;
    };
    let width = layer.width();
    for at in value * width..(value + 1) * width {
        match layer.values() {
            Values::Text(texts) => {
                sink.byte(b' ');
                sink.bytes(&texts[at]);
            }
            values => spaced(sink, number(values, at)),
        }
        let is_whole = has_fractions(layer) && number(layer.values(), at).fract() == 0.0;
        if is_whole && number(layer.values(), at).abs() < 1e16 {
            sink.bytes(b".0");
        }
    }
}

#[inline]
fn spaced(sink: &mut Sink<'_>, value: f64) {
    sink.byte(b' ');
    sink.real(value);
}
