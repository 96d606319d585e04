//! Takes a mesh apart until it is manifold, and no further.
//!
//! *Why*: most data structures and tools need manifold meshes, and many tools get them by deleting faces. This pass deletes
//! no face: it makes copies of vertices.
//!
//! 1. Match sides that are beyond doubt: rules 1 and 2 of the text. A face that repeats another one and differs from it
//!    is not sewn to it.
//! 2. If non-orientable patches are cut, part their matched sides that run the same way: they are a seam.
//! 3. At edges of degree three or more, match what is free by policy: into sheets, or not at all.
//! 4. The new vertices are the classes of corners that are joined across matched sides, so a vertex has exactly one
//!    umbrella, and the result is manifold by construction.
//! 5. Different edges that would join the same two vertices are subdivided, each by a vertex of its own.
//!
//! *Promises* no non-manifold edge and no non-manifold vertex (with `pinch-only`: no pinched vertex among edges of
//! degree one and two). *Requires* simple, consistently oriented faces, so that its sheets mean something; it works on any
//! faces. *May introduce* boundary edges, corners where edges are subdivided, and a patch without a consistent
//! orientation that a non-manifold edge had hidden. *Cost*: O(n log d) for edges of degree d. *Source*: A. Guéziec, G. Taubin,
//! F. Lazarus, W. Horn, *Cutting and stitching*, 2001, for splitting by matching; the sheets follow the text.

use meshmend_core::{
    Connectivity, CornerId, Defect, DefectKind, EdgeClass, EdgeId, PolygonMesh, VertexClass, edge_class,
};
use meshmend_kernels::KernelTask;
use serde::{Deserialize, Serialize};

use crate::apart::{Apart, Coinciding, NewVertices, Separation, VertexParts, with_ends};
use crate::matching::{Matching, StoredGroups};
use crate::sewing::{Sewing, has_clash};
use crate::stored_vertices::StoredVertices;
use crate::{Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word};

mod radial;
mod seams;
mod sheets;

pub use seams::SeamFigures;

/// Takes a mesh apart until it is manifold, and no further.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Split {
    /// What happens at edges of degree three or more.
    pub edges: SplitEdges,
    /// What happens to patches that have no consistent orientation.
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

/// What happens to patches that have no consistent orientation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Seams {
    /// They stay whole.
    #[default]
    Keep,
    /// They are opened along the edges at which sides run the same way. Then they can be oriented.
    Cut,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "split",
    explanation: "Takes the mesh apart until it is manifold, and no further: sides at edges with three faces or more are paired \
                  into sheets by their order round the edge, and each umbrella of faces gets a vertex of its own. No face is \
                  removed.",
    is_default: true,
    before: None,
    options: &[PassOption {
        name: "split",
        help: "Edges with three faces or more, and pinched vertices",
        sets: &["edges"],
        values: OptionValues::Words(&[
            Word::new("sheets", "Take them apart into sheets"),
            Word::new("cut", "Take them apart wherever it is not beyond doubt what belongs together"),
            Word::new("pinch-only", "Split pinched vertices alone"),
        ]),
    }],
    form: Form::of::<Split>(),
};

impl Pass for Split {
    fn kind(&self) -> PassKind {
        PassKind::Split
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
            // In a patch that has no consistent orientation by vertices as stored, and was joined otherwise before.
            DefectKind::InconsistentEdge,
            DefectKind::NonOrientablePatch,
            // A triangle one of whose edges is subdivided.
            DefectKind::PolygonFace,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let complex = mesh.complex();
        context.check_cancelled()?;
        context.kernel.run_on_all_vertices(complex, Task { options: self, mesh, context })?
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
        self.context.check_cancelled()?;
        let stored = StoredVertices::new(self.mesh, self.context);
        self.context.check_cancelled()?;
        let mut sewing = Sewing::of(kernel, self.mesh, self.context);
        self.context.check_cancelled()?;
        let has_seam = self.options.seams == Seams::Cut && has_clash(kernel);
        if !has_seam && sewing.is_whole(kernel, self.mesh, &stored) {
            return Ok(Outcome::unchanged(self.mesh));
        }
        self.context.check_cancelled()?;
        let mut matching = sewing.take_matching(kernel, &stored);
        self.context.check_cancelled()?;
        let seam = self.complete(kernel, &stored, &sewing, &mut matching)?;
        let parted = sewing.parted_copies(kernel);
        self.context.check_cancelled()?;
        let seam_edges = seam.iter().map(|&(one, _)| kernel.corner_edge(one));
        let cut: Vec<EdgeId> = seam_edges.chain(parted.iter().copied()).collect();
        let joined = self.joined_as_stored(kernel, &stored);
        self.context.check_cancelled()?;
        let vertices = with_ends(kernel, sewing.irregular, &cut);
        self.context.check_cancelled()?;
        let separation =
            Separation { matching: &matching, joined: &joined, vertices, coinciding: self.coinciding() };
        let apart = Apart::of(kernel, self.mesh, self.context, separation)?;
        self.context.check_cancelled()?;
        let figures = seams::seam_figures(kernel, self.mesh, &matching, &apart.vertices, &seam);
        drop(matching);
        let came_apart = parted.into_iter().filter(|&edge| self.comes_apart(kernel, &apart.vertices, edge));
        let clashing = came_apart.map(|edge| Defect::inconsistent_edge(edge, kernel.edge_ends(edge)));
        self.context.check_cancelled()?;
        let opened = seams::seam_edges(kernel, &seam).chain(clashing).collect();
        Ok(Outcome { seam: figures, ..self.outcome(kernel, apart, opened)? })
    }
}

