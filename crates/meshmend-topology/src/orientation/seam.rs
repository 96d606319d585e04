//! Along which edges does orientation break, and how few can they be?
//!
//! However the faces of a patch that is not orientable are turned, some of its edges of degree 2 stay inconsistent:
//! they *clash*. For any choice of sides the clashing edges are one class of cycles mod 2 relative to the boundary,
//! and cutting along them leaves the patch orientable: a *seam*. A short one is sought from the sides of the
//! breadth-first walk on; in a large patch first among fewer and fewer faces that stand for many.
//!
//! *Guarantee*: the seam is no longer than that of the breadth-first walk, and cutting along it leaves the patch in
//! one piece. Among few faces no region can be turned that lies on one side of the seam, as the search sees its
//! sides, to make it shorter. It is the shortest there is on every small surface that was compared with all choices
//! of sides, but nothing promises that: finding the shortest is NP-hard when there is no bound on the number of
//! cross-caps.
//!
//! *Source*: E. W. Chambers, J. Erickson, A. Nayyeri, *Minimum cuts and shortest homologous cycles*, 2009, for
//! shortest cycles of a class and their hardness.

use meshmend_core::{Connectivity, EdgeId};
use serde::Serialize;

use crate::orientation::dual_graph::{DualEdge, DualGraph, SignedEdge, SignedGraph, TwistedPatches};
use crate::{PatchId, Patches, Side};

mod coarse;
mod flow;
mod shorten;
mod sides;
mod surroundings;

use coarse::Coarse;
use shorten::shorten;
use sides::{Sides, Walk};
use surroundings::Reach;

/// Among so many faces regions of any size are tried.
const FEW: usize = 2000;
/// Among more faces those within so many steps of the seam.
const STEPS: u32 = 8;

/// The edges along which a patch can be cut to make it orientable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Seam {
    /// The patch that it opens.
    pub patch: PatchId,
    /// The edges, ascending.
    pub edges: Vec<EdgeId>,
}

/// A short seam of each patch that is not orientable, by the number of edges.
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{patches, seams};
/// let band = [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 5], FaceTable::triangles(5, band)?)?;
/// let kernel = EdgeUse::build(mesh.complex())?;
/// assert_eq!(seams(&kernel, &patches(&kernel))[0].edges.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: constant if all patches are orientable; else O(n log n), with at most a fixed number of looks at each
/// side of those that are not.
pub fn seams<K: Connectivity>(kernel: &K, patches: &Patches) -> Vec<Seam> {
    of_twisted(patches, &TwistedPatches::of(kernel, patches, None))
}

/// A short seam of each patch that is not orientable, by the lengths of edges.
///
/// A patch in which a length is not a number from 0 on is measured in edges.
///
/// *Cost*: that of [`seams`].
pub fn seams_by_length<K: Connectivity>(
    kernel: &K,
    patches: &Patches,
    length: impl Fn(EdgeId) -> f64,
) -> Vec<Seam> {
    of_twisted(patches, &TwistedPatches::of(kernel, patches, Some(&length)))
}

/// For each dual edge whether it is part of a short seam: what is left can be oriented, and hangs together as before.
///
/// For faces that are joined by something else than a mesh's own edges. Dual edges are only cut to spare heavier ones
/// where that is possible at all: where those alone can be oriented, none of them is cut.
///
/// *Cost*: O(n log n) for n dual edges, and at most a fixed number of looks at each dual edge of what can't be
/// oriented.
pub fn short_seam(dual_edges: &[DualEdge]) -> Vec<bool> {
    let graph = DualGraph::of(dual_edges).graph;
    let Walk { components, is_turned } = Walk::over(&graph);
    shortened(&graph, &components, is_turned)
}

fn of_twisted(patches: &Patches, twisted: &TwistedPatches) -> Vec<Seam> {
    let is_cut = cut_signed_edges(patches, twisted, &DualGraph::of(&twisted.dual_edges));
    let seams = twisted.patches.iter().map(|&patch| Seam { patch, edges: Vec::new() });
    let mut seams: Vec<Seam> = seams.collect();
    for ((dual_edge, &edge), is_cut) in twisted.dual_edges.iter().zip(&twisted.edges).zip(is_cut) {
        let place = seams.partition_point(|seam| Some(seam.patch) < patches.of_face(dual_edge.faces[0]));
        if let Some(seam) = seams.get_mut(place).filter(|_| is_cut) {
            seam.edges.push(edge);
        }
    }
    seams
}

