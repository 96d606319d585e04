//! For each vertex the lowest one at the same position.

use meshmend_core::{Id, PolygonMesh, SharedPlaces, VertexId};
use rayon::prelude::*;

use super::equal_keys::{CHUNK, always, lowest_of_equal};
use crate::vector::{Point, is_finite, place_bits};

/// For each vertex the lowest one at the same position: −0 equals 0, and a position that is not finite equals no other.
///
/// *Cost*: linear; 20 bytes a vertex, and 36 for each that equals another one in single precision alone.
pub fn coincident_vertices(mesh: &PolygonMesh) -> Vec<VertexId> {
    let Ok(lowest) = watched_coincident_vertices(mesh, always);
    lowest
}

/// The same while somebody watches, who is asked now and then whether to go on.
///
/// # Errors
/// That of whoever does not go on.
///
/// *Cost*: that of [`coincident_vertices`].
pub fn watched_coincident_vertices<E: Send>(
    mesh: &PolygonMesh,
    goes_on: impl Fn() -> Result<(), E> + Sync,
) -> Result<Vec<VertexId>, E> {
    Ok(Coincidence::of_mesh(mesh, goes_on)?.exactly)
}

/// For each vertex the lowest one at the same position when all coordinates are rounded to single precision; what is
/// not finite then equals nothing.
///
/// *Cost*: linear; 20 bytes a vertex.
pub fn coincident_in_single(mesh: &PolygonMesh) -> Vec<VertexId> {
    let Ok(lowest) = equal_in_single(mesh.positions(), &always);
    lowest
}

/// Which vertices are in the same place, and how many more would be if coordinates were stored in single precision.
#[derive(Clone, Debug)]
pub struct Coincidence {
    /// For each vertex the lowest one at the same position.
    pub exactly: Vec<VertexId>,
    /// How many vertices equal a lower one in single precision alone.
    pub only_in_single: usize,
}

impl Coincidence {
    /// Looks at some points.
    ///
    /// *Cost*: that of [`coincident_vertices`].
    pub fn of(positions: &[Point]) -> Self {
        let Ok(found) = Self::watched(positions, always);
        found
    }

    /// Looks at the points of a mesh while somebody watches, who is asked now and then whether to go on. Of places that vertices
    /// are known to share each is looked at once.
    ///
    /// # Errors
    /// That of whoever does not go on.
    ///
    /// *Cost*: that of [`coincident_vertices`].
    pub fn of_mesh<E: Send>(
        mesh: &PolygonMesh,
        goes_on: impl Fn() -> Result<(), E> + Sync,
    ) -> Result<Self, E> {
        if let Some(shared) = mesh.shared_places() {
            let places = Coincidence::watched(shared.points(), &goes_on)?;
            goes_on()?;
            // More vertices than places are in one place in single precision alone: then they are counted one by one.
            if places.only_in_single == 0 {
                return Ok(Coincidence {
                    exactly: lowest_sharing(shared, &places.exactly),
                    only_in_single: 0,
                });
            }
        }
        Coincidence::watched(mesh.positions(), goes_on)
    }

    /// Looks at some points while somebody watches, who is asked now and then whether to go on.
    ///
    /// # Errors
    /// That of whoever does not go on.
    ///
    /// *Cost*: that of [`coincident_vertices`].
    pub fn watched<E: Send>(
        positions: &[Point],
        goes_on: impl Fn() -> Result<(), E> + Sync,
    ) -> Result<Self, E> {
        let are_single = |positions: &[Point]| positions.iter().flatten().all(|&x| f64::from(x as f32) == x);
        let lowest = equal_in_single(positions, &goes_on)?;
        goes_on()?;
        // A coordinate that is not a number equals none, itself included.
        if positions.par_chunks(CHUNK).all(are_single) {
            return Ok(Coincidence { exactly: lowest, only_in_single: 0 });
        }
        let doubtful = doubtful(positions, &lowest);
        let mut exactly = lowest;
        let joined = |lowest: &[VertexId]| doubtful.iter().filter(|&&v| lowest[v.index()] != v).count();
        let joined_in_single = joined(&exactly);
        let points: Vec<Point> = doubtful.iter().map(|v| positions[v.index()]).collect();
        let equal = lowest_of_equal(&points, |point| is_finite(point).then(|| place_bits(*point)), &goes_on)?;
        for (&vertex, low) in doubtful.iter().zip(equal) {
            exactly[vertex.index()] = doubtful[low.index()];
        }
        // Numbers that single precision does not reach may be equal as they are, and are not in single precision.
        let only_in_single = joined_in_single.saturating_sub(joined_within(&exactly, &doubtful, positions));
        Ok(Coincidence { exactly, only_in_single })
    }
}

/// For each vertex the lowest one at its position, by the lowest equal one of each place.
fn lowest_sharing(shared: &SharedPlaces, lowest_place: &[VertexId]) -> Vec<VertexId> {
    // Places come in the order in which vertices first have them, so the lowest place has the lowest vertex.
    let first = shared.first_vertices();
    let lowest = |(vertex, place): (usize, &VertexId)| {
        let is_finite = is_finite(&shared.points()[place.index()]);
        if is_finite { first[lowest_place[place.index()].index()] } else { VertexId::new(vertex) }
    };
    shared.of_vertex().iter().enumerate().map(lowest).collect()
}

