//! Which closed strip of faces is the shortest that comes back mirrored?
//!
//! The *shortest one-sided loop* of a patch that is not orientable: a shortest path between the two copies of one
//! face in the orientation double cover, least over all faces. Its faces are all different, for a strip that comes
//! back to a face falls into two, one of which is mirrored and shorter. Of equally short ones it is that with the
//! lowest face, and of those through that face the one whose edges from there are the lowest, compared one after
//! another.
//!
//! Every one-sided loop crosses the [seam](crate::seams) of its patch, so only the faces at a short seam are asked,
//! and each search ends half as far away as the best loop so far is long.

use meshmend_core::{Connectivity, EdgeId};
use serde::Serialize;

use crate::orientation::dual_graph::{DualGraph, TwistedPatches};
use crate::orientation::seam::cut_signed_edges;
use crate::{OneSidedStrip, PatchId, Patches, orientability};

mod search;

use search::{Round, Search, Spent};

/// How many times [`one_sided_loops`] looks at a side of a face before it gives up.
///
/// Only patches that are long and wide come near it: a Klein bottle of 220 × 440 triangles stays within it.
pub const ONE_SIDED_BUDGET: u64 = 1 << 28;

/// The shortest one-sided loop of a patch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OneSidedLoop {
    /// The strip of faces, from its lowest face on.
    #[serde(flatten)]
    pub strip: OneSidedStrip,
    /// Whether there is none that is shorter; otherwise it is the shortest that was found within the budget.
    pub is_shortest: bool,
}

/// The shortest one-sided loop of each patch that is not orientable, by the number of faces.
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{one_sided_loops, patches};
/// let band = [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 5], FaceTable::triangles(5, band)?)?;
/// let kernel = EdgeUse::build(mesh.complex())?;
/// assert_eq!(one_sided_loops(&kernel, &patches(&kernel))[0].strip.faces.len(), 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: constant if all patches are orientable; else that of [`seams`](crate::seams) and O(k n log n) for a seam
/// of k edges, or k times the faces within half a loop's length; at most [`ONE_SIDED_BUDGET`] looks.
pub fn one_sided_loops<K: Connectivity>(kernel: &K, patches: &Patches) -> Vec<OneSidedLoop> {
    shortest(kernel, patches, None, ONE_SIDED_BUDGET)
}

/// The shortest one-sided loop of each patch that is not orientable, by lengths of the steps across edges, such as
/// the ways between the centres of faces.
///
/// A patch in which a length is not a number from 0 on is measured in faces. Lengths count in steps of the 2³¹st part
/// of the longest one, and as one step at least.
///
/// *Cost*: that of [`one_sided_loops`].
pub fn one_sided_loops_by_length<K: Connectivity>(
    kernel: &K,
    patches: &Patches,
    length: impl Fn(EdgeId) -> f64,
) -> Vec<OneSidedLoop> {
    shortest(kernel, patches, Some(&length), ONE_SIDED_BUDGET)
}

/// The shortest one-sided loops, by lengths if there are any, with at most so many looks at a side of a face.
fn shortest<K: Connectivity>(
    kernel: &K,
    patches: &Patches,
    length: Option<&dyn Fn(EdgeId) -> f64>,
    budget: u64,
) -> Vec<OneSidedLoop> {
    let twisted = TwistedPatches::of(kernel, patches, length);
    let tied = DualGraph::of(&twisted.dual_edges);
    let mut starts = starts(patches, &twisted, &tied).into_iter().peekable();
    let mut search = Search::new(&tied.graph, budget);
    let shortened = orientability(kernel, patches).one_sided.into_iter().map(|witness| {
        let of_patch = std::iter::from_fn(|| starts.next_if(|start| start.0 == witness.patch));
        let (round, is_shortest) = best_round(&mut search, of_patch, twisted.length(&witness.edges));
        let strip = match round {
            Some(round) => {
                let signed_edges = search.lowest_signed_edges(round.lowest, round.length);
                strip(&twisted, &tied, (witness.patch, round.lowest), &signed_edges)
            }
            None => witness,
        };
        OneSidedLoop { strip, is_shortest }
    });
    shortened.collect()
}

