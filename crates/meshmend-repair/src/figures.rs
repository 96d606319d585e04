//! The three figures that show the effect of a pass on the topology.

use meshmend_core::{Connectivity, EdgeUse, FaceTable, Id, PolygonMesh, is_manifold};
use meshmend_topology::{TopologyReport, boundary_loops, components};
use serde::Serialize;

/// χ, the number of components, and the number of boundary loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Figures {
    /// V − E + F.
    pub euler_characteristic: i64,
    /// Classes of faces joined by shared vertices.
    pub components: u64,
    /// Boundary loops; absent where the mesh is not manifold.
    pub boundary_loops: Option<u64>,
}

impl Figures {
    /// The figures of a mesh.
    ///
    /// *Cost*: builds the edge-use kernel, then linear; one look at each corner where no two faces share a vertex.
    pub fn of(mesh: &PolygonMesh) -> Self {
        if are_discs_apart(mesh.complex().faces()) {
            // Each has as many edges as vertices.
            let faces = mesh.complex().proper_face_count() as u64;
            return Figures {
                euler_characteristic: faces as i64,
                components: faces,
                boundary_loops: Some(faces),
            };
        }
        let kernel = EdgeUse::assemble(mesh.complex());
        let components = components(&kernel);
        let faces = mesh.complex().proper_face_count() as i64;
        Figures {
            euler_characteristic: components.referenced_vertices() as i64 - kernel.edge_count() as i64
                + faces,
            components: components.count() as u64,
            boundary_loops: is_manifold(&kernel).then(|| boundary_loops(&kernel).count() as u64),
        }
    }

    /// The figures that are in a report. *Cost*: O(1).
    pub(crate) fn of_report(report: &TopologyReport) -> Self {
        Figures {
            euler_characteristic: report.euler_characteristic,
            components: report.components,
            boundary_loops: report.boundary_loops,
        }
    }
}

/// Whether no vertex is at two corners, as in what has no indices: then each face is a disc of its own.
fn are_discs_apart(faces: &FaceTable) -> bool {
    let mut is_used = vec![false; faces.vertex_count()];
    faces.corner_vertices().iter().all(|vertex| !std::mem::replace(&mut is_used[vertex.index()], true))
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;
    use meshmend_topology::topology;

    use super::*;

    /// What the report says, whatever the faces are; those of some soups share no vertex.
    #[track_caller]
    fn assert_as_reported(soup: &Soup) -> bool {
        let mesh = soup.mesh();
        let report = topology(&EdgeUse::assemble(mesh.complex()), &mesh);
        assert_eq!(Figures::of(&mesh), Figures::of_report(&report), "{soup:?}");
        are_discs_apart(mesh.complex().faces())
    }

    #[test]
    fn faces_that_share_no_vertex_are_discs() {
        let soup = |faces: &[&[u32]]| Soup::generic(12, faces.iter().map(|face| face.to_vec()));
        assert!(assert_as_reported(&soup(&[])));
        assert!(assert_as_reported(&soup(&[&[3, 1, 2], &[4, 5, 6, 7], &[8, 9], &[10, 11, 11, 0]])));
        assert!(!assert_as_reported(&soup(&[&[0, 1, 2], &[3, 4, 0]])));
        assert!(!assert_as_reported(&soup(&[&[0, 1, 2, 0, 3, 4]])));
    }

    #[test]
    fn figures_are_those_of_the_report() {
        let mut state = 5u32;
        let mut next = |below: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % below
        };
        let mut apart = 0;
        for _ in 0..2000 {
            let faces: Vec<Vec<u32>> =
                (0..next(4)).map(|_| (0..2 + next(4)).map(|_| next(40)).collect()).collect();
            apart += u32::from(assert_as_reported(&Soup::generic(40, faces)));
        }
        assert!((200..1900).contains(&apart), "{apart}");
    }
}
