//! Faces with holes stay open: what they are cut into, and what the whole repair makes of them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Defect, DefectKind, FaceId, PolygonMesh, VertexId};
use meshmend_repair::{PassKind, Pipeline, Plan, Repaired, TriangulateFaces};
use meshmend_testkit::{Soup, reference};

/// A flat face by the points of its corners; those at one point are one vertex.
fn face(corners: &[[f64; 2]]) -> Soup {
    solid(&[&corners.iter().map(|&[x, y]| [x, y, 0.0]).collect::<Vec<_>>()])
}

/// Faces by the points of their corners; those at one point are one vertex.
fn solid(faces: &[&[[f64; 3]]]) -> Soup {
    let mut soup = Soup::default();
    for face in faces {
        let mut vertex = |point: &[f64; 3]| {
            let known = soup.positions.iter().position(|p| p == point);
            known.unwrap_or_else(|| {
                soup.positions.push(*point);
                soup.positions.len() - 1
            }) as u32
        };
        let vertices = face.iter().map(&mut vertex).collect();
        soup.faces.push(vertices);
    }
    soup
}

fn plan(faces: TriangulateFaces) -> Plan {
    let mut plan = Plan::default();
    plan.triangulate.faces = faces;
    plan
}

fn repair(soup: &Soup) -> Repaired {
    Plan::default().pipeline().run(&soup.mesh()).unwrap()
}

/// The sum of all areas.
fn area(mesh: &PolygonMesh) -> f64 {
    let faces = mesh.faces();
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let of = |face| {
        let points: Vec<[f64; 3]> = faces.face_vertices(face).iter().map(|&v| mesh.position(v)).collect();
        let sides = points.iter().zip(points.iter().cycle().skip(1));
        let sum =
            sides.map(|(&a, &b)| cross(a, b)).fold([0.0; 3], |s, c| [s[0] + c[0], s[1] + c[1], s[2] + c[2]]);
        sum.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0
    };
    faces.faces().map(of).sum()
}

/// Repairs a mesh with each way of cutting triangles, twice: its area and χ are these, and the second repair changes
/// nothing. Each face with a hole has right pieces after `clean`.
#[track_caller]
fn assert_stays_open(soup: &Soup, expected_area: f64, euler_characteristic: i64) {
    for faces in [None, Some(TriangulateFaces::Auto), Some(TriangulateFaces::All)] {
        let plan = match faces {
            None => Plan::default().without(PassKind::Triangulate),
            Some(faces) => plan(faces),
        };
        let pipeline = plan.pipeline();
        let once = pipeline.run(&soup.mesh()).unwrap();
        let report = once.topology.as_ref().unwrap();
        assert_eq!(report.euler_characteristic, euler_characteristic, "{faces:?}");
        let found = area(&once.mesh);
        assert!((found - expected_area).abs() < 1e-9 * expected_area, "{faces:?}: {found}");
        let kept = Soup::of_mesh(&once.mesh);
        assert_eq!(reference::broken_postconditions(kept.vertex_count(), &kept.faces), [""; 0]);
        let twice = pipeline.run(&once.mesh).unwrap();
        assert_eq!(Soup::of_mesh(&twice.mesh), kept, "{faces:?}: a second repair changes the mesh");
    }
    let positions = reference::exact_positions(soup);
    let cleaned = cleaned(soup);
    // Of repeated faces the first is left.
    let are_repeated = !named(&cleaned, DefectKind::DuplicateFace).is_empty();
    let holes = reference::faces_with_holes(&positions, &soup.faces);
    for hole in holes.into_iter().take(if are_repeated { 1 } else { usize::MAX }) {
        let word = reference::word_of(&positions, &soup.faces[hole as usize]);
        let pieces = pieces_of(&cleaned, hole);
        assert_eq!(reference::hole_faults(&positions, &word, &pieces), [""; 0], "face {hole}: {pieces:?}");
    }
}

fn cleaned(soup: &Soup) -> Repaired {
    let plan = Plan { passes: vec![PassKind::Weld, PassKind::Clean], ..Plan::default() };
    plan.pipeline().run(&soup.mesh()).unwrap()
}

fn pieces_of(cleaned: &Repaired, face: u32) -> Vec<Vec<u32>> {
    let faces = cleaned.mesh.faces();
    let pieces = faces.faces().filter(|&f| cleaned.provenance.faces.of(f) == Some(FaceId(face)));
    let lowest = |v: &VertexId| cleaned.provenance.vertices.of(*v).unwrap().0;
    pieces.map(|f| faces.face_vertices(f).iter().map(lowest).collect()).collect()
}

fn named(repaired: &Repaired, kind: DefectKind) -> Vec<Defect> {
    let all = repaired.passes.iter().flat_map(|pass| pass.fixed.iter());
    all.filter(|defect| defect.kind() == kind).collect()
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
const HOLE: [[f64; 2]; 5] = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0]];

fn ring() -> Vec<[f64; 2]> {
    [&SQUARE[..], &SQUARE[..1], &HOLE].concat()
}

