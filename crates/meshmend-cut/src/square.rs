//! Opens a torus into a square: along two closed paths that meet in one vertex.
//!
//! ```text
//!     x ── b ── x      the first path, a, goes once round the torus; cut along it the torus is a tube with two copies of
//!     │         │      each of its vertices, and the second path, b, is the shortest way through the tube from one copy
//!     a         a      of a vertex to the other. Both sides of a cut are as long, edge by edge.
//!     │         │
//!     x ── b ── x
//! ```
//!
//! Neither path has a chord, an edge between two of its vertices that do not follow one another: in the square it
//! would cut off a piece that lies on one side. The second is a shortest one. The first is a shortest one through
//! some vertex, and is sought again from the vertex opposite, until that makes it no shorter: a chord has its ends at
//! equal distances, or nearly, from where the path begins, so the vertex opposite would have a shorter one.

use std::collections::VecDeque;

use meshmend_core::{
    Column, Connectivity, EdgeId, EdgeTable, EdgeUse, Id, PolygonMesh, Provenance, VertexId,
};
use meshmend_topology::{CoTree, GeneratorOptions, Roots, Surface, generators};

use crate::error::CutError;
use crate::open::{CutOpen, CutSeam, cut_open};

/// A torus that was cut open into a square.
#[must_use]
#[derive(Clone, Debug)]
pub struct SquareCut {
    /// The mesh with its cuts open: a disc.
    pub mesh: PolygonMesh,
    /// Where each of its elements came from: faces and corners are the same as before.
    pub provenance: Provenance,
    /// Which sides of the boundary belong together, by ascending edge.
    pub seams: Vec<CutSeam>,
    /// What has become of the vertex in which the two paths meet, ascending.
    pub corners: [VertexId; 4],
}

/// The second path is sought from so many vertices of the first, spread evenly.
const MOST_STARTS: usize = 64;

/// Cuts a torus open along two closed paths that meet in one vertex; `None` for a mesh that is not a single closed
/// torus, or is too coarse for two such paths.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// # use meshmend_cut::cut_to_square;
/// // The torus with seven vertices.
/// let corners = (0..7).flat_map(|i| [i, (i + 1) % 7, (i + 3) % 7, i, (i + 3) % 7, (i + 2) % 7]);
/// let faces = FaceTable::triangles(7, corners.map(VertexId).collect())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 7], faces)?;
/// let square = cut_to_square(&mesh)?.ok_or("no square")?;
/// assert!(square.corners.map(|corner| square.provenance.vertices.of(corner)).iter().all(|&v| v == Some(VertexId(0))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the paths can't be found, which is a mistake of this program.
///
/// *Cost*: that of a few runs of [`generators`](meshmend_topology::generators()), and of up to 64 searches of the
/// mesh.
pub fn cut_to_square(mesh: &PolygonMesh) -> Result<Option<SquareCut>, CutError> {
    let Some(first) = way_round(mesh)? else { return Ok(None) };
    let table = mesh.complex().edges();
    let mut edges = path_edges(table, first.iter().copied().chain(first.first().copied()));
    let tube = cut_open(mesh, &edges)?;
    let Some(second) = way_through(&tube, &first) else { return Ok(None) };
    let (meeting, second) = (second[0], second.iter().filter_map(|&v| tube.provenance.vertices.of(v)));
    edges.extend(path_edges(table, second));
    let CutOpen { mesh, provenance, seams, .. } = cut_open(mesh, &edges)?;
    let copies: Vec<VertexId> =
        provenance.vertices.iter().filter(|&(_, old)| old == Some(meeting)).map(|(new, _)| new).collect();
    let corners = copies.try_into().ok();
    Ok(corners.map(|corners| SquareCut { mesh, provenance, seams, corners }))
}

/// A closed path round a torus without a chord; `None` for any other mesh.
fn way_round(mesh: &PolygonMesh) -> Result<Option<Vec<VertexId>>, CutError> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let (mut best, mut roots): (Option<Vec<VertexId>>, Roots) = (None, Roots::Lowest);
    loop {
        let options = GeneratorOptions { co_tree: CoTree::Greedy, roots, ..GeneratorOptions::default() };
        let found = generators(&kernel, &options)?;
        let [component] = found.components() else { return Ok(None) };
        let is_torus = component.system.is_some_and(|system| system.surface == TORUS);
        let shortest = component.generators.iter().min_by_key(|generator| generator.vertex_count);
        let Some(shortest) = shortest.filter(|_| is_torus) else { return Ok(None) };
        if best.as_ref().is_some_and(|best| best.len() <= shortest.vertex_count) {
            return Ok(best);
        }
        let path = found.vertices(shortest);
        roots = Roots::At(path[path.len() / 2]);
        best = Some(path);
    }
}

