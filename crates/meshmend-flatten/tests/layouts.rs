//! What a layout promises, on meshes whose layout is known or whose trouble is.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_core::{FaceId, FaceTableBuilder, Id, PolygonMesh, VertexId};
use meshmend_flatten::{Boundary, Flatten, FlattenError, Layout, Weights, flatten, svg};
use meshmend_shapes::{
    Closed, NAMED_SHAPES, Shape, Sizes, annulus, bow_tie, disc, fan, out_and_back, polygon, strip, surface,
    torus,
};

fn laid_out(mesh: &PolygonMesh, boundary: Boundary, weights: Weights) -> Layout {
    flatten(mesh, &Flatten { boundary, weights }).unwrap()
}

fn mesh(places: Vec<[f64; 3]>, faces: &[Vec<u32>]) -> PolygonMesh {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    let table = builder.build(places.len()).unwrap();
    PolygonMesh::new(places, table).unwrap()
}

fn faces_of(mesh: &PolygonMesh) -> Vec<Vec<u32>> {
    let faces = mesh.faces();
    faces.faces().map(|face| faces.face_vertices(face).iter().map(|v| v.0).collect()).collect()
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let from_first = |p: &[f64; 2]| [p[0] - corners[0][0], p[1] - corners[0][1]];
    let pairs = corners.windows(2).map(|pair| [from_first(&pair[0]), from_first(&pair[1])]);
    pairs.map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
}

/// The area of each face in a layout.
fn areas(mesh: &PolygonMesh, layout: &Layout) -> Vec<f64> {
    let corners = |face: Vec<u32>| face.iter().map(|&v| layout.points[v as usize]).collect::<Vec<_>>();
    faces_of(mesh).into_iter().map(|face| area(&corners(face))).collect()
}

/// A tube of n rings of m vertices, closed at its far end: a disc that is long.
fn finger(m: usize, n: usize) -> PolygonMesh {
    let ring = |z: usize| (0..m).map(move |i| (z, std::f64::consts::TAU * i as f64 / m as f64));
    let place = |(z, turn): (usize, f64)| [turn.cos(), turn.sin(), z as f64];
    let mut places: Vec<[f64; 3]> = (0..n).flat_map(ring).map(place).collect();
    places.push([0.0, 0.0, n as f64]);
    let at = |z: usize, i: usize| (z * m + i % m) as u32;
    let mut faces = Vec::new();
    for i in 0..m {
        for z in 0..n - 1 {
            let [a, b, c, d] = [at(z, i), at(z, i + 1), at(z + 1, i + 1), at(z + 1, i)];
            faces.extend([vec![a, b, c], vec![a, c, d]]);
        }
        faces.push(vec![at(n - 1, i), at(n - 1, i + 1), (m * n) as u32]);
    }
    mesh(places, &faces)
}

#[track_caller]
fn assert_near(found: &[[f64; 2]], expected: impl Iterator<Item = [f64; 2]>) {
    for (vertex, (found, expected)) in found.iter().zip(expected).enumerate() {
        let distance = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        assert!(distance < 1e-12, "v{vertex} is at {found:?} in place of {expected:?}");
    }
}

#[test]
fn a_grid_in_a_square_is_the_grid() {
    for n in [1, 2, 5, 16] {
        let quads = disc(n, n).unwrap();
        let triangles = quads.triangulated().unwrap();
        for (shape, weights) in [&quads, &triangles]
            .into_iter()
            .flat_map(|shape| [(shape, Weights::Uniform), (shape, Weights::Cotangent)])
        {
            let layout = laid_out(&shape.mesh, Boundary::Square, weights);
            assert_near(
                &layout.points,
                shape.mesh.positions().iter().map(|p| [p[0] / n as f64, p[1] / n as f64]),
            );
            assert!(n == 1 || layout.is_one_to_one(), "{n} {weights:?}");
        }
    }
}

/// A harmonic map reproduces what is linear, whatever the triangles.
#[test]
fn what_is_flat_already_is_its_own_harmonic_layout() {
    let grid = disc(9, 9).unwrap().triangulated().unwrap().mesh;
    let moved = |p: &[f64; 3]| {
        let is_inner = p[..2].iter().all(|&x| x > 0.0 && x < 9.0);
        let shift = if is_inner { 0.35 * (7.0 * p[0] + 3.0 * p[1]).sin() } else { 0.0 };
        [p[0] + shift, p[1] - 0.8 * shift, 0.0]
    };
    let places: Vec<[f64; 3]> = grid.positions().iter().map(moved).collect();
    let bent = grid.with_positions(places.clone()).unwrap();
    let layout = laid_out(&bent, Boundary::Square, Weights::Cotangent);
    assert_near(&layout.points, places.iter().map(|p| [p[0] / 9.0, p[1] / 9.0]));
    assert!(layout.is_one_to_one());
}

