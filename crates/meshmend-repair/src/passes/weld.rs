//! Joins vertices that are in the same place.
//!
//! *Why*: files without shared vertices (STL) fall apart into single triangles, and exporters split vertices along
//! seams of texture or normals.
//!
//! * *Exact* (default): their positions are equal as numbers. −0 equals 0, and a position that is not finite equals none.
//! * *Single*: their positions are equal after each coordinate is rounded to single precision.
//! * *Tolerance ε*: they are in one connected component of "distance ≤ ε", so no pair within ε is missed.
//! * *Auto*: along open edges within the tolerance that stands out, if one does ([`Advice`]).
//! * *Boundary ε*: their positions are equal, or both are vertices of open edges, not farther apart than ε, and nothing is
//!   against it ([`boundary`]). This closes cracks without touching what is whole.
//!
//! Vertices that a model's motion parts are not in one place: morph targets displace them differently, or other joints
//! move them. So a closed mouth stays two lips ([`WeldBy::Pose`]).
//!
//! 1. Find the classes.
//! 2. Each class becomes its lowest vertex, whose position is kept to the bit. Attributes that differ across
//!    welded vertices move to the corners; none is averaged or dropped.
//!
//! *Promises* no coincident vertices. *Requires* nothing. *May introduce* degenerate faces, duplicates and non-manifold
//! edges and vertices. In a pipeline `orient` and `split` keep apart again what would leave the mesh non-manifold: there
//! welding is stitching and can't make a mesh worse. *Cost*: linear if exact; for a tolerance see
//! [`proximity_classes`].

use std::borrow::Cow;

use meshmend_core::{Cancelled, DefectKind, Draft, Id, PolygonMesh, Sources, VertexId};
use meshmend_geometry::coincident::{
    coincident_in_single, equal_in_pose, near_in_pose, watched_coincident_vertices,
};
use meshmend_geometry::proximity::{NoClasses, proximity_classes};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

mod at_places;
mod boundary;

use at_places::joined_at_places;
use boundary::joined_along_boundaries;
pub(crate) use boundary::{NearPair, OpenEdges};

use crate::tolerance::{no_tolerance, resolved_on, unresolved};
use crate::{
    Advice, Context, Fixed, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word,
};

/// Joins vertices that are in the same place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Weld {
    /// When two vertices are in the same place.
    pub distance: Distance,
    /// Whether vertices in the same place have to stay together when a model moves.
    pub by: WeldBy,
}

/// Whether vertices in the same place have to stay together when a model moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WeldBy {
    /// They have to: morph targets displace them alike, and the same joints move them by the same weights. A distance
    /// bounds each displacement too.
    #[default]
    Pose,
    /// They don't.
    Position,
}

/// When two vertices are in the same place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Distance {
    /// Their positions are equal as numbers.
    #[default]
    Exact,
    /// Their positions are equal after each coordinate is rounded to single precision. This is for files whose last digits
    /// are noise.
    Single,
    /// A chain of vertices joins them, each within so many units of length of the next.
    Absolute(f64),
    /// The same, in parts of a bounding box's diagonal: 0.001 is a thousandth of it. The box is that of the vertices
    /// that a face or a loose edge uses; in a mesh with neither, of all vertices.
    Relative(f64),
    /// Their positions are equal, or both are vertices of open edges within so many units of length of each other. No two
    /// vertices that are joined are farther apart, and no face loses a corner.
    Boundary(f64),
    /// The same, in parts of the box's diagonal.
    BoundaryRelative(f64),
    /// Along open edges within the tolerance that stands out in the mesh ([`Advice`]), and equal positions alone if none does.
    Auto,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "weld",
    explanation: "Joins vertices at the same position (exact), or within a tolerance, to the lowest of them; with \
                  `boundary:` and a tolerance only vertices of open edges, so that cracks close and what is whole stays. Attributes that \
                  differ across welded vertices move to the corners; none is averaged. In a pipeline orient and split keep \
                  apart again what would leave the mesh non-manifold, so that welding is stitching and can't make a mesh worse.",
    is_default: true,
    before: None,
    options: &[
        PassOption {
            name: "weld",
            help: "Which vertices are joined: none, exact, single (equal in single precision), within a length, within a \
               percentage of the bounding box's diagonal, along open edges within either (boundary:0.01, boundary:0.1%), or along \
               open edges within what stands out, if anything does (auto; `advise` tells)",
            sets: &["distance"],
            values: OptionValues::Distance,
        },
        PassOption {
            name: "weld-by",
            help: "Whether vertices that morph targets or joints move apart are joined",
            sets: &["by"],
            values: OptionValues::Words(&[
                Word::new("pose", "They are not: a closed mouth stays two lips"),
                Word::new("position", "They are"),
            ]),
        },
    ],
    form: Form::of::<Weld>(),
};

