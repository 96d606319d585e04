//! What does each vertex, edge and face change, when they are added one after another?
//!
//! A cell of dimension d either *starts* a cycle of its own dimension, so that β_d grows by one, or *fills* one of the
//! dimension below, so that β_{d−1} shrinks by one. Added are, face by face in the order of the file, the vertices that
//! the face is the first to use, then the edges that it is the first to use, each in the order of its corners, then the
//! face. A vertex starts a component. An edge joins two components, or starts a loop. A face fills a loop, or encloses a
//! void. In the end the numbers are the Betti numbers over ℤ/2 of the whole.
//!
//! Whether a face encloses a void depends on what is there before it alone. It does when it is the last face of some
//! cycle; all faces of a patch of the whole complex are in a cycle or none is, so it must be the last face of a patch
//! without boundary. Where no edge has three sides that is all. Else such patches are taken in the order of their last
//! faces, and one encloses a void when its boundary along the edges of degree 3 or more is a sum of those before it.
//!
//! *Source*: C. Delfinado, H. Edelsbrunner, *An incremental algorithm for Betti numbers of simplicial complexes on the
//! 3-sphere*, 1995; A. Bærentzen, *On the Topology of Polygonal Meshes*, 2025, Table 2, whose instigators the counts are.

use meshmend_core::{Cell, Column, Connectivity, EdgeClass, EdgeId, FaceId, VertexId, edge_class};
use petgraph::unionfind::UnionFind;
use serde::Serialize;

use crate::{Instigators, PatchId, Patches};

mod reduction;

use reduction::Reduction;

/// How many entries of columns [`incremental`] touches before it gives up.
///
/// Only foams come near it, in which nearly every face is a patch of its own: a block of 50 × 50 × 50 cells stays
/// within it.
pub const REDUCTION_BUDGET: u64 = 1 << 28;

/// What a cell does to the cycles when it is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// There is one more cycle of its dimension: a component, a loop or a void.
    Starts,
    /// There is one cycle less of the dimension below: a component is joined to another, or a loop is filled.
    Fills,
}

/// A cell that is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Step {
    /// The cell: a vertex, an edge or a face.
    pub cell: Cell,
    /// What it does; absent for a face where the reduction went over its budget.
    pub effect: Option<Effect>,
}

/// A complex that is put together cell by cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Incremental {
    steps: Vec<Step>,
}

impl Incremental {
    /// The cells in the order in which they are added.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// β₀, β₁ and β₂ after each step. From a step on of which the effect is not known, β₁ and β₂ are absent.
    ///
    /// *Cost*: constant a step.
    pub fn running_betti(&self) -> impl ExactSizeIterator<Item = [Option<u64>; 3]> + '_ {
        let mut numbers = [Some(0u64); 3];
        self.steps.iter().map(move |step| {
            let [own, below] = match step.cell {
                // There is nothing below that a vertex could fill; corners are not added.
                Cell::Vertex(_) | Cell::Corner(_) => [0, 0],
                Cell::Edge(_) => [1, 0],
                Cell::Face(_) => [2, 1],
            };
            match step.effect {
                Some(Effect::Starts) => numbers[own] = numbers[own].map(|number| number + 1),
                Some(Effect::Fills) => numbers[below] = numbers[below].map(|number| number - 1),
                None => (numbers[1], numbers[2]) = (None, None),
            }
            numbers
        })
    }

    /// How many cells of each kind start and fill something; those of the faces are absent where a face's is.
    ///
    /// *Cost*: linear in the steps.
    pub fn instigators(&self) -> Instigators {
        let count = |is_of_kind: fn(&Cell) -> bool, effect: Option<Effect>| {
            self.steps.iter().filter(|step| is_of_kind(&step.cell) && step.effect == effect).count() as u64
        };
        let [vertex, edge, face]: [fn(&Cell) -> bool; 3] = [
            |cell| matches!(cell, Cell::Vertex(_)),
            |cell| matches!(cell, Cell::Edge(_)),
            |cell| matches!(cell, Cell::Face(_)),
        ];
        let is_known = count(face, None) == 0;
        let [starts, fills] = [Effect::Starts, Effect::Fills].map(Some);
        Instigators {
            v_n: count(vertex, fills),
            v_c: count(vertex, starts),
            e_n: count(edge, fills),
            e_c: count(edge, starts),
            f_c: is_known.then(|| count(face, starts)),
            f_n: is_known.then(|| count(face, fills)),
        }
    }
}

