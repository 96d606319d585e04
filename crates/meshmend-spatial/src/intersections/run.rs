//! A run of faces, each compared with all higher faces.

use std::ops::Range;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError};

use meshmend_core::{Column, FaceId, Id};
use petgraph::unionfind::UnionFind;

use super::STEP;
use super::hits::{Coplanar, Hit, Met, Piece, hit, one_for_two_faces};
use super::report::{FacePair, Figures, Listed};
use crate::boxes::{Bounds, BoxTree, Query};
use crate::meeting::{Contact, shown_point};
use crate::surface::Surface;

/// Faces between two looks: some groups that go down the tree together.
const BETWEEN_LOOKS: usize = 16 * TOGETHER;
/// Faces that go down the tree together.
const TOGETHER: usize = 64;

/// A mesh in which intersections are looked for.
pub(super) struct Subject<'a> {
    pub(super) surface: &'a Surface<'a>,
    pub(super) tree: BoxTree,
    /// The classes of faces that cross. The order in which they are joined does not matter.
    pub(super) clusters: Mutex<UnionFind<u32>>,
    /// For each face the greatest of its contacts.
    pub(super) contacts: Column<FaceId, Greatest>,
    /// How many pairs of each class are listed.
    pub(super) limit: usize,
}

/// The greatest of some contacts, in whichever order they come: its place among all and one, or 0 without any.
#[derive(Default)]
pub(super) struct Greatest(AtomicU8);

impl Greatest {
    fn add(&self, contact: Contact) {
        self.0.fetch_max(contact as u8 + 1, Ordering::Relaxed);
    }

    /// The greatest contact.
    pub(super) fn get(&self) -> Option<Contact> {
        let place = usize::from(self.0.load(Ordering::Relaxed)).checked_sub(1)?;
        Contact::ALL.get(place).copied()
    }
}

/// What was found in a run of faces.
#[derive(Default)]
pub(super) struct Run {
    pub(super) tests: u64,
    pub(super) figures: Figures,
    pub(super) pairs: Vec<FacePair>,
    pub(super) listed: Listed,
    pub(super) self_crossing: Vec<FaceId>,
}

impl Subject<'_> {
    /// Compares some faces in a row with all higher ones.
    pub(super) fn run(&self, faces: Range<usize>) -> Run {
        let mut run = Run::default();
        let (mut queries, mut found) = (Vec::new(), Vec::new());
        for start in faces.clone().step_by(TOGETHER) {
            let is_time = (start - faces.start).is_multiple_of(BETWEEN_LOOKS);
            if is_time && self.surface.watch().look(STEP, start, self.contacts.len()).is_err() {
                // Whoever asked for the run looks too, and is told.
                break;
            }
            let end = faces.end.min(start + TOGETHER);
            let first = self.surface.range_of(FaceId::new(start)).start;
            let triangles = first..self.surface.range_of(FaceId::new(end - 1)).end;
            queries.clear();
            queries.extend(triangles.map(|at| Query { bounds: self.bounds(at), from: at as u32 + 1 }));
            found.clear();
            self.compare(first, &queries, &mut found, &mut run);
            one_for_two_faces(&mut found, self.surface);
            self.report(&found, &mut run);
        }
        run.self_crossing.sort_unstable();
        run.self_crossing.dedup();
        run
    }

    /// Compares the triangles of some queries, the first of which has the number `first`, with what overlaps them.
    fn compare(&self, first: usize, queries: &[Query], found: &mut Vec<Met>, run: &mut Run) {
        let piece = |number: usize| Piece::of(self.surface, number as u32);
        self.tree.each_overlap(
            queries,
            |at| self.bounds(at),
            |query, other| {
                run.tests += 1;
                match hit(self.surface, &piece(first + query), &piece(other)) {
                    Some(Hit::SelfCrossing(face)) => run.self_crossing.push(face),
                    Some(Hit::Faces(met)) => found.push(met),
                    None => {}
                }
            },
        );
    }

    /// Counts pairs, joins those that cross, and lists what there is room for.
    pub(super) fn report(&self, found: &[Met], run: &mut Run) {
        for met in found {
            run.figures.add(met.contact, met.coplanar == Coplanar::Yes);
            met.faces(self.surface).iter().for_each(|&face| self.contacts[face].add(met.contact));
        }
        let crossing = || found.iter().filter(|met| met.contact == Contact::FaceFace);
        if crossing().next().is_some() {
            let mut clusters = self.clusters.lock().unwrap_or_else(PoisonError::into_inner);
            crossing().for_each(|met| {
                let [one, other] = met.faces(self.surface);
                clusters.union(one.0, other.0);
            });
        }
        let Run { listed, pairs, .. } = run;
        let there_is_room = |met: &&Met| listed.takes(met.contact, self.limit);
        pairs.extend(found.iter().filter(there_is_room).map(|met| self.listed(met)));
    }

    fn listed(&self, met: &Met) -> FacePair {
        let is_coplanar = met.coplanar == Coplanar::Yes;
        let points = met.triangles.map(|at| self.surface.points(&self.surface.triangles()[at as usize]));
        let is_crossing = met.contact == Contact::FaceFace;
        FacePair {
            faces: met.faces(self.surface),
            contact: met.contact,
            is_coplanar,
            point: is_crossing.then(|| shown_point(points, is_coplanar)),
        }
    }

    fn bounds(&self, triangle: usize) -> Bounds {
        Bounds::of(self.surface.points(&self.surface.triangles()[triangle]))
    }
}
