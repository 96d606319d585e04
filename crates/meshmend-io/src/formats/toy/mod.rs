//! The reader and the writer of the example of CONTRIBUTING.

pub(crate) mod facts;

use std::io;

use meshmend_core::VertexId;

use crate::formats::driver::{Driver, ReadResult};
use crate::input::assemble::Parts;
use crate::input::source::{Parsed, Source};
use crate::output::layer_losses::{layer_losses, loose_losses};
use crate::output::sink::Sink;
use crate::output::statements::metadata_losses;
use crate::shell::NoChoices;
use crate::text::{line_end, skip_space, usual_line::UsualLine};
use crate::{Encoding, Format, Limits, Loss, Prepared, Shell, WriteErrorKind};

pub(crate) static DRIVER: Driver = Driver {
    read,
    read_blocks: Driver::needs_whole_file,
    stream: Driver::streams_nothing,
    look_beside: Driver::names_no_files,
    prepare: |_| Ok(()),
    encode,
    losses,
};

fn read(source: &Source<'_>, limits: &Limits) -> ReadResult {
    let (mut parts, mut at) = (Parts::default(), line_end(source.bytes, 0));
    while skip_space(source.bytes, at, source.bytes.len()) < source.bytes.len() {
        let line = UsualLine::from(source.bytes, at);
        let start = line.at;
        let wrong = || source.malformed(source.line(start), "neither `v` and numbers nor `f` and indices");
        at = row(line, &mut parts).ok_or_else(wrong)?;
        source.limited("vertices", parts.positions.len() as u64, limits.max_vertices)?;
        source.limited("faces", parts.faces.face_count() as u64, limits.max_faces)?;
        source.limited("corners", parts.faces.corner_count() as u64, limits.max_corners)?;
    }
    let (mesh, notes) = parts.assemble(source, 0, |at| source.line(at))?;
    Ok(Parsed::whole(mesh, notes, Shell::of_file(Format::Toy, Encoding::Ascii, NoChoices)))
}

/// Takes a row in, and returns where the next one begins.
fn row(mut line: UsualLine<'_>, parts: &mut Parts) -> Option<usize> {
    if line.accept(b"v") {
        parts.positions.push(line.point()?);
        return line.end();
    }
    line.pass(b"f")?;
    while line.has_more() {
        let (vertex, at) = line.placed_whole()?;
        parts.max_index.see(vertex, at);
        parts.faces.push_corner(VertexId(vertex));
    }
    parts.faces.end_face();
    line.end()
}

fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let (mesh, mut sink) = (prepared.mesh(), Sink::new(out));
    sink.bytes(b"toy\n");
    for position in mesh.positions() {
        sink.byte(b'v');
        for &x in position {
            sink.byte(b' ');
            sink.real(x);
        }
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    for face in mesh.faces().faces() {
        sink.byte(b'f');
        for vertex in mesh.faces().face_vertices(face) {
            sink.byte(b' ');
            sink.integer(vertex.0.into());
        }
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    Ok(sink.finish()?)
}

fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mut losses = layer_losses(prepared.mesh(), &[]);
    losses.extend(loose_losses(prepared.mesh()));
    losses.extend(metadata_losses(prepared.mesh(), &[]));
    losses
}
