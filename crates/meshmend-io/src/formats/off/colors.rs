//! Colours in OFF: none, an index into a map, three or four bytes, or three or four fractions.
//!
//! Programs print fractions as C++ streams do, such as `0.5 0 1`, so only some numbers have a point. If one number of
//! the file has a point, all colours that can be fractions are fractions.

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, Role, Values};

use crate::text::{self, words};

/// The text of each element's colour.
#[derive(Default)]
pub(super) struct Colors<'a> {
    texts: Vec<(u32, &'a [u8])>,
}

/// The kind of the colours of some elements. All of them have the same kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Indices into a map.
    Indices,
    /// So many bytes each.
    Bytes(usize),
    /// So many fractions each.
    Fractions(usize),
    /// Anything else. It is kept as text.
    Other,
}

/// The name of the layer of indices into a map of colours.
pub(super) const INDEX_LAYER: &str = "color_index";

impl<'a> Colors<'a> {
    /// Keeps the colour of an element, if it has one.
    pub(super) fn add(&mut self, element: usize, text: &'a [u8]) {
        if !text.is_empty() {
            self.texts.push((element as u32, text));
        }
    }

    /// Whether a number of a colour has a point.
    pub(super) fn has_fractions(&self) -> bool {
        let is_color = |text: &&[u8]| matches!(words(text).count(), 3 | 4);
        self.texts().filter(is_color).flat_map(words).any(|word| fraction(word).is_some())
    }

    /// The layer, or `None` if no element has a colour. `fractions_are_usual` means that some number of a colour in
    /// the file has a point.
    pub(super) fn layer(self, domain: Domain, elements: usize, fractions_are_usual: bool) -> Option<Layer> {
        if self.texts.is_empty() {
            return None;
        }
        let (name, width, values) = match self.kind(fractions_are_usual) {
            Kind::Indices => (INDEX_LAYER, 1, Values::I32(self.texts().filter_map(index).collect())),
            Kind::Bytes(width) => ("color", width, Values::U8(self.numbers(width, byte, u8::MAX))),
            Kind::Fractions(width) => ("color", width, Values::F64(self.numbers(width, number, 1.0))),
            Kind::Other => {
                let spelled = |text| words(text).collect::<Vec<_>>().join(&b' ');
                ("color", 1, Values::Text(self.texts().map(spelled).collect()))
            }
        };
        let carry = match (domain, &values) {
            (Domain::Vertex, Values::U8(_) | Values::F64(_) | Values::Text(_)) => Carry::Interpolate,
            _ => Carry::Copy,
        };
        let role = if name == INDEX_LAYER { Role::Plain } else { Role::Color };
        if self.texts.len() == elements {
            return Some(Layer::direct(name, domain, width, carry, values).with_role(role));
        }
        let mut uses = vec![NO_VALUE; elements];
        for (value, &(element, _)) in self.texts.iter().enumerate() {
            uses[element as usize] = value as u32;
        }
        Some(Layer::indexed(name, domain, width, carry, values, uses).with_role(role))
    }

    /// How many colours have three numbers while others have four. They get an opaque fourth number.
    pub(super) fn without_alpha_among_others(&self, fractions_are_usual: bool) -> u64 {
        match self.kind(fractions_are_usual) {
            Kind::Bytes(4) | Kind::Fractions(4) => {
                self.texts().filter(|text| words(text).count() == 3).count() as u64
            }
            _ => 0,
        }
    }

    fn texts(&self) -> impl Iterator<Item = &'a [u8]> {
        self.texts.iter().map(|&(_, text)| text)
    }

    /// All numbers, with an opaque fourth number where it is missing.
    fn numbers<T: Copy>(&self, width: usize, number: impl Fn(&[u8]) -> Option<T>, opaque: T) -> Vec<T> {
        let mut numbers = Vec::with_capacity(self.texts.len() * width);
        for (text, end) in self.texts().zip((1..).map(|count| count * width)) {
            numbers.extend(words(text).filter_map(&number));
            numbers.resize(end, opaque);
        }
        numbers
    }

    fn kind(&self, fractions_are_usual: bool) -> Kind {
        let all = |is_so: &dyn Fn(&[u8]) -> bool| self.texts().all(is_so);
        if all(&|text| index(text).is_some()) {
            return Kind::Indices;
        }
        let most = self.texts().map(|text| words(text).count()).max().unwrap_or(0);
        let is_color = |text: &[u8]| matches!(words(text).count(), 3 | 4);
        // A whole number above 1 can't be a fraction.
        let is_fraction =
            |word: &[u8]| fraction(word).is_some() || byte(word).is_some_and(|value| value <= 1);
        let are_fractions = all(&|text| is_color(text) && words(text).all(is_fraction));
        let are_bytes = all(&|text| is_color(text) && words(text).all(|word| byte(word).is_some()));
        match (are_fractions, are_bytes) {
            (true, true) if !fractions_are_usual => Kind::Bytes(most),
            (true, _) => Kind::Fractions(most),
            (false, true) => Kind::Bytes(most),
            (false, false) => Kind::Other,
        }
    }
}

