//! Passes in a row, with any options and in any order, on any mesh.

use meshmend_core::{Defect, DefectKind, PolygonMesh};
use meshmend_repair::{
    AnyPass, Context, Emptying, History, NonOrientable, Orient, Pass, PassError, PassKind, Pipeline, Plan,
    Repaired, Side, SliverRecord, SplitEdges, TriangulateFaces,
};
use meshmend_testkit::laws::Change;
use meshmend_testkit::{Soup, oracle, reference, shapes, worlds};
use proptest::prelude::*;
use proptest::sample::select;

use crate::many;
use crate::options::every_choice;
use crate::passes::{Patches, World, bits, honest, step_laws};

/// Any passes with any options in any order, or all of them once in the order of the default pipeline.
pub(crate) fn any_pipeline() -> impl Strategy<Value = Pipeline> {
    prop_oneof![
        proptest::collection::vec(select(every_choice()), 0..8).prop_map(emptying),
        in_default_order(),
    ]
}

/// Every pass once, in the order of the default pipeline, with any options.
fn in_default_order() -> impl Strategy<Value = Pipeline> {
    each_of(PassKind::ALL)
}

/// These passes in this order, with any options.
fn each_of(kinds: &[PassKind]) -> impl Strategy<Value = Pipeline> + use<> {
    let all = every_choice();
    let choice =
        |kind: PassKind| select(all.iter().filter(|p| p.kind() == kind).cloned().collect::<Vec<_>>());
    kinds.iter().map(|&kind| choice(kind)).collect::<Vec<_>>().prop_map(emptying)
}

/// A pipeline that takes any mesh.
fn emptying(passes: Vec<AnyPass>) -> Pipeline {
    Pipeline::new(passes).on_emptying(Emptying::Allow)
}

/// Runs a pipeline step by step, each step under the laws of a step, and all steps so far together under those of a
/// record; then the pipeline itself must give the same.
fn assert_lawful(pipeline: &Pipeline, mesh: &PolygonMesh) -> Option<Repaired> {
    if mesh.counts().faces == 0 {
        let repaired = pipeline.run(mesh).unwrap();
        assert_same_mesh(&repaired.mesh, mesh);
        assert!(repaired.provenance.is_same());
        return Some(repaired);
    }
    let stored = World::of(mesh.clone());
    let (mut world, mut history, mut has_moved) = (World::of(mesh.clone()), History::begin(mesh), false);
    let mut tolerance = pipeline.tolerance_after_split(mesh);
    let mut moved: f64 = 0.0;
    for pass in pipeline.passes() {
        if let AnyPass::Weld(weld) = pass {
            tolerance = tolerance.max(weld.tolerance_on(&world.mesh));
        }
        let clearance = pipeline.clearance(tolerance);
        let context = Context::default().with_history(&history).with_clearance(clearance).with_moved(moved);
        let outcome = honest(pass.as_pass().apply(&world.mesh, &context))?;
        let after = step_laws(pass, Patches::ByMatching, &world, &outcome)
            .unwrap_or_else(|why| panic!("{pass:?}: {why}"));
        moved = moved.max(outcome.moved);
        has_moved |= outcome.fixed.iter().any(|defect| joins_places(&defect, &world.mesh));
        history = history.extended(&outcome.provenance, &outcome.mesh);
        world = after;
        let all = Change { before: &stored.mesh, after: &world.mesh, record: history.provenance() };
        let place = if has_moved { Ok(()) } else { all.place_law(|_, _| false) };
        let law = all.record_law().and(place).and(all.attribute_law());
        law.unwrap_or_else(|why| panic!("after {pass:?}: {why}"));
    }
    let repaired = match pipeline.run(mesh) {
        Ok(repaired) => repaired,
        // What a second run would refuse is refused at once.
        Err(PassError::Policy { .. } | PassError::Request { .. }) => return None,
        Err(error) => panic!("{error}"),
    };
    // What a second run would find is done in further rounds.
    if repaired.passes.len() == pipeline.passes().len() {
        assert_same_mesh(&repaired.mesh, &world.mesh);
        assert_eq!(&repaired.provenance, history.provenance());
    }
    let all = Change { before: mesh, after: &repaired.mesh, record: &repaired.provenance };
    let removed = repaired.removed_faces.iter().map(|removed| (removed.face, removed.reason));
    all.removal_law(removed).unwrap_or_else(|why| panic!("{why}"));
    Some(repaired)
}