const TORUS: Surface = Surface::Orientable { genus: 1, holes: 0 };

/// The edges between the vertices of a path, in its order.
fn path_edges(table: &EdgeTable, path: impl Iterator<Item = VertexId> + Clone) -> Vec<EdgeId> {
    let pairs = path.clone().zip(path.skip(1)).map(|(a, b)| [a.min(b), a.max(b)]);
    pairs.filter_map(|ends| table.all_ends().binary_search(&ends).ok().map(EdgeId::new)).collect()
}

/// The shortest way, by edges, from a vertex of the loop to its copy that touches the tube's rims nowhere else; of
/// equal ones the first.
fn way_through(tube: &CutOpen, first: &[VertexId]) -> Option<Vec<VertexId>> {
    let kernel = EdgeUse::assemble(tube.mesh.complex());
    let before = tube.provenance.before.vertices;
    let mut is_rim = Column::filled(false, kernel.vertex_count());
    let mut copy = Column::filled(None, kernel.vertex_count());
    first.iter().for_each(|&vertex| is_rim[vertex] = true);
    for new in (before..kernel.vertex_count()).map(VertexId::new) {
        is_rim[new] = true;
        if let Some(old) = tube.provenance.vertices.of(new) {
            copy[old] = Some(new);
        }
    }
    let stride = first.len().div_ceil(MOST_STARTS).max(1);
    let ends = first.iter().step_by(stride).filter_map(|&from| Some((from, copy[from]?)));
    let mut best: Option<Vec<VertexId>> = None;
    for (from, to) in ends {
        let way = shortest_way(&kernel, &is_rim, from, to);
        let is_shorter = |way: &Vec<VertexId>| best.as_ref().is_none_or(|best| way.len() < best.len());
        if let Some(way) = way.filter(is_shorter) {
            best = Some(way);
        }
    }
    best
}

