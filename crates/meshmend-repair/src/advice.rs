//! Which weld tolerance stands out in a mesh, if one does.
//!
//! The vertices of open edges are joined in thought, nearest first. Each step closes edges, and says how far apart what it joined
//! was. Where a crack was left by rounding, many steps lie close together and then nothing happens for a long while: that is a
//! *plateau*, a range of distances within which nothing more is joined, at least four times as long as its beginning. It ends at
//! the latest where a face would lose a corner or a loose edge its length (*harm*), and at 2 % of the diagonal of the box.
//!
//! Of the plateaus the one is taken that ends the steepest rise: the most open edges closed for a tenfold of distance. The
//! tolerance is the geometric mean of its ends, and at most ten times its beginning. What it closes is not estimated: the weld is
//! tried.

mod steps;

use meshmend_core::{PolygonMesh, Watch};
use meshmend_geometry::coincident::{equal_in_pose, watched_coincident_vertices};
use serde::Serialize;

use self::steps::{Merging, Step};
use crate::passes::{OpenEdges, diagonal};
use crate::{Context, Distance, PassError};

/// What the work is called to whoever watches.
const STEP: &str = "advise";
/// Distances are looked at up to this part of the diagonal of the box.
const FARTHEST: f64 = 0.02;
/// How many times as long as its beginning a plateau is at least.
const LENGTH_OF_PLATEAU: f64 = 4.0;
/// How many times the beginning of its plateau a tolerance is at most.
const BEYOND_BEGINNING: f64 = 10.0;
/// A rise counts as no shorter than this part of a tenfold of distance.
const SHORTEST_RISE: f64 = 0.1;
/// Bins of the histogram for a tenfold of distance.
pub const BINS_A_DECADE: usize = 10;

/// Which weld tolerance stands out in a mesh, and what was seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Advice {
    /// The diagonal of the box that relative distances refer to.
    pub diagonal: f64,
    /// How many open edges there are where equal positions are one.
    pub open_edges: u64,
    /// How many of them another open edge coincides with already.
    pub coincident: u64,
    /// The tolerance that stands out; `None` if none does.
    pub tolerance: Option<Tolerance>,
    /// From which distance on a face would lose a corner, or an edge its length, if that is within what was looked at.
    pub harm: Option<f64>,
    /// Up to which distance pairs of vertices were looked at: 2 % of the diagonal, or less where there are very many.
    pub looked_up_to: f64,
    /// How many vertices are joined to others, by distance: ten bins for a tenfold, those that have any.
    pub histogram: Vec<Bin>,
    /// How many open edges are closed at each distance at which that changes, ascending.
    #[serde(skip)]
    pub closed: Vec<(f64, u64)>,
}

/// A tolerance that stands out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Tolerance {
    /// In units of length.
    pub distance: f64,
    /// In parts of the diagonal.
    pub relative: f64,
    /// How many open edges a weld along open edges within it closes.
    pub closes: u64,
    /// The plateau: from the longest distance that is joined within it, to the next one above, or to where looking ended.
    pub plateau: [f64; 2],
    /// The next distance above at which vertices would be joined, if there is one.
    pub next: Option<f64>,
}

/// How many vertices are joined at distances of a range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Bin {
    /// Where the range begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// How many.
    pub joined: u64,
}

impl Tolerance {
    /// The weld that it stands for.
    pub fn weld(self) -> Distance {
        Distance::Boundary(self.distance)
    }
}

impl Advice {
    /// The weld that stands out, or that of equal positions.
    pub fn weld(&self) -> Distance {
        self.tolerance.map_or(Distance::Exact, Tolerance::weld)
    }

