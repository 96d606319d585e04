//! The tags of a text, one after the other.

use std::ops::Range;

use meshmend_core::printable;
use quick_xml::Reader;
use quick_xml::events::Event;

use super::attributes::{Attribute, attributes, unescaped};
use super::namespaces::{Namespaces, Space};
use crate::formats::threemf::package::Fault;
use crate::text::{shown, text_start};

/// A start tag, or an empty one.
#[derive(Clone, Debug)]
pub(in crate::formats::threemf) struct Tag<'a> {
    pub(in crate::formats::threemf) space: Space,
    /// Its name without a prefix.
    pub(in crate::formats::threemf) local: &'a str,
    /// Its bytes, with the brackets.
    pub(in crate::formats::threemf) place: Range<usize>,
    pub(in crate::formats::threemf) is_empty: bool,
    /// The text between the brackets, without the `/` of an empty tag.
    pub(in crate::formats::threemf) text: &'a str,
    /// Where in it the attributes begin.
    pub(in crate::formats::threemf) name_end: usize,
}

impl<'a> Tag<'a> {
    pub(in crate::formats::threemf) fn is(&self, space: Space, local: &str) -> bool {
        self.space == space && self.local == local
    }

    /// Its name with a prefix.
    pub(in crate::formats::threemf) fn name(&self) -> &'a str {
        &self.text[..self.name_end]
    }
}

/// Reads the tags of a text in order.
pub(in crate::formats::threemf) struct Scanner<'a> {
    text: &'a str,
    /// Where the first byte is that the reader below sees.
    start: usize,
    reader: Reader<&'a [u8]>,
    namespaces: Namespaces<'a>,
    depth: usize,
    /// The end tag that was met last.
    closed: Range<usize>,
    entry: &'a str,
}

/// How deep tags may stand in tags.
const DEEPEST: usize = 64;

enum Token<'a> {
    Open(Tag<'a>),
    Close,
    End,
}

impl<'a> Scanner<'a> {
    /// The text of an entry of this name.
    pub(in crate::formats::threemf) fn of(text: &'a str, entry: &'a str) -> Self {
        let start = text_start(text.as_bytes());
        let reader = Reader::from_str(&text[start..]);
        let (namespaces, closed) = (Namespaces::default(), 0..0);
        Scanner { text, start, reader, namespaces, depth: 0, closed, entry }
    }

