//! Reading the header: the elements, their properties, and where the values begin.

use crate::formats::ply::property_names::KNOWN_ELEMENTS;
use crate::formats::ply::scalar::Scalar;
use crate::input::assemble::Parts;
use crate::input::source::Source;
use crate::limits::DECLARATIONS;
use crate::text::{self, comment_text, shown};
use crate::{Limits, Place, ReadError};

/// The encoding of the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// An element: rows of these properties.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    /// Where in the file it is declared.
    pub(super) at: usize,
}

/// A property: a number, or a list of numbers after its length.
pub(super) struct Property {
    pub(super) name: String,
    pub(super) length: Option<Scalar>,
    pub(super) item: Scalar,
}

pub(super) struct Header {
    pub(super) form: Form,
    pub(super) elements: Vec<Element>,
    /// Where the values begin.
    pub(super) end: usize,
}

/// Reads the header. Comments become metadata of the parts.
pub(super) fn read(source: &Source<'_>, parts: &mut Parts, limits: &Limits) -> Result<Header, ReadError> {
    let mut reader = HeaderReader { source, form: None, elements: Vec::new(), declarations: 0 };
    let (first, mut at) = next_line(source.bytes, 0, true);
    if text::trimmed(first) != b"ply" {
        return Err(source.malformed(Place::Line(1), "a PLY file begins with the line `ply`"));
    }
    // After a lone CR, the first byte of binary values must not be taken for the LF of a pair.
    let ends_with_pair = source.bytes.get(at.wrapping_sub(1)) == Some(&b'\n');
    while at < source.bytes.len() {
        let start = at;
        let (line, next) = next_line(source.bytes, at, ends_with_pair);
        at = next;
        let words: Vec<&[u8]> = text::words(line).collect();
        match words.first().copied() {
            Some(b"end_header") => return reader.finish(at),
            Some(key @ (b"comment" | b"obj_info")) => {
                let after = text::trimmed_start(line).get(key.len()..).unwrap_or_default();
                let key = if key == b"comment" { "comment" } else { "obj_info" };
                parts.keep_statement(key, comment_text(after), limits, || source.line(start));
            }
            Some(_) => {
                reader.declare(&words, start)?;
                source.limited(DECLARATIONS, reader.declarations, limits.max_declarations)?;
            }
            None => {}
        }
    }
    Err(source.malformed(Place::Byte(source.bytes.len() as u64), "the header has no end"))
}

fn next_line(bytes: &[u8], at: usize, takes_pairs: bool) -> (&[u8], usize) {
    let end = text::line_end(bytes, at);
    let next = if takes_pairs { text::after_line_end(bytes, end) } else { (end + 1).min(bytes.len()) };
    (&bytes[at..end], next)
}

struct HeaderReader<'a> {
    source: &'a Source<'a>,
    form: Option<Form>,
    elements: Vec<Element>,
    /// How many elements and properties there are.
    declarations: u64,
}

impl HeaderReader<'_> {
    fn declare(&mut self, words: &[&[u8]], at: usize) -> Result<(), ReadError> {
        match words {
            [b"format", form, _] => self.format(form, at),
            [b"element", name, count] => self.element(name, count, at),
            [b"property", b"list", length, item, name] => self.property(Some(length), item, name, at),
            [b"property", item, name] => self.property(None, item, name, at),
            _ => {
                Err(self.wrong(at, format!("`{}` is not a statement of a header", shown(&words.join(&b' ')))))
            }
        }
    }

    fn format(&mut self, form: &[u8], at: usize) -> Result<(), ReadError> {
        let known = match form {
            b"ascii" => Form::Ascii,
            b"binary_little_endian" => Form::LittleEndian,
            b"binary_big_endian" => Form::BigEndian,
            _ => return Err(self.wrong(at, format!("`{}` is not a known format", shown(form)))),
        };
        match self.form.replace(known) {
            None => Ok(()),
            Some(_) => Err(self.wrong(at, "a second format".to_owned())),
        }
    }

    fn element(&mut self, name: &[u8], count: &[u8], at: usize) -> Result<(), ReadError> {
        let whole = text::digits(count).filter(|&(value, length)| length == count.len() && value < u64::MAX);
        let Some((count, _)) = whole else {
            return Err(self.wrong(at, format!("`{}` is not a number of elements", shown(count))));
        };
        let name = String::from_utf8_lossy(name).into_owned();
        let is_known = KNOWN_ELEMENTS.contains(&name.as_str());
        if is_known && self.elements.iter().any(|element| element.name == name) {
            return Err(self.wrong(at, format!("a second element `{name}`")));
        }
        self.declarations += 1;
        self.elements.push(Element { name, count, properties: Vec::new(), at });
        Ok(())
    }

    fn property(
        &mut self,
        length: Option<&[u8]>,
        item: &[u8],
        name: &[u8],
        at: usize,
    ) -> Result<(), ReadError> {
        let scalar = |name: &[u8]| {
            Scalar::from_name(name).ok_or_else(|| self.wrong(at, format!("`{}` is not a type", shown(name))))
        };
        let (length, item) = (length.map(scalar).transpose()?, scalar(item)?);
        let name = String::from_utf8_lossy(name).into_owned();
        match self.elements.last_mut() {
            None => Err(self.wrong(at, "a property before the first element".to_owned())),
            Some(element) => {
                element.properties.push(Property { name, length, item });
                self.declarations += 1;
                Ok(())
            }
        }
    }

    fn finish(self, end: usize) -> Result<Header, ReadError> {
        for element in &self.elements {
            let mut names: Vec<&str> = element.properties.iter().map(|p| p.name.as_str()).collect();
            names.sort_unstable();
            if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
                let reason = format!("element `{}` has two properties `{}`", element.name, twice[0]);
                return Err(self.wrong(element.at, reason));
            }
        }
        let missing = || self.source.malformed(Place::Byte(end as u64), "the header does not say the format");
        let form = self.form.ok_or_else(missing)?;
        Ok(Header { form, elements: self.elements, end })
    }

    fn wrong(&self, at: usize, reason: String) -> ReadError {
        self.source.malformed(self.source.line(at), reason)
    }
}
