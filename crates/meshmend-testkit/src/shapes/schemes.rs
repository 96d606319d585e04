//! Discs whose rim is glued to itself by a word, and the small classics.
//!
//! ```text
//!      rim word  0 1 2 0 2 1        rim ─ quads ─ inner ring ─ triangles ─ centre
//! ```

use std::f64::consts::TAU;

use super::{Closed, Shape, Truth};
use crate::Soup;

/// A disc of w quads and w triangles whose rim, of w corners, spells a word; vertices of the word are the lowest.
///
/// V = r + w + 1, E = e + 3w, F = 2w for a word of length w with r different vertices and e different edges.
pub fn disc_with_rim(word: &[u32]) -> Soup {
    let rim_vertices = word.iter().max().map_or(0, |&v| v + 1);
    let w = word.len() as u32;
    let (inner, centre) = (|i: u32| rim_vertices + i % w, rim_vertices + w);
    let mut faces = Vec::new();
    for i in 0..w {
        let (here, next) = (word[i as usize], word[((i + 1) % w) as usize]);
        faces.push(vec![here, next, inner(i + 1), inner(i)]);
        faces.push(vec![inner(i), inner(i + 1), centre]);
    }
    let ring = |count: u32, radius: f64, height: f64| {
        (0..count).map(move |i| {
            let turn = TAU * f64::from(i) / f64::from(count);
            [radius * turn.cos(), radius * turn.sin(), height * f64::from(i + 1)]
        })
    };
    let positions = ring(rim_vertices, 3.0, 0.25).chain(ring(w, 1.0, 0.0)).chain([[0.0; 3]]).collect();
    Soup { positions, faces }
}

/// The dunce hat: a triangle with sides a, a, a⁻¹. V = 13, E = 30, F = 18; contractible, β = (1, 0, 0), with three
/// faces along each edge of its rim.
pub fn dunce_hat() -> Shape {
    let soup = disc_with_rim(&[0, 1, 2, 0, 1, 2, 0, 2, 1]);
    Shape::branched("dunce hat", soup, [1, 0, 0], [13, 30, 18])
}

/// A disc wrapped k times round a triangle. V = 3k + 4, E = 9k + 3, F = 6k; H₁ = Z/k, so β over Q is (1, 0, 0) and
/// over Z/2 (1, 1, 1) for even k. With k = 1 a disc, with k = 2 the projective plane, else no manifold.
pub fn wrapped_disc(k: usize) -> Shape {
    let soup = disc_with_rim(&[0, 1, 2].repeat(k));
    let (name, counts) = (format!("disc wrapped {k} times"), [3 * k + 4, 9 * k + 3, 6 * k]);
    match k {
        0 => panic!("a disc is wrapped at least once"),
        1 => Shape::surface(name, soup, Closed::Handles(0), 1, counts),
        2 => Shape::surface(name, soup, Closed::CrossCaps(1), 0, counts),
        _ => {
            let [v, e, f] = counts;
            let even = 1 - k % 2;
            let truth = Truth { betti_z2: [1, even, even], ..Truth::branched([1, 0, 0], v, e, f) };
            Shape { name, soup, truth }
        }
    }
}

/// The projective plane on six vertices: every two are joined. V = 6, E = 15, F = 10.
pub fn projective_plane() -> Shape {
    let soup = Soup::generic(6, PROJECTIVE_PLANE);
    Shape::surface("projective plane", soup, Closed::CrossCaps(1), 0, [6, 15, 10])
}

/// The torus on seven vertices: every two are joined. V = 7, E = 21, F = 14.
pub fn seven_vertex_torus() -> Shape {
    let soup = Soup::generic(7, seven_vertex_torus_faces());
    Shape::surface("seven-vertex torus", soup, Closed::Handles(1), 0, [7, 21, 14])
}

/// Dyck's surface, three cross-caps: the seven-vertex torus and the six-vertex projective plane, a triangle taken
/// out of each and the rims glued. V = 10, E = 33, F = 22.
pub fn dycks_surface() -> Shape {
    let torus = seven_vertex_torus_faces();
    let rim = torus[0].clone();
    let glued = |v: &u32| if *v < 3 { rim[*v as usize] } else { v + 4 };
    let plane = PROJECTIVE_PLANE[1..].iter().map(|face| face.iter().map(glued).collect());
    let soup = Soup::generic(10, torus[1..].iter().cloned().chain(plane).collect::<Vec<_>>());
    Shape::surface("Dyck's surface", soup, Closed::CrossCaps(3), 0, [10, 33, 22])
}

/// The first two faces share the edge 0-2.
pub(super) const PROJECTIVE_PLANE: [[u32; 3]; 10] = [
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

/// The first two faces, (0 1 3) and (0 3 2), share the edge 0-3.
pub(super) fn seven_vertex_torus_faces() -> Vec<Vec<u32>> {
    let two = |i: u32| [vec![i, (i + 1) % 7, (i + 3) % 7], vec![i, (i + 3) % 7, (i + 2) % 7]];
    (0..7).flat_map(two).collect()
}
