//! What `fill` makes of boundary loops, and what it says of them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Carry, Defect, DefectKind, Domain, Layer, NO_VALUE, PolygonMesh, Values};
use meshmend_repair::{
    Context, CrossingFills, Fill, FillLimits, FillLoops, FillRims, FillShape, FillWith, LeftOpen, LoopFate,
    LoopRecord, Outcome, Pass, PassKind, Pipeline, Reach,
};

/// A cube of quads without its lid, whose corners are named by the bits x, y, z.
fn open_cube() -> PolygonMesh {
    let at = |code: u32| [4, 2, 1].map(|bit| f64::from(u8::from(code & bit != 0)));
    let points: Vec<[f64; 3]> = (0..8).map(at).collect();
    let corners = [4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 0, 1, 3, 2];
    PolygonMesh::from_polygons(&points, &corners, &[0, 4, 8, 12, 16, 20]).unwrap()
}

fn filled(mesh: &PolygonMesh, options: &Fill) -> Outcome {
    options.apply(mesh, &Context::default()).unwrap()
}

fn left(outcome: &Outcome) -> Vec<Option<LeftOpen>> {
    let reason = |row: &LoopRecord| match row.fate {
        LoopFate::Left { left } => Some(left),
        LoopFate::Filled { .. } => None,
    };
    outcome.loops.iter().map(reason).collect()
}

fn boundary_edges(mesh: &PolygonMesh) -> usize {
    let edges = mesh.complex().edges();
    edges.edges().filter(|&edge| edges.edge_corners(edge).len() == 1).count()
}

#[test]
fn a_cube_gets_its_lid_of_two_triangles() {
    let mesh = open_cube();
    let outcome = filled(&mesh, &Fill::default());
    let [row] = &outcome.loops[..] else { panic!("{:?}", outcome.loops) };
    let expected = LoopFate::Filled { fill: FillShape::Triangles, faces: 2, fold: 1.0, area: 1.0 };
    assert_eq!((row.edges, row.length, row.fate), (4, 4.0, expected));
    assert!((row.turned - 0.2).abs() < 1e-12);
    assert_eq!(
        row.to_string(),
        "loop at v1: 4 edges, length 4.000000, turned 0.200: filled by 2 faces, fold 1.000, area 1.000000"
    );
    assert_eq!((outcome.mesh.counts().faces, boundary_edges(&outcome.mesh)), (7, 0));
    assert_eq!((outcome.provenance.added_faces(), outcome.provenance.removed_faces().len()), (2, 0));
    let fixed: Vec<Defect> = outcome.fixed.iter().collect();
    assert!(fixed.len() == 4 && fixed.iter().all(|defect| defect.kind() == DefectKind::BoundaryEdge));
}

#[test]
fn a_fan_has_a_vertex_in_the_middle() {
    let outcome = filled(&open_cube(), &Fill { by: FillWith::Fan, ..Fill::default() });
    assert_eq!(outcome.mesh.positions()[8], [0.5, 0.5, 1.0]);
    assert_eq!((outcome.mesh.counts().faces, boundary_edges(&outcome.mesh)), (9, 0));
    let expected = LoopFate::Filled { fill: FillShape::Fan, faces: 4, fold: 1.0, area: 1.0 };
    assert_eq!(outcome.loops[0].fate, expected);
}

#[test]
fn limits_have_to_hold_all_of_them() {
    let within = |limits| Fill { loops: FillLoops::Within(limits), ..Fill::default() };
    let none = FillLimits::default();
    let cases = [
        (none, None),
        (FillLimits { edges: Some(4), area: Some(Reach::Absolute(1.0)), ..none }, None),
        (FillLimits { edges: Some(3), ..none }, Some(LeftOpen::Edges)),
        (FillLimits { length: Some(Reach::Absolute(3.9)), ..none }, Some(LeftOpen::Length)),
        // The diagonal is √3 long.
        (FillLimits { length: Some(Reach::Relative(2.32)), ..none }, None),
        (FillLimits { length: Some(Reach::Relative(2.3)), ..none }, Some(LeftOpen::Length)),
        (FillLimits { area: Some(Reach::Relative(0.58)), ..none }, None),
        (FillLimits { area: Some(Reach::Relative(0.57)), ..none }, Some(LeftOpen::Area)),
    ];
    for (limits, reason) in cases {
        assert_eq!(left(&filled(&open_cube(), &within(limits))), [reason], "{limits:?}");
    }
}

