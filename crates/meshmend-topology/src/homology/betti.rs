//! How many pieces, tunnels and voids does the complex have?
//!
//! The *Betti numbers* β₀, β₁, β₂ over a field are the dimensions of homology; exact for any complex, manifold or
//! not. β₀ is the number of components. A 2-cycle gives all faces of a patch the same coefficient, up to the sides
//! that orient the patch, so β₂ is the nullity of a small system: one unknown a patch, 0 for a patch with a
//! boundary edge (over ℚ also for one that is not orientable), and one equation for each edge of degree 3 or
//! more, in which a patch counts once for each of its uses there. Then β₁ = β₀ + β₂ − χ.
//!
//! Over ℤ/2 and ℚ the numbers can differ: a Klein bottle has (1, 2, 1) and (1, 1, 0). For ℚ the rank is taken
//! modulo 2³¹ − 1.
//!
//! *Source*: A. Bærentzen, *On the Topology of Polygonal Meshes*, 2025, §4 and Table 2; C. Delfinado,
//! H. Edelsbrunner, *An incremental algorithm for Betti numbers of simplicial complexes on the 3-sphere*, 1995.

use meshmend_core::{Column, Connectivity, CornerId, EdgeClass, EdgeId, edge_class};
use serde::Serialize;

use super::elimination::{PrimeField, SparseRows};
use crate::{Components, PatchId, Patches, Side};

/// How many matrix entries [`betti`] touches for each field before it gives up.
///
/// Only foams come near it, in which nearly every face is a patch of its own: a block of 50 × 50 × 50 cells takes
/// half of it.
pub const ELIMINATION_BUDGET: u64 = 1 << 25;

/// The Betti numbers β₀, β₁, β₂ over two fields, each absent where elimination went over its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Betti {
    /// Over the integers modulo 2.
    pub z2: Option<[u64; 3]>,
    /// Over the rationals.
    pub q: Option<[u64; 3]>,
}

/// How many elements, added one after another, negate and create topological features (Bærentzen, Table 2).
///
/// A face figure is absent where β₂ over ℤ/2 is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Instigators {
    /// Vertices that negate anything: always 0.
    pub v_n: u64,
    /// Vertices that create a component: all.
    pub v_c: u64,
    /// Edges that join two components.
    pub e_n: u64,
    /// Edges that create a loop.
    pub e_c: u64,
    /// Faces that create a void.
    pub f_c: Option<u64>,
    /// Faces that fill a loop.
    pub f_n: Option<u64>,
}

/// The Betti numbers of a complex, within [`ELIMINATION_BUDGET`].
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{betti, components, patches};
/// // Two spheres that share a triangle enclose two voids.
/// let faces = [0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 1, 4, 1, 2, 4, 2, 0, 4].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 5], FaceTable::triangles(5, faces)?)?;
/// let kernel = EdgeUse::build(mesh.complex())?;
/// let found = betti(&kernel, &components(&kernel), &patches(&kernel));
/// assert_eq!((found.z2, found.q), (Some([1, 0, 2]), Some([1, 0, 2])));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: linear, apart from elimination on one unknown a patch where edges of degree 3 or more are.
pub fn betti<K: Connectivity>(kernel: &K, components: &Components, patches: &Patches) -> Betti {
    betti_within(kernel, components, patches, ELIMINATION_BUDGET)
}

/// The Betti numbers of a complex, within a budget of matrix entries touched for each field.
///
/// *Cost*: that of [`betti`], at most `budget` entries touched.
pub fn betti_within<K: Connectivity>(
    kernel: &K,
    components: &Components,
    patches: &Patches,
    budget: u64,
) -> Betti {
    let faces: usize = patches.ids().map(|patch| patches.faces(patch).len()).sum();
    let elements = [components.referenced_vertices(), kernel.edge_count(), faces].map(|count| count as u64);
    betti_of(elements, components.count() as u64, &KernelCycles::of(kernel, patches), budget)
}

