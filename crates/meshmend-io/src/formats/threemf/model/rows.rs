//! The attributes of a vertex and of a triangle.

use meshmend_core::VertexId;

use crate::formats::threemf::xml::{Tag, attributes, unescaped};
use crate::text::{digits, real, shown, trimmed};

/// What a row says of a triangle.
pub(super) struct Triangle {
    pub(super) vertices: [VertexId; 3],
    pub(super) group: Option<u32>,
    pub(super) members: [Option<u32>; 3],
}

const NO_ATTRIBUTES: &str = "what stands there are no attributes";

/// The position that a row gives a vertex.
///
/// # Errors
/// The reason why it gives none.
#[inline]
pub(super) fn vertex(tag: &Tag<'_>) -> Result<[f64; 3], String> {
    let mut found = [None; 3];
    for attribute in attributes(tag.text, tag.name_end) {
        let attribute = attribute.map_err(|_| NO_ATTRIBUTES)?;
        let axis = match attribute.name {
            "x" => 0,
            "y" => 1,
            "z" => 2,
            _ => continue,
        };
        let value = coordinate(attribute.value).ok_or_else(|| no_number(attribute.name, attribute.value))?;
        if found[axis].replace(value).is_some() {
            return Err(twice(attribute.name));
        }
    }
    match found {
        [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
        [None, ..] => Err(missing("x")),
        [_, None, _] => Err(missing("y")),
        [.., None] => Err(missing("z")),
    }
}

/// What a row says of a triangle.
///
/// # Errors
/// The reason why it is no triangle.
#[inline]
pub(super) fn triangle(tag: &Tag<'_>) -> Result<Triangle, String> {
    const NAMES: [&str; 7] = ["v1", "v2", "v3", "p1", "p2", "p3", "pid"];
    let mut found = [None; 7];
    for attribute in attributes(tag.text, tag.name_end) {
        let attribute = attribute.map_err(|_| NO_ATTRIBUTES)?;
        let Some(place) = NAMES.iter().position(|name| *name == attribute.name) else { continue };
        let value = index(attribute.value).ok_or_else(|| no_number(attribute.name, attribute.value))?;
        if found[place].replace(value).is_some() {
            return Err(twice(attribute.name));
        }
    }
    let [a, b, c, members @ .., group] = found;
    match [a, b, c] {
        [Some(a), Some(b), Some(c)] => Ok(Triangle { vertices: [a, b, c].map(VertexId), group, members }),
        [None, ..] => Err(missing("v1")),
        [_, None, _] => Err(missing("v2")),
        [.., None] => Err(missing("v3")),
    }
}

#[inline]
fn coordinate(value: &str) -> Option<f64> {
    match real::<f64>(value.as_bytes()) {
        Some((number, length)) if length == value.len() => Some(number),
        _ => {
            let value = unescaped(value)?;
            let value = trimmed(value.as_bytes());
            real::<f64>(value).filter(|&(_, length)| length == value.len()).map(|(number, _)| number)
        }
    }
}

#[inline]
fn index(value: &str) -> Option<u32> {
    whole(value).or_else(|| whole(&unescaped(value)?))
}

#[cold]
fn no_number(name: &str, value: &str) -> String {
    format!("`{name}` is no number: `{}`", shown(value.as_bytes()))
}

#[cold]
fn twice(name: &str) -> String {
    format!("`{name}` stands twice")
}

#[cold]
fn missing(name: &str) -> String {
    format!("`{name}` is missing")
}

/// A text that is a whole number below the greatest.
pub(super) fn whole(text: &str) -> Option<u32> {
    let text = trimmed(text.as_bytes());
    let (number, length) = digits(text)?;
    u32::try_from(number).ok().filter(|&number| length == text.len() && number < u32::MAX)
}
