//! Two triangles of a surface, compared.

use std::cmp::Reverse;

use meshmend_core::FaceId;
use meshmend_geometry::vector::Point;

use crate::boxes::Bounds;
use crate::meeting::{Contact, Pair};
use crate::surface::{Surface, Triangle, WHOLE};

/// A triangle of a surface, with what it takes to compare it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) triangle: Triangle,
    pub(super) points: [Point; 3],
    pub(super) bounds: Bounds,
    /// The length of the longest side of its box.
    pub(super) size: f64,
    /// Its number among all triangles.
    pub(super) number: u32,
}

impl Piece {
    /// A triangle with its number.
    #[inline]
    pub(super) fn of(surface: &Surface<'_>, number: u32) -> Self {
        let triangle = surface.triangles()[number as usize];
        let points = surface.points(&triangle);
        let bounds = Bounds::of(points);
        Piece { triangle, points, bounds, size: bounds.size(), number }
    }
}

/// What came of two triangles that are not apart and do not meet properly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hit {
    /// They are parts of different faces, which meet in this way.
    Faces(Met),
    /// They are parts of one face, and cross.
    SelfCrossing(FaceId),
}

/// Two triangles of two faces that meet, that of the lower face first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Met {
    pub(super) triangles: [u32; 2],
    pub(super) contact: Contact,
    pub(super) coplanar: Coplanar,
}

/// Whether faces lie in one plane where they meet. What passes through comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Coplanar {
    No,
    Yes,
}

impl Met {
    /// The two faces.
    pub(super) fn faces(&self, surface: &Surface<'_>) -> [FaceId; 2] {
        self.triangles.map(|number| surface.triangles()[number as usize].face)
    }
}

/// Leaves of each two faces the pair of triangles that is the one to name for them, in the order of the faces.
pub(super) fn one_for_two_faces(met: &mut Vec<Met>, surface: &Surface<'_>) {
    met.sort_unstable_by_key(|met| (met.faces(surface), Reverse(met.contact), met.coplanar, met.triangles));
    met.dedup_by_key(|met| met.faces(surface));
}

/// How two triangles of a surface meet, of which the first has the lower number; `None` if they are apart or meet properly.
#[inline]
pub(super) fn hit(surface: &Surface<'_>, one: &Piece, other: &Piece) -> Option<Hit> {
    let (f, g) = (&one.triangle, &other.triangle);
    let points = [&one.points, &other.points];
    let pair = Pair::named(points, [f.corners, g.corners]);
    if !f.has_inside()
        && !g.has_inside()
        && pair.is_seen_to_be_proper(if one.size > other.size { one.size } else { other.size })
    {
        return None;
    }
    if f.face == g.face {
        let is_crossing = pair.meeting().is_some_and(|meeting| meeting.cells == [WHOLE; 2]);
        return is_crossing.then_some(Hit::SelfCrossing(f.face));
    }
    let hit =
        |contact, coplanar| Hit::Faces(Met { triangles: [one.number, other.number], contact, coplanar });
    let are_triangles = surface.is_triangle(f.face) && surface.is_triangle(g.face);
    if if are_triangles { pair.is_coincident() } else { surface.is_same_cycle(f.face, g.face) } {
        return Some(hit(Contact::Coincident, Coplanar::Yes));
    }
    let meeting = pair.meeting()?;
    let cells = [f.cell_of_face(meeting.cells[0]), g.cell_of_face(meeting.cells[1])];
    if cells == meeting.cells && pair.is_proper(cells) {
        return None;
    }
    let coplanar = if meeting.is_coplanar { Coplanar::Yes } else { Coplanar::No };
    Contact::of_cells(cells).map(|contact| hit(contact, coplanar))
}
