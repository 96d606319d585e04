//! Complexes that branch along edges or touch in vertices: no manifolds, but each figure is known.

use std::f64::consts::TAU;

use meshmend_core::{PolygonMesh, VertexId};

use crate::mesh_builder::{MeshBuilder, at_least, circle};
use crate::platonic::{tetrahedron_sketch, unit_box};
use crate::{Closed, Shape, ShapeError};

/// n triangles along one edge, all through it the same way. V = n + 2, E = 2n + 1, F = n, β = (1, 0, 0); a disc while
/// n ≤ 2, and then inconsistent for n = 2.
///
/// # Errors
/// When n is 0 or too large.
pub fn book(n: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of pages", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 3])?;
    builder.points([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    builder.points(circle(n, 1.0, 0.5));
    (0..n as u32).for_each(|page| builder.face(&[0, 1, page + 2]));
    let (name, counts) = (format!("book of {n}"), [n + 2, 2 * n + 1, n]);
    if n <= 2 {
        builder.surface(name, Closed::Handles(0), 1, counts)
    } else {
        builder.branched(name, [1, 0, 0], counts)
    }
}

/// Three triangles on one edge. V = 5, E = 7, F = 3, β = (1, 0, 0).
///
/// # Errors
/// None: it is small.
pub fn three_triangles_on_an_edge() -> Result<Shape, ShapeError> {
    book(3)
}

/// n tubes of three quads, one inside the other, that share one edge. V = 4n + 2, E = 8n + 1, F = 3n,
/// β = (1, n, 0); an annulus for n = 1.
///
/// Round the edge the 2n sides are nested like brackets, and each tube is a sheet of its own.
///
/// # Errors
/// When n is 0 or too large.
pub fn nested_pages(n: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of tubes", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 12])?;
    builder.points([[0.0; 3], [0.0, 0.0, 1.0]]);
    for page in 0..n {
        let (wide, long) = ((page + 1) as f64, (page + 2) as f64 * n as f64);
        let base = builder.next();
        for [x, y] in [[long, -wide], [long, wide]] {
            builder.points([[x, y, 0.0], [x, y, 1.0]]);
        }
        let [out_low, out_high, back_low, back_high] = [base, base + 1, base + 2, base + 3];
        builder.face(&[0, out_low, out_high, 1]);
        builder.face(&[out_low, back_low, back_high, out_high]);
        builder.face(&[back_low, 0, 1, back_high]);
    }
    let (name, counts) = (format!("{n} nested pages"), [4 * n + 2, 8 * n + 1, 3 * n]);
    if n == 1 {
        builder.surface(name, Closed::Handles(0), 2, counts)
    } else {
        builder.branched(name, [1, n, 0], counts)
    }
}

/// Two tetrahedra that share a vertex. V = 7, E = 12, F = 8, β = (1, 0, 2).
///
/// # Errors
/// None: it is small.
pub fn two_tetrahedra_on_a_vertex() -> Result<Shape, ShapeError> {
    let (solid, centre) = (tetrahedron_sketch().mesh()?, VertexId(0));
    let builder = with_copy(&solid, solid.position(centre), [1.0, 0.0, 0.0], &[centre]);
    builder.branched("two tetrahedra on a vertex", [1, 0, 2], [7, 12, 8])
}

/// Two tetrahedra that share an edge. V = 6, E = 11, F = 8, β = (1, 0, 2).
///
/// # Errors
/// None: it is small.
pub fn two_tetrahedra_on_an_edge() -> Result<Shape, ShapeError> {
    let builder = with_copy_on_edge(&tetrahedron_sketch().mesh()?);
    builder.branched("two tetrahedra on an edge", [1, 0, 2], [6, 11, 8])
}

/// Two cubes that share an edge, each on the other side of it. V = 14, E = 23, F = 12, β = (1, 0, 2).
///
/// # Errors
/// None: it is small.
pub fn two_boxes_on_an_edge() -> Result<Shape, ShapeError> {
    let builder = with_copy_on_edge(&unit_box().mesh()?);
    builder.branched("two boxes on an edge", [1, 0, 2], [14, 23, 12])
}

/// n tetrahedra that share one vertex: n closed umbrellas there. V = 3n + 1, E = 6n, F = 4n, β = (1, 0, n).
///
/// # Errors
/// When n is 0 or too large.
pub fn umbrellas(n: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of tetrahedra", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 12])?;
    builder.point([0.0; 3]);
    for cone in 0..n {
        let (a, height) = (builder.next(), (cone + 1) as f64);
        builder.points([[1.0, 0.0, height], [-0.5, 1.0, height], [-0.5, -1.0, height]]);
        let [b, c] = [a + 1, a + 2];
        [[0, b, a], [0, c, b], [0, a, c], [a, b, c]].iter().for_each(|face| builder.face(face));
    }
    let (name, counts) = (format!("{n} umbrellas"), [3 * n + 1, 6 * n, 4 * n]);
    if n == 1 {
        builder.surface(name, Closed::Handles(0), 0, counts)
    } else {
        builder.branched(name, [1, 0, n], counts)
    }
}

/// Two triangles that share a vertex. V = 5, E = 6, F = 2, β = (1, 0, 0); pinched, with open fans only.
///
/// # Errors
/// None: it is small.
pub fn bow_tie() -> Result<Shape, ShapeError> {
    let mut builder = MeshBuilder::default();
    builder.points([[0.0; 3], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0]]);
    builder.face(&[0, 1, 2]);
    builder.face(&[0, 3, 4]);
    builder.branched("bow tie", [1, 0, 0], [5, 6, 2])
}

/// A sphere of r rings of m vertices whose two poles are one vertex: a torus with a meridian shrunk to a point.
/// V = rm + 1, E = (2r + 1)m, F = (r + 1)m, β = (1, 1, 1); r ≥ 2, m ≥ 3.
///
/// # Errors
/// When r or m is too small or the mesh too large.
pub fn pinched_torus(rings: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(2, "the number of rings", rings)?;
    at_least(3, "the number of vertices a ring", m)?;
    let mut builder = MeshBuilder::with_room(&[rings.saturating_add(1), m, 4])?;
    let point = |ring: usize, i: usize| (1 + ring * m + i % m) as u32;
    builder.point([0.0; 3]);
    for ring in 0..rings {
        let turn = TAU * (ring + 1) as f64 / (rings + 1) as f64;
        let thin = circle(m, 0.5 * (turn / 2.0).sin(), 0.0);
        builder.points(thin.map(|[x, y, _]| [(1.0 + x) * (1.0 - turn.cos()), (1.0 + x) * turn.sin(), y]));
    }
    for i in 0..m {
        builder.face(&[0, point(0, i + 1), point(0, i)]);
        for (near, far) in (1..rings).map(|far| (far - 1, far)) {
            builder.face(&[point(near, i), point(near, i + 1), point(far, i + 1), point(far, i)]);
        }
        builder.face(&[point(rings - 1, i), point(rings - 1, i + 1), 0]);
    }
    let counts = [rings * m + 1, (2 * rings + 1) * m, (rings + 1) * m];
    builder.branched(format!("pinched torus of {rings} rings of {m}"), [1, 1, 1], counts)
}

/// A bipyramid with its equator, of m edges, filled by one face. V = m + 2, E = 3m, F = 2m + 1, β = (1, 0, 2); m ≥ 3.
///
/// # Errors
/// When m is below 3 or too large.
pub fn sphere_with_membrane(m: usize) -> Result<Shape, ShapeError> {
    let mut builder = cones(m, &[1.0, -1.0])?;
    builder.face(&(0..m as u32).collect::<Vec<_>>());
    builder.branched(format!("sphere with a membrane of {m} edges"), [1, 0, 2], [m + 2, 3 * m, 2 * m + 1])
}

/// Three cones on one circle of m edges. V = m + 3, E = 4m, F = 3m, β = (1, 0, 2); m ≥ 3.
///
/// # Errors
/// When m is below 3 or too large.
pub fn three_hemispheres(m: usize) -> Result<Shape, ShapeError> {
    let builder = cones(m, &[1.0, 2.0, -1.0])?;
    builder.branched(format!("three hemispheres on a circle of {m} edges"), [1, 0, 2], [m + 3, 4 * m, 3 * m])
}

/// A block of a × b × c cells with all walls between them. V = (a + 1)(b + 1)(c + 1), E = Σ a(b + 1)(c + 1),
/// F = Σ (a + 1)bc, over the three directions; β = (1, 0, abc).
///
/// Away from the twelve edges of the block each face is a patch of its own: the worst case of Betti numbers by
/// patches. A cube for one cell.
///
/// # Errors
/// When a size is 0 or the block too large.
pub fn foam(a: usize, b: usize, c: usize) -> Result<Shape, ShapeError> {
    let size = [a, b, c];
    size.iter().try_for_each(|&cells| at_least(1, "the number of cells", cells))?;
    let [over_a, over_b, over_c] = size.map(|cells| cells.saturating_add(1));
    let mut builder = MeshBuilder::with_room(&[12, over_a, over_b, over_c])?;
    let point = |p: [usize; 3]| ((p[0] * (b + 1) + p[1]) * (c + 1) + p[2]) as u32;
    for p in blocks([a + 1, b + 1, c + 1]) {
        builder.point(p.map(|x| x as f64));
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            if p[u] < size[u] && p[v] < size[v] {
                let moved = |du, dv| point(plus(plus(p, u, du), v, dv));
                builder.face(&[moved(0, 0), moved(1, 0), moved(1, 1), moved(0, 1)]);
            }
        }
    }
    let edges = a * (b + 1) * (c + 1) + (a + 1) * b * (c + 1) + (a + 1) * (b + 1) * c;
    let faces = (a + 1) * b * c + a * (b + 1) * c + a * b * (c + 1);
    let (name, counts) = (format!("foam of {a}x{b}x{c}"), [(a + 1) * (b + 1) * (c + 1), edges, faces]);
    if a * b * c == 1 {
        builder.surface(name, Closed::Handles(0), 0, counts)
    } else {
        builder.branched(name, [1, 0, a * b * c], counts)
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

fn with_copy_on_edge(solid: &PolygonMesh) -> MeshBuilder {
    let edge = [0, 1].map(VertexId);
    let [from, to] = edge.map(|v| solid.position(v));
    with_copy(solid, from, [0, 1, 2].map(|i| to[i] - from[i]), &edge)
}

/// A solid and a copy of it, turned by half a turn about an axis through a point; some vertices are shared.
///
/// Half a turn keeps what lies on the axis, and the orientation.
fn with_copy(solid: &PolygonMesh, centre: [f64; 3], axis: [f64; 3], shared: &[VertexId]) -> MeshBuilder {
    let square: f64 = axis.iter().map(|x| x * x).sum();
    let turned = |p: [f64; 3]| {
        let along: f64 = (0..3).map(|i| (p[i] - centre[i]) * axis[i]).sum::<f64>() / square;
        [0, 1, 2].map(|i| 2.0 * (centre[i] + along * axis[i]) - p[i])
    };
    let mut builder = MeshBuilder::default();
    builder.points(solid.positions().iter().copied());
    let mut names = Vec::new();
    for (v, &place) in (0..).map(VertexId).zip(solid.positions()) {
        names.push(if shared.contains(&v) { v.0 } else { builder.point(turned(place)) });
    }
    let faces = solid.faces();
    for face in faces.faces() {
        builder.face(&faces.face_vertices(face).iter().map(|v| v.0).collect::<Vec<_>>());
    }
    for face in faces.faces() {
        builder.face(&faces.face_vertices(face).iter().map(|v| names[v.0 as usize]).collect::<Vec<_>>());
    }
    builder
}

/// A circle of m vertices and an apex above or below it for each height; cones above look up, those below down.
fn cones(m: usize, heights: &[f64]) -> Result<MeshBuilder, ShapeError> {
    at_least(3, "the number of edges", m)?;
    let mut builder = MeshBuilder::with_room(&[12, m])?;
    builder.points(circle(m, 1.0, 0.0));
    for &height in heights {
        let apex = builder.point([0.0, 0.0, height]);
        for (i, next) in (0..m as u32).map(|i| (i, (i + 1) % m as u32)) {
            builder.face(&if height > 0.0 { [i, next, apex] } else { [next, i, apex] });
        }
    }
    Ok(builder)
}
