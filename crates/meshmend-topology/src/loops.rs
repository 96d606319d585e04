//! Along which closed paths can a surface not be shrunk, and along which edges does it open into a disc?
//!
//! For each component that is a surface:
//!
//! 1. a tree of shortest paths from a root to every vertex (`forest`);
//! 2. a tree across the other edges to every face, boundary loops counting as faces (`co_tree`);
//! 3. what is left over are 2g edges, or μ: each with its two ways to the root, from where they meet, is a closed path.
//!    Together with all boundary loops but the one with the lowest vertex these are the [`Generators`]: as many as β₁
//!    over ℤ/2, and independent, since the way that an edge closes across the tree of the faces crosses its own path
//!    once and no other.
//!
//! The [`cut_graph`] are the edges that a tree of the faces alone does not cross, less what ends blindly.
//!
//! Only ids decide, so every kernel gives the same answer. A component that is no surface gets none, and the reason.
//!
//! *Source*: D. Eppstein, *Dynamic generators of topologically embedded graphs*, 2003; J. Erickson, K. Whittlesey,
//! *Greedy optimal homotopy and homology generators*, 2005.

use meshmend_core::{Column, Connectivity, Defect, EdgeId, VertexId};
use serde::Serialize;
use thiserror::Error;

mod ancestors;
mod co_tree;
mod collect;
mod cut_graph;
mod forest;
mod roots;
mod surfaces;
mod transport;
mod trees;
mod weights;

pub use co_tree::CoTree;
pub use cut_graph::{CutGraph, cut_graph};
pub use roots::Roots;
pub use weights::Measure;

use forest::Forest;
use surfaces::Surfaces;
use trees::Ground;

use crate::{BoundaryLoops, ComponentId, Surface};

/// How generators and cut graphs are chosen; by default with as few edges as a tree from the lowest vertex gives.
#[derive(Clone, Copy, Debug, Default)]
pub struct GeneratorOptions<'a> {
    /// The length of each edge; without, and in components where they can't be added up, edges are counted.
    pub lengths: Option<&'a Column<EdgeId, f64>>,
    /// Which edges the tree of the faces takes first.
    pub co_tree: CoTree,
    /// Where the trees of the vertices begin.
    pub roots: Roots,
}

/// Why there are no generators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum GeneratorError {
    /// The root that was asked for is in no face.
    #[error("{0} is in no face, so no path begins there")]
    NoSuchRoot(VertexId),
    /// There is not one length for each edge.
    #[error("there are {found} lengths for {expected} edges")]
    Lengths {
        /// How many lengths there are.
        found: usize,
        /// How many are needed.
        expected: usize,
    },
    /// The number of generators is not β₁: a mistake of this program.
    #[error("{component} has {found} generators in place of {expected}, which is a mistake of this program")]
    Count {
        /// The component.
        component: ComponentId,
        /// How many generators were found.
        found: usize,
        /// Its Betti number β₁ over ℤ/2.
        expected: i64,
    },
}

/// What a generator goes round.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum GeneratorKind {
    /// A handle of an orientable surface: along it or round it.
    Handle,
    /// The cross-caps of a non-orientable surface.
    CrossCap,
    /// A hole.
    Boundary,
}

/// One of the closed paths that generate the first homology of a surface over ℤ/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Generator {
    /// What it goes round.
    pub kind: GeneratorKind,
    /// How long it is, in the measure of its component.
    pub length: f64,
    /// How many vertices it has, all different.
    pub vertex_count: usize,
    /// Whether it has two sides, that is, an annular neighbourhood and no Möbius band.
    pub is_two_sided: bool,
    path: Path,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// A left-over edge, and the vertex at which its two ways to the root meet.
    Closed { edge: EdgeId, ends: [VertexId; 2], apex: VertexId },
    /// A boundary loop, by its place.
    Boundary(usize),
}

/// The generators of a component, or why there are none.
#[derive(Clone, Debug, PartialEq)]
pub struct ComponentGenerators {
    /// The component.
    pub component: ComponentId,
    /// Where the generators begin and what they are; nothing for a component that is no surface.
    pub system: Option<LoopSystem>,
    /// For a component that is no surface, the first edge, or else the first vertex, that no surface has.
    pub obstacle: Option<Defect>,
    /// Its generators: by left-over edge, and then boundary loops by lowest vertex.
    pub generators: Vec<Generator>,
}

/// From where the loops of a surface were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopSystem {
    /// Which surface the component is.
    pub surface: Surface,
    /// The vertex at which the shortest paths begin.
    pub root: VertexId,
    /// In what lengths are measured.
    pub measure: Measure,
    /// How long all loops but the boundary's are together, each taken from the root and back to it.
    pub length: f64,
}