impl Pass for Weld {
    fn kind(&self) -> PassKind {
        PassKind::Weld
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::CoincidentVertex]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::DegenerateFace,
            DefectKind::NonSimpleFace,
            DefectKind::RepeatedCorner,
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
            DefectKind::NonManifoldEdge,
            DefectKind::InconsistentEdge,
            DefectKind::PinchedVertex,
            DefectKind::SingularVertex,
            DefectKind::NonOrientablePatch,
            DefectKind::BoundaryEdge,
            // The vertices of faces that become degenerate.
            DefectKind::UnreferencedVertex,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if self.distance != Distance::Auto {
            return self.join(mesh, context);
        }
        let advice = Advice::on(mesh, context.watch())?;
        let weld = Weld { distance: advice.weld(), by: self.by };
        Ok(Outcome { advice: Some(advice), ..weld.join(mesh, context)? })
    }

    /// 0 if only vertices in one place are joined, or the distance is not known yet. *Cost*: linear if it is relative, else
    /// constant.
    fn tolerance_on(&self, mesh: &PolygonMesh) -> f64 {
        self.distance.length_on(mesh)
    }
}

impl Distance {
    /// The length that it is on a mesh; 0 where only positions that are equal in some way are near.
    ///
    /// *Cost*: linear if it is relative, else constant.
    pub fn length_on(self, mesh: &PolygonMesh) -> f64 {
        match self {
            Distance::Exact | Distance::Single | Distance::Auto => 0.0,
            Distance::Absolute(epsilon) | Distance::Boundary(epsilon) => epsilon,
            Distance::Relative(part) | Distance::BoundaryRelative(part) => part * diagonal(mesh),
        }
    }
}

impl Weld {
    /// A weld of vertices within a distance; its other options are the defaults.
    pub fn within(distance: Distance) -> Self {
        Weld { distance, ..Weld::default() }
    }

    /// Joins the vertices within a distance that is known.
    fn join(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if matches!(self.distance, Distance::Exact | Distance::Auto)
            && let Some(outcome) = joined_at_places(mesh, context)?
        {
            return Ok(outcome);
        }
        let lowest = match self.distance {
            Distance::Exact | Distance::Auto => in_one_place(mesh, context)?,
            Distance::Single => coincident_in_single(mesh),
            Distance::Absolute(_) | Distance::Relative(_) => within(mesh, self.tolerance_on(mesh), context)?,
            Distance::Boundary(_) | Distance::BoundaryRelative(_) => {
                let exact = equal_in_pose_if(self.by, mesh, in_one_place(mesh, context)?);
                let epsilon = resolved_on(ROW.name, mesh, self.distance)?;
                joined_along_boundaries(mesh, exact, epsilon, context)?
            }
        };
        context.check_cancelled()?;
        let lowest = self.in_one_pose(mesh, lowest, context)?;
        context.check_cancelled()?;
        join_to(mesh, lowest, context)
    }

    /// Classes of vertices, parted where a model's motion parts them.
    fn in_one_pose(
        &self,
        mesh: &PolygonMesh,
        lowest: Vec<VertexId>,
        context: &Context<'_>,
    ) -> Result<Vec<VertexId>, PassError> {
        let epsilon = self.tolerance_on(mesh);
        match self.by {
            _ if epsilon == 0.0 => Ok(equal_in_pose_if(self.by, mesh, lowest)),
            WeldBy::Position => Ok(lowest),
            WeldBy::Pose => {
                let goes_on = || context.check_cancelled().is_ok();
                near_in_pose(mesh, lowest, epsilon, &goes_on).map_err(|reason| not_told(epsilon, reason))
            }
        }
    }
}

