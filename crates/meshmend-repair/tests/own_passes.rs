//! Passes of other crates in sessions and pipelines: whatever they do is seen, and what they claim is checked.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_core::{Defect, DefectKind, Draft, FaceId, FaceTableBuilder, PolygonMesh, Sources};
use meshmend_repair::{Context, Form, Outcome, Pass, PassError, PassKind, PassRow, Pipeline, Session};
use meshmend_testkit::{Soup, shapes};
use serde::{Deserialize, Serialize};

const fn row<P: Pass + Default + Serialize + for<'de> Deserialize<'de>>(
    name: &'static str,
    before: PassKind,
) -> PassRow {
    PassRow {
        name,
        explanation: "A test.",
        is_default: false,
        before: Some(before),
        options: &[],
        form: Form::of::<P>(),
    }
}

/// Lifts every vertex by one.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Lift;

const LIFT: PassRow = row::<Lift>("lift", PassKind::Split);

fn lifted(mesh: &PolygonMesh) -> PolygonMesh {
    let positions = mesh.positions().iter().map(|&[x, y, z]| [x, y, z + 1.0]).collect();
    mesh.clone().with_positions(positions).unwrap()
}

impl Pass for Lift {
    fn kind(&self) -> PassKind {
        PassKind::Own(&LIFT)
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }
    fn apply(&self, mesh: &PolygonMesh, _: &Context<'_>) -> Result<Outcome, PassError> {
        Ok(Outcome { mesh: lifted(mesh), ..Outcome::unchanged(mesh) })
    }
}

/// Removes the first face, for a reason that no pass of meshmend's own has.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Behead;

const BEHEAD: PassRow = row::<Behead>("behead", PassKind::Verify);

impl Pass for Behead {
    fn kind(&self) -> PassKind {
        PassKind::Own(&BEHEAD)
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::BoundaryEdge]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }
    fn apply(&self, mesh: &PolygonMesh, _: &Context<'_>) -> Result<Outcome, PassError> {
        let mut faces = FaceTableBuilder::default();
        let kept = || mesh.faces().faces().skip(1);
        kept().for_each(|face| faces.push_face(mesh.faces().face_vertices(face).iter().copied()));
        let corners = kept().flat_map(|face| mesh.faces().face_corners(face));
        let draft = Draft::of_faces(
            mesh,
            faces.build(mesh.counts().vertices)?,
            Sources::listed(kept().map(Some)),
            Sources::listed(corners.map(Some)),
        );
        Ok(Outcome::changed(mesh.rebuild(draft)?, vec![Defect::polygon_face(FaceId(0), 3)]))
    }
}

/// What is moved is a change, also where it is the only one; what was known of the mesh is not known any more.
#[test]
fn a_vertex_that_moves_is_seen() {
    let mesh = Soup::generic(3, [[0, 1, 2]]).mesh();
    let mut session = Session::begin(&mesh);
    session.topology().unwrap();
    assert!(session.apply(Lift).unwrap().is_changed);
    let repaired = session.finish().unwrap();
    assert!(repaired.is_changed() && repaired.topology.is_none());
    assert_eq!(repaired.mesh.positions(), lifted(&mesh).positions());
}

/// Later passes take vertices for what was made of them, and do not put them back to where they were stored.
#[test]
fn a_vertex_that_moved_stays_where_it_is() {
    let pinched = shapes::two_tetrahedra_on_a_vertex().soup;
    let mut apart = shapes::book(3).soup;
    let copied = apart.positions[0];
    apart.faces.push(vec![apart.positions.len() as u32, 2, 3]);
    apart.positions.push(copied);
    for soup in [pinched, apart] {
        let mesh = soup.mesh();
        let (plain, moved) = (Pipeline::default(), Pipeline::default().with(Lift));
        let [plain, moved] = [plain, moved].map(|pipeline| pipeline.run(&mesh).unwrap());
        assert!(plain.mesh.counts().vertices > 0);
        assert_eq!(moved.mesh.faces(), plain.mesh.faces());
        assert_eq!(moved.mesh.positions(), lifted(&plain.mesh).positions());
    }
}

#[test]
fn a_face_that_goes_is_named_with_the_reason_that_the_pass_gives() {
    let mesh = Soup::generic(4, [[0, 1, 2], [1, 0, 3]]).mesh();
    let mut session = Session::begin(&mesh);
    session.apply(Behead).unwrap();
    let removed = session.finish().unwrap().removed_faces;
    assert_eq!(removed.len(), 1);
    assert_eq!((removed[0].face, removed[0].reason), (FaceId(0), DefectKind::PolygonFace));
    assert_eq!(removed[0].pass.name(), "behead");
}

#[test]
fn a_promise_is_held_against_the_result() {
    let mesh = Soup::generic(4, [[0, 1, 2], [1, 0, 3]]).mesh();
    let error = Pipeline::default().with(Behead).run(&mesh).unwrap_err();
    assert!(matches!(error, PassError::Promise { .. }), "{error}");
}

#[test]
fn nothing_left_is_told_with_the_pass() {
    let mesh = Soup::generic(3, [[0, 1, 2]]).mesh();
    let error = Pipeline::default().then(Behead).run(&mesh).unwrap_err().to_string();
    assert_eq!(
        error,
        "the repair would remove the only face: faces with more than three corners: 1, by behead"
    );
}

#[test]
fn a_pass_of_meshmends_own_is_itself_however_it_comes() {
    use meshmend_repair::{AnyPass, Orient, Weld};
    assert!(matches!(AnyPass::from(Weld::default()), AnyPass::Weld(_)));
    assert!(matches!(AnyPass::from(Lift), AnyPass::Own(_)));
    assert_eq!(AnyPass::from(Lift), AnyPass::from(Lift));
    assert_ne!(AnyPass::from(Lift), AnyPass::from(Orient::default()));
}
