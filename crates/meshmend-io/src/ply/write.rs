//! The PLY writer.

use std::io;

use meshmend_core::{PolygonMesh, Values};

use crate::layers::number;
use crate::ply::plan::{Column, Plan, Shape, header_line, index};
use crate::ply::scalar::Scalar;
use crate::sink::Sink;
use crate::{Encoding, Prepared, WriteErrorKind};

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let (mesh, encoding) = (&prepared.mesh, prepared.encoding);
    let plan = Plan::of(prepared);
    let mut rows = Rows { sink: Sink::new(out), encoding, row_has_values: false };
    header(mesh, &plan, encoding, &mut rows.sink)?;
    rows.vertices(mesh, &plan)?;
    rows.faces(mesh, &plan)?;
    rows.edges(mesh)?;
    Ok(rows.sink.finish()?)
}

fn header(mesh: &PolygonMesh, plan: &Plan<'_>, encoding: Encoding, sink: &mut Sink<'_>) -> io::Result<()> {
    let form = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    sink.bytes(format!("ply\nformat {form} 1.0\n").as_bytes());
    for statement in mesh.metadata() {
        let word = match statement.kind() {
            key @ ("comment" | "obj_info") => key,
            _ => continue,
        };
        sink.bytes(word.as_bytes());
        sink.byte(b' ');
        sink.bytes(&header_line(&statement.value));
        sink.byte(b'\n');
        sink.checkpoint()?;
    }
    let counts = mesh.counts();
    let mut text = format!("element vertex {}\n", counts.vertices);
    for axis in ["x", "y", "z"] {
        text += &format!("property {} {axis}\n", plan.position.name());
    }
    text.extend(plan.vertex.iter().map(declaration));
    text += &format!("element face {}\n", counts.faces);
    text += &format!("property list {} int vertex_indices\n", plan.degree.name());
    text.extend(plan.face.iter().map(declaration));
    if !mesh.loose_edges().is_empty() {
        let edges = mesh.loose_edges().len();
        text += &format!("element edge {edges}\nproperty int vertex1\nproperty int vertex2\n");
    }
    text += "end_header\n";
    sink.bytes(text.as_bytes());
    Ok(())
}

fn declaration(column: &Column<'_>) -> String {
    let item = column.item.name();
    match column.shape {
        Shape::Component(_) => format!("property {item} {}\n", column.name),
        Shape::List(length) | Shape::Corners(length) => {
            format!("property list {} {item} {}\n", length.name(), column.name)
        }
    }
}

/// Writes values in one encoding.
struct Rows<'a> {
    sink: Sink<'a>,
    encoding: Encoding,
    row_has_values: bool,
}

impl Rows<'_> {
    fn vertices(&mut self, mesh: &PolygonMesh, plan: &Plan<'_>) -> io::Result<()> {
        for (vertex, point) in mesh.positions().iter().enumerate() {
            point.iter().for_each(|&x| self.real(plan.position, x));
            for column in &plan.vertex {
                self.column(column, vertex, 0..0);
            }
            self.end_row()?;
        }
        Ok(())
    }

    fn faces(&mut self, mesh: &PolygonMesh, plan: &Plan<'_>) -> io::Result<()> {
        let faces = mesh.faces();
        for face in faces.faces() {
            let vertices = faces.face_vertices(face);
            self.whole(plan.degree, vertices.len() as i64);
            vertices.iter().for_each(|&vertex| self.whole(Scalar::I32, index(vertex)));
            for column in &plan.face {
                self.column(column, face.0 as usize, faces.corner_range(face));
            }
            self.end_row()?;
        }
        Ok(())
    }

    fn edges(&mut self, mesh: &PolygonMesh) -> io::Result<()> {
        for ends in mesh.loose_edges() {
            ends.iter().for_each(|&vertex| self.whole(Scalar::I32, index(vertex)));
            self.end_row()?;
        }
        Ok(())
    }

    fn column(&mut self, column: &Column<'_>, element: usize, corners: std::ops::Range<usize>) {
        let (values, width) = (column.layer.values(), column.layer.width());
        match column.shape {
            Shape::Component(component) => {
                let at = column.value_of(element).map(|value| value * width + component);
                self.entry(column.item, values, at);
            }
            Shape::List(length) => {
                let Values::Lists { starts, items } = values else { return };
                let range = match column.value_of(element) {
                    Some(value) => starts[value] as usize..starts[value + 1] as usize,
                    None => 0..0,
                };
                self.whole(length, range.len() as i64);
                range.for_each(|at| self.entry(column.item, items, Some(at)));
            }
            Shape::Corners(length) => {
                let count = column.corner_values(corners.clone());
                self.whole(length, count as i64);
                if count > 0 {
                    corners.for_each(|corner| self.corner(column, corner));
                }
            }
        }
    }

    fn corner(&mut self, column: &Column<'_>, corner: usize) {
        let width = column.layer.width();
        let value = column.value_of(corner);
        (0..width).for_each(|i| {
            self.entry(column.item, column.layer.values(), value.map(|value| value * width + i));
        });
    }

    /// An entry of a pool; for none at all NaN, or 0 in types that have no NaN.
    #[inline]
    fn entry(&mut self, item: Scalar, values: &Values, at: Option<usize>) {
        match (item.has_fractions(), at) {
            (true, Some(at)) => self.fraction(item, values, at),
            (true, None) => self.real(item, f64::NAN),
            (false, Some(at)) => self.whole(item, number(values, at) as i64),
            (false, None) => self.whole(item, 0),
        }
    }

    /// A number with a fraction, bit by bit also where it is a NaN with a payload.
    #[inline]
    fn fraction(&mut self, item: Scalar, values: &Values, at: usize) {
        match values {
            Values::F32(v) => self.single(v[at]),
            values => self.real(item, number(values, at)),
        }
    }

    #[inline]
    fn single(&mut self, value: f32) {
        match self.encoding {
            Encoding::Ascii => {
                self.part();
                self.sink.single(value);
            }
            Encoding::LittleEndian => self.sink.bytes(&value.to_le_bytes()),
            Encoding::BigEndian => self.sink.bytes(&value.to_be_bytes()),
        }
    }

    #[inline]
    fn real(&mut self, scalar: Scalar, value: f64) {
        if scalar == Scalar::F32 {
            return self.single(value as f32);
        }
        match self.encoding {
            Encoding::Ascii => {
                self.part();
                self.sink.real(value);
            }
            Encoding::LittleEndian => self.sink.bytes(&value.to_le_bytes()),
            Encoding::BigEndian => self.sink.bytes(&value.to_be_bytes()),
        }
    }

    /// A whole number that is within the range of its type.
    #[inline]
    fn whole(&mut self, scalar: Scalar, value: i64) {
        match self.encoding {
            Encoding::Ascii => {
                self.part();
                self.sink.integer(value);
            }
            Encoding::LittleEndian => self.sink.bytes(&value.to_le_bytes()[..scalar.size()]),
            Encoding::BigEndian => self.sink.bytes(&value.to_be_bytes()[8 - scalar.size()..]),
        }
    }

    /// A blank between values of one row.
    #[inline]
    fn part(&mut self) {
        if std::mem::replace(&mut self.row_has_values, true) {
            self.sink.byte(b' ');
        }
    }

    #[inline]
    fn end_row(&mut self) -> io::Result<()> {
        if self.encoding == Encoding::Ascii {
            self.sink.byte(b'\n');
            self.row_has_values = false;
        }
        self.sink.checkpoint()
    }
}
