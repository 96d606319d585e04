//! The edge algebra of Guibas and Stolfi: four operators, and the four references an edge that they rest on.
//!
//! ```text
//!               Dest                      A *dart* is an edge looked at one way: (record, r, f).
//!          Lnext │ ╱                      r  quarter turns: 0 along the edge, 1 across it from right to left,
//!                │╱                          2 back along it, 3 across it from left to right
//!      Left  ····┼···→ Right              f  1 when the surface is looked at from its other side
//!                │╲  (Rot⁻¹)
//!                │ ╲                      Rot    turns left by a quarter         x Rot⁴ = x
//!                │  ↖ x                   Sym    turns back, Rot twice
//!               Org                       Flip   goes to the other side          x Flip² = x
//!               ╱ ╲  Onext                Onext  the next dart counter-clockwise out of the same origin
//! ```
//!
//! Rot, Sym and Flip are arithmetic on (r, f). Onext is what a record stores, for its four quarter turns; the four
//! darts on the other side follow from those, so that an edge and its mirror image can't disagree.
//!
//! *Source*: L. Guibas, J. Stolfi, *Primitives for the manipulation of general subdivisions and the computation of
//! Voronoi diagrams*, 1985, §2 and §4.

use meshmend_core::{Array, Column, EdgeId, Id, Per};

/// An edge as seen along one of four directions and from one of two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dart {
    pub(super) edge: EdgeId,
    turn: Turn,
}

/// How a dart lies to its record: quarter turns r in the low two bits, flip f in the third.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Turn(u8);

/// The edges of a subdivision of a surface, each with a label.
#[derive(Clone, Debug, Default)]
pub(super) struct Subdivision<T> {
    quads: Column<EdgeId, Quad<T>>,
}

#[derive(Clone, Copy, Debug)]
struct Quad<T> {
    /// Onext of the dart after r quarter turns: its record, and how it lies to that.
    next: [EdgeId; 4],
    next_turn: [Turn; 4],
    label: T,
}

impl Dart {
    /// What stands for the dart of a vertex that has none: there are always fewer edges.
    pub(super) const NONE: Dart = Dart { edge: EdgeId(u32::MAX), turn: Turn(0) };

    /// The edge as its record has it.
    pub(super) fn along(edge: EdgeId) -> Self {
        Dart { edge, turn: Turn(0) }
    }

    /// Turned left by a quarter: across the edge, from the face on the right to the one on the left.
    #[inline]
    pub(super) fn rot(self) -> Self {
        self.turned(1 + 2 * self.flipped())
    }

    /// Turned right by a quarter.
    #[inline]
    pub(super) fn rot_inverse(self) -> Self {
        self.turned(3 + 2 * self.flipped())
    }

    /// The same edge the other way.
    #[inline]
    pub(super) fn sym(self) -> Self {
        self.turned(2)
    }

    /// The same edge the same way, from the other side of the surface.
    #[inline]
    pub(super) fn flip(self) -> Self {
        Dart { turn: Turn(self.turn.0 ^ 4), ..self }
    }

    /// Quarter turns from the record's own direction.
    #[inline]
    pub(super) fn quarter(self) -> usize {
        usize::from(self.turn.0 & 3)
    }

    /// 1 on the other side of the surface, else 0.
    #[inline]
    pub(super) fn flipped(self) -> u8 {
        self.turn.0 >> 2
    }

    fn turned(self, quarters: u8) -> Self {
        Dart { turn: Turn((self.turn.0 + quarters) & 3 | self.turn.0 & 4), ..self }
    }
}

impl<T> Subdivision<T> {
    /// No edge, and room for so many.
    pub(super) fn with_capacity(edges: usize) -> Self {
        Subdivision { quads: Vec::with_capacity(edges).into() }
    }