#[test]
fn a_single_face_is_a_regular_polygon() {
    for n in [3, 4, 7, 100] {
        let layout = laid_out(&polygon(n).unwrap().mesh, Boundary::Circle, Weights::Uniform);
        let point = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        assert_near(&layout.points, (0..n).map(point).map(|(y, x)| [0.5 + 0.5 * x, 0.5 + 0.5 * y]));
        assert!(layout.is_one_to_one());
    }
}

/// Every disc of the catalogue, closed ones with a hole cut in, in quads and triangles, coarse and fine.
fn discs() -> Vec<Shape> {
    let mut shapes: Vec<Shape> =
        NAMED_SHAPES.iter().map(|one| one.make(&Sizes::default()).unwrap()).collect();
    shapes.extend((1..=4).map(|n| surface(Closed::Handles(0), 1, n).unwrap()));
    shapes.extend((1..=9).flat_map(|n| [fan(n).unwrap(), strip(n).unwrap(), disc(n, 3).unwrap()]));
    shapes.retain(|shape| shape.truth.genus == Some(0) && shape.truth.boundary_loops == Some(1));
    let finer = shapes.iter().map(|shape| shape.refined().unwrap()).collect::<Vec<_>>();
    shapes.extend(finer);
    let triangles = shapes.iter().map(|shape| shape.triangulated().unwrap()).collect::<Vec<_>>();
    shapes.extend(triangles);
    shapes
}

#[test]
fn no_face_is_flipped_on_a_circle() {
    let shapes = discs();
    assert!(shapes.len() > 100);
    for shape in shapes {
        let layout = laid_out(&shape.mesh, Boundary::Circle, Weights::Uniform);
        assert!(layout.is_one_to_one(), "{}", shape.name);
        assert!(areas(&shape.mesh, &layout).iter().all(|&area| area > 0.0), "{}", shape.name);
        assert!(layout.points.iter().flatten().all(|x| (0.0..=1.0).contains(x)), "{}", shape.name);
    }
}

