//! `counts` and `numbering`: ids are dense and the same in every kernel.

use meshmend_core::{Connectivity, Id};

use super::asked::Asked;
use super::law::{Breach, Law, same};

pub(super) const COUNTS: Law = Law {
    id: "counts",
    sentence: "there are as many vertices, edges, faces and corners as the mesh has, unreferenced vertices and degenerate \
        faces included",
    why: "ids are dense: whoever walks over all elements walks over 0 to the count",
    often: Some("a degenerate face has an id and no corner, and a vertex in no face has an id too"),
};

pub(super) fn counts<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    let count = |name: &str, found, expected| same(|| format!("{name}()"), &found, &expected);
    count("vertex_count", kernel.vertex_count(), right.stars.len())?;
    count("edge_count", kernel.edge_count(), right.edges.len())?;
    count("face_count", kernel.face_count(), right.faces.len())?;
    count("corner_count", kernel.corner_count(), right.vertex.len())
}

pub(super) const NUMBERING: Law = Law {
    id: "numbering",
    sentence: "a corner has the vertex, the face and the edge that it has in the mesh, and an edge its ends, the smaller first",
    why: "ids mean the same in every kernel, so answers of two kernels can be compared and passed on",
    often: Some(
        "edges numbered as they were met; here they are numbered by (smaller, larger vertex). Or the face of corner c taken for \
        c / 3: degenerate faces have ids and no corners",
    ),
};

pub(super) fn numbering<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    for corner in right.corners() {
        let at = corner.index();
        same(|| format!("corner_vertex({corner})"), &kernel.corner_vertex(corner), &right.vertex[at])?;
        same(|| format!("corner_face({corner})"), &kernel.corner_face(corner), &right.face[at])?;
        same(|| format!("corner_edge({corner})"), &kernel.corner_edge(corner), &right.edge[at])?;
    }
    right.all_edges().try_for_each(|edge| {
        same(|| format!("edge_ends({edge})"), &kernel.edge_ends(edge), &right.ends(edge))
    })
}
