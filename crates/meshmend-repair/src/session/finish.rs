//! What a session gives back when it ends.

use meshmend_core::{Defect, DefectKind, Id, Provenance, turned_normals};

use super::Session;
use crate::{FaceStorage, Fixed, PassError, PassKind, PassRecord, Repaired};

impl Session {
    /// All that was done.
    ///
    /// # Errors
    /// When the topology of the result is known, as it is after `verify`, and shows what a pass had promised to remove: a
    /// mistake of this program.
    pub fn finish(mut self) -> Result<Repaired, PassError> {
        self.check_promises()?;
        let storage = &self.aim.storage.clone();
        let has_changed = self.records.iter().any(|record| record.is_changed);
        let is_same = has_changed && storage.are_alike(self.stored(), &self.mesh)?;
        let stitched = if has_changed { self.stitched(storage, is_same) } else { 0 };
        self.figures.extend(self.figures());
        if self.takes_figures {
            let mut changes = 0;
            for record in &mut self.records {
                let before = changes;
                changes += usize::from(record.is_changed);
                record.figures = Some([before, changes].map(|at| self.figures[at]));
            }
        }
        self.keep_last_judgement();
        let provenance = self.history.provenance().clone();
        let survives = provenance.faces.survivors(provenance.before.faces);
        let mut removed_faces = self.removed_faces;
        // A face that was split has several parts, and is gone only when all of them are.
        removed_faces.retain(|removed| !survives[removed.face.0 as usize]);
        removed_faces.sort_by_key(|removed| removed.face);
        removed_faces.dedup_by_key(|removed| removed.face);
        let turned_normals = turned_normals(self.history.stored(), &self.mesh, &provenance);
        let Session { mut mesh, records: mut passes, rounding, topology, mut created_faces, .. } = self;
        let mut provenance = provenance;
        if is_same {
            forget_changes(&mut passes);
            if !storage.takes_apart(&mesh)? {
                mesh = self.history.stored().clone();
                provenance = Provenance::same(mesh.counts());
                created_faces = Vec::new();
            }
        }
        Ok(Repaired {
            mesh,
            provenance,
            passes,
            removed_faces,
            created_faces,
            turned_normals,
            rounding,
            topology,
            stitched,
        })
    }

    /// How many vertices the first pass joined to others that are apart from them in the result.
    fn stitched(&self, storage: &FaceStorage, is_same: bool) -> usize {
        let Some(weld) = self.records.first() else { return 0 };
        if is_same {
            return weld.fixed.joined_vertices().count();
        }
        let is_split = self.records.iter().any(|record| record.pass == PassKind::Split && record.is_changed);
        if weld.fixed.joined_vertices().next().is_none() || (!storage.is_apart() && !is_split) {
            return 0;
        }
        let provenance = self.history.provenance();
        if storage.is_apart()
            && provenance.corners.is_all_of(provenance.before.corners)
            && provenance.before.vertices == provenance.before.corners
        {
            // Every vertex as stored has a corner of its own, and all are there.
            return weld.fixed.len();
        }
        let stays: Vec<bool> = if storage.is_apart() {
            let mut stays = vec![false; provenance.before.vertices];
            let corners = provenance.corners.iter().filter_map(|(_, stored)| stored);
            corners.for_each(|c| stays[self.stored().faces().corner_vertex(c).index()] = true);
            stays
        } else {
            provenance.vertices.survivors(provenance.before.vertices)
        };
        weld.fixed.joined_vertices().filter(|(vertex, _)| stays[vertex.index()]).count()
    }

    /// Fails when the topology of the mesh shows what a pass had promised to remove.
    fn check_promises(&self) -> Result<(), PassError> {
        let Some(report) = self.topology.as_ref().filter(|_| self.stored().counts().faces > 0) else {
            return Ok(());
        };
        let mut promised: Vec<DefectKind> = Vec::new();
        for pass in &self.applied {
            let pass = pass.as_pass();
            let is_bound = pass.requires().iter().all(|kind| promised.contains(kind));
            promised.retain(|kind| !pass.may_introduce().contains(kind));
            if is_bound {
                promised.extend(pass.removes());
            }
        }
        for kind in promised {
            // Copies of a face that differ run the same way along an edge until `split` takes them apart.
            let is_named = |defect: &Defect| {
                matches!(defect.kind(), DefectKind::NonOrientablePatch | DefectKind::DifferingFace)
            };
            let is_twisted = report.non_orientable_patches > 0
                || self.records.iter().any(|record| record.left.iter().any(is_named));
            if kind == DefectKind::InconsistentEdge && is_twisted {
                continue;
            }
            if let Some(defect) = report.defects.of_kind(kind).next() {
                return Err(PassError::Promise { pass: "the pipeline", defect });
            }
        }
        Ok(())
    }

    /// Where patches are turned outward twice, what could not be judged the first time may have been the second time.
    fn keep_last_judgement(&mut self) {
        let orients = self.records.iter_mut().filter(|record| record.pass == PassKind::Orient);
        let not_last = orients.rev().skip(1);
        not_last.for_each(|record| record.left.retain(|defect| defect.kind() != DefectKind::UnjudgedPatch));
    }
}

/// The records of passes that together changed nothing.
fn forget_changes(passes: &mut [PassRecord]) {
    let last = passes.last().and_then(|record| record.figures);
    for record in passes {
        (record.is_changed, record.fixed, record.seam) = (false, Fixed::default(), None);
        record.figures = last.map(|[_, after]| [after; 2]);
    }
}
