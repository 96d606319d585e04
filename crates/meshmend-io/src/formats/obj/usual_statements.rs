//! Statements as almost all programs write them: `v` with three coordinates and maybe a colour, `vt`, `vn`, and `f`
//! whose corners all name the same things, by positive indices.

use meshmend_core::{FaceTableBuilder, VertexId};

use crate::formats::obj::pools::{Colors, Pool};
use crate::input::indices::{MaxIndex, Uses};
use crate::text::speculative_parse::UsualRows;
use crate::text::usual_line::UsualLine;

/// The content of usual statements.
#[derive(Default)]
pub(super) struct UsualStatements {
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) colors: Colors,
    pub(super) texcoords: Pool,
    pub(super) normals: Pool,
    pub(super) faces: FaceTableBuilder,
    pub(super) max_index: MaxIndex,
    /// The uses of all corners, or of none.
    pub(super) texcoord_uses: Uses,
    pub(super) normal_uses: Uses,
}

impl UsualRows for UsualStatements {
    fn none(&self) -> Self {
        UsualStatements::default()
    }

    fn clear(&mut self) {
        self.positions.clear();
        self.colors.clear();
        self.texcoords.clear();
        self.normals.clear();
        self.faces.clear();
        self.max_index = MaxIndex::default();
        self.texcoord_uses.clear();
        self.normal_uses.clear();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let mut line = UsualLine::from(text, at);
        if line.accept(b"v") {
            self.vertex(line)
        } else if line.accept(b"f") {
            self.face(line)
        } else if line.accept(b"vn") {
            let normal = line.point()?;
            let end = line.end()?;
            self.normals.push(&normal);
            Some(end)
        } else if line.accept(b"vt") {
            self.texcoord(line)
        } else {
            None
        }
    }
}

impl UsualStatements {
    #[inline]
    fn vertex(&mut self, mut line: UsualLine<'_>) -> Option<usize> {
        let point = line.point()?;
        if line.has_more() {
            let [r, g, b] = line.point()?;
            let alpha = if line.has_more() { Some(line.real()?) } else { None };
            line.end()?;
            let width = if alpha.is_some() { 4 } else { 3 };
            self.colors.set(self.positions.len(), [r, g, b, alpha.unwrap_or(1.0)], width);
        }
        self.positions.push(point);
        line.end()
    }

    /// One to three numbers, as many as the other statements have.
    fn texcoord(&mut self, mut line: UsualLine<'_>) -> Option<usize> {
        let (mut numbers, mut count) = ([0.0; 3], 0);
        while line.has_more() {
            *numbers.get_mut(count)? = line.real()?;
            count += 1;
        }
        let is_like_others = count > 0 && [0, count].contains(&self.texcoords.width);
        let end = line.end().filter(|_| is_like_others)?;
        self.texcoords.push(&numbers[..count]);
        Some(end)
    }

    #[inline]
    fn face(&mut self, line: UsualLine<'_>) -> Option<usize> {
        let before = (self.max_index, self.texcoord_uses.mark(), self.normal_uses.mark());
        let end = self.corners(line).filter(|_| self.corners_are_alike());
        if end.is_some() {
            self.faces.end_face();
        } else {
            self.faces.abandon_face();
            self.max_index = before.0;
            self.texcoord_uses.return_to(before.1);
            self.normal_uses.return_to(before.2);
        }
        end
    }

    /// Whether all corners of all faces name a texture coordinate or none does, and likewise for normals.
    #[inline]
    fn corners_are_alike(&self) -> bool {
        let corners = self.faces.corner_count();
        [&self.texcoord_uses, &self.normal_uses].iter().all(|uses| uses.is_empty() || uses.len() == corners)
    }

    #[inline]
    fn corners(&mut self, mut line: UsualLine<'_>) -> Option<usize> {
        while line.has_more() {
            let start = line.at;
            let vertex = line.digits()?.checked_sub(1)?;
            self.max_index.see(vertex, start);
            self.faces.push_corner(VertexId(vertex));
            if line.accept_byte(b'/') {
                self.attributes(&mut line, start)?;
            }
            if !line.word_ended() {
                return None;
            }
        }
        line.end()
    }

    /// What follows the slash after the vertex of a corner: `t`, `t/n` or `/n`.
    #[inline]
    fn attributes(&mut self, line: &mut UsualLine<'_>, start: usize) -> Option<()> {
        let mut has_normal = line.accept_byte(b'/');
        if !has_normal {
            self.texcoord_uses.push(line.digits()?.checked_sub(1)?, start);
            has_normal = line.accept_byte(b'/');
        }
        if has_normal {
            self.normal_uses.push(line.digits()?.checked_sub(1)?, start);
        }
        Some(())
    }
}
