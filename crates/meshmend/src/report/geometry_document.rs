//! What a check says about where the faces lie.

use std::collections::BTreeMap;

use meshmend_core::{FaceId, VertexId};
use meshmend_spatial::{
    Contact, FacePair, Intersections, LoopKind, NestedComponent, NoSide, NoSpace, OpenLoop, Sliver, TJunction,
};
use serde::Serialize;

use super::Listing;
use crate::CheckReport;

/// A vertex, the ends of an edge on which it lies, how far it is from it, and whether it is aligned with it.
type TJunctionRow = (VertexId, VertexId, VertexId, f64, bool);

/// The answers about where the faces lie; what was not asked is absent. Every list is cut to a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GeometryDocument {
    /// Which faces cross or touch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intersections: Option<IntersectionsDocument>,
    /// The vertices on edges: vertex, the two ends, distance, and whether they are aligned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub t_junctions: Option<Listing<TJunctionRow>>,
    /// The boundary loops.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loops: Option<Vec<OpenLoopDocument>>,
    /// How many loops there are in all, by what they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loop_counts: Option<LoopCounts>,
    /// The components.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub components: Option<Vec<ComponentDocument>>,
    /// How many components there are in all, by their state, or why they have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub state_counts: Option<BTreeMap<&'static str, u64>>,
    /// The faces that are inside of what closed components enclose on both sides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub internal_faces: Option<Vec<FaceId>>,
    /// The faces of which that can't be said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mixed_faces: Option<Vec<FaceId>>,
    /// The faces without area.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zero_area_faces: Option<Vec<FaceId>>,
    /// The slivers: face, `needle` or `cap`, and how many times its height it is long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slivers: Option<Vec<(FaceId, &'static str, f64)>>,
}

/// The faces that cross or touch. Figures are null where the search stopped at its budget.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct IntersectionsDocument {
    /// The pairs: two faces, the contact, and whether they lie in one plane there.
    pub pairs: Vec<(FaceId, FaceId, &'static str, bool)>,
    /// For each pair that crosses or overlaps a point of both, within rounding.
    pub points: Vec<Option<[f64; 3]>>,
    /// How many pairs there are of each contact.
    pub counts: Option<ContactCounts>,
    /// The pairs of coincident faces.
    pub coincident: Option<u64>,
    /// The pairs that pass through one another.
    pub crossing: Option<u64>,
    /// The pairs that overlap in one plane.
    pub overlapping: Option<u64>,
    /// The faces in such pairs.
    pub crossing_faces: Option<u64>,
    /// The classes of faces that such pairs join.
    pub clusters: Option<u64>,
    /// The faces whose own surface crosses itself.
    pub self_crossing_faces: Vec<FaceId>,
    /// The last face that was compared with all others, where the search stopped at its budget.
    pub complete_to: Option<FaceId>,
}

/// How many pairs of faces there are of each contact.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs, reason = "each is a contact")]
pub struct ContactCounts {
    pub face_face: u64,
    pub edge_face: u64,
    pub edge_edge: u64,
    pub vertex_face: u64,
    pub vertex_edge: u64,
}

/// How many boundary loops there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct LoopCounts {
    /// Openings.
    pub holes: u64,
    /// Outer borders of sheets.
    pub rims: u64,
    /// Loops of faces that have no side.
    pub undecided: u64,
}

/// A boundary loop.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OpenLoopDocument {
    /// Its lowest vertex.
    pub first_vertex: VertexId,
    /// How many edges it has.
    pub edges: u64,
    /// Its length.
    pub length: f64,
    /// The length of its area vector; null where its faces have no side.
    pub area: Option<f64>,
    /// What part of its component's area faces as it does; null where its faces have no side.
    pub turned: Option<f64>,
    /// Whether it is the outer border of a sheet; null where its faces have no side.
    pub rim: Option<bool>,
    /// Why its faces have no side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
}

/// A component, with its place among the others.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[allow(missing_docs, reason = "as in the report on nesting")]
pub struct ComponentDocument {
    pub lowest_face: FaceId,
    pub faces: u32,
    pub closed: bool,
    pub oriented: bool,
    pub depth: Option<u32>,
    pub state: Option<&'static str>,
    pub volume: Option<f64>,
    /// Why it has no state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
}

impl GeometryDocument {
    /// The document of a report, if it was asked about geometry, with at most `limit` items in each list.
    pub fn of(report: &CheckReport, limit: usize) -> Option<Self> {
        let found = report.geometry.as_ref()?;
        let names = Names { report, limit };
        let components = found.nesting.as_ref().map(|nesting| &nesting.components);
        Some(GeometryDocument {
            intersections: found.intersections.as_ref().map(|found| names.intersections(found)),
            t_junctions: found
                .t_junctions
                .as_ref()
                .map(|found| Listing::cut(found.iter().map(|junction| names.t_junction(junction)), limit)),
            loops: found.loops.as_ref().map(|loops| names.cut(loops, |item| names.boundary(item))),
            loop_counts: found.loops.as_deref().map(loop_counts),
            state_counts: components.map(|all| state_counts(all)),
            components: components.map(|all| names.cut(all, |component| names.component(component))),
            internal_faces: found.internal.as_ref().map(|found| names.faces(&found.internal)),
            mixed_faces: found.internal.as_ref().map(|found| names.faces(&found.mixed)),
            zero_area_faces: found.shapes.as_ref().map(|shapes| names.faces(&shapes.zero_area)),
            slivers: found
                .shapes
                .as_ref()
                .map(|shapes| names.cut(&shapes.slivers, |sliver| names.sliver(sliver))),
        })
    }
}