    /// Adds an edge by itself, on a sphere of its own: two ends and a single face round it.
    pub(super) fn make_edge(&mut self, label: T) -> EdgeId {
        let (edge, next_turn) = (EdgeId::new(self.quads.len()), [Turn(0), Turn(3), Turn(2), Turn(1)]);
        self.quads.push(Quad { next: [edge; 4], next_turn, label })
    }

    /// The label of an edge.
    #[inline]
    pub(super) fn label(&self, edge: EdgeId) -> &T {
        &self.quads[edge].label
    }

    /// The label of an edge, to be changed.
    pub(super) fn label_mut(&mut self, edge: EdgeId) -> &mut T {
        &mut self.quads[edge].label
    }

    /// The next dart counter-clockwise with the same origin.
    #[inline]
    pub(super) fn onext(&self, dart: Dart) -> Dart {
        let quad = &self.quads[dart.edge];
        let at = (dart.quarter() + usize::from(dart.flipped())) & 3;
        let stored = Dart { edge: quad.next[at], turn: quad.next_turn[at] };
        if dart.flipped() == 0 { stored } else { stored.rot().flip() }
    }

    /// The next dart clockwise with the same origin.
    #[inline]
    pub(super) fn oprev(&self, dart: Dart) -> Dart {
        self.onext(dart.rot()).rot()
    }

    /// The next dart counter-clockwise along the face on the left.
    #[inline]
    pub(super) fn lnext(&self, dart: Dart) -> Dart {
        self.onext(dart.rot_inverse()).rot()
    }

    /// The dart before, along the face on the left.
    #[inline]
    pub(super) fn lprev(&self, dart: Dart) -> Dart {
        self.onext(dart).sym()
    }

    /// Makes one dart follow another along the face on their left: the dual ring about that face is known, and the
    /// ring about the vertex between them.
    ///
    /// When this has been said of every side of every face, holes included, all four references of every edge
    /// have been written: each of the two sides of an edge writes one of either ring.
    pub(super) fn link(&mut self, dart: Dart, following: Dart) {
        self.write_onext(dart.rot_inverse(), following.rot_inverse());
        self.write_onext(following, dart.sym());
    }

    fn write_onext(&mut self, dart: Dart, next: Dart) {
        let (at, stored) = match dart.flipped() {
            0 => (dart.quarter(), next),
            _ => ((dart.quarter() + 1) & 3, next.flip().rot_inverse()),
        };
        let quad = &mut self.quads[dart.edge];
        quad.next[at] = stored.edge;
        quad.next_turn[at] = stored.turn;
    }

    /// How many edges there are.
    pub(super) fn len(&self) -> usize {
        self.quads.len()
    }

    /// The fields of a record that the algebra keeps.
    pub(super) fn arrays(&self) -> [Array; 2] {
        let field = |name, each| Array::new(name, Per::Edge, each, self.capacity());
        [field("Onext", size_of::<[EdgeId; 4]>()), field("turn", size_of::<[Turn; 4]>())]
    }

    /// How many edges there is room for.
    pub(super) fn capacity(&self) -> usize {
        self.quads.capacity()
    }

    /// Bytes on the heap.
    pub(super) fn heap_bytes(&self) -> usize {
        self.quads.heap_bytes()
    }

    /// Every dart: four quarter turns on either side of each edge.
    #[cfg(test)]
    pub(super) fn darts(&self) -> impl Iterator<Item = Dart> {
        self.quads.iter().flat_map(|(edge, _)| (0..8).map(move |turn| Dart { edge, turn: Turn(turn) }))
    }
}

