//! What fills a hole: the triangles over one boundary loop that fold least, or have the least area.
//!
//! A fill is *admissible* when no diagonal joins two vertices that an edge joins already, and no triangle is there already.
//! Of all admissible fills the best one has the fewest triangles of zero area; then the least greatest fold; then the least
//! area. Of two that are equal to 10⁻¹² it is the one whose list of triangles is the lexicographically first.
//!
//! * Up to 64 corners the best fill is found by dynamic programming: first the least greatest fold ([`least_fold`]), then
//!   the least area among fills that fold no more ([`least_area`]).
//! * Larger loops get the best of several candidates ([`candidates`]), which local changes then make better ([`flips`]).
//!
//! *Source*: P. Liepa, *Filling holes in meshes*, 2003, for the dynamic program over angles; here a state is the triangle
//! over a range of corners, so that the result is the best one.

mod candidates;
mod ears;
mod facet;
mod factor;
mod flips;

mod least_area;
mod least_fold;
mod lists;
mod measure;
mod neighbours;
mod opening;
mod ranges;
mod scaled;
#[cfg(test)]
mod tests;

use meshmend_geometry::polygon::Triangle;

pub use facet::direction_of_face;
pub use measure::{FillCost, fan_cost};
pub use opening::Opening;

use least_area::least_area;
use least_fold::least_fold;
use measure::measure;
use ranges::Ranges;
use scaled::Scaled;

/// Loops of up to so many corners get the best fill that there is.
const LARGEST_EXACT: usize = 64;
/// Costs that differ by less than this part are equal.
const EQUAL: f64 = 1e-12;

/// What a fill is judged by, after its number of triangles of zero area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillBy {
    /// The greatest fold, and then the area.
    Fold,
    /// The area alone.
    Area,
}

/// The triangles that fill an opening.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// The triangles by the places of their corners, each ascending, in the order in which they lie along the loop.
    pub triangles: Vec<Triangle>,
    /// What they cost.
    pub cost: FillCost,
}

/// The best admissible fill of an opening, or for a loop of more than 64 corners an admissible one that folds no more than what
/// triangulating its polygon gives; `None` where none was found.
///
/// *Cost*: O(n⁴) for n corners up to 64, mostly n³; O(n log n) beyond, where triangulating the polygon takes no longer.
pub fn best_fill(opening: &Opening<'_>, by: FillBy) -> Option<Fill> {
    let count = opening.points.len();
    if count < 3 {
        return None;
    }
    let scaled = Scaled::of(opening);
    let triangles = if count <= LARGEST_EXACT {
        let ranges = Ranges::new(opening, &scaled);
        let limit = match by {
            FillBy::Fold => Some(least_fold(&ranges)?),
            FillBy::Area => None,
        };
        least_area(&ranges, limit)?
    } else {
        candidates::best_candidate(opening, &scaled, by)?
    };
    let cost = measure(opening, &scaled, &triangles)?;
    Some(Fill { triangles, cost })
}