/// On a square the faces cover it, none is flipped, and those that collapse are those with all corners on a side.
#[test]
fn what_collapses_on_a_square_is_named() {
    let mut collapsed = 0;
    for shape in discs().iter().filter(|shape| shape.truth.vertices > 8) {
        let layout = laid_out(&shape.mesh, Boundary::Square, Weights::Uniform);
        assert_eq!(layout.flipped, [], "{}", shape.name);
        let areas = areas(&shape.mesh, &layout);
        assert!((areas.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{}", shape.name);
        let faces = faces_of(&shape.mesh);
        let on = |v: u32, axis: usize, value: f64| layout.points[v as usize][axis] == value;
        let is_flat = |face: &[u32]| {
            [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)]
                .iter()
                .any(|&(axis, value)| face.len() == 3 && face.iter().all(|&v| on(v, axis, value)))
        };
        let flat: Vec<FaceId> =
            (0..).map(FaceId).zip(&faces).filter(|(_, face)| is_flat(face)).map(|(f, _)| f).collect();
        assert_eq!(layout.collapsed, flat, "{}", shape.name);
        collapsed += flat.len();
    }
    assert!(collapsed > 0);
}

/// Far down a finger equal weights leave rings smaller than doubles resolve; lower ones there make room.
#[test]
fn a_long_finger_needs_reweighting_and_is_laid_out() {
    let short = laid_out(&finger(12, 12), Boundary::Circle, Weights::Uniform);
    assert_eq!((short.rounds, short.is_one_to_one()), (0, true));
    let finger = finger(12, 120);
    let layout = laid_out(&finger, Boundary::Circle, Weights::Uniform);
    assert!(layout.rounds > 0 && layout.is_one_to_one());
    assert!(areas(&finger, &layout).iter().all(|&area| area > 0.0));
    // Harmonic weights are what they are: what became too small is named.
    let harmonic = laid_out(&finger, Boundary::Circle, Weights::Cotangent);
    assert_eq!(harmonic.rounds, 0);
    assert!(!harmonic.is_one_to_one());
}

/// A rugged surface has obtuse triangles, and negative weights.
#[test]
fn faces_that_a_harmonic_layout_flips_are_named() {
    let grid = disc(12, 12).unwrap().triangulated().unwrap().mesh;
    let height = |p: &[f64; 3]| [p[0], p[1], 9.0 * (11.0 * p[0] + 17.0 * p[1] * p[1]).sin()];
    let rugged = grid.positions().iter().map(height).collect();
    let rugged = grid.with_positions(rugged).unwrap();
    let layout = laid_out(&rugged, Boundary::Circle, Weights::Cotangent);
    let areas = areas(&rugged, &layout);
    assert!(areas.iter().all(|area| area.abs() > 1e-14), "far enough from zero for doubles to tell");
    let negative = (0..).map(FaceId).zip(&areas).filter(|&(_, &area)| area < 0.0).map(|(face, _)| face);
    assert_eq!(layout.flipped, negative.collect::<Vec<_>>());
    assert!(!layout.flipped.is_empty() && layout.collapsed.is_empty());
    assert!(laid_out(&rugged, Boundary::Circle, Weights::Uniform).is_one_to_one());
}

#[test]
fn faces_may_run_either_way_round() {
    let grid = disc(4, 4).unwrap().mesh;
    let mut faces = faces_of(&grid);
    faces.iter_mut().skip(1).step_by(2).for_each(|face| face.reverse());
    let turned = mesh(grid.positions().to_vec(), &faces);
    for boundary in [Boundary::Circle, Boundary::Square] {
        let one = laid_out(&grid, boundary, Weights::Uniform);
        let other = laid_out(&turned, boundary, Weights::Uniform);
        assert_near(&other.points, one.points.iter().copied());
        assert!(other.is_one_to_one());
    }
}

#[test]
fn several_discs_lie_beside_one_another() {
    let grid = disc(2, 2).unwrap().mesh;
    let count = grid.counts().vertices as u32;
    let copies = 5;
    let places = grid.positions().repeat(copies);
    let moved = |copy: usize| {
        faces_of(&grid).into_iter().map(move |face| face.iter().map(|v| v + copy as u32 * count).collect())
    };
    let faces: Vec<Vec<u32>> = (0..copies).flat_map(moved).collect();
    let mut places = places;
    places.push([9.0; 3]);
    let mesh = mesh(places, &faces);
    let layout = laid_out(&mesh, Boundary::Square, Weights::Uniform);
    assert!(layout.discs == 5 && layout.is_one_to_one());
    assert_eq!(layout.points.last(), Some(&[0.0; 2]), "the vertex in no face");
    let bounds = |disc: &[[f64; 2]]| {
        let ends = |axis: usize| {
            disc.iter().map(|p| p[axis]).fold([1.0f64, 0.0], |[low, high], x| [low.min(x), high.max(x)])
        };
        [ends(0), ends(1)]
    };
    let boxes: Vec<_> = layout.points[..copies * count as usize].chunks(count as usize).map(bounds).collect();
    for (i, one) in boxes.iter().enumerate() {
        let apart = |other: &[[f64; 2]; 2]| {
            (0..2).any(|axis| one[axis][0] > other[axis][1] || one[axis][1] < other[axis][0])
        };
        assert!(boxes[..i].iter().all(apart));
    }
}

/// A torus cut along two loops through one vertex: its opposite sides are two sides of one cut.
fn torus_cut_open(n: usize) -> PolygonMesh {
    let (ring, grid) = (torus(n, n).unwrap().mesh, disc(n, n).unwrap().mesh);
    let place = |p: &[f64; 3]| ring.positions()[(p[0] as usize % n) * n + p[1] as usize % n];
    let places: Vec<[f64; 3]> = grid.positions().iter().map(place).collect();
    grid.with_positions(places).unwrap()
}

#[test]
fn the_sides_of_a_cut_torus_match() {
    let n = 8;
    let open = torus_cut_open(n);
    let at = |i: usize, j: usize| VertexId::new(i * (n + 1) + j);
    let corners = [at(0, 0), at(n, 0), at(n, n), at(0, n)];
    for corners in [corners, [corners[2], corners[0], corners[3], corners[1]]] {
        let layout = laid_out(&open, Boundary::SquareAt(corners), Weights::Uniform);
        assert!(layout.is_one_to_one());
        let point = |v: VertexId| layout.points[v.index()];
        assert_eq!(point(corners[0]), [0.0, 0.0]);
        for i in 0..=n {
            let [low, high, left, right] = [at(i, 0), at(i, n), at(0, i), at(n, i)].map(point);
            let along = |a: [f64; 2], b: [f64; 2]| a[0] == b[0] || a[1] == b[1];
            assert!(along(low, high) && along(left, right), "{low:?} {high:?} {left:?} {right:?}");
        }
    }
}

#[test]
fn nothing_is_laid_out_as_nothing() {
    for boundary in [Boundary::Circle, Boundary::Square] {
        let layout = laid_out(&mesh(vec![[1.0; 3]; 2], &[vec![0, 1, 0]]), boundary, Weights::Uniform);
        assert_eq!((layout.discs, layout.points.len(), layout.is_one_to_one()), (0, 2, true));
    }
}

#[test]
fn what_is_no_disc_is_refused_with_its_name() {
    let refused = |shape: Shape| flatten(&shape.mesh, &Flatten::default()).unwrap_err();
    let not =
        |name: Option<&str>| FlattenError::NotADisc { vertex: VertexId(0), name: name.map(str::to_owned) };
    assert_eq!(refused(torus(3, 3).unwrap()), not(Some("torus")));
    assert_eq!(refused(annulus(3, 1).unwrap()), not(Some("annulus")));
    assert_eq!(refused(bow_tie().unwrap()), not(None));
    assert_eq!(
        refused(bow_tie().unwrap()).to_string(),
        "the component of v0 is not a surface: only a disc can be laid out, so cut it open first"
    );
    assert_eq!(refused(out_and_back(4).unwrap()), not(Some("sphere")));
}

#[test]
fn what_cannot_be_laid_out_says_why() {
    // A face that is joined to itself along an edge: a disc with a slit closed.
    let slit = mesh((0..5).map(|i| [i as f64, (i * i) as f64, 0.0]).collect(), &[vec![0, 1, 2, 3, 4, 3]]);
    let wrong = flatten(&slit, &Flatten::default()).unwrap_err();
    assert_eq!(wrong, FlattenError::NonSimpleFace { face: FaceId(0) });
    let square = |boundary| Flatten { boundary, ..Flatten::default() };
    let wrong = flatten(&polygon(3).unwrap().mesh, &square(Boundary::Square)).unwrap_err();
    assert_eq!(wrong, FlattenError::NoSquare { vertex: VertexId(0) });
    let grid = disc(2, 2).unwrap().mesh;
    for corners in [[0, 2, 8, 4], [0, 0, 2, 8], [0, 2, 6, 99]] {
        let wrong = flatten(&grid, &square(Boundary::SquareAt(corners.map(VertexId)))).unwrap_err();
        assert_eq!(wrong, FlattenError::NoSquare { vertex: VertexId(0) }, "{corners:?}");
    }
    let harmonic = Flatten { weights: Weights::Cotangent, ..Flatten::default() };
    let line = mesh((0..4).map(|i| [i as f64, 0.0, 0.0]).collect(), &[vec![0, 1, 2], vec![2, 1, 3]]);
    assert_eq!(flatten(&line, &harmonic).unwrap_err(), FlattenError::NoCotangent { face: FaceId(0) });
}

/// Positions only measure the boundary, and need not be numbers.
#[test]
fn lengths_that_are_no_numbers_are_taken_as_equal() {
    let grid = disc(6, 6).unwrap().triangulated().unwrap().mesh;
    for wrong in [f64::NAN, f64::INFINITY, 1e300, 0.0] {
        let places = grid.positions().iter().map(|p| p.map(|x| x * wrong)).collect();
        let wild = grid.clone().with_positions(places).unwrap();
        assert!(laid_out(&wild, Boundary::Circle, Weights::Uniform).is_one_to_one(), "{wrong}");
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let mesh = finger(12, 100);
    let work = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| laid_out(&mesh, Boundary::Circle, Weights::Uniform))
    };
    let bits = |layout: Layout| layout.points.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    let one = bits(work(1));
    assert!([2, 8].iter().all(|&threads| bits(work(threads)) == one));
}

#[test]
fn a_picture_has_a_path_a_face_and_marks_the_bad_ones() {
    let row = fan(40).unwrap().mesh;
    let layout = laid_out(&row, Boundary::Square, Weights::Uniform);
    let picture = svg(&row, &layout);
    assert_eq!(picture.matches("<path").count(), 40);
    assert!(!layout.collapsed.is_empty());
    assert_eq!(picture.matches("class=\"collapsed\"").count(), layout.collapsed.len());
    assert!(picture.starts_with("<svg") && picture.ends_with("</svg>\n"));
}
