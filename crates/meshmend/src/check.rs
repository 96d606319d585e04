//! What a mesh is, what is wrong with it and where, and which kernels hold it.

use std::collections::BTreeMap;
use std::iter;

use meshmend_core::{
    Cancelled, Defect, DefectKind, Defects, FaceId, Found, Id, Listed, PolygonMesh, Rules, Severity, Sources,
    VertexId, Watch,
};
use meshmend_geometry::coincident::{Coincidence, equal_in_pose};
use meshmend_repair::{Distance, Fixed, PassError, Session, Weld};
use meshmend_topology::TopologyReport;
use serde::Serialize;

use crate::geometry_questions::{GeometryOptions, GeometryReport};
use crate::{AnyKernel, CheckOptions, Kernels, View};

/// What a check found.
#[derive(Clone, Debug)]
pub struct CheckReport {
    /// As what the mesh was judged.
    pub view: View,
    /// What is stored.
    pub stored: StoredCounts,
    /// The mesh in that view: all ids below are its.
    pub mesh: PolygonMesh,
    /// The vertex as stored that each of its vertices is: of those that a weld joined, the lowest.
    pub vertex_sources: Sources<VertexId>,
    /// The face as stored that each of its faces is.
    pub face_sources: Sources<FaceId>,
    /// Its figures, and the list of what is wrong with it as it is.
    pub topology: TopologyReport,
    /// Which kernels hold it.
    pub kernels: Vec<KernelVerdict>,
    /// How many vertices would be joined to others in single precision, beyond those at the same position. Vertices
    /// at the same position are defects of their own; in a view welded within a distance this is 0.
    pub joined_in_single: u64,
    /// How many vertices are at the position of a lower one and yet apart from all such: morph targets or joints move
    /// them differently.
    pub apart_in_pose: u64,
    /// The vertices that exact welding would join to a lower one; empty if the view is welded.
    coincident: Vec<(VertexId, VertexId)>,
    /// The ends of edges with one side that are not counted as boundary, as other parts use them too.
    shared: Vec<[VertexId; 2]>,
    rules: Rules,
    /// The kinds that are listed because they were asked for.
    asked: Vec<DefectKind>,
    /// What was found by rules that are not meshmend's own.
    own: Vec<(DefectKind, Vec<Defect>)>,
    /// What was found about where the faces lie, if that was asked.
    pub geometry: Option<GeometryReport>,
}

/// How many elements a mesh has as stored, whether anything uses them or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct StoredCounts {
    /// Vertices, unreferenced ones included.
    pub vertices: usize,
    /// Faces, degenerate ones included.
    pub faces: usize,
    /// Edges that are elements of their own.
    pub loose_edges: usize,
    /// Points that are elements of their own.
    pub loose_points: usize,
}

/// Whether a kernel holds a mesh, and what stands against it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct KernelVerdict {
    /// The kernel's name.
    pub name: &'static str,
    /// Whether the kernel holds the mesh.
    pub holds: bool,
    /// How many defects of each kind it does not admit.
    pub refusals: BTreeMap<DefectKind, u64>,
}

/// Checks a mesh, and changes nothing.
///
/// # Errors
/// When the kernel can't hold the mesh, or the view's distance is not a finite, non-negative number.
///
/// *Cost*: near-linear, with questions about geometry that of [`GeometryReport::of`]; but for shortest witnesses, which cost what
/// [`one_sided_loops`](meshmend_topology::one_sided_loops) does; one sort of the positions to tell what welding would join.
pub fn check(mesh: &PolygonMesh, options: &CheckOptions) -> Result<CheckReport, PassError> {
    let mut session = Session::begin(mesh).with_watch(&options.watch);
    let view = options.view.resolved(session.mesh(), session.watch())?;
    let mesh = viewed(&mut session, view)?;
    let topology = options.kernel.topology(&mesh.0, options.witness, &options.watch)?;
    let stored = StoredCounts::of(session.stored());
    let report =
        CheckReport::new(view, stored, mesh, topology, (options.rules, options.kernels), &options.watch)?;
    match &options.geometry {
        Some(asked) => report.with_geometry(asked, &options.watch),
        None => Ok(report),
    }
}

