//! A pass alone, with any options, on any mesh.

use std::collections::BTreeSet;

use meshmend_core::{Defect, DefectKind, FaceId, PolygonMesh, Severity, VertexId};
use meshmend_repair::{
    AnyPass, Context, Outcome, Pass, PassError, SliverFate, SliverMend, SliverRecord, Weld,
};
use meshmend_testkit::laws::{Change, DefectCounts, Promise};
use meshmend_testkit::{Soup, shapes, worlds};
use proptest::prelude::*;
use rayon::prelude::*;

use crate::many;
use crate::options::every_choice;

/// A mesh, and what the oracle finds in it.
pub(crate) struct World {
    pub(crate) mesh: PolygonMesh,
    pub(crate) found: DefectCounts,
}

impl World {
    pub(crate) fn of(mesh: PolygonMesh) -> Self {
        World { found: DefectCounts::of(&mesh), mesh }
    }

    /// Whether there is nothing that the default options of any pass would change: nothing but boundaries, polygons
    /// and walls with two sides.
    pub(crate) fn is_tidy(&self) -> bool {
        let is_fine = |kind: &DefectKind| {
            matches!(kind, DefectKind::BoundaryEdge | DefectKind::PolygonFace | DefectKind::OppositeFace)
        };
        DefectKind::ALL.iter().all(|kind| is_fine(kind) || self.found.count(*kind) == 0)
    }
}

/// What a pass promises.
pub(crate) fn promise(pass: &AnyPass) -> Promise {
    let pass = pass.as_pass();
    Promise { removes: pass.removes(), requires: pass.requires(), may_introduce: pass.may_introduce() }
}

/// The outcome of a pass, or nothing where a policy forbids it, or coordinates are too coarse for its tolerance.
pub(crate) fn honest(result: Result<Outcome, PassError>) -> Option<Outcome> {
    match result {
        Ok(outcome) => Some(outcome),
        Err(PassError::Policy { kind, defects, .. }) => {
            assert!(!defects.is_empty() && defects.iter().all(|defect| defect.kind() == kind), "{defects:?}");
            None
        }
        Err(PassError::Request { reason, .. }) if reason.contains("can't be resolved") => None,
        Err(error) => panic!("{error}"),
    }
}

/// By what the faces of a patch hang together.
#[derive(Clone, Copy)]
pub(crate) enum Patches {
    /// By edges of two sides: what the oracle sees.
    ByEdges,
    /// By the matching of a pipeline under way, which knows the vertices as stored. What has no consistent side there may
    /// have one in the oracle's eyes, until it is taken apart.
    ByMatching,
}

/// The faces that are named as having got another corner by a flip.
fn flipped_faces(outcome: &Outcome) -> BTreeSet<FaceId> {
    let flip = |record: &SliverRecord| match record.fate {
        SliverFate::Mended(SliverMend::Flip { with, .. }) => [record.face, with],
        _ => [record.face; 2],
    };
    outcome.slivers.iter().filter(|record| record.is_step()).flat_map(flip).collect()
}

/// What one application of a pass must be, whether alone or after others; gives the world after it.
pub(crate) fn step_laws(
    pass: &AnyPass,
    patches: Patches,
    world: &World,
    outcome: &Outcome,
) -> Result<World, String> {
    let change = Change { before: &world.mesh, after: &outcome.mesh, record: &outcome.provenance };
    let fixed: Vec<Defect> = outcome.fixed.iter().collect();
    change.record_law()?;
    change.naming_law_but_for(&fixed, &flipped_faces(outcome))?;
    change.attribute_law()?;
    let found = if outcome.provenance.is_same() && is_equal(&outcome.mesh, &world.mesh) {
        if !change.is_none() || !fixed.is_empty() {
            return Err(format!(
                "nothing changed, and yet the mesh is another value, or is fixed: {fixed:?}"
            ));
        }
        world.found.clone()
    } else {
        DefectCounts::of(&outcome.mesh)
    };
    let blind: &[DefectKind] = match patches {
        Patches::ByEdges => &[],
        Patches::ByMatching => &[DefectKind::InconsistentEdge, DefectKind::NonOrientablePatch],
    };
    // What has no face is left as it is.
    if world.mesh.counts().faces > 0 {
        promise(pass).law(&world.found.clone().without(blind), &found.clone().without(blind))?;
    }
    Ok(World { mesh: outcome.mesh.clone(), found })
}

/// Every position with its bits, so that what is no number equals itself.
pub(crate) fn bits(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    mesh.positions().iter().map(|p| p.map(f64::to_bits)).collect()
}

fn is_equal(one: &PolygonMesh, other: &PolygonMesh) -> bool {
    bits(one) == bits(other)
        && one.faces() == other.faces()
        && one.loose_edges() == other.loose_edges()
        && one.loose_points() == other.loose_points()
}

fn joined_vertices(defect: &Defect) -> Option<(VertexId, VertexId)> {
    let is_joined = defect.kind == DefectKind::CoincidentVertex;
    is_joined.then(|| Some((defect.at.vertex()?, defect.beside.as_ref()?.vertex()?))).flatten()
}

