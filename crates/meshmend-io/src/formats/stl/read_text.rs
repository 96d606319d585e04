//! The reader of STL as text. Facets in the usual layout are parsed ahead of it.

use meshmend_core::{Carry, Domain, Layer, Metadata, NO_VALUE, Values, VertexId, counted};

use std::collections::BTreeMap;

use crate::formats::stl::form::SOLID;
use crate::formats::stl::normals::{Recomputed, roughly};
use crate::formats::stl::solid_names::SolidNames;
use crate::formats::stl::usual_facets::UsualFacets;
use crate::input::assemble::Parts;
use crate::input::source::{Parsed, Source};
use crate::shell::NoChoices;
use crate::text::speculative_parse::{SequentialReader, read_speculatively};
use crate::text::{self, is_space};
use crate::{Encoding, Format, Limits, NoteKind, Place, ReadError, Shell};

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let at = text::text_start(source.bytes);
    let mut reader = Reader {
        source,
        limits,
        at,
        parts: Parts::default(),
        solids: Vec::new(),
        is_in_solid: false,
        names: SolidNames::new(source.bytes),
        recomputed: Recomputed::default(),
    };
    read_speculatively(source.bytes, source.pace, &UsualFacets::default(), &mut reader)?;
    reader.finish()
}

struct Reader<'a> {
    source: &'a Source<'a>,
    limits: &'a Limits,
    at: usize,
    parts: Parts,
    /// The first face and the name of each solid.
    solids: Vec<(usize, &'a [u8])>,
    is_in_solid: bool,
    names: SolidNames<'a>,
    recomputed: Recomputed,
}

impl<'a> Reader<'a> {
    /// Reads the next item: a facet, or the beginning or the end of a solid.
    fn item(&mut self) -> Result<(), ReadError> {
        let start = self.next();
        if !self.is_in_solid {
            self.expect("solid")?;
            let name = self.name();
            self.solids.push((self.parts.faces.face_count(), name));
            self.is_in_solid = true;
            Ok(())
        } else if start == self.source.bytes.len() {
            self.is_in_solid = false;
            self.missing_end(start)
        } else if self.accept("facet") {
            self.facet(start)
        } else if self.accept("endsolid") {
            self.pass_end_name();
            self.is_in_solid = false;
            Ok(())
        } else {
            Err(self.unexpected("`facet` or `endsolid`"))
        }
    }

    /// Notes that `endsolid` is missing. If the solid has no facet, the file may have been cut, which is an error.
    fn missing_end(&mut self, at: usize) -> Result<(), ReadError> {
        if self.solids.last().is_none_or(|&(first, _)| first == self.parts.faces.face_count()) {
            return Err(self.wrong(at, "the file ends before the first facet of a solid"));
        }
        let source = self.source;
        self.parts.notes.add(NoteKind::MissingEnd, "`endsolid` is missing", || source.line(at));
        Ok(())
    }

