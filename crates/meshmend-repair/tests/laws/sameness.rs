//! Neither the number of threads nor the kernel makes a difference, to the bit.

use std::sync::OnceLock;

use meshmend_core::{Defect, PolygonMesh, Provenance};
use meshmend_kernels::KernelKind;
use meshmend_repair::{Context, Distance, Outcome, PassError, Pipeline, Repaired, Session, Weld};
use meshmend_testkit::damage::Damage;
use meshmend_testkit::shapes::{self, Tiles};
use meshmend_testkit::{Soup, worlds};
use meshmend_topology::Witness;
use proptest::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::many;
use crate::options::every_choice;
use crate::passes::bits;
use crate::pipelines::any_pipeline;

/// Pools of one, two and eight threads.
fn pools() -> &'static [ThreadPool] {
    static POOLS: OnceLock<Vec<ThreadPool>> = OnceLock::new();
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    POOLS.get_or_init(|| [1, 2, 8].map(pool).into())
}

/// All that a repair gives, comparable.
#[derive(Debug, PartialEq)]
pub(crate) struct Given {
    positions: Vec<[u64; 3]>,
    faces: Vec<Vec<u32>>,
    layers: String,
    record: Provenance,
    fixed: Vec<Defect>,
    left: Vec<Defect>,
}

impl Given {
    fn of(mesh: &PolygonMesh, record: &Provenance, fixed: Vec<Defect>, left: Vec<Defect>) -> Self {
        let (faces, layers) = (meshmend_testkit::Soup::of_mesh(mesh).faces, format!("{:?}", mesh.layers()));
        Given { positions: bits(mesh), faces, layers, record: record.clone(), fixed, left }
    }

    fn by_pass(outcome: &Outcome) -> Self {
        let (fixed, left) = (outcome.fixed.iter().collect(), outcome.left.clone());
        Given::of(&outcome.mesh, &outcome.provenance, fixed, left)
    }

    fn in_all(repaired: &Repaired) -> Self {
        let fixed = repaired.passes.iter().flat_map(|pass| pass.fixed.iter()).collect();
        let left = repaired.passes.iter().flat_map(|pass| pass.left.clone()).collect();
        Given::of(&repaired.mesh, &repaired.provenance, fixed, left)
    }
}

/// A repair gives the same on every kernel and with any number of threads; a kernel that is not permissive may refuse.
#[track_caller]
fn assert_same_everywhere(what: &str, repair: impl Fn(KernelKind) -> Result<Given, PassError> + Sync) {
    let mut first: Option<Result<Given, String>> = None;
    for &kernel in KernelKind::ALL {
        for pool in pools() {
            let result = match pool.install(|| repair(kernel)) {
                Err(PassError::Refused(_)) if !kernel.capabilities().is_permissive() => continue,
                result => result.map_err(|error| error.to_string()),
            };
            let threads = pool.current_num_threads();
            let expected =
                first.get_or_insert_with(|| repair(KernelKind::default()).map_err(|e| e.to_string()));
            assert!(
                result == *expected,
                "{what}: {kernel} on {threads} threads gives\n{result:?}\nnot {expected:?}"
            );
        }
    }
}

fn assert_passes_are_the_same(mesh: &PolygonMesh) {
    for pass in every_choice() {
        assert_same_everywhere(&format!("{pass:?}"), |kernel| {
            let context = Context::default().with_kernel(kernel);
            pass.as_pass().apply(mesh, &context).map(|outcome| Given::by_pass(&outcome))
        });
    }
}

fn assert_pipeline_is_the_same(pipeline: &Pipeline, mesh: &PolygonMesh) {
    assert_same_everywhere(&format!("{:?}", pipeline.passes()), |kernel| {
        let session = Session::begin(mesh).with_kernel(kernel);
        pipeline.run_in(session).map(|repaired| Given::in_all(&repaired))
    });
}

