//! What covers of holes cross: faces of the mesh, each other, and themselves.

use meshmend_core::{Cancelled, VertexId, Watch};
use meshmend_geometry::polygon::Triangle;
use meshmend_geometry::vector::Point;
use meshmend_spatial::boxes::{Bounds, BoxTree, Query};
use meshmend_spatial::{CrossingSearch, Surface, do_cross};
use rayon::prelude::*;

use super::ROW;
use super::hole::{Cover, Hole};
use super::record::{Crossed, FillCrossing};

/// Triangles of covers between two looks.
const BETWEEN_LOOKS: usize = 256;

/// A hole with its cover, if it has one.
pub(super) type Covered<'a> = (&'a Hole<'a>, Option<&'a Cover>);

/// A triangle of a cover.
struct Piece {
    /// Which hole it covers, by its place in the list.
    hole: usize,
    triangle: Triangle,
    points: [Point; 3],
}

/// For each hole the first thing that its cover crosses: of faces of the surface; of itself; and of the covers before it that
/// are made, as `is_made` says of what each crosses.
///
/// # Errors
/// When whoever watches the surface stops it.
///
/// *Cost*: O(n log n), and a comparison for each pair of boxes that overlap.
pub(super) fn crossings(
    surface: &Surface<'_>,
    holes: &[Covered<'_>],
    is_made: impl Fn(Option<&FillCrossing>) -> bool,
) -> Result<Vec<Option<FillCrossing>>, Cancelled> {
    let pieces = pieces(holes);
    let search = CrossingSearch::new(surface)?;
    let first = |(place, piece): (usize, &Piece)| {
        if place.is_multiple_of(BETWEEN_LOOKS) {
            surface.watch().look(ROW.name, place, pieces.len())?;
        }
        Ok(search.first_crossing(piece.points))
    };
    let faces = pieces.par_iter().enumerate().map(first).collect::<Result<Vec<_>, Cancelled>>()?;
    let mut found: Vec<Option<FillCrossing>> = vec![None; holes.len()];
    for (piece, face) in pieces.iter().zip(&faces) {
        if let (Some(face), None) = (face, &found[piece.hole]) {
            found[piece.hole] = Some(crossing(holes, piece, Crossed::Face(*face)));
        }
    }
    // By the later one of the two: what comes before it is decided then.
    for (other, one) in crossing_pieces(&pieces, surface.watch())? {
        let (one, other) = (&pieces[one], &pieces[other]);
        let is_there = one.hole == other.hole || is_made(found[other.hole].as_ref());
        if found[one.hole].is_none() && is_there {
            let first = holes[other.hole].0.vertices.iter().copied().min().unwrap_or(VertexId(0));
            found[one.hole] = Some(crossing(holes, one, Crossed::Fill(first)));
        }
    }
    Ok(found)
}

fn pieces(holes: &[Covered<'_>]) -> Vec<Piece> {
    let of_hole = |(hole, &(ring, cover)): (usize, &Covered<'_>)| -> Vec<Piece> {
        let of_cover = |cover: &Cover| {
            let piece =
                |&triangle: &Triangle| Piece { hole, triangle, points: ring.points_of(cover, triangle) };
            cover.triangles.iter().map(piece).collect()
        };
        cover.map_or_else(Vec::new, of_cover)
    };
    holes.iter().enumerate().flat_map(of_hole).collect()
}

/// The pairs of pieces that cross, the lower one first, ascending by the higher one.
fn crossing_pieces(pieces: &[Piece], watch: &Watch) -> Result<Vec<(usize, usize)>, Cancelled> {
    let bounds = |at: usize| Bounds::of(pieces[at].points);
    let tree = BoxTree::watched(pieces.len(), bounds, (watch, ROW.name))?;
    let queries: Vec<Query> =
        (0..pieces.len()).map(|at| Query { bounds: bounds(at), from: at as u32 + 1 }).collect();
    let mut pairs = Vec::new();
    for (first, queries) in (0..).step_by(BETWEEN_LOOKS).zip(queries.chunks(BETWEEN_LOOKS)) {
        watch.look(ROW.name, first, pieces.len())?;
        tree.each_overlap(queries, bounds, |one, other| {
            if do_cross(pieces[first + one].points, pieces[other].points) {
                pairs.push((first + one, other));
            }
        });
    }
    pairs.sort_unstable_by_key(|&(one, other)| (other, one));
    Ok(pairs)
}

fn crossing(holes: &[Covered<'_>], piece: &Piece, with: Crossed) -> FillCrossing {
    let vertices = &holes[piece.hole].0.vertices;
    let triangle = piece.triangle.iter().filter_map(|&corner| vertices.get(corner).copied()).collect();
    FillCrossing { triangle, with }
}
