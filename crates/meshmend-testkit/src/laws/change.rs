//! What must be true of any change to a mesh and of the record of it.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{
    Blend, CornerId, Defect, DefectKind, Domain, FaceId, FaceTable, Id, Layer, PolygonMesh, Provenance,
    VertexId,
};

use super::same;
use super::values::{Entry, layer_entries};

/// A mesh before and after a change, and the record of it.
#[derive(Clone, Copy, Debug)]
pub struct Change<'a> {
    /// The mesh before.
    pub before: &'a PolygonMesh,
    /// The mesh after.
    pub after: &'a PolygonMesh,
    /// Where each of its elements came from.
    pub record: &'a Provenance,
}

impl Change<'_> {
    /// The record is true: it is as long as the meshes are; what has a source has one that exists, a corner one of its
    /// face's source; a vertex that has none is named as created; and a face runs as its source does or, where it is
    /// named as flipped, the other way round.
    ///
    /// # Errors
    /// The first thing that is not so.
    pub fn record_law(&self) -> Result<(), String> {
        let (counts, record) = (self.after.counts(), self.record);
        same("the size before", "the record", record.before, self.before.counts())?;
        let listed = [record.vertices.len(), record.faces.len(), record.corners.len()];
        same("the sizes", "the record", listed, [counts.vertices, counts.faces, counts.corners])?;
        let created: Vec<VertexId> =
            record.vertices.iter().filter(|(_, old)| old.is_none()).map(|(v, _)| v).collect();
        same("the list", "created vertices", record.created.iter().map(|(v, _)| *v).collect(), created)?;
        let flipped: BTreeSet<FaceId> = record.flipped.iter().copied().collect();
        same("the order", "flipped faces", flipped.iter().copied().collect(), record.flipped.clone())?;
        if let Some((vertex, _)) = record
            .vertices
            .iter()
            .find(|(_, old)| old.is_some_and(|old| old.index() >= record.before.vertices))
        {
            return Err(format!("{vertex} comes from a vertex that is not there"));
        }
        let mut faces = self.after.faces().faces();
        faces.try_for_each(|face| self.face_is_recorded(face, flipped.contains(&face)))
    }

    /// Nothing moves: a vertex has its source's point, as numbers are equal, and a corner that of its source, or that of
    /// a vertex that its source's vertex `may_meet`; and what is created lies between the corners that the record names.
    ///
    /// # Errors
    /// The first thing that is elsewhere.
    pub fn place_law(&self, may_meet: impl Fn(VertexId, VertexId) -> bool) -> Result<(), String> {
        for (vertex, old) in self.record.vertices.iter() {
            let Some(old) = old else { continue };
            if !is_same_place(self.after.position(vertex), self.before.position(old)) {
                return Err(format!("{vertex} is not where {old} was"));
            }
        }
        for (corner, old) in self.record.corners.iter() {
            let Some(old) = old else { continue };
            let (here, there) =
                (self.after.faces().corner_vertex(corner), self.before.faces().corner_vertex(old));
            let source = self.record.vertices.of(here).unwrap_or(there);
            let stays = is_same_place(self.before.position(source), self.before.position(there));
            if !stays && !may_meet(there, source) {
                return Err(format!("{corner} went from {there} to {here}, which is {source}"));
            }
        }
        self.record.created.iter().try_for_each(|(vertex, place)| self.is_between(*vertex, *place))
    }

    /// Every vertex has its source's point to the bit.
    ///
    /// # Errors
    /// The first vertex that has not.
    pub fn bit_law(&self) -> Result<(), String> {
        let bits = |mesh: &PolygonMesh, v| mesh.position(v).map(f64::to_bits);
        let mut kept = self.record.vertices.iter().filter_map(|(vertex, old)| Some((vertex, old?)));
        kept.try_for_each(|(new, old)| same("the point", new, bits(self.after, new), bits(self.before, old)))
    }

    /// Attributes follow: every corner and every face has in each layer what its source has, whether the layer is kept
    /// by vertices or by corners.
    ///
    /// # Errors
    /// The layer and the element whose value is another.
    pub fn attribute_law(&self) -> Result<(), String> {
        same("the number", "layers", self.after.layers().len(), self.before.layers().len())?;
        for (new, old) in self.after.layers().iter().zip(self.before.layers()) {
            same("the name", "a layer", new.name(), old.name())?;
            let (new_values, old_values) = (layer_entries(new), layer_entries(old));
            if old.domain() == Domain::Face {
                for (face, source) in self.record.faces.iter().filter_map(|(f, old)| Some((f, old?))) {
                    same(new.name(), face, &new_values[face.index()], &old_values[source.index()])?;
                }
                continue;
            }
            if matches!(old.domain(), Domain::LooseEdge | Domain::LoosePoint) {
                // They stay or go together.
                let is_gone = new_values.is_empty();
                same(new.name(), "loose elements", is_gone || new_values == old_values, true)?;
                continue;
            }
            for (corner, source) in self.record.corners.iter().filter_map(|(c, old)| Some((c, old?))) {
                let found = at_corner(self.after.faces(), new, &new_values, corner);
                same(new.name(), corner, found, at_corner(self.before.faces(), old, &old_values, source))?;
            }
        }
        Ok(())
    }

    /// Nothing goes without a word: each old face of which nothing is left is named with a reason for which faces go,
    /// and no face is named that is still there.
    ///
    /// # Errors
    /// The first face that is on one list alone, or has another reason.
    pub fn removal_law(&self, named: impl IntoIterator<Item = (FaceId, DefectKind)>) -> Result<(), String> {
        let named: BTreeMap<FaceId, DefectKind> = named.into_iter().collect();
        same("the list", "removed faces", named.keys().copied().collect(), self.record.removed_faces())?;
        match named.iter().find(|(_, reason)| !REASONS_TO_GO.contains(reason)) {
            Some((face, reason)) => Err(format!("{face} is gone because of {}", reason.title())),
            None => Ok(()),
        }
    }

    /// Nothing changes without a word, in one step: what is no longer there, or there twice, or in pieces, is named
    /// among what was fixed, and so is whatever asked for a new vertex.
    ///
    /// # Errors
    /// The first element that changed and is not named.
    pub fn naming_law(&self, fixed: &[Defect]) -> Result<(), String> {
        self.naming_law_but_for(fixed, &BTreeSet::new())
    }

    /// The same, where some faces are said to have got other corners.
    ///
    /// # Errors
    /// As [`naming_law`](Self::naming_law).
    pub fn naming_law_but_for(&self, fixed: &[Defect], reshaped: &BTreeSet<FaceId>) -> Result<(), String> {
        let named = Named::of(fixed);
        let survivors = self.record.faces.survivors(self.before.counts().faces);
        let gone = |face: &FaceId| !survivors[face.index()];
        let reason = |face: &FaceId| {
            named.faces.get(face).and_then(|kinds| kinds.iter().find(|k| REASONS_TO_GO.contains(k)))
        };
        let all_gone = self.record.removed_faces();
        self.removal_law(all_gone.iter().filter_map(|face| Some((*face, *reason(face)?))))?;
        if let Some((face, _)) =
            named.faces.iter().find(|(f, kinds)| kinds.iter().any(|k| CERTAIN.contains(k)) && !gone(f))
        {
            return Err(format!("{face} is said to have gone, and is there"));
        }
        self.pieces_are_named(&named, reshaped)?;
        self.vertices_are_named(&named)?;
        let kept = |list: usize, kind| list - fixed.iter().filter(|defect| defect.kind() == kind).count();
        let edges = kept(self.before.loose_edges().len(), DefectKind::LooseEdge);
        same("the number", "loose edges", self.after.loose_edges().len(), edges)?;
        let points = kept(self.before.loose_points().len(), DefectKind::LoosePoint);
        same("the number", "loose points", self.after.loose_points().len(), points)
    }

    /// Whether the mesh after is the very value before: not a copy, and with a record of no change.
    pub fn is_none(&self) -> bool {
        self.record.is_same()
            && std::ptr::eq(self.before.faces(), self.after.faces())
            && std::ptr::eq(self.before.positions(), self.after.positions())
            && std::ptr::eq(self.before.layers(), self.after.layers())
    }
}

