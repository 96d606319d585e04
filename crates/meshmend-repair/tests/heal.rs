//! What `heal` makes of vertices on open edges, and what it says of them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Carry, DefectKind, Domain, Layer, PolygonMesh, Values, VertexId, Watch};
use meshmend_repair::{
    Context, Heal, HealWithin, Outcome, Pass, PassKind, Pipeline, Repaired, TJunctionFate,
};
use meshmend_spatial::{shapes, t_junctions};

/// A triangle over two that share a vertex in the middle of its lower side, so far below it.
fn over_two(below: f64, lower: [[u32; 3]; 2]) -> PolygonMesh {
    let points = [[0.0, 0.0], [8.0, 0.0], [4.0, 6.0], [4.0, -below], [4.0, -6.0]];
    let [one, other] = lower;
    PolygonMesh::from_triangles(&points.map(|[x, y]| [x, y, 0.0]), &[[0, 1, 2], one, other]).unwrap()
}

const LOWER: [[u32; 3]; 2] = [[0, 4, 3], [3, 4, 1]];

fn healed(mesh: &PolygonMesh, within: HealWithin) -> Outcome {
    Heal { within }.apply(mesh, &Context::default()).unwrap()
}

fn repaired(mesh: &PolygonMesh, within: HealWithin) -> Repaired {
    let pipeline = Pipeline::default().with(Heal { within });
    let repaired = pipeline.run(mesh).unwrap();
    let again = pipeline.run(&repaired.mesh).unwrap();
    assert!(!again.is_changed(), "{:?}", again.passes);
    repaired
}

fn boundary_edges(mesh: &PolygonMesh) -> usize {
    let edges = mesh.complex().edges();
    edges.edges().filter(|&edge| edges.edge_corners(edge).len() == 1).count()
}

#[test]
fn a_vertex_on_an_edge_becomes_a_corner_there() {
    let mesh = over_two(0.0, LOWER);
    let outcome = healed(&mesh, HealWithin::Exact);
    let corners: Vec<u32> = outcome.mesh.faces().corner_vertices().iter().map(|vertex| vertex.0).collect();
    assert_eq!(corners, [0, 3, 1, 2, 0, 4, 3, 3, 4, 1]);
    let [record] = &outcome.t_junctions[..] else { panic!("{:?}", outcome.t_junctions) };
    assert_eq!(record.fate, TJunctionFate::Healed { foot: 0.5, short_edge: None });
    assert_eq!(record.to_string(), "v3 on the edge v0-v1 of f0, at distance 0e0: put in at 0.500000");
    let fixed: Vec<DefectKind> = outcome.fixed.iter().map(|defect| defect.kind()).collect();
    assert_eq!(fixed, [DefectKind::TJunction]);
    assert_eq!((boundary_edges(&mesh), boundary_edges(&outcome.mesh)), (7, 4));
}

#[test]
fn triangles_stay_triangles_and_none_loses_its_area() {
    let repaired = repaired(&over_two(0.0, LOWER), HealWithin::Exact);
    assert!(repaired.mesh.faces().is_all_triangles());
    assert_eq!((repaired.mesh.counts().faces, boundary_edges(&repaired.mesh)), (4, 4));
    assert!(t_junctions(&repaired.mesh, 0.0, &Watch::NOBODY).unwrap().is_empty());
    assert!(shapes(&repaired.mesh, 1000.0).zero_area.is_empty());
}

#[test]
fn neighbours_that_run_against_each_other_are_turned() {
    let repaired = repaired(&over_two(0.0, LOWER.map(|[a, b, c]| [c, b, a])), HealWithin::Exact);
    assert_eq!(boundary_edges(&repaired.mesh), 4);
    let turned =
        repaired.provenance.flipped.iter().map(|&face| repaired.provenance.faces.of(face).unwrap().0);
    assert_eq!(
        turned.collect::<Vec<_>>(),
        [0, 0],
        "both parts of the upper one are turned to the side of the others"
    );
    let run: Vec<PassKind> = repaired.passes.iter().map(|record| record.pass).collect();
    let turns = run.windows(4).any(|four| four[..3] == [PassKind::Orient, PassKind::Heal, PassKind::Orient]);
    assert!(turns, "{run:?}");
}

