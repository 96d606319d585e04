//! Whatever takes long can be stopped at each look, has then changed nothing, and does not depend on being watched.

use std::fs;
use std::num::NonZeroU32;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use meshmend::cutting::CutAlong;
use meshmend::formats::{ReadErrorKind, WriteErrorKind};
use meshmend::mesh::Watch;
use meshmend::topology::{CoTree, Roots};
use meshmend::{
    CheckOptions, CutOptions, Distance, Format, GeometryOptions, LoopError, LoopOptions, PassError,
    PathOptions, Plan, PolygonMesh, ReadOptions, Session, View, WriteOptions, check, cut, encode, loops,
    read_bytes, repair, write,
};
use meshmend_testkit::{Soup, shapes};

/// A watch that stops work at a look, counted from 0, and how many looks there were.
fn stopping_at(last: usize) -> (Watch, Arc<AtomicUsize>) {
    let looks = Arc::new(AtomicUsize::new(0));
    let counted = looks.clone();
    let watch = Watch::new(move |at| {
        assert!(!at.step.is_empty() && (at.total == 0 || at.done <= at.total), "{at:?}");
        match counted.fetch_add(1, Ordering::Relaxed) < last {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        }
    });
    (watch, looks)
}

/// Does work that is not stopped, and then work that is stopped at each of its looks, or at some of them if there are many.
/// Returns how many there are.
fn stopped_everywhere<T: PartialEq + std::fmt::Debug>(
    what: &str,
    work: impl Fn(&Watch) -> Result<T, String>,
) -> usize {
    let (watch, looks) = stopping_at(usize::MAX);
    let whole = work(&watch);
    assert_eq!(whole, work(&Watch::NOBODY), "{what}: the answer does not depend on who watches");
    assert!(whole.is_ok(), "{what}: {whole:?}");
    let count = looks.load(Ordering::Relaxed);
    for last in (0..count).step_by(count.div_ceil(60).max(1)) {
        let (watch, _) = stopping_at(last);
        assert_eq!(work(&watch), Err("cancelled".to_owned()), "{what}: look {last} of {count}");
    }
    count
}

/// A soup with something for each pass.
fn broken() -> PolygonMesh {
    let mut faces = shapes::torus(12, 12, shapes::Tiles::Triangles).soup.faces;
    faces.truncate(faces.len() - 3);
    for face in faces.iter_mut().step_by(5) {
        face.reverse();
    }
    faces.extend([vec![0, 0, 1], vec![0, 1, 140, 7, 9]]);
    Soup::generic(144, faces).mesh()
}

fn of_pass<T>(result: Result<T, PassError>) -> Result<T, String> {
    result.map_err(|error| error.to_string())
}

#[test]
fn a_repair_stops_at_each_look() {
    let mesh = broken();
    let text = "passes = ['weld', 'clean', 'orient', 'heal', 'split', 'fill', 'triangulate', 'slivers', 'drop', \
                'outward', 'compact', 'verify']\n[fill]\nloops = 'all'\n[drop]\ninternal = 'remove-components'\n";
    for (name, plan, least) in [("", "", 20), ("in full", text, 40)] {
        let pipeline = Plan::from_toml(plan).unwrap().pipeline();
        let looks = stopped_everywhere(&format!("repair {name}"), |watch| {
            let repaired = of_pass(pipeline.run_in(Session::begin(&mesh).with_watch(watch)))?;
            Ok((repaired.mesh.positions().to_vec(), repaired.mesh.faces().clone(), repaired.provenance))
        });
        assert!(looks >= least, "{name}: {looks} looks");
    }
}

#[test]
fn a_check_stops_at_each_look() {
    let mesh = repair(&broken()).unwrap().mesh;
    for (geometry, least) in [(None, 5), (Some(GeometryOptions::all()), 10)] {
        let looks = stopped_everywhere("check", |watch| {
            let options = CheckOptions::default().with_geometry(geometry).with_watch(watch);
            let report = of_pass(check(&mesh, &options))?;
            Ok((report.topology.betti, report.kernels.clone(), report.listed_kinds().collect::<Vec<_>>()))
        });
        assert!(looks >= least, "{looks} looks");
    }
}

#[test]
fn loops_and_cuts_stop_at_each_look() {
    let mesh = shapes::torus(12, 12, shapes::Tiles::Triangles).soup.mesh();
    let roots = Roots::Best(NonZeroU32::new(3).unwrap());
    for (view, roots, least) in
        [(View::Indexed, Roots::Lowest, 12), (View::Welded(Distance::Exact), roots, 24)]
    {
        let paths = PathOptions::default().with_co_tree(CoTree::Greedy).with_roots(roots);
        let looks = stopped_everywhere("loops", |watch| {
            let options = LoopOptions::default().with_view(view).with_paths(paths).with_watch(watch);
            let found = loops(&mesh, &options).map_err(cancelled)?.generators;
            Ok((found.loop_edges(), found.components().to_vec()))
        });
        assert!(looks >= least, "{looks} looks for loops");
        for along in [CutAlong::CutGraph, CutAlong::Generators] {
            let options = CutOptions::default().with_view(view).with_along(along).with_paths(paths);
            let looks = stopped_everywhere("cut", |watch| {
                let report = cut(&mesh, &options.clone().with_watch(watch)).map_err(cancelled)?;
                Ok((report.discs.provenance, report.discs.pieces))
            });
            assert!(looks >= least + 4, "{looks} looks for a cut");
        }
    }
}

/// That work was stopped is said in one way, wherever it was.
fn cancelled(error: LoopError) -> String {
    assert!(matches!(error, LoopError::Pass(PassError::Cancelled(_))), "{error:?}");
    error.to_string()
}

#[test]
fn reading_and_writing_stop_at_each_look() {
    let mesh = repair(&broken()).unwrap().mesh;
    for &format in Format::ALL {
        let options = WriteOptions::of(format);
        let mut bytes = Vec::new();
        let looks = stopped_everywhere(&format!("encode {format}"), |watch| {
            let mut out = Vec::new();
            match encode(&mesh, &options.clone().with_watch(watch), &mut out) {
                Ok(_) => Ok(out),
                Err(error) if matches!(error.kind, WriteErrorKind::Cancelled(_)) => {
                    Err(error.kind.to_string())
                }
                Err(error) => Err(format!("another error: {error}")),
            }
        });
        assert!(looks >= 1, "{format}");
        encode(&mesh, &options, &mut bytes).unwrap();
        let looks = stopped_everywhere(&format!("read {format}"), |watch| {
            let options = ReadOptions::default().with_format(format).with_watch(watch);
            match read_bytes(&bytes, "mesh", &options) {
                Ok(file) => Ok((file.mesh.faces().clone(), file.mesh.positions().to_vec())),
                Err(error) if matches!(error.kind, ReadErrorKind::Cancelled(_)) => {
                    Err(error.kind.to_string())
                }
                Err(error) => Err(format!("another error: {error}")),
            }
        });
        assert!(looks >= 1, "{format}");
    }
}

#[test]
fn a_file_that_is_not_written_to_its_end_is_as_it_was() {
    let folder = std::env::temp_dir().join(format!("meshmend-watched-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("mesh.obj");
    fs::write(&path, "what was there").unwrap();
    let (watch, _) = stopping_at(1);
    let error = write(&path, &broken(), &WriteOptions::default().with_watch(&watch)).unwrap_err();
    assert!(matches!(error.kind, WriteErrorKind::Cancelled(_)), "{error}");
    assert_eq!(fs::read(&path).unwrap(), b"what was there");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "nothing is left beside it");
    fs::remove_dir_all(&folder).unwrap();
}
