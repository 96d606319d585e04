//! Any compact connected surface: a polygonal sphere with handles, cross-caps and holes let in.
//!
//! ```text
//!   ┌──┬──┬──┬──┬──┐      every second cell of the middle row becomes
//!   ├──┼──┼──┼──┼──┤        a handle:    the seven-vertex torus less two triangles (3 vertices, 12 faces)
//!   │  │◉ │  │◎ │  │        a cross-cap: the six-vertex projective plane less two (2 vertices, 8 faces)
//!   ├──┼──┼──┼──┼──┤        a hole:      nothing
//!   └──┴──┴──┴──┴──┘      and one face closes the grid round the outside
//! ```

use super::schemes::{PROJECTIVE_PLANE, seven_vertex_torus_faces};
use super::{Closed, Shape, Truth};
use crate::Soup;

/// The surface of a kind with so many holes, each face cut into quads `refinements` times.
///
/// Before the first refinement, with c features in w = max(1, c) * 2 + 1 columns: V = 4(w + 1) + 3 a handle + 2 a
/// cross-cap, E = 7w + 3 + 16 a handle + 10 a cross-cap, F = 3w + 1 + 11 a handle + 7 a cross-cap − 1 a hole.
pub fn surface(kind: Closed, holes: usize, refinements: usize) -> Shape {
    let (handles, caps) = match kind {
        Closed::Handles(genus) => (genus, 0),
        Closed::CrossCaps(caps) => (0, caps.max(1)),
    };
    let features = handles + caps + holes;
    let columns = 2 * features.max(1) + 1;
    let mut soup = open_grid(columns);
    for feature in 0..features {
        let rim = cell(2 * feature + 1, 1);
        if feature < handles {
            let faces = seven_vertex_torus_faces();
            glue(&mut soup, &rim, [1, 0, 2, 3], &faces[2..]);
        } else if feature < handles + caps {
            let faces = PROJECTIVE_PLANE.map(|face| face.to_vec());
            glue(&mut soup, &rim, [0, 1, 2, 3], &faces[2..]);
        }
    }
    let taken: Vec<Vec<u32>> = (0..features).map(|feature| cell(2 * feature + 1, 1)).collect();
    soup.faces.retain(|face| !taken.contains(face));
    let mut counts = [
        4 * (columns + 1) + 3 * handles + 2 * caps,
        7 * columns + 3 + 16 * handles + 10 * caps,
        3 * columns + 1 + 11 * handles + 7 * caps - holes,
    ];
    for _ in 0..refinements {
        let corners: usize = soup.faces.iter().map(Vec::len).sum();
        counts = [counts.iter().sum(), 2 * counts[1] + corners, corners];
        soup = soup.refined();
    }
    let [v, e, f] = counts;
    let name = format!("{kind:?} with {holes} holes, refined {refinements} times");
    Shape { name, soup, truth: Truth::surface(kind, holes, v, e, f) }
}

/// The corners of a cell, counter-clockwise; four vertices a column.
fn cell(i: usize, j: usize) -> Vec<u32> {
    [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| (4 * i + j) as u32).to_vec()
}

/// A grid of three rows, closed by one face round the outside; heights are irregular, so that no two points of a
/// refinement coincide.
fn open_grid(columns: usize) -> Soup {
    let positions = (0..4 * (columns + 1)).map(|v| irregular((v / 4) as f64, (v % 4) as f64, v)).collect();
    let mut faces: Vec<Vec<u32>> = (0..columns).flat_map(|i| (0..3).map(move |j| cell(i, j))).collect();
    let point = |i: usize, j: usize| (4 * i + j) as u32;
    let up = (0..3).map(|j| point(0, j));
    let along = (0..columns).map(|i| point(i, 3));
    let down = (1..=3).rev().map(|j| point(columns, j));
    let back = (1..=columns).rev().map(|i| point(i, 0));
    faces.push(up.chain(along).chain(down).chain(back).collect());
    Soup { positions, faces }
}

/// Adds a piece: its vertices `seam` become those of the rim, in order, and the others new vertices.
fn glue(soup: &mut Soup, rim: &[u32], seam: [u32; 4], piece: &[Vec<u32>]) {
    let (x, y) = (soup.positions[rim[0] as usize][0] + 0.5, soup.positions[rim[0] as usize][1] + 0.5);
    let last = piece.iter().flatten().max().copied().unwrap();
    let mut names = vec![0; last as usize + 1];
    for v in 0..=last {
        names[v as usize] = match seam.iter().position(|&s| s == v) {
            Some(at) => rim[at],
            None => {
                soup.positions.push(irregular(x, y, soup.positions.len()));
                soup.positions.len() as u32 - 1
            }
        };
    }
    soup.faces.extend(piece.iter().map(|face| face.iter().map(|&v| names[v as usize]).collect::<Vec<_>>()));
}

fn irregular(x: f64, y: f64, seed: usize) -> [f64; 3] {
    let golden = |k: f64| (seed as f64 * k).fract() / 4.0;
    [x + golden(0.618_033_988_7), y + golden(0.754_877_666_2), 1.0 + golden(0.569_840_290_9)]
}