    /// The name of the solid that begins here.
    fn name(&mut self) -> &'a [u8] {
        let start = self.at;
        self.at = self.names.end(start);
        text::trimmed(&self.source.bytes[start..self.at])
    }

    /// Skips the name of the solid that ends here.
    fn pass_end_name(&mut self) {
        let name = self.solids.last().map_or(&b""[..], |&(_, name)| name);
        self.at = self.names.end_of_repeated(self.at, name);
    }

    fn facet(&mut self, start: usize) -> Result<(), ReadError> {
        let normal = self.normal()?;
        self.expect("loop")?;
        let first = self.parts.positions.len();
        while self.accept("vertex") {
            let point = [self.coordinate()?, self.coordinate()?, self.coordinate()?];
            self.parts.faces.push_corner(VertexId(self.parts.positions.len() as u32));
            self.parts.positions.push(point);
        }
        let count = self.parts.positions.len() - first;
        self.expect("endloop")?;
        self.expect("endfacet")?;
        if count < 3 {
            return Err(self.wrong(start, &format!("a facet with {}", counted(count, "vertex"))));
        }
        self.parts.faces.end_face();
        if let [a, b, c] = self.parts.positions[first..] {
            self.recomputed.see(normal, [a, b, c], start);
        }
        let vertices = self.parts.positions.len() as u64;
        self.source.limited("vertices", vertices, self.limits.max_vertices.min(self.limits.max_corners))?;
        self.source.limited("faces", self.parts.faces.face_count() as u64, self.limits.max_faces)
    }

    /// The numbers after `normal`, or zeros if there are not three. It reads up to and with `outer`.
    fn normal(&mut self) -> Result<[f64; 3], ReadError> {
        const MOST_WORDS: usize = 4;
        let is_named = self.accept("normal");
        let (mut numbers, mut found) = ([0.0; MOST_WORDS], 0);
        while !self.accept("outer") {
            if found + usize::from(is_named) == MOST_WORDS {
                return Err(self.unexpected("`outer`"));
            }
            let word = text::word(self.source.bytes, self.at);
            self.at += word.len();
            numbers[found] = roughly(word);
            found += 1;
        }
        let [x, y, z, _] = numbers;
        Ok(if is_named && found == 3 { [x, y, z] } else { [0.0; 3] })
    }

    fn coordinate(&mut self) -> Result<f64, ReadError> {
        let start = self.next();
        let bytes = &self.source.bytes[start..];
        let ended = |length: usize| bytes.get(length).is_none_or(|&b| is_space(b));
        match text::real::<f64>(bytes) {
            Some((value, length)) if ended(length) => {
                self.at += length;
                Ok(value)
            }
            _ => Err(self.unexpected("a number")),
        }
    }

    /// Skips blanks and line ends; the place of the next word.
    #[inline]
    fn next(&mut self) -> usize {
        let bytes = &self.source.bytes[self.at..];
        self.at += bytes.iter().position(|&b| !is_space(b)).unwrap_or(bytes.len());
        self.at
    }

    /// Skips the next word if it is this one, and returns whether it is.
    #[inline]
    fn accept(&mut self, word: &str) -> bool {
        let start = self.next();
        let bytes = &self.source.bytes[start..];
        let is_word =
            bytes.get(..word.len()).is_some_and(|found| found.eq_ignore_ascii_case(word.as_bytes()))
                && bytes.get(word.len()).is_none_or(|&b| is_space(b));
        if is_word {
            self.at += word.len();
        }
        is_word
    }

    #[inline]
    fn expect(&mut self, word: &str) -> Result<(), ReadError> {
        if self.accept(word) { Ok(()) } else { Err(self.unexpected(&format!("`{word}`"))) }
    }

    #[cold]
    fn unexpected(&self, what: &str) -> ReadError {
        let found = text::word(self.source.bytes, self.at);
        if found.is_empty() {
            return self.wrong(self.at, &format!("the file ends where {what} belongs"));
        }
        self.wrong(self.at, &format!("`{}` where {what} belongs", text::shown(found)))
    }

    #[cold]
    fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(self.source.line(at), reason)
    }

    fn finish(mut self) -> Result<Parsed, ReadError> {
        let Some(&(_, first_name)) = self.solids.first() else {
            return Err(self.wrong(self.at, "no solid"));
        };
        let faces = self.parts.faces.face_count();
        self.drop_empty_solids(faces);
        let name = self.solids.first().map_or(first_name, |&(_, name)| name);
        if self.solids.iter().any(|&(_, other)| other != name) {
            self.parts.layers.push(objects(&self.solids, faces));
        } else if !name.is_empty() {
            self.parts.metadata.push(Metadata { key: SOLID.to_owned(), value: name.to_vec() });
        }
        let source = self.source;
        self.recomputed.note(&mut self.parts.notes, |at| source.line(at));
        let (mesh, notes) = self.parts.assemble(source, 0, |at| source.line(at))?;
        let shell = Shell::of_file(Format::Stl, Encoding::Ascii, NoChoices);
        Ok(Parsed::whole(mesh, notes, shell))
    }

    /// Forgets solids without a facet. A single solid is kept: it is that of the file.
    fn drop_empty_solids(&mut self, faces: usize) {
        let count = self.solids.len();
        let ends: Vec<usize> = self.solids.iter().skip(1).map(|&(first, _)| first).chain([faces]).collect();
        let mut ends = ends.iter();
        self.solids.retain(|(first, _)| ends.next().is_some_and(|end| end > first));
        let dropped = if count > 1 { count - self.solids.len() } else { 0 };
        let message = "a solid without a facet was skipped";
        self.parts.notes.add_many(NoteKind::UnusedName, message, dropped as u64, || Place::File);
    }
}

impl SequentialReader<UsualFacets> for Reader<'_> {
    fn at(&self) -> usize {
        self.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        let length = self.source.bytes.len();
        loop {
            self.at = text::skip_space(self.source.bytes, self.at, end);
            let is_missing_end = self.at == length && self.is_in_solid;
            if self.at >= end && !is_missing_end {
                return Ok(());
            }
            self.item()?;
        }
    }

    fn take(&mut self, rows: &UsualFacets, end: usize) {
        let (faces, vertices) = (self.parts.faces.face_count(), self.parts.positions.len());
        let all = vertices + rows.positions.len();
        let is_within = self.limits.hold(all, faces + rows.positions.len() / 3, all);
        if !is_within || !self.is_in_solid {
            return;
        }
        self.parts.positions.extend_from_slice(&rows.positions);
        self.recomputed.see_all(rows.recomputed);
        (vertices as u32..all as u32).step_by(3).for_each(|first| {
            self.parts.faces.push_face([first, first + 1, first + 2].map(VertexId));
        });
        self.at = end;
    }

    fn is_done(&self) -> bool {
        false
    }

    fn look(&self) -> Result<(), ReadError> {
        self.source.look(self.at)
    }
}

/// The names of several solids as a face layer. A face of a solid without a name has no value.
fn objects(solids: &[(usize, &[u8])], faces: usize) -> Layer {
    let (mut pool, mut known, mut uses) = (Vec::new(), BTreeMap::new(), vec![NO_VALUE; faces]);
    let ends = solids.iter().skip(1).map(|&(first, _)| first).chain([faces]);
    for (&(first, name), end) in solids.iter().zip(ends) {
        if name.is_empty() || first == end {
            continue;
        }
        let value = *known.entry(name).or_insert_with(|| {
            pool.push(name.to_vec());
            pool.len() as u32 - 1
        });
        uses[first..end].fill(value);
    }
    Layer::indexed("object", Domain::Face, 1, Carry::Copy, Values::Text(pool), uses)
}
