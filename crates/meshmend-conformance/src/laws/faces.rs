//! `next-and-prev` and `face-stars`: the ways round a face.

use meshmend_core::{Connectivity, Id};

use super::asked::Asked;
use super::law::{Breach, Law, same, same_star};

pub(super) const NEXT_AND_PREV: Law = Law {
    id: "next-and-prev",
    sentence: "next goes round the face as stored, prev undoes it",
    why: "every walk along a boundary and about a vertex is made of these two",
    often: Some("turned the wrong way at the far end of a side"),
};

pub(super) fn next_and_prev<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    right.corners().try_for_each(|corner| {
        let at = corner.index();
        same(|| format!("next_corner({corner})"), &kernel.next_corner(corner), &right.next[at])?;
        same(|| format!("prev_corner({corner})"), &kernel.prev_corner(corner), &right.prev[at])
    })
}

pub(super) const FACE_STARS: Law = Law {
    id: "face-stars",
    sentence: "a face has its corners in its own order, from its first corner on, and a degenerate face has none",
    why: "whoever writes the mesh again writes the faces as they were",
    often: Some(
        "begun at any edge of the face; that will do in a lecture, and here all kernels give the same bytes",
    ),
};

pub(super) fn face_stars<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let right = asked.expected;
    right.all_faces().try_for_each(|face| {
        let corners = asked.kernel.face_corners(face);
        same_star(|| format!("face_corners({face})"), corners, &right.face_corners[face.index()])
    })
}
