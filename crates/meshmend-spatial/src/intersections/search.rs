//! The search through all faces, run by run.

use std::sync::{Mutex, PoisonError};

use meshmend_core::{Cancelled, FaceId, Id};
use petgraph::unionfind::UnionFind;
use rayon::prelude::*;

use super::STEP;
use super::hits::one_for_two_faces;
use super::join::joined;
use super::report::{Figures, IntersectionOptions, Intersections};
use super::run::{Greatest, Run, Subject};
use crate::boxes::{Bounds, BoxTree};
use crate::surface::Surface;

/// Faces of a run.
const RUN: usize = 4096;
/// Runs of a thread at a time: if the budget ends among them, those after are done in vain.
const AT_A_TIME: usize = 8;

/// Which faces of a surface intersect, and how. Answers are the same for every number of threads.
///
/// # Errors
/// When whoever watches the surface stops it.
///
/// *Cost*: O((n + tests) log n) time, where as many pairs of triangles are tested as have boxes that overlap; with the surface
/// some 50 bytes a face while it searches, 12 for each pair of triangles that meets but no more than about as many as there are
/// faces, and what the listed pairs take.
pub fn intersections(
    surface: &Surface<'_>,
    options: IntersectionOptions,
) -> Result<Intersections, Cancelled> {
    let (all, watch) = (surface.triangles(), surface.watch());
    watch.look(STEP, 0, 0)?;
    let tree = BoxTree::watched(all.len(), |at| Bounds::of(surface.points(&all[at])), (watch, STEP))?;
    let faces = surface.mesh().counts().faces;
    watch.look(STEP, 0, faces)?;
    let clusters = Mutex::new(UnionFind::new(faces));
    let contacts = (0..faces).map(|_| Greatest::default()).collect();
    let subject = Subject { surface, tree, clusters, contacts, limit: options.limit };
    let (budget, runs) = (options.budget.tests(faces), faces.div_ceil(RUN));
    let mut total = Run::default();
    let mut done = 0;
    if let Some(mut joined) = joined(&subject, budget) {
        watch.look(STEP, faces, faces)?;
        one_for_two_faces(&mut joined.met, surface);
        watch.look(STEP, faces, faces)?;
        subject.report(&joined.met, &mut total);
        total.self_crossing = joined.self_crossing;
        total.self_crossing.sort_unstable();
        total.self_crossing.dedup();
        watch.look(STEP, faces, faces)?;
        done = runs;
    }
    watch.look(STEP, faces.min(done * RUN), faces)?;
    while done < runs && total.tests <= budget {
        let next = done..runs.min(done + AT_A_TIME * rayon::current_num_threads());
        let found: Vec<Run> =
            next.into_par_iter().map(|run| subject.run(run * RUN..faces.min((run + 1) * RUN))).collect();
        watch.look(STEP, faces.min(done * RUN), faces)?;
        for run in found {
            if total.tests <= budget {
                add(&mut total, run, options.limit);
                done += 1;
            }
        }
    }
    let is_complete = done == runs;
    Ok(Intersections {
        pairs: total.pairs,
        contacts: subject.contacts.values().iter().map(Greatest::get).collect(),
        self_crossing: total.self_crossing,
        figures: is_complete.then(|| with_clusters(total.figures, subject.clusters)),
        complete_to: (!is_complete).then(|| FaceId::new(done * RUN - 1)),
        zero_area: surface.zero_area().to_vec(),
        unfit: surface.unfit().to_vec(),
    })
}

fn add(total: &mut Run, run: Run, limit: usize) {
    total.tests += run.tests;
    total.figures.add_all(&run.figures);
    total.self_crossing.extend(run.self_crossing);
    let listed = &mut total.listed;
    total.pairs.extend(run.pairs.into_iter().filter(|pair| listed.takes(pair.contact, limit)));
}

/// The figures with those of the classes of faces that cross.
fn with_clusters(mut figures: Figures, clusters: Mutex<UnionFind<u32>>) -> Figures {
    if figures.crossing + figures.overlapping == 0 {
        return figures;
    }
    let roots = clusters.into_inner().unwrap_or_else(PoisonError::into_inner).into_labeling();
    let mut members = vec![0_u32; roots.len()];
    roots.iter().for_each(|&root| members[root as usize] += 1);
    let classes = members.iter().filter(|&&count| count > 1);
    figures.crossing_faces = classes.clone().map(|&count| count as usize).sum();
    figures.clusters = classes.count();
    figures
}
