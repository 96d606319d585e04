//! Which patches have no consistent side, and what shows it?
//!
//! A patch that is not orientable carries a *witness*: a closed strip of faces f₀ f₁ … f₀, each two neighbours
//! sharing a named edge of degree 2, that reverses orientation once round. It is read off the breadth-first tree
//! from the patch's lowest face, neighbours in corner order. Each edge that contradicts the tree's sides closes
//! one cycle with it, through the lowest common ancestor of its two faces; the cycle with the fewest faces is
//! taken, of equal ones that with the lowest edge. Its faces are all different. It begins at its lowest face and
//! runs in the direction whose first edge has the lower id. A face that is glued to itself is a strip alone.
//!
//! *Source*: for ancestors in O(log n) by one jump pointer a node: E. W. Myers, *An applicative random-access
//! stack*, 1983.

use meshmend_core::{Column, Connectivity, CornerId, Defect, EdgeId, FaceId};
use serde::Serialize;

use crate::{PatchId, Patches};

/// A closed strip of faces that comes back mirrored.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OneSidedStrip {
    /// The patch that it shows to be non-orientable.
    pub patch: PatchId,
    /// The faces, all different, the lowest one first.
    pub faces: Vec<FaceId>,
    /// The edge between each face and the next one, the last leading back to the first face.
    pub edges: Vec<EdgeId>,
}

impl From<OneSidedStrip> for Defect {
    fn from(strip: OneSidedStrip) -> Self {
        Defect::non_orientable_patch(strip.faces, strip.edges)
    }
}

/// Whether a mesh is orientable, with the proof where it is not.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Orientability {
    /// A witness for each patch that is not orientable, ascending.
    pub one_sided: Vec<OneSidedStrip>,
}

impl Orientability {
    /// Whether every patch is orientable.
    pub fn is_orientable(&self) -> bool {
        self.one_sided.is_empty()
    }
}

/// The witnesses of all patches that are not orientable.
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{orientability, patches};
/// let band = [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 5], FaceTable::triangles(5, band)?)?;
/// let kernel = EdgeUse::build(mesh.complex())?;
/// let found = orientability(&kernel, &patches(&kernel));
/// assert_eq!(found.one_sided[0].faces.len(), 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: constant if all patches are orientable; else linear in the corners of those that are not, with a
/// logarithm for each contradicting edge, and 12 bytes a face.
pub fn orientability<K: Connectivity>(kernel: &K, patches: &Patches) -> Orientability {
    let mut twisted = patches.ids().filter(|&patch| !patches.is_orientable(patch)).peekable();
    if twisted.peek().is_none() {
        return Orientability::default();
    }
    let mut tree = Tree::new(kernel, patches);
    let one_sided = twisted.filter_map(|patch| {
        tree.grow(patch);
        tree.shortest_one_sided_cycle(patch)
    });
    Orientability { one_sided: one_sided.collect() }
}

/// The breadth-first trees of the patches, with a jump pointer each face.
struct Tree<'a, K> {
    kernel: &'a K,
    patches: &'a Patches,
    /// The corner of the predecessor across whose side a face was reached; `ROOT` for a lowest face.
    entry: Column<FaceId, CornerId>,
    jump: Column<FaceId, FaceId>,
    depth: Column<FaceId, u32>,
}

const UNSEEN: CornerId = CornerId(u32::MAX);
const ROOT: CornerId = CornerId(u32::MAX - 1);

impl<'a, K: Connectivity> Tree<'a, K> {
    fn new(kernel: &'a K, patches: &'a Patches) -> Self {
        let count = kernel.face_count();
        Tree {
            kernel,
            patches,
            entry: Column::filled(UNSEEN, count),
            jump: Column::filled(FaceId(0), count),
            depth: Column::filled(0, count),
        }
    }

    /// Adds the tree of a patch.
    fn grow(&mut self, patch: PatchId) {
        let faces = self.patches.faces(patch);
        let Some(&root) = faces.first() else { return };
        self.entry[root] = ROOT;
        self.jump[root] = root;
        for &face in faces {
            for corner in self.kernel.face_corners(face) {
                let Some(crossing) = self.patches.crossings().across(corner) else { continue };
                let neighbour = self.kernel.corner_face(crossing.opposite);
                if self.entry[neighbour] == UNSEEN {
                    self.entry[neighbour] = corner;
                    self.depth[neighbour] = self.depth[face] + 1;
                    self.jump[neighbour] = self.jump_from(face);
                }
            }
        }
    }

