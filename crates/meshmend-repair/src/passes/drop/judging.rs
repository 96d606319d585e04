//! Which faces go.

use meshmend_core::{Defect, DefectKind, FaceId, PolygonMesh, Watch};
use meshmend_geometry::vector::{cross, length, minus};
use meshmend_spatial::{
    Budget, InternalFaces, IntersectionOptions, Nesting, Surface, internal_faces, intersections, nesting,
};

use super::{DropParts, DroppedComponent, Internal, ROW, SmallComponents};
use crate::PassError;
use crate::fates::Fates;

/// What is to go of a mesh.
pub(super) struct Judged {
    pub(super) fates: Fates,
    /// The faces that go, ascending.
    pub(super) going: Vec<Going>,
    /// The components that go as a whole.
    pub(super) components: Vec<DroppedComponent>,
    /// How many faces stay of which it can't be said whether they are internal.
    pub(super) mixed: usize,
}

/// A face that goes, with the reason.
#[derive(Clone, Copy)]
pub(super) struct Going {
    pub(super) face: FaceId,
    reason: DefectKind,
    component_faces: u32,
}

impl Going {
    /// The reason as a defect of the face, which has this id.
    pub(super) fn defect(&self, face: FaceId) -> Defect {
        match self.reason {
            DefectKind::InternalFace => Defect::internal_face(face),
            _ => Defect::small_component(face, self.component_faces),
        }
    }
}

/// What is to go of a mesh as it is.
pub(super) fn judged(options: &DropParts, mesh: &PolygonMesh, watch: &Watch) -> Result<Judged, PassError> {
    let surface = Surface::watched(mesh, watch)?;
    let nesting = nesting(&surface)?;
    let inside = match options.internal {
        Internal::Keep => InternalFaces::default(),
        Internal::RemoveComponents | Internal::RemoveFaces => {
            let all = IntersectionOptions { budget: Budget::Tests(u64::MAX), limit: 0 };
            internal_faces(&surface, &intersections(&surface, all)?, &nesting)?.unwrap_or_default()
        }
    };
    let is_inside = inside.whole_components(&nesting);
    watch.look(ROW.name, 0, 0)?;
    let areas = areas(&surface, &nesting);
    watch.look(ROW.name, 0, 0)?;
    let reason = |at: usize| {
        let component = &nesting.components[at];
        if is_inside[at] {
            return Some(DefectKind::InternalFace);
        }
        let is_small = match options.components {
            SmallComponents::Keep => false,
            SmallComponents::Faces(limit) => component.faces < limit,
            SmallComponents::Area(limit) => areas[at] < limit,
            SmallComponents::Volume(limit) => component.volume.is_some_and(|volume| volume.abs() < limit),
        };
        is_small.then_some(DefectKind::SmallComponent)
    };
    let reasons: Vec<Option<DefectKind>> = (0..nesting.components.len()).map(reason).collect();
    let whole = |face: FaceId| {
        nesting.component_of(face).and_then(|at| Some((reasons[at]?, nesting.components[at].faces)))
    };
    let is_single = |face: &FaceId| {
        options.internal == Internal::RemoveFaces && inside.internal.binary_search(face).is_ok()
    };
    let mut fates = Fates::unchanged(mesh.counts().faces);
    let mut going = Vec::new();
    for face in mesh.faces().faces() {
        let single = || is_single(&face).then_some((DefectKind::InternalFace, 1));
        if let Some((reason, component_faces)) = whole(face).or_else(single) {
            fates.remove(face);
            going.push(Going { face, reason, component_faces });
        }
    }
    watch.look(ROW.name, 0, 0)?;
    let components = dropped(&nesting, &areas, &reasons);
    let mixed = inside.mixed.iter().filter(|&&face| fates.stays(face)).count();
    Ok(Judged { fates, going, components, mixed })
}

/// The components that go as a whole.
fn dropped(nesting: &Nesting, areas: &[f64], reasons: &[Option<DefectKind>]) -> Vec<DroppedComponent> {
    let all = nesting.components.iter().zip(areas).zip(reasons);
    let record = all.filter_map(|((component, &area), reason)| {
        let (lowest_face, faces, volume) = (component.lowest_face, component.faces, component.volume);
        Some(DroppedComponent { lowest_face, faces, area, volume, reason: (*reason)? })
    });
    record.collect()
}

/// The area of each component, in doubles, faces in order.
fn areas(surface: &Surface<'_>, nesting: &Nesting) -> Vec<f64> {
    let mut areas = vec![0.0; nesting.components.len()];
    for face in surface.mesh().faces().faces() {
        let Some(at) = nesting.component_of(face) else { continue };
        for triangle in surface.triangles_of(face) {
            let [a, b, c] = surface.points(triangle);
            areas[at] += length(cross(minus(b, a), minus(c, a))) / 2.0;
        }
    }
    areas
}

/// How many edges keep one side of several once faces go.
pub(super) fn opened_edges(mesh: &PolygonMesh, fates: &Fates) -> usize {
    let (edges, faces) = (mesh.complex().edges(), mesh.complex().faces());
    let is_opened = |&edge: &_| {
        let corners = edges.edge_corners(edge);
        let count = corners.len();
        count > 1 && corners.filter(|&corner| fates.stays(faces.corner_face(corner))).count() == 1
    };
    edges.edges().filter(is_opened).count()
}
