//! Every readable file of the corpus, repaired with the default pipeline, is clean in the eyes of an independent
//! checker, and the repair keeps its other promises: nothing lost without a name, the second repair changes nothing,
//! and the bytes depend neither on the kernel nor on the number of threads.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::PathBuf;

use meshmend_core::{DefectKind, PolygonMesh};
use meshmend_io::{Format, ReadOptions, WriteOptions, encode, held_layers, read, read_bytes};
use meshmend_kernels::KernelKind;
use meshmend_repair::{
    Emptying, NonOrientable, Orient, PassError, Pipeline, Plan, Repaired, Session, Side, Split, SplitEdges,
    Triangulate, TriangulateFaces,
};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_tests::judge::{judge_clean, python};
use meshmend_tests::program;
use meshmend_tests::scratch::Scratch;
use rayon::prelude::*;

/// Every file that can be read, the odd ones that the reader need not take among them.
fn readable(entries: &[Entry]) -> Vec<(&Entry, PolygonMesh)> {
    let here: Vec<&Entry> = entries.iter().filter(|entry| entry.is_read_here()).collect();
    let mesh = |entry: &&Entry| read(&entry.path, &ReadOptions::default()).ok().map(|file| file.mesh);
    here.par_iter().copied().filter_map(|entry| Some((entry, mesh(&entry)?))).collect()
}

/// Those of one mesh. The parts of others are repaired one by one.
fn of_one_mesh(mut meshes: Vec<(&Entry, PolygonMesh)>) -> Vec<(&Entry, PolygonMesh)> {
    let is_scene = |entry: &Entry| entry.name.ends_with(".glb") || entry.name.ends_with(".gltf");
    meshes.retain(|(entry, _)| !is_scene(entry));
    meshes
}

/// The default pipeline, which here takes any mesh.
fn emptying() -> Pipeline {
    Pipeline::default().on_emptying(Emptying::Allow)
}

fn repaired(mesh: &PolygonMesh) -> Repaired {
    emptying().run(mesh).unwrap()
}

/// The mesh repaired for an OFF file, which can't tell faces apart by the names that they have in other formats.
fn repaired_for_off(mesh: &PolygonMesh) -> Repaired {
    emptying().for_layers(held_layers(mesh, &WriteOptions::of(Format::Off))).run(mesh).unwrap()
}

/// The mesh as an OFF file, which tells vertices apart by index.
fn off(mesh: &PolygonMesh) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(mesh, &WriteOptions::of(Format::Off), &mut bytes).unwrap();
    bytes
}

#[test]
fn every_repaired_file_is_clean_in_the_eyes_of_the_checker() {
    assert_clean(&Plan::default());
}

#[test]
fn files_cut_into_triangles_are_clean() {
    let triangulate = Triangulate { faces: TriangulateFaces::All };
    assert_clean(&Plan { triangulate, ..Plan::default() });
}

#[test]
fn files_cut_at_every_branching_edge_are_clean() {
    let split = Split { edges: SplitEdges::Cut, ..Split::default() };
    let orient = Orient { side: Side::Outward, ..Orient::default() };
    assert_clean(&Plan { split, orient, ..Plan::default() });
}

#[test]
fn non_orientable_files_are_clean_when_cut_open() {
    let orient = Orient { non_orientable: NonOrientable::Cut, ..Orient::default() };
    assert_clean(&Plan { orient, ..Plan::default() });
}

/// Every file repaired by a plan is clean; only what the report calls non-orientable may be oriented inconsistently.
fn assert_clean(plan: &Plan) {
    let (Some(entries), Some(_)) = (corpus(), python()) else { return };
    let scratch = Scratch::new();
    let meshes = readable(&entries);
    assert!(meshes.len() > 450, "only {} files", meshes.len());
    let may_stay_twisted = plan.orient.non_orientable == NonOrientable::Report;
    let repair = |(number, (entry, mesh)): (usize, &(&Entry, PolygonMesh))| {
        let repaired = plan
            .pipeline()
            .on_emptying(Emptying::Allow)
            .run(mesh)
            .unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let path = scratch.path().join(format!("{number}.off"));
        // Without its attributes, as the checker does not know every variant of OFF.
        std::fs::write(&path, off(&repaired.mesh.with_layers(Vec::new()).unwrap())).unwrap();
        (may_stay_twisted && !repaired.topology.unwrap().orientable, path)
    };
    let written: Vec<(bool, PathBuf)> = meshes.par_iter().enumerate().map(repair).collect();
    let paths: Vec<PathBuf> = written.iter().map(|(_, path)| path.clone()).collect();
    let Some(verdicts) = judge_clean(&paths) else { return };
    let mut wrong = Vec::new();
    for (((entry, mesh), (is_twisted, _)), verdict) in meshes.iter().zip(&written).zip(&verdicts) {
        // The vertices of a mesh without faces are what it is about.
        let has_no_faces = mesh.counts().faces == 0;
        let is_excused = |property: &str| {
            property == "oriented" && *is_twisted || property == "no_unreferenced" && has_no_faces
        };
        let lacks: Vec<&String> = verdict.lacks.iter().filter(|property| !is_excused(property)).collect();
        if !lacks.is_empty() {
            wrong.push(format!("{} lacks {lacks:?}: {}", entry.name, verdict.findings["examples"]));
        }
    }
    assert!(wrong.is_empty(), "{} files are not clean:\n{}", wrong.len(), wrong.join("\n"));
    println!("{} files judged", verdicts.len());
}

