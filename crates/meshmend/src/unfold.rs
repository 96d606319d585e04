//! A mesh laid out in the plane, cut open first where it is not a disc.

use meshmend_core::{Carry, Domain, Layer, MeshError, PolygonMesh, Role, Values, Watch};
use meshmend_cut::{CutAlong, Discs, cut_to_discs, cut_to_square};
use meshmend_flatten::{Boundary, Flatten, FlattenError, Layout, flatten};
use meshmend_topology::GeneratorOptions;
use thiserror::Error;

use crate::{LoopError, PathOptions, View};

/// How to lay a mesh out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct UnfoldOptions {
    /// Whether the mesh is taken as stored or as welded.
    pub view: View,
    /// Where the boundary goes, and what holds the other vertices.
    pub flatten: Flatten,
    /// Along which paths a surface is cut that is not a disc.
    pub paths: PathOptions,
}

impl UnfoldOptions {
    /// These options with this view of the mesh.
    #[must_use]
    pub fn with_view(self, view: View) -> Self {
        UnfoldOptions { view, ..self }
    }

    /// These options with a layout made so.
    #[must_use]
    pub fn with_flatten(self, flatten: Flatten) -> Self {
        UnfoldOptions { flatten, ..self }
    }

    /// These options with cuts along these paths.
    #[must_use]
    pub fn with_paths(self, paths: PathOptions) -> Self {
        UnfoldOptions { paths, ..self }
    }
}

/// A mesh with its layout.
#[derive(Clone, Debug)]
pub struct Unfolded {
    /// The mesh in the view that was asked for, before.
    pub before: PolygonMesh,
    /// The mesh, cut open where that was needed, with the layout as its corners' `texcoord`.
    pub mesh: PolygonMesh,
    /// Where each vertex lies.
    pub layout: Layout,
    /// How many edges were opened.
    pub opened_edges: usize,
    /// Whether the mesh had texture coordinates, which the layout has replaced.
    pub has_replaced_texcoords: bool,
}

