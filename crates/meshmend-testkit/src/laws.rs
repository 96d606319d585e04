//! What any kernel must do, whatever it is made of: laws to be asked for each kernel over each world.
//!
//! What a kernel says is compared with the plain lists of the complex's faces, and edges found anew from those; the
//! shared edge table is not looked at.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;

use meshmend_core::{
    Complex, Connectivity, CornerId, EdgeId, FaceId, Id, ManifoldConnectivity, VertexId, admission,
};

/// Every law of a kernel, over one complex; a complex that the kernel refuses rightly keeps them all.
///
/// # Errors
/// The law that is broken, and where.
pub fn kernel_laws<K: Connectivity>(complex: &Complex) -> Result<(), String> {
    let Some(kernel) = admitted::<K>(complex)? else { return Ok(()) };
    let expected = Expected::of(complex);
    numbering(&kernel, &expected)?;
    faces(&kernel, &expected)?;
    edges(&kernel, &expected)?;
    vertices(&kernel, &expected)?;
    derived_answers(&kernel, &expected)
}

/// The laws of a kernel whose edges have one side or two: `opposite` is the other side, both ways.
///
/// # Errors
/// The law that is broken, and where.
pub fn manifold_laws<K: ManifoldConnectivity>(complex: &Complex) -> Result<(), String> {
    kernel_laws::<K>(complex)?;
    let Some(kernel) = admitted::<K>(complex)? else { return Ok(()) };
    let expected = Expected::of(complex);
    for (corner, &edge) in expected.corner_edge.iter().enumerate() {
        let sides = &expected.edges[edge].1;
        if sides.len() > 2 {
            return Err(format!("a manifold kernel admits e{edge} with {} sides", sides.len()));
        }
        let other = sides.iter().find(|&&side| side != corner).map(|&side| CornerId::new(side));
        same("the opposite side", CornerId::new(corner), kernel.opposite(CornerId::new(corner)), other)?;
    }
    Ok(())
}

/// Whether `heap_bytes` is within a twentieth of what an allocator counted while the kernel was assembled.
///
/// # Errors
/// Both figures, when they differ by more.
pub fn heap_law<K: Connectivity>(kernel: &K, measured: usize) -> Result<(), String> {
    let said = kernel.heap_bytes();
    if said.abs_diff(measured).saturating_mul(20) <= measured {
        Ok(())
    } else {
        Err(format!("{} says {said} bytes, but {measured} were allocated", K::NAME))
    }
}

/// The kernel, or nothing where it refuses for just the reasons that admission gives.
fn admitted<K: Connectivity>(complex: &Complex) -> Result<Option<K>, String> {
    let against = admission(complex, &K::CAPABILITIES);
    match K::build(complex) {
        Ok(_) if !against.is_empty() => Err(format!("{} builds in spite of {against:?}", K::NAME)),
        Ok(kernel) => Ok(Some(kernel)),
        Err(refusal) if against.is_empty() => {
            Err(format!("{} refuses an admitted complex: {refusal}", K::NAME))
        }
        Err(refusal) => {
            same("the refusal's kernel", K::NAME, refusal.kernel, K::NAME)?;
            same("the refusal's reasons", K::NAME, refusal.defects, against)?;
            Ok(None)
        }
    }
}

/// The right answers, from plain lists.
struct Expected {
    vertex_count: usize,
    /// The vertices of each face.
    faces: Vec<Vec<usize>>,
    /// The first corner of each face.
    first: Vec<usize>,
    /// Of each corner its vertex, its face and its edge.
    corner_vertex: Vec<usize>,
    corner_face: Vec<usize>,
    corner_edge: Vec<usize>,
    /// The edges in order of their ends, each with its corners.
    edges: Vec<([usize; 2], Vec<usize>)>,
}

