//! Complexes that branch along edges or touch in vertices: no manifolds, but each figure is known.

use std::f64::consts::TAU;

use super::platonic::{tetrahedron, unit_box};
use super::{Closed, Shape};
use crate::Soup;

/// n triangles along one edge, all through it the same way. V = n + 2, E = 2n + 1, F = n, β = (1, 0, 0); a disc while
/// n ≤ 2, and then inconsistent for n = 2.
pub fn book(n: usize) -> Shape {
    let pages = circle(n, 1.0, 0.5);
    let positions = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]].into_iter().chain(pages).collect();
    let faces = (0..n as u32).map(|page| vec![0, 1, page + 2]).collect();
    let (name, soup, counts) = (format!("book of {n}"), Soup { positions, faces }, [n + 2, 2 * n + 1, n]);
    if n <= 2 {
        Shape::surface(name, soup, Closed::Handles(0), 1, counts)
    } else {
        Shape::branched(name, soup, [1, 0, 0], counts)
    }
}

/// Three triangles on one edge. V = 5, E = 7, F = 3, β = (1, 0, 0).
pub fn three_triangles_on_an_edge() -> Shape {
    book(3)
}

/// n tubes of three quads, one inside the other, that share one edge. V = 4n + 2, E = 8n + 1, F = 3n,
/// β = (1, n, 0); an annulus for n = 1.
///
/// Round the edge the 2n sides are nested like brackets, and each tube is a sheet of its own.
pub fn nested_pages(n: usize) -> Shape {
    let mut soup = Soup { positions: vec![[0.0; 3], [0.0, 0.0, 1.0]], faces: Vec::new() };
    for page in 0..n {
        let (wide, long) = ((page + 1) as f64, (page + 2) as f64 * n as f64);
        let base = soup.positions.len() as u32;
        for [x, y] in [[long, -wide], [long, wide]] {
            soup.positions.extend([[x, y, 0.0], [x, y, 1.0]]);
        }
        let [out_low, out_high, back_low, back_high] = [base, base + 1, base + 2, base + 3];
        soup.faces.push(vec![0, out_low, out_high, 1]);
        soup.faces.push(vec![out_low, back_low, back_high, out_high]);
        soup.faces.push(vec![back_low, 0, 1, back_high]);
    }
    let (name, counts) = (format!("{n} nested pages"), [4 * n + 2, 8 * n + 1, 3 * n]);
    if n == 1 {
        Shape::surface(name, soup, Closed::Handles(0), 2, counts)
    } else {
        Shape::branched(name, soup, [1, n, 0], counts)
    }
}

/// Two tetrahedra that share a vertex. V = 7, E = 12, F = 8, β = (1, 0, 2).
pub fn two_tetrahedra_on_a_vertex() -> Shape {
    Shape::branched("two tetrahedra on a vertex", glued_copy(tetrahedron().soup, &[0]), [1, 0, 2], [7, 12, 8])
}

/// Two tetrahedra that share an edge. V = 6, E = 11, F = 8, β = (1, 0, 2).
pub fn two_tetrahedra_on_an_edge() -> Shape {
    Shape::branched(
        "two tetrahedra on an edge",
        glued_copy(tetrahedron().soup, &[0, 1]),
        [1, 0, 2],
        [6, 11, 8],
    )
}

/// Two cubes that share an edge, each on the other side of it. V = 14, E = 23, F = 12, β = (1, 0, 2).
pub fn two_boxes_on_an_edge() -> Shape {
    Shape::branched("two boxes on an edge", glued_copy(unit_box(), &[0, 1]), [1, 0, 2], [14, 23, 12])
}