/// All laws of a pass alone.
fn laws(pass: &AnyPass, world: &World) -> Result<(), String> {
    let Some(outcome) = honest(pass.as_pass().apply(&world.mesh, &Context::default())) else { return Ok(()) };
    let after = step_laws(pass, Patches::ByEdges, world, &outcome)?;
    let change = Change { before: &world.mesh, after: &outcome.mesh, record: &outcome.provenance };
    let joined: BTreeSet<(VertexId, VertexId)> =
        outcome.fixed.iter().filter_map(|defect| joined_vertices(&defect)).collect();
    change.place_law(|from, to| joined.contains(&(from, to)))?;
    change.bit_law()?;
    let is_usual = pass.kind().row().is_default && *pass == pass.kind().with_defaults();
    if world.is_tidy() && is_usual && !change.is_none() {
        return Err("a tidy mesh is changed".into());
    }
    // What a pass requires is what it takes to be done in one go.
    if pass.as_pass().requires().iter().any(|kind| world.found.count(*kind) > 0) {
        return Ok(());
    }
    // A second run does not know where vertices were.
    if outcome.slivers.iter().any(SliverRecord::is_limited) {
        return Ok(());
    }
    // A tolerance in parts of a box grows with the box, where vertices are joined to one that no face used.
    let grows = |weld: &Weld| weld.tolerance_on(&after.mesh) > weld.tolerance_on(&world.mesh);
    if matches!(pass, AnyPass::Weld(weld) if grows(weld)) {
        return Ok(());
    }
    let again = pass.as_pass().apply(&after.mesh, &Context::default()).map_err(|error| error.to_string())?;
    let change = Change { before: &after.mesh, after: &again.mesh, record: &again.provenance };
    if change.is_none() && again.fixed.is_empty() {
        Ok(())
    } else {
        Err(format!("a second time it mends {:?}", again.fixed.iter().collect::<Vec<_>>()))
    }
}

/// Every pass with every choice of options, on each of some meshes; all that is wrong in one failure.
fn assert_lawful(meshes: Vec<(String, PolygonMesh)>) {
    let choices = every_choice();
    let count = meshes.len() * choices.len();
    let wrong: Vec<String> = meshes
        .into_par_iter()
        .flat_map_iter(|(name, mesh)| {
            let world = World::of(mesh);
            let broken =
                |pass: &AnyPass| laws(pass, &world).err().map(|why| format!("{name}: {pass:?}: {why}"));
            choices.iter().filter_map(broken).collect::<Vec<_>>()
        })
        .collect();
    let some = &wrong[..wrong.len().min(12)];
    assert!(wrong.is_empty(), "{} of {count} break a law:\n{}", wrong.len(), some.join("\n"));
}

#[test]
fn every_shape() {
    assert_lawful(shapes::catalogue().into_iter().map(|shape| (shape.name, shape.soup.numbered())).collect());
}

#[test]
fn every_set_of_oriented_triangles_over_four_vertices() {
    let sets = worlds::oriented_triangle_sets(4).map(|faces| (format!("{faces:?}"), Soup::generic(4, faces)));
    assert_lawful(sets.map(|(name, soup)| (name, soup.numbered())).collect());
}

#[test]
fn loose_elements_and_nothing_at_all() {
    let soup = Soup::generic(4, [[0, 1, 2]]);
    let loose =
        (vec![[VertexId(0), VertexId(3)], [VertexId(1), VertexId(1)]], vec![VertexId(3), VertexId(0)]);
    let with_loose = soup.numbered().with_loose(loose.0, loose.1).unwrap();
    let nothing = Soup::default().numbered();
    assert_lawful(vec![("loose elements".into(), with_loose), ("nothing".into(), nothing)]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: many(250), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn soups(soup in worlds::any_table(10)) {
        assert_lawful(vec![("a soup".into(), soup.numbered())]);
    }

    #[test]
    fn soups_in_general_position(soup in worlds::generic_table(10)) {
        assert_lawful(vec![("a soup".into(), soup.numbered())]);
    }

    #[test]
    fn damaged_grids(soup in worlds::damaged_grid()) {
        assert_lawful(vec![("a damaged grid".into(), soup.numbered())]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: many(60), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_shapes((shape, harms, soup) in worlds::damaged_shape()) {
        assert_lawful(vec![(format!("{} with {harms:?}", shape.name), soup.numbered())]);
    }
}

/// What `verify` leaves is what the oracle finds, to the letter.
#[test]
fn what_is_left_is_what_is_there() {
    for shape in shapes::catalogue() {
        let mesh = shape.soup.mesh();
        let mut expected = meshmend_testkit::oracle::defects(&mesh);
        expected.retain(|defect| defect.kind().severity() == Severity::Defect);
        expected.retain(|defect| !matches!(defect.kind(), DefectKind::NonFiniteFace));
        let left =
            meshmend_repair::PassKind::Verify.with_defaults().as_pass().apply(&mesh, &Context::default());
        assert_eq!(left.unwrap().left, expected, "{}", shape.name);
    }
}
