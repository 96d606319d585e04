//! Random operators, and every operator that a small surface offers.

use super::surface::Surface;
use super::{Kind, Opening, Operator, Side};

/// Numbers that say which operator and where, whatever surface there is when it is applied; so a sequence of them still
/// means something when some are left out.
#[derive(Clone, Copy, Debug)]
pub struct Draw {
    kind: Kind,
    at: [u64; 3],
}

/// Numbers from a seed, the same everywhere (splitmix64).
pub(super) struct Numbers(pub(super) u64);

impl Numbers {
    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ bits >> 31
    }

    pub(super) fn draw(&mut self) -> Draw {
        Draw::new(self.next(), [self.next(), self.next(), self.next()])
    }
}

impl Draw {
    /// An operator of some kind at some elements.
    pub fn new(kind: u64, at: [u64; 3]) -> Self {
        Draw { kind: Kind::ALL[(kind % Kind::ALL.len() as u64) as usize], at }
    }

    /// The operator on faces that a half-edge structure holds. None where these have nothing for it.
    pub fn operator(&self, faces: &[Vec<u32>]) -> Option<Operator> {
        self.on(&Surface::of(faces.to_vec())?)
    }

    /// The operator on a surface. None where that has nothing for it.
    pub(super) fn on(&self, surface: &Surface) -> Option<Operator> {
        let halves: Vec<Side> = surface.halves().into_iter().collect();
        let (holes, sides): (Vec<Side>, Vec<Side>) = halves.iter().partition(|&&side| surface.is_hole(side));
        let any =
            |from: &[Side], at: usize| from.get((self.at[at] % from.len().max(1) as u64) as usize).copied();
        let side = any(&sides, 0)?;
        let of_face = surface.face_from(side)?;
        let along = |at: usize| {
            let place = (self.at[at] % of_face.len() as u64) as usize;
            [of_face[place], of_face[(place + 1) % of_face.len()]]
        };
        Some(match self.kind {
            Kind::SplitEdge => Operator::SplitEdge(any(&halves, 0)?),
            Kind::JoinEdges => Operator::JoinEdges(side[0]),
            Kind::SplitFace => Operator::SplitFace(side, along(1)),
            Kind::JoinFaces => Operator::JoinFaces(side),
            Kind::Poke => Operator::Poke(side),
            Kind::RemoveVertex => Operator::RemoveVertex(side[0]),
            Kind::Flip => Operator::Flip(side),
            Kind::Collapse => Operator::Collapse(any(&halves, 0)?),
            Kind::SplitVertex => {
                let star = surface.star(side[0]);
                let opening = |at: usize| {
                    let half = [side[0], star[(self.at[at] / 2 % star.len() as u64) as usize]];
                    if self.at[at].is_multiple_of(2) { Opening::Corner(half) } else { Opening::Edge(half) }
                };
                Operator::SplitVertex(opening(1), opening(2))
            }
            Kind::OpenFace => Operator::OpenFace(side),
            Kind::CloseHole => Operator::CloseHole(any(&holes, 1)?),
            Kind::CutLoop => {
                let loops = loops_from(surface, side, 4 + (self.at[1] % 4) as usize);
                Operator::CutLoop(loops.get((self.at[2] % loops.len().max(1) as u64) as usize)?.clone())
            }
            Kind::ZipHoles => Operator::ZipHoles(any(&holes, 0)?, any(&holes, 1)?),
        })
    }
}

/// The closed walks of different vertices along a half-edge and up to so many in all.
fn loops_from(surface: &Surface, [a, b]: Side, longest: usize) -> Vec<Vec<u32>> {
    let (mut found, mut open) = (Vec::new(), vec![vec![a, b]]);
    while let Some(walk) = open.pop() {
        let Some(&last) = walk.last() else { continue };
        for next in surface.star(last) {
            if next == a && walk.len() > 2 {
                found.push(walk.clone());
            } else if walk.len() < longest && !walk.contains(&next) && open.len() < 200 {
                open.push(walk.iter().copied().chain([next]).collect());
            }
        }
        if found.len() > 50 {
            break;
        }
    }
    found
}

/// Every operator on a surface, also where it is nonsense.
pub(super) fn all_operators(surface: &Surface) -> Vec<Operator> {
    let halves: Vec<Side> = surface.halves().into_iter().collect();
    let mut all: Vec<Operator> = surface.vertices().into_iter().flat_map(of_vertex).collect();
    for &side in &halves {
        all.extend(of_side(surface, side, 6));
        all.extend(halves.iter().map(|&other| Operator::SplitFace(side, other)));
        let holes = halves.iter().filter(|&&other| surface.is_hole(side) && surface.is_hole(other));
        all.extend(holes.map(|&other| Operator::ZipHoles(side, other)));
    }
    all
}

/// Operators of every kind that name a vertex.
pub(super) fn operators_at(surface: &Surface, vertex: u32) -> Vec<Operator> {
    let sides: Vec<Side> =
        surface.star(vertex).into_iter().flat_map(|n| [[vertex, n], [n, vertex]]).collect();
    let mut all = of_vertex(vertex).to_vec();
    all.extend(sides.iter().flat_map(|&side| of_side(surface, side, 4)));
    for &side in &sides {
        all.extend(
            sides
                .iter()
                .flat_map(|&other| [Operator::SplitFace(side, other), Operator::ZipHoles(side, other)]),
        );
    }
    all
}

fn of_vertex(vertex: u32) -> [Operator; 2] {
    [Operator::JoinEdges(vertex), Operator::RemoveVertex(vertex)]
}

/// The operators on one half-edge, on a loop along it, and on an arc that begins there.
fn of_side(surface: &Surface, side: Side, longest_loop: usize) -> Vec<Operator> {
    let mut all = vec![
        Operator::SplitEdge(side),
        Operator::JoinFaces(side),
        Operator::Poke(side),
        Operator::Flip(side),
        Operator::Collapse(side),
        Operator::OpenFace(side),
        Operator::CloseHole(side),
    ];
    let ends = |side: Side| [Opening::Corner(side), Opening::Edge(side)];
    for other in surface.star(side[0]) {
        let pairs = ends(side).into_iter().flat_map(|from| ends([side[0], other]).map(|to| (from, to)));
        all.extend(pairs.map(|(from, to)| Operator::SplitVertex(from, to)));
    }
    all.extend(loops_from(surface, side, longest_loop).into_iter().map(Operator::CutLoop));
    all
}
