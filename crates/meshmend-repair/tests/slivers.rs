//! What `slivers` mends, and what it says of that.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{
    Carry, CornerId, DefectKind, Domain, FaceId, Layer, PolygonMesh, Role, Sources, Values, VertexId,
};
use meshmend_repair::{
    Context, Distance, Outcome, Pass, PassKind, Pipeline, Reach, SliverFate, SliverMend, Slivers, Weld,
};
use meshmend_spatial::SliverReason;

/// A strip in whose middle vertices 1 and 2 are a unit apart, inside of a border.
fn needles() -> PolygonMesh {
    let points = [[-4e3, 0.0], [0.0, 0.0], [0.0, 1.0], [4e3, 0.0], [0.0, -5e3], [0.0, 5e3]];
    let faces = [[1, 3, 2], [2, 0, 1], [0, 4, 1], [1, 4, 3], [3, 5, 2], [2, 5, 0]];
    PolygonMesh::from_triangles(&points.map(|[x, y]| [x, y, 0.0]), &faces).unwrap()
}

/// A cap over the edge 0–1, with a face below it and two above.
fn cap() -> PolygonMesh {
    let points = [[0.0, 0.0], [5e3, 0.0], [2.5e3, 1.0], [2.5e3, -3e3], [2.5e3, 4e3]];
    let faces = [[0, 1, 2], [1, 0, 3], [0, 2, 4], [2, 1, 4]];
    PolygonMesh::from_triangles(&points.map(|[x, y]| [x, y, 0.0]), &faces).unwrap()
}

fn within(length: f64) -> Slivers {
    Slivers { max_move: Reach::Absolute(length), ..Slivers::default() }
}

fn mended(mesh: &PolygonMesh) -> Outcome {
    within(1.0).apply(mesh, &Context::default()).unwrap()
}

fn reasons(outcome: &Outcome) -> Vec<SliverReason> {
    let left = outcome.slivers.iter().filter_map(|record| match record.fate {
        SliverFate::Left { left } => Some(left),
        SliverFate::Mended(_) => None,
    });
    left.collect()
}

/// A layer of the corners in which one corner has another value than all others.
fn one_differs(mesh: &PolygonMesh, corner: usize, role: Role) -> Layer {
    let uses = (0..mesh.counts().corners).map(|at| u32::from(at == corner)).collect();
    Layer::indexed("u", Domain::Corner, 1, Carry::Interpolate, Values::F64(vec![1.0, 2.0]), uses)
        .with_role(role)
}

#[test]
fn a_collapse_names_what_went_into_what() {
    let mesh = needles();
    let outcome = mended(&mesh);
    assert_eq!((outcome.mesh.counts().vertices, outcome.mesh.counts().faces), (5, 4));
    assert_eq!(
        outcome.slivers[0].fate,
        SliverFate::Mended(SliverMend::Collapse { from: VertexId(2), into: VertexId(1) })
    );
    assert!(outcome.slivers[0].to_string().starts_with("f0, a needle of aspect 4000"));
    let fixed: Vec<String> =
        outcome.fixed.iter().map(|defect| format!("{:?} {:?}", defect.kind(), defect.at)).collect();
    assert_eq!(fixed.len(), 3, "{fixed:?}");
    let joined = outcome.fixed.iter().find(|defect| defect.kind() == DefectKind::CoincidentVertex).unwrap();
    assert_eq!((joined.at.vertex(), joined.beside.unwrap().vertex()), (Some(VertexId(2)), Some(VertexId(1))));
    assert_eq!(outcome.provenance.removed_faces(), [FaceId(0), FaceId(1)]);
    assert_eq!(outcome.provenance.vertices, Sources::listed([0, 1, 3, 4, 5].map(|v| Some(VertexId(v)))));
    // The corners that came to vertex 1 are new ones.
    let created: Vec<CornerId> = outcome
        .provenance
        .corners
        .iter()
        .filter(|(_, old)| old.is_none())
        .map(|(corner, _)| corner)
        .collect();
    assert_eq!(created, [CornerId(8), CornerId(9)]);
    assert_eq!(outcome.left, []);
}

