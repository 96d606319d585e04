//! Two triangles of a surface, compared.

use crate::meeting::{Contact, Pair};
use crate::surface::{Surface, Triangle, WHOLE};

/// What came of two triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hit {
    /// They are parts of different faces, which meet in this way.
    Faces(Contact, Coplanar),
    /// They are parts of one face, and cross.
    SelfCrossing,
}

/// Whether faces lie in one plane where they meet. What passes through comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Coplanar {
    No,
    Yes,
}

/// How two triangles of a surface meet; `None` if they are apart or meet properly.
#[inline]
pub(super) fn hit(surface: &Surface<'_>, f: &Triangle, g: &Triangle) -> Option<Hit> {
    let points = [surface.points(f), surface.points(g)];
    let pair = Pair::named(&points, [f.corners, g.corners]);
    if f.face == g.face {
        let is_crossing = pair.meeting().is_some_and(|meeting| meeting.cells == [WHOLE; 2]);
        return is_crossing.then_some(Hit::SelfCrossing);
    }
    let are_triangles = surface.is_triangle(f.face) && surface.is_triangle(g.face);
    if if are_triangles { pair.is_coincident() } else { surface.is_same_cycle(f.face, g.face) } {
        return Some(Hit::Faces(Contact::Coincident, Coplanar::Yes));
    }
    let meeting = pair.meeting()?;
    let cells = [f.cell_of_face(meeting.cells[0]), g.cell_of_face(meeting.cells[1])];
    if cells == meeting.cells && pair.is_proper(cells) {
        return None;
    }
    let coplanar = if meeting.is_coplanar { Coplanar::Yes } else { Coplanar::No };
    Contact::of_cells(cells).map(|contact| Hit::Faces(contact, coplanar))
}
