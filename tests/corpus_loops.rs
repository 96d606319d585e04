//! The surfaces of the corpus, once repaired: as many generators as β₁, and open into discs whose rims say what they
//! were.

use meshmend_core::{Connectivity, EdgeUse, PolygonMesh};
use meshmend_cut::{CutAlong, cut_to_discs};
use meshmend_geometry::edge_lengths;
use meshmend_io::{ReadOptions, read};
use meshmend_repair::Pipeline;
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_topology::{CoTree, GeneratorOptions, Roots, betti, components, generators, patches};
use rayon::prelude::*;

/// Every file that can be read, repaired.
fn repaired(entries: &[Entry]) -> Vec<(&Entry, PolygonMesh)> {
    let here: Vec<&Entry> = entries.iter().filter(|entry| entry.is_read_here()).collect();
    let mesh = |entry: &&Entry| Some(read(&entry.path, &ReadOptions::default()).ok()?.mesh);
    let repair = |mesh: PolygonMesh| Pipeline::default().run(&mesh).ok().map(|repaired| repaired.mesh);
    here.par_iter().copied().filter_map(|entry| Some((entry, mesh(&entry).and_then(repair)?))).collect()
}

#[test]
fn repaired_files_have_their_generators_and_open_into_discs() {
    let Some(entries) = corpus() else { return };
    let meshes = repaired(&entries);
    assert!(meshes.len() > 450, "only {} files", meshes.len());
    assert_each(&meshes, |(entry, mesh)| {
        wrong(mesh).map(|what| format!("{}: {what}", entry.name)).into_iter().collect()
    });
}

/// What is not as it should be.
fn wrong(mesh: &PolygonMesh) -> Option<String> {
    let lengths = edge_lengths(mesh);
    let options = GeneratorOptions {
        lengths: Some(&lengths),
        co_tree: CoTree::Greedy,
        roots: Roots::Lowest,
        watch: None,
    };
    let kernel = EdgeUse::assemble(mesh.complex());
    let found = match generators(&kernel, &options) {
        Ok(found) => found,
        Err(error) => return Some(error.to_string()),
    };
    let count: usize = found.components().iter().map(|component| component.generators.len()).sum();
    let first_betti = betti(&kernel, &components(&kernel), &patches(&kernel)).z2.map(|betti| betti[1]);
    if first_betti != Some(count as u64) {
        return Some(format!("{count} generators where β₁ is {first_betti:?}"));
    }
    let open = match cut_to_discs(mesh, CutAlong::CutGraph, &options) {
        Ok(open) => open,
        Err(error) => return Some(error.to_string()),
    };
    let misspelt = open
        .pieces
        .iter()
        .find(|piece| piece.word.as_ref().and_then(|word| word.surface()) != Some(piece.before));
    misspelt.map(|piece| format!("{piece:?}"))
}
