//! The values of attribute layers, comparable.

use meshmend_core::{Layer, Values};

/// One entry of a layer's value. Numbers are the same when they are equal to the bit or both no number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// A number, by its key.
    Number(u64),
    /// A name.
    Text(Vec<u8>),
    /// A list.
    List(Vec<Entry>),
}

/// A number by which it can be compared: all that are no number are one.
pub fn number_key(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

/// The value that each element has in a layer.
pub fn layer_entries(layer: &Layer) -> Vec<Option<Vec<Entry>>> {
    let width = layer.width();
    let value =
        |value: usize| (value * width..(value + 1) * width).map(|at| entry(layer.values(), at)).collect();
    (0..layer.element_count()).map(|element| layer.value_of(element).map(value)).collect()
}

fn entry(values: &Values, at: usize) -> Entry {
    let number = |x: f64| Entry::Number(number_key(x));
    match values {
        Values::I8(v) => number(v[at].into()),
        Values::U8(v) => number(v[at].into()),
        Values::I16(v) => number(v[at].into()),
        Values::U16(v) => number(v[at].into()),
        Values::I32(v) => number(v[at].into()),
        Values::U32(v) => number(v[at].into()),
        Values::F32(v) => number(v[at].into()),
        Values::F64(v) => number(v[at]),
        Values::Text(v) => Entry::Text(v[at].clone()),
        Values::Lists { starts, items } => {
            Entry::List((starts[at]..starts[at + 1]).map(|item| entry(items, item as usize)).collect())
        }
    }
}