/// The whole number that a text is, if it is one.
fn index(text: &[u8]) -> Option<i32> {
    let (value, length) = text::integer(text)?;
    i32::try_from(value).ok().filter(|_| length == text.len())
}

/// A byte.
fn byte(word: &[u8]) -> Option<u8> {
    let (value, length) = text::digits(word)?;
    u8::try_from(value).ok().filter(|_| length == word.len())
}

/// A number that is spelled with a point or an exponent.
fn fraction(word: &[u8]) -> Option<f64> {
    let is_whole = word.iter().all(|b| b.is_ascii_digit() || matches!(b, b'-' | b'+'));
    number(word).filter(|_| !is_whole)
}

fn number(word: &[u8]) -> Option<f64> {
    let (value, length) = text::real::<f64>(word)?;
    (length == word.len()).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn colors(texts: &[&'static str]) -> Colors<'static> {
        let mut colors = Colors::default();
        texts.iter().enumerate().for_each(|(i, text)| colors.add(i, text.as_bytes()));
        colors
    }

    fn layer(texts: &[&'static str]) -> Option<Layer> {
        let colors = colors(texts);
        let has_fractions = colors.has_fractions();
        colors.layer(Domain::Face, texts.len(), has_fractions)
    }

    #[test]
    fn colours_of_one_kind_are_numbers_and_others_are_text() {
        assert_eq!(layer(&["", ""]), None);
        assert_eq!(layer(&["1 2 3", "255 0 0"]).unwrap().values(), &Values::U8(vec![1, 2, 3, 255, 0, 0]));
        assert_eq!(layer(&["1 0 01"]).unwrap().values(), &Values::U8(vec![1, 0, 1]));
        let fractions = layer(&["", "0.5 1.0 0. 1e0"]).unwrap();
        assert_eq!((fractions.width(), fractions.values()), (4, &Values::F64(vec![0.5, 1.0, 0.0, 1.0])));
        assert_eq!((fractions.value_of(0), fractions.value_of(1)), (None, Some(0)));
        let mixed = layer(&["17", "1 2 3"]).unwrap();
        assert_eq!(mixed.values(), &Values::Text(vec![b"17".to_vec(), b"1 2 3".to_vec()]));
        for odd in ["256 0 0", "-1 0 0", "1 2", "1 2 3 4 5", "x y z", "0.5 2 0"] {
            assert!(matches!(layer(&[odd]).unwrap().values(), Values::Text(_)), "{odd}");
        }
    }

    #[test]
    fn one_number_with_a_point_makes_the_colours_of_the_file_fractions() {
        let fractions = |values: &[f64]| Values::F64(values.to_vec());
        assert_eq!(
            layer(&["1 0 0", "0.5 0 1"]).unwrap().values(),
            &fractions(&[1.0, 0.0, 0.0, 0.5, 0.0, 1.0])
        );
        assert_eq!(layer(&["1e-05 0 1"]).unwrap().values(), &fractions(&[1e-5, 0.0, 1.0]));
        assert_eq!(layer(&["127.5 0 255.0"]).unwrap().values(), &fractions(&[127.5, 0.0, 255.0]));
        let of_others = colors(&["1 0 0"]).layer(Domain::Face, 1, true).unwrap();
        assert_eq!(of_others.values(), &fractions(&[1.0, 0.0, 0.0]));
        // Bytes that can't be fractions stay bytes, whatever others are.
        let bytes = colors(&["255 0 0", "1 1 1"]).layer(Domain::Face, 2, true).unwrap();
        assert_eq!(bytes.values(), &Values::U8(vec![255, 0, 0, 1, 1, 1]));
    }

    #[test]
    fn a_fourth_number_that_is_missing_is_opaque() {
        let mixed = layer(&["1 2 3", "4 5 6 7"]).unwrap();
        assert_eq!((mixed.width(), mixed.values()), (4, &Values::U8(vec![1, 2, 3, 255, 4, 5, 6, 7])));
        let mixed = layer(&["0.5 0 1 0", "0 0 1"]).unwrap();
        assert_eq!(mixed.values(), &Values::F64(vec![0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0]));
        assert_eq!(colors(&["1 2 3", "4 5 6 7", "0 0 0"]).without_alpha_among_others(false), 2);
        assert_eq!(colors(&["1 2 3", "4 5 6"]).without_alpha_among_others(false), 0);
    }

    #[test]
    fn single_numbers_are_indices() {
        let indices = layer(&["17", "", "-1"]).unwrap();
        assert_eq!((indices.name(), indices.values()), (INDEX_LAYER, &Values::I32(vec![17, -1])));
        assert!(matches!(layer(&["1.5"]).unwrap().values(), Values::Text(_)));
    }
}
