//! The closed paths that generate a surface, with lengths measured in space, and cutting along them.

use meshmend_core::{PolygonMesh, Watch};
use meshmend_cut::{CutAlong, CutError, Discs, cut_to_discs};
use meshmend_geometry::edge_lengths;
use meshmend_repair::{PassError, Session};
use meshmend_topology::{CoTree, GeneratorError, GeneratorOptions, Generators, Measure, Roots};
use thiserror::Error;

use crate::check::viewed;
use crate::{AnyKernel, View};

/// What the work is called to whoever watches it.
const STEP: &str = "loops";

/// How to look for the closed paths of surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LoopOptions {
    /// Whether the mesh is taken as stored or as welded.
    pub view: View,
    /// The kernel to compute on.
    pub kernel: AnyKernel,
    /// Which paths are wanted.
    pub paths: PathOptions,
    /// Who watches, and may stop it.
    pub watch: Watch,
}

impl LoopOptions {
    /// These options with this view of the mesh.
    #[must_use]
    pub fn with_view(self, view: View) -> Self {
        LoopOptions { view, ..self }
    }

    /// These options with this kernel to compute on.
    #[must_use]
    pub fn with_kernel(self, kernel: impl Into<AnyKernel>) -> Self {
        LoopOptions { kernel: kernel.into(), ..self }
    }

    /// These options with these paths wanted.
    #[must_use]
    pub fn with_paths(self, paths: PathOptions) -> Self {
        LoopOptions { paths, ..self }
    }

    /// These options for a search that is watched.
    #[must_use]
    pub fn with_watch(self, watch: &Watch) -> Self {
        LoopOptions { watch: watch.clone(), ..self }
    }
}

/// Which closed paths of a surface are wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PathOptions {
    /// Whether edges are measured in space or counted.
    pub measure: Measure,
    /// Whether any paths will do, or the shortest system at the root is wanted.
    pub co_tree: CoTree,
    /// Where the paths begin.
    pub roots: Roots,
}

impl PathOptions {
    /// These options with edges measured so.
    #[must_use]
    pub fn with_measure(self, measure: Measure) -> Self {
        PathOptions { measure, ..self }
    }

    /// These options with this system of paths wanted.
    #[must_use]
    pub fn with_co_tree(self, co_tree: CoTree) -> Self {
        PathOptions { co_tree, ..self }
    }

    /// These options with paths that begin there.
    #[must_use]
    pub fn with_roots(self, roots: Roots) -> Self {
        PathOptions { roots, ..self }
    }
}

/// How to cut surfaces open.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CutOptions {
    /// Whether the mesh is taken as stored or as welded.
    pub view: View,
    /// Along what it is cut.
    pub along: CutAlong,
    /// Along which paths.
    pub paths: PathOptions,
    /// Who watches, and may stop it.
    pub watch: Watch,
}

impl CutOptions {
    /// These options with this view of the mesh.
    #[must_use]
    pub fn with_view(self, view: View) -> Self {
        CutOptions { view, ..self }
    }

    /// These options with cuts along these edges.
    #[must_use]
    pub fn with_along(self, along: CutAlong) -> Self {
        CutOptions { along, ..self }
    }

    /// These options with cuts along these paths.
    #[must_use]
    pub fn with_paths(self, paths: PathOptions) -> Self {
        CutOptions { paths, ..self }
    }

    /// These options for a cut that is watched.
    #[must_use]
    pub fn with_watch(self, watch: &Watch) -> Self {
        CutOptions { watch: watch.clone(), ..self }
    }
}

/// The closed paths of a mesh's surfaces.
#[derive(Clone, Debug)]
pub struct LoopReport {
    /// As what the mesh was taken.
    pub view: View,
    /// The mesh in that view: all ids are its.
    pub mesh: PolygonMesh,
    /// The paths.
    pub generators: Generators,
}

/// A mesh that was cut open.
#[derive(Clone, Debug)]
pub struct CutReport {
    /// As what the mesh was taken.
    pub view: View,
    /// The mesh in that view, before.
    pub before: PolygonMesh,
    /// The mesh after, and how its rims belong together.
    pub discs: Discs,
}

