//! Faces that have one status, as nothing else meets the edges between them.

use meshmend_core::{Column, FaceId, Id, VertexId};
use petgraph::unionfind::UnionFind;

use crate::Surface;

/// For each face the lowest of its region: faces of which `is_free` says that nothing meets them but properly are joined across
/// edges that no third face has, by position.
///
/// *Cost*: O(n log n), 20 bytes a side.
pub(super) fn regions(surface: &Surface<'_>, is_free: impl Fn(FaceId) -> bool) -> Column<FaceId, FaceId> {
    let mesh = surface.mesh();
    let mut sides: Vec<([VertexId; 2], FaceId)> = Vec::with_capacity(mesh.counts().corners);
    for face in mesh.faces().faces().filter(|&face| !surface.triangles_of(face).is_empty()) {
        let vertices = mesh.faces().face_vertices(face);
        for (&from, &to) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
            let [one, other] = [from, to].map(|vertex| surface.place(vertex));
            sides.push(([one.min(other), one.max(other)], face));
        }
    }
    sides.sort_unstable();
    let mut joined = UnionFind::<u32>::new(mesh.counts().faces);
    for sides in sides.chunk_by(|one, other| one.0 == other.0) {
        if let [(_, one), (_, other)] = *sides
            && is_free(one)
            && is_free(other)
        {
            joined.union(one.0, other.0);
        }
    }
    let roots = joined.into_labeling();
    let mut lowest = vec![None; roots.len()];
    let first = |(face, &root): (usize, &u32)| *lowest[root as usize].get_or_insert(FaceId::new(face));
    roots.iter().enumerate().map(first).collect()
}
