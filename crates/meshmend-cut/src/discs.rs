//! Opens every component of a mesh into a disc, and reads from its rim how it is glued.

use meshmend_core::{
    Column, Connectivity, EdgeId, EdgeUse, PolygonMesh, Provenance, VertexId, vertex_classes,
};
use meshmend_topology::{
    ComponentId, GeneratorError, GeneratorOptions, GluingWord, Surface, boundary_loops, component_facts,
    components, cut_graph, generators, patches,
};
use serde::{Deserialize, Serialize};

use crate::error::CutError;
use crate::open::{CutOpen, CutSeam, cut_open};

/// Along what a mesh is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CutAlong {
    /// A graph beside which every component is a disc.
    #[default]
    CutGraph,
    /// The handles' and cross-caps' paths of closed components: what is left hangs together and has no handle, but it
    /// may have more boundary loops than one.
    Generators,
}

/// A mesh that was cut open, component by component.
#[must_use]
#[derive(Clone, Debug)]
pub struct Discs {
    /// The mesh with its cuts open.
    pub mesh: PolygonMesh,
    /// Where each of its elements came from: faces and corners are the same as before.
    pub provenance: Provenance,
    /// Which sides of the boundary belong together, by ascending edge.
    pub seams: Vec<CutSeam>,
    /// The components, which are as many as before and in the same order.
    pub pieces: Vec<Piece>,
}

/// A component before and after.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The surface that it was.
    pub before: Surface,
    /// The surface that it is.
    pub after: Surface,
    /// How gluing its rim makes it again what it was; `None` if it is not a disc.
    pub word: Option<GluingWord>,
}

/// Cuts every component of a mesh open.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// # use meshmend_cut::{CutAlong, cut_to_discs};
/// // The torus with seven vertices.
/// let corners = (0..7).flat_map(|i| [i, (i + 1) % 7, (i + 3) % 7, i, (i + 3) % 7, (i + 2) % 7]);
/// let faces = FaceTable::triangles(7, corners.map(VertexId).collect())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 7], faces)?;
/// let open = cut_to_discs(&mesh, CutAlong::CutGraph, &Default::default())?;
/// let word = open.pieces[0].word.as_ref();
/// assert_eq!(word.and_then(|word| word.surface()), Some(open.pieces[0].before));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When a component is not a surface, or is to be cut along generators and has a boundary; when the generators can't
/// be found; when a component did not become a disc, which is a mistake of this program; or if the watch of the options
/// stops it.
///
/// *Cost*: that of [`generators`](meshmend_topology::generators()), and linear in the mesh.
pub fn cut_to_discs(
    mesh: &PolygonMesh,
    along: CutAlong,
    options: &GeneratorOptions<'_>,
) -> Result<Discs, CutError> {
    let look = || options.watch().look("cut", 0, 0).map_err(GeneratorError::from);
    look()?;
    let kernel = EdgeUse::assemble(mesh.complex());
    let (edges, before) = match along {
        CutAlong::CutGraph => by_graph(&kernel, options)?,
        CutAlong::Generators => by_generators(&kernel, options)?,
    };
    drop(kernel);
    look()?;
    let CutOpen { mesh, provenance, seams, .. } = cut_open(mesh, &edges)?;
    let pieces = pieces(&mesh, &provenance, &before, along, &look)?;
    Ok(Discs { mesh, provenance, seams, pieces })
}

const DISC: Surface = Surface::Orientable { genus: 0, holes: 1 };

type EdgesAndSurfaces = (Vec<EdgeId>, Vec<Surface>);

fn by_graph(kernel: &EdgeUse, options: &GeneratorOptions<'_>) -> Result<EdgesAndSurfaces, CutError> {
    let graph = cut_graph(kernel, options)?;
    match graph.obstacles.into_iter().next() {
        Some((_, obstacle)) => Err(CutError::NotManifold(obstacle)),
        None => Ok((graph.edges, graph.surfaces.into_vec().into_iter().flatten().collect())),
    }
}

fn by_generators(kernel: &EdgeUse, options: &GeneratorOptions<'_>) -> Result<EdgesAndSurfaces, CutError> {
    let found = generators(kernel, options)?;
    let mut surfaces = Vec::with_capacity(found.components().len());
    for component in found.components() {
        if let Some(obstacle) = &component.obstacle {
            return Err(CutError::NotManifold(obstacle.clone()));
        }
        let surface = component.system.map(|system| system.surface);
        if surface.is_some_and(|surface| surface.holes() > 0) {
            return Err(CutError::HasBoundary(component.component));
        }
        surfaces.extend(surface);
    }
    Ok((found.loop_edges(), surfaces))
}

/// What has become of each component; fails when one was cut along its cut graph and is not a disc.
fn pieces(
    mesh: &PolygonMesh,
    provenance: &Provenance,
    before: &[Surface],
    along: CutAlong,
    look: &dyn Fn() -> Result<(), GeneratorError>,
) -> Result<Vec<Piece>, CutError> {
    look()?;
    let kernel = EdgeUse::assemble(mesh.complex());
    look()?;
    let (components, rims) = (components(&kernel), boundary_loops(&kernel));
    look()?;
    let (patches, classes) = (patches(&kernel), vertex_classes(&kernel));
    look()?;
    let facts = component_facts(&kernel, &components, &patches, &classes, &rims);
    let mut words: Column<ComponentId, Option<GluingWord>> = Column::filled(None, components.count());
    for rim in rims.iter() {
        let component = rim.first().and_then(|&vertex| components.of_vertex(vertex));
        let walk: Vec<VertexId> = rim.iter().filter_map(|&vertex| provenance.vertices.of(vertex)).collect();
        if let Some(component) = component.filter(|&c| facts[c].surface() == Some(DISC)) {
            words[component] = GluingWord::of_rim(&walk);
        }
    }
    let is_kept = |surface: &Surface| along == CutAlong::Generators || *surface == DISC;
    let mut pieces = Vec::with_capacity(before.len());
    for ((component, facts), &before) in facts.iter().zip(before) {
        let after = facts.surface().filter(is_kept).ok_or(CutError::NoDisc(component))?;
        pieces.push(Piece { before, after, word: words[component].take() });
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use meshmend_core::FaceTable;

    use super::*;

    #[test]
    fn a_component_that_is_no_disc_is_told() {
        let faces = FaceTable::triangles(3, [0, 1, 2, 2, 1, 0].map(VertexId).to_vec()).unwrap();
        let sphere = PolygonMesh::new(vec![[0.0; 3]; 3], faces).unwrap();
        let (whole, before) =
            (Provenance::same(sphere.counts()), [Surface::Orientable { genus: 0, holes: 0 }]);
        let pieces = |along| pieces(&sphere, &whole, &before, along, &|| Ok(()));
        assert!(pieces(CutAlong::Generators).is_ok());
        let wrong = pieces(CutAlong::CutGraph).unwrap_err();
        assert_eq!(
            wrong.to_string(),
            "component 0 was cut but is not a disc, which is a mistake of this program"
        );
    }
}