    /// Looks for the weld tolerance that stands out in a mesh.
    ///
    /// # Errors
    /// When the watch stops it.
    ///
    /// *Cost*: O(n log n) for n vertices of open edges, where not very many of them lie close together.
    pub fn on(mesh: &PolygonMesh, watch: &Watch) -> Result<Self, PassError> {
        let exact = equal_in_pose(mesh, watched_coincident_vertices(mesh, || watch.look(STEP, 0, 0))?);
        watch.look(STEP, 0, 0)?;
        let open = OpenEdges::of(mesh, &exact)?;
        let diagonal = diagonal(mesh);
        watch.look(STEP, 0, 0)?;
        let (pairs, looked_up_to) = open.near_pairs(FARTHEST * diagonal, (watch, STEP))?;
        watch.look(STEP, 0, 0)?;
        let Merging { coincident, steps, harm } = Merging::of(&open, pairs, watch)?;
        let end = harm.unwrap_or(looked_up_to);
        let plateau = plateau(&steps, coincident, end);
        let context = Context::default().with_watch(watch, STEP);
        let tolerance = |Plateau { from, to, next }: Plateau| {
            let distance = rounded((from * to).sqrt().min(BEYOND_BEGINNING * from));
            let after = open.coincident_within(mesh, exact, distance, &context)?;
            let closes = after.saturating_sub(coincident);
            Ok(Tolerance { distance, relative: distance / diagonal, closes, plateau: [from, to], next })
        };
        let tolerance: Result<Option<Tolerance>, PassError> = plateau.map(tolerance).transpose();
        Ok(Advice {
            diagonal,
            open_edges: open.edges().len() as u64,
            coincident,
            tolerance: tolerance?.filter(|tolerance| tolerance.closes > 0),
            harm,
            looked_up_to,
            histogram: histogram(&steps),
            closed: steps.iter().map(|step| (step.distance, step.closed)).collect(),
        })
    }
}

/// A distance with two digits, as people say it: the ends of its plateau are farther away.
fn rounded(distance: f64) -> f64 {
    format!("{distance:.1e}").parse().unwrap_or(distance)
}

/// A range of distances within which nothing is joined.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plateau {
    from: f64,
    to: f64,
    next: Option<f64>,
}

/// The plateau that ends the steepest rise of closed edges; `end` is where looking ended.
fn plateau(steps: &[Step], already: u64, end: f64) -> Option<Plateau> {
    let (mut best, mut best_gain) = (None, 0.0);
    let mut begin: Option<(f64, u64)> = None;
    for (place, step) in steps.iter().enumerate() {
        let before = place.checked_sub(1).map_or(already, |before| steps[before].closed);
        let (from, closed) = *begin.get_or_insert((step.distance, before));
        let next = steps.get(place + 1).map(|next| next.distance);
        let to = next.unwrap_or(end);
        if to < LENGTH_OF_PLATEAU * step.distance {
            continue;
        }
        let decades = (step.distance / from).log10().max(SHORTEST_RISE);
        let gain = step.closed.saturating_sub(closed) as f64 / decades;
        if gain > best_gain {
            (best, best_gain) = (Some(Plateau { from: step.distance, to, next }), gain);
        }
        begin = None;
    }
    best
}