impl Task<'_> {
    /// Steps 1 to 3: matches by policy what the rules leave free, and returns the pairs of the seam that was parted.
    fn complete<K: Connectivity>(
        &self,
        kernel: &K,
        stored: &StoredVertices<'_>,
        sewing: &Sewing,
        matching: &mut Matching,
    ) -> Result<Vec<seams::Parted>, PassError> {
        let copies = sewing.copies.as_ref();
        if let (Some(copies), SplitEdges::Sheets | SplitEdges::PinchOnly) = (copies, self.options.edges) {
            matching.pair_by_rank(kernel, stored, copies);
        }
        let seam = match self.options.seams {
            Seams::Keep => Vec::new(),
            Seams::Cut => seams::part_seams(kernel, matching),
        };
        self.context.check_cancelled()?;
        if self.options.edges == SplitEdges::Sheets {
            sheets::match_sheets(kernel, self.mesh, copies, matching, self.context)?;
        }
        Ok(seam)
    }

    /// The sides that `pinch-only` keeps together: those of one edge of degree three or more as stored.
    fn joined_as_stored<K: Connectivity>(
        &self,
        kernel: &K,
        stored: &StoredVertices<'_>,
    ) -> Vec<(CornerId, CornerId)> {
        let mut joined = Vec::new();
        if self.options.edges != SplitEdges::PinchOnly {
            return joined;
        }
        let mut groups = StoredGroups::default();
        for edge in kernel.edges() {
            let uses = groups.uses_of(kernel, stored, edge);
            for group in uses.chunk_by(|one, other| one.stored == other.stored) {
                if group.len() > 2 {
                    joined.extend(group[1..].iter().map(|u| (group[0].corner, u.corner)));
                }
            }
        }
        joined
    }

    fn coinciding(&self) -> Coinciding {
        match self.options.edges {
            SplitEdges::PinchOnly => Coinciding::Joined,
            SplitEdges::Sheets | SplitEdges::Cut => Coinciding::Subdivided,
        }
    }

    /// Whether an edge of two sides is two edges afterwards: `pinch-only` does not subdivide what would coincide.
    fn comes_apart<K: Connectivity>(&self, kernel: &K, vertices: &NewVertices, edge: EdgeId) -> bool {
        let ends = kernel.edge_corners(edge).map(|corner| {
            let (from, to) = (vertices.of_corner[corner], vertices.of_corner[kernel.next_corner(corner)]);
            (from.min(to), from.max(to))
        });
        let ends: Vec<_> = ends.collect();
        self.options.edges != SplitEdges::PinchOnly || ends.windows(2).any(|two| two[0] != two[1])
    }

    /// The new mesh and the record; `opened` are the edges that were cut open.
    fn outcome<K: Connectivity>(
        &self,
        kernel: &K,
        apart: Apart,
        opened: Vec<Defect>,
    ) -> Result<Outcome, PassError> {
        if apart.is_unchanged(kernel, self.mesh) {
            let left = self.left(self.mesh);
            return Ok(Outcome { left, ..Outcome::unchanged(self.mesh) });
        }
        let mut fixed = self.edges_fixed(kernel);
        self.context.check_cancelled()?;
        fixed.extend(vertices_fixed(&apart.parts));
        let subdivided = apart.subdivided_edges().iter();
        fixed.extend(subdivided.map(|&edge| Defect::coincident_edges(kernel.edge_ends(edge))));
        fixed.extend(opened);
        self.context.check_cancelled()?;
        let outcome = Outcome::changed(apart.rebuild(self.mesh, self.context)?, fixed);
        self.context.check_cancelled()?;
        Ok(Outcome { left: self.left(&outcome.mesh), ..outcome })
    }

    /// The edges of degree three and more, unless they are left alone.
    fn edges_fixed<K: Connectivity>(&self, kernel: &K) -> Vec<Defect> {
        if self.options.edges == SplitEdges::PinchOnly {
            return Vec::new();
        }
        let edges = kernel.edges().filter(|&e| edge_class(kernel, e) == EdgeClass::NonManifold);
        let defect = |edge| {
            let degree = kernel.edge_degree(edge) as u32;
            Defect::non_manifold_edge(edge, kernel.edge_ends(edge), degree)
        };
        edges.map(defect).collect()
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

/// The vertices that came apart, except the ends of edges that were cut open: there the edge is named.
fn vertices_fixed(parts: &VertexParts) -> impl Iterator<Item = Defect> + '_ {
    let by_vertex = parts.parts.chunk_by(|one, next| one.vertex == next.vertex);
    let came_apart = parts.vertices.iter().zip(by_vertex).filter(|(_, parts)| parts.len() > 1);
    came_apart.filter_map(|(&(vertex, class), _)| match class {
        VertexClass::Pinched { umbrellas, boundary_only } => {
            Some(Defect::pinched_vertex(vertex, umbrellas, boundary_only))
        }
        VertexClass::Disc | VertexClass::HalfDisc => None,
        _ => Some(Defect::singular_vertex(vertex)),
    })
}
