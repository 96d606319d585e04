//! What is asked of a layout, what it is, and how it is made.

use meshmend_core::{FaceId, PolygonMesh, VertexId};

use crate::boundary_placement::{Cell, Outline, corners_by_length, rim_points};
use crate::cotangents::cotangents;
use crate::discs::Discs;
use crate::error::FlattenError;
use crate::flat::Flat;
use crate::laplacian::Laplacian;
use crate::orientation::bad_faces;
use crate::reweighting::reweighted;
use crate::untangle::untangle;

/// How to lay a mesh out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flatten {
    /// Where the boundary goes.
    pub boundary: Boundary,
    /// What holds the other vertices.
    pub weights: Weights,
}

/// Where the boundary of a disc goes, by its length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Boundary {
    /// On a circle, where no face has to collapse.
    #[default]
    Circle,
    /// On a square, the boundary's lowest vertex in the lower left corner and those nearest to the quarters of its
    /// length in the others.
    ///
    /// What an edge across the disc cuts off collapses if both of its ends are on one side: that can't be helped.
    Square,
    /// On a square with these vertices in its corners, the first in the lower left one and the others as the boundary
    /// comes to them; for one disc.
    ///
    /// Opposite sides that are as long edge by edge, as the two sides of a cut are, have their vertices at the same
    /// places.
    SquareAt([VertexId; 4]),
}

/// How strongly a vertex is drawn to each of its neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weights {
    /// Equally, as Tutte has it. Where the layout becomes too small for doubles the edges are weighted anew, and
    /// weights stay positive: see [`Layout::rounds`].
    #[default]
    Uniform,
    /// By the cotangents of the angles across the edge: the layout that changes angles least, a discrete harmonic
    /// map. Obtuse triangles make weights negative, and may be flipped.
    Cotangent,
}

/// Discs in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The point of each vertex in the unit square; that of a vertex in no face is the origin.
    pub points: Vec<[f64; 2]>,
    /// How many discs there are, each in a square of its own.
    pub discs: usize,
    /// Faces that run clockwise, against their disc, ascending.
    pub flipped: Vec<FaceId>,
    /// Faces with a part that has no area and none that is flipped, ascending.
    pub collapsed: Vec<FaceId>,
    /// How often the edges were weighted anew.
    pub rounds: usize,
}

/// Reweighting goes on as long as one of this many rounds in a row leaves fewer bad faces than any before.
const PATIENCE: usize = 4;

impl Layout {
    /// Whether no face is flipped or collapsed.
    pub fn is_one_to_one(&self) -> bool {
        self.flipped.is_empty() && self.collapsed.is_empty()
    }
}

/// Lays out a mesh whose every component is a disc, each in a square of its own.
///
/// The point of a vertex depends on ids and lengths alone, not on the number of threads.
///
/// # Errors
/// When a component is not a disc, a face is not simple, or the weights can't be computed.
///
/// *Cost*: a sparse factorisation, about n^1.5 for n vertices, and as many again as rounds are needed; about a
/// kilobyte a vertex.
pub fn flatten(mesh: &PolygonMesh, request: &Flatten) -> Result<Layout, FlattenError> {
    let discs = Discs::of(mesh)?;
    let cells: Vec<Cell> = Cell::grid(discs.rims.len()).collect();
    let mut points = vec![[0.0; 2]; discs.places.len()];
    for (rim, &cell) in discs.rims.iter().zip(&cells) {
        let lengths = discs.rim_lengths(rim);
        let no_square = FlattenError::NoSquare { vertex: VertexId(rim[0]) };
        let outline = match request.boundary {
            Boundary::Circle => Outline::Circle,
            Boundary::Square => Outline::Square(corners_by_length(&lengths).ok_or(no_square)?),
            Boundary::SquareAt(corners) => Outline::Square(places_in(rim, corners).ok_or(no_square)?),
        };
        let places = rim_points(&lengths, outline, cell);
        rim.iter().zip(places).for_each(|(&node, place)| points[node as usize] = place);
    }
    let laplacian =
        Laplacian::of(&discs.triangles, discs.places.len(), discs.rims.iter().flatten().copied())?;
    let flat = match request.boundary {
        Boundary::Circle => Flat::default(),
        _ => Flat::find(&laplacian, &discs, &cells, &points),
    };
    let work = Work { discs: &discs, laplacian: &laplacian, flat: &flat };
    let mut layout = match request.weights {
        Weights::Uniform => work.uniform(points)?,
        Weights::Cotangent => {
            work.solve(&cotangents(&discs, &laplacian)?, &mut points)?;
            work.layout(points, 0)
        }
    };
    layout.points.truncate(mesh.counts().vertices);
    Ok(layout)
}

/// The places of four different vertices in a rim: the first, and the others as the rim comes to them.
fn places_in(rim: &[u32], corners: [VertexId; 4]) -> Option<[usize; 4]> {
    let mut places = [0; 4];
    for (place, corner) in places.iter_mut().zip(corners) {
        *place = rim.iter().position(|&node| node == corner.0)?;
    }
    let first = places[0];
    let after_first = |place: usize| (place + rim.len() - first) % rim.len();
    places.sort_unstable_by_key(|&place| after_first(place));
    places.windows(2).all(|pair| pair[0] != pair[1]).then_some(places)
}

/// What a layout is made of.
struct Work<'a> {
    discs: &'a Discs,
    laplacian: &'a Laplacian,
    flat: &'a Flat,
}

impl Work<'_> {
    fn solve(&self, weights: &[f64], points: &mut [[f64; 2]]) -> Result<(), FlattenError> {
        self.laplacian.solve(weights, points)?;
        self.flat.press(points);
        Ok(())
    }

    fn layout(&self, points: Vec<[f64; 2]>, rounds: usize) -> Layout {
        let (flipped, collapsed) = bad_faces(&self.discs.triangles, &self.discs.face_of, &points);
        Layout { points, discs: self.discs.rims.len(), flipped, collapsed, rounds }
    }

    /// Equal weights, reweighted while that leaves fewer bad faces. The faces that are bad then are untangled.
    fn uniform(&self, mut points: Vec<[f64; 2]>) -> Result<Layout, FlattenError> {
        let (triangles, ends) = (&self.discs.triangles, &self.laplacian.ends);
        self.solve(&vec![1.0; ends.len()], &mut points)?;
        let unavoidable = self.flat.collapsed_faces(self.discs);
        let bad = |layout: &Layout| layout.flipped.len() + layout.collapsed.len();
        let mut best = self.layout(points.clone(), 0);
        let mut factors = vec![1.0; points.len()];
        for round in 1.. {
            if bad(&best) <= unavoidable || round > best.rounds + PATIENCE {
                break;
            }
            factors = reweighted(&factors, triangles, &points);
            let product = |ends: &[u32; 2]| factors[ends[0] as usize] * factors[ends[1] as usize];
            self.solve(&ends.iter().map(product).collect::<Vec<f64>>(), &mut points)?;
            let layout = self.layout(points.clone(), round);
            if bad(&layout) < bad(&best) {
                best = layout;
            }
        }
        if bad(&best) > unavoidable {
            let may_move = |node: u32| self.laplacian.is_free(node as usize) && !self.flat.holds(node);
            untangle(triangles, &mut best.points, may_move);
            best = self.layout(best.points, best.rounds);
        }
        Ok(best)
    }
}
