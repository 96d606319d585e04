//! The PLY writer.

use std::io;

use meshmend_core::{FaceId, Id, Layer, PolygonMesh, Values};

use crate::formats::ply::plan::{Element, Plan, header_line};
use crate::formats::ply::property::{Property, Source, corner_values};
use crate::formats::ply::scalar::Scalar;
use crate::layers::number;
use crate::output::sink::Sink;
use crate::{Encoding, Prepared, WriteErrorKind};

pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let plan = Plan::of(prepared);
    let mut rows = RowWriter { sink: Sink::new(out), encoding: prepared.encoding, row_has_values: false };
    header(&prepared.mesh, &plan, prepared.encoding, &mut rows.sink)?;
    for element in &plan.elements {
        rows.element(&prepared.mesh, element)?;
    }
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
    for element in &plan.elements {
        sink.bytes(format!("element {} {}\n", element.name, element.count).as_bytes());
        for property in &element.properties {
            sink.bytes(property.declaration().as_bytes());
            sink.checkpoint()?;
        }
    }
    sink.bytes(b"end_header\n");
    Ok(())
}

/// Writes values in one encoding.
struct RowWriter<'a> {
    sink: Sink<'a>,
    encoding: Encoding,
    row_has_values: bool,
}

impl RowWriter<'_> {
    fn element(&mut self, mesh: &PolygonMesh, element: &Element<'_>) -> io::Result<()> {
        match element.properties[..] {
            [] => return Ok(()),
            // Almost all files have just these elements.
            [
                Property { source: Source::Coordinate(0), item, .. },
                Property { source: Source::Coordinate(1), item: second, .. },
                Property { source: Source::Coordinate(2), item: third, .. },
            ] if item.has_fractions() && [second, third] == [item; 2] => return self.points(mesh, item),
            [Property { source: Source::Indices(Scalar::U8), item: Scalar::I32 | Scalar::U32, .. }] => {
                return self.polygons(mesh);
            }
            _ => {}
        }
        for row in 0..element.count {
            for property in &element.properties {
                self.property(mesh, property, row);
            }
            self.end_row()?;
        }
        Ok(())
    }

    /// Writes vertices that have only coordinates, all in one floating-point type.
    fn points(&mut self, mesh: &PolygonMesh, item: Scalar) -> io::Result<()> {
        for &point in mesh.positions() {
            let single = point.map(|x| x as f32);
            match (self.encoding, item) {
                (Encoding::Ascii, _) => point.iter().for_each(|&x| self.real(item, x)),
                (Encoding::LittleEndian, Scalar::F32) => {
                    self.sink.bytes(single.map(f32::to_le_bytes).as_flattened());
                }
                (Encoding::LittleEndian, _) => self.sink.bytes(point.map(f64::to_le_bytes).as_flattened()),
                (Encoding::BigEndian, Scalar::F32) => {
                    self.sink.bytes(single.map(f32::to_be_bytes).as_flattened());
                }
                (Encoding::BigEndian, _) => self.sink.bytes(point.map(f64::to_be_bytes).as_flattened()),
            }
            self.end_row()?;
        }
        Ok(())
    }

    /// Writes faces that have only vertices: a byte for their number, and four bytes for each.
    fn polygons(&mut self, mesh: &PolygonMesh) -> io::Result<()> {
        const LONGEST: usize = 15;
        for face in mesh.faces().faces() {
            let vertices = mesh.faces().face_vertices(face);
            if self.encoding == Encoding::Ascii || vertices.len() > LONGEST {
                self.whole(Scalar::U8, vertices.len() as i64);
                vertices.iter().for_each(|vertex| self.whole(Scalar::U32, i64::from(vertex.0)));
            } else {
                let mut row = [0; 1 + 4 * LONGEST];
                row[0] = vertices.len() as u8;
                for (slot, vertex) in row[1..].as_chunks_mut::<4>().0.iter_mut().zip(vertices) {
                    *slot = match self.encoding {
                        Encoding::BigEndian => vertex.0.to_be_bytes(),
                        _ => vertex.0.to_le_bytes(),
                    };
                }
                self.sink.bytes(&row[..1 + 4 * vertices.len()]);
            }
            self.end_row()?;
        }
        Ok(())
    }

    #[inline]
    fn property(&mut self, mesh: &PolygonMesh, property: &Property<'_>, row: usize) {
        let item = property.item;
        match property.source {
            Source::Coordinate(axis) => self.coordinate(item, mesh.positions()[row][axis]),
            Source::Indices(length) => {
                let vertices = mesh.faces().face_vertices(FaceId::new(row));
                self.whole(length, vertices.len() as i64);
                vertices.iter().for_each(|&vertex| self.whole(item, vertex.index() as i64));
            }
            Source::End(end) => self.whole(item, mesh.loose_edges()[row][end].index() as i64),
            Source::Component(layer, component) => {
                let at = layer.value_of(row).map(|value| value * layer.width() + component);
                self.entry(item, layer.values(), at);
            }
            Source::List(layer, length) => self.list(layer, length, item, row),
            Source::Corners(layer, length) => {
                let corners = mesh.faces().corner_range(FaceId::new(row));
                let count = corner_values(layer, corners.clone());
                self.whole(length, count as i64);
                if count > 0 {
                    corners.for_each(|corner| self.corner(layer, item, corner));
                }
            }
        }
    }

    #[inline]
    fn coordinate(&mut self, item: Scalar, x: f64) {
        if item.has_fractions() {
            self.real(item, x);
        } else {
            self.whole(item, x as i64);
        }
    }

    fn list(&mut self, layer: &Layer, length: Scalar, item: Scalar, row: usize) {
        let Values::Lists { starts, items } = layer.values() else { return };
        let range = match layer.value_of(row) {
            Some(value) => starts[value] as usize..starts[value + 1] as usize,
            None => 0..0,
        };
        self.whole(length, range.len() as i64);
        range.for_each(|at| self.entry(item, items, Some(at)));
    }

    fn corner(&mut self, layer: &Layer, item: Scalar, corner: usize) {
        let (width, value) = (layer.width(), layer.value_of(corner));
        (0..width).for_each(|i| self.entry(item, layer.values(), value.map(|value| value * width + i)));
    }

    /// An entry of a pool. Without an entry it is NaN, or 0 in types without NaN.
    #[inline]
    fn entry(&mut self, item: Scalar, values: &Values, at: Option<usize>) {
        match (item.has_fractions(), at) {
            (true, Some(at)) => self.fraction(item, values, at),
            (true, None) => self.real(item, f64::NAN),
            (false, Some(at)) => self.whole(item, number(values, at) as i64),
            (false, None) => self.whole(item, 0),
        }
    }

    /// A floating-point number to the bit, also if it is a NaN with a payload.
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

    /// A whole number within the range of its type.
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

    /// Writes a blank between values of one row.
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
