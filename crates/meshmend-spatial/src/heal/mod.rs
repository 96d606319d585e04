//! Which T-junctions are healed: boundary vertices become corners of the faces on whose boundary edges they lie.
//!
//! In rounds, until one changes nothing; a round decides everything on the faces as they were before it:
//!
//! 1. The aligned vertices on a boundary edge, in the order of their feet, then distance, then id, cut it into *pieces*
//!    ([`chains`]). A whole boundary edge is a piece of itself.
//! 2. A piece is *good* when exactly two sides would run between its ends, pieces and whole edges of every face counted, of
//!    different faces that don't lie on each other ([`lie`]).
//! 3. An end of a good piece becomes a corner of the edge's face. The edge stays as it is, with the [reason](NotHealed), if the
//!    face is thin there, would get a vertex at two of its edges, or would crowd an edge ([`crowd`]).
//!
//! No vertex moves, and no face is added or removed. Every corner put in is the end of an edge that was boundary on both sides
//! and has two sides now; no edge gains a third side.

mod chains;
mod copies;
mod crowd;
mod lie;
mod not_healed;
mod record;
mod round;

use std::sync::Arc;

use meshmend_core::{Cancelled, Complex, PolygonMesh, Watch};

use crate::t_junctions::{Boundary, vertices_on_edges, welded_faces};

pub use not_healed::NotHealed;
pub use record::{Healed, HealedCorner, Insertion, LeftTJunction};

use record::{Place, Recorder};
use round::Round;

