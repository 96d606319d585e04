//! Which closed components lie inside others, and which are inside out?
//!
//! A *component* is a set of faces that hang together through vertices; it is *closed* when each of its edges has two sides.
//! The *depth* of a closed component is the number of other closed ones that hold its *anchor*: the least of its points that does
//! not lie on the other one, in the order of x, y and z. Where all lie on it, the other does not hold it. It *holds* a
//! point when a ray from there, towards +z and moved by an infinitesimal, passes an odd number of its faces ([`passage`]).
//!
//! | depth | volume below 0 | volume above 0 |
//! |---|---|---|
//! | even | inside out | a solid |
//! | odd | the wall of a cavity | a solid within a solid |
//!
//! Depth depends neither on orientation nor on names. Every sign is that of real arithmetic.

mod depth;
mod parts;
mod passage;

use meshmend_core::{Cancelled, Column, EdgeId, FaceId, ITEMS_BETWEEN_LOOKS};
use meshmend_geometry::vector::{Point, cross, dot, minus};

use crate::Surface;
use crate::exact::{Sign, volume_sign};
use crate::unit::Unit;

use depth::depths;
use parts::{Part, parts};

pub use passage::{lies_on, passage, passage_of_turns};

/// The components of a mesh, and what is inside of what.
#[derive(Clone, Debug)]
pub struct Nesting {
    /// The components, by lowest face.
    pub components: Vec<NestedComponent>,
    of_face: Column<FaceId, u32>,
}

/// A component with its place among the others.
#[derive(Clone, Debug, PartialEq)]
pub struct NestedComponent {
    /// Its lowest face.
    pub lowest_face: FaceId,
    /// How many faces it has.
    pub faces: u32,
    /// Whether each of its edges has two sides.
    pub is_closed: bool,
    /// Whether no two of its faces run the same way along an edge that they alone have.
    pub is_oriented: bool,
    /// How many other closed components hold it; `None` if it encloses no space.
    pub depth: Option<u32>,
    /// Its state; `None` if it encloses no space or has no orientation.
    pub state: Option<NestingState>,
    /// Its signed volume, in doubles; 0 where rounding leaves no sign.
    pub volume: Option<f64>,
    /// Why depth or state are absent.
    pub reason: Option<NoSpace>,
}

/// How a closed component is turned, where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NestingState {
    /// A solid: it looks outward, in an even number of others.
    Outward,
    /// It looks inward, in an even number of others.
    InsideOut,
    /// The wall of a hollow: it looks inward, in an odd number of others.
    Cavity,
    /// It looks outward, in an odd number of others: the space in it is counted twice.
    SolidWithin,
    /// It encloses as much space on one side as on the other.
    NoVolume,
}

impl NestingState {
    /// The state of a component in so many others whose volume has a sign.
    pub fn of(depth: u32, volume: Sign) -> Self {
        match (volume, depth.is_multiple_of(2)) {
            (Sign::Zero, _) => NestingState::NoVolume,
            (Sign::Positive, true) => NestingState::Outward,
            (Sign::Negative, true) => NestingState::InsideOut,
            (Sign::Negative, false) => NestingState::Cavity,
            (Sign::Positive, false) => NestingState::SolidWithin,
        }
    }

    /// The state in a word, as reports have it.
    pub fn name(self) -> &'static str {
        match self {
            NestingState::Outward => "outward",
            NestingState::InsideOut => "inside-out",
            NestingState::Cavity => "cavity",
            NestingState::SolidWithin => "solid-within",
            NestingState::NoVolume => "no-volume",
        }
    }
}

/// Why a component encloses no space, or has no orientation: the first that applies, at its lowest element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NoSpace {
    /// A corner of the face is not finite.
    NotFinite(FaceId),
    /// The edge has three sides or more.
    NonManifold(EdgeId),
    /// The edge has one side.
    Open(EdgeId),
    /// The face, of four corners or more, has two at one position.
    NoSurface(FaceId),
    /// Two faces run along the edge the same way.
    Inconsistent(EdgeId),
}

impl Nesting {
    /// The component of a face, by its place; `None` for a degenerate face.
    pub fn component_of(&self, face: FaceId) -> Option<usize> {
        let place = self.of_face[face];
        (place != parts::NO_PART).then_some(place as usize)
    }
}

