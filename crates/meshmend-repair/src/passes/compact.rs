//! Removes what no face uses, and names it.
//!
//! *Why*: unreferenced vertices change bounding boxes and counts, and exporters write loose edges and points as elements
//! that were not asked for.
//!
//! A mesh without a face as stored is a point cloud or a set of lines. These are its content, and all of it stays.
//!
//! 1. Loose edges and points go (policy: remove or keep, each).
//! 2. Vertices that no face and no kept loose element uses go; the others keep their order.
//!
//! *Promises* no unreferenced vertex but those of kept loose elements, if there is a face as stored. *Requires* that degenerate
//! faces are gone, as their vertices stay with them. *May introduce* no defect. *Cost*: linear.

use meshmend_core::{Defect, DefectKind, Draft, Id, Loose, PolygonMesh, Sources, VertexId};
use serde::{Deserialize, Serialize};

use crate::{
    Context, Form, History, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word,
};

/// Removes what no face uses, and names it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Compact {
    /// What happens to edges that are elements of their own.
    pub loose_edges: LooseElements,
    /// What happens to points that are elements of their own.
    pub loose_points: LooseElements,
}

/// What happens to elements that belong to no face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LooseElements {
    /// They are removed and named.
    #[default]
    Remove,
    /// They are kept, and so are their vertices.
    Keep,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "compact",
    explanation: "Removes unreferenced vertices, loose edges and loose points, keeps the order of the rest, and lists what \
                  went.",
    is_default: true,
    before: None,
    options: &[PassOption {
        name: "compact",
        help: "What happens to vertices, edges and points that no face uses",
        sets: &["loose-edges", "loose-points"],
        values: OptionValues::Words(&[
            Word::standing_for("on", "remove", "Remove them, and say which"),
            Word::standing_for(
                "keep-loose",
                "keep",
                "Keep loose edges and points with their vertices; remove other vertices",
            ),
        ]),
    }],
    form: Form::of::<Compact>(),
};

impl Pass for Compact {
    fn kind(&self) -> PassKind {
        PassKind::Compact
    }
    fn removes(&self) -> &'static [DefectKind] {
        use DefectKind::{LooseEdge, LoosePoint, UnreferencedVertex};
        match (self.loose_edges, self.loose_points) {
            (LooseElements::Remove, LooseElements::Remove) => &[UnreferencedVertex, LooseEdge, LoosePoint],
            (LooseElements::Remove, LooseElements::Keep) => &[LooseEdge],
            (LooseElements::Keep, LooseElements::Remove) => &[LoosePoint],
            (LooseElements::Keep, LooseElements::Keep) => &[],
        }
    }
    fn requires(&self) -> &'static [DefectKind] {
        // The vertices of a degenerate face stay with it, though no face of the complex uses them.
        &[DefectKind::DegenerateFace]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let stored = context.history.map_or(mesh, History::stored);
        if stored.counts().faces == 0 {
            return Ok(Outcome::unchanged(mesh));
        }
        let drop_loose = Loose {
            edges: self.loose_edges == LooseElements::Remove,
            points: self.loose_points == LooseElements::Remove,
        };
        let is_kept = used_vertices(mesh, drop_loose);
        let fixed = removed(mesh, &is_kept, drop_loose);
        if fixed.is_empty() {
            return Ok(Outcome::unchanged(mesh));
        }
        Ok(Outcome::changed(mesh.rebuild(draft(mesh, &is_kept, drop_loose)?)?, fixed))
    }
}

/// For each vertex whether a face or a kept loose element uses it.
fn used_vertices(mesh: &PolygonMesh, drop_loose: Loose) -> Vec<bool> {
    let mut is_used = vec![false; mesh.counts().vertices];
    let mut mark = |v: &VertexId| is_used[v.index()] = true;
    mesh.faces().corner_vertices().iter().for_each(&mut mark);
    if !drop_loose.edges {
        mesh.loose_edges().iter().flatten().for_each(&mut mark);
    }
    if !drop_loose.points {
        mesh.loose_points().iter().for_each(&mut mark);
    }
    is_used
}

/// What goes, by kind and id.
fn removed(mesh: &PolygonMesh, is_used: &[bool], drop_loose: Loose) -> Vec<Defect> {
    let unused = is_used.iter().enumerate().filter(|(_, used)| !**used);
    let mut removed: Vec<Defect> =
        unused.map(|(v, _)| Defect::unreferenced_vertex(VertexId::new(v))).collect();
    if drop_loose.edges {
        let edges = mesh.loose_edges().iter().zip(0..);
        removed.extend(edges.map(|(&ends, index)| Defect::loose_edge(index, ends)));
    }
    if drop_loose.points {
        let points = mesh.loose_points().iter().zip(0..);
        removed.extend(points.map(|(&vertex, index)| Defect::loose_point(index, vertex)));
    }
    removed
}

fn draft(mesh: &PolygonMesh, is_kept: &[bool], drop_loose: Loose) -> Result<Draft, PassError> {
    let mut new_id = vec![VertexId(0); is_kept.len()];
    let mut sources = Vec::new();
    for (v, _) in is_kept.iter().enumerate().filter(|(_, kept)| **kept) {
        new_id[v] = VertexId::new(sources.len());
        sources.push(Some(VertexId::new(v)));
    }
    let old = mesh.faces();
    let corners = old.corner_vertices().iter().map(|v| new_id[v.index()]).collect();
    let faces = old.over(sources.len(), corners)?;
    let (face_sources, corner_sources) = (Sources::same(old.face_count()), Sources::same(old.corner_count()));
    Ok(Draft {
        vertex_sources: Sources::listed(sources),
        drop_loose,
        ..Draft::of_faces(mesh, faces, face_sources, corner_sources)
    })
}
