//! The surface is cut along a closed walk.
//!
//! ```text
//!      ── v ── v' ──               ── v ── v' ──     the left side keeps its vertices,
//!                          →          (holes)
//!                                  ── w ── w' ──     the right side gets others
//! ```

use crate::place::Place;
use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, HalfKey, Key, Refused, VertexKey};

impl Editor {
    /// Whether the surface can be cut along a closed walk.
    ///
    /// # Errors
    /// `stale`; `not-a-loop` unless each half-edge begins where the one before ends, the first one where the last one ends, and
    /// there are three different vertices or more; `touches-hole` for each vertex on the boundary; `full`.
    pub fn can_cut_loop(&self, halves: &[HalfKey]) -> Result<(), Refused> {
        self.fresh(halves.iter().map(|&half| Key::Half(half)))?;
        let mut vertices: Vec<VertexKey> = halves.iter().map(|&half| self.halves[half].origin).collect();
        let follows = |at: usize| self.target_of(halves[at]) == vertices[(at + 1) % halves.len()];
        let is_closed = (0..halves.len()).all(follows);
        vertices.sort_unstable();
        let is_simple = halves.len() >= 3 && vertices.windows(2).all(|pair| pair[0] != pair[1]);
        if !is_closed || !is_simple {
            return Err(EditRefusal::NotALoop.into());
        }
        let on_hole = vertices.into_iter().filter(|&vertex| self.is_on_boundary(vertex));
        unless(on_hole.map(EditRefusal::TouchesHole).chain(self.full(2 * halves.len())).collect())
    }

    /// Cuts the surface along a closed walk. What lies to its left keeps the vertices, and what lies to its right gets others at
    /// the same points. [`Editor::zip_holes`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_cut_loop`].
    ///
    /// *Cost*: O(n log n) in the length of the walk, and linear in the edges of its vertices.
    pub fn cut_loop(&mut self, halves: &[HalfKey]) -> Result<Done, Refused> {
        self.can_cut_loop(halves)?;
        let count = halves.len();
        let before = |at: usize| (at + count - 1) % count;
        let right_sides: Vec<Vec<HalfKey>> = (0..count)
            .map(|at| {
                let back = self.halves[halves[before(at)]].twin;
                self.star(back).take_while(|&half| half != halves[at]).collect()
            })
            .collect();
        let twins: Vec<HalfKey> = halves.iter().map(|&half| self.halves[half].twin).collect();
        let kept: Vec<VertexKey> = halves.iter().map(|&half| self.halves[half].origin).collect();
        let vertices: Vec<VertexKey> = kept.iter().map(|&vertex| self.add_copy(vertex)).collect();
        right_sides.iter().zip(&vertices).for_each(|(side, &vertex)| self.set_origin(side, vertex));

        let mut edges: Vec<EdgeKey> = Vec::with_capacity(count);
        let (mut left_hole, mut right_hole) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for at in 0..count {
            let left = self.add_half(kept[(at + 1) % count], None, Place::Unknown);
            let right = self.add_half(vertices[at], None, Place::Unknown);
            let edge = self.halves[halves[at]].edge;
            self.pair(halves[at], left, edge);
            edges.push(self.edges.insert(right));
            self.pair(twins[at], right, edges[at]);
            left_hole.push(left);
            right_hole.push(right);
            self.vertices[kept[at]].half = Some(halves[at]);
            self.vertices[vertices[at]].half = Some(right);
        }
        for at in 0..count {
            self.link(left_hole[at], left_hole[before(at)]);
            self.link(right_hole[before(at)], right_hole[at]);
        }
        let undo = Edit::ZipHoles { half: left_hole[0], other: right_hole[0] };
        Ok(Done { vertices, edges, ..Done::undone_by(undo) })
    }

    /// Adds a vertex that is where another one is, and comes from where that does.
    fn add_copy(&mut self, vertex: VertexKey) -> VertexKey {
        let like = self.vertices[vertex];
        self.add_vertex(like.position, like.source, like.place)
    }
}
