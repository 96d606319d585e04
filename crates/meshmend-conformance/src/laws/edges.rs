//! `edge-stars` and `across`: the sides along an edge.

use meshmend_core::{Connectivity, CornerId};

use super::asked::Asked;
use super::law::{Breach, Law, same, same_star};

pub(super) const EDGE_STARS: Law = Law {
    id: "edge-stars",
    sentence: "an edge has the corners whose sides run along it, ascending, each with its direction",
    why: "boundary, manifoldness and orientation are read off the sides of the edges",
    often: Some("in the order in which the record keeps them"),
};

pub(super) fn edge_stars<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    right.all_edges().try_for_each(|edge| {
        let corners = right.edge_corners(edge);
        same_star(|| format!("edge_corners({edge})"), kernel.edge_corners(edge), corners)?;
        let sides: Vec<(CornerId, bool)> =
            corners.iter().map(|&side| (side, right.is_forward(side))).collect();
        same_star(|| format!("edge_sides({edge})"), kernel.edge_sides(edge), &sides)
    })
}

pub(super) const ACROSS: Law = Law {
    id: "across",
    sentence: "the side across is the other one of two, and there is none where an edge has one side or three or more",
    why: "neighbours of faces, patches and umbrellas are found through it",
    often: Some("the boundary leads to the side itself, or to the sides of another edge"),
};

pub(super) fn across<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    asked.expected.corners().try_for_each(|corner| {
        let expected = asked.expected.across(corner);
        same(|| format!("across({corner})"), &asked.kernel.across(corner), &expected)?;
        let Some(opposite) = asked.opposite else { return Ok(()) };
        same(|| format!("opposite({corner})"), &opposite(corner), &expected)
    })
}
