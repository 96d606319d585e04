//! Along which edges does each surface open into a disc?
//!
//! A tree of the faces alone leaves edges that it does not cross, the boundary among them. What ends blindly there
//! can be taken away again and again, and what is left is the *cut graph*: cut along it, the surface is a disc. The
//! tree crosses edges outside the tree of the vertices first, so that the graph is made of shortest paths where it
//! can be.
//!
//! Of a closed sphere nothing would be left. Its cut graph is a path of two edges: the lowest two at its lowest
//! vertex that has two. Every closed sphere has such a vertex, as every face has three different vertices; one edge
//! would not do, as its two sides would still join the same two vertices.

use meshmend_core::{Cancelled, Column, Connectivity, Defect, EdgeId, VertexId};

use super::STEP;
use super::error::GeneratorError;
use super::options::GeneratorOptions;
use super::surfaces::Surfaces;
use super::trees::{Ground, Trees};
use crate::{ComponentFacts, ComponentId, Surface};

/// The edges along which all surfaces of a mesh open into discs.
#[derive(Clone, Debug, PartialEq)]
pub struct CutGraph {
    /// Those edges, those of the boundary among them, ascending.
    pub edges: Vec<EdgeId>,
    /// Which surface each component is, if it is one.
    pub surfaces: Column<ComponentId, Option<Surface>>,
    /// For each component that is not a surface, the first edge, or else the first vertex, that no surface has. Such
    /// a component has no cut graph.
    pub obstacles: Vec<(ComponentId, Defect)>,
}

/// The cut graphs of all components that are surfaces.
///
/// ```
/// # use meshmend_core::{Build, Connectivity, EdgeId, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{GeneratorOptions, cut_graph};
/// // A tetrahedron opens along two edges.
/// let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
/// let found = cut_graph(&EdgeUse::build(mesh.complex())?, &GeneratorOptions::default())?;
/// assert_eq!(found.edges, [EdgeId(0), EdgeId(1)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When no face has the root, or there are more or fewer lengths than edges; or if the watch of the options stops it.
///
/// *Cost*: that of [`generators`](crate::generators()).
pub fn cut_graph<K: Connectivity>(
    kernel: &K,
    options: &GeneratorOptions<'_>,
) -> Result<CutGraph, GeneratorError> {
    let surfaces = Surfaces::of(kernel, options.watch())?;
    let ground = Ground::new(kernel, &surfaces, options)?;
    let trees = ground.trees(options.roots)?;
    let mut edges = uncrossed(&ground, &trees)?;
    ground.watch.look(STEP, 0, 0)?;
    prune(kernel, &mut edges);
    edges.extend(sphere_paths(kernel, &surfaces));
    edges.sort_unstable();
    let of = |component| Some((component, surfaces.obstacles[component].clone()?));
    let obstacles = surfaces.components.ids().filter_map(of).collect();
    let surfaces = surfaces.facts.values().iter().map(ComponentFacts::surface).collect();
    Ok(CutGraph { edges, surfaces, obstacles })
}

/// The edges of surfaces that a tree of the faces does not cross.
fn uncrossed<K: Connectivity>(ground: &Ground<'_, K>, trees: &Trees) -> Result<Vec<EdgeId>, Cancelled> {
    let in_trees = trees.forest.order.iter().filter_map(|&vertex| trees.forest.entry(vertex));
    let is_crossed = ground.dual.crossed(trees.order.iter().copied().chain(in_trees), ground.watch)?;
    let of_surface = |edge: &EdgeId| ground.surfaces.of_edge(ground.kernel, *edge).is_some();
    Ok(ground.kernel.edges().filter(|&edge| !is_crossed[edge]).filter(of_surface).collect())
}

/// Takes away edges that end blindly, until there is none.
fn prune<K: Connectivity>(kernel: &K, edges: &mut Vec<EdgeId>) {
    // Of all edges at a vertex that are there: how many, and the exclusive or of their numbers, which is the last
    // one's when there is one.
    let mut at_vertex: Column<VertexId, (u32, u32)> = Column::filled((0, 0), kernel.vertex_count());
    for edge in edges.iter() {
        for end in kernel.edge_ends(*edge) {
            let (count, sum) = at_vertex[end];
            at_vertex[end] = (count + 1, sum ^ edge.0);
        }
    }
    let mut is_gone = Column::filled(false, kernel.edge_count());
    for start in kernel.vertices() {
        let mut vertex = start;
        while let (1, last) = at_vertex[vertex] {
            let [low, high] = kernel.edge_ends(EdgeId(last));
            is_gone[EdgeId(last)] = true;
            at_vertex[vertex] = (0, 0);
            vertex = if low == vertex { high } else { low };
            let (count, sum) = at_vertex[vertex];
            at_vertex[vertex] = (count - 1, sum ^ last);
        }
    }
    edges.retain(|&edge| !is_gone[edge]);
}

/// Two edges of each closed sphere.
fn sphere_paths<K: Connectivity>(kernel: &K, surfaces: &Surfaces) -> Vec<EdgeId> {
    let mut is_open = Column::filled(false, surfaces.components.count());
    for (component, facts) in surfaces.facts.iter() {
        is_open[component] = facts.surface() == Some(Surface::Orientable { genus: 0, holes: 0 });
    }
    let mut found = Vec::new();
    for vertex in kernel.vertices() {
        let Some(component) = surfaces.of_vertex(vertex).filter(|&component| is_open[component]) else {
            continue;
        };
        let sides = kernel.vertex_corners(vertex).flat_map(|corner| [corner, kernel.prev_corner(corner)]);
        let mut edges: Vec<EdgeId> = sides.map(|side| kernel.corner_edge(side)).collect();
        edges.sort_unstable();
        edges.dedup();
        if let [first, second, ..] = edges[..] {
            found.extend([first, second]);
            is_open[component] = false;
        }
    }
    found
}
