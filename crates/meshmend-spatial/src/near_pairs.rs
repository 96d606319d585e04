//! Which points are near each other, pair by pair.

use meshmend_core::{Cancelled, Watch};
use meshmend_geometry::proximity::Nearness;
use meshmend_geometry::vector::{Point, dot, minus};

use crate::t_junctions::PointTree;

/// The pairs of finite points not farther apart than a distance of at least 0, by their places, the lower first: nearest pairs
/// first, of equally near ones by their places. `None` if there are more than so many.
///
/// # Errors
/// When whoever watches the step stops it.
///
/// *Cost*: O(n log n + pairs · log pairs); 24 bytes a pair.
pub fn near_pairs(
    points: &[Point],
    within: f64,
    most: usize,
    (watch, step): (&Watch, &'static str),
) -> Result<Option<Vec<[u32; 2]>>, Cancelled> {
    let look = |place| watch.look_at_times(step, place, points.len());
    let tree = PointTree::watched(points.iter().copied(), &|| look(0))?;
    let near = Nearness::within(within);
    let mut pairs: Vec<(f64, [u32; 2])> = Vec::new();
    for (place, &point) in (0u32..).zip(points) {
        look(place as usize)?;
        let mut beside = Vec::new();
        tree.visit_near([point, point], within, |other| {
            if other > place && near.are_near(point, points[other as usize]) {
                beside.push(other);
            }
        });
        if pairs.len() + beside.len() > most {
            return Ok(None);
        }
        pairs.extend(beside.into_iter().map(|other| {
            let between = minus(points[other as usize], point);
            (dot(between, between), [place, other])
        }));
    }
    pairs.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
    Ok(Some(pairs.into_iter().map(|(_, pair)| pair).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(points: &[Point], within: f64, most: usize) -> Option<Vec<[u32; 2]>> {
        near_pairs(points, within, most, (&Watch::NOBODY, "pairs")).unwrap()
    }

    #[test]
    fn the_nearest_pairs_come_first_and_too_many_are_none() {
        let points: Vec<Point> = [0.0, 3.0, 1.0, 7.0, 2.5].map(|x| [x, 1.0, -1.0]).to_vec();
        let expected = vec![[1, 4], [0, 2], [2, 4], [1, 2]];
        assert_eq!(found(&points, 2.0, 4), Some(expected));
        assert_eq!(found(&points, 2.0, 3), None);
        assert_eq!(found(&[[0.0; 3], [0.0; 3]], 0.0, 9), Some(vec![[0, 1]]));
        assert_eq!(found(&[], 1.0, 0), Some(vec![]));
    }
}
