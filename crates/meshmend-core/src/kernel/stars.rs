//! The local classes: what an edge's and a vertex's star look like.

use std::ops::Range;

use crate::{Classes, Column, Connectivity, CornerId, EdgeId, Id, VertexId, threads};

/// What an edge is, by the number of sides that run along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum EdgeClass {
    /// One side.
    Boundary,
    /// Two sides.
    Interior,
    /// Three sides or more.
    NonManifold,
}

/// What a vertex is, by the umbrellas of corners round it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VertexClass {
    /// In no face of the complex.
    Unreferenced,
    /// One closed umbrella.
    Disc,
    /// One open fan.
    HalfDisc,
    /// Two umbrellas or more, each closed or open.
    Pinched {
        /// How many.
        umbrellas: u32,
        /// Whether all of them are open fans, so that closing holes makes the vertex manifold.
        boundary_only: bool,
    },
    /// Some edge here has three sides or more.
    Singular,
}

impl VertexClass {
    /// Whether a surface may have such a vertex.
    pub fn is_manifold(self) -> bool {
        matches!(self, VertexClass::Disc | VertexClass::HalfDisc)
    }
}

/// The class of an edge.
///
/// *Cost*: a look at up to three of its corners.
pub fn edge_class<K: Connectivity>(kernel: &K, edge: EdgeId) -> EdgeClass {
    match kernel.edge_corners(edge).take(3).count() {
        0 | 1 => EdgeClass::Boundary,
        2 => EdgeClass::Interior,
        _ => EdgeClass::NonManifold,
    }
}

/// Whether an edge has exactly two sides and both run the same way.
pub fn is_inconsistent<K: Connectivity>(kernel: &K, edge: EdgeId) -> bool {
    let mut sides = kernel.edge_sides(edge);
    match (sides.next(), sides.next(), sides.next()) {
        (Some((_, one)), Some((_, other)), None) => one == other,
        _ => false,
    }
}

/// How the corners at one vertex hang together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Umbrellas {
    /// Classes of corners that share edges at the vertex.
    pub count: u32,
    /// How many edges at the vertex have one side.
    pub boundary_edges: u32,
    /// Whether an edge at the vertex has three sides or more.
    pub singular: bool,
}

/// The umbrellas at a vertex: its corners, joined where they share an edge there, of whatever degree.
///
/// *Cost*: O(d log d) for d corners.
pub fn umbrellas<K: Connectivity>(kernel: &K, vertex: VertexId) -> Umbrellas {
    Star::default().umbrellas(kernel, vertex)
}

/// Vertices that a thread looks at together.
const CHUNK: usize = 1 << 12;

/// The class of every vertex.
///
/// *Cost*: O(Σ d log d) over the vertices' degrees d.
pub fn vertex_classes<K: Connectivity>(kernel: &K) -> Column<VertexId, VertexClass> {
    vertex_classes_in(kernel, 0..kernel.vertex_count()).into()
}

/// The class of each vertex of a range.
///
/// *Cost*: that of [`vertex_classes`] for these vertices.
pub fn vertex_classes_in<K: Connectivity>(kernel: &K, vertices: Range<usize>) -> Vec<VertexClass> {
    let class = |star: &mut Star, v| star.umbrellas(kernel, VertexId::new(v)).class();
    // Threads are not worth starting for a small mesh.
    if vertices.len() <= CHUNK {
        let mut star = Star::default();
        return vertices.map(|v| class(&mut star, v)).collect();
    }
    threads::map_with(vertices, CHUNK, Star::default, class)
}

/// The vertices in some face that are neither disc nor half-disc, ascending, with what they are.
///
/// *Cost*: that of [`vertex_classes`].
pub fn irregular_vertices<K: Connectivity>(kernel: &K) -> Vec<(VertexId, VertexClass)> {
    let chunks = 0..kernel.vertex_count().div_ceil(CHUNK);
    if chunks.len() <= 1 {
        return chunks.flat_map(|chunk| irregular_in_chunk(kernel, chunk)).collect();
    }
    threads::flat_map(chunks, |chunk| irregular_in_chunk(kernel, chunk))
}

/// Whether every edge has one side or two, and every vertex in a face one umbrella.
///
/// *Cost*: that of [`vertex_classes`] up to the first vertex that is neither disc nor half-disc.
pub fn is_manifold<K: Connectivity>(kernel: &K) -> bool {
    let mut chunks = 0..kernel.vertex_count().div_ceil(CHUNK);
    let is_manifold = |chunk| irregular_in_chunk(kernel, chunk).next().is_none();
    if chunks.len() <= 1 { chunks.all(is_manifold) } else { threads::all(chunks, is_manifold) }
}

