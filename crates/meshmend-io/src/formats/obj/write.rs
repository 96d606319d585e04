//! The OBJ writer.

use std::io;

use meshmend_core::{Domain, Id, Layer, PolygonMesh, Values, counted};

use crate::formats::obj::comment_anchors::{COMMENT, ELEMENTS, FACE, NORMAL, TEXCOORD, VERTEX};
use crate::formats::obj::shape::ObjShape;
use crate::formats::obj::write_comments::{Between, is_between};
use crate::formats::obj::write_library::make_library;
use crate::formats::obj::write_loose::LoosePlan;
use crate::formats::obj::write_names::NameWriter;
use crate::formats::obj::write_values::{attributes, spaced, values};
use crate::layers::{has_fractions, is_numeric, layer_of, number};
use crate::output::layer_losses::{absent, layer_losses, losses_in};
use crate::output::sink::Sink;
use crate::output::statements::{metadata_losses, one_line, spelling_loss};
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

/// The keys of statements about the whole file, and their words.
const STATEMENTS: [(&str, &str); 2] = [(COMMENT, "#"), ("mtllib", "mtllib")];

/// Moves colours and weights to the vertices, with which they are written, and makes a library for materials of
/// another format.
pub(super) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    prepared.name_textures()?;
    prepared.split_seams(|layer| match layer.name() {
        "color" => is_color(layer),
        "weight" => has_fractions(layer) && layer.width() == 1,
        _ => false,
    })?;
    make_library(prepared);
    Ok(())
}

fn is_color(layer: &Layer) -> bool {
    let is_known = has_fractions(layer) || matches!(layer.values(), Values::U8(_));
    is_known && (3..=4).contains(&layer.width())
}

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh, ObjShape::color_width(prepared));
    let mut sink = Sink::new(out);
    let mut between = Between::of(mesh);
    for statement in mesh.metadata().iter().filter(|statement| !is_between(statement)) {
        let Some((_, word)) = STATEMENTS.iter().find(|(key, _)| *key == statement.kind()) else { continue };
        sink.bytes(word.as_bytes());
        if !statement.value.is_empty() {
            sink.byte(b' ');
        }
        sink.bytes(&one_line(&statement.value));
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    let is_written = |key: &str| STATEMENTS.iter().any(|(known, _)| *known == key);
    if mesh.positions().is_empty() && !mesh.metadata().iter().any(|statement| is_written(statement.kind())) {
        // An empty file would look like the result of a failure.
        sink.bytes(b"# no vertices\n");
    }
    plan.vertices(mesh, &mut between, &mut sink)?;
    pool(plan.texcoord, TEXCOORD, &mut between, &mut sink)?;
    plan.loose.further_texcoords(&mut sink)?;
    pool(plan.normal, NORMAL, &mut between, &mut sink)?;
    let mut names = NameWriter::of(mesh);
    plan.faces(mesh, &mut names, &mut between, &mut sink)?;
    plan.loose.write(mesh, &mut names, &mut between, &mut sink)?;
    between.at_end(&mut sink);
    Ok(sink.finish()?)
}

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(mesh, ObjShape::color_width(prepared));
    let names = NameWriter::of(mesh);
    let written: Vec<&Layer> = plan.layers().into_iter().chain(names.layers()).collect();
    let mut losses = layer_losses(mesh, &written);
    losses.extend(losses_in(mesh, &written, &[Domain::LooseEdge, Domain::LoosePoint]));
    losses.extend(plan.color.filter(|color| !has_fractions(color)).map(|color| {
        let count = color.element_count();
        let message = format!("colours of {} become fractions of 255", counted(count, "vertex"));
        Loss::new(LossKind::Converted, count, message)
    }));
    losses.extend(plan.color.and_then(|color| plan.alpha_loss(color)));
    losses.extend(plan.weight.and_then(|layer| {
        Loss::if_any(LossKind::AbsentValue, absent(layer), |n| {
            let (have, they_get) = if n == 1 { ("has", "it gets") } else { ("have", "they get") };
            format!("that {} {have} no vertex attribute `weight`: {they_get} 1", counted(n, "vertex"))
        })
    }));
    losses.extend([plan.texcoord, plan.normal].into_iter().flatten().filter_map(moved_to_corners));
    losses.extend(names.losses());
    let keys = STATEMENTS.map(|(key, _)| key);
    losses.extend(metadata_losses(mesh, &keys));
    losses.extend(spelling_loss(mesh, &keys));
    losses
}