#[test]
fn a_ring_stays_a_ring() {
    assert_stays_open(&face(&ring()), 12.0, 0);
    let ring = repair(&face(&ring()));
    let holes = named(&ring, DefectKind::FaceWithHole);
    assert_eq!(holes.len(), 1);
    assert_eq!(named(&ring, DefectKind::NonSimpleFace), []);
}

/// The other way round, begun anywhere, seen from any side, and far from the origin.
#[test]
fn a_ring_stays_a_ring_however_it_lies() {
    let ring = ring();
    for start in 0..ring.len() {
        let begun = [&ring[start..], &ring[..start]].concat();
        let reversed: Vec<[f64; 2]> = begun.iter().rev().copied().collect();
        for corners in [begun, reversed] {
            assert_stays_open(&face(&corners), 12.0, 0);
            let tilted: Vec<[f64; 3]> = corners.iter().map(|&[x, y]| [y, x + 7.0, x + y - 9.0]).collect();
            assert_stays_open(&solid(&[&tilted]), 12.0 * 3.0f64.sqrt(), 0);
            let far: Vec<[f64; 3]> =
                corners.iter().map(|&[x, y]| [4e5 + x / 8.0, 5e6 + y / 8.0, 100.0]).collect();
            assert_stays_open(&solid(&[&far]), 12.0 / 64.0, 0);
        }
    }
}

/// As many exporters write it: the bridge has vertices of its own.
#[test]
fn a_bridge_of_doubled_vertices_is_stitched() {
    let mut soup = Soup { positions: Vec::new(), faces: vec![(0..10).collect()] };
    soup.positions = ring().iter().map(|&[x, y]| [x, y, 0.0]).collect();
    assert_stays_open(&soup, 12.0, 0);
}

#[test]
fn several_holes_stay_open_whichever_way_their_bridges_lead() {
    let rim = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    let hole = |x: f64, y: f64| [[x, y], [x, y + 1.0], [x + 1.0, y + 1.0], [x + 1.0, y], [x, y]];
    // Each from the corner of the rim.
    let fan = [&rim[..], &rim[..1], &hole(1.0, 5.0), &rim[..1], &hole(2.0, 2.0), &rim[..1], &hole(5.0, 1.0)];
    assert_stays_open(&face(&fan.concat()), 78.0, -2);
    // One from the other: the second hole hangs on a corner of the first.
    let nested = [&rim[..], &rim[..1], &hole(2.0, 2.0)[..3], &hole(5.0, 5.0), &hole(2.0, 2.0)[2..]];
    assert_stays_open(&face(&nested.concat()), 79.0, -1);
}

#[test]
fn a_hole_may_touch_the_rim_or_another_hole() {
    let rim = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    // In a corner of the rim: what is left is joined at that vertex alone, which is split.
    let touching = [&rim[..], &[[0.0, 0.0], [2.0, 4.0], [4.0, 2.0]]].concat();
    assert_stays_open(&face(&touching), 75.0, 1);
    // The second hole at a corner of the first, as one walk round both.
    let first = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0]];
    let second = [[3.0, 5.0], [5.0, 5.0], [5.0, 3.0], [3.0, 3.0]];
    let both = [&rim[..], &rim[..1], &first, &second, &[[3.0, 1.0], [1.0, 1.0]]].concat();
    assert_stays_open(&face(&both), 73.0, 0);
    // The same holes, each on a bridge of its own.
    let lower = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0]];
    let upper = [[3.0, 5.0], [5.0, 5.0], [5.0, 3.0], [3.0, 3.0], [3.0, 5.0]];
    let apart = [&rim[..], &upper, &rim[3..], &rim[..1], &lower].concat();
    let found = repair(&face(&apart));
    assert!((area(&found.mesh) - 73.0).abs() < 1e-9, "{}", area(&found.mesh));
    assert_eq!(named(&found, DefectKind::CrossingFace), []);
}

/// Bridges may lead to the reflex corners of a rim; a hole may be as small as numbers allow.
#[test]
fn rims_may_be_concave_and_holes_tiny() {
    let rim = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.0, 4.0], [0.0, 8.0]];
    let hole = [[3.0, 1.0], [3.0, 2.0], [5.0, 2.0], [5.0, 1.0], [3.0, 1.0]];
    let concave = [&rim[..4], &hole[1..4], &hole[..2], &rim[3..]].concat();
    assert_stays_open(&face(&concave), 46.0, 0);
    for size in [1e-3, 1e-9, f64::EPSILON] {
        let tiny = HOLE.map(|p| p.map(|x| 1.0 + size * x));
        let soup = face(&[&SQUARE[..], &SQUARE[..1], &tiny].concat());
        assert_stays_open(&soup, 16.0 - 4.0 * size * size, 0);
    }
}

#[test]
fn a_rim_that_is_not_flat_keeps_its_hole() {
    let lifted = |[x, y]: [f64; 2]| [x, y, 0.1 * x * y];
    let corners: Vec<[f64; 3]> = ring().into_iter().map(lifted).collect();
    let soup = solid(&[&corners]);
    let positions = reference::exact_positions(&soup);
    let word = reference::word_of(&positions, &soup.faces[0]);
    assert_eq!(reference::hole_faults(&positions, &word, &pieces_of(&cleaned(&soup), 0)), [""; 0]);
    assert_eq!(repair(&soup).topology.unwrap().euler_characteristic, 0);
}