/// For each signed edge in the patches that are not orientable whether it is part of a short seam.
pub(crate) fn cut_signed_edges(patches: &Patches, twisted: &TwistedPatches, tied: &DualGraph) -> Vec<bool> {
    let is_reversed = |place| patches.side(tied.face(place)) == Side::Reversed;
    let is_turned = tied.graph.faces().map(is_reversed).collect();
    // In the order of the walk, in which neighbours are near to one another in memory.
    let component = |&patch: &PatchId| patches.faces(patch).iter().map(|&face| tied.place(face)).collect();
    let components: Vec<Vec<u32>> = twisted.patches.iter().map(component).collect();
    shortened(&tied.graph, &components, is_turned)
}

/// Shortens the seams of the components that have one; for each signed edge whether it is cut.
fn shortened(graph: &SignedGraph, components: &[Vec<u32>], mut is_turned: Vec<bool>) -> Vec<bool> {
    let sides = Sides::given(graph, is_turned.clone());
    let mut has_seam = vec![false; graph.face_count()];
    sides.clashing().for_each(|signed_edge| has_seam[graph.signed_edge(signed_edge).ends[0] as usize] = true);
    let mut place = vec![0u32; graph.face_count()];
    for component in components.iter().filter(|faces| faces.iter().any(|&face| has_seam[face as usize])) {
        (0..).zip(component).for_each(|(new, &face)| place[face as usize] = new);
        let part = part(graph, component, &place);
        let start = component.iter().map(|&face| is_turned[face as usize]).collect();
        let found = short_sides(&part, start);
        component.iter().zip(found).for_each(|(&face, side)| is_turned[face as usize] = side);
    }
    let sides = Sides::given(graph, is_turned);
    (0..graph.signed_edges().len() as u32).map(|signed_edge| sides.clashes(signed_edge)).collect()
}

/// A component as a graph of its own; without signed edges of faces with themselves, which clash whatever is turned.
fn part(graph: &SignedGraph, component: &[u32], place: &[u32]) -> SignedGraph {
    let edges_of = |&face: &u32| {
        let arcs = graph.arcs(face).iter().filter(move |arc| arc.to != face);
        let signed_edges = arcs
            .map(|arc| graph.signed_edge(arc.signed_edge))
            .filter(move |signed_edge| signed_edge.ends[0] == face);
        signed_edges.map(|signed_edge| SignedEdge {
            ends: signed_edge.ends.map(|face| place[face as usize]),
            ..*signed_edge
        })
    };
    SignedGraph::new(component.len(), component.iter().flat_map(edges_of).collect())
}

/// Sides for which little clashes, no more than at the start: searched among all of few faces, and where there are
/// many in coarser and coarser graphs first, and in each finer one near the seam.
fn short_sides(graph: &SignedGraph, start: Vec<bool>) -> Vec<bool> {
    if graph.face_count() <= FEW {
        return shorten(Sides::given(graph, start), Reach::All).into_turned();
    }
    let mut levels = coarser_and_coarser(graph);
    let mut found: Option<Vec<bool>> = None;
    while let Some(level) = levels.pop() {
        let (start, reach) = match found {
            None => (Walk::over(&level.graph).is_turned, Reach::All),
            Some(found) => (found, Reach::Steps(STEPS)),
        };
        let reach = if level.graph.face_count() <= FEW { reach } else { Reach::Steps(STEPS) };
        found = Some(level.in_fine(&shorten(Sides::given(&level.graph, start), reach).into_turned()));
    }
    let given = Sides::given(graph, start);
    let best = match found.map(|found| Sides::given(graph, found)) {
        Some(found) if found.cost() < given.cost() => found,
        _ => given,
    };
    shorten(best, Reach::Steps(STEPS)).into_turned()
}

