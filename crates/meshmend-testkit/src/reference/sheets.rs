//! Rule 3, policy `sheets`: free sides round an edge of degree three or more, paired by their angles.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::{Pipeline, Side};

type Vector = [BigRational; 3];

/// The radial order of sides round an edge, and the group of equal angles of each that has one.
struct Radial {
    order: Vec<Side>,
    angle: BTreeMap<Side, usize>,
}

/// Which patch each face is in, and which closed, orientable patches have negative signed volume.
struct Solids {
    patch_of: BTreeMap<usize, usize>,
    reversed: BTreeSet<usize>,
}

impl Pipeline {
    pub(super) fn match_sheets(&mut self) {
        let solids = self.inside_out();
        for (edge, sides) in self.sides_by_welded() {
            if sides.len() < 3 || sides.iter().filter(|&&side| self.is_free(side)).count() < 2 {
                continue;
            }
            let Radial { order, angle } = self.radial_order(edge, &sides);
            let same_patch = |a: Side, b: Side| solids.patch_of[&a.0] == solids.patch_of[&b.0];
            let opposite = |of: &Self, a: Side, b: Side| of.is_forward(a) != of.is_forward(b);
            let outward = |of: &Self, side: Side| {
                of.is_forward(side) != solids.reversed.contains(&solids.patch_of[&side.0])
            };
            let around_solid =
                |of: &Self, a: Side, b: Side| opposite(of, a, b) && !outward(of, a) && outward(of, b);
            let apart = |a: Side, b: Side| !angle.contains_key(&a) || angle.get(&b) != angle.get(&a);
            self.pair_in_place(&order, |of, a, b| same_patch(a, b) && around_solid(of, a, b));
            self.pair_like_brackets(&order, |of, a, b| same_patch(a, b) && opposite(of, a, b) && apart(a, b));
            self.pair_in_place(&order, around_solid);
            self.pair_like_brackets(&order, opposite);
        }
    }

    /// Neighbours in the full circular order, once round.
    fn pair_in_place(&mut self, order: &[Side], wanted: impl Fn(&Self, Side, Side) -> bool) {
        for (i, &one) in order.iter().enumerate() {
            let other = order[(i + 1) % order.len()];
            if one != other && self.is_free(one) && self.is_free(other) && wanted(self, one, other) {
                self.pair(one, other);
            }
        }
    }

    /// Neighbours among the free sides, as brackets are matched; then the two ends of what is left.
    fn pair_like_brackets(&mut self, order: &[Side], wanted: impl Fn(&Self, Side, Side) -> bool) {
        let mut stack: Vec<Side> = Vec::new();
        let free: Vec<Side> = order.iter().copied().filter(|&side| self.is_free(side)).collect();
        for side in free {
            match stack.last() {
                Some(&top) if wanted(self, top, side) => {
                    stack.pop();
                    self.pair(top, side);
                }
                _ => stack.push(side),
            }
        }
        while let [first, .., last] = stack[..]
            && wanted(self, last, first)
        {
            self.pair(last, first);
            stack.pop();
            stack.remove(0);
        }
    }

    /// Counter-clockwise about the edge from its lower to its higher vertex, from the half-plane of the first side
    /// that has one; sides without a half-plane last.
    fn radial_order(&self, edge: [u32; 2], sides: &[Side]) -> Radial {
        let axis = minus(self.point(edge[1]), self.point(edge[0]));
        let mut sides = sides.to_vec();
        sides.sort_unstable();
        let (mut planes, mut undefined) = (Vec::new(), Vec::new());
        for side in sides {
            let inward = self.half_plane(side, &axis);
            if inward.iter().all(Zero::is_zero) {
                undefined.push(side);
            } else {
                planes.push((side, inward));
            }
        }
        let Some((_, zero)) = planes.first().cloned() else {
            return Radial { order: undefined, angle: BTreeMap::new() };
        };
        let quarter = cross(&axis, &zero);
        let is_far_half = |w: &Vector| {
            let (x, y) = (dot(w, &zero), dot(w, &quarter));
            !(y.is_positive() || (y.is_zero() && x.is_positive()))
        };
        let turn = |s: &Vector, t: &Vector| {
            let sine = dot(&axis, &cross(s, t));
            is_far_half(s).cmp(&is_far_half(t)).then_with(|| BigRational::zero().cmp(&sine))
        };
        planes.sort_by(|(one, s), (other, t)| {
            turn(s, t).then_with(|| (!self.is_forward(*one), *one).cmp(&(!self.is_forward(*other), *other)))
        });
        let (mut angle, mut group) = (BTreeMap::new(), 0);
        for (i, (side, plane)) in planes.iter().enumerate() {
            group += usize::from(i > 0 && turn(&planes[i - 1].1, plane) != Ordering::Equal);
            angle.insert(*side, group);
        }
        Radial { order: planes.into_iter().map(|(side, _)| side).chain(undefined).collect(), angle }
    }

    /// The direction from the edge into the face: its area vector × the direction of the side.
    fn half_plane(&self, side: Side, axis: &Vector) -> Vector {
        let points: Vec<&Vector> =
            self.faces[side.0].corners.iter().map(|&c| self.point(self.name(c))).collect();
        let mut normal = [0; 3].map(|_| BigRational::zero());
        for (i, p) in points.iter().enumerate() {
            let q = points[(i + 1) % points.len()];
            normal = plus(&normal, &cross(&minus(p, points[0]), &minus(q, points[0])));
        }
        let inward = cross(&normal, axis);
        if self.is_forward(side) { inward } else { inward.map(|x| -x) }
    }

    fn inside_out(&self) -> Solids {
        let patches = self.patches.iter().enumerate();
        let patch_of: BTreeMap<usize, usize> =
            patches.flat_map(|(p, patch)| patch.iter().map(move |&f| (f, p))).collect();
        let mut volume = vec![BigRational::zero(); self.patches.len()];
        let mut balance: BTreeMap<(usize, [u32; 2]), i64> = BTreeMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            let points: Vec<&Vector> = face.corners.iter().map(|&c| self.point(self.name(c))).collect();
            for pair in points[1..].windows(2) {
                volume[patch_of[&f]] += dot(points[0], &cross(pair[0], pair[1]));
            }
            for place in 0..face.corners.len() {
                let [a, b] = face.side(place).map(|v| self.name(v));
                let sides = balance.entry((patch_of[&f], [a.min(b), a.max(b)])).or_insert(0);
                *sides += if self.is_forward((f, place)) { 1 } else { -1 };
            }
        }
        let mut open: BTreeSet<usize> = self.non_orientable.iter().map(|patch| patch_of[&patch[0]]).collect();
        open.extend(balance.iter().filter(|(_, sides)| **sides != 0).map(|((patch, _), _)| *patch));
        let is_reversed = |p: &usize| volume[*p].is_negative() && !open.contains(p);
        let reversed = (0..self.patches.len()).filter(is_reversed).collect();
        Solids { patch_of, reversed }
    }
}

pub(super) fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

pub(super) fn plus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

pub(super) fn cross(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub(super) fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