fn is_same_place(one: [f64; 3], other: [f64; 3]) -> bool {
    one == other || one.map(f64::to_bits) == other.map(f64::to_bits)
}

/// The kinds of defect because of which a face goes.
const REASONS_TO_GO: [DefectKind; 8] = [
    DefectKind::DegenerateFace,
    DefectKind::NonFiniteFace,
    DefectKind::DuplicateFace,
    DefectKind::OppositeFace,
    DefectKind::SmallComponent,
    DefectKind::InternalFace,
    DefectKind::SliverFace,
    DefectKind::ZeroAreaFace,
];

/// Those because of which all of it goes: of a face that falls into pieces one may be a duplicate.
const CERTAIN: [DefectKind; 2] = [DefectKind::DegenerateFace, DefectKind::NonFiniteFace];

impl Change<'_> {
    fn face_is_recorded(&self, face: FaceId, is_flipped: bool) -> Result<(), String> {
        let record = self.record;
        let Some(source) = record.faces.of(face) else { return Ok(()) };
        if source.index() >= record.before.faces {
            return Err(format!("{face} comes from {source}, which is not there"));
        }
        let range = self.before.faces().corner_range(source);
        let mut places: Vec<CornerId> = Vec::new();
        for corner in self.after.faces().face_corners(face) {
            let vertex = self.after.faces().corner_vertex(corner);
            let old = record.corners.of(corner);
            if old.is_some() && record.vertices.of(vertex).is_none() {
                return Err(format!("{corner} comes from {old:?}, but stands at {vertex}, which is created"));
            }
            if old.is_some_and(|old| !range.contains(&old.index())) {
                return Err(format!("{corner} of {face} comes from {old:?}, which is not of {source}"));
            }
            places.extend(old);
        }
        let first = places.first().copied();
        if is_flipped {
            places.reverse();
        }
        // Once round, corners ascend but for one step: the one over the end of the source.
        let descents = (0..places.len()).filter(|&i| places[i] >= places[(i + 1) % places.len()]).count();
        if descents > 1 {
            return Err(format!("{face} from {first:?} does not run as its record says: {places:?}"));
        }
        Ok(())
    }

    /// Whether a created vertex lies in the box of the corners that the record puts it between, or beside that box
    /// along one axis: where no point within is free it is moved along one.
    fn is_between(&self, vertex: VertexId, place: Option<Blend>) -> Result<(), String> {
        let (found, old) = (self.after.position(vertex), self.before.faces());
        let point = |corner: CornerId| self.before.position(old.corner_vertex(corner));
        let corners: Vec<[f64; 3]> = match place {
            None => return Ok(()),
            Some(Blend::Along { from, to, numerator, denominator }) => {
                let face = old.corner_face(from);
                same("the face", to, old.corner_face(to), face)?;
                if numerator == 0 || numerator >= denominator {
                    return Err(format!("{vertex} is {numerator}/{denominator} of the way"));
                }
                vec![point(from), point(to)]
            }
            Some(Blend::Inside { face }) => old.face_corners(face).map(point).collect(),
        };
        let is_within = |axis: usize| {
            let along = || corners.iter().map(|p| p[axis]);
            let (low, high) =
                (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
            let slack = (low.abs() + high.abs()) * 1e-12;
            !found[axis].is_finite() || (low - slack <= found[axis] && found[axis] <= high + slack)
        };
        if (0..3).filter(|&axis| !is_within(axis)).count() <= 1 {
            Ok(())
        } else {
            Err(format!("{vertex} is at {found:?}, outside {corners:?}"))
        }
    }

    /// A face that is in pieces, or has lost corners, is named, or said to have got others; so are the vertices of corners
    /// that went with them.
    fn pieces_are_named(&self, named: &Named, reshaped: &BTreeSet<FaceId>) -> Result<(), String> {
        for (face, source) in self.record.faces.iter().filter_map(|(f, old)| Some((f, old?))) {
            let kept = self.after.faces().face_corners(face).filter(|&c| self.record.corners.of(c).is_some());
            let goes = |vertex: &&VertexId| named.gone_vertices.contains(vertex);
            let went = self.before.faces().face_vertices(source).iter().filter(goes);
            let is_whole = kept.count() + went.count() >= self.before.faces().corner_range(source).len();
            let is_named = named.faces.contains_key(&source) || reshaped.contains(&source);
            if !is_whole && !is_named {
                return Err(format!("{face} is not all of {source}, and that is not named"));
            }
        }
        Ok(())
    }

    /// A vertex that is gone is named, one that is still there is not, and one that is there twice or new has a reason.
    fn vertices_are_named(&self, named: &Named) -> Result<(), String> {
        let mut parts = vec![0; self.before.counts().vertices];
        self.record.vertices.iter().filter_map(|(_, old)| old).for_each(|old| parts[old.index()] += 1);
        for (v, &count) in parts.iter().enumerate() {
            let vertex = VertexId::new(v);
            same("being gone", vertex, count == 0, named.gone_vertices.contains(&vertex))?;
            if count > 1 && !named.parted_vertices.contains(&vertex) {
                return Err(format!("{vertex} is there {count} times, and that is not named"));
            }
        }
        if self.record.created.is_empty() || named.asks_for_vertices {
            Ok(())
        } else {
            Err("vertices are created for no reason".into())
        }
    }
}