fn loop_counts(loops: &[OpenLoop]) -> LoopCounts {
    let mut counts = LoopCounts::default();
    for item in loops {
        *match item.kind {
            LoopKind::Hole => &mut counts.holes,
            LoopKind::Rim => &mut counts.rims,
            LoopKind::Undecided(_) => &mut counts.undecided,
        } += 1;
    }
    counts
}

fn state_counts(components: &[NestedComponent]) -> BTreeMap<&'static str, u64> {
    let mut counts = BTreeMap::new();
    for component in components {
        let state = component.state.map(|state| state.name());
        let reason = || component.reason.as_ref().map(why_no_state);
        *counts.entry(state.or_else(reason).unwrap_or("open")).or_default() += 1;
    }
    counts
}

fn why_no_state(reason: &NoSpace) -> &'static str {
    match reason {
        NoSpace::NotFinite(_) => "not-finite",
        NoSpace::NonManifold(_) => "non-manifold",
        NoSpace::Open(_) => "open",
        NoSpace::NoSurface(_) => "no-surface",
        NoSpace::Inconsistent(_) => "inconsistent",
    }
}

/// Elements by the numbers that they have as stored.
struct Names<'a> {
    report: &'a CheckReport,
    limit: usize,
}

impl Names<'_> {
    fn cut<T, D>(&self, all: &[T], document: impl Fn(&T) -> D) -> Vec<D> {
        all.iter().take(self.limit).map(document).collect()
    }

    fn face(&self, face: FaceId) -> FaceId {
        self.report.stored_face(face)
    }

    fn intersections(&self, found: &Intersections) -> IntersectionsDocument {
        let figures = found.figures.as_ref();
        let pair = |pair: &FacePair| {
            let [one, other] = pair.faces.map(|face| self.face(face));
            (one, other, pair.contact.name(), pair.is_coplanar)
        };
        IntersectionsDocument {
            pairs: self.cut(&found.pairs, pair),
            points: self.cut(&found.pairs, |pair| pair.point),
            counts: figures.map(|figures| ContactCounts {
                face_face: figures.count(Contact::FaceFace),
                edge_face: figures.count(Contact::EdgeFace),
                edge_edge: figures.count(Contact::EdgeEdge),
                vertex_face: figures.count(Contact::VertexFace),
                vertex_edge: figures.count(Contact::VertexEdge),
            }),
            coincident: figures.map(|figures| figures.count(Contact::Coincident)),
            crossing: figures.map(|figures| figures.crossing),
            overlapping: figures.map(|figures| figures.overlapping),
            crossing_faces: figures.map(|figures| figures.crossing_faces as u64),
            clusters: figures.map(|figures| figures.clusters as u64),
            self_crossing_faces: self.faces(&found.self_crossing),
            complete_to: found.complete_to.map(|face| self.face(face)),
        }
    }

    fn t_junction(&self, junction: &TJunction) -> (VertexId, VertexId, VertexId, f64, bool) {
        let [vertex, from, to] = [junction.vertex, junction.ends[0], junction.ends[1]]
            .map(|vertex| self.report.stored_vertex(vertex));
        (vertex, from, to, junction.distance, junction.is_aligned)
    }

    fn boundary(&self, item: &OpenLoop) -> OpenLoopDocument {
        let reason = match item.kind {
            LoopKind::Undecided(reason) => Some(reason),
            LoopKind::Rim | LoopKind::Hole => None,
        };
        let figure = |figure: f64| reason.is_none().then_some(figure);
        let first = item.vertices.first().copied().unwrap_or(VertexId(0));
        OpenLoopDocument {
            first_vertex: self.report.stored_vertex(first),
            edges: item.vertices.len() as u64,
            length: item.length,
            area: figure(item.area),
            turned: figure(item.turned),
            rim: reason.is_none().then_some(item.kind == LoopKind::Rim),
            reason: reason.map(|reason| match reason {
                NoSide::NotFinite => "not-finite",
                NoSide::NonManifold => "non-manifold",
                NoSide::Inconsistent => "inconsistent",
            }),
        }
    }

    fn component(&self, component: &NestedComponent) -> ComponentDocument {
        ComponentDocument {
            lowest_face: self.face(component.lowest_face),
            faces: component.faces,
            closed: component.is_closed,
            oriented: component.is_oriented,
            depth: component.depth,
            state: component.state.map(|state| state.name()),
            volume: component.volume,
            reason: component.reason.as_ref().map(why_no_state),
        }
    }

    fn faces(&self, faces: &[FaceId]) -> Vec<FaceId> {
        self.cut(faces, |&face| self.face(face))
    }

    fn sliver(&self, sliver: &Sliver) -> (FaceId, &'static str, f64) {
        (self.face(sliver.face), sliver.kind.name(), sliver.aspect)
    }
}
