//! Lines as almost all programs write them: three coordinates; a number of corners and as many indices.

use meshmend_core::{FaceTableBuilder, VertexId};

use crate::input::assemble::Highest;
use crate::text::plain_line::Line;
use crate::text::speculative_parse::Rows;

/// Vertices without anything beside their coordinates.
#[derive(Default)]
pub(super) struct Points {
    pub(super) positions: Vec<[f64; 3]>,
}

impl Rows for Points {
    fn none(&self) -> Self {
        Points::default()
    }

    fn clear(&mut self) {
        self.positions.clear();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let mut line = Line::from(text, at);
        let point = line.point()?;
        let end = line.end()?;
        self.positions.push(point);
        Some(end)
    }
}

/// Faces without a colour.
#[derive(Default)]
pub(super) struct Polygons {
    pub(super) faces: FaceTableBuilder,
    pub(super) highest: Highest,
}

impl Rows for Polygons {
    fn none(&self) -> Self {
        Polygons::default()
    }

    fn clear(&mut self) {
        self.faces.clear();
        self.highest = Highest::default();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let before = self.highest;
        let end = self.corners(Line::from(text, at));
        if end.is_some() {
            self.faces.end_face();
        } else {
            self.faces.abandon_face();
            self.highest = before;
        }
        end
    }
}

impl Polygons {
    #[inline]
    fn corners(&mut self, mut line: Line<'_>) -> Option<usize> {
        for _ in 0..line.whole()? {
            let (vertex, at) = line.placed_whole()?;
            self.highest.see(vertex, at);
            self.faces.push_corner(VertexId(vertex));
        }
        line.end()
    }
}
