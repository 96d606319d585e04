//! Numbers within a statement.

use meshmend_core::Layer;

use crate::layers::number;
use crate::output::sink::Sink;

/// What follows a vertex: the numbers of its texture coordinate and normal.
#[inline]
pub(super) fn attributes(sink: &mut Sink<'_>, texcoord: Option<usize>, normal: Option<usize>) {
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

/// A statement of the numbers of one value.
#[inline]
pub(super) fn values(layer: &Layer, value: usize, statement: &[u8], sink: &mut Sink<'_>) {
    sink.bytes(statement);
    let width = layer.width();
    (0..width).for_each(|i| spaced(sink, number(layer.values(), value * width + i)));
    sink.byte(b'\n');
}

#[inline]
pub(super) fn spaced(sink: &mut Sink<'_>, value: f64) {
    sink.byte(b' ');
    sink.real(value);
}
