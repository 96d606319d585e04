//! Lines as almost all programs write them: three coordinates; a number of corners and as many indices.

use meshmend_core::{FaceTableBuilder, VertexId};

use crate::input::indices::MaxIndex;
use crate::text::speculative_parse::UsualRows;
use crate::text::usual_line::UsualLine;

/// Vertices that have only coordinates.
#[derive(Default)]
pub(super) struct UsualVertices {
    pub(super) positions: Vec<[f64; 3]>,
}

impl UsualRows for UsualVertices {
    fn none(&self) -> Self {
        UsualVertices::default()
    }

    fn clear(&mut self) {
        self.positions.clear();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let mut line = UsualLine::from(text, at);
        let point = line.point()?;
        let end = line.end()?;
        self.positions.push(point);
        Some(end)
    }
}

/// Faces without a colour.
#[derive(Default)]
pub(super) struct UsualFaces {
    pub(super) faces: FaceTableBuilder,
    pub(super) max_index: MaxIndex,
}

impl UsualRows for UsualFaces {
    fn none(&self) -> Self {
        UsualFaces::default()
    }

    fn clear(&mut self) {
        self.faces.clear();
        self.max_index = MaxIndex::default();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let before = self.max_index;
        let end = self.corners(UsualLine::from(text, at));
        if end.is_some() {
            self.faces.end_face();
        } else {
            self.faces.abandon_face();
            self.max_index = before;
        }
        end
    }
}

impl UsualFaces {
    #[inline]
    fn corners(&mut self, mut line: UsualLine<'_>) -> Option<usize> {
        for _ in 0..line.whole()? {
            let (vertex, at) = line.placed_whole()?;
            self.max_index.see(vertex, at);
            self.faces.push_corner(VertexId(vertex));
        }
        line.end()
    }
}
