//! The attributes of vertices, and their order.
//!
//! The format has normals before colours. MeshLab writes colours first, under the same letters. The values decide
//! which order a file has. The normals of MeshLab are sums weighted by angles, so they need not have unit length. But
//! a number beyond a full turn can't belong to a normal, and one below 0 can't belong to a colour.

use std::f64::consts::TAU;

use meshmend_core::{Carry, Domain, Layer, Role, Values};

use crate::NoteKind;
use crate::formats::off::colors::Colors;
use crate::formats::off::letters::Columns;
use crate::formats::off::reader::Reader;
use crate::text::{self, words};

/// The values of all vertices.
#[derive(Default)]
pub(super) struct VertexAttributes<'a> {
    pub(super) normals: Vec<f64>,
    pub(super) texcoords: Vec<f64>,
    /// The texts of normal and colour together, if vertices have both.
    pairs: Vec<&'a [u8]>,
}

impl<'a> VertexAttributes<'a> {
    /// Keeps the colour of a vertex. `start` is where its normal begins, if it has one.
    pub(super) fn add_color(
        &mut self,
        reader: &mut Reader<'a>,
        columns: Columns,
        vertex: usize,
        start: usize,
        color: &'a [u8],
    ) {
        reader.vertex_colors.add(vertex, color);
        if columns.normal {
            self.pairs.push(text::trimmed(&reader.bytes[start..reader.at]));
        }
    }

    /// Adds the layers to the parts of the reader.
    pub(super) fn finish(mut self, columns: Columns, reader: &mut Reader<'a>) {
        if columns.normal && columns.color && has_colors_first(&self.pairs) {
            reader.note(NoteKind::ColumnOrder, "colours stand before normals, as MeshLab writes them");
            let parted = self.pairs.iter().map(|pair| parted(pair, words(pair).count() - 3));
            let (colors, normals): (Vec<_>, Vec<_>) = parted.unzip();
            self.normals = normals.iter().flat_map(|text| numbers(text)).collect();
            reader.vertex_colors = Colors::default();
            colors
                .into_iter()
                .enumerate()
                .for_each(|(vertex, color)| reader.vertex_colors.add(vertex, color));
        }
        let direct = |name, width, values| {
            Layer::direct(name, Domain::Vertex, width, Carry::Interpolate, Values::F64(values))
        };
        let normal = columns.normal.then(|| direct("normal", 3, self.normals).with_role(Role::Normal));
        let texcoord =
            columns.texcoord.then(|| direct("texcoord", 2, self.texcoords).with_role(Role::TexCoord));
        reader.parts.layers.extend([normal, texcoord].into_iter().flatten());
    }
}

/// Whether the colours come first: the numbers make sense in that order, but not in the order of the format.
fn has_colors_first(pairs: &[&[u8]]) -> bool {
    let is_pair =
        |pair: &&[u8]| matches!(words(pair).count(), 6 | 7) && numbers(pair).count() == words(pair).count();
    if pairs.is_empty() || !pairs.iter().all(is_pair) {
        return false;
    }
    let normals_first = Order::of(pairs.iter().map(|pair| parted(pair, 3)));
    let colors_first = Order::of(pairs.iter().map(|pair| {
        let (color, normal) = parted(pair, words(pair).count() - 3);
        (normal, color)
    }));
    let is_wrong = !normals_first.has_normals || !normals_first.has_colors;
    let is_empty = normals_first.has_zeros_alone && colors_first.has_units_alone;
    colors_first.has_normals && colors_first.has_colors && (is_wrong || is_empty)
}

/// What an order of the columns would mean for the values.
struct Order {
    /// Whether every number of a normal is within a full turn.
    has_normals: bool,
    has_zeros_alone: bool,
    has_units_alone: bool,
    /// Whether all colours are bytes, or all of them fractions.
    has_colors: bool,
}

impl Order {
    fn of<'a>(rows: impl Iterator<Item = (&'a [u8], &'a [u8])>) -> Self {
        const SLACK: f64 = 1e-3;
        let (mut bytes, mut fractions) = (true, true);
        let mut order =
            Order { has_normals: true, has_zeros_alone: true, has_units_alone: true, has_colors: true };
        for (normal, color) in rows {
            // A number that is not finite decides nothing.
            order.has_normals &= !numbers(normal).any(|x| x.abs() > TAU + SLACK);
            order.has_zeros_alone &= numbers(normal).all(|x| x == 0.0);
            let square: f64 = numbers(normal).map(|x| x * x).sum();
            order.has_units_alone &= (square.sqrt() - 1.0).abs() <= SLACK;
            bytes &= numbers(color).all(|x| x.fract() == 0.0 && (0.0..=255.0).contains(&x));
            fractions &= numbers(color).all(|x| (0.0..=1.0).contains(&x));
        }
        order.has_colors = bytes || fractions;
        order
    }
}

/// The first words of a text, and the others.
fn parted(text: &[u8], first: usize) -> (&[u8], &[u8]) {
    let next = |at| text::skip_space(text, at, text.len());
    let at = (0..first).fold(next(0), |at, _| next(at + text::word(text, at).len()));
    (text::trimmed(&text[..at]), &text[at..])
}

/// The numbers of a text.
fn numbers(text: &[u8]) -> impl Iterator<Item = f64> {
    words(text).filter_map(text::real::<f64>).map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_format_unless_its_values_say_otherwise() {
        let first = |rows: &[&'static str]| {
            has_colors_first(&rows.iter().map(|row| row.as_bytes()).collect::<Vec<_>>())
        };
        for rows in [
            &["255 0 0 255 0 0 1"][..],
            &["0 0 0 255 0.6 -0.8 0"],
            &["0 0 0 255 0 0 1"],
            &["0 0 0 255 0 0 1", "200 10 10 255 nan nan nan"],
            &["0.5 1 0.2 1 -1 0 0"],
            &["10 20 30 0 0 1"],
            // As MeshLab wrote it.
            &["1 2 3 255 0 0 1.5708", "4 5 6 255 0 0 0.785398"],
            &["1 1 1 1 0 0 -1"],
        ] {
            assert!(first(rows), "{rows:?}");
        }
        for rows in [
            &[][..],
            &["0 0 1 10 20 30"],
            &["0 0 1 255 0 0 255", "0.6 0.8 0 0 0 0 255"],
            &["0 0 5 10 20 30 255"],
            &["0 0 2.5 255 255 255 255"],
            &["0 0 0 255 0 0 255"],
            &["0 0 1 0.5 0.5 0.5 1"],
            &["0 0 1 17"],
            &["255 0 0 255 0 0 1", "0 0 1 0.5 -0.5 300 1"],
        ] {
            assert!(!first(rows), "{rows:?}");
        }
    }

    #[test]
    fn words_are_parted_where_they_are() {
        assert_eq!(parted(b"a  bb c", 2), (&b"a  bb"[..], &b"c"[..]));
        assert_eq!(parted(b"a b", 0), (&b""[..], &b"a b"[..]));
        assert_eq!(parted(b"a b", 5), (&b"a b"[..], &b""[..]));
    }
}