/// The Betti numbers of a complex with these numbers of vertices, edges and faces, and of components.
///
/// *Cost*: that of elimination on one unknown a patch; at most `budget` entries touched for each field.
pub fn betti_of(elements: [u64; 3], components: u64, cycles: &impl TwoCycles, budget: u64) -> Betti {
    let [vertices, edges, faces] = elements;
    // β₁ = β₀ + β₂ − χ, in an order that stays above 0: E ≥ V − β₀ and E − V + β₀ ≥ F − β₂.
    let from_nullity = |b2: u64| [components, (edges + components + b2) - vertices - faces, b2];
    let is_closed = |patch: PatchEnds| !patch.has_boundary;
    let is_two_sided = |patch: PatchEnds| is_closed(patch) && patch.is_orientable;
    let sign = |is_forward| if is_forward { 1 } else { -1 };
    let [free_z2, free_q] = cycles.free();
    let z2 = nullity(cycles, PrimeField::TWO, is_closed, |_| 1, budget);
    let q = nullity(cycles, PrimeField::LARGE, is_two_sided, sign, budget);
    Betti {
        z2: z2.map(|nullity| from_nullity(nullity + free_z2)),
        q: q.map(|nullity| from_nullity(nullity + free_q)),
    }
}

/// What a 2-cycle has to satisfy, still without a field.
pub trait TwoCycles {
    /// The patches, by number.
    fn patches(&self) -> impl Iterator<Item = PatchEnds>;

    /// How many unknowns there are beside these patches, over ℤ/2 and over ℚ: closed patches that no edge of degree 3 or more ends.
    fn free(&self) -> [u64; 2] {
        [0, 0]
    }

    /// Hands over the uses of each edge of degree 3 or more, by ascending edge.
    fn each_branch(&self, visit: impl FnMut(&[PatchUse]));
}

/// How a patch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatchEnds {
    /// Whether it has an edge of degree 1.
    pub has_boundary: bool,
    /// Whether its faces can be flipped so that none of its edges is inconsistent.
    pub is_orientable: bool,
}

/// A use of an edge by a face of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatchUse {
    /// The patch.
    pub patch: PatchId,
    /// Whether it runs from the lower to the higher vertex when all faces of the patch lie as its lowest one.
    pub is_forward: bool,
}

/// The dimension of the 2-cycles over a field, where a patch is an unknown if it may be one; nothing beyond the budget.
fn nullity(
    cycles: &impl TwoCycles,
    field: PrimeField,
    may_be_unknown: impl Fn(PatchEnds) -> bool,
    coefficient: impl Fn(bool) -> i64,
    budget: u64,
) -> Option<u64> {
    let mut unknown_count = 0;
    let number = |patch| {
        let is_unknown = may_be_unknown(patch);
        unknown_count += u32::from(is_unknown);
        is_unknown.then(|| unknown_count - 1)
    };
    let unknowns: Column<PatchId, Option<u32>> = cycles.patches().map(number).collect();
    let (mut rows, mut terms) = (SparseRows::new(field), Vec::new());
    cycles.each_branch(|uses| {
        terms.clear();
        terms.extend(
            uses.iter().filter_map(|use_| Some((unknowns[use_.patch]?, coefficient(use_.is_forward)))),
        );
        rows.push(&mut terms);
    });
    Some(u64::from(unknown_count) - rows.rank(unknown_count as usize, budget)? as u64)
}

/// The instigator counts of a complex with these numbers of elements and of components, and β₂ over ℤ/2.
pub fn instigators(elements: [u64; 3], components: u64, b2: Option<u64>) -> Instigators {
    let [vertices, edges, faces] = elements;
    Instigators {
        v_n: 0,
        v_c: vertices,
        e_n: vertices - components,
        e_c: edges + components - vertices,
        f_c: b2,
        f_n: b2.map(|b2| faces - b2),
    }
}

/// The system of a complex in memory.
struct KernelCycles<'a, K> {
    kernel: &'a K,
    patches: &'a Patches,
    has_boundary: Column<PatchId, bool>,
    /// The edges of degree 3 or more.
    branches: Vec<EdgeId>,
}

