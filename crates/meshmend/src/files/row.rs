//! The row of a file that was repaired, or that could not be.

use std::io;

use meshmend_io::{Place, ReadError, ReadErrorKind, WriteError, WriteErrorKind};
use meshmend_repair::PassKind;

use super::{FileError, RepairedFile};
use crate::TopologyReport;
use crate::report::{CheckDocument, RepairDocument, Row, RowFigures, RowLoss, RowStatus};

impl RepairedFile {
    /// The row of a file, with what the repair did. The meshes must have been judged before and after.
    #[must_use]
    pub fn told_in(&self, row: Row) -> Row {
        let reports = self.reports();
        let sum = |count: fn(&RepairDocument) -> u64| reports.iter().map(|report| count(report)).sum();
        let mut row = Row {
            status: self.row_status(),
            format_in: Some(self.variant().to_owned()),
            before: figures(reports.iter().filter_map(|report| report.before.as_ref())),
            after: figures(reports.iter().filter_map(|report| report.after.as_ref())),
            changed: self.is_changed(),
            removed_faces: sum(|report| report.removed_faces.count),
            flipped_faces: sum(|report| report.flipped_faces.count),
            created_vertices: sum(|report| report.created_vertices.count),
            welded_vertices: sum(welded),
            ..row
        };
        for group in reports.iter().filter_map(|report| report.before.as_ref()).flat_map(|b| &b.defects) {
            *row.defects.entry(group.kind.code().to_owned()).or_insert(0) += group.count;
        }
        let losses = self.losses().iter();
        row.losses = losses.map(|loss| RowLoss { kind: loss.kind.to_string(), count: loss.count }).collect();
        row
    }

    /// What the file is, with its encoding.
    fn variant(&self) -> &'static str {
        match self {
            RepairedFile::Mesh(mesh) => mesh.file.variant,
            RepairedFile::Parts(parts) => parts.document.variant,
        }
    }

    fn row_status(&self) -> RowStatus {
        if self.left() > 0 || !self.failing().is_empty() {
            RowStatus::Left
        } else if self.is_changed() {
            RowStatus::Mended
        } else {
            RowStatus::Clean
        }
    }
}

impl FileError {
    /// The row of a file that was not repaired for this reason.
    #[must_use]
    pub fn told_in(&self, row: Row) -> Row {
        let status = match self {
            FileError::Placed { .. } => RowStatus::Unreadable,
            FileError::Write(WriteError { kind: WriteErrorKind::Seams { .. }, .. }) => RowStatus::Refused,
            FileError::Write(_) => RowStatus::Unwritable,
            _ => RowStatus::Refused,
        };
        row.failed(status, &self.to_string())
    }
}

impl Row {
    /// This row, of a file that can't be read for this reason.
    #[must_use]
    pub fn unreadable(self, error: &ReadError) -> Self {
        let status = match &error.kind {
            ReadErrorKind::Io(error) if error.kind() == io::ErrorKind::NotFound => RowStatus::Missing,
            ReadErrorKind::Io(error) if error.kind() == io::ErrorKind::OutOfMemory => RowStatus::Memory,
            _ => RowStatus::Unreadable,
        };
        let (line, byte) = match error.place {
            Place::Line(line) => (Some(line), None),
            Place::Byte(byte) => (None, Some(byte)),
            _ => (None, None),
        };
        Row { line, byte, ..self.failed(status, &error.to_string()) }
    }
}

/// How many vertices welding joined.
fn welded(report: &RepairDocument) -> u64 {
    let welds = report.passes.iter().filter(|pass| pass.pass == PassKind::Weld);
    welds.flat_map(|pass| pass.mended.values()).map(|mended| mended.count).sum()
}

/// The figures of several meshes together; `None` of none.
fn figures<'a>(documents: impl Iterator<Item = &'a CheckDocument>) -> Option<RowFigures> {
    let together = |sum: RowFigures, one: RowFigures| RowFigures {
        vertices: sum.vertices + one.vertices,
        edges: sum.edges + one.edges,
        faces: sum.faces + one.faces,
        components: sum.components + one.components,
        boundary_edges: sum.boundary_edges + one.boundary_edges,
        non_manifold_edges: sum.non_manifold_edges + one.non_manifold_edges,
        pinched: sum.pinched + one.pinched,
        singular: sum.singular + one.singular,
        inconsistent_edges: sum.inconsistent_edges + one.inconsistent_edges,
        degenerate_faces: sum.degenerate_faces + one.degenerate_faces,
        euler: sum.euler + one.euler,
        boundary_loops: sum.boundary_loops.zip(one.boundary_loops).map(|(sum, one)| sum + one),
        genus: None,
        cross_caps: None,
        manifold: sum.manifold && one.manifold,
        closed: sum.closed && one.closed,
        orientable: sum.orientable && one.orientable,
        consistently_oriented: sum.consistently_oriented && one.consistently_oriented,
    };
    documents.map(|document| of_topology(&document.topology)).reduce(together)
}

fn of_topology(topology: &TopologyReport) -> RowFigures {
    RowFigures {
        vertices: topology.vertices,
        edges: topology.edges,
        faces: topology.faces,
        components: topology.components,
        boundary_edges: topology.boundary_edges,
        non_manifold_edges: topology.non_manifold_edges,
        pinched: topology.non_manifold_vertices.pinched,
        singular: topology.non_manifold_vertices.singular,
        inconsistent_edges: topology.inconsistent_edges,
        degenerate_faces: topology.degenerate_faces,
        euler: topology.euler_characteristic,
        boundary_loops: topology.boundary_loops,
        genus: topology.genus,
        cross_caps: topology.cross_caps,
        manifold: topology.manifold,
        closed: topology.closed,
        orientable: topology.orientable,
        consistently_oriented: topology.consistently_oriented,
    }
}