/// What a list of defects names.
#[derive(Default)]
struct Named {
    faces: BTreeMap<FaceId, BTreeSet<DefectKind>>,
    gone_vertices: BTreeSet<VertexId>,
    parted_vertices: BTreeSet<VertexId>,
    asks_for_vertices: bool,
}

impl Named {
    fn of(fixed: &[Defect]) -> Self {
        let mut named = Named::default();
        for defect in fixed {
            match defect.kind {
                DefectKind::DegenerateFace
                | DefectKind::NonFiniteFace
                | DefectKind::DuplicateFace
                | DefectKind::OppositeFace
                | DefectKind::NonSimpleFace
                | DefectKind::FaceWithHole
                | DefectKind::CrossingFace
                | DefectKind::RepeatedCorner
                | DefectKind::SmallComponent
                | DefectKind::InternalFace
                | DefectKind::SliverFace
                | DefectKind::ZeroAreaFace => named.name_face(defect),
                DefectKind::PolygonFace => {
                    named.name_face(defect);
                    named.asks_for_vertices = true;
                }
                DefectKind::UnreferencedVertex | DefectKind::CoincidentVertex => {
                    named.gone_vertices.extend(defect.at.vertex());
                }
                DefectKind::PinchedVertex | DefectKind::SingularVertex => {
                    named.parted_vertices.extend(defect.at.vertex());
                }
                DefectKind::SeamEdge => named.parted_vertices.extend(defect.at.ends().into_iter().flatten()),
                DefectKind::CoincidentEdges | DefectKind::BoundaryEdge => named.asks_for_vertices = true,
                _ => {}
            }
        }
        named
    }

    fn name_face(&mut self, defect: &Defect) {
        if let Some(face) = defect.at.face() {
            self.faces.entry(face).or_default().insert(defect.kind);
        }
    }
}

/// What a corner has in a layer of the vertices or the corners.
fn at_corner<'a>(
    faces: &FaceTable,
    layer: &Layer,
    values: &'a [Option<Vec<Entry>>],
    corner: CornerId,
) -> &'a Option<Vec<Entry>> {
    match layer.domain() {
        Domain::Vertex => &values[faces.corner_vertex(corner).index()],
        _ => &values[corner.index()],
    }
}

#[cfg(test)]
mod tests;
