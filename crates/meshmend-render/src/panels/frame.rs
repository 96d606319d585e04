//! Fitting what is seen into a rectangle of the picture.

use crate::scenes::camera::Camera;
use crate::vector::Vector;

/// A rectangle of the picture, in pixels; y goes down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// A box along the axes; of no point it is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    low: Vector,
    high: Vector,
}

impl Bounds {
    pub(crate) const EMPTY: Bounds = Bounds { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// The box around finite points.
    pub(crate) fn of(points: impl Iterator<Item = Vector>) -> Self {
        points.fold(Bounds::EMPTY, |bounds, point| bounds.and(Bounds { low: point, high: point }))
    }

    /// The box around two boxes.
    pub(crate) fn and(self, other: Bounds) -> Self {
        let pick = |choose: fn(f64, f64) -> f64, a: Vector, b: Vector| {
            [choose(a[0], b[0]), choose(a[1], b[1]), choose(a[2], b[2])]
        };
        Bounds { low: pick(f64::min, self.low, other.low), high: pick(f64::max, self.high, other.high) }
    }

    /// Its width and height; nothing of an empty one.
    pub(crate) fn extent(&self) -> [f64; 2] {
        [0, 1].map(|axis| (self.high[axis] - self.low[axis]).max(0.0))
    }

    fn is_empty(&self) -> bool {
        self.low[0] > self.high[0]
    }
}

/// Brings the points of a box near one, whatever their size: its middle to zero, half its longest side to one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    middle: Vector,
    half: f64,
}

impl Unit {
    pub(crate) fn of(bounds: Bounds) -> Self {
        if bounds.is_empty() {
            return Unit { middle: [0.0; 3], half: 1.0 };
        }
        // Halved first: neither the sum nor the difference of two coordinates need be finite.
        let ends = |axis: usize| (bounds.low[axis] / 2.0, bounds.high[axis] / 2.0);
        let middle = [0, 1, 2].map(|axis| ends(axis).0 + ends(axis).1);
        let longest = [0, 1, 2].iter().fold(0.0_f64, |half, &axis| half.max(ends(axis).1 - ends(axis).0));
        Unit { middle, half: if longest > 0.0 { longest } else { 1.0 } }
    }

    pub(crate) fn apply(&self, point: Vector) -> Vector {
        [0, 1, 2].map(|axis| (point[axis] - self.middle[axis]) / self.half)
    }
}

/// From space to a panel's pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    camera: Camera,
    unit: Unit,
    /// Pixels a unit.
    scale: f64,
    /// What comes to the middle of the panel, and where that is.
    middle: [f64; 2],
    origin: [f64; 2],
}

impl Frame {
    /// Fits points as [projected](Frame::projected) into a panel of a width and a height.
    pub(crate) fn new(camera: Camera, unit: Unit, seen: Bounds, panel: Rectangle, margin: f64) -> Self {
        let room = [panel.width, panel.height].map(|length| (length - 2.0 * margin).max(1.0));
        let origin = [panel.width / 2.0, panel.height / 2.0];
        if seen.is_empty() {
            return Frame { camera, unit, scale: 1.0, middle: [0.0; 2], origin };
        }
        let fit = |axis: usize| room[axis] / (seen.high[axis] - seen.low[axis]);
        let scale = fit(0).min(fit(1));
        let middle = [0, 1].map(|axis| (seen.low[axis] + seen.high[axis]) / 2.0);
        Frame { camera, unit, scale: if scale.is_finite() { scale } else { 1.0 }, middle, origin }
    }

    /// A point as projected, before it is fitted.
    pub(crate) fn projected(camera: &Camera, unit: &Unit, point: Vector) -> Vector {
        camera.project(camera.turn(unit.apply(point)))
    }

    /// A point as turned towards the eye, of size about one.
    pub(crate) fn turned(&self, point: Vector) -> Vector {
        self.camera.turn(self.unit.apply(point))
    }

    /// A point in the panel: x to the right and y down in pixels, and how near it is, in units of about one.
    pub(crate) fn place(&self, point: Vector) -> Vector {
        let [x, y, near] = Frame::projected(&self.camera, &self.unit, point);
        [
            self.origin[0] + (x - self.middle[0]) * self.scale,
            self.origin[1] - (y - self.middle[1]) * self.scale,
            near,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fitted(points: &[Vector], camera: Camera) -> Vec<Vector> {
        let unit = Unit::of(Bounds::of(points.iter().copied()));
        let seen = Bounds::of(points.iter().map(|&p| Frame::projected(&camera, &unit, p)));
        let panel = Rectangle { left: 0.0, top: 0.0, width: 120.0, height: 60.0 };
        let frame = Frame::new(camera, unit, seen, panel, 10.0);
        points.iter().map(|&p| frame.place(p)).collect()
    }

    #[test]
    fn what_is_seen_fills_the_panel_but_for_its_margin() {
        let plan = Camera::from([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).unwrap();
        let placed = fitted(&[[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]], plan);
        assert_eq!(placed, [[40.0, 50.0, -0.5], [80.0, 10.0, -0.5], [40.0, 10.0, 0.5]]);
    }

    #[test]
    fn huge_and_tiny_coordinates_are_fitted_too() {
        let plan = Camera::from([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).unwrap();
        let small = fitted(&[[-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]], plan);
        for factor in [f64::MAX, 1e-300] {
            let placed = fitted(&[[-factor, -factor, 0.0], [factor, factor, 0.0]], plan);
            assert_eq!(placed, small);
        }
        let one = fitted(&[[f64::MAX, 0.0, 5.0]], plan);
        assert_eq!(one, [[60.0, 30.0, 0.0]]);
        assert!(fitted(&[], plan).is_empty());
    }
}