/// Why a mesh was not laid out.
#[derive(Clone, Debug, Error)]
pub enum UnfoldError {
    /// It can't be cut open.
    #[error(transparent)]
    Cut(#[from] LoopError),
    /// It can't be laid out.
    #[error(transparent)]
    Flatten(#[from] FlattenError),
    /// The layout does not fit the mesh: a mistake of this program.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

const TEXCOORD: &str = "texcoord";

/// Lays a mesh out in the unit square, each component in a square of its own. If one is not a disc, all are cut open,
/// and their vertices on the cut are doubled.
///
/// On a square a closed torus is cut along two paths that meet in one vertex, its corners, so that opposite sides match.
///
/// ```
/// use meshmend::{FaceTable, PolygonMesh, UnfoldOptions, VertexId, unfold};
///
/// let tetrahedron = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let places = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
/// let mesh = PolygonMesh::new(places, FaceTable::triangles(4, tetrahedron)?)?;
/// let unfolded = unfold(&mesh, &UnfoldOptions::default())?;
/// assert!(unfolded.opened_edges > 0 && unfolded.layout.is_one_to_one());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the view's distance is not a finite, non-negative number, a component is not a surface, or the weights can't be
/// computed.
///
/// *Cost*: that of [`loops`](crate::loops()) and of [`flatten`].
pub fn unfold(mesh: &PolygonMesh, options: &UnfoldOptions) -> Result<Unfolded, UnfoldError> {
    let before = options.view.of(mesh).map_err(LoopError::from)?;
    let (mesh, layout, opened_edges) = match flatten(&before, &options.flatten) {
        Err(FlattenError::NotADisc { .. }) => cut_and_flatten(&before, options)?,
        layout => (before.clone(), layout?, 0),
    };
    let has_replaced_texcoords = mesh.layers().iter().any(|layer| layer.name() == TEXCOORD);
    let mesh = with_texcoords(mesh, &layout)?;
    Ok(Unfolded { before, mesh, layout, opened_edges, has_replaced_texcoords })
}

fn cut_and_flatten(
    mesh: &PolygonMesh,
    options: &UnfoldOptions,
) -> Result<(PolygonMesh, Layout, usize), UnfoldError> {
    if options.flatten.boundary == Boundary::Square
        && let Some(square) = cut_to_square(mesh).map_err(LoopError::from)?
    {
        let request = Flatten { boundary: Boundary::SquareAt(square.corners), ..options.flatten };
        let layout = flatten(&square.mesh, &request)?;
        return Ok((square.mesh, layout, square.seams.len()));
    }
    let work = |choice: &GeneratorOptions<'_>| cut_to_discs(mesh, CutAlong::CutGraph, choice);
    let discs = options.paths.with_lengths(mesh, &Watch::NOBODY, work).map_err(LoopError::from)?;
    let Discs { mesh, seams, .. } = discs.map_err(LoopError::from)?;
    let layout = flatten(&mesh, &options.flatten)?;
    Ok((mesh, layout, seams.len()))
}

/// The mesh with the points of a layout in place of its texture coordinates.
fn with_texcoords(mesh: PolygonMesh, layout: &Layout) -> Result<PolygonMesh, MeshError> {
    let pool = Values::F64(layout.points.iter().flatten().copied().collect());
    let uses = mesh.faces().corner_vertices().iter().map(|vertex| vertex.0).collect();
    let texcoords = Layer::indexed(TEXCOORD, Domain::Corner, 2, Carry::Interpolate, pool, uses);
    let texcoords = texcoords.with_role(Role::TexCoord);
    let others = mesh.layers().iter().filter(|layer| layer.name() != TEXCOORD).cloned();
    let layers = others.chain([texcoords]).collect();
    mesh.with_layers(layers)
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTableBuilder, VertexId};

    use super::*;

    /// A torus of n × m quads.
    fn torus(n: usize, m: usize) -> PolygonMesh {
        let place = |v: usize| {
            let turn = |i: usize, of: usize| std::f64::consts::TAU * i as f64 / of as f64;
            let (u, v) = (turn(v / m, n), turn(v % m, m));
            [(3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin()]
        };
        let at = |i: usize, j: usize| VertexId((i % n * m + j % m) as u32);
        let mut builder = FaceTableBuilder::default();
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            builder.push_face([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
        let faces = builder.build(n * m).unwrap();
        PolygonMesh::new((0..n * m).map(place).collect(), faces).unwrap()
    }

    fn options(boundary: Boundary) -> UnfoldOptions {
        let flatten = Flatten { boundary, ..Flatten::default() };
        UnfoldOptions { flatten, ..UnfoldOptions::default() }
    }

    #[test]
    fn a_torus_on_a_circle_is_one_to_one_and_carries_its_layout() {
        let unfolded = unfold(&torus(9, 6), &options(Boundary::Circle)).unwrap();
        assert!(unfolded.layout.is_one_to_one() && unfolded.opened_edges > 0);
        let layer = unfolded.mesh.layer("texcoord", Domain::Corner).unwrap();
        let Values::F64(pool) = layer.values() else { panic!("{layer:?}") };
        for corner in unfolded.mesh.faces().corners() {
            let (vertex, at) = (
                unfolded.mesh.faces().corner_vertex(corner).0 as usize,
                layer.value_of(corner.0 as usize).unwrap(),
            );
            assert_eq!(pool[2 * at..2 * at + 2], unfolded.layout.points[vertex]);
        }
        // What is a disc already is not cut, and what it had is replaced.
        assert!(!unfolded.has_replaced_texcoords);
        let again = unfold(&unfolded.mesh, &options(Boundary::Circle)).unwrap();
        assert_eq!((again.opened_edges, again.has_replaced_texcoords), (0, true));
        assert_eq!(again.mesh.layers().len(), 1);
    }

    /// Opposite sides of the square are two sides of one cut: their vertices lie at the same places.
    #[test]
    fn a_torus_on_a_square_matches_across_it() {
        for (n, m) in [(3, 3), (9, 6), (6, 12)] {
            let unfolded = unfold(&torus(n, m), &options(Boundary::Square)).unwrap();
            assert!(unfolded.layout.is_one_to_one(), "{n} x {m}");
            let points = &unfolded.layout.points;
            let side = |axis: usize, value: f64| {
                let mut along: Vec<f64> =
                    points.iter().filter(|p| p[axis] == value).map(|p| p[1 - axis]).collect();
                along.sort_by(f64::total_cmp);
                along
            };
            for axis in 0..2 {
                assert_eq!(side(axis, 0.0), side(axis, 1.0), "{n} x {m}");
                assert!(side(axis, 0.0).len() > 3);
            }
        }
    }

    #[test]
    fn what_is_no_surface_is_refused() {
        let mut builder = FaceTableBuilder::default();
        (2..5).for_each(|page| builder.push_face([0, 1, page].map(VertexId)));
        let book = PolygonMesh::new(vec![[0.0; 3]; 5], builder.build(5).unwrap()).unwrap();
        assert!(matches!(unfold(&book, &UnfoldOptions::default()), Err(UnfoldError::Cut(LoopError::Cut(_)))));
    }
}
