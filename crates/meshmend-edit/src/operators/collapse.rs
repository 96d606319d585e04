//! An edge shrinks to a vertex.
//!
//! ```text
//!          b                     b
//!        ╱ │ ╲                 ╱   ╲
//!      c   │h  d      →      c       d       the triangles at the edge become edges,
//!        ╲ │ ╱                 (all at b)    and larger faces there lose a side
//!          a
//! ```
//!
//! *When the surface stays what it is* is the link condition, here in words that hold with boundary and polygons:
//!
//! 1. The vertices joined to both ends are the tips of the triangles at the edge, and two triangles have two tips.
//! 2. No edge lies opposite to both ends in triangles: else two faces would lie on each other, as with a tetrahedron.
//! 3. No face but those at the edge has both ends.
//! 4. The edge is on the boundary if both ends are; and its hole has more than three sides.
//!
//! With a vertex put on every hole and joined to all of it, the fourth follows from the first two, but for ends on two holes.
//!
//! *Source*: T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, *Topology preserving edge contraction*, 1999.

use crate::refusal::unless;
use crate::{Done, EdgeKey, Edit, EditRefusal, Editor, FaceKey, HalfKey, Opening, Refused, VertexKey};

impl Editor {
    /// Whether an edge can shrink to a vertex.
    ///
    /// # Errors
    /// `stale`; `link-condition` with every element at which it fails; `bridge`; `would-close`.
    pub fn can_collapse(&self, half: HalfKey) -> Result<(), Refused> {
        self.fresh([half.into()])?;
        let twin = self.halves[half].twin;
        let (vertices, edges, faces) =
            (self.common_neighbours(half), self.common_opposite_edges(half), self.common_faces(half));
        let mut reasons = Vec::new();
        if !(vertices.is_empty() && edges.is_empty() && faces.is_empty()) {
            reasons.push(EditRefusal::LinkCondition { vertices, edges, faces });
        }
        let ends = [half, twin].map(|half| self.halves[half].origin);
        let is_inside = [half, twin].iter().all(|&half| self.halves[half].face.is_some());
        if is_inside && ends.iter().all(|&end| self.is_on_boundary(end)) {
            reasons.push(EditRefusal::Bridge(self.halves[half].edge));
        }
        let holes = [half, twin].into_iter().filter(|&half| self.halves[half].face.is_none());
        let small = holes.filter(|&half| self.round(half).count() == 3);
        reasons.extend(small.map(EditRefusal::WouldClose));
        unless(reasons)
    }

    /// The vertices joined to both ends that are not the tip of one triangle at the edge.
    fn common_neighbours(&self, half: HalfKey) -> Vec<VertexKey> {
        let [mut one, mut other] = self.of_both_ends(half, |half| Some(self.target_of(half)));
        let sides = [half, self.halves[half].twin].into_iter().filter(|&half| self.triangle(half).is_some());
        let tips: Vec<VertexKey> = sides.map(|half| self.halves[self.halves[half].prev].origin).collect();
        let mut common = common(&mut one, &mut other);
        common.retain(|vertex| tips.iter().filter(|&tip| tip == vertex).count() != 1);
        common
    }

    /// The edges that lie opposite to both ends in triangles.
    fn common_opposite_edges(&self, half: HalfKey) -> Vec<EdgeKey> {
        let opposite = |half| self.triangle(half).map(|_| self.halves[self.halves[half].next].edge);
        let [mut one, mut other] = self.of_both_ends(half, opposite);
        common(&mut one, &mut other)
    }

    /// The faces that have both ends and not the edge.
    fn common_faces(&self, half: HalfKey) -> Vec<FaceKey> {
        let [mut one, mut other] = self.of_both_ends(half, |half| self.halves[half].face);
        let at_edge = [half, self.halves[half].twin].map(|half| self.halves[half].face);
        let mut common = common(&mut one, &mut other);
        common.retain(|&face| !at_edge.contains(&Some(face)));
        common
    }

