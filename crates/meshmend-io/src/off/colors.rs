//! Colours as OFF has them: nothing, an index into a map, bytes or fractions, from line to line.

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, Values};

use crate::text::{self, words};

/// The text of each element's colour.
pub(super) struct Colors<'a> {
    texts: Vec<(u32, &'a [u8])>,
}

/// What the words of all colours have in common.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Bytes(usize),
    Fractions(usize),
    Other,
}

impl<'a> Colors<'a> {
    pub(super) fn new() -> Self {
        Colors { texts: Vec::new() }
    }

    /// Keeps the colour of an element, if it has one.
    pub(super) fn add(&mut self, element: usize, text: &'a [u8]) {
        if !text.is_empty() {
            self.texts.push((element as u32, text));
        }
    }

    /// The layer, or nothing when no element has a colour.
    pub(super) fn layer(self, domain: Domain, elements: usize) -> Option<Layer> {
        let kind = self.common_kind()?;
        let texts = || self.texts.iter().map(|(_, text)| *text);
        let (width, values) = match kind {
            Kind::Bytes(width) => (width, Values::U8(texts().flat_map(words).filter_map(byte).collect())),
            Kind::Fractions(width) => {
                (width, Values::F64(texts().flat_map(words).filter_map(fraction).collect()))
            }
            Kind::Other => {
                (1, Values::Text(texts().map(|text| words(text).collect::<Vec<_>>().join(&b' ')).collect()))
            }
        };
        let carry = if domain == Domain::Vertex { Carry::Interpolate } else { Carry::Copy };
        if self.texts.len() == elements {
            return Some(Layer::direct("color", domain, width, carry, values));
        }
        let mut uses = vec![NO_VALUE; elements];
        for (value, &(element, _)) in self.texts.iter().enumerate() {
            uses[element as usize] = value as u32;
        }
        Some(Layer::indexed("color", domain, width, carry, values, uses))
    }

    fn common_kind(&self) -> Option<Kind> {
        let mut kinds = self.texts.iter().map(|(_, text)| kind(text));
        let first = kinds.next()?;
        Some(if kinds.all(|kind| kind == first) { first } else { Kind::Other })
    }
}

fn kind(text: &[u8]) -> Kind {
    let width = words(text).count();
    match width {
        3 | 4 if words(text).all(|word| byte(word).is_some()) => Kind::Bytes(width),
        3 | 4 if words(text).all(|word| fraction(word).is_some()) => Kind::Fractions(width),
        _ => Kind::Other,
    }
}

/// A byte, spelled as it is written.
fn byte(word: &[u8]) -> Option<u8> {
    let is_plain = word == b"0" || word.first() != Some(&b'0');
    let (value, length) = text::digits(word)?;
    u8::try_from(value).ok().filter(|_| is_plain && length == word.len())
}

/// A number that is spelled with a point or an exponent.
fn fraction(word: &[u8]) -> Option<f64> {
    let (value, length) = text::real::<f64>(word)?;
    let is_whole = word.iter().all(|b| b.is_ascii_digit() || matches!(b, b'-' | b'+'));
    (length == word.len() && !is_whole).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(texts: &[&'static str]) -> Option<Layer> {
        let mut colors = Colors::new();
        texts.iter().enumerate().for_each(|(i, text)| colors.add(i, text.as_bytes()));
        colors.layer(Domain::Face, texts.len())
    }

    #[test]
    fn colours_of_one_kind_are_numbers_and_others_are_text() {
        assert_eq!(layer(&["", ""]), None);
        assert_eq!(layer(&["1 2 3", "255 0 0"]).unwrap().values(), &Values::U8(vec![1, 2, 3, 255, 0, 0]));
        assert_eq!(layer(&["", "0.5 1.0 0"]).unwrap().values(), &Values::Text(vec![b"0.5 1.0 0".to_vec()]));
        let fractions = layer(&["", "0.5 1.0 0. 1e0"]).unwrap();
        assert_eq!((fractions.width(), fractions.values()), (4, &Values::F64(vec![0.5, 1.0, 0.0, 1.0])));
        assert_eq!((fractions.value_of(0), fractions.value_of(1)), (None, Some(0)));
        let mixed = layer(&["17", "1 2 3"]).unwrap();
        assert_eq!(mixed.values(), &Values::Text(vec![b"17".to_vec(), b"1 2 3".to_vec()]));
        assert!(matches!(layer(&["256 0 0"]).unwrap().values(), Values::Text(_)));
    }
}