/// A block with a tunnel, both of whose ends are faces with a bridge: a torus.
#[test]
fn a_block_with_a_tunnel_is_a_torus() {
    assert_stays_open(&tunnel(1), 2.0 * 12.0 + 4.0 * 4.0 + 4.0 * 2.0, 0);
    assert_stays_open(&tunnel(3), 3.0 * (2.0 * 12.0 + 4.0 * 4.0 + 4.0 * 2.0), 0);
}

/// So many blocks beside each other, each with a tunnel.
fn tunnel(blocks: u32) -> Soup {
    let mut faces: Vec<Vec<[f64; 3]>> = Vec::new();
    for shift in (0..blocks).map(|block| 9.0 * f64::from(block)) {
        let at = |[x, y]: [f64; 2], z: f64| [x + shift, y, z];
        faces.push(ring().iter().map(|&p| at(p, 1.0)).collect());
        faces.push(ring().iter().rev().map(|&p| at(p, 0.0)).collect());
        for walk in [&[&SQUARE[..], &SQUARE[..1]].concat(), &HOLE[..]] {
            faces.extend(walk.windows(2).map(|side| {
                [at(side[0], 0.0), at(side[1], 0.0), at(side[1], 1.0), at(side[0], 1.0)].to_vec()
            }));
        }
    }
    solid(&faces.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

/// Both sides of a thin plate, and one side that is there twice.
#[test]
fn opposite_and_repeated_faces_with_a_hole() {
    let front: Vec<[f64; 3]> = ring().iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let back: Vec<[f64; 3]> = front.iter().rev().copied().collect();
    let plate = solid(&[&front, &back]);
    let found = repair(&plate);
    assert_eq!(found.topology.as_ref().unwrap().euler_characteristic, 0);
    assert!((area(&found.mesh) - 24.0).abs() < 1e-9);
    let twice = solid(&[&front, &[&front[3..], &front[..3]].concat()]);
    assert_stays_open(&twice, 12.0, 0);
    assert!(!named(&repair(&twice), DefectKind::DuplicateFace).is_empty());
    // The same object twice, with vertices of its own.
    let mut copies = solid(&[&front]);
    let again: Vec<u32> = copies.faces[0].iter().map(|v| v + 8).collect();
    copies.faces.push(again);
    copies.positions.extend(copies.positions.clone());
    assert_stays_open(&copies, 12.0, 0);
}

/// No diagonals cut it into pieces that turn as it does: all were tried.
#[test]
fn a_face_that_crosses_itself_is_split_into_its_loops_and_named() {
    let corners = [[2.0, 3.0], [1.0, 0.0], [0.0, 4.0], [4.0, 3.0], [2.0, 3.0], [0.0, 1.0], [4.0, 2.0]];
    let crossing = face(&corners);
    let expected = Defect::crossing_face(FaceId(0), VertexId(0));
    assert_eq!(named(&repair(&crossing), DefectKind::CrossingFace), [expected]);
    assert_eq!(pieces_of(&cleaned(&crossing), 0), [vec![0, 1, 2, 3], vec![0, 4, 5]]);
}

/// Loops that turn the same way are no holes.
#[test]
fn loops_that_turn_the_same_way_are_split() {
    let two = face(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]]);
    let found = repair(&two);
    assert_eq!(named(&found, DefectKind::NonSimpleFace).len(), 1);
    assert!((area(&found.mesh) - 2.0).abs() < 1e-12);
}

/// A sheet of thousands of holes is cut as fast as it is read.
#[test]
fn thousands_of_holes_in_one_face() {
    let (rows, columns) = (50u32, 60u32);
    let mut corners = vec![[0.0, 0.0], [f64::from(columns) + 1.0, 0.0]];
    corners.extend([[f64::from(columns) + 1.0, f64::from(rows) + 1.0], [0.0, f64::from(rows) + 1.0]]);
    for y in (1..=rows).rev().map(f64::from) {
        corners.push([0.0, y]);
        for x in (1..=columns).map(f64::from) {
            corners.extend([[x - 0.25, y], [x, y + 0.25], [x + 0.25, y]]);
        }
        for x in (1..=columns).rev().map(f64::from) {
            corners.extend((x < f64::from(columns)).then_some([x + 0.25, y]));
            corners.extend([[x, y - 0.25], [x - 0.25, y]]);
        }
        corners.push([0.0, y]);
    }
    let size = f64::from((rows + 1) * (columns + 1)) - f64::from(rows * columns) / 8.0;
    assert_stays_open(&face(&corners), size, 1 - i64::from(rows * columns));
}

/// The default pipeline and its promises.
#[test]
fn the_default_pipeline_says_what_it_cut() {
    let found = Pipeline::default().run(&tunnel(1).mesh()).unwrap();
    assert_eq!(named(&found, DefectKind::FaceWithHole).len(), 2);
}