#[test]
fn a_new_corner_has_the_values_at_its_foot() {
    let mesh = over_two(0.0, LOWER);
    let values = vec![1.0, 5.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let layer = Layer::direct("u", Domain::Corner, 1, Carry::Interpolate, Values::F64(values));
    let outcome = healed(&mesh.with_layers(vec![layer]).unwrap(), HealWithin::Exact);
    let layer = &outcome.mesh.layers()[0];
    let values: Vec<Option<usize>> = (0..4).map(|corner| layer.value_of(corner)).collect();
    let Values::F64(pool) = layer.values() else { panic!("numbers stay numbers") };
    let values: Vec<f64> = values.into_iter().map(|value| pool[value.unwrap()]).collect();
    assert_eq!(values, [1.0, 3.0, 5.0, 9.0]);
}

#[test]
fn near_an_edge_is_on_it_from_a_distance_on() {
    let mesh = over_two(0.01, LOWER);
    for (within, count) in [
        (HealWithin::Exact, 0),
        (HealWithin::Absolute(0.009), 0),
        (HealWithin::Absolute(0.02), 1),
        (HealWithin::Relative(0.002), 1),
    ] {
        let outcome = healed(&mesh, within);
        assert_eq!(
            outcome.t_junctions.iter().filter(|record| record.is_healed()).count(),
            count,
            "{within:?}"
        );
        assert_eq!(outcome.mesh.positions(), mesh.positions(), "no vertex moves");
    }
    let refused = |within| Heal { within }.apply(&mesh, &Context::default()).unwrap_err().to_string();
    let fine = refused(HealWithin::Absolute(1e-300));
    assert!(fine.contains("can't be resolved by coordinates as large as 8e0"), "{fine}");
    assert!(refused(HealWithin::Absolute(-1.0)).contains("not -1"));
}

#[test]
fn of_vertices_in_one_place_the_one_of_the_side_beside_becomes_the_corner() {
    let points = [[0, 0, 0], [8, 0, 0], [4, 6, 0], [4, 0, 0], [4, -6, 0], [4, 0, 0], [4, 0, 5], [3, 0, 5]];
    let faces = [[0, 1, 2], [0, 4, 5], [5, 4, 1], [3, 6, 7]];
    let mesh = PolygonMesh::from_triangles(&points.map(|point| point.map(f64::from)), &faces).unwrap();
    let outcome = healed(&mesh, HealWithin::Exact);
    let vertices: Vec<u32> = outcome.mesh.faces().corner_vertices().iter().map(|vertex| vertex.0).collect();
    assert_eq!(vertices[..4], [0, 5, 1, 2]);
    assert_eq!(outcome.mesh.positions(), mesh.positions());
    assert_eq!(boundary_edges(&outcome.mesh), 4 + 3);
    let [record] = &outcome.t_junctions[..] else { panic!("{:?}", outcome.t_junctions) };
    assert!(record.to_string().starts_with("v5 on the edge v0-v1 of f0"), "{record}");
    // Of the two sides beside it each has its own: one of them is taken, and split takes the others apart.
    let faces = [[0, 1, 2], [0, 4, 5], [3, 4, 1], [6, 7, 5]];
    let mesh = PolygonMesh::from_triangles(&points.map(|point| point.map(f64::from)), &faces).unwrap();
    let outcome = healed(&mesh, HealWithin::Exact);
    assert_eq!(outcome.mesh.faces().corner_vertices()[1], VertexId(3));
}

#[test]
fn what_stays_is_named_with_the_reason() {
    let points = [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0], [4.0, 0.0], [2.0, -4.0], [6.0, -4.0]];
    let touching =
        PolygonMesh::from_triangles(&points.map(|[x, y]| [x, y, 0.0]), &[[0, 1, 2], [3, 4, 5]]).unwrap();
    let outcome = healed(&touching, HealWithin::Exact);
    assert!(outcome.provenance.is_same() && outcome.fixed.is_empty());
    let [record] = &outcome.t_junctions[..] else { panic!("{:?}", outcome.t_junctions) };
    let expected =
        "v3 on the edge v0-v1 of f0, at distance 0e0: left: no open edge of the vertex runs along the edge";
    assert_eq!(record.to_string(), expected);
    assert_eq!(serde_json::to_value(record).unwrap()["left"], "foreign");
}

/// The vertices of the strips lie on each other's edges, so that several are put into one side.
#[test]
fn strips_of_different_fineness_are_sewn_together() {
    let (fine, coarse) = (24, 9);
    let mut points: Vec<[f64; 3]> = Vec::new();
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for (count, y) in [(fine, 1.0), (coarse, -1.0)] {
        let first = points.len() as u32;
        for at in 0..=count {
            let x = 72.0 * f64::from(at) / f64::from(count);
            points.extend([[x, 0.0, 0.0], [x, y, 0.0]]);
        }
        for at in 0..count {
            let a = first + 2 * at;
            faces.extend([[a, a + 1, a + 3], [a, a + 3, a + 2]]);
        }
    }
    let mesh = PolygonMesh::from_triangles(&points, &faces).unwrap();
    let on = t_junctions(&mesh, 0.0, &Watch::NOBODY).unwrap();
    let repaired = repaired(&mesh, HealWithin::Exact);
    assert!(!on.is_empty() && t_junctions(&repaired.mesh, 0.0, &Watch::NOBODY).unwrap().is_empty());
    // Both rims, and the ends of the strips.
    assert_eq!(boundary_edges(&repaired.mesh), (fine + coarse + 4) as usize);
    let topology = repaired.topology.as_ref().unwrap();
    assert_eq!((topology.euler_characteristic, topology.components), (1, 1));
}
