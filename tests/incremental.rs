//! Meshes put together cell by cell end at the Betti numbers of the whole, and each prefix of the faces has those that
//! the naive oracle gives it.

use meshmend_core::{Cell, Connectivity, EdgeUse, PolygonMesh};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::{Soup, oracle, shapes, worlds};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_topology::{Incremental, incremental, patches, topology};

struct Build;

impl KernelTask for Build {
    type Output = Incremental;
    fn run<K: Connectivity>(self, kernel: &K) -> Incremental {
        incremental(kernel, &patches(kernel))
    }
}

/// What is wrong with the end of a mesh that is put together, against the figures of the whole.
fn wrong_end(name: &str, mesh: &PolygonMesh) -> Vec<String> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let (built, report) = (incremental(&kernel, &patches(&kernel)), topology(&kernel, mesh));
    let end = built.running_betti().last().unwrap_or([Some(0); 3]);
    let mut wrong = Vec::new();
    if report.betti.z2.is_some_and(|whole| end != whole.map(Some)) {
        wrong.push(format!("{name}: the end is {end:?}, and the whole {:?}", report.betti.z2));
    }
    if report.betti.z2.is_some() && built.instigators() != report.instigators {
        wrong.push(format!("{name}: {:?} instead of {:?}", built.instigators(), report.instigators));
    }
    wrong
}

/// What is wrong with the numbers after each face, against the oracle's for the faces so far.
fn wrong_prefix(soup: &Soup) -> Vec<String> {
    let mesh = soup.mesh();
    let kernel = EdgeUse::assemble(mesh.complex());
    let built = incremental(&kernel, &patches(&kernel));
    let steps = built.steps().iter().zip(built.running_betti());
    let after_faces = steps.filter_map(|(step, betti)| match step.cell {
        Cell::Face(face) => Some((face.0 as usize, betti)),
        _ => None,
    });
    let wrong = after_faces.filter_map(|(face, betti)| {
        let faces = soup.faces[..=face].to_vec();
        let expected = oracle::report(&Soup { faces, ..soup.clone() }).betti.z2;
        let is_wrong = betti != expected.map(|number| Some(number as u64));
        is_wrong.then(|| format!("{:?}: {betti:?} instead of {expected:?} after {face}", soup.faces))
    });
    wrong.collect()
}

#[test]
fn every_shape_ends_at_its_own_figures() {
    assert_each(&shapes::catalogue(), |shape| wrong_end(&shape.name, &shape.soup.mesh()));
}

#[test]
fn small_worlds_are_exact_after_each_face() {
    // Each of the 59 049 sets of oriented triangles over five vertices, one in seven.
    let worlds: Vec<Soup> =
        worlds::oriented_triangle_sets(5).step_by(7).map(|faces| Soup::generic(5, faces)).collect();
    assert_each(&worlds, wrong_prefix);
}

#[test]
fn every_kernel_that_holds_a_shape_says_the_same() {
    assert_each(&shapes::catalogue(), |shape| {
        let complex = shape.soup.complex();
        let usual = KernelKind::default().run(&complex, Build).ok();
        let others =
            KernelKind::ALL.iter().filter_map(|kernel| Some((kernel, kernel.run(&complex, Build).ok()?)));
        let wrong = others.filter(|(_, built)| usual.as_ref() != Some(built));
        wrong.map(|(kernel, _)| format!("{}: {kernel} differs", shape.name)).collect()
    });
}

#[test]
fn every_file_of_the_corpus_ends_at_its_figures() {
    let Some(entries) = corpus() else { return };
    let readable: Vec<&Entry> =
        entries.iter().filter(|entry| entry.is_read_here() && entry.is_well_formed()).collect();
    assert_each(&readable, |entry| wrong_end(&entry.name, &entry.mesh()));
}