/// The generators of all components.
#[derive(Clone, Debug)]
pub struct Generators {
    components: Vec<ComponentGenerators>,
    forest: Forest,
    co_tree: Vec<EdgeId>,
    boundary: BoundaryLoops,
}

/// The generators of the first homology of each component over ℤ/2.
///
/// ```
/// # use meshmend_core::{Connectivity, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{GeneratorKind, GeneratorOptions, generators};
/// // The torus with seven vertices.
/// let corners = (0..7).flat_map(|i| [i, (i + 1) % 7, (i + 3) % 7, i, (i + 3) % 7, (i + 2) % 7]);
/// let faces = FaceTable::triangles(7, corners.map(VertexId).collect())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 7], faces)?;
/// let found = generators(&EdgeUse::build(mesh.complex())?, &GeneratorOptions::default())?;
/// let [torus] = found.components() else { return Ok(()) };
/// assert_eq!(torus.generators.len(), 2);
/// assert_eq!(torus.generators[0].kind, GeneratorKind::Handle);
/// assert_eq!(found.vertices(&torus.generators[0]).len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the root is in no face, or there is not one length for each edge; or when the count is not β₁, which is a
/// mistake of this program.
///
/// *Cost*: O(n log n), times the number of roots that are tried; about 60 bytes a vertex beside what the questions
/// about components and patches take. Paths are not stored: together they can be as long as n².
pub fn generators<K: Connectivity>(
    kernel: &K,
    options: &GeneratorOptions<'_>,
) -> Result<Generators, GeneratorError> {
    let surfaces = Surfaces::of(kernel);
    let ground = Ground::new(kernel, &surfaces, options)?;
    let trees = ground.trees(options.roots)?;
    let [co_tree, left_over] = ground.dual.split(&trees.order);
    let components = collect::components(&ground, &trees, &left_over)?;
    Ok(Generators { components, forest: trees.forest, co_tree, boundary: surfaces.boundary })
}

impl Generators {
    /// Every component, ascending.
    pub fn components(&self) -> &[ComponentGenerators] {
        &self.components
    }

    /// The vertices of a generator of these, all different, each joined to the next and the last to the first.
    ///
    /// A handle's or cross-cap's begins where its ways to the root meet, and goes first to the lower end of its
    /// left-over edge; a boundary loop is as [`boundary_loops`](crate::boundary_loops()) gives it.
    ///
    /// *Cost*: linear in the path.
    pub fn vertices(&self, generator: &Generator) -> Vec<VertexId> {
        match generator.path {
            Path::Boundary(place) => self.boundary.vertices(place).to_vec(),
            Path::Closed { ends: [low, high], apex, .. } => {
                let mut vertices: Vec<VertexId> = self.forest.path_up(low, apex).collect();
                vertices.push(apex);
                vertices.reverse();
                vertices.extend(self.forest.path_up(high, apex));
                vertices
            }
        }
    }

    /// The edges of the trees of shortest paths, ascending.
    pub fn tree_edges(&self) -> Vec<EdgeId> {
        let mut edges: Vec<EdgeId> =
            self.forest.order.iter().filter_map(|&vertex| self.forest.entry(vertex)).collect();
        edges.sort_unstable();
        edges
    }

    /// The edges that the trees of the faces and boundary loops cross, ascending.
    pub fn co_tree_edges(&self) -> &[EdgeId] {
        &self.co_tree
    }

    /// Every edge on a handle's or cross-cap's path, ascending.
    ///
    /// *Cost*: linear in the mesh, however long the paths are together.
    pub fn loop_edges(&self) -> Vec<EdgeId> {
        let mut edges = Vec::new();
        // How many paths pass from below each vertex to it, less how many turn round at it.
        let mut passing = Column::filled(0i64, self.forest.ancestors.vertex_count());
        for generator in self.components.iter().flat_map(|component| &component.generators) {
            if let Path::Closed { edge, ends, apex } = generator.path {
                edges.push(edge);
                ends.into_iter().for_each(|end| passing[end] += 1);
                passing[apex] -= 2;
            }
        }
        for &vertex in self.forest.order.iter().rev() {
            if let Some(edge) = self.forest.entry(vertex).filter(|_| passing[vertex] > 0) {
                edges.push(edge);
                let above = self.forest.ancestors.parent(vertex);
                passing[above] += passing[vertex];
            }
        }
        edges.sort_unstable();
        edges
    }
}