/// What is inside of what in the mesh of a surface.
///
/// # Errors
/// When whoever watches the surface stops it.
///
/// *Cost*: O(n log n) for components that touch each other at few points, on all threads; for each that touches another,
/// each of its points on that one costs a search.
pub fn nesting(surface: &Surface<'_>) -> Result<Nesting, Cancelled> {
    const STEP: &str = "nesting";
    let (mesh, watch) = (surface.mesh(), surface.watch());
    watch.look(STEP, 0, 0)?;
    let parts = parts(mesh, surface);
    watch.look(STEP, 0, parts.list.len())?;
    let depths = depths(mesh, surface, &parts);
    watch.look(STEP, 0, parts.list.len())?;
    let triangles = parts.triangles(surface);
    watch.look(STEP, 0, parts.list.len())?;
    let (mut faces, count) = (0, parts.list.len());
    let judged = parts.list.iter().zip(depths).zip(&triangles).enumerate();
    let judged = judged.map(|(place, ((part, depth), triangles))| {
        faces += part.faces as usize;
        if faces > ITEMS_BETWEEN_LOOKS {
            faces = 0;
            watch.look(STEP, place, count)?;
        }
        Ok(judged_part(part, depth, triangles))
    });
    Ok(Nesting { components: judged.collect::<Result<_, Cancelled>>()?, of_face: parts.of_face })
}

fn judged_part(part: &Part, depth: Option<u32>, triangles: &[[Point; 3]]) -> NestedComponent {
    let mut found = NestedComponent {
        lowest_face: part.lowest_face,
        faces: part.faces,
        is_closed: part.is_closed,
        is_oriented: part.is_oriented,
        depth,
        state: None,
        volume: None,
        reason: part.reason,
    };
    if let (Some(depth), None) = (depth, part.reason) {
        let sign = volume_sign(triangles.iter().copied());
        let volume = volume(triangles);
        found.volume = Some(if Sign::of(volume) == sign { volume } else { 0.0 });
        found.state = Some(NestingState::of(depth, sign));
    }
    found
}

/// The signed volume of closed triangles, in doubles.
fn volume(triangles: &[[Point; 3]]) -> f64 {
    let largest = triangles.iter().flatten().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    let unit = Unit::of(largest);
    let Some(origin) = triangles.first().map(|triangle| unit.shrunk(triangle[0])) else { return 0.0 };
    let of_triangle = |triangle: &[Point; 3]| {
        let [a, b, c] = triangle.map(|corner| minus(unit.shrunk(corner), origin));
        dot(a, cross(b, c))
    };
    let sixfold: f64 = triangles.iter().map(of_triangle).sum();
    unit.length(unit.area(sixfold.abs() / 6.0)).copysign(sixfold)
}

#[cfg(test)]
mod tests {
    use meshmend_core::PolygonMesh;
    use proptest::prelude::*;

    use super::*;

    /// The corners and triangles of a box, looking outward.
    fn block(low: Point, high: Point) -> (Vec<Point>, Vec<[u32; 3]>) {
        let at = |code: u32| -> Point {
            std::array::from_fn(|axis| if code >> (2 - axis) & 1 == 0 { low[axis] } else { high[axis] })
        };
        let quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
        let triangles = quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        ((0..8).map(at).collect(), triangles)
    }

    /// Cubes about one centre, each by half its length and whether it looks outward.
    fn cubes(sizes: &[(f64, bool)], scale: f64) -> PolygonMesh {
        let (mut points, mut faces) = (Vec::new(), Vec::new());
        for &(size, is_outward) in sizes {
            let (corners, triangles) = block([-size * scale; 3], [size * scale; 3]);
            let first = points.len() as u32;
            faces.extend(triangles.into_iter().map(|[a, b, c]| {
                let corners = if is_outward { [a, b, c] } else { [a, c, b] };
                corners.map(|corner| first + corner)
            }));
            points.extend(corners);
        }
        PolygonMesh::from_triangles(&points, &faces).unwrap()
    }

    fn states(mesh: &PolygonMesh) -> Vec<(Option<u32>, Option<NestingState>)> {
        nesting(&Surface::of(mesh).unwrap())
            .unwrap()
            .components
            .into_iter()
            .map(|part| (part.depth, part.state))
            .collect()
    }