/// What each cell of a complex does when they are added one after another, within [`REDUCTION_BUDGET`].
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, Connectivity, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{Effect, incremental, patches};
/// let tetrahedron = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, tetrahedron)?)?;
/// let kernel = EdgeUse::build(mesh.complex())?;
/// let built = incremental(&kernel, &patches(&kernel));
/// let effects: Vec<_> = built.steps().iter().filter_map(|step| step.effect).collect();
/// use Effect::{Fills, Starts};
/// // Three vertices, three edges, a face; a vertex, two edges, a face; an edge, a face; and the face that closes it.
/// assert_eq!(effects[..7], [Starts, Starts, Starts, Fills, Fills, Starts, Fills]);
/// assert_eq!(effects[7..], [Starts, Fills, Starts, Fills, Starts, Fills, Starts]);
/// assert_eq!(built.running_betti().last(), Some([Some(1), Some(0), Some(1)]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: near-linear, apart from the reduction of one column a patch without boundary where edges of degree 3 or more
/// are; 12 bytes a cell.
pub fn incremental<K: Connectivity>(kernel: &K, patches: &Patches) -> Incremental {
    incremental_within(kernel, patches, REDUCTION_BUDGET)
}

/// What each cell of a complex does when they are added one after another, within a budget of entries touched.
///
/// *Cost*: that of [`incremental`], at most `budget` entries touched.
pub fn incremental_within<K: Connectivity>(kernel: &K, patches: &Patches, budget: u64) -> Incremental {
    let faces = face_effects(kernel, patches, budget);
    let mut components = UnionFind::<u32>::new(kernel.vertex_count());
    let mut is_vertex_there = Column::<VertexId, bool>::filled(false, kernel.vertex_count());
    let mut is_edge_there = Column::<EdgeId, bool>::filled(false, kernel.edge_count());
    let mut steps = Vec::new();
    for face in kernel.faces().filter(|&face| kernel.is_proper_face(face)) {
        for vertex in kernel.face_vertices(face) {
            if !std::mem::replace(&mut is_vertex_there[vertex], true) {
                steps.push(Step { cell: Cell::Vertex(vertex), effect: Some(Effect::Starts) });
            }
        }
        for corner in kernel.face_corners(face) {
            let edge = kernel.corner_edge(corner);
            if !std::mem::replace(&mut is_edge_there[edge], true) {
                let [low, high] = kernel.edge_ends(edge);
                let effect = if components.union(low.0, high.0) { Effect::Fills } else { Effect::Starts };
                steps.push(Step { cell: Cell::Edge(edge), effect: Some(effect) });
            }
        }
        steps.push(Step { cell: Cell::Face(face), effect: faces[face] });
    }
    Incremental { steps }
}

/// What each face does, when the faces are added by ascending id.
fn face_effects<K: Connectivity>(
    kernel: &K,
    patches: &Patches,
    budget: u64,
) -> Column<FaceId, Option<Effect>> {
    let mut effects = Column::filled(Some(Effect::Fills), kernel.face_count());
    let (has_boundary, branches) = boundaries(kernel, patches);
    let mut closed: Vec<(FaceId, PatchId)> = patches
        .ids()
        .filter(|&patch| !has_boundary[patch])
        .filter_map(|patch| Some((patches.faces(patch).iter().copied().max()?, patch)))
        .collect();
    closed.sort_unstable();
    let mut columns = columns(kernel, patches, &branches);
    let mut reduction = Reduction::new(branches.len(), budget);
    let mut is_within_budget = true;
    for (last, patch) in closed {
        let column = std::mem::take(&mut columns[patch]);
        let depends = if is_within_budget { reduction.depends(column) } else { None };
        is_within_budget = depends.is_some();
        effects[last] = depends.map(|depends| if depends { Effect::Starts } else { Effect::Fills });
    }
    effects
}

/// Which patches have a boundary edge, and the edges of degree 3 or more, by their first use.
fn boundaries<K: Connectivity>(kernel: &K, patches: &Patches) -> (Column<PatchId, bool>, Vec<EdgeId>) {
    let mut has_boundary = Column::filled(false, patches.count());
    let mut branches = Vec::new();
    for edge in kernel.edges() {
        match edge_class(kernel, edge) {
            EdgeClass::Boundary => {
                let patch = kernel.edge_faces(edge).find_map(|face| patches.of_face(face));
                patch.into_iter().for_each(|patch| has_boundary[patch] = true);
            }
            EdgeClass::Interior => {}
            EdgeClass::NonManifold => branches.push(edge),
        }
    }
    branches.sort_by_cached_key(|&edge| kernel.edge_corners(edge).next());
    (has_boundary, branches)
}