/// How many vertices are joined, by distance.
fn histogram(steps: &[Step]) -> Vec<Bin> {
    let bins = BINS_A_DECADE as f64;
    let bin_of = |step: &Step| (step.distance.log10() * bins).floor();
    let edge = |bin: f64| 10f64.powf(bin / bins);
    let chunks = steps.chunk_by(|one, other| bin_of(one) == bin_of(other));
    let bin = |chunk: &[Step]| {
        let at = bin_of(&chunk[0]);
        Bin { from: edge(at), to: edge(at + 1.0), joined: chunk.iter().map(|step| step.joined).sum() }
    };
    chunks.map(bin).collect()
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;

    use super::*;

    /// Squares beside each other along a line, each of two triangles with vertices of their own: between the right end of one
    /// and the left end of the next is a gap.
    fn strip(gaps: &[f64]) -> PolygonMesh {
        let (mut positions, mut faces, mut left) = (Vec::new(), Vec::new(), 0.0);
        for at in 0..=gaps.len() {
            let right = left + 1.0;
            let first = positions.len() as u32;
            positions.extend([[left, 0.0, 0.0], [right, 0.0, 0.0], [right, 1.0, 0.0], [left, 1.0, 0.0]]);
            faces.extend([vec![first, first + 1, first + 2], vec![first, first + 2, first + 3]]);
            left = right + gaps.get(at).copied().unwrap_or_default();
        }
        Soup { positions, faces }.mesh()
    }

    fn advice(mesh: &PolygonMesh) -> Advice {
        Advice::on(mesh, &Watch::NOBODY).unwrap()
    }

    #[test]
    fn a_crack_stands_out() {
        let gaps = [1e-5, 1.2e-5, 0.9e-5, 1.1e-5];
        let advice = advice(&strip(&gaps));
        let tolerance = advice.tolerance.unwrap();
        assert!((1.2e-5..1.3e-4).contains(&tolerance.distance), "{tolerance:?}");
        // Of each gap both ends are closed.
        assert_eq!((advice.open_edges, tolerance.closes, advice.coincident), (20, 8, 0));
        assert_eq!(
            (tolerance.next, advice.harm),
            (None, None),
            "pairs are looked at up to 2 % of the diagonal"
        );
        let joined: u64 = advice.histogram.iter().map(|bin| bin.joined).sum();
        assert_eq!(joined, 8, "two vertices a gap");
        assert_eq!(advice.closed.last().unwrap().1, 8);
        assert_eq!(advice.weld(), Distance::Boundary(tolerance.distance));
    }

    #[test]
    fn of_two_cracks_the_steeper_rise_is_taken() {
        // Three cracks near 1e-6, one at 1e-3.
        let tolerance = advice(&strip(&[1e-6, 1.1e-6, 1.2e-6, 1e-3])).tolerance.unwrap();
        assert!((1.2e-6..1e-3).contains(&tolerance.distance), "{tolerance:?}");
        assert_eq!(tolerance.closes, 6);
        assert!((tolerance.next.unwrap() - 1e-3).abs() < 1e-9);
    }

    #[test]
    fn distances_without_a_gap_between_them_stand_out_in_nothing() {
        // From one to the next less than four times as far, up to where looking ends.
        let gaps: Vec<f64> = (0..19).map(|step| 1e-6 * 2f64.powi(step)).collect();
        let gradual = advice(&strip(&gaps));
        assert_eq!((gradual.tolerance, gradual.weld()), (None, Distance::Exact));
        assert_eq!(advice(&strip(&[])).tolerance, None);
        assert_eq!(
            advice(&Soup { positions: vec![[f64::NAN; 3]; 3], faces: vec![vec![0, 1, 2]] }.mesh()).tolerance,
            None
        );
        assert_eq!(advice(&Soup::default().mesh()).open_edges, 0);
    }

    #[test]
    fn harm_ends_a_plateau_and_is_told() {
        // A sliver of a face, shorter than the crack is wide.
        let mut soup =
            Soup { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1e-4, 0.0]], faces: vec![vec![0, 1, 2]] };
        soup.positions.extend([[0.0, -1e-3, 0.0], [1.0, -1e-3, 0.0], [0.5, -1.0, 0.0]]);
        soup.faces.push(vec![4, 3, 5]);
        let advice = advice(&soup.mesh());
        assert_eq!((advice.tolerance, advice.closed.len()), (None, 0));
        assert!((advice.harm.unwrap() - 1e-4).abs() < 1e-9, "{:?}", advice.harm);
    }

    #[test]
    fn what_welds_at_one_place_already_is_told_apart() {
        // Two faces whose edge has vertices of its own in each, at the same places.
        let positions =
            vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0; 3]];
        let exact = advice(&Soup { positions, faces: vec![vec![0, 1, 2], vec![4, 3, 5]] }.mesh());
        assert_eq!((exact.open_edges, exact.tolerance), (4, None), "an exact weld closes it");
    }

    #[test]
    fn the_order_of_faces_does_not_matter() {
        let mesh = strip(&[1e-5, 3e-3, 1.1e-5]);
        let mut faces: Vec<Vec<u32>> = mesh
            .faces()
            .faces()
            .map(|face| mesh.faces().face_vertices(face).iter().map(|v| v.0).collect())
            .collect();
        faces.reverse();
        let turned = Soup { positions: mesh.positions().to_vec(), faces }.mesh();
        assert_eq!(advice(&mesh), advice(&turned));
    }

    #[test]
    fn a_repair_takes_it_and_a_second_one_finds_nothing() {
        use crate::{Pipeline, Weld};

        for gaps in [&[1e-5, 1.2e-5][..], &[1e-6, 1.1e-6, 1e-3], &[0.0, 0.0], &[1e-6, 1e-5, 1e-4, 1e-3, 1e-2]]
        {
            let pipeline = Pipeline::default().with(Weld::within(Distance::Auto));
            let mesh = strip(gaps);
            let repaired = pipeline.run(&mesh).unwrap();
            let advice = repaired.passes[0].advice.as_ref().unwrap();
            let fixed = pipeline.clone().with(Weld::within(advice.weld())).run(&mesh).unwrap();
            assert!(repaired.mesh.counts().vertices <= fixed.mesh.counts().vertices, "{gaps:?}");
            let again = pipeline.run(&repaired.mesh).unwrap();
            assert!(!again.is_changed(), "{gaps:?}");
        }
    }
}
