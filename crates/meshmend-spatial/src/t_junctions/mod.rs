//! Which vertices of the boundary lie on edges of the boundary?
//!
//! A *T-junction* within ε is a boundary vertex and a boundary edge of a face that the vertex is no corner of, where the
//! vertex is not farther than ε from the edge, its foot is strictly between the edge's ends, and it is farther than ε from
//! both. With ε = 0 it is exactly on the edge. Vertices at one position count as one, the lowest. A vertex is *aligned* with
//! an edge when one of its own boundary edges runs along it: when it and another vertex both lie on, or are ends of, both
//! edges. A foreign corner that touches an edge is not.
//!
//! The boundary is that of the mesh whose vertices at one position are joined, degenerate faces set aside. Every yes or no is
//! that of real arithmetic.

mod boundary;
mod near;
mod place;
mod point_tree;

use meshmend_core::{Cancelled, Defect, DefectKind, Element, FaceId, Id, PolygonMesh, VertexId, Watch};
use meshmend_geometry::vector::Point;
use rayon::prelude::*;

pub(crate) use boundary::{Boundary, welded_faces};
pub(crate) use near::{OnEdges, vertices_on_edges};
pub(crate) use place::{compare_distance, is_on, is_thin};
pub(crate) use point_tree::PointTree;

/// A vertex of the boundary on an edge of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TJunction {
    /// The vertex; the lowest at its position.
    pub vertex: VertexId,
    /// The ends of the edge in the direction of its face, each the lowest vertex at its position.
    pub ends: [VertexId; 2],
    /// The face that has the edge.
    pub face: FaceId,
    /// How far the vertex is from the edge, in doubles; 0 if it is asked for those exactly on it.
    pub distance: f64,
    /// Whether a boundary edge of the vertex runs along the edge.
    pub is_aligned: bool,
}

impl TJunction {
    /// The defect, with the edge that the mesh has there, if it has one between vertices at these positions.
    ///
    /// *Cost*: linear in the corners of the face, once the mesh knows its edges.
    pub fn defect(&self, mesh: &PolygonMesh) -> Defect {
        let place = |vertex: VertexId| mesh.position(vertex);
        let ends = self.ends.map(place);
        let (faces, edges) = (mesh.complex().faces(), mesh.complex().edges());
        let sides = faces.face_corners(self.face).map(|corner| edges.corner_edge(corner));
        let is_there = |edge: &_| {
            let [one, other] = edges.ends(*edge).map(place);
            [one, other] == ends || [other, one] == ends
        };
        let mut found = sides.filter(is_there);
        match found.next() {
            Some(edge) => Defect::t_junction(self.vertex, edge, edges.ends(edge), self.is_aligned),
            None => Defect::new(DefectKind::TJunction, Element::Vertex(self.vertex)),
        }
    }
}

/// The T-junctions of a mesh within a distance of at least 0, ordered by vertex and ends.
///
/// # Errors
/// When whoever watches stops it.
///
/// *Cost*: O(n log n + pairs); 100 bytes a boundary edge.
pub fn t_junctions(mesh: &PolygonMesh, within: f64, watch: &Watch) -> Result<Vec<TJunction>, Cancelled> {
    watch.look(STEP, 0, 0)?;
    let boundary = Boundary::welded(mesh, watch)?;
    let on = vertices_on_edges(mesh.positions(), &boundary, within, watch)?;
    watch.look(STEP, 0, 0)?;
    let pairs = on.pairs();
    let found = pairs.par_iter().enumerate().map(|(place, &(edge, vertex))| {
        watch.look_at_times(STEP, place, pairs.len())?;
        Ok(TJunction {
            is_aligned: on.is_aligned(&boundary, edge, vertex),
            distance: if within > 0.0 { distance(mesh.positions(), &boundary, edge, vertex) } else { 0.0 },
            ..junction(&boundary, edge, vertex)
        })
    });
    let mut found = found.collect::<Result<Vec<TJunction>, Cancelled>>()?;
    found.par_sort_unstable_by_key(|junction| (junction.vertex, junction.ends));
    Ok(found)
}

/// What the search is called to whoever watches.
pub(crate) const STEP: &str = "T-junctions";

/// A vertex on a boundary edge, exactly on it and not aligned for all that is known.
pub(crate) fn junction(boundary: &Boundary, edge: u32, vertex: VertexId) -> TJunction {
    let side = boundary.edges()[edge as usize];
    TJunction { vertex, ends: side.ends, face: side.face, distance: 0.0, is_aligned: false }
}

