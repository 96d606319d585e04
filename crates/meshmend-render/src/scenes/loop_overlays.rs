//! The overlays that show how a mesh hangs together: generators, trees and seams.

use std::num::NonZeroU32;

use meshmend_core::{Column, Connectivity, EdgeId, EdgeUse, PolygonMesh};
use meshmend_topology::{
    CoTree, ComponentGenerators, GeneratorError, GeneratorOptions, Roots, generators, patches, seams,
};

use crate::Overlay;

/// The generators of a mesh, and the trees that they come from.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopOverlays {
    /// The generators of every component that is a surface, component by component; the first [`MOST_GENERATORS`].
    pub generators: Overlay,
    /// The trees of shortest paths.
    pub tree: Overlay,
    /// The trees of the faces.
    pub cotree: Overlay,
}

/// So many generators are drawn: on a surface of many handles all paths together can be longer than any memory, and
/// nobody could tell them apart.
pub const MOST_GENERATORS: usize = 256;

/// So many roots are tried, for loops that are short together.
const ROOTS: NonZeroU32 = NonZeroU32::MIN.saturating_add(7);

/// Short generators of a mesh by the lengths of its edges, with their trees.
///
/// # Errors
/// When the number of generators is not β₁, which is a mistake of this program.
///
/// *Cost*: O(n log n) for each of eight roots, and the paths of at most [`MOST_GENERATORS`] generators.
pub fn loops(mesh: &PolygonMesh) -> Result<LoopOverlays, GeneratorError> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let length = |edge: EdgeId| {
        let [a, b] = kernel.edge_ends(edge).map(|end| mesh.position(end));
        (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
    };
    let lengths: Column<EdgeId, f64> = kernel.edges().map(length).collect();
    let options = GeneratorOptions {
        lengths: Some(&lengths),
        co_tree: CoTree::Greedy,
        roots: Roots::Best(ROOTS),
        watch: None,
    };
    let found = generators(&kernel, &options)?;
    let all = || found.components().iter().flat_map(|ComponentGenerators { generators, .. }| generators);
    let loops = all().take(MOST_GENERATORS).map(|generator| found.vertices(generator)).collect();
    Ok(LoopOverlays {
        generators: Overlay::Generators { loops, more: all().count().saturating_sub(MOST_GENERATORS) },
        tree: Overlay::Tree { edges: found.tree_edges() },
        cotree: Overlay::Cotree { edges: found.co_tree_edges().to_vec() },
    })
}

/// Where patches with one side only can be cut to have two.
///
/// *Cost*: as [`seams`].
pub fn seam(mesh: &PolygonMesh) -> Overlay {
    let kernel = EdgeUse::assemble(mesh.complex());
    let mut edges: Vec<EdgeId> =
        seams(&kernel, &patches(&kernel)).into_iter().flat_map(|seam| seam.edges).collect();
    edges.sort_unstable();
    Overlay::Seam { edges }
}