fn equal_in_single<E: Send>(
    positions: &[Point],
    goes_on: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<Vec<VertexId>, E> {
    let key = |&point: &Point| is_in_reach(point).then(|| point.map(|x| (x as f32 + 0.0).to_bits()));
    lowest_of_equal(positions, key, goes_on)
}

/// The vertices of which single precision does not tell what they equal: all of a class that are not all at one
/// position, and those beyond its reach.
fn doubtful(positions: &[Point], lowest: &[VertexId]) -> Vec<VertexId> {
    let vertices = || (0..positions.len()).map(VertexId::new);
    let mut is_mixed = vec![false; positions.len()];
    for vertex in vertices() {
        let low = lowest[vertex.index()];
        if low != vertex && positions[low.index()] != positions[vertex.index()] {
            is_mixed[low.index()] = true;
        }
    }
    let is_doubtful = |vertex: &VertexId| {
        let point = positions[vertex.index()];
        is_mixed[lowest[vertex.index()].index()] || !is_in_reach(point) && is_finite(&point)
    };
    vertices().filter(is_doubtful).collect()
}

/// How many of some vertices within the reach of single precision are joined to a lower one.
fn joined_within(lowest: &[VertexId], vertices: &[VertexId], positions: &[Point]) -> usize {
    let is_joined = |v: &&VertexId| lowest[v.index()] != **v && is_in_reach(positions[v.index()]);
    vertices.iter().filter(is_joined).count()
}

fn is_in_reach(point: Point) -> bool {
    point.iter().all(|&x| (x as f32).is_finite())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use meshmend_core::FaceTable;
    use proptest::prelude::*;

    use super::*;

    fn lowest(positions: &[Point]) -> Vec<u32> {
        let faces = FaceTable::empty(positions.len());
        let mesh = PolygonMesh::new(positions.to_vec(), faces).unwrap();
        coincident_vertices(&mesh).into_iter().map(|vertex| vertex.0).collect()
    }

    fn expected(positions: &[Point]) -> Vec<u32> {
        let mut first = BTreeMap::new();
        let position = |(vertex, p): (u32, &[f64; 3])| {
            let key = p.map(|x| (x + 0.0).to_bits());
            if p.iter().all(|x| x.is_finite()) { *first.entry(key).or_insert(vertex) } else { vertex }
        };
        (0..).zip(positions).map(position).collect()
    }

    #[test]
    fn zeros_are_equal_and_what_is_not_finite_equals_nothing() {
        let positions = [
            [0.0, -0.0, 1.0],
            [-0.0, 0.0, 1.0],
            [f64::NAN, 0.0, 0.0],
            [f64::NAN, 0.0, 0.0],
            [f64::INFINITY, 0.0, 0.0],
            [f64::INFINITY, 0.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        assert_eq!(lowest(&positions), [0, 0, 2, 3, 4, 5, 0]);
        // Without the numbers that are none all are single precision.
        assert_eq!(lowest(&positions[4..]), [0, 1, 2]);
        assert_eq!(lowest(&[]), [0u32; 0]);
    }

    /// More than one chunk and many parts, in single and in double precision.
    #[test]
    fn large_clouds_are_as_a_map_has_them() {
        for scale in [1.0, 0.1] {
            let count = 5 * CHUNK as u64 / 2;
            let coordinate = |i: u64, step: u64| (i.wrapping_mul(step) % 40) as f64 * scale;
            let positions: Vec<[f64; 3]> = (0..count)
                .map(|i| [coordinate(i, 7), coordinate(i / 40, 11), coordinate(i / 977, 13)])
                .collect();
            assert_eq!(lowest(&positions), expected(&positions));
        }
    }

    /// What is joined in single precision is counted beyond what is equal, also where numbers leave its range.
    #[test]
    fn single_precision_joins_more() {
        let positions = [
            [0.1, 0.0, 0.0],
            [0.1_f32.into(), 0.0, 0.0],
            [0.1, -0.0, 1e-60],
            [0.1, 0.0, 0.0],
            [1e39, 0.0, 0.0],
            [1e39, 0.0, 0.0],
            [2e39, 0.0, 0.0],
            [f64::NAN, 0.0, 0.0],
            [0.5, 0.0, 0.0],
        ];
        let found = Coincidence::of(&positions);
        let exactly: Vec<u32> = found.exactly.iter().map(|v| v.0).collect();
        assert_eq!((exactly, found.only_in_single), (vec![0, 1, 2, 0, 4, 4, 6, 7, 8], 2));
        let Ok(in_single) = equal_in_single(&positions, &always);
        let in_single: Vec<u32> = in_single.iter().map(|v| v.0).collect();
        assert_eq!(in_single, [0, 0, 0, 0, 4, 5, 6, 7, 8]);
        assert_eq!(Coincidence::of(&positions[8..]).only_in_single, 0);
    }

    proptest! {
        #[test]
        fn small_clouds_are_as_a_map_has_them(cells in prop::collection::vec((0..3i8, -1..2i8, 0..2i8), 0..60)) {
            let point = |&(x, y, z): &(i8, i8, i8)| [f64::from(x) / 3.0, f64::from(y) * -0.0, f64::from(z)];
            let positions: Vec<[f64; 3]> = cells.iter().map(point).collect();
            prop_assert_eq!(lowest(&positions), expected(&positions));
        }
    }
}