/// Faces of each patch one of which every one-sided loop goes through, by patch and place.
fn starts(patches: &Patches, twisted: &TwistedPatches, tied: &DualGraph) -> Vec<(PatchId, u32)> {
    let cut = cut_signed_edges(patches, twisted, tied);
    let seam = tied
        .graph
        .signed_edges()
        .iter()
        .zip(cut)
        .filter(|(_, is_cut)| *is_cut)
        .map(|(signed_edge, _)| signed_edge.ends[0]);
    let mut starts: Vec<(PatchId, u32)> =
        seam.filter_map(|place| Some((patches.of_face(tied.face(place))?, place))).collect();
    starts.sort_unstable();
    starts.dedup();
    starts
}

/// The shortest way round from any of some faces, no longer than a bound, and whether all of them could be asked.
fn best_round(
    search: &mut Search<'_>,
    starts: impl Iterator<Item = (PatchId, u32)>,
    mut bound: u64,
) -> (Option<Round>, bool) {
    let (mut best, mut is_all): (Option<Round>, bool) = (None, true);
    for (_, start) in starts {
        match search.round(start, bound) {
            Ok(Some(round)) => {
                let lowest_so_far = best.filter(|best| best.length == round.length).map(|best| best.lowest);
                bound = round.length;
                best = Some(Round { lowest: lowest_so_far.unwrap_or(u32::MAX).min(round.lowest), ..round });
            }
            Ok(None) => {}
            Err(Spent) => is_all = false,
        }
    }
    (best, is_all)
}