/// What becomes of the faces of a mesh whose T-junctions within a distance of at least 0 are healed. Vertices at one
/// position count as one, the lowest; a new corner is the one of them that the sides beside it have.
///
/// # Errors
/// When whoever watches stops it.
///
/// *Cost*: O(n log n + pairs) a round; most meshes need one or two.
pub fn heal(mesh: &PolygonMesh, within: f64, watch: &Watch) -> Result<Healed, Cancelled> {
    const STEP: &str = "heal";
    watch.look(STEP, 0, 0)?;
    let welded = welded_faces(mesh, STEP, watch)?.map(|faces| Complex::of(&Arc::new(faces)));
    let place = Place { positions: mesh.positions(), within };
    let first = welded.as_ref().unwrap_or(mesh.complex());
    let mut recorder = Recorder::of(first);
    let mut faces = first.shared_faces();
    loop {
        watch.look(STEP, 0, 0)?;
        let complex = Complex::of(&faces);
        complex.edges();
        watch.look(STEP, 0, 0)?;
        let boundary = Boundary::of(&complex, mesh.positions());
        let on = vertices_on_edges(mesh.positions(), &boundary, within, watch)?;
        watch.look(STEP, 0, boundary.edges().len())?;
        let round = Round::decided(mesh.positions(), &boundary, &on, within);
        match recorder.insert(&place, &boundary, &round) {
            Some(next) => faces = Arc::new(next),
            None => {
                let shared = welded.is_some().then_some(mesh);
                return Ok(recorder.finished(shared, &place, &boundary, &on, &round));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use meshmend_core::VertexId;
    use proptest::prelude::*;

    use super::*;

    type Faces = Vec<Vec<u32>>;

    fn mesh(points: &[[i32; 3]], faces: &Faces) -> PolygonMesh {
        let points: Vec<[f64; 3]> = points.iter().map(|point| point.map(f64::from)).collect();
        let ends = faces.iter().scan(0, |end, face| {
            *end += face.len() as u32;
            Some(*end)
        });
        let starts: Vec<u32> = std::iter::once(0).chain(ends).collect();
        PolygonMesh::from_polygons(&points, &faces.concat(), &starts).unwrap()
    }

    /// The faces as they are once they are healed.
    fn faces_after(mesh: &PolygonMesh, healed: &Healed) -> Faces {
        let table = mesh.faces();
        let ids = |vertices: &[VertexId]| vertices.iter().map(|vertex| vertex.0).collect();
        let mut faces: Faces = table.faces().map(|face| ids(table.face_vertices(face))).collect();
        for (face, corners) in &healed.faces {
            let vertex = |corner: &HealedCorner| match corner {
                HealedCorner::Kept(corner) => table.corner_vertex(*corner).0,
                HealedCorner::New { vertex, .. } => vertex.0,
            };
            faces[face.0 as usize] = corners.iter().map(vertex).collect();
        }
        faces
    }

    /// The faces along each edge.
    fn edges(faces: &Faces) -> BTreeMap<[u32; 2], Vec<usize>> {
        let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (place, face) in faces.iter().enumerate() {
            for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
                edges.entry([a.min(b), a.max(b)]).or_default().push(place);
            }
        }
        edges
    }

    #[test]
    fn a_corner_on_an_edge_becomes_one_of_the_face_beside() {
        let points = [[0, 0, 0], [8, 0, 0], [8, 4, 0], [0, 4, 0], [2, 4, 0], [0, 8, 0], [8, 8, 0], [2, 8, 0]];
        let faces = vec![vec![0, 1, 2, 3], vec![3, 4, 7, 5], vec![4, 2, 6, 7]];
        let mesh = mesh(&points, &faces);
        let healed = heal(&mesh, 0.0, &Watch::NOBODY).unwrap();
        assert_eq!(faces_after(&mesh, &healed)[0], [0, 1, 2, 4, 3]);
        assert_eq!((healed.rounds, healed.left.len()), (1, 0));
        let [Insertion { vertex, ends, foot, distance, .. }] = healed.insertions[..] else { panic!("one") };
        assert_eq!((vertex, ends, foot, distance), (VertexId(4), [2, 3].map(VertexId), 0.75, 0.0));
        assert!(matches!(healed.faces[0].1[3], HealedCorner::New { share: 0.75, .. }));
    }

    #[test]
    fn what_stays_has_a_reason() {
        let points = [[0, 0, 0], [8, 0, 0], [0, 8, 0], [4, 0, 0], [2, -4, 0], [6, -4, 0]];
        let touching = mesh(&points, &vec![vec![0, 1, 2], vec![3, 4, 5]]);
        let reasons = |mesh: &PolygonMesh| {
            heal(mesh, 0.0, &Watch::NOBODY)
                .unwrap()
                .left
                .into_iter()
                .map(|left| left.reason)
                .collect::<Vec<_>>()
        };
        assert_eq!(reasons(&touching), [NotHealed::Foreign]);
        let alone = mesh(&points, &vec![vec![0, 1, 2], vec![3, 0, 4]]);
        assert!(
            heal(&alone, 0.0, &Watch::NOBODY).unwrap().insertions.len() == 1,
            "half of the edge is matched"
        );
        let wall = [[0, 0, 0], [8, 0, 0], [0, 8, 0], [4, 0, 0]];
        let double = mesh(&wall, &vec![vec![0, 1, 2], vec![2, 1, 3, 0]]);
        assert_eq!(reasons(&double), [NotHealed::Unmatched]);
    }

    prop_compose! {
        fn soup()(
            points in prop::collection::btree_set(prop::array::uniform3(0i32..4), 8..24),
        )(
            faces in prop::collection::vec(prop::array::uniform3(0..points.len() as u32), 1..12),
            points in Just(points.into_iter().collect::<Vec<_>>()).prop_shuffle(),
        ) -> (Vec<[i32; 3]>, Faces) {
            let is_proper = |&[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
            (points, faces.into_iter().filter(is_proper).map(Vec::from).collect())
        }
    }

    proptest! {
        #[test]
        fn nothing_gets_worse((points, faces) in soup()) {
            let before = mesh(&points, &faces);
            let healed = heal(&before, 0.0, &Watch::NOBODY).unwrap();
            let after = faces_after(&before, &healed);
            let (old, new) = (edges(&faces), edges(&after));
            for (ends, sides) in &new {
                let most = old.get(ends).map_or(2, |sides| sides.len().max(2));
                prop_assert!(sides.len() <= most, "{:?}", ends);
            }
            for insertion in &healed.insertions {
                let (vertex, face) = (insertion.vertex.0, insertion.face.0 as usize);
                let is_matched = new.iter().any(|(ends, sides)| {
                    ends.contains(&vertex) && sides.len() == 2 && sides.contains(&face)
                });
                prop_assert!(is_matched);
            }
            let is_simple = |face: &Vec<u32>| {
                let mut vertices = face.clone();
                vertices.sort_unstable();
                vertices.windows(2).all(|two| two[0] != two[1])
            };
            prop_assert!(after.iter().all(is_simple));
            let again = heal(&mesh(&points, &after), 0.0, &Watch::NOBODY).unwrap();
            prop_assert!(again.insertions.is_empty());
        }

        #[test]
        fn names_do_not_matter((points, faces) in soup(), turns in 0usize..3) {
            let healed = heal(&mesh(&points, &faces), 0.0, &Watch::NOBODY).unwrap();
            let count = points.len() as u32;
            let renamed: Vec<[i32; 3]> = points.iter().rev().copied().collect();
            let turned: Faces = faces.iter().rev().map(|face| {
                let mut face: Vec<u32> = face.iter().map(|vertex| count - 1 - vertex).collect();
                face.rotate_left(turns);
                face.reverse();
                face
            }).collect();
            let other = heal(&mesh(&renamed, &turned), 0.0, &Watch::NOBODY).unwrap();
            let mut expected: Vec<(u32, u32)> =
                healed.insertions.iter().map(|i| (i.vertex.0, i.face.0)).collect();
            let last = faces.len() as u32;
            let mut found: Vec<(u32, u32)> =
                other.insertions.iter().map(|i| (count - 1 - i.vertex.0, last - 1 - i.face.0)).collect();
            expected.sort_unstable();
            found.sort_unstable();
            prop_assert_eq!(found, expected);
        }
    }
}