impl<'a, K: Connectivity> KernelCycles<'a, K> {
    fn of(kernel: &'a K, patches: &'a Patches) -> Self {
        let mut has_boundary = Column::filled(false, patches.count());
        let mut branches = Vec::new();
        for edge in kernel.edges() {
            match edge_class(kernel, edge) {
                EdgeClass::Boundary => kernel
                    .edge_faces(edge)
                    .filter_map(|face| patches.of_face(face))
                    .for_each(|patch| has_boundary[patch] = true),
                EdgeClass::Interior => {}
                EdgeClass::NonManifold => branches.push(edge),
            }
        }
        KernelCycles { kernel, patches, has_boundary, branches }
    }

    fn use_of(&self, corner: CornerId) -> Option<PatchUse> {
        let face = self.kernel.corner_face(corner);
        let is_same = self.patches.side(face) == Side::Same;
        let is_forward = is_same == self.kernel.is_forward(corner);
        Some(PatchUse { patch: self.patches.of_face(face)?, is_forward })
    }
}

impl<K: Connectivity> TwoCycles for KernelCycles<'_, K> {
    fn patches(&self) -> impl Iterator<Item = PatchEnds> {
        self.patches.ids().map(|patch| PatchEnds {
            has_boundary: self.has_boundary[patch],
            is_orientable: self.patches.is_orientable(patch),
        })
    }

    fn each_branch(&self, mut visit: impl FnMut(&[PatchUse])) {
        let mut uses = Vec::new();
        for &edge in &self.branches {
            uses.clear();
            uses.extend(self.kernel.edge_corners(edge).filter_map(|corner| self.use_of(corner)));
            visit(&uses);
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::Id;

    use super::*;
    use crate::shapes::{self, Random, Shape, dense_rank, kernel};
    use crate::{components, patches};

    fn both<K: Connectivity>(kernel: &K) -> [Option<[u64; 3]>; 2] {
        let found = betti(kernel, &components(kernel), &patches(kernel));
        [found.z2, found.q]
    }

    #[track_caller]
    fn assert_betti(shape: &Shape, z2: [u64; 3], q: [u64; 3]) {
        assert_eq!(both(&shape.kernel()), [Some(z2), Some(q)]);
    }

    #[test]
    fn surfaces_with_known_numbers() {
        assert_betti(&shapes::tetrahedron(), [1, 0, 1], [1, 0, 1]);
        assert_betti(&shapes::torus(3, 4), [1, 2, 1], [1, 2, 1]);
        assert_betti(&shapes::klein_bottle(4, 5), [1, 2, 1], [1, 1, 0]);
        assert_betti(&shapes::projective_plane(), [1, 1, 1], [1, 0, 0]);
        assert_betti(&shapes::moebius_band(6), [1, 1, 0], [1, 1, 0]);
        assert_betti(&Shape::of(&[]), [0, 0, 0], [0, 0, 0]);
    }

    #[test]
    fn complexes_that_are_no_surface() {
        assert_betti(&Shape::of(&[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]), [1, 0, 0], [1, 0, 0]);
        assert_betti(&shapes::three_hemispheres(), [1, 0, 2], [1, 0, 2]);
        assert_betti(&shapes::sphere_with_membrane(), [1, 0, 2], [1, 0, 2]);
        assert_betti(&shapes::tetrahedra_on_a_vertex(), [1, 0, 2], [1, 0, 2]);
        assert_betti(&shapes::tetrahedra_on_an_edge(), [1, 0, 2], [1, 0, 2]);
        assert_betti(&shapes::bow_tie(), [1, 0, 0], [1, 0, 0]);
        assert_betti(&shapes::pinched_torus(), [1, 1, 1], [1, 1, 1]);
        // The dunce hat, as one face that spells its rim, and cut into triangles.
        assert_betti(&Shape::of(&[&[0, 1, 2, 0, 1, 2, 0, 2, 1]]), [1, 0, 0], [1, 0, 0]);
        assert_betti(&shapes::disc_with_rim(&[0, 1, 2, 0, 1, 2, 0, 2, 1]), [1, 0, 0], [1, 0, 0]);
        // A disc whose rim goes three times round a circle: torsion of order three, seen by neither field.
        assert_betti(&shapes::disc_with_rim(&[0, 1, 2, 0, 1, 2, 0, 1, 2]), [1, 0, 0], [1, 0, 0]);
        // Four times round: over ℤ/2 that is no boundary condition at all.
        assert_betti(&shapes::disc_with_rim(&[0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2]), [1, 1, 1], [1, 0, 0]);
    }

    #[test]
    fn the_rank_of_the_boundary_matrices_says_the_same() {
        let mut random = Random(5);
        let triangles: Vec<[u32; 3]> = (0..5u32)
            .flat_map(|a| (a + 1..5).flat_map(move |b| (b + 1..5).map(move |c| [a, b, c])))
            .collect();
        for set in 0u32..1 << triangles.len() {
            let chosen = triangles.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
            let faces: Vec<Vec<u32>> = chosen.map(|(_, face)| random.turned(face)).collect();
            assert_by_matrices(&faces);
        }
        for round in 0..2000 {
            assert_by_matrices(&random.soup(4 + round % 4, 14, 6));
        }
    }

    #[track_caller]
    fn assert_by_matrices(soup: &[Vec<u32>]) {
        let faces: Vec<&[u32]> = soup.iter().map(Vec::as_slice).collect();
        let kernel = kernel(9, &faces);
        let expected = [2, (1 << 31) - 1].map(|prime| Some(by_matrices(&kernel, prime)));
        assert_eq!(both(&kernel), expected, "{soup:?}");
    }

    fn by_matrices<K: Connectivity>(kernel: &K, prime: i64) -> [u64; 3] {
        let d1: Vec<Vec<i64>> = kernel
            .edges()
            .map(|e| {
                let mut row = vec![0; kernel.vertex_count()];
                let [low, high] = kernel.edge_ends(e);
                (row[low.index()], row[high.index()]) = (-1, 1);
                row
            })
            .collect();
        let d2: Vec<Vec<i64>> = kernel
            .faces()
            .filter(|&f| kernel.is_proper_face(f))
            .map(|f| {
                let mut row = vec![0; kernel.edge_count()];
                for c in kernel.face_corners(f) {
                    row[kernel.corner_edge(c).index()] += if kernel.is_forward(c) { 1 } else { -1 };
                }
                row
            })
            .collect();
        let vertices = kernel.vertices().filter(|&v| kernel.is_referenced(v)).count();
        let (r1, r2) = (dense_rank(&d1, prime), dense_rank(&d2, prime));
        [vertices - r1, d1.len() - r1 - r2, d2.len() - r2].map(|b| b as u64)
    }

    #[test]
    fn over_the_budget_there_is_no_number() {
        let kernel = shapes::three_hemispheres().kernel();
        let found = betti_within(&kernel, &components(&kernel), &patches(&kernel), 2);
        assert_eq!(found, Betti { z2: None, q: None });
    }

    #[test]
    fn table_2_of_the_paper() {
        let table = [
            (Shape::of(&[&[0, 1, 2, 3, 4, 5]]), [0, 6, 5, 1], Some([0, 1])),
            (shapes::annulus(6), [0, 12, 11, 7], Some([0, 6])),
            (shapes::tetrahedron(), [0, 4, 3, 3], Some([1, 3])),
            (shapes::torus(3, 3), [0, 9, 8, 10], Some([1, 8])),
        ];
        for (shape, [v_n, v_c, e_n, e_c], faces) in table {
            let report = shape.report();
            let [f_c, f_n] = [0, 1].map(|i| faces.map(|f| f[i]));
            assert_eq!(report.instigators, Instigators { v_n, v_c, e_n, e_c, f_c, f_n });
        }
    }
}