fn irregular_in_chunk<K: Connectivity>(
    kernel: &K,
    chunk: usize,
) -> impl Iterator<Item = (VertexId, VertexClass)> {
    let mut star = Star::default();
    let vertices = chunk * CHUNK..kernel.vertex_count().min((chunk + 1) * CHUNK);
    let classes = vertices.map(VertexId::new).map(move |v| (v, star.umbrellas(kernel, v).class()));
    classes.filter(|(_, class)| !class.is_manifold() && *class != VertexClass::Unreferenced)
}

impl Umbrellas {
    /// The vertex's class.
    pub fn class(self) -> VertexClass {
        if self.count == 0 {
            VertexClass::Unreferenced
        } else if self.singular {
            VertexClass::Singular
        } else if self.count > 1 {
            // A fan has two edges with one side, a closed umbrella none.
            VertexClass::Pinched {
                umbrellas: self.count,
                boundary_only: self.boundary_edges == 2 * self.count,
            }
        } else if self.boundary_edges == 0 {
            VertexClass::Disc
        } else {
            VertexClass::HalfDisc
        }
    }
}

/// Stars of more corners are counted, not walked round.
const FEW: usize = 16;
/// No place in a star.
const NONE: u8 = u8::MAX;

/// The corners at a vertex with their edges there; reused from vertex to vertex.
#[derive(Default)]
struct Star {
    /// The edges before and after each corner.
    edges: Vec<EdgeId>,
    edge_of_corner: Vec<(EdgeId, u32)>,
    classes: Classes,
}

impl Star {
    fn umbrellas<K: Connectivity>(&mut self, kernel: &K, vertex: VertexId) -> Umbrellas {
        self.edges.clear();
        for corner in kernel.vertex_corners(vertex) {
            let before: CornerId = kernel.prev_corner(corner);
            self.edges.extend([kernel.corner_edge(before), kernel.corner_edge(corner)]);
        }
        self.single_umbrella().unwrap_or_else(|| self.any_umbrellas())
    }

    /// What a disc or half-disc of a few corners is, found by walking from corner to corner across the edges; nothing
    /// where the vertex is anything else.
    fn single_umbrella(&self) -> Option<Umbrellas> {
        let partners = self.partners()?;
        let corners = self.edges.len() / 2;
        // From the first corner across the edge after it.
        let (found, is_closed) = walk(&partners, 1, corners);
        if is_closed {
            let disc = Umbrellas { count: 1, boundary_edges: 0, singular: false };
            return (found == corners).then_some(disc);
        }
        let half_disc = Umbrellas { count: 1, boundary_edges: 2, singular: false };
        (found + walk(&partners, 0, corners).0 + 1 == corners).then_some(half_disc)
    }

    /// For each place of an edge beside a corner the other place where the same edge is, if there are one or two.
    /// Nothing where an edge has more, or there are more corners than a few.
    fn partners(&self) -> Option<[u8; 2 * FEW]> {
        const SLOTS: usize = 4 * FEW;
        if !(2..=2 * FEW).contains(&self.edges.len()) {
            return None;
        }
        let (mut partners, mut table) = ([NONE; 2 * FEW], [NONE; SLOTS]);
        for (at, edge) in self.edges.iter().enumerate() {
            let mut slot = edge.index() % SLOTS;
            while table[slot] != NONE && self.edges[usize::from(table[slot])] != *edge {
                slot = (slot + 1) % SLOTS;
            }
            let first = usize::from(std::mem::replace(&mut table[slot], at as u8));
            if first == usize::from(NONE) {
                continue;
            }
            if partners[first] != NONE {
                return None;
            }
            (partners[first], partners[at]) = (at as u8, first as u8);
        }
        Some(partners)
    }

    fn any_umbrellas(&mut self) -> Umbrellas {
        self.classes.reset(self.edges.len() / 2);
        self.edge_of_corner.clear();
        self.edge_of_corner.extend(self.edges.iter().zip(0..).map(|(&edge, at)| (edge, at / 2)));
        self.edge_of_corner.sort_unstable();
        let mut found = Umbrellas { count: self.edges.len() as u32 / 2, ..Umbrellas::default() };
        for run in self.edge_of_corner.chunk_by(|one, other| one.0 == other.0) {
            match run.len() {
                1 => found.boundary_edges += 1,
                2 => {}
                _ => found.singular = true,
            }
            for pair in run.windows(2) {
                found.count -= u32::from(self.classes.join(pair[0].1, pair[1].1));
            }
        }
        found
    }
}

