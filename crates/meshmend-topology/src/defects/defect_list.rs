//! Everything that is wrong with a mesh, in little memory.
//!
//! A soup of ten million triangles has thirty million boundary edges, so the list keeps ids alone and makes
//! [`Defect`]s as they are asked for.

use meshmend_core::{Column, Connectivity, Defect, DefectKind, PolygonMesh, VertexClass, VertexId};

use super::items::Items;
use super::survey::survey;
use crate::Orientability;

/// Everything that is wrong with a mesh as it is, by kind and then by id.
#[derive(Clone, Debug, Default)]
pub struct DefectList {
    columns: Vec<(DefectKind, Items)>,
}

/// Stands for a kind of which there is none.
const NO_ITEMS: &Items = &Items::Faces(Vec::new());

impl DefectList {
    /// Looks for every kind of defect that a mesh can have as it is.
    ///
    /// *Cost*: one pass over the elements each, and [`duplicate_faces`](crate::duplicate_faces).
    pub(crate) fn find<K: Connectivity>(
        kernel: &K,
        mesh: &PolygonMesh,
        vertex_classes: &Column<VertexId, VertexClass>,
        orientability: Orientability,
    ) -> Self {
        DefectList { columns: survey(kernel, mesh, vertex_classes, orientability) }
    }

    /// How many defects of a kind there are. *Cost*: O(1).
    pub fn count(&self, kind: DefectKind) -> usize {
        self.items(kind).len()
    }

    /// The defects of a kind, by ascending id; none for the kinds that are found otherwise.
    pub fn of_kind(&self, kind: DefectKind) -> impl ExactSizeIterator<Item = Defect> + '_ {
        let items = self.items(kind);
        (0..items.len()).map(move |place| items.defect(kind, place))
    }

    /// All defects, by kind and then by id.
    pub fn iter(&self) -> impl Iterator<Item = Defect> + '_ {
        self.columns.iter().flat_map(|&(kind, _)| self.of_kind(kind))
    }

    fn items(&self, kind: DefectKind) -> &Items {
        self.columns.iter().find(|column| column.0 == kind).map_or(NO_ITEMS, |column| &column.1)
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::Build;

    use super::*;
    use crate::topology;
    use meshmend_core::EdgeUse;

    #[test]
    fn every_kind_is_listed_in_order() {
        let faces: &[&[u32]] = &[
            &[0, 1, 2], // three on an edge, one of them twice, one reversed
            &[1, 2, 0],
            &[2, 1, 0],
            &[3, 4],                   // degenerate
            &[5, 6, 7, 5, 8, 9],       // non-simple, which pinches v5
            &[10, 11, 12, 12],         // a repeated corner
            &[10, 11, 13],             // runs along v10-v11 the same way
            &[15, 16, 17, 15, 16, 18], // a Möbius band of one face
        ];
        let mesh = crate::shapes::mesh(20, faces);
        let mut positions = mesh.positions().to_vec();
        positions[19] = [0.0, f64::NAN, 0.0];
        let mesh = mesh.with_positions(positions).unwrap();
        let mesh = mesh.with_loose(vec![[VertexId(3), VertexId(4)]], vec![VertexId(14)]).unwrap();
        let report = topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh);
        let kinds: Vec<DefectKind> = report.defects.iter().map(|d| d.kind()).collect();
        assert!(kinds.is_sorted());
        for (kind, count) in [
            (DefectKind::DegenerateFace, 1),
            (DefectKind::DuplicateFace, 1),
            (DefectKind::OppositeFace, 1),
            (DefectKind::RepeatedCorner, 1),
            (DefectKind::NonManifoldEdge, 3),
            (DefectKind::SingularVertex, 3),
            (DefectKind::NonSimpleFace, 2),
            (DefectKind::InconsistentEdge, 2),
            (DefectKind::NonOrientablePatch, 1),
            (DefectKind::NonFiniteVertex, 1),
            (DefectKind::UnreferencedVertex, 4),
            (DefectKind::LooseEdge, 1),
            (DefectKind::LoosePoint, 1),
            (DefectKind::CoincidentVertex, 0),
        ] {
            assert_eq!(report.defects.of_kind(kind).count(), count, "{kind}");
            assert_eq!(report.defects.count(kind), count, "{kind}");
        }
        let pinched = report.defects.of_kind(DefectKind::PinchedVertex).next();
        let expected = Defect::pinched_vertex(VertexId(5), 2, true);
        assert_eq!(pinched, Some(expected));
    }
}