    /// The outermost tag.
    pub(in crate::formats::threemf) fn root(&mut self) -> Result<Tag<'a>, Fault> {
        match self.token()? {
            Token::Open(tag) => Ok(tag),
            Token::Close | Token::End => Err(self.wrong("the text has no element")),
        }
    }

    /// The next tag in a tag, all of whose children before it were read or skipped. `None` behind the last one.
    #[inline]
    pub(in crate::formats::threemf) fn child(&mut self, parent: &Tag<'a>) -> Result<Option<Tag<'a>>, Fault> {
        if parent.is_empty {
            return Ok(None);
        }
        match self.token()? {
            Token::Open(tag) => Ok(Some(tag)),
            Token::Close => Ok(None),
            Token::End => {
                Err(self.wrong(format!("the text ends within `{}`", shown(parent.name().as_bytes()))))
            }
        }
    }

    /// Passes over all that is in a tag.
    pub(in crate::formats::threemf) fn skip(&mut self, tag: &Tag<'a>) -> Result<(), Fault> {
        let outside = self.depth - usize::from(!tag.is_empty);
        while self.depth > outside {
            if matches!(self.token()?, Token::End) {
                return Err(self.wrong(format!("the text ends within `{}`", shown(tag.name().as_bytes()))));
            }
        }
        Ok(())
    }

    /// Passes over the children of a tag, and returns where the text is that stood in it.
    pub(in crate::formats::threemf) fn inside(&mut self, tag: &Tag<'a>) -> Result<Range<usize>, Fault> {
        self.skip(tag)?;
        Ok(self.inner(tag))
    }

    /// Where the text is that stood in a tag whose children were just read.
    pub(in crate::formats::threemf) fn inner(&self, tag: &Tag<'a>) -> Range<usize> {
        if tag.is_empty { tag.place.end..tag.place.end } else { tag.place.end..self.closed.start }
    }

    /// Reads what is behind the outermost tag, which may be comments alone.
    pub(in crate::formats::threemf) fn finish(&mut self) -> Result<(), Fault> {
        match self.token()? {
            Token::End => Ok(()),
            Token::Open(_) | Token::Close => Err(self.wrong("there is a second element behind the first")),
        }
    }

    /// The value of an attribute without a prefix, with its entities resolved.
    pub(in crate::formats::threemf) fn value(
        &self,
        tag: &Tag<'a>,
        name: &str,
    ) -> Result<Option<String>, Fault> {
        self.find(tag, |attribute| attribute.name == name)
    }

    /// The value of an attribute of a vocabulary.
    pub(in crate::formats::threemf) fn value_in(
        &self,
        tag: &Tag<'a>,
        space: Space,
        local: &str,
    ) -> Result<Option<String>, Fault> {
        self.find(tag, |attribute| {
            attribute.name.contains(':') && self.namespaces.resolved(attribute.name) == (space, local)
        })
    }

    fn find(
        &self,
        tag: &Tag<'a>,
        is_wanted: impl Fn(&Attribute<'a>) -> bool,
    ) -> Result<Option<String>, Fault> {
        let mut found = None;
        for attribute in attributes(tag.text, tag.name_end) {
            let attribute = attribute.map_err(|_| self.no_attribute(tag))?;
            if !is_wanted(&attribute) {
                continue;
            }
            let value = unescaped(attribute.value).ok_or_else(|| self.unknown_entity(attribute.value))?;
            if found.replace(value.into_owned()).is_some() {
                return Err(
                    self.wrong(format!("`{}` stands twice in one tag", shown(attribute.name.as_bytes())))
                );
            }
        }
        Ok(found)
    }

    pub(in crate::formats::threemf) fn wrong(&self, reason: impl Into<String>) -> Fault {
        Fault::of_entry(self.entry, reason)
    }

    #[cold]
    pub(in crate::formats::threemf) fn no_attribute(&self, tag: &Tag<'a>) -> Fault {
        self.wrong(format!("no attributes: `{}`", shown(tag.text.as_bytes())))
    }

    #[cold]
    fn unknown_entity(&self, text: &str) -> Fault {
        self.wrong(format!("an entity that XML does not know: `{}`", shown(text.as_bytes())))
    }

    #[inline]
    fn token(&mut self) -> Result<Token<'a>, Fault> {
        // What an empty tag declared held for its own attributes.
        self.namespaces.leave(self.depth);
        loop {
            let from = self.at();
            match self.reader.read_event() {
                Ok(Event::Start(tag)) => {
                    let name = tag.name().as_ref().len();
                    return self.opened(from, name, false);
                }
                Ok(Event::Empty(tag)) => {
                    let name = tag.name().as_ref().len();
                    return self.opened(from, name, true);
                }
                Ok(Event::End(_)) => {
                    self.closed = from..self.at();
                    self.depth -= 1;
                    return Ok(Token::Close);
                }
                Ok(Event::Eof) => return self.ended(),
                Ok(event) => self.pass(&event)?,
                Err(error) => {
                    let reason = printable(&error.to_string());
                    return Err(self.wrong(format!("no well-formed XML: {reason}")));
                }
            }
        }
    }

    fn at(&self) -> usize {
        self.start + self.reader.buffer_position() as usize
    }

    fn ended(&self) -> Result<Token<'a>, Fault> {
        if self.depth == 0 { Ok(Token::End) } else { Err(self.wrong("the text ends within an element")) }
    }

    /// Passes over what is no tag.
    fn pass(&self, event: &Event<'_>) -> Result<(), Fault> {
        match event {
            Event::DocType(_) => Err(self.wrong("a DOCTYPE, which 3MF does not allow")),
            Event::GeneralRef(name) => {
                let text: &str = name;
                let entity = format!("&{text};");
                unescaped(&entity).map(|_| ()).ok_or_else(|| self.unknown_entity(&entity))
            }
            Event::Text(text) if self.depth == 0 && !text.trim().is_empty() => {
                Err(self.wrong("text outside of the model"))
            }
            Event::Decl(declaration) => match declaration.encoding() {
                Some(Ok(name)) if !is_unicode(&name) => {
                    let name = shown(name.as_bytes());
                    Err(self.wrong(format!("the text is in `{name}`; 3MF has UTF-8 and UTF-16")))
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    fn opened(&mut self, from: usize, name_end: usize, is_empty: bool) -> Result<Token<'a>, Fault> {
        let place = from..self.at();
        let inside = self.text.get(place.start + 1..place.end - 1).unwrap_or_default();
        let text = if is_empty { inside.strip_suffix('/').unwrap_or(inside) } else { inside };
        let depth = self.depth + 1;
        if depth > DEEPEST {
            return Err(self.wrong(format!("elements stand in each other more than {DEEPEST} deep")));
        }
        if text.contains("xmlns") {
            self.declare(text, name_end, depth)?;
        }
        let (space, local) = self.namespaces.resolved(text.get(..name_end).unwrap_or_default());
        let tag = Tag { space, local, place, is_empty, text, name_end };
        self.depth = if is_empty { self.depth } else { depth };
        Ok(Token::Open(tag))
    }

    fn declare(&mut self, text: &'a str, name_end: usize, depth: usize) -> Result<(), Fault> {
        for attribute in attributes(text, name_end) {
            let Ok(Attribute { name, value, .. }) = attribute else { break };
            if !self.namespaces.declare(depth, name, value) {
                return Err(self.wrong("more namespaces than any program declares"));
            }
        }
        Ok(())
    }
}

fn is_unicode(encoding: &str) -> bool {
    ["utf-8", "utf8", "utf-16", "us-ascii", "ascii"]
        .iter()
        .any(|known| known.eq_ignore_ascii_case(encoding.trim()))
}