/// Graphs with fewer and fewer faces. Each has at most nine tenths of the faces of the one before, so that all
/// together have no more than ten times those of the first; where that can't be had they end with many.
fn coarser_and_coarser(graph: &SignedGraph) -> Vec<Coarse> {
    let mut levels = vec![Coarse::of(graph, &vec![1; graph.face_count()])];
    while let Some(last) = levels.last().filter(|last| last.graph.face_count() > FEW) {
        let next = last.coarser();
        if next.graph.face_count() * 10 > last.graph.face_count() * 9 {
            break;
        }
        levels.push(next);
    }
    levels
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceId, Id};

    use super::*;
    use crate::patches;
    use crate::shapes::{Random, Shape, klein_bottle, moebius_band, projective_plane, torus};

    /// A Möbius band of an even width: a Klein bottle without its row in the middle.
    fn wide_moebius_band(round: u32, width: u32) -> Shape {
        let mut band = klein_bottle(round, width + 1);
        let mut place = 0..;
        band.0.retain(|_| place.next().is_some_and(|face| face % (width + 1) != width / 2));
        band
    }

    fn seam_lengths(shape: &Shape) -> Vec<usize> {
        let kernel = shape.kernel();
        seams(&kernel, &patches(&kernel)).iter().map(|seam| seam.edges.len()).collect()
    }

    #[test]
    fn closed_forms() {
        assert!(seam_lengths(&torus(4, 5)).is_empty());
        assert_eq!(seam_lengths(&klein_bottle(8, 8)), [8]);
        assert_eq!(seam_lengths(&klein_bottle(30, 5)), [5]);
        assert_eq!(seam_lengths(&klein_bottle(5, 30)), [30]);
        assert_eq!(seam_lengths(&moebius_band(9)), [1]);
        assert_eq!(seam_lengths(&wide_moebius_band(20, 6)), [6]);
        // The shortest closed edge path that can't be shrunk has three edges.
        assert_eq!(seam_lengths(&projective_plane()), [3]);
        assert_eq!(seam_lengths(&Shape::of(&[&[2, 3, 0, 1, 4, 0, 1]])), [1]);
        let parts = [klein_bottle(4, 7), torus(3, 3), moebius_band(5)];
        assert_eq!(seam_lengths(&Shape::side_by_side(&parts)), [7, 1]);
    }

    #[test]
    fn among_many_faces_it_is_found_too() {
        let mut random = Random(54);
        for (shape, width) in [(klein_bottle(60, 50), 50), (wide_moebius_band(90, 40), 40)] {
            assert!(shape.0.len() > FEW);
            let order = random.permutation(shape.0.len());
            let faces = order.iter().map(|&face| random.turned(&shape.0[face as usize])).collect();
            assert_eq!(seam_lengths(&shape), [width]);
            assert_eq!(seam_lengths(&Shape(faces)), [width]);
        }
    }

    #[test]
    fn lengths_can_be_given() {
        let kernel = wide_moebius_band(20, 6).kernel();
        let patches = patches(&kernel);
        let cheap = seams(&kernel, &patches)[0].edges.clone();
        // The seam is elsewhere when its edges are dear, and where it was when all others are.
        let dear = |edge: EdgeId| if cheap.contains(&edge) { 9.5 } else { 1.5 };
        let other = &seams_by_length(&kernel, &patches, dear)[0].edges;
        assert!(other.len() == 6 && other.iter().all(|edge| !cheap.contains(edge)));
        assert_eq!(seams_by_length(&kernel, &patches, |edge| 11.0 - dear(edge))[0].edges, cheap);
        for unusable in [f64::NAN, f64::INFINITY, -1.0, 0.0] {
            let length = |edge: EdgeId| if unusable == 0.0 || edge.0 == 5 { unusable } else { dear(edge) };
            assert_eq!(seams_by_length(&kernel, &patches, length)[0].edges.len(), 6);
        }
    }

    /// The least that can clash, by trying all sides.
    fn least(dual_edges: &[DualEdge], faces: usize) -> u64 {
        let cost = |turned: u32| -> u64 {
            let is_turned = |face: FaceId| turned >> face.0 & 1 == 1;
            let clashes = |j: &&DualEdge| is_turned(j.faces[0]) ^ is_turned(j.faces[1]) ^ j.is_mirrored;
            dual_edges.iter().filter(clashes).map(|dual_edge| u64::from(dual_edge.weight)).sum()
        };
        (0..1u32 << (faces - 1)).map(cost).min().unwrap()
    }

    /// Whether what is not cut can be oriented, and hangs together as all dual edges do.
    fn is_seam(dual_edges: &[DualEdge], is_cut: &[bool]) -> bool {
        let rest: Vec<DualEdge> = dual_edges
            .iter()
            .zip(is_cut)
            .filter(|(_, is_cut)| !**is_cut)
            .map(|(dual_edge, _)| *dual_edge)
            .collect();
        let [whole, graph] = [dual_edges, &rest].map(|dual_edges| DualGraph::of(dual_edges).graph);
        let walk = Walk::over(&graph);
        let sides = Sides::given(&graph, walk.is_turned);
        let pieces = walk.components.len() + whole.face_count() - graph.face_count();
        (0..graph.signed_edges().len() as u32).all(|signed_edge| !sides.clashes(signed_edge))
            && pieces == Walk::over(&whole).components.len()
    }

    #[test]
    fn on_small_surfaces_none_is_shorter() {
        let mut random = Random(51);
        let mut seen = 0;
        for round in 0..300 {
            let twisted = [klein_bottle(4, 3), projective_plane(), moebius_band(7), klein_bottle(3, 4)]
                [round % 4]
                .clone();
            let mut faces = twisted.0;
            if round > 8 {
                faces.retain(|_| random.below(9) > 0);
            }
            let order = random.permutation(faces.len());
            let faces = order.iter().map(|&face| random.turned(&faces[face as usize])).collect();
            let kernel = Shape(faces).kernel();
            let patches = patches(&kernel);
            let twisted = TwistedPatches::of(&kernel, &patches, None);
            let found = seams(&kernel, &patches);
            let length: usize = found.iter().map(|seam| seam.edges.len()).sum();
            assert_eq!(length as u64, least(&twisted.dual_edges, kernel.face_count()));
            let is_cut = |edge| found.iter().any(|seam| seam.edges.contains(edge));
            assert!(is_seam(&twisted.dual_edges, &twisted.edges.iter().map(is_cut).collect::<Vec<_>>()));
            seen += found.len();
        }
        assert!(seen > 200, "{seen}");
    }

    #[test]
    fn on_dual_edges_of_any_kind_nearly_none_is_shorter() {
        let mut random = Random(52);
        let mut shortest = 0;
        for round in 0..300 {
            let faces = 4 + random.below(8);
            let id = |face: usize| FaceId::new(face);
            let heaviest = if round % 2 == 0 { 1 } else { 5 };
            let mut dual_edges: Vec<DualEdge> = Vec::new();
            for place in 0..2 * faces {
                let one = if place > 0 && place < faces { place } else { random.below(faces) };
                let other =
                    if place > 0 && place < faces { random.below(place) } else { random.below(faces) };
                let (is_mirrored, weight) = (random.below(2) == 0, 1 + random.below(heaviest) as u32);
                dual_edges.push(DualEdge { faces: [id(one), id(other)], is_mirrored, weight });
            }
            let is_cut = short_seam(&dual_edges);
            assert!(is_seam(&dual_edges, &is_cut), "{dual_edges:?}");
            let length: u64 = dual_edges
                .iter()
                .zip(&is_cut)
                .filter(|(_, cut)| **cut)
                .map(|(j, _)| u64::from(j.weight))
                .sum();
            let least = least(&dual_edges, faces);
            assert!(length >= least);
            shortest += usize::from(length == least);
        }
        assert!(shortest > 270, "{shortest}");
    }

    /// Dual edges such as `0-1=2 1-2~1`: the faces, `~` where the dual edge mirrors, and the weight.
    fn dual_edges(text: &str) -> Vec<DualEdge> {
        let dual_edge = |word: &str| {
            let mut numbers = word.split(['-', '=', '~']).map(|n| n.parse().unwrap());
            let faces = [(); 2].map(|()| FaceId(numbers.next().unwrap()));
            DualEdge { faces, is_mirrored: word.contains('~'), weight: numbers.next().unwrap() }
        };
        text.split(' ').map(dual_edge).collect()
    }

    #[test]
    fn each_step_of_the_search_is_needed_for_the_shortest_seams() {
        let cases = [
            // Only where a region was turned that costs the same is there one that is better.
            "2-4=1 1-0=1 2-0~1 3-1~1 4-2~1 1-4~1 4-0=1 3-2~1 3-2~1",
            "3-1~5 1-0=2 2-1~3 3-2~7 4-0~6 5-0=4 6-4=1 3-6=2 4-5=8 4-6~8 0-5=4",
            // Only single faces lead there: as regions they are held.
            "3-1~1 1-0=1 2-0~1 3-1~1 4-0=1 5-0~1 5-4=1 3-1=1 5-2~1",
            "0-4=8 1-0~6 2-0=4 3-0~8 4-1~4 2-3=3 1-0=6 2-4~3",
        ];
        for text in cases {
            let dual_edges = dual_edges(text);
            let faces = dual_edges.iter().flat_map(|dual_edge| dual_edge.faces).max().unwrap().index() + 1;
            let is_cut = short_seam(&dual_edges);
            assert!(is_seam(&dual_edges, &is_cut));
            let cut = dual_edges.iter().zip(is_cut).filter(|(_, is_cut)| *is_cut);
            assert_eq!(
                cut.map(|(dual_edge, _)| u64::from(dual_edge.weight)).sum::<u64>(),
                least(&dual_edges, faces)
            );
        }
    }

    /// A Klein bottle that is half as wide at one place, as far from the seam of the walk as from its beginning.
    #[test]
    fn among_many_faces_the_waist_is_found_from_far_away() {
        let (round, width) = (150, 20);
        let mut bottle = klein_bottle(round, width);
        let waist = round / 4 * width;
        bottle.0.drain((waist + width / 2) as usize..(waist + width) as usize);
        assert!(bottle.0.len() > FEW);
        assert_eq!(seam_lengths(&bottle), [width as usize / 2]);
    }

    /// Stars of signed edges, each the middle and its rays.
    fn stars(count: u32, rays: u32) -> SignedGraph {
        let signed_edge = |star: u32, ray: u32| SignedEdge {
            ends: [star * (rays + 1), star * (rays + 1) + ray],
            is_mirrored: false,
            weight: 1,
        };
        let signed_edges = (0..count).flat_map(|star| (1..=rays).map(move |ray| signed_edge(star, ray)));
        SignedGraph::new((count * (rays + 1)) as usize, signed_edges.collect())
    }

    #[test]
    fn graphs_become_coarser_by_a_tenth_or_not_at_all() {
        let sizes = |graph: &SignedGraph| -> Vec<usize> {
            coarser_and_coarser(graph).iter().map(|level| level.graph.face_count()).collect()
        };
        // Of a star two faces are joined at a time, from 11 of them on, 10, 9, …
        assert_eq!(sizes(&stars(300, 10)), [3000, 2700, 2400, 2100, 1800]);
        assert_eq!(sizes(&stars(1, 2 * FEW as u32)), [2 * FEW]);
    }

    #[test]
    fn where_no_faces_can_be_joined_the_lighter_joints_are_cut_too() {
        let dual_edge = |ray: usize, is_mirrored: bool| {
            let weight = if is_mirrored == ray.is_multiple_of(2) { 2 } else { 1 };
            DualEdge { faces: [FaceId(0), FaceId::new(ray)], is_mirrored, weight }
        };
        let dual_edges: Vec<DualEdge> =
            (1..=2 * FEW).flat_map(|ray| [dual_edge(ray, true), dual_edge(ray, false)]).collect();
        let is_cut = short_seam(&dual_edges);
        assert!(dual_edges.iter().zip(is_cut).all(|(dual_edge, is_cut)| is_cut == (dual_edge.weight == 1)));
    }

    #[test]
    fn heavy_joints_that_agree_are_not_cut() {
        let mut random = Random(53);
        for round in 0..201 {
            let count = if round < 200 { 30 } else { 3 * FEW };
            let sides: Vec<bool> = (0..count).map(|_| random.below(2) == 0).collect();
            let mut dual_edge = |is_firm: bool| {
                let faces = [random.below(count), random.below(count)];
                let agrees = sides[faces[0]] ^ sides[faces[1]];
                let is_mirrored = if is_firm { agrees } else { random.below(2) == 0 };
                let weight = if is_firm { u32::MAX } else { 1 };
                DualEdge { faces: faces.map(FaceId::new), is_mirrored, weight }
            };
            let dual_edges: Vec<DualEdge> = (0..2 * count).map(|place| dual_edge(place % 3 == 0)).collect();
            let is_cut = short_seam(&dual_edges);
            assert!(is_seam(&dual_edges, &is_cut));
            assert!(
                dual_edges.iter().zip(is_cut).all(|(dual_edge, is_cut)| !is_cut || dual_edge.weight == 1)
            );
        }
    }
}
