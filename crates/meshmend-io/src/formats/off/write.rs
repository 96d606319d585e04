//! The OFF writer.

use std::io;

use meshmend_core::{Domain, Id, Layer, Values, counted};

use crate::formats::off::colors::INDEX_LAYER;
use crate::formats::off::shape::OffShape;
use crate::layers::{has_fractions, is_numeric, layer_of, number};
use crate::output::layer_losses::{absent, absent_loss, layer_losses, loose_losses};
use crate::output::sink::Sink;
use crate::output::statements::{metadata_losses, one_line, spelling_loss};
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

/// Which layers are written.
struct Plan<'a> {
    /// The letters in the header of the input.
    letters: &'a [u8],
    normal: Option<&'a Layer>,
    texcoord: Option<&'a Layer>,
    vertex_color: Option<&'a Layer>,
    face_color: Option<&'a Layer>,
}

/// Moves normals, colours and texture coordinates to the vertices, with which they are written.
pub(super) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    prepared.split_seams(|layer| match layer.name() {
        "normal" => is_numeric(layer) && layer.width() == 3,
        "texcoord" => is_numeric(layer) && layer.width() == 2,
        "color" => is_color(layer),
        _ => false,
    })
}

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(prepared);
    let mut sink = Sink::new(out);
    sink.bytes(plan.header().as_bytes());
    for statement in mesh.metadata().iter().filter(|statement| statement.kind() == "comment") {
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
        color(plan.face_color, face.index(), 0, &mut sink);
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    Ok(sink.finish()?)
}

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(prepared);
    let written = [plan.normal, plan.texcoord, plan.vertex_color, plan.face_color];
    let written: Vec<&Layer> = written.into_iter().flatten().collect();
    let mut losses = layer_losses(mesh, &written);
    for layer in [plan.normal, plan.texcoord].into_iter().flatten() {
        losses.extend(absent_loss(layer, absent(layer)));
    }
    if let Some(layer) = plan.vertex_color.filter(|layer| lacks_alpha(layer)) {
        let count = layer.element_count() - absent(layer);
        losses.extend(Loss::if_any(LossKind::Converted, count, |n| {
            format!("vertex attribute `color` of {} gets an opaque fourth number", counted(n, "vertex"))
        }));
    }
    losses.extend(loose_losses(mesh));
    losses.extend(metadata_losses(mesh, &["comment"]));
    losses.extend(spelling_loss(mesh, &["comment"]));
    losses
}

impl<'a> Plan<'a> {
    fn of(prepared: &'a Prepared) -> Self {
        let mesh = &prepared.mesh;
        // Letters in the header promise columns. Without a vertex a reader could not see their kind.
        let on_vertices = |name, is_wanted: &dyn Fn(&Layer) -> bool| {
            layer_of(mesh, name, Domain::Vertex, is_wanted).filter(|_| mesh.counts().vertices > 0)
        };
        let vertex = |name, width| on_vertices(name, &|layer| is_numeric(layer) && layer.width() == width);
        let (normal, vertex_color) = (vertex("normal", 3), on_vertices("color", &is_color));
        let letters = match prepared.shape() {
            Some(OffShape { letters }) => letters,
            _ => &[][..],
        };
        // Headers with `ST` and other letters are valid, but many programs don't read them.
        let is_alone = normal.is_none() && vertex_color.is_none();
        let is_as_read = letters.starts_with(b"ST") || letters.ends_with(b"ST");
        let texcoord = vertex("texcoord", 2).filter(|_| is_alone || is_as_read);
        let of_faces = |name, is_fit: &dyn Fn(&Layer) -> bool| layer_of(mesh, name, Domain::Face, is_fit);
        let face_color = of_faces("color", &is_color).or_else(|| of_faces(INDEX_LAYER, &is_index));
        Plan { letters, normal, texcoord, vertex_color, face_color }
    }

    /// The header: with the letters of the input, if they still fit.
    fn header(&self) -> String {
        let letters = [(self.texcoord, "ST"), (self.vertex_color, "C"), (self.normal, "N")];
        let letters = letters.iter().filter(|(layer, _)| layer.is_some()).map(|(_, letters)| *letters);
        let usual: String = letters.collect();
        let sorted = |letters: &[u8]| {
            let mut letters = letters.to_vec();
            letters.sort_unstable();
            letters
        };
        let as_read = String::from_utf8_lossy(self.letters);
        let letters = if sorted(self.letters) == sorted(usual.as_bytes()) { &*as_read } else { &*usual };
        format!("{letters}OFF\n")
    }

    fn vertex_columns(&self, vertex: usize, sink: &mut Sink<'_>) {
        numbers(self.normal, vertex, sink);
        color(self.vertex_color, vertex, 4, sink);
        numbers(self.texcoord, vertex, sink);
    }
}

/// Bytes, fractions, or texts that fit a line.
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

/// Indices into a map of colours.
fn is_index(layer: &Layer) -> bool {
    matches!(layer.values(), Values::I32(_)) && layer.width() == 1
}

/// The numbers of a value, or NaN if there is none.
fn numbers(layer: Option<&Layer>, element: usize, sink: &mut Sink<'_>) {
    let Some(layer) = layer else { return };
    let (width, value) = (layer.width(), layer.value_of(element));
    for i in 0..width {
        spaced(sink, value.map_or(f64::NAN, |value| number(layer.values(), value * width + i)));
    }
}

/// A colour of so many numbers at least. Fractions that are whole get a point, so that they are not read as bytes.
fn color(layer: Option<&Layer>, element: usize, least: usize, sink: &mut Sink<'_>) {
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
    if lacks_alpha(layer) && least == 4 {
        sink.bytes(if has_fractions(layer) { b" 1.0" } else { b" 255" });
    }
}

/// Whether a layer's colours have three numbers.
fn lacks_alpha(layer: &Layer) -> bool {
    is_numeric(layer) && layer.width() == 3
}

#[inline]
fn spaced(sink: &mut Sink<'_>, value: f64) {
    sink.byte(b' ');
    sink.real(value);
}