/// The strip that crosses signed edges one after another, from a face on.
fn strip(
    twisted: &TwistedPatches,
    tied: &DualGraph,
    (patch, first): (PatchId, u32),
    signed_edges: &[u32],
) -> OneSidedStrip {
    let mut at = first;
    let step = |&signed_edge: &u32| {
        let [one, other] = tied.graph.signed_edge(signed_edge).ends;
        let face = tied.face(at);
        at = if one == at { other } else { one };
        face
    };
    let faces = signed_edges.iter().map(step).collect();
    let edges = signed_edges.iter().map(|&signed_edge| twisted.edges[signed_edge as usize]).collect();
    OneSidedStrip { patch, faces, edges }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceId, Id};

    use super::*;
    use crate::patches;
    use crate::shapes::{Random, Shape, klein_bottle, moebius_band, projective_plane, torus};

    fn loops<K: Connectivity>(kernel: &K) -> Vec<OneSidedLoop> {
        one_sided_loops(kernel, &patches(kernel))
    }

    /// By the definition: every mirrored way from a face that only goes through higher faces, none twice, by length,
    /// lowest face and edges.
    fn by_definition<K: Connectivity>(
        kernel: &K,
        patch: &[FaceId],
        weight: &dyn Fn(EdgeId) -> u64,
    ) -> (u64, FaceId, Vec<EdgeId>) {
        let mut best = None;
        for &first in patch {
            // (face, mirrored, edges, faces, length)
            let mut open = vec![(first, false, Vec::<EdgeId>::new(), vec![first], 0u64)];
            while let Some((face, mirrored, edges, faces, length)) = open.pop() {
                for corner in kernel.face_corners(face) {
                    let Some(other) = kernel.across(corner) else { continue };
                    let (edge, next) = (kernel.corner_edge(corner), kernel.corner_face(other));
                    let mirrored = mirrored ^ (kernel.corner_vertex(corner) == kernel.corner_vertex(other));
                    let mut edges = edges.clone();
                    edges.push(edge);
                    let length = length + weight(edge);
                    let key = (length, first, edges.clone());
                    if best.as_ref().is_some_and(|(least, _, _): &(u64, FaceId, Vec<EdgeId>)| length > *least)
                    {
                        continue;
                    }
                    if next == first && mirrored {
                        best = Some(best.map_or(key.clone(), |best| key.min(best)));
                    } else if next > first && !faces.contains(&next) {
                        let mut faces = faces.clone();
                        faces.push(next);
                        open.push((next, mirrored, edges, faces, length));
                    }
                }
            }
        }
        best.unwrap()
    }

    #[track_caller]
    fn assert_by_definition(shape: &Shape, random: &mut Random) -> usize {
        let kernel = shape.kernel();
        let patches = patches(&kernel);
        let lengths: Vec<u32> = (0..kernel.edge_count()).map(|_| 1 + random.below(4) as u32).collect();
        let by_faces = one_sided_loops(&kernel, &patches);
        let by_length = one_sided_loops_by_length(&kernel, &patches, |edge| f64::from(lengths[edge.index()]));
        for (found, weight) in [(&by_faces, None), (&by_length, Some(&lengths))] {
            for OneSidedLoop { strip, is_shortest } in found {
                assert!(is_shortest);
                let weight = |edge: EdgeId| weight.map_or(1, |lengths| u64::from(lengths[edge.index()]));
                let (_, first, edges) = by_definition(&kernel, patches.faces(strip.patch), &weight);
                assert_eq!((strip.faces[0], &strip.edges), (first, &edges), "{shape:?}");
                let mut at = first;
                for (&face, &edge) in strip.faces.iter().zip(&strip.edges) {
                    assert_eq!(face, at);
                    let ends: Vec<FaceId> = kernel.edge_faces(edge).collect();
                    at = if ends[0] == at { ends[1] } else { ends[0] };
                }
                assert_eq!(at, first);
            }
        }
        let twisted: Vec<_> = patches.ids().filter(|&patch| !patches.is_orientable(patch)).collect();
        assert_eq!(by_faces.iter().map(|found| found.strip.patch).collect::<Vec<_>>(), twisted);
        by_faces.len()
    }

    #[test]
    fn an_orientable_surface_has_none() {
        assert!(loops(&torus(4, 5).kernel()).is_empty());
    }

    #[test]
    fn closed_forms() {
        let length = |shape: &Shape| loops(&shape.kernel())[0].strip.faces.len();
        assert_eq!(length(&moebius_band(9)), 9);
        // Along the row in the middle; where there is none, it takes a step across.
        assert_eq!(length(&klein_bottle(12, 5)), 12);
        assert_eq!(length(&klein_bottle(8, 8)), 9);
        assert_eq!(length(&klein_bottle(5, 12)), 6);
        assert_eq!(length(&projective_plane()), 5);
        // A face that is glued to itself, and two that are to each other.
        assert_eq!(length(&Shape::of(&[&[2, 3, 0, 1, 4, 0, 1]])), 1);
        assert_eq!(length(&Shape::of(&[&[0, 1, 4, 2, 3, 5], &[1, 0, 2, 3]])), 2);
    }

    #[test]
    fn none_is_shorter_and_ties_are_as_defined() {
        let mut random = Random(41);
        let mut seen = 0;
        for round in 0..300 {
            let twisted = [klein_bottle(4, 3), projective_plane(), moebius_band(7), klein_bottle(3, 4)];
            let mut faces = twisted[round % 4].0.clone();
            faces.retain(|_| random.below(9) > 0);
            faces.extend(random.soup(13, 2, 6));
            let order = random.permutation(faces.len());
            let faces = order.iter().map(|&face| random.turned(&faces[face as usize])).collect();
            seen += assert_by_definition(&Shape(faces), &mut random);
        }
        assert!(seen > 150, "{seen}");
        for _ in 0..2000 {
            let soup = Shape(random.soup(6, 9, 6));
            assert_by_definition(&soup, &mut random);
        }
    }

    #[test]
    fn beyond_the_budget_it_says_so() {
        let kernel = klein_bottle(6, 6).kernel();
        let patches = patches(&kernel);
        for budget in [0, 30, 200] {
            let found = shortest(&kernel, &patches, None, budget);
            assert!(!found[0].is_shortest && found[0].strip.faces.len() >= 6);
        }
        assert_eq!(
            shortest(&kernel, &patches, None, 0)[0].strip,
            orientability(&kernel, &patches).one_sided[0]
        );
        assert!(shortest(&kernel, &patches, None, 1 << 14)[0].is_shortest);
    }
}