/// Breadth first, neighbours in corner order.
fn shortest_way(
    kernel: &EdgeUse,
    is_rim: &Column<VertexId, bool>,
    from: VertexId,
    to: VertexId,
) -> Option<Vec<VertexId>> {
    let mut entry: Column<VertexId, Option<VertexId>> = Column::filled(None, kernel.vertex_count());
    let mut open = VecDeque::from([from]);
    while let Some(vertex) = open.pop_front() {
        if vertex == to {
            let mut way: Vec<VertexId> =
                std::iter::successors(Some(to), |&vertex| entry[vertex].filter(|_| vertex != from)).collect();
            way.reverse();
            return Some(way);
        }
        let neighbours = kernel.vertex_corners(vertex).flat_map(|corner| {
            [kernel.corner_target(corner), kernel.corner_vertex(kernel.prev_corner(corner))]
        });
        for next in neighbours {
            if next != from && entry[next].is_none() && (next == to || !is_rim[next]) {
                entry[next] = Some(vertex);
                open.push_back(next);
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use meshmend_core::PolygonMesh;
    use meshmend_testkit::Soup;
    use meshmend_testkit::shapes::{
        Closed, Shape, Tiles, klein_bottle, seven_vertex_torus, surface, tetrahedron, torus,
    };
    use meshmend_topology::boundary_loops;

    use super::*;

    fn tori() -> Vec<Shape> {
        let mut shapes = vec![seven_vertex_torus(), surface(Closed::Handles(1), 0, 1)];
        for (n, m) in [(3, 3), (3, 5), (7, 4), (8, 8), (12, 11)] {
            shapes.extend([torus(n, m, Tiles::Quads), torus(n, m, Tiles::Triangles)]);
        }
        shapes
    }

    #[test]
    fn a_torus_becomes_a_disc_with_four_corners_and_two_pairs_of_sides() {
        for shape in tori() {
            let mesh = shape.soup.mesh();
            let cut = cut_to_square(&mesh).unwrap().unwrap();
            let rims = boundary_loops(&EdgeUse::assemble(cut.mesh.complex()));
            let [rim] = rims.iter().collect::<Vec<_>>()[..] else { panic!("{}", shape.name) };
            assert_eq!(rim.len(), 2 * cut.seams.len(), "{}", shape.name);
            let places: Vec<usize> =
                (0..rim.len()).filter(|&place| cut.corners.contains(&rim[place])).collect();
            assert_eq!(places.len(), 4, "{}", shape.name);
            // From corner to corner, each side runs over the vertices of the opposite one backwards.
            let old = |place: usize| cut.provenance.vertices.of(rim[place % rim.len()]).unwrap();
            let side = |i: usize| {
                let end = if i == 3 { places[0] + rim.len() } else { places[i + 1] };
                (places[i]..=end).map(old).collect::<Vec<_>>()
            };
            for i in 0..4 {
                let end = if i == 3 { places[0] + rim.len() } else { places[i + 1] };
                let side: Vec<VertexId> = (places[i]..=end).map(|place| rim[place % rim.len()]).collect();
                assert_eq!(chords(&cut.mesh, &side), 0, "{}", shape.name);
            }
            for i in 0..2 {
                let mut opposite = side(i + 2);
                opposite.reverse();
                assert_eq!(side(i), opposite, "{}", shape.name);
            }
        }
    }

    /// A torus of four columns, each as many edges high but for one, which is an edge shorter.
    fn with_a_short_column(short: u32, rows: u32) -> Soup {
        let at = |column: u32, row: u32| (row % rows) * 4 + column % 4;
        let between =
            |column: u32, row: u32| (row == 0 && column % 4 != short).then_some(4 * rows + column % 4);
        let face = |column: u32, row: u32| -> Vec<u32> {
            let right = [Some(at(column + 1, row)), between(column + 1, row), Some(at(column + 1, row + 1))];
            let left = [Some(at(column, row + 1)), between(column, row), Some(at(column, row))];
            right.into_iter().chain(left).flatten().collect()
        };
        let cells = (0..rows).flat_map(|row| (0..4).map(move |column| (column, row)));
        Soup::generic(4 * rows as usize + 4, cells.map(|(column, row)| face(column, row)))
    }

    #[test]
    fn the_paths_meet_where_the_second_is_shortest() {
        for short in 0..4 {
            let mesh = with_a_short_column(short, 5).mesh();
            let cut = cut_to_square(&mesh).unwrap().unwrap();
            assert_eq!(cut.seams.len(), 4 + 5);
            let meeting = cut.corners.map(|corner| cut.provenance.vertices.of(corner).unwrap().0 % 4);
            assert_eq!(meeting, [short; 4]);
        }
    }

    #[test]
    fn of_second_paths_as_short_the_one_from_where_the_first_begins_is_taken() {
        let mesh = torus(4, 6, Tiles::Quads).soup.mesh();
        let first = way_round(&mesh).unwrap().unwrap();
        let cut = cut_to_square(&mesh).unwrap().unwrap();
        assert_eq!(cut.corners.map(|corner| cut.provenance.vertices.of(corner)), [Some(first[0]); 4]);
    }

    /// Four faces side by side round a tube whose ends are joined with half a turn. The shortest way round is along
    /// the joint, and all that leaves it at one vertex comes back at the opposite one.
    #[test]
    fn a_torus_too_coarse_for_a_second_path_has_no_square() {
        let face = |i: u32| {
            let next = (i + 1) % 4;
            [i, next, 4 + next, 8 + next, (next + 2) % 4, (i + 2) % 4, 8 + i, 4 + i]
        };
        let mesh = Soup::generic(12, (0..4).map(face)).mesh();
        assert_eq!(way_round(&mesh).unwrap().map(|path| path.len()), Some(4));
        assert!(cut_to_square(&mesh).unwrap().is_none());
    }

    /// How many edges join two vertices of a path that do not follow one another.
    fn chords(mesh: &PolygonMesh, path: &[VertexId]) -> usize {
        let place = |vertex: &VertexId| path.iter().position(|on| on == vertex);
        let is_chord = |ends: &&[VertexId; 2]| match ends.each_ref().map(place) {
            [Some(one), Some(other)] => one.abs_diff(other) > 1,
            _ => false,
        };
        mesh.complex().edges().all_ends().iter().filter(is_chord).count()
    }

    /// A torus of nine vertices. The shortest way round through its lowest one has four and a chord.
    #[test]
    fn the_first_path_is_sought_again_until_it_has_no_chord() {
        let faces = "413 103 524 264 253 230 563 847 437 548 658 673 168 614 276 728 820 018".split(' ');
        let faces = faces.map(|face| face.bytes().map(|digit| u32::from(digit - b'0')).collect::<Vec<_>>());
        let mesh = Soup::generic(9, faces).mesh();
        let path = way_round(&mesh).unwrap().unwrap();
        // The edge from the path's end to its beginning is none.
        assert_eq!(chords(&mesh, &path), 1, "{path:?}");
    }

    #[test]
    fn what_is_no_closed_torus_has_no_square() {
        let shapes = [tetrahedron(), klein_bottle(4, 4, Tiles::Quads), surface(Closed::Handles(1), 1, 0)];
        for shape in shapes {
            assert!(cut_to_square(&shape.soup.mesh()).unwrap().is_none(), "{}", shape.name);
        }
    }
}