/// Whether a vertex was joined to one in another place.
fn joins_places(defect: &Defect, mesh: &PolygonMesh) -> bool {
    let places = [Some(&defect.at), defect.beside.as_ref()].map(|at| Some(mesh.position(at?.vertex()?)));
    defect.kind == DefectKind::CoincidentVertex && places[0] != places[1]
}

fn assert_same_mesh(one: &PolygonMesh, other: &PolygonMesh) {
    assert_eq!(bits(one), bits(other));
    assert_eq!(one.faces(), other.faces());
}

/// Doing it again gives the mesh as it is, but for slivers that a second run may move farther: it does not know where vertices
/// were stored.
fn assert_done(pipeline: &Pipeline, repaired: &Repaired) {
    if repaired.passes.iter().any(|record| record.slivers.iter().any(SliverRecord::is_limited)) {
        return;
    }
    let again = pipeline.run(&repaired.mesh).unwrap();
    assert_same_mesh(&again.mesh, &repaired.mesh);
    assert!(again.provenance.is_same() && again.removed_faces.is_empty() && !again.is_changed());
}

/// The postconditions of the default pipeline, by the oracle and by the reference's own list.
fn assert_clean(repaired: &Repaired) {
    let soup = Soup::of_mesh(&repaired.mesh);
    assert_eq!(reference::broken_postconditions(soup.vertex_count(), &soup.faces), [""; 0]);
    let report = oracle::report(&soup);
    assert!(report.manifold && report.non_finite_vertices == 0, "{report:?}");
    assert_eq!(oracle::mendable_clashes(&repaired.mesh), []);
}

/// All that the default pipeline promises.
fn assert_repaired(plan: &Plan, soup: &Soup) -> Repaired {
    let (pipeline, mesh) = (plan.pipeline().on_emptying(Emptying::Allow), soup.numbered());
    let repaired = assert_lawful(&pipeline, &mesh).unwrap();
    let all = Change { before: &mesh, after: &repaired.mesh, record: &repaired.provenance };
    assert_eq!(all.bit_law(), Ok(()));
    if soup.faces.is_empty() {
        return repaired;
    }
    assert_clean(&repaired);
    assert_done(&pipeline, &repaired);
    repaired
}

/// A plan with one option changed.
fn plan(change: impl FnOnce(&mut Plan)) -> Plan {
    let mut plan = Plan { empty: Emptying::Allow, ..Plan::default() };
    change(&mut plan);
    plan
}

/// A mesh in which nothing is wrong comes out as the very value that went in.
#[test]
fn what_is_tidy_stays() {
    let mut count = 0;
    for shape in shapes::catalogue() {
        let mesh = shape.soup.numbered();
        if World::of(mesh.clone()).is_tidy() {
            let repaired = Pipeline::default().run(&mesh).unwrap();
            let all = Change { before: &mesh, after: &repaired.mesh, record: &repaired.provenance };
            assert!(all.is_none() && repaired.passes.iter().all(|pass| !pass.is_changed), "{}", shape.name);
            count += 1;
        }
    }
    assert!(count > 30, "{count} shapes are tidy");
}

#[test]
fn every_shape() {
    for shape in shapes::catalogue() {
        assert_repaired(&Plan::default(), &shape.soup);
    }
}