#[test]
fn corners_have_the_values_that_were_where_they_came() {
    let mesh = needles();
    let values = Values::F64((0..18).map(f64::from).collect());
    let layer = Layer::direct("u", Domain::Vertex, 3, Carry::Interpolate, values);
    let outcome = mended(&mesh.with_layers(vec![layer]).unwrap());
    let layer = &outcome.mesh.layers()[0];
    assert_eq!((layer.domain(), layer.value_of(1), layer.value_of(2)), (Domain::Vertex, Some(1), Some(3)));

    let flip = mended(&cap().with_layers(vec![one_differs(&cap(), 8, Role::TexCoord)]).unwrap());
    let corners: Vec<u32> = flip.mesh.faces().corner_vertices().iter().map(|vertex| vertex.0).collect();
    assert_eq!(corners[..6], [0, 3, 2, 1, 2, 3]);
    assert!(flip.provenance.faces.is_same() && flip.provenance.flipped.is_empty());
    let values: Vec<_> = (0..12).map(|corner| flip.mesh.layers()[0].value_of(corner)).collect();
    let expected: Vec<_> = (0..12).map(|corner| Some(usize::from(corner == 8))).collect();
    assert_eq!(values, expected);
}

#[test]
fn no_step_crosses_a_seam() {
    let with = |mesh: PolygonMesh, corner, role| {
        let layer = one_differs(&mesh, corner, role);
        reasons(&mended(&mesh.with_layers(vec![layer]).unwrap()))
    };
    // Corner 0 of the needles is at vertex 1 in face 0; corner 3 of the cap's mesh at vertex 1 in the face below.
    assert_eq!(with(needles(), 0, Role::TexCoord), [SliverReason::Seam; 2]);
    assert_eq!(with(cap(), 3, Role::Plain), [SliverReason::Seam]);
    assert_eq!(with(cap(), 3, Role::Identity), [], "what names a row of a file is not a seam");
    let material = |uses: Vec<u32>| {
        let names = Values::Text(vec![b"red".to_vec(), b"blue".to_vec()]);
        let layer = Layer::indexed("material", Domain::Face, 1, Carry::Copy, names, uses);
        reasons(&mended(&cap().with_layers(vec![layer]).unwrap()))
    };
    assert_eq!(material(vec![0, 1, 0, 0]), [SliverReason::Seam]);
    assert_eq!(material(vec![0, 0, 1, 1]), []);
}

#[test]
fn nothing_is_farther_than_allowed_from_where_it_was_stored() {
    // Vertex 6 is in the place of vertex 2 but for 0.2, and is joined to it first.
    let points = [[-4e3, 0.0], [0.0, 0.0], [0.0, 1.0], [4e3, 0.0], [0.0, -5e3], [0.0, 5e3], [0.0, 1.2]];
    let faces = [[1, 3, 2], [2, 0, 1], [0, 4, 1], [1, 4, 3], [3, 5, 6], [6, 5, 0]];
    let mesh = PolygonMesh::from_triangles(&points.map(|[x, y]| [x, y, 0.0]), &faces).unwrap();
    let record = |length: f64| {
        let pipeline = Pipeline::default().with(Weld::within(Distance::Absolute(0.25))).with(within(length));
        let repaired = pipeline.run(&mesh).unwrap();
        let record = repaired.passes.into_iter().find(|record| record.pass == PassKind::Slivers).unwrap();
        record.slivers[0].clone()
    };
    let collapse =
        |from, into| SliverFate::Mended(SliverMend::Collapse { from: VertexId(from), into: VertexId(into) });
    assert_eq!(record(1.25).fate, collapse(2, 1));
    assert_eq!(record(1.1).fate, collapse(1, 2), "vertex 6 was stored farther away from vertex 1");
    assert!(record(0.9).is_limited());
}

#[test]
fn options_are_refused_that_have_no_meaning() {
    let refused = |slivers: Slivers| slivers.apply(&cap(), &Context::default()).unwrap_err().to_string();
    let aspect = |aspect| refused(Slivers { aspect, ..Slivers::default() });
    assert!(aspect(0.5).contains("1 or more, not 0.5") && aspect(f64::NAN).contains("not NaN"));
    assert!(refused(within(-1.0)).contains("not -1"));
    assert!(refused(within(1e-300)).contains("can't be resolved"));
}

#[test]
fn a_second_run_changes_nothing_where_the_distance_was_no_limit() {
    let pipeline = Pipeline::default().with(within(1.0));
    for mesh in [needles(), cap()] {
        let repaired = pipeline.run(&mesh).unwrap();
        assert!(repaired.is_changed());
        assert!(!pipeline.run(&repaired.mesh).unwrap().is_changed());
    }
}