/// Asserts the axioms E1 to E5 and F1 to F5 of an edge algebra for every dart.
#[cfg(test)]
pub(super) fn assert_axioms<T>(edges: &Subdivision<T>) {
    for x in edges.darts() {
        let rot_onext = |dart: Dart| edges.onext(dart.rot());
        let flip_onext = |dart: Dart| edges.onext(dart.flip());
        assert_eq!(x.rot().rot().rot().rot(), x, "E1");
        assert_eq!(rot_onext(rot_onext(x)), x, "E2");
        assert_ne!(x.rot().rot(), x, "E3");
        assert_ne!(x.rot().quarter() % 2, x.quarter() % 2, "E4: Rot exchanges the primal and the dual");
        assert_eq!(edges.onext(x).quarter() % 2, x.quarter() % 2, "E5: Onext does not");
        assert_eq!(x.flip().flip(), x, "F1");
        assert_eq!(flip_onext(flip_onext(x)), x, "F2");
        assert!(ring(edges, x).all(|y| y != x.flip()), "F3");
        assert_eq!(x.flip().rot().flip().rot(), x, "F4");
        assert_eq!(x.flip().quarter() % 2, x.quarter() % 2, "F5");
        assert_eq!((x.rot().rot_inverse(), x.rot_inverse().rot()), (x, x));
        assert_eq!((x.rot().rot(), x.sym().sym()), (x.sym(), x));
        assert_eq!((edges.oprev(edges.onext(x)), edges.lprev(edges.lnext(x))), (x, x));
    }
}

/// The darts from one on counter-clockwise about its origin, once round.
#[cfg(test)]
fn ring<T>(edges: &Subdivision<T>, first: Dart) -> impl Iterator<Item = Dart> {
    std::iter::successors(Some(first), move |&dart| Some(edges.onext(dart)).filter(|&next| next != first))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn subdivision(faces: &[&[Dart]], mut edges: Subdivision<()>) -> Subdivision<()> {
        for face in faces {
            for (place, &dart) in face.iter().enumerate() {
                edges.link(dart, face[(place + 1) % face.len()]);
            }
        }
        edges
    }

    fn two_edges() -> (Subdivision<()>, Dart, Dart) {
        let mut edges = Subdivision::with_capacity(2);
        let (a, b) = (Dart::along(edges.make_edge(())), Dart::along(edges.make_edge(())));
        (edges, a, b)
    }

    /// V − E + F, counting rings; every ring is there once for either side.
    fn euler_number(edges: &Subdivision<()>) -> isize {
        let mut rings: Vec<Vec<usize>> = Vec::new();
        let darts: Vec<Dart> = edges.darts().collect();
        for &dart in &darts {
            let mut places: Vec<usize> =
                ring(edges, dart).map(|x| darts.iter().position(|&y| y == x).unwrap()).collect();
            places.sort_unstable();
            rings.push(places);
        }
        rings.sort();
        rings.dedup();
        (rings.len() / 2) as isize - (darts.len() / 8) as isize
    }

    #[test]
    fn an_edge_by_itself_is_a_sphere() {
        let mut edges = Subdivision::with_capacity(1);
        let edge = Dart::along(edges.make_edge(()));
        assert_axioms(&edges);
        assert_eq!(euler_number(&edges), 2);
        assert_eq!((edges.onext(edge), edges.lnext(edge)), (edge, edge.sym()));
    }

    #[test]
    fn words_round_one_face_give_the_surfaces_of_the_classification() {
        let (edges, a, b) = two_edges();
        let torus = subdivision(&[&[a, b, a.sym(), b.sym()]], edges);
        assert_axioms(&torus);
        assert_eq!(euler_number(&torus), 0);

        // A side that runs the same way again is the edge seen from the other side of the surface.
        let (edges, a, b) = two_edges();
        let klein_bottle = subdivision(&[&[a, b, a.flip(), b.sym()]], edges);
        assert_axioms(&klein_bottle);
        assert_eq!(euler_number(&klein_bottle), 0);

        let (edges, a, b) = two_edges();
        let projective_plane = subdivision(&[&[a, b, a.flip(), b.flip()]], edges);
        assert_axioms(&projective_plane);
        assert_eq!(euler_number(&projective_plane), 1);

        let (edges, a, b) = two_edges();
        let sphere = subdivision(&[&[a, a.sym(), b, b.sym()]], edges);
        assert_axioms(&sphere);
        assert_eq!(euler_number(&sphere), 2);
    }
}