impl Expected {
    fn of(complex: &Complex) -> Self {
        let table = complex.faces();
        let list = |f| table.face_vertices(f).iter().map(|v| v.index()).collect::<Vec<_>>();
        let faces: Vec<Vec<usize>> = table.faces().map(list).collect();
        let (mut first, mut corner_vertex, mut corner_face) = (Vec::new(), Vec::new(), Vec::new());
        let mut by_ends: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (f, face) in faces.iter().enumerate() {
            first.push(corner_vertex.len());
            for (i, &v) in face.iter().enumerate() {
                let target = face[(i + 1) % face.len()];
                by_ends.entry([v.min(target), v.max(target)]).or_default().push(corner_vertex.len());
                corner_vertex.push(v);
                corner_face.push(f);
            }
        }
        let edges: Vec<_> = by_ends.into_iter().collect();
        let mut corner_edge = vec![0; corner_vertex.len()];
        for (e, (_, corners)) in edges.iter().enumerate() {
            corners.iter().for_each(|&corner| corner_edge[corner] = e);
        }
        let vertex_count = table.vertex_count();
        Expected { vertex_count, faces, first, corner_vertex, corner_face, corner_edge, edges }
    }

    fn corners_of(&self, face: usize) -> Vec<CornerId> {
        (0..self.faces[face].len()).map(|i| CornerId::new(self.first[face] + i)).collect()
    }
}

/// Ids are dense and the table's.
fn numbering<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    same("the number of vertices", K::NAME, kernel.vertex_count(), expected.vertex_count)?;
    same("the number of edges", K::NAME, kernel.edge_count(), expected.edges.len())?;
    same("the number of faces", K::NAME, kernel.face_count(), expected.faces.len())?;
    same("the number of corners", K::NAME, kernel.corner_count(), expected.corner_vertex.len())?;
    for corner in kernel.corners() {
        let c = corner.index();
        same("the vertex", corner, kernel.corner_vertex(corner).index(), expected.corner_vertex[c])?;
        same("the face", corner, kernel.corner_face(corner).index(), expected.corner_face[c])?;
        same("the edge", corner, kernel.corner_edge(corner).index(), expected.corner_edge[c])?;
    }
    Ok(())
}

/// Faces partition the corners, in order; next and previous are inverse and go round the face.
fn faces<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    for face in kernel.faces() {
        let corners = expected.corners_of(face.index());
        same("the corners", face, kernel.face_corners(face).collect::<Vec<_>>(), corners.clone())?;
        for (i, &corner) in corners.iter().enumerate() {
            let next = corners[(i + 1) % corners.len()];
            same("the next corner", corner, kernel.next_corner(corner), next)?;
            same("the corner before", next, kernel.prev_corner(next), corner)?;
        }
    }
    Ok(())
}

/// Edges partition the corners, ascending, and each side joins its edge's ends.
fn edges<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    for edge in kernel.edges() {
        let (ends, corners) = &expected.edges[edge.index()];
        same("the ends", edge, kernel.edge_ends(edge).map(Id::index), *ends)?;
        let corners: Vec<_> = corners.iter().copied().map(CornerId::new).collect();
        same("the sides", edge, kernel.edge_corners(edge).collect::<Vec<_>>(), corners)?;
    }
    for corner in kernel.corners() {
        let mut side = [kernel.corner_vertex(corner), kernel.corner_vertex(kernel.next_corner(corner))];
        side.sort_unstable();
        same("the ends of the side", corner, kernel.edge_ends(kernel.corner_edge(corner)), side)?;
    }
    Ok(())
}

/// Vertices partition the corners: ascending, or in rotational order where the kernel says so.
fn vertices<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    let mut at: Vec<Vec<CornerId>> = vec![Vec::new(); expected.vertex_count];
    for (corner, &v) in expected.corner_vertex.iter().enumerate() {
        at[v].push(CornerId::new(corner));
    }
    for vertex in kernel.vertices() {
        let mut corners: Vec<CornerId> = kernel.vertex_corners(vertex).collect();
        if K::CAPABILITIES.ordered_vertex_stars {
            rotational(kernel, vertex, &corners)?;
            corners.sort_unstable();
        }
        same("the corners", vertex, corners, at[vertex.index()].clone())?;
    }
    Ok(())
}

/// Each corner of a star shares an edge at the vertex with the one after it.
fn rotational<K: Connectivity>(kernel: &K, vertex: VertexId, corners: &[CornerId]) -> Result<(), String> {
    let edges = |c: CornerId| [kernel.corner_edge(c), kernel.corner_edge(kernel.prev_corner(c))];
    let meet = |a: CornerId, b: CornerId| edges(a).iter().any(|e| edges(b).contains(e));
    match corners.windows(2).find(|pair| !meet(pair[0], pair[1])) {
        None => Ok(()),
        Some(pair) => {
            Err(format!("{} of {vertex} is followed by {}, which is not next to it", pair[0], pair[1]))
        }
    }
}