/// Checks the mesh of a session that has just begun, as [`check`] does. A pipeline may go on with the session.
///
/// ```
/// # use meshmend::{FaceTable, PolygonMesh, Rules, VertexId, View, Session};
/// # let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
/// # let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces)?;
/// let mut session = Session::begin(&mesh);
/// let before = meshmend::check_in(&mut session, View::default(), Rules::default())?;
/// let repaired = meshmend::Pipeline::default().run_in(session)?;
/// assert_eq!(repaired.topology.map(|after| after.components), Some(before.topology.components));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`check`].
pub fn check_in(session: &mut Session, view: View, rules: Rules) -> Result<CheckReport, PassError> {
    let view = view.resolved(session.mesh(), session.watch())?;
    let mesh = viewed(session, view)?;
    let topology = session.topology()?.clone();
    let stored = StoredCounts::of(session.stored());
    Ok(CheckReport::new(view, stored, mesh, topology, (rules, Kernels::builtin()), session.watch())?)
}

/// The mesh of a session that has just begun, in a view, and of each of its vertices the stored one.
pub(crate) fn viewed(
    session: &mut Session,
    view: View,
) -> Result<(PolygonMesh, Sources<VertexId>), PassError> {
    let Some(distance) = view.distance() else {
        return Ok((session.mesh().clone(), session.provenance().vertices.clone()));
    };
    let stored = session.mesh().counts().vertices;
    let fixed = &session.apply(Weld::within(distance))?.fixed;
    let names = if fixed.is_empty() { Sources::same(stored) } else { kept(stored, fixed) };
    Ok((session.mesh().clone(), names))
}

/// Of so many vertices those that a weld kept: each class has the place of its lowest vertex, whether a face uses that or not.
fn kept(stored: usize, fixed: &Fixed) -> Sources<VertexId> {
    let mut joined = fixed.joined_vertices().map(|(vertex, _)| vertex).peekable();
    let kept = (0..stored).map(VertexId::new).filter(|vertex| joined.next_if_eq(vertex).is_none());
    Sources::listed(kept.map(Some))
}

impl CheckReport {
    /// The report with answers about where the faces of its mesh lie.
    ///
    /// # Errors
    /// As [`GeometryReport::of`].
    ///
    /// *Cost*: that of [`GeometryReport::of`].
    pub fn with_geometry(self, asked: &GeometryOptions, watch: &Watch) -> Result<Self, PassError> {
        let geometry = Some(GeometryReport::of(&self.mesh, asked, watch)?);
        Ok(CheckReport { geometry, ..self })
    }

    /// The report on a mesh as stored whose topology is known already, as it is after a repair.
    ///
    /// # Errors
    /// When whoever watches stops it.
    ///
    /// *Cost*: an exact weld, and what other rules than meshmend's own take.
    pub fn of_topology(
        mesh: PolygonMesh,
        topology: TopologyReport,
        rules: Rules,
        watch: &Watch,
    ) -> Result<Self, Cancelled> {
        let vertices = Sources::same(mesh.counts().vertices);
        Self::new(
            View::Indexed,
            StoredCounts::of(&mesh),
            (mesh, vertices),
            topology,
            (rules, Kernels::builtin()),
            watch,
        )
    }

