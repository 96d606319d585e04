//! Faces that have one status, as nothing else meets the edges between them.

use meshmend_core::{Cancelled, Column, FaceId, Id, VertexId};
use petgraph::unionfind::UnionFind;

use crate::Surface;

/// For each face the lowest of its region: faces of which `is_free` says that nothing meets them but properly are joined across
/// edges that no third face has, by position.
///
/// *Cost*: linear but for sorting the sides of each vertex; 12 bytes a side.
///
/// # Errors
/// When whoever watches the surface stops the step.
pub(super) fn regions(
    surface: &Surface<'_>,
    is_free: impl Fn(FaceId) -> bool,
    step: &'static str,
) -> Result<Column<FaceId, FaceId>, Cancelled> {
    let (mesh, watch) = (surface.mesh(), surface.watch());
    // The sides by their lower ends: where those of each place begin, then the higher end and the face of each.
    let mut starts = vec![0u32; mesh.counts().vertices + 1];
    sides(surface).for_each(|([low, _], _)| starts[low.index() + 1] += 1);
    for place in 1..starts.len() {
        starts[place] += starts[place - 1];
    }
    watch.look(step, 0, 0)?;
    let mut next = starts.clone();
    let mut by_place = vec![(VertexId(0), FaceId(0)); starts.last().map_or(0, |&count| count as usize)];
    for ([low, high], face) in sides(surface) {
        by_place[next[low.index()] as usize] = (high, face);
        next[low.index()] += 1;
    }
    watch.look(step, 0, 0)?;
    let mut joined = UnionFind::<u32>::new(mesh.counts().faces);
    for (place, bounds) in starts.windows(2).enumerate() {
        watch.look_at_times(step, place, starts.len())?;
        let here = &mut by_place[bounds[0] as usize..bounds[1] as usize];
        here.sort_unstable();
        for along in here.chunk_by(|one, other| one.0 == other.0) {
            if let [(_, one), (_, other)] = *along
                && is_free(one)
                && is_free(other)
            {
                joined.union(one.0, other.0);
            }
        }
    }
    watch.look(step, 0, 0)?;
    let roots = joined.into_labeling();
    let mut lowest = vec![None; roots.len()];
    let first = |(face, &root): (usize, &u32)| *lowest[root as usize].get_or_insert(FaceId::new(face));
    Ok(roots.iter().enumerate().map(first).collect())
}

/// The sides of the faces that have a surface: their places, the lower one first, and their faces.
fn sides<'a>(surface: &'a Surface<'_>) -> impl Iterator<Item = ([VertexId; 2], FaceId)> + 'a {
    let table = surface.mesh().faces();
    let faces = table.faces().filter(|&face| !surface.triangles_of(face).is_empty());
    faces.flat_map(move |face| {
        let vertices = table.face_vertices(face);
        vertices.iter().zip(vertices.iter().cycle().skip(1)).map(move |(&from, &to)| {
            let [one, other] = [from, to].map(|vertex| surface.place(vertex));
            ([one.min(other), one.max(other)], face)
        })
    })
}