/// The answers that are derived from the others.
fn derived_answers<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    let referenced: BTreeSet<usize> = expected.corner_vertex.iter().copied().collect();
    for v in kernel.vertices() {
        same("being referenced", v, kernel.is_referenced(v), referenced.contains(&v.index()))?;
        let faces: Vec<FaceId> = kernel.vertex_corners(v).map(|c| kernel.corner_face(c)).collect();
        same("the faces", v, kernel.vertex_faces(v).collect::<Vec<_>>(), faces)?;
    }
    for f in kernel.faces() {
        let vertices = &expected.faces[f.index()];
        same("being proper", f, kernel.is_proper_face(f), !vertices.is_empty())?;
        same(
            "the vertices",
            f,
            kernel.face_vertices(f).map(Id::index).collect::<Vec<_>>(),
            vertices.clone(),
        )?;
    }
    for e in kernel.edges() {
        let corners = &expected.edges[e.index()].1;
        same("the degree", e, kernel.edge_degree(e), corners.len())?;
        let faces: Vec<usize> = corners.iter().map(|&c| expected.corner_face[c]).collect();
        same("the faces", e, kernel.edge_faces(e).map(Id::index).collect::<Vec<_>>(), faces)?;
    }
    kernel.corners().try_for_each(|c| derived_of_corner(kernel, expected, c))
}

fn derived_of_corner<K: Connectivity>(
    kernel: &K,
    expected: &Expected,
    corner: CornerId,
) -> Result<(), String> {
    let edge: EdgeId = kernel.corner_edge(corner);
    let (ends, sides) = &expected.edges[edge.index()];
    let start = expected.corner_vertex[corner.index()];
    let target = if start == ends[0] { ends[1] } else { ends[0] };
    same("the target", corner, kernel.corner_target(corner).index(), target)?;
    same("running forward", corner, kernel.is_forward(corner), start == ends[0])?;
    let other = match sides[..] {
        [one, other] if one == corner.index() => Some(other),
        [one, _] => Some(one),
        _ => None,
    };
    same("the side across", corner, kernel.across(corner).map(Id::index), other)
}