    fn new(
        view: View,
        stored: StoredCounts,
        (mesh, vertex_sources): (PolygonMesh, Sources<VertexId>),
        topology: TopologyReport,
        (rules, kernels): (Rules, Kernels),
        watch: &Watch,
    ) -> Result<Self, Cancelled> {
        const STEP: &str = "report";
        let (mut coincident, mut joined_in_single, mut apart_in_pose) = (Vec::new(), 0, 0);
        if matches!(view, View::Indexed | View::Welded(Distance::Exact)) {
            let found = Coincidence::of_mesh(&mesh, || watch.look(STEP, 0, 0))?;
            let Coincidence { exactly, only_in_single } = found;
            let joined = |lowest: &[VertexId]| {
                lowest.iter().enumerate().filter(|(v, low)| low.0 as usize != *v).count()
            };
            let at_one_position = joined(&exactly);
            let in_one_pose = equal_in_pose(&mesh, exactly);
            apart_in_pose = (at_one_position - joined(&in_one_pose)) as u64;
            let joined = (0..).map(VertexId).zip(in_one_pose).filter(|(vertex, lowest)| vertex != lowest);
            coincident.extend(joined.filter(|_| view == View::Indexed));
            joined_in_single = only_in_single as u64;
        }
        watch.look(STEP, 0, 0)?;
        let face_sources = Sources::same(mesh.counts().faces);
        let own = rules.own().map(|kind| (kind, found_in(&mesh, kind))).collect();
        let mut report = CheckReport {
            view,
            stored,
            mesh,
            vertex_sources,
            face_sources,
            topology,
            kernels: Vec::new(),
            joined_in_single,
            apart_in_pose,
            coincident,
            shared: Vec::new(),
            rules,
            asked: Vec::new(),
            own,
            geometry: None,
        };
        let count = |kind| report.count(kind) as u64;
        report.kernels = kernels.all().map(|kernel| KernelVerdict::of(kernel, count)).collect();
        Ok(report)
    }

    /// The report with these kinds listed where they occur, also those that are not listed unasked.
    #[must_use]
    pub fn listing(self, kinds: &[DefectKind]) -> Self {
        CheckReport { asked: kinds.to_vec(), ..self }
    }

    /// Whether nothing is wrong: no defect of any kind but notes.
    pub fn is_sound(&self) -> bool {
        is_sound(self.rules, |kind| self.count(kind) as u64)
    }

    /// How many defects of a kind there are; 0 for the kinds that only a repair finds.
    ///
    /// *Cost*: constant, or for kinds that are [found in the mesh](Found::InMesh) that of finding them.
    pub fn count(&self, kind: DefectKind) -> usize {
        match (kind, kind.rule().found) {
            (DefectKind::Own(_), _) => self.defects_of_kind(kind).count(),
            (_, Found::InSurvey) => self.topology.defects.count(kind) - self.left_out(kind).len(),
            (_, Found::ByWelding) => self.coincident.len(),
            (_, Found::ByGeometry) => self.geometry.as_ref().map_or(0, |found| found.count(kind)),
            _ => self.defects_of_kind(kind).count(),
        }
    }

    /// Counts these edges, given by their ends, no longer as boundary: other parts use them too.
    pub(crate) fn leave_out(&mut self, shared: &[[VertexId; 2]]) {
        self.shared = shared.to_vec();
    }

    /// The ends of edges that are not counted in a kind.
    fn left_out(&self, kind: DefectKind) -> &[[VertexId; 2]] {
        if kind == DefectKind::BoundaryEdge { &self.shared } else { &[] }
    }

