//! Two holes of the same length are sewn together.

use crate::refusal::unless;
use crate::{Done, Edit, EditRefusal, Editor, FaceKey, HalfKey, Refused, VertexKey};

/// Two holes laid on each other: at each place a half-edge of either, which run opposite ways.
struct Zip {
    kept: Vec<HalfKey>,
    gone: Vec<HalfKey>,
}

impl Editor {
    /// Whether two holes can be sewn together, so that one half-edge comes to lie on the other, end on beginning.
    ///
    /// # Errors
    /// `stale`; `not-a-hole`; `same-hole`; `different-lengths`; `vertex-twice` for each face that would come back to a vertex;
    /// `already-joined` for each edge that would be there twice.
    pub fn can_zip_holes(&self, half: HalfKey, other: HalfKey) -> Result<(), Refused> {
        self.fresh([half.into(), other.into()])?;
        let closed = [half, other].into_iter().filter(|&half| self.halves[half].face.is_some());
        unless(closed.map(EditRefusal::NotAHole).collect())?;
        if self.round(half).any(|along| along == other) {
            return Err(EditRefusal::SameHole([half, other]).into());
        }
        let lengths = [half, other].map(|half| self.round(half).count());
        if lengths[0] != lengths[1] {
            return Err(EditRefusal::DifferentLengths(lengths).into());
        }
        let zip = self.zip(half, other);
        let mut reasons = Vec::new();
        for (&kept, &gone) in zip.kept.iter().zip(&zip.gone) {
            let pair = [self.halves[kept].origin, self.target_of(gone)];
            reasons.extend(self.faces_of_both(pair).into_iter().map(EditRefusal::VertexTwice));
        }
        let joined = self.joined_twice(&zip);
        reasons.extend(joined.into_iter().map(EditRefusal::AlreadyJoined));
        unless(reasons)
    }

    fn zip(&self, half: HalfKey, other: HalfKey) -> Zip {
        let mut gone: Vec<HalfKey> = self.round(other).collect();
        // The other hole is gone round backwards, from the given half-edge on.
        gone[1..].reverse();
        Zip { kept: self.round(half).collect(), gone }
    }

    /// The faces that have both vertices.
    fn faces_of_both(&self, pair: [VertexKey; 2]) -> Vec<FaceKey> {
        let [mut one, other] =
            pair.map(|v| self.star_of(v).filter_map(|half| self.halves[half].face).collect::<Vec<FaceKey>>());
        one.sort_unstable();
        let mut both: Vec<FaceKey> =
            other.into_iter().filter(|face| one.binary_search(face).is_ok()).collect();
        both.sort_unstable();
        both
    }

    /// The pairs of vertices, after the holes are one seam, that more than one edge would join.
    fn joined_twice(&self, zip: &Zip) -> Vec<[VertexKey; 2]> {
        let mut instead: Vec<(VertexKey, VertexKey)> = zip
            .kept
            .iter()
            .zip(&zip.gone)
            .map(|(&kept, &gone)| (self.target_of(gone), self.halves[kept].origin))
            .collect();
        instead.sort_unstable();
        let renamed = |vertex: VertexKey| match instead.binary_search_by_key(&vertex, |&(gone, _)| gone) {
            Ok(at) => instead[at].1,
            Err(_) => vertex,
        };
        let mut joined = Vec::new();
        for (&kept, &gone) in zip.kept.iter().zip(&zip.gone) {
            let vertex = self.halves[kept].origin;
            let seam = [gone, self.halves[gone].next].map(|half| self.halves[half].edge);
            let others =
                self.star_of(self.target_of(gone)).filter(|&half| !seam.contains(&self.halves[half].edge));
            let all = self.star(kept).chain(others).map(|half| renamed(self.target_of(half)));
            let mut ends: Vec<VertexKey> = all.chain([vertex]).collect();
            ends.sort_unstable();
            let twice = ends.windows(2).filter(|pair| pair[0] == pair[1]);
            joined.extend(twice.map(|pair| [vertex.min(pair[0]), vertex.max(pair[0])]));
        }
        joined.sort_unstable();
        joined.dedup();
        joined
    }

    /// Sews two holes together, so that one half-edge comes to lie on the other, end on beginning. The vertices of the first hole
    /// stay. [`Editor::cut_loop`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_zip_holes`].
    ///
    /// *Cost*: O(n log n) in the sides of the holes and the edges of their vertices.
    pub fn zip_holes(&mut self, half: HalfKey, other: HalfKey) -> Result<Done, Refused> {
        self.can_zip_holes(half, other)?;
        let zip = self.zip(half, other);
        let pairs: Vec<[VertexKey; 2]> = zip
            .kept
            .iter()
            .zip(&zip.gone)
            .map(|(&kept, &gone)| [self.halves[kept].origin, self.target_of(gone)])
            .collect();
        for &[kept, gone] in &pairs {
            let star: Vec<HalfKey> = self.star_of(gone).collect();
            self.hand_over(&star, gone, kept);
        }
        let mut seam = Vec::with_capacity(pairs.len());
        for (&kept, &gone) in zip.kept.iter().zip(&zip.gone) {
            let [inside, across] = [kept, gone].map(|half| self.halves[half].twin);
            let edge = self.halves[inside].edge;
            self.edges.remove(self.halves[across].edge);
            self.halves.remove(kept);
            self.halves.remove(gone);
            self.pair(inside, across, edge);
            let origin = self.halves[inside].origin;
            self.vertices[origin].half = Some(inside);
            seam.push(inside);
        }
        pairs.iter().for_each(|&[_, gone]| _ = self.vertices.remove(gone));
        seam.reverse();
        Ok(Done::undone_by(Edit::CutLoop { halves: seam }))
    }
}
