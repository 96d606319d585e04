//! Which faces are near a seam, and on which of its sides?

use super::flow::Region;
use super::sides::Sides;

/// How far from the seam faces may be turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// Anywhere.
    All,
    /// Within so many steps.
    Steps(u32),
}

/// A signed edge that clashes, and which of its two faces says on which side it is.
pub(super) type Seed = (u32, usize);

/// Memory for searches through a graph.
#[derive(Debug)]
pub(super) struct Surroundings {
    /// How many steps a face is from the seam, or from a seed; `OUTSIDE` between two searches.
    distance: Vec<u32>,
}

const OUTSIDE: u32 = u32::MAX;
const UNREACHED: u32 = u32::MAX - 1;

impl Surroundings {
    pub(super) fn of(sides: &Sides<'_>) -> Self {
        Surroundings { distance: vec![OUTSIDE; sides.graph.face_count()] }
    }

    /// The faces at a clashing signed edge, and at one that is as far from it as any.
    pub(super) fn seeds(&mut self, sides: &Sides<'_>, reach: Reach) -> Vec<Seed> {
        let Some(first) = sides.clashing().next() else { return Vec::new() };
        let (faces, _) = self.near(sides, reach);
        self.measure(sides, (first, 0));
        let distance = |signed_edge: u32| {
            sides.graph.signed_edge(signed_edge).ends.map(|face| self.distance[face as usize])
        };
        let nearer = |signed_edge: &u32| distance(*signed_edge).into_iter().min();
        let farthest = sides.clashing().max_by_key(nearer).unwrap_or(first);
        self.forget(&faces);
        vec![(first, 0), (first, 1), (farthest, 0), (farthest, 1)]
    }

    /// The faces that may be turned, with those that are held: of each clashing signed edge the face that is nearer
    /// to the seed, and what is one step too far from the seam.
    pub(super) fn region(&mut self, sides: &Sides<'_>, reach: Reach, seed: Seed) -> Region {
        let (faces, mut held) = self.near(sides, reach);
        self.measure(sides, seed);
        let by_distance = |signed_edge: u32| {
            let [one, other] = sides.graph.signed_edge(signed_edge).ends;
            let is_swapped = self.distance[other as usize] < self.distance[one as usize];
            if is_swapped { [other, one] } else { [one, other] }
        };
        held.extend(sides.clashing().map(|signed_edge| by_distance(signed_edge)[0]));
        held.sort_unstable();
        held.dedup();
        let free = sides.clashing().map(|signed_edge| (signed_edge, by_distance(signed_edge)[1]));
        let clashing = free.filter(|(_, free)| held.binary_search(free).is_err()).collect();
        self.forget(&faces);
        Region { faces, held, clashing }
    }

    /// The faces within reach of the seam, and those one step beyond, which are among them. All are unreached now.
    fn near(&mut self, sides: &Sides<'_>, reach: Reach) -> (Vec<u32>, Vec<u32>) {
        let Reach::Steps(most) = reach else {
            self.distance.fill(UNREACHED);
            return (sides.graph.faces().collect(), Vec::new());
        };
        let mut faces = Vec::new();
        for face in sides.clashing().flat_map(|signed_edge| sides.graph.signed_edge(signed_edge).ends) {
            self.reach(&mut faces, OUTSIDE, face, 0);
        }
        let mut done = 0;
        while let Some(&face) = faces.get(done) {
            done += 1;
            let steps = self.distance[face as usize] + 1;
            for arc in sides.graph.arcs(face).iter().filter(|_| steps <= most + 1) {
                self.reach(&mut faces, OUTSIDE, arc.to, steps);
            }
        }
        let beyond = faces.iter().copied().filter(|&face| self.distance[face as usize] > most).collect();
        faces.iter().for_each(|&face| self.distance[face as usize] = UNREACHED);
        (faces, beyond)
    }

    /// Sets the distances of unreached faces from a seed across signed edges that do not clash. Where a clashing
    /// signed edge has no face that is reached, the walk goes on from the same end of it.
    fn measure(&mut self, sides: &Sides<'_>, (seed, end): Seed) {
        let mut order = Vec::new();
        for signed_edge in std::iter::once(seed).chain(sides.clashing()) {
            let ends = sides.graph.signed_edge(signed_edge).ends;
            if ends.iter().any(|&face| self.distance[face as usize] != UNREACHED) {
                continue;
            }
            let mut done = order.len();
            self.reach(&mut order, UNREACHED, ends[end], 0);
            while let Some(&face) = order.get(done) {
                done += 1;
                let steps = self.distance[face as usize] + 1;
                for arc in sides.graph.arcs(face).iter().filter(|arc| !sides.clashes(arc.signed_edge)) {
                    self.reach(&mut order, UNREACHED, arc.to, steps);
                }
            }
        }
    }

    /// Gives a face its distance, if it is as given so far.
    fn reach(&mut self, order: &mut Vec<u32>, so_far: u32, face: u32, steps: u32) {
        if self.distance[face as usize] == so_far {
            self.distance[face as usize] = steps;
            order.push(face);
        }
    }

    fn forget(&mut self, faces: &[u32]) {
        faces.iter().for_each(|&face| self.distance[face as usize] = OUTSIDE);
    }
}
