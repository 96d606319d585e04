//! Failures of pipelines.

use std::ops::ControlFlow;

use meshmend_core::{Draft, FaceTable, MAX_CORNERS, Sources, Watch};
use meshmend_kernels::KernelKind;
use meshmend_testkit::{Soup, assert_every_variant, shapes};
use serde::{Deserialize, Serialize};

use super::*;
use crate::{Context, Form, NonFinite, Outcome, PassRow};

fn failure(pipeline: &Pipeline, soup: &Soup) -> PassError {
    pipeline.run(&soup.mesh()).unwrap_err()
}

/// The failure of a pipeline whose passes left everything as it was.
fn promise_of_the_lazy(pipeline: &Pipeline, soup: &Soup) -> Option<PassError> {
    let mut session = Session::begin(&soup.mesh());
    pipeline.passes().iter().for_each(|pass| session.skip(pass).unwrap());
    session.topology().unwrap();
    session.finish().err()
}

#[test]
fn every_failure_says_which_pass_and_why() {
    let plan = |change: fn(&mut Plan)| {
        let mut plan = Plan::default();
        change(&mut plan);
        plan.pipeline()
    };
    let strict = |mesh: &PolygonMesh| {
        Pipeline::default().run_in(Session::begin(mesh).with_kernel(KernelKind::HalfEdge)).unwrap_err()
    };
    let no_distance = plan(|plan| plan.weld.distance = Distance::Absolute(-1.0));
    let no_infinity = plan(|plan| plan.clean.non_finite = NonFinite::Fail);
    let no_band = plan(|plan| plan.orient.non_orientable = NonOrientable::Fail);
    let triangle = Soup::generic(3, [[0, 1, 2]]);
    let mut infinite = triangle.clone();
    infinite.positions[2] = [f64::INFINITY; 3];
    let (mesh, stop) = (triangle.mesh(), Watch::new(|_| ControlFlow::Break(())));
    let wrong = Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(1), Sources::same(2));
    let cases = vec![
        (
            strict(&shapes::two_tetrahedra_on_a_vertex().soup.mesh()),
            "the half-edge kernel can't hold this mesh: pinched vertices: 1 (v0 joins 2 umbrellas)",
        ),
        (
            failure(&no_infinity, &infinite),
            "clean: the policy is `fail`, and the mesh has faces with non-finite corners: 1 \
             (f0 uses v2, which is not finite)",
        ),
        (
            failure(&no_band, &shapes::moebius_band(6, 1, shapes::Tiles::Quads).soup),
            "orient: the policy is `fail`, and the mesh has non-orientable patches: 1 \
             (a strip of 6 faces from f0 comes back reversed)",
        ),
        (failure(&no_distance, &triangle), "weld: a tolerance must be a finite number of 0 or more, not -1"),
        (
            failure(&Pipeline::default(), &infinite),
            "the repair would remove the only face: faces with non-finite corners: 1, because of \
             --non-finite drop",
        ),
        (Pipeline::default().run_in(Session::begin(&mesh).with_watch(&stop)).unwrap_err(), "cancelled"),
        (
            promise_of_the_lazy(&Pipeline::default(), &shapes::book(3).soup).unwrap(),
            "the pipeline broke its promise, which is a mistake of this program: e0 v0-v1 has 3 sides",
        ),
        (
            Pipeline::default().then(Shredder).run(&mesh).unwrap_err(),
            "shredder removed f0 and fixed no defect of it",
        ),
        (
            FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err().into(),
            "2147483648 vertices are more than the 2147483648 that a table holds",
        ),
        (mesh.rebuild(wrong).unwrap_err().into(), "a draft has 2 corner sources, but needs 3"),
    ];
    assert_every_variant!(
        cases,
        PassError { Refused, Policy, Request, Emptied, Cancelled, Promise, Unnamed, Table, Draft }
    );
}

#[test]
fn sides_that_clash_are_a_broken_promise_where_there_is_a_consistent_side() {
    let pipeline = Plan::default().without(PassKind::Split).pipeline();
    let clashing = promise_of_the_lazy(&pipeline, &Soup::generic(4, [[0, 1, 2], [1, 2, 3]]));
    let is_named = matches!(&clashing, Some(PassError::Promise { defect, .. }) if defect.kind == DefectKind::InconsistentEdge);
    assert!(is_named, "{clashing:?}");
    let band = shapes::moebius_band(6, 1, shapes::Tiles::Quads).soup;
    assert!(promise_of_the_lazy(&pipeline, &band).is_none());
}

/// Removes every face without a word.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Shredder;

const SHREDDER: PassRow = PassRow {
    name: "shredder",
    explanation: "Removes every face.",
    is_default: false,
    before: None,
    options: &[],
    form: Form::of::<Shredder>(),
};

impl Pass for Shredder {
    fn kind(&self) -> PassKind {
        PassKind::Own(&SHREDDER)
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }
    fn apply(&self, mesh: &PolygonMesh, _: &Context<'_>) -> Result<Outcome, PassError> {
        let faces = FaceTable::triangles(mesh.counts().vertices, Vec::new())?;
        let draft = Draft::of_faces(mesh, faces, Sources::listed([]), Sources::listed([]));
        Ok(Outcome::changed(mesh.rebuild(draft)?, Vec::new()))
    }
}
