//! Takes a mesh apart until it is manifold, and no further.
//!
//! *Why*: most data structures and tools need manifold meshes, and many get them by deleting faces. Here nothing is
//! deleted: vertices are given copies.
//!
//! 1. Match sides that are beyond doubt: rules 1 and 2 of the text. A face that repeats another one and differs from it
//!    is not sewn to it.
//! 2. Where a non-orientable patch is to be cut, part the matched sides that run the same way: they are a seam.
//! 3. At edges of degree three or more, match what is free by policy: into sheets, or not at all.
//! 4. The new vertices are the classes of corners that are joined across matched sides, so a vertex has exactly one
//!    umbrella, and the result is manifold by construction.
//! 5. Different edges that would join the same two vertices are subdivided, each by a vertex of its own.
//!
//! *Promises* no non-manifold edge and no non-manifold vertex (with `pinch-only`: no pinched vertex among edges of
//! degree one and two). *Requires* simple, consistently oriented faces for its sheets to be meaningful; works on
//! any. *May introduce* boundary edges, corners where edges are subdivided, and a patch without a consistent side that
//! was hidden by a non-manifold edge. *Cost*: O(n log d) for edges of degree d. *Source*: A. Guéziec, G. Taubin,
//! F. Lazarus, W. Horn, *Cutting and stitching*, 2001, for splitting by matching; the sheets follow the text.

use meshmend_core::{
    Connectivity, CornerId, Defect, DefectKind, EdgeClass, EdgeId, PolygonMesh, VertexClass, VertexId,
    edge_class, irregular_vertices, is_inconsistent,
};
use meshmend_kernels::KernelTask;
use serde::{Deserialize, Serialize};

use crate::copies::Copies;
use crate::matching::{Matching, StoredGroups, may_match};
use crate::telling::Telling;
use crate::{Context, Outcome, Pass, PassError, StoredNames};

mod radial;
mod regular_fast_path;
mod seams;
mod sheets;

use crate::apart::draft;
use crate::apart::new_vertices::NewVertices;
use crate::apart::parts::VertexParts;
use crate::apart::subdivide::{self, Inserted};
pub use seams::SeamFigures;

/// Takes a mesh apart until it is manifold, and no further.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Split {
    /// What happens at edges of degree three or more.
    pub edges: SplitEdges,
    /// What happens to patches that have no consistent side.
    pub seams: Seams,
}

/// What happens at edges with three sides or more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SplitEdges {
    /// Sides are paired into sheets by their order round the edge; the rest becomes boundary.
    #[default]
    Sheets,
    /// What is not matched beyond doubt becomes boundary.
    Cut,
    /// Edges are left alone; only pinched vertices are split.
    PinchOnly,
}

/// What happens to patches that have no consistent side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Seams {
    /// They stay whole.
    #[default]
    Keep,
    /// They are opened along the edges at which their faces' sides clash, after which they can be oriented.
    Cut,
}

impl Pass for Split {
    fn name(&self) -> &'static str {
        "split"
    }
    fn removes(&self) -> &'static [DefectKind] {
        match self.edges {
            SplitEdges::PinchOnly => &[DefectKind::PinchedVertex],
            _ => &[DefectKind::NonManifoldEdge, DefectKind::PinchedVertex, DefectKind::SingularVertex],
        }
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[
            DefectKind::DegenerateFace,
            DefectKind::NonSimpleFace,
            DefectKind::RepeatedCorner,
            DefectKind::InconsistentEdge,
        ]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::BoundaryEdge,
            DefectKind::CoincidentVertex,
            // In a patch that by vertices as stored has no consistent side, but hung together otherwise before.
            DefectKind::InconsistentEdge,
            DefectKind::NonOrientablePatch,
            // A triangle one of whose edges is subdivided.
            DefectKind::PolygonFace,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        context.kernel.run(mesh.complex(), Task { options: self, mesh, context })?
    }
}

struct Task<'a> {
    options: &'a Split,
    mesh: &'a PolygonMesh,
    context: &'a Context<'a>,
}