/// Classes of vertices in one place, parted where a model's motion parts them, if it counts.
fn equal_in_pose_if(by: WeldBy, mesh: &PolygonMesh, lowest: Vec<VertexId>) -> Vec<VertexId> {
    match by {
        WeldBy::Position => lowest,
        WeldBy::Pose => equal_in_pose(mesh, lowest),
    }
}

/// The diagonal of the box to which a relative distance refers. An unused vertex can't stretch it.
pub(crate) fn diagonal(mesh: &PolygonMesh) -> f64 {
    if mesh.faces().corner_count() == 0 && mesh.loose_edges().is_empty() {
        return meshmend_geometry::diagonal(mesh.positions());
    }
    meshmend_geometry::diagonal(&used_positions(mesh))
}

/// Classes of vertices in which those that others join are joined too. Each vertex names the lowest of its class.
fn joined_classes(mut classes: Vec<VertexId>, others: &[VertexId]) -> Vec<VertexId> {
    let lowest = |classes: &[VertexId], mut vertex: VertexId| {
        while classes[vertex.index()] != vertex {
            vertex = classes[vertex.index()];
        }
        vertex
    };
    for (at, &other) in others.iter().enumerate() {
        let (one, other) = (lowest(&classes, VertexId::new(at)), lowest(&classes, other));
        classes[one.max(other).index()] = one.min(other);
    }
    for at in 0..classes.len() {
        classes[at] = classes[classes[at].index()];
    }
    classes
}

/// The positions, with NaN for vertices that no face and no loose edge uses.
fn used_positions(mesh: &PolygonMesh) -> Cow<'_, [[f64; 3]]> {
    let mut is_used = vec![false; mesh.counts().vertices];
    let used = mesh.faces().corner_vertices().iter().chain(mesh.loose_edges().iter().flatten());
    used.for_each(|vertex| is_used[vertex.index()] = true);
    if is_used.iter().all(|&used| used) {
        return Cow::Borrowed(mesh.positions());
    }
    let position = |(point, used): (&[f64; 3], bool)| if used { *point } else { [f64::NAN; 3] };
    mesh.positions().iter().zip(is_used).map(position).collect()
}

fn within(mesh: &PolygonMesh, epsilon: f64, context: &Context<'_>) -> Result<Vec<VertexId>, PassError> {
    if epsilon == 0.0 {
        in_one_place(mesh, context)
    } else if epsilon.is_finite() && epsilon > 0.0 {
        let goes_on = || context.check_cancelled().is_ok();
        let classes = proximity_classes(mesh.positions(), epsilon, &goes_on);
        let classes = match (&classes, used_positions(mesh)) {
            // Coordinates that are too large can't resolve the distance. If no face has them, they are set aside.
            (Err(NoClasses::Unresolved { .. }), Cow::Owned(used)) => {
                let exact = in_one_place(mesh, context)?;
                proximity_classes(&used, epsilon, &goes_on).map(|classes| joined_classes(classes, &exact))
            }
            _ => classes,
        };
        classes.map_err(|reason| not_told(epsilon, reason))
    } else {
        Err(no_tolerance(ROW.name, epsilon))
    }
}

/// For each vertex the lowest one at its position.
fn in_one_place(mesh: &PolygonMesh, context: &Context<'_>) -> Result<Vec<VertexId>, PassError> {
    watched_coincident_vertices(mesh, || context.check_cancelled())
}

fn not_told(epsilon: f64, reason: NoClasses) -> PassError {
    match reason {
        NoClasses::Stopped => Cancelled.into(),
        NoClasses::Unresolved { extent } => unresolved(ROW.name, epsilon, extent),
    }
}