/// n tetrahedra that share one vertex: n closed umbrellas there. V = 3n + 1, E = 6n, F = 4n, β = (1, 0, n).
pub fn umbrellas(n: usize) -> Shape {
    let mut soup = Soup { positions: vec![[0.0; 3]], faces: Vec::new() };
    for cone in 0..n {
        let (base, height) = (3 * cone as u32 + 1, (cone + 1) as f64);
        soup.positions.extend([[1.0, 0.0, height], [-0.5, 1.0, height], [-0.5, -1.0, height]]);
        let [a, b, c] = [base, base + 1, base + 2];
        soup.faces.extend([vec![0, b, a], vec![0, c, b], vec![0, a, c], vec![a, b, c]]);
    }
    let (name, counts) = (format!("{n} umbrellas"), [3 * n + 1, 6 * n, 4 * n]);
    if n == 1 {
        Shape::surface(name, soup, Closed::Handles(0), 0, counts)
    } else {
        Shape::branched(name, soup, [1, 0, n], counts)
    }
}

/// Two triangles that share a vertex. V = 5, E = 6, F = 2, β = (1, 0, 0); pinched, with open fans only.
pub fn bow_tie() -> Shape {
    let positions = vec![[0.0; 3], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0]];
    let faces = vec![vec![0, 1, 2], vec![0, 3, 4]];
    Shape::branched("bow tie", Soup { positions, faces }, [1, 0, 0], [5, 6, 2])
}

/// A sphere of r rings of m vertices whose two poles are one vertex: a torus with a meridian shrunk to a point.
/// V = rm + 1, E = (2r + 1)m, F = (r + 1)m, β = (1, 1, 1); r ≥ 2, m ≥ 3.
pub fn pinched_torus(rings: usize, m: usize) -> Shape {
    assert!(rings >= 2 && m >= 3, "the two ends of a pinched torus must differ");
    let point = |ring: usize, i: usize| (1 + ring * m + i % m) as u32;
    let mut soup = Soup { positions: vec![[0.0; 3]], faces: Vec::new() };
    for ring in 0..rings {
        let turn = TAU * (ring + 1) as f64 / (rings + 1) as f64;
        let thin = circle(m, 0.5 * (turn / 2.0).sin(), 0.0);
        soup.positions
            .extend(thin.map(|[x, y, _]| [(1.0 + x) * (1.0 - turn.cos()), (1.0 + x) * turn.sin(), y]));
    }
    for i in 0..m {
        soup.faces.push(vec![0, point(0, i + 1), point(0, i)]);
        for ring in 1..rings {
            let (near, far) = (ring - 1, ring);
            soup.faces.push(vec![point(near, i), point(near, i + 1), point(far, i + 1), point(far, i)]);
        }
        soup.faces.push(vec![point(rings - 1, i), point(rings - 1, i + 1), 0]);
    }
    let counts = [rings * m + 1, (2 * rings + 1) * m, (rings + 1) * m];
    Shape::branched(format!("pinched torus of {rings} rings of {m}"), soup, [1, 1, 1], counts)
}

/// A bipyramid with its equator, of m edges, filled by one face. V = m + 2, E = 3m, F = 2m + 1, β = (1, 0, 2).
pub fn sphere_with_membrane(m: usize) -> Shape {
    let mut soup = cones(m, &[1.0, -1.0]);
    soup.faces.push((0..m as u32).collect());
    Shape::branched("sphere with membrane", soup, [1, 0, 2], [m + 2, 3 * m, 2 * m + 1])
}

/// Three cones on one circle of m edges. V = m + 3, E = 4m, F = 3m, β = (1, 0, 2).
pub fn three_hemispheres(m: usize) -> Shape {
    let soup = cones(m, &[1.0, 2.0, -1.0]);
    Shape::branched("three hemispheres on a circle", soup, [1, 0, 2], [m + 3, 4 * m, 3 * m])
}

