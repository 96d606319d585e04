//! The generators of all components, and the paths that they are.

use meshmend_core::{Column, Connectivity, EdgeId, KernelTask, VertexId};

use super::collect;
use super::error::GeneratorError;
use super::forest::Forest;
use super::generator::{ComponentGenerators, Generator, Path};
use super::options::GeneratorOptions;
use super::surfaces::Surfaces;
use super::trees::Ground;
use crate::BoundaryLoops;

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
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
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
/// When no face has the root, or there are more or fewer lengths than edges; or when the count is not β₁, which is a
/// mistake of this program; or if the watch of the options stops it.
///
/// *Cost*: O(n log n), times the number of roots that are tried; about 60 bytes a vertex beside what the questions
/// about components and patches take. Paths are not stored: together they can be as long as n².
pub fn generators<K: Connectivity>(
    kernel: &K,
    options: &GeneratorOptions<'_>,
) -> Result<Generators, GeneratorError> {
    kernel.ask_of_all_vertices(Ask(options))
}

/// The generators, through whichever kernel.
struct Ask<'a>(&'a GeneratorOptions<'a>);

impl KernelTask for Ask<'_> {
    type Output = Result<Generators, GeneratorError>;
    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        generators_of(kernel, self.0)
    }
}

fn generators_of<K: Connectivity>(
    kernel: &K,
    options: &GeneratorOptions<'_>,
) -> Result<Generators, GeneratorError> {
    let surfaces = Surfaces::of(kernel, options.watch())?;
    let ground = Ground::new(kernel, &surfaces, options)?;
    let trees = ground.trees(options.roots)?;
    let [co_tree, left_over] = ground.dual.split(&trees.order, ground.watch)?;
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
