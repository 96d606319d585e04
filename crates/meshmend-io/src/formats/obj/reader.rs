//! What the OBJ reader has read so far, and the indices of its statements.

use meshmend_core::NO_VALUE;

use crate::formats::obj::comment_anchors::Anchors;
use crate::formats::obj::loose_parts::LooseParts;
use crate::formats::obj::name_statements::{Elements, KINDS, Runs};
use crate::formats::obj::pools::{Colors, Pool};
use crate::formats::obj::statement_cursor::Cursor;
use crate::input::assemble::{Parts, no_such_vertex};
use crate::input::indices::Uses;
use crate::input::source::Source;
use crate::{Limits, NoteKind, ReadError};

pub(super) struct Reader<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) limits: &'a Limits,
    pub(super) cursor: Cursor<'a>,
    /// Whether a statement, or a comment, was understood.
    pub(super) is_obj: bool,
    pub(super) parts: Parts,
    pub(super) weights: Option<Vec<f64>>,
    pub(super) colors: Colors,
    pub(super) texcoords: Pool,
    pub(super) normals: Pool,
    pub(super) texcoord_uses: Uses,
    pub(super) normal_uses: Uses,
    pub(super) names: [Runs<'a>; KINDS.len()],
    pub(super) loose: LooseParts,
    pub(super) anchors: Anchors,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: &'a Source<'a>, limits: &'a Limits) -> Self {
        let pool = |width| Pool { width, values: Vec::new(), mixed: 0 };
        Reader {
            source,
            limits,
            cursor: Cursor::new(source),
            is_obj: false,
            parts: Parts::default(),
            weights: None,
            colors: Colors::default(),
            texcoords: pool(0),
            normals: pool(3),
            texcoord_uses: Uses::default(),
            normal_uses: Uses::default(),
            names: Default::default(),
            loose: LooseParts::default(),
            anchors: Anchors::default(),
        }
    }

    /// How many elements have been read.
    pub(super) fn elements(&self) -> Elements {
        Elements {
            faces: self.parts.faces.face_count(),
            edges: self.parts.loose_edges.len(),
            points: self.parts.loose_points.len(),
        }
    }

    /// The index of a vertex, counted from 0. Whether it exists is checked at the end, unless it counts back.
    #[inline]
    pub(super) fn vertex_index(&mut self, raw: i64, start: usize) -> Result<u32, ReadError> {
        let count = self.parts.positions.len();
        match resolved(raw, count) {
            Some(index) => {
                self.parts.max_index.see(index, start);
                Ok(index)
            }
            None if raw == 0 => Err(self.cursor.wrong(start, "vertex index 0: the first vertex is 1")),
            None if raw.saturating_abs() == i64::MAX => {
                Err(self.cursor.wrong(start, "a vertex index beyond 64 bits"))
            }
            None => Err(self.cursor.wrong(start, &no_such_vertex(raw, count))),
        }
    }

    /// The index of a texture coordinate or normal, counted from 0. An impossible index is noted and has no value.
    pub(super) fn attribute_index(&mut self, raw: i64, count: usize, start: usize) -> u32 {
        resolved(raw, count).unwrap_or_else(|| {
            self.note_out_of_range(1, start);
            NO_VALUE
        })
    }

    pub(super) fn note_out_of_range(&mut self, count: u64, start: usize) {
        let source = self.source;
        let message = "texture or normal indices that do not exist; the corners have no such value";
        self.parts.notes.add_many(NoteKind::AttributeOutOfRange, message, count, || source.line(start));
    }
}

/// An index counted from 0. In a file, positive indices count from 1, and negative ones back from the count.
#[inline]
fn resolved(raw: i64, count: usize) -> Option<u32> {
    let index = match raw {
        1.. => raw - 1,
        0 => return None,
        _ => raw + count as i64,
    };
    u32::try_from(index).ok().filter(|&index| index != NO_VALUE)
}