impl KernelTask for Task<'_> {
    type Output = Result<Outcome, PassError>;

    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        let stored = StoredNames::new(self.mesh, self.context);
        let is_manifold = self.context.report.is_some_and(|report| report.manifold);
        let irregular = if is_manifold { Vec::new() } else { irregular_vertices(kernel) };
        let copies = self.copies(kernel, &irregular);
        if irregular.is_empty() && copies.is_none() && self.is_whole(kernel, &stored) {
            return Ok(Outcome::unchanged(self.mesh));
        }
        let mut matching = Matching::by_rules(kernel, &stored, copies.as_ref());
        if let (Some(copies), SplitEdges::Sheets | SplitEdges::PinchOnly) = (&copies, self.options.edges) {
            matching.pair_by_rank(kernel, &stored, copies);
        }
        let seam = match self.options.seams {
            Seams::Keep => Vec::new(),
            Seams::Cut => seams::part_seams(kernel, &mut matching),
        };
        self.context.check_cancelled()?;
        let joined = match self.options.edges {
            SplitEdges::Sheets => {
                sheets::match_sheets(kernel, self.mesh, copies.as_ref(), &mut matching);
                Vec::new()
            }
            SplitEdges::Cut => Vec::new(),
            SplitEdges::PinchOnly => joined_as_stored(kernel, &stored),
        };
        self.context.check_cancelled()?;
        let parted = parted_copies(kernel, copies.as_ref());
        let cut: Vec<EdgeId> =
            seam.iter().map(|&(one, _)| kernel.corner_edge(one)).chain(parted.iter().copied()).collect();
        let parts = VertexParts::of(kernel, &matching, &joined, seams::with_ends(kernel, irregular, &cut));
        let names = NewVertices::name(kernel, &stored, &parts);
        let figures = seams::seam_figures(kernel, self.mesh, &matching, &names, &seam);
        let inserted = match self.options.edges {
            SplitEdges::PinchOnly => Inserted { vertices: Vec::new(), sides: Vec::new(), edges: Vec::new() },
            _ => subdivide::subdivide(kernel, self.mesh, &matching, &names, self.context)?,
        };
        let mut seam: Vec<Defect> = seams::seam_edges(kernel, &seam).collect();
        let came_apart = parted.iter().filter(|&&edge| self.comes_apart(kernel, &names, edge));
        seam.extend(came_apart.map(|&edge| Defect::inconsistent_edge(edge, kernel.edge_ends(edge))));
        drop(matching);
        let outcome = self.outcome(kernel, &parts, names, inserted, seam)?;
        Ok(Outcome { seam: figures, ..outcome })
    }
}

/// The edges that only two copies of a face have, which differ and so come apart.
fn parted_copies<K: Connectivity>(kernel: &K, copies: Option<&Copies>) -> Vec<EdgeId> {
    let Some(copies) = copies else { return Vec::new() };
    let is_parted = |&edge: &EdgeId| {
        let mut corners = kernel.edge_corners(edge);
        match (corners.next(), corners.next(), corners.next()) {
            (Some(one), Some(other), None) => !may_match(kernel, Some(copies), one, other),
            _ => false,
        }
    };
    kernel.edges().filter(is_parted).collect()
}

/// The sides that `pinch-only` keeps together: those of one edge of degree three or more as stored.
fn joined_as_stored<K: Connectivity>(kernel: &K, names: &StoredNames<'_>) -> Vec<(CornerId, CornerId)> {
    let mut groups = StoredGroups::default();
    let mut joined = Vec::new();
    for edge in kernel.edges() {
        for group in groups.uses_of(kernel, names, edge).chunk_by(|one, other| one.stored == other.stored) {
            if group.len() > 2 {
                joined.extend(group[1..].iter().map(|u| (group[0].corner, u.corner)));
            }
        }
    }
    joined
}

