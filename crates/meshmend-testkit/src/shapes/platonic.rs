//! The five Platonic solids, faces outward.
//!
//! | solid | V | E | F |
//! |---|--:|--:|--:|
//! | tetrahedron | 4 | 6 | 4 |
//! | cube | 8 | 12 | 6 |
//! | octahedron | 6 | 12 | 8 |
//! | dodecahedron | 20 | 30 | 12 |
//! | icosahedron | 12 | 30 | 20 |

use super::{Closed, Shape};
use crate::Soup;

/// Four triangles.
pub fn tetrahedron() -> Shape {
    let positions = vec![[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]];
    let faces = lists(&[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);
    solid("tetrahedron", Soup { positions, faces }, [4, 6, 4])
}

/// Six squares; corners at 0 and 1.
pub fn cube() -> Shape {
    solid("cube", unit_box(), [8, 12, 6])
}

/// Eight triangles.
pub fn octahedron() -> Shape {
    let positions =
        vec![[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let faces =
        lists(&[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]);
    solid("octahedron", Soup { positions, faces }, [6, 12, 8])
}

/// Twenty triangles.
pub fn icosahedron() -> Shape {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let mut positions = Vec::new();
    for axis in 0..3 {
        for [one, phi] in [[1.0, golden], [-1.0, golden], [1.0, -golden], [-1.0, -golden]] {
            let mut point = [0.0; 3];
            point[(axis + 1) % 3] = one;
            point[(axis + 2) % 3] = phi;
            positions.push(point);
        }
    }
    // Edges have length 2: the faces are the triples that are that far apart, turned outward.
    let near = |a: u32, b: u32| (distance_squared(&positions, a, b) - 4.0).abs() < 1e-9;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let outward = volume(&positions, [a, b, c]) > 0.0;
                    faces.push(if outward { vec![a, b, c] } else { vec![a, c, b] });
                }
            }
        }
    }
    solid("icosahedron", Soup { positions, faces }, [12, 30, 20])
}

/// Twelve pentagons: the dual of the icosahedron.
pub fn dodecahedron() -> Shape {
    let Shape { soup: icosahedron, .. } = icosahedron();
    let centre = |face: &Vec<u32>| {
        [0, 1, 2].map(|axis| face.iter().map(|&v| icosahedron.positions[v as usize][axis]).sum::<f64>() / 3.0)
    };
    let positions = icosahedron.faces.iter().map(centre).collect();
    let follower = |v: u32, face: u32| {
        // The triangle that holds the side from v to the vertex before v in this one.
        let here = &icosahedron.faces[face as usize];
        let at = here.iter().position(|&w| w == v).unwrap();
        let side = [v, here[(at + 2) % 3]];
        let holds = |f: &Vec<u32>| (0..3).any(|i| [f[i], f[(i + 1) % 3]] == side);
        icosahedron.faces.iter().position(holds).unwrap() as u32
    };
    let ring = |v: u32| -> Vec<u32> {
        let first = icosahedron.faces.iter().position(|face| face.contains(&v)).unwrap() as u32;
        std::iter::successors(Some(first), |&face| Some(follower(v, face))).take(5).collect()
    };
    let faces = (0..12).map(ring).collect();
    solid("dodecahedron", Soup { positions, faces }, [20, 30, 12])
}

/// All five.
pub fn platonic_solids() -> [Shape; 5] {
    [tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron()]
}

/// The cube between the corners (0, 0, 0) and (1, 1, 1), six squares outward; vertex 4x + 2y + z.
pub(super) fn unit_box() -> Soup {
    let positions = (0..8).map(|i| [f64::from(i / 4), f64::from(i / 2 % 2), f64::from(i % 2)]).collect();
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    Soup { positions, faces: faces.map(|f| f.to_vec()).to_vec() }
}

fn solid(name: &str, soup: Soup, counts: [usize; 3]) -> Shape {
    Shape::surface(name, soup, Closed::Handles(0), 0, counts)
}

fn lists(faces: &[[u32; 3]]) -> Vec<Vec<u32>> {
    faces.iter().map(|face| face.to_vec()).collect()
}

fn distance_squared(positions: &[[f64; 3]], a: u32, b: u32) -> f64 {
    (0..3).map(|axis| (positions[a as usize][axis] - positions[b as usize][axis]).powi(2)).sum()
}

fn volume(positions: &[[f64; 3]], face: [u32; 3]) -> f64 {
    let [a, b, c] = face.map(|v| positions[v as usize]);
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_look_outward() {
        for shape in platonic_solids() {
            let inside = if shape.name == "cube" { 0.5 } else { 0.0 };
            let moved: Vec<_> = shape.soup.positions.iter().map(|p| p.map(|x| x - inside)).collect();
            for face in &shape.soup.faces {
                assert!(volume(&moved, [face[0], face[1], face[2]]) > 0.0, "{} {face:?}", shape.name);
            }
        }
    }
}