    /// The defects of a kind, by ascending id.
    pub fn defects_of_kind(&self, kind: DefectKind) -> Defects<'_> {
        let rule = kind.rule();
        if let DefectKind::Own(_) = kind {
            let found = self.own.iter().filter(move |(own, _)| *own == kind);
            return Box::new(found.flat_map(|(_, defects)| defects.iter().cloned()));
        }
        match (rule.found, rule.listed) {
            (_, Listed::AlreadyBy(other)) if self.count(other) == 0 => Box::new(iter::empty()),
            (Found::InSurvey, _) => {
                let left_out = self.left_out(kind);
                let defects = self.topology.defects.of_kind(kind);
                Box::new(defects.filter(move |defect| !is_at(defect, left_out)))
            }
            (Found::InMesh(find), _) => find(&self.mesh),
            (Found::ByWelding, _) => {
                let pairs = self.coincident.iter();
                Box::new(pairs.map(|&(vertex, original)| Defect::coincident_vertex(vertex, original)))
            }
            (Found::ByGeometry, _) => match &self.geometry {
                Some(found) => found.defects(kind, &self.mesh),
                None => Box::new(iter::empty()),
            },
            _ => Box::new(iter::empty()),
        }
    }

    /// The kinds that occur and that a report lists, in order.
    pub fn listed_kinds(&self) -> impl Iterator<Item = DefectKind> + '_ {
        listed_kinds(self.rules, &self.asked, |kind| self.count(kind) as u64)
    }

    /// The vertex as stored that a vertex of the mesh is.
    pub fn stored_vertex(&self, vertex: VertexId) -> VertexId {
        self.vertex_sources.of(vertex).unwrap_or(vertex)
    }

    /// The face as stored that a face of the mesh is.
    pub fn stored_face(&self, face: FaceId) -> FaceId {
        self.face_sources.of(face).unwrap_or(face)
    }
}

/// Whether nothing is wrong, by how many defects of each kind there are.
pub(crate) fn is_sound(rules: Rules, count: impl Fn(DefectKind) -> u64) -> bool {
    let mut wrong = rules.kinds().filter(|kind| kind.severity() == Severity::Defect);
    wrong.all(|kind| count(kind) == 0)
}

/// The kinds that occur and that a report lists, in order; some because they were asked for.
pub(crate) fn listed_kinds<'a>(
    rules: Rules,
    asked: &'a [DefectKind],
    count: impl Fn(DefectKind) -> u64 + 'a,
) -> impl Iterator<Item = DefectKind> + 'a {
    let unasked = |kind: &DefectKind| !matches!(kind.rule().listed, Listed::OnRequest | Listed::AlreadyBy(_));
    let is_listed = move |kind: &DefectKind| unasked(kind) || asked.contains(kind);
    rules.kinds().filter(is_listed).filter(move |&kind| count(kind) > 0)
}

impl KernelVerdict {
    /// Whether a kernel holds a mesh with so many defects of each kind.
    pub(crate) fn of(kernel: AnyKernel, count: impl Fn(DefectKind) -> u64) -> Self {
        let counts = kernel.capabilities.refused_kinds().map(|kind| (kind, count(kind)));
        let refusals: BTreeMap<DefectKind, u64> = counts.filter(|&(_, count)| count > 0).collect();
        KernelVerdict { name: kernel.name, holds: refusals.is_empty(), refusals }
    }
}

/// Whether a defect is at an edge with one of these pairs of ends.
fn is_at(defect: &Defect, pairs: &[[VertexId; 2]]) -> bool {
    !pairs.is_empty()
        && defect
            .at
            .ends()
            .is_some_and(|[one, other]| pairs.binary_search(&[one.min(other), one.max(other)]).is_ok())
}

/// What the rule of a kind finds in a mesh.
fn found_in(mesh: &PolygonMesh, kind: DefectKind) -> Vec<Defect> {
    match kind.rule().found {
        Found::InMesh(find) => find(mesh).collect(),
        _ => Vec::new(),
    }
}