/// Walks from the first corner across its edge before it (0) or after it (1): how many corners are come to, and
/// whether the first one is the last of them.
fn walk(partners: &[u8; 2 * FEW], start: u8, corners: usize) -> (usize, bool) {
    let mut from = start;
    for found in 0..corners {
        match partners[usize::from(from)] {
            NONE => return (found, false),
            to if to == start ^ 1 => return (found + 1, true),
            to => from = to ^ 1,
        }
    }
    (corners, false)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{Complex, EdgeUse, FaceTable};

    fn kernel(faces: &[[u32; 3]]) -> EdgeUse {
        let corners = faces.iter().flatten().copied().map(VertexId).collect();
        EdgeUse::assemble(&Complex::of(&Arc::new(FaceTable::triangles(9, corners).unwrap())))
    }

    fn class(faces: &[[u32; 3]]) -> VertexClass {
        vertex_classes(&kernel(faces))[VertexId(0)]
    }

    #[test]
    fn a_vertex_is_what_its_umbrellas_say() {
        assert_eq!(class(&[[1, 2, 3]]), VertexClass::Unreferenced);
        assert_eq!(class(&[[0, 1, 2], [0, 2, 3]]), VertexClass::HalfDisc);
        assert_eq!(class(&[[0, 1, 2], [0, 2, 3], [0, 3, 1]]), VertexClass::Disc);
        let two_fans = VertexClass::Pinched { umbrellas: 2, boundary_only: true };
        assert_eq!(class(&[[0, 1, 2], [0, 3, 4]]), two_fans);
        let fan_and_cone = VertexClass::Pinched { umbrellas: 2, boundary_only: false };
        assert_eq!(class(&[[0, 1, 2], [0, 3, 4], [0, 4, 5], [0, 5, 3]]), fan_and_cone);
        assert_eq!(class(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]), VertexClass::Singular);
    }

    #[test]
    fn walking_round_a_vertex_finds_what_counting_finds() {
        let (mut star, mut walked, mut state) = (Star::default(), 0, 1u32);
        for _ in 0..20_000 {
            let mut next = || {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                state >> 16
            };
            // Corners along a path or a ring, now and then with an edge that is another.
            let (corners, ring) = (next() % 19, next() % 2 == 0);
            star.edges.clear();
            for at in 0..corners {
                let after = if ring && at + 1 == corners { 0 } else { at + 1 };
                let both = [at, after].map(|edge| if next() % 40 == 0 { next() % 20 } else { edge });
                star.edges.extend(if next() % 2 == 0 { both } else { [both[1], both[0]] }.map(EdgeId));
            }
            if let Some(found) = star.single_umbrella() {
                walked += 1;
                assert_eq!(found, star.any_umbrellas(), "{:?}", star.edges);
            } else if (1..=16).contains(&corners) {
                let found = star.any_umbrellas().class();
                assert!(!found.is_manifold(), "{found:?} {:?}", star.edges);
            }
        }
        assert!(walked > 5000);
    }

    #[test]
    fn umbrellas_are_counted_with_their_rim() {
        // A fan, a cone and a book of three pages at one vertex each.
        let kernel = kernel(&[[0, 1, 2], [0, 3, 4], [0, 4, 5], [0, 5, 3], [6, 7, 1], [6, 7, 2], [6, 7, 8]]);
        let found = |v| umbrellas(&kernel, VertexId(v));
        assert_eq!(found(0), Umbrellas { count: 2, boundary_edges: 2, singular: false });
        assert_eq!(found(6), Umbrellas { count: 1, boundary_edges: 3, singular: true });
        assert_eq!(found(8), Umbrellas { count: 1, boundary_edges: 2, singular: false });
    }

    #[test]
    fn a_surface_has_discs_and_half_discs_alone() {
        use VertexClass::*;
        let pinched = [true, false].map(|boundary_only| Pinched { umbrellas: 2, boundary_only });
        assert!(Disc.is_manifold() && HalfDisc.is_manifold());
        assert!(!Unreferenced.is_manifold() && !Singular.is_manifold());
        assert!(pinched.iter().all(|class| !class.is_manifold()));
    }

    #[test]
    fn the_way_that_faces_run_does_not_matter_to_vertices() {
        assert_eq!(class(&[[0, 1, 2], [0, 3, 2], [0, 3, 1]]), VertexClass::Disc);
    }

    #[test]
    fn an_edge_is_what_its_sides_say() {
        let kernel = kernel(&[[0, 1, 2], [0, 1, 3], [0, 2, 3], [0, 3, 4], [5, 3, 0]]);
        let classes: Vec<EdgeClass> = kernel.edges().map(|e| edge_class(&kernel, e)).collect();
        let ends = |e: EdgeId| kernel.edge_ends(e).map(|v| v.0);
        assert_eq!((ends(EdgeId(0)), classes[0]), ([0, 1], EdgeClass::Interior));
        assert_eq!((ends(EdgeId(2)), classes[2]), ([0, 3], EdgeClass::NonManifold));
        assert!(is_inconsistent(&kernel, EdgeId(0)) && !is_inconsistent(&kernel, EdgeId(1)));
        assert!(!is_inconsistent(&kernel, EdgeId(2)), "more than two sides are another defect");
    }
}