fn same<T: PartialEq + Debug>(what: &str, place: impl Debug, found: T, expected: T) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("{what} of {place:?} is {found:?} and should be {expected:?}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::catalogue;
    use crate::worlds::{any_table, oriented_triangle_sets};
    use crate::{Soup, shapes};
    use meshmend_core::{Capabilities, EdgeUse};
    use proptest::prelude::*;

    /// The edge-use table with one answer made wrong, or other capabilities.
    struct Broken<const WHICH: u8>(EdgeUse);

    const ADMITS_ALL: u8 = 0;
    const WRONG_NEXT: u8 = 1;
    const WRONG_EDGE_ORDER: u8 = 2;
    const LOSES_A_CORNER: u8 = 3;
    const STRICT: u8 = 4;
    const SAYS_ORDERED: u8 = 5;
    const ENDS_SWAPPED: u8 = 6;
    const NO_ACROSS: u8 = 7;

    impl<const WHICH: u8> Connectivity for Broken<WHICH> {
        const NAME: &'static str = "broken";
        const CAPABILITIES: Capabilities = Capabilities {
            non_manifold_edges: WHICH != STRICT,
            ordered_vertex_stars: WHICH == SAYS_ORDERED,
            ..Capabilities::PERMISSIVE
        };
        fn assemble(complex: &Complex) -> Self {
            Broken(EdgeUse::assemble(complex))
        }
        fn vertex_count(&self) -> usize {
            self.0.vertex_count()
        }
        fn edge_count(&self) -> usize {
            self.0.edge_count()
        }
        fn face_count(&self) -> usize {
            self.0.face_count()
        }
        fn corner_count(&self) -> usize {
            self.0.corner_count()
        }
        fn corner_vertex(&self, corner: CornerId) -> VertexId {
            self.0.corner_vertex(corner)
        }
        fn corner_edge(&self, corner: CornerId) -> EdgeId {
            self.0.corner_edge(corner)
        }
        fn corner_face(&self, corner: CornerId) -> FaceId {
            self.0.corner_face(corner)
        }
        fn next_corner(&self, corner: CornerId) -> CornerId {
            if WHICH == WRONG_NEXT { self.0.prev_corner(corner) } else { self.0.next_corner(corner) }
        }
        fn prev_corner(&self, corner: CornerId) -> CornerId {
            self.0.prev_corner(corner)
        }
        fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
            let [a, b] = self.0.edge_ends(edge);
            if WHICH == ENDS_SWAPPED { [b, a] } else { [a, b] }
        }
        fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
            self.0.face_corners(face)
        }
        fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
            let mut corners: Vec<_> = self.0.edge_corners(edge).collect();
            if WHICH == WRONG_EDGE_ORDER {
                corners.reverse();
            }
            corners.into_iter()
        }
        fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
            self.0.vertex_corners(vertex).skip(usize::from(WHICH == LOSES_A_CORNER && vertex.index() == 1))
        }
        fn heap_bytes(&self) -> usize {
            self.0.heap_bytes()
        }
        fn across(&self, corner: CornerId) -> Option<CornerId> {
            if WHICH == NO_ACROSS { None } else { self.0.across(corner) }
        }
    }

    #[test]
    fn the_default_kernel_keeps_the_laws_on_shapes_and_every_small_mesh() {
        for shape in catalogue() {
            assert_eq!(kernel_laws::<EdgeUse>(&shape.soup.complex()), Ok(()), "{}", shape.name);
        }
        for faces in oriented_triangle_sets(4) {
            assert_eq!(kernel_laws::<EdgeUse>(&Soup::generic(4, &faces).complex()), Ok(()), "{faces:?}");
        }
    }

    #[test]
    fn each_law_finds_the_kernel_that_breaks_it() {
        let cube = shapes::cube().soup.complex();
        assert_eq!(kernel_laws::<Broken<ADMITS_ALL>>(&cube), Ok(()));
        let finds = |result: Result<(), String>, what: &str| {
            let law = result.unwrap_err();
            assert!(law.contains(what), "{law}");
        };
        finds(kernel_laws::<Broken<WRONG_NEXT>>(&cube), "next corner");
        finds(kernel_laws::<Broken<WRONG_EDGE_ORDER>>(&cube), "the sides of e0");
        finds(kernel_laws::<Broken<LOSES_A_CORNER>>(&cube), "the corners of v1");
        finds(kernel_laws::<Broken<ENDS_SWAPPED>>(&cube), "the ends of e0");
        finds(kernel_laws::<Broken<NO_ACROSS>>(&cube), "the side across");
        // Ascending corners of a large fan's hub are in order; those of an octahedron's are not.
        finds(kernel_laws::<Broken<SAYS_ORDERED>>(&shapes::octahedron().soup.complex()), "not next to it");
    }

    #[test]
    fn a_strict_kernel_may_refuse_but_only_for_the_reasons_that_there_are() {
        let book = shapes::book(3).soup.complex();
        assert_eq!(kernel_laws::<Broken<STRICT>>(&book), Ok(()));
        assert!(Broken::<STRICT>::build(&book).is_err());
        assert_eq!(kernel_laws::<Broken<STRICT>>(&shapes::cube().soup.complex()), Ok(()));
    }

    #[test]
    fn the_heap_law_allows_a_twentieth() {
        let kernel = EdgeUse::assemble(&shapes::cube().soup.complex());
        let said = kernel.heap_bytes();
        assert_eq!(heap_law(&kernel, said), Ok(()));
        assert_eq!(heap_law(&kernel, said * 100 / 96), Ok(()));
        assert!(heap_law(&kernel, said * 100 / 94).is_err());
        assert!(heap_law(&kernel, said * 90 / 100).is_err());
    }

    proptest! {
        #[test]
        fn the_default_kernel_keeps_the_laws_on_any_table(soup in any_table(12)) {
            prop_assert_eq!(kernel_laws::<EdgeUse>(&soup.complex()), Ok(()));
        }
    }
}