impl StoredCounts {
    /// The counts of a mesh.
    pub fn of(mesh: &PolygonMesh) -> Self {
        StoredCounts {
            vertices: mesh.counts().vertices,
            faces: mesh.counts().faces,
            loose_edges: mesh.loose_edges().len(),
            loose_points: mesh.loose_points().len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Element, FaceId, FaceTableBuilder, Rule, admission};
    use meshmend_kernels::KernelKind;

    use super::*;

    fn mesh(positions: &[[f64; 3]], faces: &[&[u32]]) -> PolygonMesh {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        let table = builder.build(positions.len()).unwrap();
        PolygonMesh::new(positions.to_vec(), table).unwrap()
    }

    fn spread(count: usize) -> Vec<[f64; 3]> {
        (0..count).map(|i| [i as f64, (i * i) as f64, 0.0]).collect()
    }

    #[test]
    fn the_verdicts_are_those_of_admission() {
        let faces: &[&[u32]] = &[
            &[0, 1, 2],
            &[1, 2, 0],
            &[2, 1, 3],
            &[3, 4],
            &[5, 6, 7, 5, 8, 9],
            &[10, 11, 12, 13],
            &[10, 11, 14],
            &[14, 15, 16],
        ];
        let mesh = mesh(&spread(17), faces);
        let report = check(&mesh, &CheckOptions::default()).unwrap();
        assert_eq!(report.kernels.len(), KernelKind::ALL.len());
        for (verdict, kernel) in report.kernels.iter().zip(KernelKind::ALL) {
            let mut expected = BTreeMap::new();
            for defect in admission(mesh.complex(), &kernel.capabilities()) {
                *expected.entry(defect.kind()).or_insert(0) += 1;
            }
            assert_eq!(verdict.refusals, expected, "{kernel}");
            assert_eq!(verdict.holds, expected.is_empty());
        }
    }

    #[test]
    fn a_view_decides_what_is_one_vertex() {
        let apart = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0; 3]];
        let mesh = mesh(&apart, &[&[0, 1, 2], &[3, 5, 4]]);
        let indexed = check(&mesh, &CheckOptions::default()).unwrap();
        assert_eq!((indexed.topology.components, indexed.count(DefectKind::CoincidentVertex)), (2, 2));
        let view = View::Welded(Distance::Exact);
        let welded = check(&mesh, &CheckOptions { view, ..CheckOptions::default() }).unwrap();
        assert_eq!((welded.topology.components, welded.count(DefectKind::CoincidentVertex)), (1, 0));
        assert_eq!((welded.stored.vertices, welded.topology.vertices), (6, 4));
        let stored: Vec<u32> = (0..4).map(|v| welded.stored_vertex(VertexId(v)).0).collect();
        assert_eq!(stored, [0, 1, 2, 5]);
        let view = View::Welded(Distance::Absolute(f64::NAN));
        assert!(matches!(
            check(&mesh, &CheckOptions { view, ..CheckOptions::default() }),
            Err(PassError::Request { .. })
        ));
    }

    #[test]
    fn of_vertices_that_are_one_the_lowest_is_named_also_where_no_face_uses_it() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [-0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = mesh(&points, &[&[1, 3, 2]]);
        let options = CheckOptions::default().with_view(View::Welded(Distance::Exact));
        let report = check(&mesh, &options).unwrap();
        assert_eq!([0, 1, 2].map(|v| report.stored_vertex(VertexId(v))), [0, 1, 3].map(VertexId));
        assert_eq!(report.mesh.position(VertexId(0)).map(f64::to_bits), [0; 3]);
    }

    #[test]
    fn what_single_precision_would_join_is_counted_beyond_what_is_equal() {
        let x = 548_123.41;
        let noisy = [[x, 0.0, 0.0], [1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 0.0], [x + 1e-5, 0.0, 0.0]];
        let mesh = mesh(&noisy, &[&[0, 1, 2], &[3, 2, 1], &[4, 2, 1]]);
        let count = |view| check(&mesh, &CheckOptions { view, ..CheckOptions::default() }).unwrap();
        let indexed = count(View::Indexed);
        assert_eq!((indexed.joined_in_single, indexed.count(DefectKind::CoincidentVertex)), (1, 1));
        let exact = count(View::Welded(Distance::Exact));
        assert_eq!((exact.joined_in_single, exact.topology.vertices), (1, 4));
        let single = count(View::Welded(Distance::Single));
        assert_eq!((single.joined_in_single, single.topology.vertices), (0, 3));
    }

    #[test]
    fn notes_alone_leave_a_mesh_sound() {
        let mut report = check(&mesh(&spread(4), &[&[0, 1, 2]]), &CheckOptions::default()).unwrap();
        assert!(report.is_sound());
        let kinds: Vec<_> = report.listed_kinds().collect();
        assert_eq!(kinds, [DefectKind::BoundaryEdge, DefectKind::UnreferencedVertex]);
        let infinite = [[0.0; 3], [1.0, f64::NAN, 0.0], [0.0, 1.0, 0.0]];
        report = check(&mesh(&infinite, &[&[0, 1, 2]]), &CheckOptions::default()).unwrap();
        assert!(!report.is_sound());
        let faces: Vec<_> = report.defects_of_kind(DefectKind::NonFiniteFace).collect();
        assert_eq!(faces, [Defect::non_finite_face(FaceId(0), VertexId(1))]);
        assert_eq!(report.count(DefectKind::NonFiniteFace), 1);
        report = check(&mesh(&spread(4), &[&[0, 1, 2, 3]]), &CheckOptions::default()).unwrap();
        assert!(report.is_sound());
        let faces: Vec<_> = report.defects_of_kind(DefectKind::PolygonFace).collect();
        assert_eq!(faces, [Defect::polygon_face(FaceId(0), 4)]);
    }

    #[test]
    fn what_is_not_listed_unasked_is_listed_where_it_is_asked_for() {
        let quad = mesh(&spread(4), &[&[0, 1, 2, 3]]);
        let asked = [DefectKind::PolygonFace, DefectKind::LooseEdge];
        let report = check(&quad, &CheckOptions::default()).unwrap();
        assert!(!report.listed_kinds().any(|kind| kind == DefectKind::PolygonFace));
        let kinds: Vec<_> = report.listing(&asked).listed_kinds().collect();
        assert_eq!(kinds, [DefectKind::PolygonFace, DefectKind::BoundaryEdge]);
    }

    #[test]
    fn a_rule_of_ones_own_is_found_counted_and_fails_a_check() {
        const EVEN: Rule = Rule {
            code: "even-vertex",
            title: "even vertices",
            severity: Severity::Defect,
            explanation: "The number of the vertex is even.",
            found: Found::InMesh(even),
            listed: Listed::Unasked,
            counts: None,
            sentence: "{at} is even",
        };
        fn even(mesh: &PolygonMesh) -> Defects<'_> {
            let even = (0..mesh.positions().len() as u32).step_by(2).map(VertexId);
            Box::new(even.map(|vertex| Defect::new(DefectKind::Own(&EVEN), Element::Vertex(vertex))))
        }
        const NEVER: Rule = Rule { code: "never-found", found: Found::ByWelding, ..EVEN };
        let rules = Rules::with(&[&EVEN, &NEVER]).unwrap();
        let (own, never) = (DefectKind::Own(&EVEN), DefectKind::Own(&NEVER));
        let stacked = mesh(&[[0.0; 3]; 3], &[&[0, 1, 2]]);
        let report = check(&stacked, &CheckOptions { rules, ..CheckOptions::default() }).unwrap();
        assert_eq!((report.count(own), report.count(never)), (2, 0));
        assert!(!report.is_sound());
        assert_eq!(report.listed_kinds().last(), Some(own));
        let report = check(&stacked, &CheckOptions::default()).unwrap();
        assert!(report.is_sound());
        assert_eq!(report.count(own), 0);
    }

    #[test]
    fn a_strict_kernel_refuses_to_check_what_it_cant_hold() {
        let fan = mesh(&spread(5), &[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]);
        let options = CheckOptions { kernel: KernelKind::HalfEdge.into(), ..CheckOptions::default() };
        assert!(matches!(check(&fan, &options), Err(PassError::Refused(_))));
    }
}