#[test]
fn a_second_repair_changes_nothing() {
    let Some(entries) = corpus() else { return };
    assert_each(&of_one_mesh(readable(&entries)), |(entry, mesh)| {
        let once = off(&repaired_for_off(mesh).mesh);
        let again = read_bytes(&once, "again.off", &ReadOptions::default()).unwrap().mesh;
        let second = repaired_for_off(&again);
        let changed: Vec<_> =
            second.passes.iter().filter(|pass| pass.is_changed).map(|pass| pass.pass).collect();
        (off(&second.mesh) != once)
            .then(|| format!("{}: repaired again it differs, by {changed:?}", entry.name))
            .into_iter()
            .collect()
    });
}

#[test]
fn every_face_is_there_or_named() {
    let Some(entries) = corpus() else { return };
    assert_each(&readable(&entries), |(entry, mesh)| {
        let repaired = repaired(mesh);
        let removed: BTreeSet<usize> =
            repaired.removed_faces.iter().map(|gone| gone.face.0 as usize).collect();
        let survives = repaired.provenance.faces.survivors(mesh.counts().faces);
        let unaccounted = (0..mesh.counts().faces).find(|face| survives[*face] == removed.contains(face));
        let wrong_reason = repaired.removed_faces.iter().find(|gone| !makes_a_face_go(gone.reason));
        unaccounted
            .map(|face| {
                format!("{}: f{face} is there {}, and named {}", entry.name, survives[face], !survives[face])
            })
            .into_iter()
            .chain(wrong_reason.map(|gone| format!("{}: {gone:?}", entry.name)))
            .collect()
    });
}

fn makes_a_face_go(reason: DefectKind) -> bool {
    use DefectKind::{DegenerateFace, DuplicateFace, NonFiniteFace};
    [DegenerateFace, DuplicateFace, NonFiniteFace].contains(&reason)
}

#[test]
fn kept_vertices_stay_where_they_were_to_the_bit() {
    let Some(entries) = corpus() else { return };
    assert_each(&readable(&entries), |(entry, mesh)| {
        let repaired = repaired(mesh);
        let moved = repaired.provenance.vertices.iter().find(|&(new, old)| {
            let bits = |p: [f64; 3]| p.map(f64::to_bits);
            old.is_some_and(|old| bits(repaired.mesh.position(new)) != bits(mesh.position(old)))
        });
        moved
            .map(|(new, old)| format!("{}: {new} is not where {old:?} was", entry.name))
            .into_iter()
            .collect()
    });
}

#[test]
fn the_bytes_are_the_same_for_any_number_of_threads() {
    let Some(entries) = corpus() else { return };
    let meshes = readable(&entries);
    let results = [1, 2, 8].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        // One after another, so that each repair has the threads to itself.
        pool.install(|| meshes.iter().map(|(_, mesh)| off(&repaired(mesh).mesh)).collect::<Vec<_>>())
    });
    for (number, (entry, _)) in meshes.iter().enumerate() {
        let [one, two, eight] = [0, 1, 2].map(|i| &results[i][number]);
        assert!(one == two && two == eight, "{}: threads make a difference", entry.name);
    }
}

#[test]
fn the_bytes_are_the_same_for_every_kernel() {
    let Some(entries) = corpus() else { return };
    assert_each(&readable(&entries), |(entry, mesh)| {
        let expected = off(&repaired(mesh).mesh);
        let differs = |&kind: &KernelKind| match emptying().run_in(Session::begin(mesh).with_kernel(kind)) {
            Ok(other) => (off(&other.mesh) != expected).then(|| format!("{}: {kind} differs", entry.name)),
            Err(PassError::Refused(_)) if !kind.capabilities().is_permissive() => None,
            Err(error) => Some(format!("{}: {kind}: {error}", entry.name)),
        };
        KernelKind::ALL.iter().skip(1).filter_map(differs).collect()
    });
}

/// Starting the program is slow, so it gets every seventh file.
#[test]
fn the_program_writes_what_the_library_gives_for_any_number_of_threads() {
    let Some(entries) = corpus() else { return };
    let meshes: Vec<_> = of_one_mesh(readable(&entries)).into_iter().step_by(7).collect();
    assert_each(&meshes, |(entry, mesh)| {
        let expected = off(&repaired_for_off(mesh).mesh);
        let scratch = Scratch::new();
        let target = scratch.path().join("out.off");
        let differs = |threads: &&str| {
            let arguments: [&OsStr; 7] = [
                "repair".as_ref(),
                entry.path.as_ref(),
                "-o".as_ref(),
                target.as_ref(),
                "--allow-empty".as_ref(),
                "--threads".as_ref(),
                threads.as_ref(),
            ];
            let output = program::run(arguments);
            !output.status.success() || std::fs::read(&target).unwrap() != expected
        };
        let wrong = ["1", "2", "8"].iter().copied().filter(|threads| differs(threads));
        wrong
            .map(|threads| format!("{} with {threads} threads differs from the library", entry.name))
            .collect()
    });
}
