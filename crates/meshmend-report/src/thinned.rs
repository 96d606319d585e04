//! The shape of a mesh that is too large for a page: its vertices drawn together in cells of a grid.

use std::collections::{BTreeMap, BTreeSet};

use meshmend::PolygonMesh;
use meshmend::mesh::canonical_rotation;

use crate::mesh::{MeshData, bounds};

/// So many cells the longest side of the grid has at most.
const FINEST: f64 = 160.0;

/// About so many triangles show the shape of a mesh, its vertices drawn together in cells of a grid.
///
/// *Cost*: linear in the corners, and the cells that have some.
pub(crate) fn thinned(mesh: &PolygonMesh, most: usize, origin: [f64; 3]) -> MeshData {
    // A surface runs through about 3 n² cells, and has twice as many triangles as vertices.
    let cells = (most as f64 / 6.0).sqrt().clamp(4.0, FINEST);
    let [low, high] = bounds(mesh.positions());
    let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
    let scale = if longest > 0.0 && longest.is_finite() { cells / longest } else { 0.0 };
    let cell =
        |point: [f64; 3]| -> [u16; 3] { std::array::from_fn(|x| ((point[x] - low[x]) * scale) as u16) };

    let (mut numbers, mut points) = (BTreeMap::new(), Vec::new());
    let mut of_vertex = Vec::with_capacity(mesh.positions().len());
    for &point in mesh.positions() {
        if point.iter().any(|x| !x.is_finite()) {
            of_vertex.push(None);
            continue;
        }
        let number = *numbers.entry(cell(point)).or_insert_with(|| {
            points.push(point);
            points.len() as u32 - 1
        });
        of_vertex.push(Some(number));
    }
    let mut triangles = BTreeSet::new();
    for face in mesh.faces().faces() {
        let vertices = mesh.faces().face_vertices(face);
        for pair in vertices.windows(2).skip(1) {
            let [a, b, c] = [vertices[0], pair[0], pair[1]].map(|vertex| of_vertex[vertex.0 as usize]);
            let (Some(a), Some(b), Some(c)) = (a, b, c) else { continue };
            if a != b && b != c && c != a {
                let mut triangle = [a, b, c];
                let first = canonical_rotation(&triangle);
                triangle.rotate_left(first);
                triangles.insert(triangle);
            }
        }
    }
    MeshData::shape(&points, triangles.into_iter().collect(), origin)
}
