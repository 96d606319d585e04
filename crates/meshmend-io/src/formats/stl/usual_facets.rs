//! Facets as almost all programs write them: seven lines, words in lower case, three vertices.

use crate::formats::stl::normals::{Recomputed, roughly};
use crate::text;
use crate::text::speculative_parse::UsualRows;
use crate::text::usual_line::UsualLine;

/// The corners of facets, three each.
#[derive(Default)]
pub(super) struct UsualFacets {
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) recomputed: Recomputed,
}

impl UsualRows for UsualFacets {
    fn none(&self) -> Self {
        UsualFacets::default()
    }

    fn clear(&mut self) {
        self.positions.clear();
        self.recomputed = Recomputed::default();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let Facet { start, normal, corners, end } = facet(text, at)?;
        self.positions.extend_from_slice(&corners);
        self.recomputed.see(normal, corners, start);
        Some(end)
    }

    /// The next line that begins with `facet`, in any case.
    fn next_row(text: &[u8], at: usize) -> usize {
        let mut next = at;
        loop {
            next = text::after_line_end(text, text::line_end(text, next));
            let start = text::skip_space(text, next, text.len());
            if start == text.len() {
                return start;
            }
            if text::word(text, start).eq_ignore_ascii_case(b"facet") {
                return next;
            }
            next = start;
        }
    }
}

/// One facet, and its bytes.
struct Facet {
    start: usize,
    normal: [f64; 3],
    corners: [[f64; 3]; 3],
    end: usize,
}

/// The facet that begins at a byte, after blanks or empty lines.
#[inline]
fn facet(text: &[u8], at: usize) -> Option<Facet> {
    let mut line = UsualLine::from(text, at);
    let start = line.at;
    line.pass(b"facet")?;
    line.pass(b"normal")?;
    // The reader passes over any words up to `outer`, and stops at the first one.
    let mut normal = [0.0; 3];
    for number in &mut normal {
        let is_other = |word: &&[u8]| word.first().is_some_and(|b| !b.eq_ignore_ascii_case(&b'o'));
        *number = roughly(line.pass_any().filter(is_other)?);
    }
    line = UsualLine::from(text, line.end()?);
    line.pass(b"outer")?;
    line.pass(b"loop")?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        line = UsualLine::from(text, line.end()?);
        line.pass(b"vertex")?;
        *corner = line.point()?;
    }
    line = UsualLine::from(text, line.end()?);
    line.pass(b"endloop")?;
    line = UsualLine::from(text, line.end()?);
    line.pass(b"endfacet")?;
    Some(Facet { start, normal, corners, end: line.end()? })
}
