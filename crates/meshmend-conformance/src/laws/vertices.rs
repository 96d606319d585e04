//! `vertex-stars` and `rotation`: the corners at a vertex.

use meshmend_core::{Connectivity, CornerId, Id};

use super::asked::Asked;
use super::law::{Breach, Law, same_star};

pub(super) const VERTEX_STARS: Law = Law {
    id: "vertex-stars",
    sentence: "a vertex has the corners that stand at it, each once; ascending, unless vertex stars are ordered",
    why: "umbrellas, links and normals are read off the corners at a vertex",
    often: Some(
        "a walk that begins inside and ends at the boundary; or a pinched vertex: one pointer reaches one umbrella",
    ),
};

pub(super) fn vertex_stars<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let right = asked.expected;
    right.vertices().try_for_each(|vertex| {
        let question = || format!("vertex_corners({vertex})");
        let (found, star) = (asked.kernel.vertex_corners(vertex), &right.stars[vertex.index()]);
        if !K::CAPABILITIES.ordered_vertex_stars {
            return same_star(question, found, star);
        }
        let found: Vec<CornerId> = found.collect();
        let mut sorted = found.clone();
        sorted.sort_unstable();
        // What is shown is what was answered, in the order in which it was.
        if sorted == *star { Ok(()) } else { same_star(question, found.into_iter(), star) }
    })
}

pub(super) const ROTATION: Law = Law {
    id: "rotation",
    sentence: "ordered corners at a vertex are one walk, counter-clockwise as the lowest corner's face runs, from the boundary \
        on, else from the lowest corner",
    why: "the order round a vertex is what a structure with rotation gives beyond the others",
    often: Some("begun at any edge, or clockwise"),
};

pub(super) fn rotation<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    if !K::CAPABILITIES.ordered_vertex_stars {
        return Ok(());
    }
    asked.expected.vertices().try_for_each(|vertex| {
        let Some(walk) = asked.expected.rotation(vertex) else { return Ok(()) };
        same_star(|| format!("vertex_corners({vertex})"), asked.kernel.vertex_corners(vertex), &walk)
    })
}