/// The mesh in which each vertex is replaced by the lowest one of its class.
fn join_to(mesh: &PolygonMesh, lowest: Vec<VertexId>, context: &Context<'_>) -> Result<Outcome, PassError> {
    let kept = lowest.iter().enumerate().filter(|(v, low)| low.index() == *v).count();
    if kept == lowest.len() {
        return Ok(Outcome::unchanged(mesh));
    }
    context.check_cancelled()?;
    let mut new_id = vec![VertexId(0); lowest.len()];
    let mut sources = Vec::with_capacity(kept);
    for (v, &low) in lowest.iter().enumerate() {
        new_id[v] = if low.index() == v {
            sources.push(Some(low));
            VertexId::new(sources.len() - 1)
        } else {
            new_id[low.index()]
        };
    }
    context.check_cancelled()?;
    let old = mesh.faces();
    let corners = old.corner_vertices().par_iter().map(|v| new_id[v.index()]).collect();
    let faces = old.over(sources.len(), corners)?;
    context.check_cancelled()?;
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        merged_into: Some(new_id),
        ..Draft::of_faces(mesh, faces, Sources::same(old.face_count()), Sources::same(old.corner_count()))
    };
    Ok(Outcome::changed(mesh.rebuild(draft)?, Fixed::joined(lowest)))
}

#[cfg(test)]
mod tests {
    use meshmend_core::Defect;
    use meshmend_testkit::Soup;

    use super::*;

    /// Points on a line, two of them in a face of two corners.
    fn line(xs: &[f64], faces: &[&[u32]]) -> PolygonMesh {
        let positions = xs.iter().map(|&x| [x, 0.0, 0.0]).collect();
        Soup { positions, faces: faces.iter().map(|face| face.to_vec()).collect() }.mesh()
    }

    #[test]
    fn the_box_of_a_relative_distance_is_that_of_what_is_used() {
        let xs = [0.0, 2.0, 1e6, f64::INFINITY, -7.0];
        let loose = |mesh: PolygonMesh, ends: [u32; 2]| {
            mesh.with_loose(vec![ends.map(VertexId)], vec![VertexId(2)]).unwrap()
        };
        assert_eq!(diagonal(&line(&xs, &[&[0, 1]])), 2.0, "a stray vertex");
        assert_eq!(diagonal(&line(&xs, &[&[0, 1, 3]])), 2.0, "a vertex at infinity");
        assert_eq!(diagonal(&loose(line(&xs, &[&[0, 1]]), [1, 4])), 9.0, "a loose edge, and a loose point");
        assert_eq!(diagonal(&loose(line(&xs, &[]), [0, 4])), 7.0, "a loose edge alone");
        assert_eq!(diagonal(&line(&xs, &[])), 1e6 + 7.0, "points alone");
        assert_eq!(diagonal(&line(&xs, &[&[3, 3]])), 0.0, "nothing finite is used");
        assert_eq!(diagonal(&line(&[], &[])), 0.0);
    }

    /// A unit cube's face, and a vertex a million units away that no face uses.
    #[test]
    fn a_stray_vertex_does_not_make_a_face_a_point() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1e6, 0.0]];
        let positions = corners.map(|[x, y]| [x, y, 0.0]).to_vec();
        let mesh = Soup { positions, faces: vec![vec![0, 1, 2]] }.mesh();
        let weld = Weld::within(Distance::Relative(1e-4));
        assert!(weld.apply(&mesh, &Context::default()).unwrap().fixed.is_empty());
    }

    #[test]
    fn a_stray_vertex_too_far_away_to_be_measured_is_set_aside() {
        let mesh = line(&[0.0, 1.0, 1.25, 4.0, 1e60], &[&[0, 1, 3], &[2, 3, 0]]);
        let weld = |distance| Weld::within(distance).apply(&mesh, &Context::default());
        for distance in [Distance::Relative(0.1), Distance::Absolute(0.25)] {
            let joined: Vec<_> = weld(distance).unwrap().fixed.iter().collect();
            assert_eq!(joined, [Defect::coincident_vertex(VertexId(2), VertexId(1))]);
        }
        assert!(weld(Distance::Absolute(1e-300)).is_err(), "what is used is too large for it, too");
    }
}