/// A mesh that was looked at before, as stored or as some weld makes it, is repaired as any other.
fn assert_looking_before_is_the_same(pipeline: &Pipeline, mesh: &PolygonMesh) {
    let told = |repaired: Result<Repaired, PassError>| {
        let told = |mut r: Repaired| {
            r.passes.iter_mut().for_each(|record| record.looked = None);
            (
                Given::in_all(&r),
                format!("{:?} {:?}", r.passes, r.removed_faces),
                r.topology.map(|topology| format!("{topology:?}")),
            )
        };
        repaired.map(told).map_err(|error| error.to_string())
    };
    let distances = [Distance::Exact, Distance::Absolute(0.5), Distance::Relative(0.01)];
    let welds = distances.map(|distance| Some(Weld::within(distance)));
    for weld in welds.into_iter().chain([None]) {
        for kernel in [KernelKind::default(), KernelKind::HalfEdge] {
            for witness in [Witness::BreadthFirst, Witness::Shortest] {
                let begun = || Session::begin(mesh).with_kernel(kernel).with_witness(witness).with_figures();
                let mut looked = begun();
                let welded = weld.clone().map_or(Ok(()), |weld| looked.apply(weld).map(|_| ()));
                match welded.and_then(|()| looked.topology().map(|_| ())) {
                    Ok(()) => {
                        let (found, mut expected) =
                            (told(pipeline.run_in(looked)), told(pipeline.run_in(begun())));
                        if let (Ok(found), Ok(expected)) = (&found, &mut expected) {
                            expected.2 = expected.2.take().or(found.2.clone());
                        }
                        assert_eq!(found, expected, "{weld:?} {kernel} {witness:?}");
                    }
                    Err(error) => assert!(matches!(error, PassError::Refused(_)), "{error}"),
                }
            }
        }
    }
}

/// Four sides at an edge as welded are two edges as stored: the sides of one of them run the same way.
#[test]
fn what_clashes_as_stored_alone_is_seen() {
    let mut soup = Soup::generic(8, [[0, 1, 2], [1, 0, 3], [4, 5, 6], [4, 5, 7]]);
    (soup.positions[4], soup.positions[5]) = (soup.positions[0], soup.positions[1]);
    let mesh = soup.mesh();
    assert_looking_before_is_the_same(&Pipeline::default(), &mesh);
    assert_eq!(Pipeline::default().run(&mesh).unwrap().provenance.flipped.len(), 1);
}

/// Large enough for work to be shared between threads, and with something for every pass to do.
#[test]
fn a_large_damaged_mesh() {
    let mut soup = shapes::torus(60, 40, Tiles::Quads).soup;
    let doubled: Vec<usize> = (0..300).map(|i| i * 7).collect();
    soup = Damage::Flip { faces: (0..900).collect() }.apply(&soup);
    soup = Damage::Crack { faces: (500..1700).collect() }.apply(&soup);
    soup.faces.extend(doubled.iter().map(|&f| soup.faces[f].clone()).collect::<Vec<_>>());
    soup = Damage::Pinch { kept: 3, lost: 1200 }.apply(&soup);
    soup.faces.extend([vec![5, 5, 6], vec![1, 2, 3, 1, 4, 700]]);
    soup = Damage::NonFinite { vertex: 77, value: meshmend_testkit::damage::Unreal::Nan }.apply(&soup);
    let (mesh, apart) = (soup.numbered(), Damage::WeldApart.apply(&soup).numbered());
    assert_passes_are_the_same(&mesh);
    assert_pipeline_is_the_same(&Pipeline::default(), &mesh);
    assert_pipeline_is_the_same(&Pipeline::default(), &apart);
}

/// What strict kernels hold as well.
#[test]
fn shapes_that_are_surfaces() {
    for shape in shapes::catalogue().iter().filter(|shape| shape.truth.manifold) {
        let mesh = shape.soup.numbered();
        assert_pipeline_is_the_same(&Pipeline::default(), &mesh);
        if shape.soup.faces.len() < 12 {
            assert_passes_are_the_same(&mesh);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: many(20), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn passes_on_soups(soup in worlds::any_table(10)) {
        assert_passes_are_the_same(&soup.numbered());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: many(250), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn pipelines_on_soups(soup in worlds::any_table(10), pipeline in any_pipeline()) {
        assert_pipeline_is_the_same(&pipeline, &soup.numbered());
    }

    #[test]
    fn looking_before(soup in worlds::any_table(10), pipeline in any_pipeline()) {
        assert_looking_before_is_the_same(&pipeline, &soup.numbered());
    }

    #[test]
    fn looking_before_at_damaged_shapes((_, _, soup) in worlds::damaged_shape(), pipeline in any_pipeline()) {
        assert_looking_before_is_the_same(&pipeline, &soup.numbered());
        assert_looking_before_is_the_same(&Pipeline::default(), &soup.numbered());
    }

    #[test]
    fn pipelines_on_damaged_shapes((_, _, soup) in worlds::damaged_shape(), pipeline in any_pipeline()) {
        assert_pipeline_is_the_same(&pipeline, &soup.numbered());
    }
}