    /// What there is at the half-edges out of either end of an edge.
    fn of_both_ends<T>(&self, half: HalfKey, at: impl Fn(HalfKey) -> Option<T>) -> [Vec<T>; 2] {
        [half, self.halves[half].twin].map(|half| self.star(half).filter_map(&at).collect())
    }

    /// Shrinks an edge: the vertex that the half-edge leaves becomes the one that it leads to, which is moved to a point.
    /// [`Editor::split_vertex`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_collapse`].
    ///
    /// *Cost*: O(n log n) in the edges of the two vertices.
    pub fn collapse(&mut self, half: HalfKey, point: [f64; 3]) -> Result<Done, Refused> {
        self.can_collapse(half)?;
        let twin = self.halves[half].twin;
        let [gone, kept] = [half, twin].map(|half| self.halves[half].origin);
        let was = [gone, kept].map(|vertex| self.vertices[vertex].position);
        let handed_over: Vec<HalfKey> = self.star(half).collect();
        self.hand_over(&handed_over, gone, kept);

        let from = match self.triangle(half) {
            Some(face) => Opening::Edge(self.shrink_left_triangle(half, face)),
            None => Opening::Corner(self.shorten(half)),
        };
        let to = match self.triangle(twin) {
            Some(face) => Opening::Edge(self.shrink_right_triangle(twin, face)),
            None => Opening::Corner(self.shorten(twin)),
        };
        self.remove_edge(half);
        self.vertices.remove(gone);
        self.vertices[kept].half = Some(from.half());
        self.vertices[kept].position = point;
        let undo = Edit::SplitVertex { from, to, point: was[0] };
        Ok(Done { moved: Some((kept, was[1])), ..Done::undone_by(undo) })
    }

    /// Takes a half-edge out of its face or hole, and gives the one that followed.
    fn shorten(&mut self, half: HalfKey) -> HalfKey {
        let (prev, next) = (self.halves[half].prev, self.halves[half].next);
        self.link(prev, next);
        self.begin_face_elsewhere(half, next);
        next
    }

    /// Makes one edge of the triangle left of the shrinking half-edge: the half-edges across its two other sides become
    /// twins. Gives the one that leaves the vertex.
    fn shrink_left_triangle(&mut self, half: HalfKey, face: FaceKey) -> HalfKey {
        let [kept, gone] = [self.halves[half].next, self.halves[half].prev];
        let [inward, outward] = [kept, gone].map(|half| self.halves[half].twin);
        self.join_across(face, [kept, gone], [inward, outward]);
        self.vertices[self.halves[inward].origin].half = Some(inward);
        outward
    }

    /// The same for the triangle left of its twin.
    fn shrink_right_triangle(&mut self, twin: HalfKey, face: FaceKey) -> HalfKey {
        let [gone, kept] = [self.halves[twin].next, self.halves[twin].prev];
        let [inward, outward] = [gone, kept].map(|half| self.halves[half].twin);
        self.join_across(face, [kept, gone], [outward, inward]);
        self.vertices[self.halves[inward].origin].half = Some(inward);
        outward
    }

    /// Removes a face with two of its half-edges. Those across become twins along the edge of the first of them.
    fn join_across(&mut self, face: FaceKey, [kept, gone]: [HalfKey; 2], across: [HalfKey; 2]) {
        let edges = [kept, gone].map(|half| self.halves[half].edge);
        self.pair(across[0], across[1], edges[0]);
        self.edges.remove(edges[1]);
        self.halves.remove(kept);
        self.halves.remove(gone);
        self.faces.remove(face);
    }
}

/// What is in both lists, ascending.
fn common<T: Ord + Copy>(one: &mut Vec<T>, other: &mut [T]) -> Vec<T> {
    one.sort_unstable();
    one.dedup();
    other.sort_unstable();
    one.iter().copied().filter(|item| other.binary_search(item).is_ok()).collect()
}
