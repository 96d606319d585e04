//! Whether the shortest edge of a needle may go, one of its ends going into the other.

use meshmend_core::{FaceId, VertexId};

use super::ground::Ground;
use super::record::SliverReason;
use super::surface::Neighbour;

/// A collapse that may be made.
pub(super) struct Collapse {
    pub(super) from: VertexId,
    pub(super) into: VertexId,
    /// The faces that come to the other end.
    pub(super) kept: Vec<FaceId>,
    /// The faces at the edge.
    pub(super) gone: Vec<FaceId>,
    /// How far what went into the other end is from it, at most.
    pub(super) bound: f64,
}

/// The collapse of an edge in the direction in which it may be made: the higher end goes if both may.
pub(super) fn collapse_of(ground: &Ground<'_>, ends: [VertexId; 2]) -> Result<Collapse, SliverReason> {
    let [low, high] = if ends[0] < ends[1] { ends } else { [ends[1], ends[0]] };
    let first = match collapse(ground, high, low) {
        Ok(collapse) => return Ok(collapse),
        Err(reason) => reason,
    };
    collapse(ground, low, high)
        .map_err(|second| if second == SliverReason::Move { SliverReason::Move } else { first })
}

fn collapse(ground: &Ground<'_>, from: VertexId, into: VertexId) -> Result<Collapse, SliverReason> {
    let faces = &ground.faces;
    let star = faces.star(from);
    let (gone, kept): (Vec<FaceId>, Vec<FaceId>) =
        star.iter().partition(|&&face| faces.of_face(face).contains(&into));
    if star.iter().any(|&face| faces.triangle(face).is_none()) {
        return Err(SliverReason::NonTriangle);
    }
    may_join(ground, [from, into], &star, &gone, &kept)?;
    if is_on_seam(ground, [from, into], &star, &gone) {
        return Err(SliverReason::Seam);
    }
    for &face in &kept {
        let Some(old) = faces.triangle(face) else { return Err(SliverReason::NonTriangle) };
        let new = old.map(|vertex| if vertex == from { into } else { vertex });
        let (Some(old), Some(new)) = (faces.points(old), faces.points(new)) else {
            return Err(SliverReason::NotFinite);
        };
        ground.may_become(old, new)?;
    }
    let bound = ground.stood_for.bound_at(from, into, ground.reach).ok_or(SliverReason::Move)?;
    Ok(Collapse { from, into, kept, gone, bound })
}

/// Whether the faces hang together afterwards as they do now.
fn may_join(
    ground: &Ground<'_>,
    [from, into]: [VertexId; 2],
    star: &[FaceId],
    gone: &[FaceId],
    kept: &[FaceId],
) -> Result<(), SliverReason> {
    let faces = &ground.faces;
    let other_star = faces.star(into);
    let (here, there) = (faces.neighbours(from, star), faces.neighbours(into, &other_star));
    if gone.len() > 2 || !here.iter().chain(&there).all(|neighbour| neighbour.is_regular()) {
        return Err(SliverReason::Sides);
    }
    if !faces.are_simple(&other_star) {
        return Err(SliverReason::NonTriangle);
    }
    if !faces.is_umbrella(from, star) {
        return Err(SliverReason::Link);
    }
    let mut apexes: Vec<VertexId> = gone.iter().flat_map(|&face| faces.of_face(face)).copied().collect();
    apexes.retain(|&vertex| vertex != from && vertex != into);
    apexes.sort_unstable();
    let common: Vec<[Neighbour; 2]> = common(&here, &there);
    if !common.iter().map(|[one, _]| one.vertex).eq(apexes.iter().copied()) {
        return Err(SliverReason::Link);
    }
    if here.iter().any(|neighbour| neighbour.sides == 1) && gone.len() != 1 || kept.is_empty() {
        return Err(SliverReason::Boundary);
    }
    // A face goes from both edges that become one.
    match common.iter().map(|[one, other]| one.sides + other.sides).find(|sides| !(3..=4).contains(sides)) {
        Some(0..=2) => return Err(SliverReason::Boundary),
        Some(_) => return Err(SliverReason::Sides),
        None => {}
    }
    // A face over both apexes at either end: the two would become one face twice.
    let is_over_apexes = |&face: &FaceId| apexes.iter().all(|apex| faces.of_face(face).contains(apex));
    let would_repeat =
        apexes.len() == 2 && kept.iter().any(is_over_apexes) && other_star.iter().any(is_over_apexes);
    if would_repeat { Err(SliverReason::Link) } else { Ok(()) }
}

/// The neighbours that are in both of two lists.
fn common(one: &[Neighbour], other: &[Neighbour]) -> Vec<[Neighbour; 2]> {
    let in_other = |here: &Neighbour| {
        let at = other.binary_search_by_key(&here.vertex, |there| there.vertex).ok()?;
        Some([*here, other[at]])
    };
    one.iter().filter_map(in_other).collect()
}

/// Whether attributes differ round the vertex that goes, or across the edge at the one that stays.
fn is_on_seam(ground: &Ground<'_>, [from, into]: [VertexId; 2], star: &[FaceId], gone: &[FaceId]) -> bool {
    let agree_at =
        |faces: &[FaceId], vertex| faces.windows(2).all(|two| ground.agree_at(vertex, [two[0], two[1]]));
    let is_one = star.windows(2).all(|two| ground.attributes.faces_agree(two[0], two[1]));
    !(is_one && agree_at(star, from) && agree_at(gone, into))
}