    /// Where the children of a face jump to: over two equal jumps at once, or else to the face.
    fn jump_from(&self, face: FaceId) -> FaceId {
        let middle = self.jump[face];
        let end = self.jump[middle];
        let equal = self.depth[face] - self.depth[middle] == self.depth[middle] - self.depth[end];
        if equal { end } else { face }
    }

    /// The predecessor of a face; a lowest face is its own.
    fn parent(&self, face: FaceId) -> FaceId {
        if self.entry[face] == ROOT { face } else { self.kernel.corner_face(self.entry[face]) }
    }

    /// The ancestor of a face at a depth not beyond its own.
    fn ancestor_at(&self, mut face: FaceId, depth: u32) -> FaceId {
        while self.depth[face] > depth {
            let far = self.jump[face];
            face = if self.depth[far] >= depth { far } else { self.parent(face) };
        }
        face
    }

    fn lowest_common_ancestor(&self, one: FaceId, other: FaceId) -> FaceId {
        let depth = self.depth[one].min(self.depth[other]);
        let (mut one, mut other) = (self.ancestor_at(one, depth), self.ancestor_at(other, depth));
        while one != other {
            let far = [self.jump[one], self.jump[other]];
            [one, other] = if far[0] == far[1] { [self.parent(one), self.parent(other)] } else { far };
        }
        one
    }

    /// The witness of a patch; `None` where no edge contradicts the sides.
    fn shortest_one_sided_cycle(&self, patch: PatchId) -> Option<OneSidedStrip> {
        let corners = self.patches.faces(patch).iter().flat_map(|&face| self.kernel.face_corners(face));
        let cycles = corners.filter_map(|corner| self.one_sided_cycle(corner));
        let (_, _, corner) = cycles.min()?;
        Some(self.strip(patch, corner))
    }

    /// The cycle that a corner's edge closes with the tree, where it contradicts the sides: how many faces it
    /// has, the edge, and the corner.
    fn one_sided_cycle(&self, corner: CornerId) -> Option<(u32, EdgeId, CornerId)> {
        let kernel = self.kernel;
        let crossing =
            self.patches.crossings().across(corner).filter(|crossing| corner < crossing.opposite)?;
        let [one, other] = [corner, crossing.opposite].map(|c| kernel.corner_face(c));
        if self.patches.side(one).across(crossing.is_mirrored) == self.patches.side(other) {
            return None;
        }
        let apex = self.depth[self.lowest_common_ancestor(one, other)];
        let length = self.depth[one] + self.depth[other] - 2 * apex + 1;
        Some((length, kernel.corner_edge(corner), corner))
    }

    /// The strip from the lowest common ancestor down to one face of a contradicting edge, across the edge, and
    /// up again from the other.
    fn strip(&self, patch: PatchId, corner: CornerId) -> OneSidedStrip {
        let kernel = self.kernel;
        let closing = kernel.across(corner).unwrap_or(corner);
        let [one, other] = [corner, closing].map(|c| kernel.corner_face(c));
        let apex = self.lowest_common_ancestor(one, other);
        let (mut faces, mut edges) = self.path_up(one, apex);
        faces.push(apex);
        faces.reverse();
        edges.reverse();
        edges.push(kernel.corner_edge(corner));
        let (faces_up, edges_up) = self.path_up(other, apex);
        faces.extend(faces_up);
        edges.extend(edges_up);
        let (faces, edges) = in_normal_form(faces, edges);
        OneSidedStrip { patch, faces, edges }
    }

    /// The faces from one up to an ancestor, that one left out, and the edges on the way.
    fn path_up(&self, mut face: FaceId, ancestor: FaceId) -> (Vec<FaceId>, Vec<EdgeId>) {
        let (mut faces, mut edges) = (Vec::new(), Vec::new());
        while face != ancestor {
            faces.push(face);
            edges.push(self.kernel.corner_edge(self.entry[face]));
            face = self.parent(face);
        }
        (faces, edges)
    }
}