impl Task<'_> {
    /// The faces that repeat others and differ from them. Where each vertex is regular, they have inconsistent edges.
    fn copies<K: Connectivity>(&self, kernel: &K, irregular: &[(VertexId, VertexClass)]) -> Option<Copies> {
        Telling::of(self.mesh, self.context.telling)?;
        let clashes = || kernel.edges().any(|edge| is_inconsistent(kernel, edge));
        if irregular.is_empty() && !clashes() {
            return None;
        }
        Copies::find(kernel, self.mesh, self.context)
    }

    /// Whether an edge of two sides is two edges afterwards: `pinch-only` does not subdivide what would coincide.
    fn comes_apart<K: Connectivity>(&self, kernel: &K, names: &NewVertices, edge: EdgeId) -> bool {
        let ends = kernel.edge_corners(edge).map(|corner| {
            let (from, to) = (names.of_corner[corner], names.of_corner[kernel.next_corner(corner)]);
            (from.min(to), from.max(to))
        });
        let ends: Vec<_> = ends.collect();
        self.options.edges != SplitEdges::PinchOnly || ends.windows(2).any(|two| two[0] != two[1])
    }

    /// Whether nothing is to be split in a mesh whose vertices are regular, as far as can be seen without a matching.
    fn is_whole<K: Connectivity>(&self, kernel: &K, names: &StoredNames<'_>) -> bool {
        let clashes = || kernel.edges().any(|edge| is_inconsistent(kernel, edge));
        let has_no_seam = self.options.seams == Seams::Keep || !clashes();
        has_no_seam && regular_fast_path::keeps_names(kernel, self.mesh, names)
    }

    fn outcome<K: Connectivity>(
        &self,
        kernel: &K,
        parts: &VertexParts,
        names: NewVertices,
        inserted: Inserted,
        seam: Vec<Defect>,
    ) -> Result<Outcome, PassError> {
        if inserted.vertices.is_empty() && self.is_unchanged(kernel, &names) {
            let left = self.left(self.mesh);
            return Ok(Outcome { left, ..Outcome::unchanged(self.mesh) });
        }
        let mut fixed = self.fixed(kernel, parts);
        let coincident = inserted.edges.iter().map(|&e| Defect::coincident_edges(kernel.edge_ends(e)));
        fixed.extend(coincident.chain(seam));
        let outcome =
            Outcome::changed(self.mesh.rebuild(draft::draft(self.mesh, names, inserted)?)?, fixed.into());
        Ok(Outcome { left: self.left(&outcome.mesh), ..outcome })
    }

    fn is_unchanged<K: Connectivity>(&self, kernel: &K, names: &NewVertices) -> bool {
        let same_bits = |a: &[f64; 3], b: &[f64; 3]| a.map(f64::to_bits) == b.map(f64::to_bits);
        names.present.iter().zip(0..).all(|(present, new)| present.0 == new)
            && names.positions.iter().zip(self.mesh.positions()).all(|(a, b)| same_bits(a, b))
            && kernel.corners().all(|c| names.of_corner[c] == kernel.corner_vertex(c))
    }

    /// Edges of degree three and more, and vertices that are no longer one.
    fn fixed<K: Connectivity>(&self, kernel: &K, parts: &VertexParts) -> Vec<Defect> {
        let mut fixed = Vec::new();
        if self.options.edges != SplitEdges::PinchOnly {
            let edges = kernel.edges().filter(|&e| edge_class(kernel, e) == EdgeClass::NonManifold);
            fixed.extend(edges.map(|edge| {
                let degree = kernel.edge_degree(edge) as u32;
                Defect::non_manifold_edge(edge, kernel.edge_ends(edge), degree)
            }));
        }
        let by_vertex = parts.parts.chunk_by(|one, next| one.vertex == next.vertex);
        for (&(vertex, class), _) in parts.vertices.iter().zip(by_vertex).filter(|(_, parts)| parts.len() > 1)
        {
            fixed.push(match class {
                VertexClass::Pinched { umbrellas, boundary_only } => {
                    Defect::pinched_vertex(vertex, umbrellas, boundary_only)
                }
                // An edge that ends here is named.
                VertexClass::Disc | VertexClass::HalfDisc => continue,
                _ => Defect::singular_vertex(vertex),
            });
        }
        fixed
    }

    /// With `pinch-only`, the edges of degree three and more that are still there.
    fn left(&self, mesh: &PolygonMesh) -> Vec<Defect> {
        if self.options.edges != SplitEdges::PinchOnly {
            return Vec::new();
        }
        let edges = mesh.complex().edges();
        let crowded = edges.edges().filter(|&e| edges.edge_corners(e).len() > 2);
        let defect = |edge| {
            let degree = edges.edge_corners(edge).len() as u32;
            Defect::non_manifold_edge(edge, edges.ends(edge), degree)
        };
        crowded.map(defect).collect()
    }
}