/// For each patch the places among the branches that have an odd number of its sides, ascending.
fn columns<K: Connectivity>(kernel: &K, patches: &Patches, branches: &[EdgeId]) -> Column<PatchId, Vec<u32>> {
    let mut columns: Column<PatchId, Vec<u32>> = Column::filled(Vec::new(), patches.count());
    for (row, &edge) in (0u32..).zip(branches) {
        for patch in kernel.edge_faces(edge).filter_map(|face| patches.of_face(face)) {
            let column = &mut columns[patch];
            // A second side of the same patch undoes the first.
            if column.last() == Some(&row) { column.truncate(column.len() - 1) } else { column.push(row) }
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use meshmend_core::Id;

    use super::*;
    use crate::shapes::{self, Random, Shape, dense_rank};
    use crate::{betti, components, patches};

    fn built<K: Connectivity>(kernel: &K) -> Incremental {
        incremental(kernel, &patches(kernel))
    }

    /// The running numbers from the ranks of the boundary matrices of what is there after each step.
    fn by_matrices<K: Connectivity>(kernel: &K, steps: &[Step]) -> Vec<[Option<u64>; 3]> {
        let (mut vertices, mut d1, mut d2) = (0usize, Vec::<Vec<i64>>::new(), Vec::<Vec<i64>>::new());
        let numbers = steps.iter().map(|step| {
            match step.cell {
                Cell::Vertex(_) => vertices += 1,
                Cell::Edge(edge) => {
                    let mut row = vec![0; kernel.vertex_count()];
                    kernel.edge_ends(edge).iter().for_each(|end| row[end.index()] = 1);
                    d1.push(row);
                }
                Cell::Face(face) => {
                    let mut row = vec![0; kernel.edge_count()];
                    kernel.face_corners(face).for_each(|c| row[kernel.corner_edge(c).index()] += 1);
                    d2.push(row);
                }
                Cell::Corner(corner) => panic!("{corner} is added"),
            }
            let (r1, r2) = (dense_rank(&d1, 2), dense_rank(&d2, 2));
            [vertices - r1, d1.len() - r1 - r2, d2.len() - r2].map(|number| Some(number as u64))
        });
        numbers.collect()
    }

    #[track_caller]
    fn assert_exact(shape: &Shape) {
        let kernel = shape.kernel();
        let built = built(&kernel);
        assert_eq!(
            built.running_betti().collect::<Vec<_>>(),
            by_matrices(&kernel, built.steps()),
            "{shape:?}"
        );
    }

    #[test]
    fn each_step_is_exact() {
        let known = [
            shapes::tetrahedron(),
            shapes::torus(3, 3),
            shapes::klein_bottle(3, 3),
            shapes::projective_plane(),
            shapes::three_hemispheres(),
            shapes::sphere_with_membrane(),
            shapes::tetrahedra_on_an_edge(),
            shapes::pinched_torus(),
            shapes::disc_with_rim(&[0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2]),
            Shape::of(&[&[0, 1, 2, 0, 1, 2, 0, 2, 1]]),
            Shape::of(&[]),
        ];
        known.iter().for_each(assert_exact);
        let mut random = Random(71);
        for round in 0..600 {
            assert_exact(&Shape(random.soup(4 + round % 4, 14, 6)));
        }
    }

    #[test]
    fn small_worlds_in_any_order_are_exact() {
        let triples = |top: u32| (0..top).flat_map(move |a| (a + 1..top).map(move |b| vec![a, b, top]));
        let all: Vec<Vec<u32>> = (2..5).flat_map(triples).collect();
        let mut random = Random(72);
        for set in 0u32..1 << all.len() {
            let chosen: Vec<&Vec<u32>> =
                all.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1).map(|(_, face)| face).collect();
            let order = random.permutation(chosen.len());
            assert_exact(&Shape(order.iter().map(|&face| random.turned(chosen[face as usize])).collect()));
        }
    }

    #[test]
    fn elements_come_when_they_are_first_used() {
        let built = built(&Shape::of(&[&[5, 5], &[2, 1, 0], &[1, 3, 0]]).kernel());
        let names: Vec<String> = built.steps().iter().map(|step| format!("{:?}", step.cell)).collect();
        let expected = "Vertex(v2) Vertex(v1) Vertex(v0) Edge(e3) Edge(e0) Edge(e1) Face(f1) \
                        Vertex(v3) Edge(e4) Edge(e2) Face(f2)";
        assert_eq!(names.join(" "), expected);
    }

    #[test]
    fn it_ends_at_the_figures_of_the_whole() {
        let mut random = Random(73);
        for round in 0..500 {
            let shape = Shape(random.soup(4 + round % 9, 24, 8));
            let kernel = shape.kernel();
            let whole = betti(&kernel, &components(&kernel), &patches(&kernel)).z2.unwrap();
            let built = built(&kernel);
            assert_eq!(built.running_betti().last().unwrap_or([Some(0); 3]), whole.map(Some));
            assert_eq!(built.instigators(), shape.report().instigators);
        }
    }

    #[test]
    fn over_the_budget_it_says_where() {
        let kernel = shapes::three_hemispheres().kernel();
        let built = incremental_within(&kernel, &patches(&kernel), 5);
        let unknown: Vec<Cell> =
            built.steps().iter().filter(|step| step.effect.is_none()).map(|step| step.cell).collect();
        assert_eq!(unknown, [Cell::Face(FaceId(5)), Cell::Face(FaceId(8))]);
        assert_eq!((built.instigators().f_c, built.instigators().e_c), (None, 7));
        let numbers: Vec<_> = built.running_betti().collect();
        assert_eq!(numbers.last(), Some(&[Some(1), None, None]));
        assert!(numbers.iter().take_while(|numbers| numbers[2].is_some()).count() > 10);
    }
}