/// A strip from its lowest face on, in the direction whose first edge has the lower id.
fn in_normal_form(mut faces: Vec<FaceId>, mut edges: Vec<EdgeId>) -> (Vec<FaceId>, Vec<EdgeId>) {
    let lowest = (0..faces.len()).min_by_key(|&place| faces[place]).unwrap_or(0);
    faces.rotate_left(lowest);
    edges.rotate_left(lowest);
    if edges.last() < edges.first() {
        faces[1..].reverse();
        edges.reverse();
    }
    (faces, edges)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patches;
    use crate::shapes::{Random, kernel, klein_bottle, moebius_band, projective_plane, torus};
    use std::collections::BTreeSet;

    fn witnesses<K: Connectivity>(kernel: &K) -> Vec<OneSidedStrip> {
        orientability(kernel, &patches(kernel)).one_sided
    }

    /// Whether a strip is simple, joined across the edges that it names, and comes back mirrored.
    fn is_one_sided<K: Connectivity>(kernel: &K, strip: &OneSidedStrip) -> bool {
        let (mut is_joined, mut mirrored) = (true, false);
        let n = strip.faces.len();
        for i in 0..n {
            let sides: Vec<_> = kernel.edge_corners(strip.edges[i]).collect();
            let mut joined: Vec<_> = sides.iter().map(|&c| kernel.corner_face(c)).collect();
            let mut wanted = vec![strip.faces[i], strip.faces[(i + 1) % n]];
            joined.sort_unstable();
            wanted.sort_unstable();
            is_joined &= joined == wanted;
            mirrored ^= kernel.corner_vertex(sides[0]) == kernel.corner_vertex(sides[1]);
        }
        is_joined
            && mirrored
            && n == strip.edges.len()
            && strip.faces.iter().collect::<BTreeSet<_>>().len() == n
    }

    #[test]
    fn orientable_surfaces_have_no_witness() {
        assert!(witnesses(&torus(4, 5).kernel()).is_empty());
        let is_orientable = |kernel| orientability(&kernel, &patches(&kernel)).is_orientable();
        assert!(is_orientable(torus(4, 5).kernel()) && !is_orientable(klein_bottle(4, 5).kernel()));
    }

    #[test]
    fn one_sided_surfaces_have_a_valid_one() {
        for shape in [moebius_band(9), klein_bottle(5, 4), projective_plane()] {
            let kernel = shape.kernel();
            let found = witnesses(&kernel);
            assert_eq!(found.len(), 1);
            assert!(is_one_sided(&kernel, &found[0]), "{found:?}");
        }
        assert_eq!(witnesses(&moebius_band(9).kernel())[0].faces.len(), 9);
    }

    #[test]
    fn a_face_may_be_glued_to_itself_and_two_to_each_other() {
        let alone = kernel(5, &[&[2, 3, 0, 1, 4, 0, 1]]);
        let strip = &witnesses(&alone)[0];
        assert_eq!((strip.faces.len(), strip.edges.len()), (1, 1));
        assert!(is_one_sided(&alone, strip));
        let pair = kernel(6, &[&[0, 1, 4, 2, 3, 5], &[1, 0, 2, 3]]);
        let strip = &witnesses(&pair)[0];
        assert_eq!(strip.faces, [FaceId(0), FaceId(1)]);
        assert!(strip.edges[0] < strip.edges[1] && is_one_sided(&pair, strip));
    }

    /// By steps from face to face the ancestors of all edges would take quadratic time.
    #[test]
    fn few_jumps_lead_up_a_long_tree() {
        let kernel = moebius_band(10_000).kernel();
        let patches = patches(&kernel);
        let mut tree = Tree::new(&kernel, &patches);
        patches.ids().for_each(|patch| tree.grow(patch));
        let deepest = kernel.faces().max_by_key(|&face| tree.depth[face]).unwrap();
        let jumps = std::iter::successors(Some(deepest), |&face| Some(tree.jump[face]));
        assert_eq!(tree.depth[deepest], 5000);
        assert!(jumps.take_while(|&face| tree.depth[face] > 0).count() <= 2 * 13);
    }

    #[test]
    fn the_choice_is_the_defined_one() {
        let mut random = Random(3);
        let twisted = [klein_bottle(4, 3), projective_plane(), moebius_band(7), klein_bottle(3, 4)];
        let mut seen = 0;
        for round in 0..400 {
            // A one-sided surface with holes, shuffled and partly flipped, among which a few faces more.
            let names = random.permutation(14);
            let mut faces = twisted[round % 4].0.clone();
            faces.retain(|_| random.below(9) > 0);
            faces.extend(random.soup(13, 2, 6));
            let order = random.permutation(faces.len());
            let faces: Vec<Vec<u32>> = order.iter().map(|&f| random.turned(&faces[f as usize])).collect();
            let renamed = faces.iter().map(|face| face.iter().map(|&v| names[v as usize]).collect());
            seen += assert_as_defined(&renamed.collect::<Vec<_>>());
        }
        assert!(seen > 200, "{seen}");
        (0..2000).for_each(|_| {
            assert_as_defined(&random.soup(6, 9, 6));
        });
    }

    /// Compares with the definition; how many witnesses there were.
    #[track_caller]
    fn assert_as_defined(soup: &[Vec<u32>]) -> usize {
        let faces: Vec<&[u32]> = soup.iter().map(Vec::as_slice).collect();
        let kernel = kernel(14, &faces);
        let patches = patches(&kernel);
        let found = orientability(&kernel, &patches).one_sided;
        let twisted: Vec<_> = patches.ids().filter(|&p| !flips_exist(&kernel, patches.faces(p))).collect();
        assert_eq!(found.iter().map(|s| s.patch).collect::<Vec<_>>(), twisted, "{soup:?}");
        for strip in &found {
            assert!(is_one_sided(&kernel, strip), "{soup:?}");
            let defined = by_definition(&kernel, patches.faces(strip.patch)[0]);
            assert_eq!((&strip.faces, &strip.edges), (&defined.0, &defined.1), "{soup:?}");
        }
        found.len()
    }

    /// Whether some choice of faces to flip makes all edges of degree 2 consistent, by trying all.
    fn flips_exist<K: Connectivity>(kernel: &K, faces: &[FaceId]) -> bool {
        let bit = |f: FaceId| faces.iter().position(|&g| g == f).unwrap();
        (0u32..1 << faces.len()).any(|flips| {
            faces.iter().flat_map(|&f| kernel.face_corners(f)).all(|c| {
                let Some(d) = kernel.across(c) else { return true };
                let [f, g] = [c, d].map(|c| flips >> bit(kernel.corner_face(c)) & 1);
                (kernel.corner_vertex(c) == kernel.corner_vertex(d)) == (f != g)
            })
        })
    }

    /// The witness straight from its definition: whole paths to the root instead of ancestors.
    fn by_definition<K: Connectivity>(kernel: &K, root: FaceId) -> (Vec<FaceId>, Vec<EdgeId>) {
        // The path of each face from the root: faces, and edges each with whether it mirrors.
        let mut paths =
            std::collections::BTreeMap::from([(root, (vec![root], Vec::<(EdgeId, bool)>::new()))]);
        let mut queue = std::collections::VecDeque::from([root]);
        let mirrors = |c, d| kernel.corner_vertex(c) == kernel.corner_vertex(d);
        while let Some(face) = queue.pop_front() {
            for c in kernel.face_corners(face).collect::<Vec<_>>() {
                let Some(d) = kernel.across(c) else { continue };
                let neighbour = kernel.corner_face(d);
                if !paths.contains_key(&neighbour) {
                    let (mut faces, mut edges) = paths[&face].clone();
                    faces.push(neighbour);
                    edges.push((kernel.corner_edge(c), mirrors(c, d)));
                    paths.insert(neighbour, (faces, edges));
                    queue.push_back(neighbour);
                }
            }
        }
        let mut cycles = Vec::new();
        for edge in kernel.edges() {
            let sides: Vec<_> = kernel.edge_corners(edge).collect();
            let [c, d] = sides[..] else { continue };
            let (Some(one), Some(other)) =
                (paths.get(&kernel.corner_face(c)), paths.get(&kernel.corner_face(d)))
            else {
                continue;
            };
            let turns = one.1.iter().chain(&other.1).filter(|e| e.1).count() + usize::from(mirrors(c, d));
            if turns % 2 == 1 {
                let common = one.0.iter().zip(&other.0).take_while(|(a, b)| a == b).count();
                let down = one.0[common - 1..].iter().chain(other.0[common..].iter().rev()).copied();
                let closing = (edge, false);
                let across = one.1[common - 1..].iter().chain([&closing]);
                let edges = across.chain(other.1[common - 1..].iter().rev()).map(|e| e.0);
                cycles.push((
                    down.clone().count(),
                    edge,
                    down.collect::<Vec<_>>(),
                    edges.collect::<Vec<_>>(),
                ));
            }
        }
        let (_, _, faces, edges) = cycles.into_iter().min().unwrap();
        let n = faces.len();
        let start = (0..n).min_by_key(|&i| faces[i]).unwrap();
        let forward = (0..n).map(|i| (faces[(start + i) % n], edges[(start + i) % n]));
        let backward = (0..n).map(|i| (faces[(start + n - i) % n], edges[(start + 2 * n - i - 1) % n]));
        let forward: (Vec<_>, Vec<_>) = forward.unzip();
        let backward: (Vec<_>, Vec<_>) = backward.unzip();
        if forward.1[0] <= backward.1[0] { forward } else { backward }
    }
}
