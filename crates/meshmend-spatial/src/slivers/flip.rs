//! Whether the longest edge of a cap may be flipped, or the cap dropped.

use std::cmp::Ordering;

use meshmend_core::{FaceId, VertexId};

use super::ground::Ground;
use super::measure::{agreement, compare_areas, is_no_higher};
use super::record::SliverReason;
use crate::compare_aspects;
use crate::exact::Sign;

/// A step for a cap that may be made.
pub(super) enum CapStep {
    Drop,
    Flip(Flip),
}

/// A flip that may be made.
pub(super) struct Flip {
    /// The edge that goes; the cap runs from its first end to the second.
    pub(super) edge: [VertexId; 2],
    /// The edge that comes: from the apex of the cap to that of the other face.
    pub(super) to: [VertexId; 2],
    pub(super) with: FaceId,
}

/// The step for a cap that runs from `a` to `b`, the ends of its longest edge, and to its apex.
pub(super) fn cap_step(
    ground: &Ground<'_>,
    cap: FaceId,
    [a, b, apex]: [VertexId; 3],
) -> Result<CapStep, SliverReason> {
    let faces = &ground.faces;
    let points = faces.points([a, b, apex]).ok_or(SliverReason::NotFinite)?;
    let (star, apex_star) = (faces.star(a), faces.star(apex));
    if !faces.are_simple(&star) || !faces.are_simple(&apex_star) {
        return Err(SliverReason::NonTriangle);
    }
    let around = faces.neighbours(apex, &apex_star);
    if !around.iter().all(|neighbour| neighbour.is_regular()) {
        return Err(SliverReason::Sides);
    }
    let sides =
        faces.neighbours(a, &star).iter().find(|neighbour| neighbour.vertex == b).map_or(0, |n| n.sides);
    let others: Vec<FaceId> =
        star.iter().copied().filter(|&face| face != cap && faces.of_face(face).contains(&b)).collect();
    let step = match (sides, others.as_slice()) {
        (1, _) => {
            let is_on_boundary = around.iter().any(|neighbour| neighbour.sides == 1);
            if is_on_boundary { Err(SliverReason::Boundary) } else { Ok(CapStep::Drop) }
        }
        (2, &[other]) => flip(ground, cap, [a, b, apex], other).map(CapStep::Flip),
        _ => Err(SliverReason::Sides),
    }?;
    if is_no_higher(points, ground.reach) { Ok(step) } else { Err(SliverReason::Move) }
}

fn flip(
    ground: &Ground<'_>,
    cap: FaceId,
    [a, b, c]: [VertexId; 3],
    other: FaceId,
) -> Result<Flip, SliverReason> {
    let faces = &ground.faces;
    let corners = faces.triangle(other).ok_or(SliverReason::NonTriangle)?;
    let [_, _, d] = (0..3)
        .map(|at| [corners[at], corners[(at + 1) % 3], corners[(at + 2) % 3]])
        .find(|&[from, to, _]| [from, to] == [b, a])
        .ok_or(SliverReason::Sides)?;
    if c == d || faces.neighbours(c, &faces.star(c)).iter().any(|neighbour| neighbour.vertex == d) {
        return Err(SliverReason::Link);
    }
    let agrees = [a, b].into_iter().all(|end| ground.agree_at(end, [cap, other]));
    if !(agrees && ground.attributes.faces_agree(cap, other)) {
        return Err(SliverReason::Seam);
    }
    let points = |vertices| faces.points(vertices).ok_or(SliverReason::NotFinite);
    let old = [points([a, b, c])?, points([b, a, d])?];
    let new = [points([a, d, c])?, points([d, b, c])?];
    let front = if compare_areas(old[0], old[1]) == Ordering::Less { old[1] } else { old[0] };
    if new.into_iter().any(|triangle| agreement(triangle, front) != Sign::Positive) {
        return Err(SliverReason::TurnsOver);
    }
    let worse =
        |[one, other]: [_; 2]| if compare_aspects(one, other) == Ordering::Less { other } else { one };
    if compare_aspects(worse(new), worse(old)) != Ordering::Less {
        return Err(SliverReason::NoBetter);
    }
    Ok(Flip { edge: [a, b], to: [c, d], with: other })
}