/// How far a vertex is from the line of a boundary edge, in doubles.
pub(crate) fn distance(positions: &[Point], boundary: &Boundary, edge: u32, vertex: VertexId) -> f64 {
    let ends = boundary.edges()[edge as usize].ends;
    place::distance(positions[vertex.index()], ends.map(|end| positions[end.index()]))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    type Whole = [i64; 3];

    fn mesh(points: &[Whole], faces: &[[u32; 3]], scale: f64) -> PolygonMesh {
        let points: Vec<[f64; 3]> = points.iter().map(|point| point.map(|x| x as f64 * scale)).collect();
        PolygonMesh::from_triangles(&points, faces).unwrap()
    }

    fn minus(a: Whole, b: Whole) -> Whole {
        std::array::from_fn(|i| a[i] - b[i])
    }

    fn dot(a: Whole, b: Whole) -> i64 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// The definition, in whole numbers, for a distance of so many halves.
    fn is_on(point: Whole, [from, to]: [Whole; 2], halves: i64) -> bool {
        let (along, off) = (minus(to, from), minus(point, from));
        let (size, foot) = (dot(along, along), dot(off, along));
        let square = dot(off, off) * size - foot * foot;
        let ends = [from, to].map(|end| minus(point, end));
        let is_away = ends.iter().all(|&way| 4 * dot(way, way) > halves * halves);
        0 < foot && foot < size && 4 * square <= halves * halves * size && is_away
    }

    /// The T-junctions by their definition, all vertices at positions of their own.
    fn by_definition(points: &[Whole], faces: &[[u32; 3]], halves: i64) -> Vec<[u32; 3]> {
        let sides = || faces.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
        let is_open = |&[a, b, _]: &[u32; 3]| {
            sides().filter(|&[c, d, _]| [a, b] == [c, d] || [b, a] == [c, d]).count() == 1
        };
        let open: Vec<[u32; 3]> = sides().filter(is_open).collect();
        let mut vertices: Vec<u32> = open.iter().flat_map(|&[a, b, _]| [a, b]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let at = |vertex: u32| points[vertex as usize];
        let pairs = vertices.iter().flat_map(|&v| open.iter().map(move |&edge| (v, edge)));
        let on =
            pairs.filter(|&(v, [a, b, c])| ![a, b, c].contains(&v) && is_on(at(v), [at(a), at(b)], halves));
        let mut found: Vec<[u32; 3]> = on.map(|(v, [a, b, _])| [v, a, b]).collect();
        found.sort_unstable();
        found
    }

    fn found(mesh: &PolygonMesh, within: f64) -> Vec<[u32; 3]> {
        let found = t_junctions(mesh, within, &Watch::NOBODY).unwrap();
        found.iter().map(|t| [t.vertex, t.ends[0], t.ends[1]].map(|vertex| vertex.0)).collect()
    }

    prop_compose! {
        /// Different points of a small grid, and triangles on them.
        fn soup()(
            points in prop::collection::btree_set(prop::array::uniform3(0i64..4), 8..24),
        )(
            faces in prop::collection::vec(prop::array::uniform3(0..points.len() as u32), 1..14),
            points in Just(points.into_iter().collect::<Vec<Whole>>()).prop_shuffle(),
        ) -> (Vec<Whole>, Vec<[u32; 3]>) {
            let is_proper = |&[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
            (points, faces.into_iter().filter(is_proper).collect())
        }
    }

    proptest! {
        #[test]
        fn t_junctions_are_those_of_the_definition((points, faces) in soup(), halves in 0i64..3) {
            let expected = by_definition(&points, &faces, halves);
            for scale in [1.0, 5e-324, 2f64.powi(-600), 2f64.powi(1000)] {
                let within = if scale == 5e-324 { 0.0 } else { halves as f64 * scale / 2.0 };
                let expected = if within == 0.0 { by_definition(&points, &faces, 0) } else { expected.clone() };
                prop_assert_eq!(found(&mesh(&points, &faces, scale), within), expected);
            }
        }

        #[test]
        fn a_soup_has_those_of_the_mesh_of_which_it_is((points, faces) in soup()) {
            let whole = t_junctions(&mesh(&points, &faces, 1.0), 0.0, &Watch::NOBODY).unwrap();
            let apart: Vec<Whole> = faces.iter().flatten().map(|&v| points[v as usize]).collect();
            let own: Vec<[u32; 3]> = (0..faces.len() as u32).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
            let soup = mesh(&apart, &own, 1.0);
            let places = |mesh: &PolygonMesh, found: &[TJunction]| {
                let place = |t: &TJunction| {
                    let points = [t.vertex, t.ends[0], t.ends[1]].map(|v| mesh.position(v).map(|x| x as i64));
                    (points, t.face, t.is_aligned)
                };
                let mut places: Vec<_> = found.iter().map(place).collect();
                places.sort_unstable();
                places
            };
            prop_assert_eq!(places(&soup, &t_junctions(&soup, 0.0, &Watch::NOBODY).unwrap()), places(&mesh(&points, &faces, 1.0), &whole));
        }
    }

    #[test]
    fn a_foreign_corner_that_touches_is_not_aligned() {
        let points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [2, 0, 0], [1, -4, 0], [3, -4, 0], [0, -4, 0]];
        let touching = mesh(&points, &[[0, 1, 2], [3, 4, 5]], 1.0);
        let [found] = t_junctions(&touching, 0.0, &Watch::NOBODY).unwrap()[..] else { panic!("one") };
        assert_eq!((found.vertex, found.ends, found.face), (VertexId(3), [0, 1].map(VertexId), FaceId(0)));
        assert_eq!((found.is_aligned, found.distance), (false, 0.0));
        let beside = mesh(&points, &[[0, 1, 2], [3, 0, 6]], 1.0);
        let [found] = t_junctions(&beside, 0.0, &Watch::NOBODY).unwrap()[..] else { panic!("one") };
        assert!(found.is_aligned);
    }

    #[test]
    fn what_is_not_finite_lies_nowhere() {
        let points =
            [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [2.0, 0.0, 0.0], [f64::NAN; 3], [f64::INFINITY; 3]];
        let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 4], [3, 5, 2]]).unwrap();
        assert_eq!(found(&mesh, 0.0), [[3, 0, 1]]);
    }
}