#[test]
fn every_set_of_oriented_triangles_over_four_vertices() {
    for faces in worlds::oriented_triangle_sets(4) {
        assert_repaired(&Plan::default(), &Soup::generic(4, faces));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: many(400), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_default_pipeline_on_soups(soup in worlds::any_table(12)) {
        assert_repaired(&Plan::default(), &soup);
    }

    #[test]
    fn the_default_pipeline_on_damaged_shapes((_, _, soup) in worlds::damaged_shape()) {
        assert_repaired(&Plan::default(), &soup);
    }

    #[test]
    fn any_pipeline_on_soups(soup in worlds::any_table(10), pipeline in any_pipeline()) {
        assert_lawful(&pipeline, &soup.numbered());
    }

    #[test]
    fn any_pipeline_on_damaged_shapes((_, _, soup) in worlds::damaged_shape(), pipeline in any_pipeline()) {
        assert_lawful(&pipeline, &soup.numbered());
    }

    #[test]
    fn cutting_makes_everything_orientable(soup in worlds::any_table(12)) {
        let repaired = assert_repaired(&plan(|plan| plan.orient.non_orientable = NonOrientable::Cut), &soup);
        let report = oracle::report(&Soup::of_mesh(&repaired.mesh));
        prop_assert!(report.orientable && report.consistently_oriented);
    }

    #[test]
    fn triangulating_everything_gives_triangles_and_keeps_the_topology(soup in worlds::any_table(10)) {
        prop_assume!(!soup.faces.is_empty());
        let plan = plan(|plan| plan.triangulate.faces = TriangulateFaces::All);
        let repaired = assert_lawful(&plan.pipeline(), &soup.numbered()).unwrap();
        assert_clean(&repaired);
        prop_assert!(repaired.mesh.faces().is_all_triangles());
        let uncut = plan.without(PassKind::Triangulate).pipeline().run(&soup.mesh()).unwrap();
        let [one, other] = [&repaired, &uncut].map(|r| oracle::report(&Soup::of_mesh(&r.mesh)));
        prop_assert_eq!(one.euler_characteristic, other.euler_characteristic);
        prop_assert_eq!(
            (one.components, one.boundary_loops, one.genus, one.cross_caps),
            (other.components, other.boundary_loops, other.genus, other.cross_caps)
        );
    }

    #[test]
    fn a_second_time_there_is_nothing_to_do(soup in worlds::any_table(12), pipeline in in_default_order()) {
        if let Ok(repaired) = pipeline.run(&soup.mesh()) {
            assert_done(&pipeline, &repaired);
        }
    }

    #[test]
    fn what_only_removes_is_done_at_once(
        soup in worlds::any_table(12),
        pipeline in each_of(&[PassKind::Clean, PassKind::Compact]),
    ) {
        if let Ok(repaired) = pipeline.run(&soup.mesh()) {
            assert_done(&pipeline, &repaired);
        }
    }

    #[test]
    fn a_second_time_there_is_nothing_to_do_on_damaged_shapes(
        (_, _, soup) in worlds::damaged_shape(),
        pipeline in in_default_order(),
    ) {
        if let Ok(repaired) = pipeline.run(&soup.mesh()) {
            assert_done(&pipeline, &repaired);
        }
    }

    #[test]
    fn no_closed_patch_is_left_inside_out(
        soup in worlds::any_table(14),
        non_orientable in select(vec![NonOrientable::Report, NonOrientable::Cut]),
    ) {
        prop_assume!(!soup.faces.is_empty());
        let plan = plan(|plan| {
            plan.orient = Orient { side: Side::Outward, non_orientable, ..Orient::default() };
        });
        let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
        assert_clean(&repaired);
        let again = AnyPass::from(plan.orient).as_pass().apply(&repaired.mesh, &Context::default()).unwrap();
        prop_assert!(again.provenance.is_same());
    }

    #[test]
    fn pinch_only_leaves_edges_and_splits_vertices(soup in worlds::generic_table(12)) {
        prop_assume!(!soup.faces.is_empty());
        let before = oracle::report(&soup);
        let pipeline = plan(|plan| plan.split.edges = SplitEdges::PinchOnly).pipeline();
        let repaired = assert_lawful(&pipeline, &soup.numbered()).unwrap();
        let after = oracle::report(&Soup::of_mesh(&repaired.mesh));
        prop_assert_eq!(after.non_manifold_vertices.pinched, 0);
        prop_assert!(repaired.provenance.created.is_empty());
        let is_simple = before.degenerate_faces + before.non_simple_faces + before.duplicate_faces.same == 0;
        prop_assert!(after.manifold || !before.manifold || !is_simple);
    }
}