/// A block of a × b × c cells with all walls between them. V = (a + 1)(b + 1)(c + 1), E = Σ a(b + 1)(c + 1),
/// F = Σ (a + 1)bc, over the three directions; β = (1, 0, abc).
///
/// Away from the twelve edges of the block each face is a patch of its own: the worst case of Betti numbers by
/// patches. A cube for one cell.
pub fn foam(a: usize, b: usize, c: usize) -> Shape {
    let size = [a, b, c];
    let point = |p: [usize; 3]| ((p[0] * (b + 1) + p[1]) * (c + 1) + p[2]) as u32;
    let mut soup = Soup::default();
    for p in blocks([a + 1, b + 1, c + 1]) {
        soup.positions.push(p.map(|x| x as f64));
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            if p[u] < size[u] && p[v] < size[v] {
                let moved = |du, dv| point(plus(plus(p, u, du), v, dv));
                soup.faces.push(vec![moved(0, 0), moved(1, 0), moved(1, 1), moved(0, 1)]);
            }
        }
    }
    let edges = a * (b + 1) * (c + 1) + (a + 1) * b * (c + 1) + (a + 1) * (b + 1) * c;
    let faces = (a + 1) * b * c + a * (b + 1) * c + a * b * (c + 1);
    let (name, counts) = (format!("foam of {a}x{b}x{c}"), [(a + 1) * (b + 1) * (c + 1), edges, faces]);
    if a * b * c == 1 {
        Shape::surface(name, soup, Closed::Handles(0), 0, counts)
    } else {
        Shape::branched(name, soup, [1, 0, a * b * c], counts)
    }
}

fn blocks(size: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    let [a, b, c] = size;
    (0..a).flat_map(move |x| (0..b).flat_map(move |y| (0..c).map(move |z| [x, y, z])))
}

fn plus(mut p: [usize; 3], axis: usize, by: usize) -> [usize; 3] {
    p[axis] += by;
    p
}

/// A solid and a copy of it, turned by half a turn about its one shared vertex or its two.
fn glued_copy(solid: Soup, shared: &[u32]) -> Soup {
    let base = solid.positions.len() as u32;
    let centre = solid.positions[shared[0] as usize];
    let axis: [f64; 3] = match shared.get(1) {
        Some(&end) => [0, 1, 2].map(|i| solid.positions[end as usize][i] - centre[i]),
        None => [1.0, 0.0, 0.0],
    };
    // Half a turn about the axis: it keeps the shared edge and the orientation.
    let square: f64 = axis.iter().map(|x| x * x).sum();
    let turned = |p: [f64; 3]| {
        let along: f64 = (0..3).map(|i| (p[i] - centre[i]) * axis[i]).sum::<f64>() / square;
        [0, 1, 2].map(|i| 2.0 * (centre[i] + along * axis[i]) - p[i])
    };
    let mut soup = solid.clone();
    let mut names = Vec::new();
    for v in 0..base {
        if shared.contains(&v) {
            names.push(v);
        } else {
            names.push(soup.positions.len() as u32);
            soup.positions.push(turned(solid.positions[v as usize]));
        }
    }
    let copy = |face: &Vec<u32>| face.iter().map(|&v| names[v as usize]).collect::<Vec<_>>();
    soup.faces.extend(solid.faces.iter().map(copy));
    soup
}

/// A circle of m vertices and an apex above or below it for each height; cones above look up, those below down.
fn cones(m: usize, heights: &[f64]) -> Soup {
    let mut soup = Soup { positions: circle(m, 1.0, 0.0).collect(), faces: Vec::new() };
    for &height in heights {
        let apex = soup.positions.len() as u32;
        soup.positions.push([0.0, 0.0, height]);
        soup.faces.extend((0..m as u32).map(|i| {
            let next = (i + 1) % m as u32;
            if height > 0.0 { vec![i, next, apex] } else { vec![next, i, apex] }
        }));
    }
    soup
}

fn circle(n: usize, radius: f64, height: f64) -> impl Iterator<Item = [f64; 3]> {
    (0..n).map(move |i| {
        let turn = TAU * i as f64 / n as f64;
        [radius * turn.cos(), radius * turn.sin(), height]
    })
}