/// A square sheet with a square hole, and another one far away that is one triangle.
fn sheet() -> PolygonMesh {
    let mut points = vec![];
    for y in 0..4 {
        points.extend((0..4).map(|x| [f64::from(x), f64::from(y), 0.0]));
    }
    points.extend([[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [9.0, 0.0, 1.0]]);
    let cells = (0..9u32).filter(|&cell| cell != 4).map(|cell| cell / 3 * 4 + cell % 3);
    let mut corners: Vec<u32> = cells.flat_map(|low| [low, low + 1, low + 5, low + 4]).collect();
    corners.extend([16, 17, 18]);
    let starts: Vec<u32> = (0..9).map(|face| 4 * face).chain([35]).collect();
    PolygonMesh::from_polygons(&points, &corners, &starts).unwrap()
}

#[test]
fn rims_and_single_faces_stay_open() {
    let outcome = filled(&sheet(), &Fill::default());
    assert_eq!(left(&outcome), [Some(LeftOpen::Rim), None, Some(LeftOpen::LoneFace)]);
    // A fill of the border would lie in the sheet.
    let taken = Fill { rims: FillRims::Take, ..Fill::default() };
    let outcome = filled(&sheet(), &taken);
    assert_eq!(left(&outcome), [Some(LeftOpen::Crossing), None, Some(LeftOpen::LoneFace)]);
    let [crossing, ..] = &outcome.loops[..] else { panic!("{:?}", outcome.loops) };
    assert!(crossing.crossing.is_some() && crossing.to_string().ends_with(" cross)"), "{crossing}");
    let outcome = filled(&sheet(), &Fill { crossing: CrossingFills::Keep, ..taken });
    assert_eq!(left(&outcome), [None, None, Some(LeftOpen::LoneFace)]);
    assert!(outcome.loops[..2].iter().all(|row| row.crossing.is_some()), "the fills lie on one another");
    assert_eq!(boundary_edges(&outcome.mesh), 3);
}

#[test]
fn a_slit_is_left() {
    // The upper and the lower half of a kite have vertices of their own along their common side.
    let points = [[0, 0], [4, 0], [2, 4], [2, -4], [1, 0], [2, 0], [-4, 0], [8, 0]];
    let points = points.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]);
    let faces = [[0, 5, 2], [5, 1, 2], [1, 4, 3], [4, 0, 3], [6, 0, 2], [6, 3, 0], [1, 7, 2], [1, 3, 7]];
    let mesh = PolygonMesh::from_triangles(&points, &faces).unwrap();
    for by in [FillWith::Fold, FillWith::Area, FillWith::Fan] {
        let outcome = filled(&mesh, &Fill { by, ..Fill::default() });
        assert_eq!(left(&outcome), [Some(LeftOpen::Flat), Some(LeftOpen::Rim)], "{by:?}");
        assert!(outcome.provenance.is_same());
    }
}

#[test]
fn no_fill_lies_on_itself() {
    // A wall of eight quads that goes round the same square twice: so do its two loops.
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let at =
        |vertex: usize| [square[vertex % 4][0], square[vertex % 4][1], if vertex < 8 { 0.0 } else { 1.0 }];
    let points: Vec<[f64; 3]> = (0..16).map(at).collect();
    let corners = (0..8_u32).flat_map(|at| [at, (at + 1) % 8, (at + 1) % 8 + 8, at + 8]);
    let starts: Vec<u32> = (0..=8).map(|face| face * 4).collect();
    let mesh = PolygonMesh::from_polygons(&points, &corners.collect::<Vec<_>>(), &starts).unwrap();
    for by in [FillWith::Fold, FillWith::Area, FillWith::Fan] {
        let options = Fill { by, crossing: CrossingFills::Keep, ..Fill::default() };
        let outcome = filled(&mesh, &options);
        assert_eq!(outcome.loops.len(), 2);
        let places = |face| {
            let vertices = outcome.mesh.faces().face_vertices(face).iter();
            let mut places: Vec<_> = vertices.map(|&v| outcome.mesh.position(v).map(f64::to_bits)).collect();
            places.sort_unstable();
            places
        };
        let mut made: Vec<_> = outcome.mesh.faces().faces().skip(8).map(places).collect();
        let count = made.len();
        made.sort_unstable();
        made.dedup();
        assert_eq!(made.len(), count, "{by:?}: {:?}", outcome.loops);
    }
}

#[test]
fn attributes_are_those_round_the_hole_where_these_agree() {
    let names = Values::Text(["steel", "wood"].map(|name| name.as_bytes().to_vec()).to_vec());
    let material = Layer::indexed("material", Domain::Face, 1, Carry::Copy, names, vec![1, 0, 0, 1, 0]);
    let number = Layer::direct("number", Domain::Face, 1, Carry::Copy, Values::U8((0..5).collect()));
    // All corners at vertex 1 have one value, those at the others have others.
    let mesh = open_cube();
    let at_one = |(corner, &vertex): (usize, &meshmend_core::VertexId)| {
        if vertex.0 == 1 { 7.5 } else { corner as f64 }
    };
    let values = mesh.faces().corner_vertices().iter().enumerate().map(at_one).collect();
    let weight = Layer::direct("weight", Domain::Corner, 1, Carry::Interpolate, Values::F64(values));
    let mesh = mesh.with_layers(vec![material, number, weight]).unwrap();
    let outcome = filled(&mesh, &Fill::default());
    let [material, number, weight] = outcome.mesh.layers() else { panic!("three layers") };
    assert_eq!(
        [5, 6].map(|face| material.value_of(face)),
        [Some(0); 2],
        "three of four faces beside it are of steel"
    );
    assert_eq!([5, 6].map(|face| number.value_of(face)), [None; 2]);
    let faces = outcome.mesh.faces();
    let new = faces
        .corners()
        .skip(20)
        .map(|corner| (faces.corner_vertex(corner).0, weight.value_of(corner.0 as usize)));
    for (vertex, value) in new {
        assert_eq!(value.is_some(), vertex == 1, "{vertex} {value:?} {NO_VALUE}");
    }
}

#[test]
fn a_pipeline_names_who_created_a_face_and_does_nothing_again() {
    let pipeline = Pipeline::default().with(Fill::default());
    let repaired = pipeline.run(&open_cube()).unwrap();
    let created: Vec<(u32, PassKind)> =
        repaired.created_faces.iter().map(|(face, pass)| (face.0, *pass)).collect();
    assert_eq!(created, [(5, PassKind::Fill), (6, PassKind::Fill)]);
    assert_eq!(repaired.passes.iter().map(|pass| pass.loops.len()).sum::<usize>(), 1);
    let again = pipeline.run(&repaired.mesh).unwrap();
    assert!(!again.is_changed() && again.created_faces.is_empty());
}