/// Why surfaces have not been looked at, or not been cut.
#[derive(Clone, Debug, Error)]
pub enum LoopError {
    /// The view's distance is not a finite, non-negative number, the kernel can't hold the mesh, or the watch stopped it.
    #[error(transparent)]
    Pass(#[from] PassError),
    /// There are no generators.
    #[error(transparent)]
    Generators(GeneratorError),
    /// There is no cut.
    #[error(transparent)]
    Cut(CutError),
}

impl From<GeneratorError> for LoopError {
    fn from(error: GeneratorError) -> Self {
        match error {
            GeneratorError::Cancelled(cancelled) => LoopError::Pass(cancelled.into()),
            error => LoopError::Generators(error),
        }
    }
}

impl From<CutError> for LoopError {
    fn from(error: CutError) -> Self {
        match error {
            CutError::Generators(error @ GeneratorError::Cancelled(_)) => error.into(),
            error => LoopError::Cut(error),
        }
    }
}

/// The closed paths that generate the first homology of each component, with their lengths in space.
///
/// ```
/// use meshmend::{FaceTable, LoopOptions, PolygonMesh, VertexId, loops};
///
/// // A square ring of four quads.
/// let corners = [0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7].map(VertexId).to_vec();
/// let faces = FaceTable::polygons(8, vec![0, 4, 8, 12, 16], corners)?;
/// let square = |z| [[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]];
/// let mesh = PolygonMesh::new([square(0.0), square(1.0)].concat(), faces)?;
/// let found = loops(&mesh, &LoopOptions::default())?;
/// assert_eq!(found.generators.components()[0].generators[0].length, 4.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the view's distance is not a finite, non-negative number, the kernel can't hold the mesh, or no face has the root.
///
/// *Cost*: O(n log n) for each root that is tried.
pub fn loops(mesh: &PolygonMesh, options: &LoopOptions) -> Result<LoopReport, LoopError> {
    let mesh = in_view(mesh, options.view, &options.watch)?;
    let ask = |choice: &GeneratorOptions<'_>| options.kernel.generators(mesh.complex(), choice);
    let found = options.paths.with_lengths(&mesh, &options.watch, ask)?.map_err(PassError::from)?;
    Ok(LoopReport { view: options.view, generators: found?, mesh })
}

/// Cuts every component of a mesh open.
///
/// # Errors
/// When the view's distance is not a finite, non-negative number, no face has the root, a component is not a surface, or one with a boundary is to
/// be cut along generators.
///
/// *Cost*: that of [`loops`].
pub fn cut(mesh: &PolygonMesh, options: &CutOptions) -> Result<CutReport, LoopError> {
    let before = in_view(mesh, options.view, &options.watch)?;
    let work = |choice: &GeneratorOptions<'_>| cut_to_discs(&before, options.along, choice);
    let discs = options.paths.with_lengths(&before, &options.watch, work)??;
    Ok(CutReport { view: options.view, before, discs })
}

fn in_view(mesh: &PolygonMesh, view: View, watch: &Watch) -> Result<PolygonMesh, PassError> {
    let mesh = viewed(&mut Session::begin(mesh).with_watch(watch), view)?.0;
    watch.look(STEP, 0, 0)?;
    Ok(mesh)
}

impl PathOptions {
    /// Does some work with these options and the lengths of a mesh's edges, unless the watch stops it before.
    pub(crate) fn with_lengths<T>(
        &self,
        mesh: &PolygonMesh,
        watch: &Watch,
        work: impl FnOnce(&GeneratorOptions<'_>) -> T,
    ) -> Result<T, PassError> {
        let mut lengths = None;
        if self.measure == Measure::Length {
            mesh.complex().edges();
            watch.look(STEP, 0, 0)?;
            lengths = Some(edge_lengths(mesh));
        }
        watch.look(STEP, 0, 0)?;
        let (lengths, co_tree, roots) = (lengths.as_ref(), self.co_tree, self.roots);
        Ok(work(&GeneratorOptions { lengths, co_tree, roots, watch: Some(watch) }))
    }
}
