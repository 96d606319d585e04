//! Discs whose rim is glued to itself by a word, and the small classics.
//!
//! ```text
//!      rim word  0 1 2 0 2 1        rim ─ quads ─ inner ring ─ triangles ─ centre
//! ```

use std::f64::consts::TAU;

use meshmend_core::PolygonMesh;

use crate::mesh_builder::{MeshBuilder, at_least, general_position};
use crate::{Closed, Shape, ShapeError, Truth};

/// A disc of w quads and w triangles whose rim, of w corners, spells a word; vertices of the word are the lowest.
///
/// V = r + w + 1, E = e + 3w, F = 2w for a word of length w with r different vertices, all of 0 to r − 1, and e
/// different edges.
///
/// # Errors
/// When the word is too long, or names too high a vertex.
pub fn disc_with_rim(word: &[u32]) -> Result<PolygonMesh, ShapeError> {
    rim_sketch(word)?.mesh()
}

fn rim_sketch(word: &[u32]) -> Result<MeshBuilder, ShapeError> {
    let rim_vertices = word.iter().max().map_or(0, |&v| v as usize + 1);
    let mut builder = MeshBuilder::with_room(&[7, word.len()])?;
    MeshBuilder::with_room(&[rim_vertices])?;
    let ring = |count: usize, radius: f64, height: f64| {
        (0..count).map(move |i| {
            let turn = TAU * i as f64 / count as f64;
            [radius * turn.cos(), radius * turn.sin(), height * (i + 1) as f64]
        })
    };
    builder.points(ring(rim_vertices, 3.0, 0.25));
    let first = builder.next();
    builder.points(ring(word.len(), 1.0, 0.0));
    let centre = builder.point([0.0; 3]);
    let w = word.len() as u32;
    let inner = |i: u32| first + i % w;
    for (i, (here, next)) in (0..).zip(word.iter().zip(word.iter().cycle().skip(1))) {
        builder.face(&[*here, *next, inner(i + 1), inner(i)]);
        builder.face(&[inner(i), inner(i + 1), centre]);
    }
    Ok(builder)
}

/// The dunce hat: a triangle with sides a, a, a⁻¹. V = 13, E = 30, F = 18; contractible, β = (1, 0, 0), with three
/// faces along each edge of its rim.
///
/// # Errors
/// None: it is small.
pub fn dunce_hat() -> Result<Shape, ShapeError> {
    rim_sketch(&[0, 1, 2, 0, 1, 2, 0, 2, 1])?.branched("dunce hat", [1, 0, 0], [13, 30, 18])
}

/// A disc wrapped k times round a triangle. V = 3k + 4, E = 9k + 3, F = 6k; H₁ = Z/k, so β over Q is (1, 0, 0) and
/// over Z/2 (1, 1, 1) for even k. With k = 1 a disc, with k = 2 the projective plane, else no manifold.
///
/// # Errors
/// When k is 0 or too large.
pub fn wrapped_disc(k: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of turns", k)?;
    MeshBuilder::with_room(&[21, k])?;
    let builder = rim_sketch(&[0, 1, 2].repeat(k))?;
    let (name, counts) = (format!("disc wrapped {k} times"), [3 * k + 4, 9 * k + 3, 6 * k]);
    match k {
        1 => builder.surface(name, Closed::Handles(0), 1, counts),
        2 => builder.surface(name, Closed::CrossCaps(1), 0, counts),
        _ => {
            let even = 1 - k % 2;
            let truth = Truth { betti_z2: [1, even, even], ..Truth::branched([1, 0, 0], counts) };
            builder.shape(name, truth)
        }
    }
}

/// The projective plane on six vertices: every two are joined. V = 6, E = 15, F = 10.
///
/// # Errors
/// None: it is small.
pub fn projective_plane() -> Result<Shape, ShapeError> {
    general(6, &PROJECTIVE_PLANE).surface("projective plane", Closed::CrossCaps(1), 0, [6, 15, 10])
}

/// The torus on seven vertices: every two are joined. V = 7, E = 21, F = 14. Its vertices are in general position;
/// its faces pass through one another.
///
/// # Errors
/// None: it is small.
pub fn seven_vertex_torus() -> Result<Shape, ShapeError> {
    general(7, &seven_vertex_torus_faces()).surface("seven-vertex torus", Closed::Handles(1), 0, [7, 21, 14])
}

/// Dyck's surface, three cross-caps: the seven-vertex torus and the six-vertex projective plane, a triangle taken
/// out of each and the rims glued. V = 10, E = 33, F = 22.
///
/// # Errors
/// None: it is small.
pub fn dycks_surface() -> Result<Shape, ShapeError> {
    let [rim, torus @ ..] = seven_vertex_torus_faces();
    let glued = |v: u32| rim.get(v as usize).copied().unwrap_or(v + 4);
    let plane = PROJECTIVE_PLANE[1..].iter().map(|face| face.map(glued));
    let faces: Vec<[u32; 3]> = torus.into_iter().chain(plane).collect();
    general(10, &faces).surface("Dyck's surface", Closed::CrossCaps(3), 0, [10, 33, 22])
}

/// The first two faces share the edge 0-2.
pub(crate) const PROJECTIVE_PLANE: [[u32; 3]; 10] = [
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 5],
    [0, 5, 1],
    [1, 2, 4],
    [2, 3, 5],
    [3, 4, 1],
    [4, 5, 2],
    [5, 1, 3],
];

fn seven_vertex_torus_faces() -> [[u32; 3]; 14] {
    std::array::from_fn(|f| {
        let i = f as u32 / 2;
        if f.is_multiple_of(2) { [i, (i + 1) % 7, (i + 3) % 7] } else { [i, (i + 3) % 7, (i + 2) % 7] }
    })
}

fn general(vertex_count: usize, faces: &[[u32; 3]]) -> MeshBuilder {
    let mut builder = MeshBuilder::default();
    builder.points(general_position(vertex_count));
    faces.iter().for_each(|face| builder.face(face));
    builder
}