fn moved_to_corners(layer: &Layer) -> Option<Loss> {
    let (domain, name) = (layer.domain().name(), layer.name());
    let count = if layer.domain() == Domain::Vertex { layer.element_count() } else { 0 };
    Loss::if_any(LossKind::Converted, count, |_| format!("{domain} attribute `{name}` moves to the corners"))
}

/// Which layers are written, and as what.
struct Plan<'a> {
    color: Option<&'a Layer>,
    /// How many numbers of a colour are written.
    color_width: usize,
    weight: Option<&'a Layer>,
    texcoord: Option<&'a Layer>,
    normal: Option<&'a Layer>,
    loose: LoosePlan<'a>,
}

impl<'a> Plan<'a> {
    fn of(mesh: &'a PolygonMesh, color_width: usize) -> Self {
        let indexed = |name, widths: std::ops::RangeInclusive<usize>| {
            let is_fit = |layer: &Layer| is_numeric(layer) && widths.contains(&layer.width());
            layer_of(mesh, name, Domain::Corner, is_fit)
                .or_else(|| layer_of(mesh, name, Domain::Vertex, is_fit))
        };
        let color = layer_of(mesh, "color", Domain::Vertex, is_color);
        let is_weight = |layer: &Layer| color.is_none() && has_fractions(layer) && layer.width() == 1;
        let texcoord = indexed("texcoord", 1..=3);
        Plan {
            color,
            color_width,
            weight: layer_of(mesh, "weight", Domain::Vertex, is_weight),
            texcoord,
            normal: indexed("normal", 3..=3),
            loose: LoosePlan::of(mesh, texcoord),
        }
    }

    /// The loss of the alpha of colours, if it is not written.
    fn alpha_loss(&self, color: &Layer) -> Option<Loss> {
        if color.width() <= self.color_width {
            return None;
        }
        let opaque = if has_fractions(color) { 1.0 } else { 255.0 };
        let is_clear = |&value: &usize| number(color.values(), value * color.width() + 3) != opaque;
        let clear = (0..color.element_count()).filter_map(|at| color.value_of(at)).filter(is_clear).count();
        Loss::if_any(LossKind::Layer, clear, |n| {
            format!("the alpha of the colours of {}: other programs misread it", counted(n, "vertex"))
        })
    }

    fn layers(&self) -> Vec<&'a Layer> {
        let single = [self.color, self.weight, self.texcoord, self.normal];
        single.into_iter().flatten().chain(self.loose.layers()).collect()
    }

    fn vertices(&self, mesh: &PolygonMesh, between: &mut Between<'_>, sink: &mut Sink<'_>) -> io::Result<()> {
        for (vertex, position) in mesh.positions().iter().enumerate() {
            between.before(VERTEX, vertex, sink);
            sink.byte(b'v');
            position.iter().for_each(|&x| spaced(sink, x));
            if let Some(layer) = self.weight {
                spaced(sink, layer.value_of(vertex).map_or(1.0, |value| number(layer.values(), value)));
            }
            if let Some((layer, value)) = self.color.and_then(|layer| Some((layer, layer.value_of(vertex)?)))
            {
                let scale = if has_fractions(layer) { 1.0 } else { 255.0 };
                let width = layer.width();
                let shown = 0..width.min(self.color_width);
                shown.for_each(|i| spaced(sink, number(layer.values(), value * width + i) / scale));
            }
            sink.byte(b'\n');
            sink.checkpoint()?;
        }
        between.after_all(VERTEX, sink);
        Ok(())
    }

    fn faces(
        &self,
        mesh: &PolygonMesh,
        names: &mut NameWriter<'_>,
        between: &mut Between<'_>,
        sink: &mut Sink<'_>,
    ) -> io::Result<()> {
        for face in mesh.faces().faces() {
            between.before(FACE, face.index(), sink);
            names.before(0, face.index(), sink);
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
        between.after_all(FACE, sink);
        Ok(())
    }
}

fn pool(
    layer: Option<&Layer>,
    kind: usize,
    between: &mut Between<'_>,
    sink: &mut Sink<'_>,
) -> io::Result<()> {
    if let Some(layer) = layer {
        let statement = ELEMENTS[kind].as_bytes();
        for value in 0..layer.value_count() {
            between.before(kind, value, sink);
            values(layer, value, statement, sink);
            sink.checkpoint()?;
        }
    }
    between.after_all(kind, sink);
    Ok(())
}