    #[test]
    fn what_is_around_alternates_at_any_scale() {
        use NestingState::{Cavity, InsideOut, Outward, SolidWithin};
        for scale in [1.0, 5e-324, 1e-200, 1e200, 4e307] {
            let mesh = cubes(&[(3.0, false), (1.0, true), (4.0, true), (2.0, false)], scale);
            let expected = [(1, Cavity), (3, SolidWithin), (0, Outward), (2, InsideOut)];
            assert_eq!(states(&mesh), expected.map(|(depth, state)| (Some(depth), Some(state))), "{scale}");
        }
        let mesh = cubes(&[(1.0, true), (2.0, false)], 1.0);
        let found = nesting(&Surface::of(&mesh).unwrap()).unwrap();
        assert_eq!(
            found.components.iter().map(|part| part.volume).collect::<Vec<_>>(),
            [Some(8.0), Some(-64.0)]
        );
        assert_eq!((found.component_of(FaceId(11)), found.component_of(FaceId(12))), (Some(0), Some(1)));
    }

    #[test]
    fn what_encloses_no_space_says_why() {
        let reason = |points: &[Point], faces: &[[u32; 3]]| {
            let mesh = PolygonMesh::from_triangles(points, faces).unwrap();
            let [part] = &nesting(&Surface::of(&mesh).unwrap()).unwrap().components[..] else {
                panic!("one")
            };
            (part.depth, part.reason)
        };
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
        let solid = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        assert_eq!(reason(&points, &solid), (Some(0), None));
        assert_eq!(reason(&points, &solid[1..]), (None, Some(NoSpace::Open(EdgeId(0)))));
        let turned = [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        assert_eq!(reason(&points, &turned), (Some(0), Some(NoSpace::Inconsistent(EdgeId(0)))));
        let finned = [solid.as_slice(), &[[0, 1, 4]]].concat();
        assert_eq!(reason(&points, &finned), (None, Some(NoSpace::NonManifold(EdgeId(0)))));
        let mut far = points;
        far[2] = [f64::NAN; 3];
        assert_eq!(reason(&far, &solid), (None, Some(NoSpace::NotFinite(FaceId(0)))));
    }

    /// The depth of a box among others by its definition, each box by its lowest corner and its lengths.
    fn depth_of_box(one: usize, boxes: &[([i32; 3], [i32; 3])]) -> u32 {
        let (low, size) = boxes[one];
        let corners = (0..8).map(|code| [4, 2, 1].map(|bit| i32::from(code & bit > 0)));
        let corners: Vec<[i32; 3]> =
            corners.map(|up| std::array::from_fn(|axis| low[axis] + up[axis] * size[axis])).collect();
        let holds = |&(low, size): &([i32; 3], [i32; 3])| {
            let is_in = |point: &[i32; 3], border: i32| {
                (0..3).all(|i| point[i] >= low[i] + border && point[i] <= low[i] + size[i] - border)
            };
            let anchor = corners.iter().find(|point| !is_in(point, 0) || is_in(point, 1));
            anchor.is_some_and(|point| is_in(point, 1))
        };
        let others = boxes.iter().enumerate().filter(|&(other, _)| other != one);
        others.filter(|(_, other)| holds(other)).count() as u32
    }

    proptest! {
        #[test]
        fn depths_of_boxes_are_those_of_the_definition_whichever_way_they_look(
            boxes in prop::collection::vec((prop::array::uniform3(0i32..5), prop::array::uniform3(1i32..5)), 2..6),
            turned in any::<u8>(),
        ) {
            let mesh = |order: &[usize], turned: u8| {
                let (mut points, mut faces) = (Vec::new(), Vec::new());
                for &at in order {
                    let (low, size) = boxes[at];
                    let high = std::array::from_fn(|axis| f64::from(low[axis] + size[axis]));
                    let (corners, triangles) = block(low.map(f64::from), high);
                    let first = points.len() as u32;
                    faces.extend(triangles.into_iter().map(|[a, b, c]| {
                        let is_turned = turned >> at & 1 == 1;
                        (if is_turned { [a, c, b] } else { [a, b, c] }).map(|corner| first + corner)
                    }));
                    points.extend(corners);
                }
                PolygonMesh::from_triangles(&points, &faces).unwrap()
            };
            let order: Vec<usize> = (0..boxes.len()).collect();
            let depths = |mesh: &PolygonMesh| -> Vec<Option<u32>> {
                states(mesh).into_iter().map(|(depth, _)| depth).collect()
            };
            let expected: Vec<Option<u32>> = order.iter().map(|&one| Some(depth_of_box(one, &boxes))).collect();
            prop_assert_eq!(&depths(&mesh(&order, 0)), &expected);
            prop_assert_eq!(&depths(&mesh(&order, turned)), &expected);
            let reversed: Vec<usize> = order.into_iter().rev().collect();
            let mut found = depths(&mesh(&reversed, turned));
            found.reverse();
            prop_assert_eq!(found, expected);
        }
    }
}
