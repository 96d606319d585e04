//! From where a mesh is seen: a direction, which way is up, and a projection.

use thiserror::Error;

use crate::vector::{Vector, cross, direction, dot};

/// How points in space become points in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Projection {
    /// Along parallel lines: what is of one length in space is so in the picture, wherever it is.
    #[default]
    Orthographic,
    /// Towards an eye two boxes' lengths away: what is nearer is larger.
    Perspective,
}

/// A direction from which to look, and what is up and right in the picture.
///
/// ```
/// # use meshmend_render::Camera;
/// let from_above = Camera::from([0.0, 0.0, 1.0], [0.0, 1.0, 0.0])?;
/// assert_eq!(from_above.right(), [1.0, 0.0, 0.0]);
/// # Ok::<(), meshmend_render::NoDirection>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    right: Vector,
    up: Vector,
    towards_eye: Vector,
    projection: Projection,
}

/// A camera was to look from a direction of no length, or one that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the direction to look from must be finite and not zero")]
pub struct NoDirection;

/// The eye's distance from the middle of the mesh, in halves of the longest side of its bounding box.
const EYE_DISTANCE: f64 = 4.0;

/// Below this sine of the angle between them, up and the direction of the eye are taken to be parallel.
const PARALLEL: f64 = 1e-9;

impl Camera {
    /// An eye that looks from a direction, seen from the mesh. Where `up` is not a direction or is that of the eye,
    /// up is the y axis, or the z axis.
    ///
    /// # Errors
    /// When the direction to look from has no length or is not finite.
    pub fn from(towards_eye: [f64; 3], up: [f64; 3]) -> Result<Self, NoDirection> {
        let towards_eye = direction(towards_eye).ok_or(NoDirection)?;
        let ups = [up, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut rights = ups.iter().filter_map(|&up| {
            let right = cross(direction(up)?, towards_eye);
            if dot(right, right).sqrt() < PARALLEL { None } else { direction(right) }
        });
        let right = rights.next().ok_or(NoDirection)?;
        let up = cross(towards_eye, right);
        Ok(Camera { right, up, towards_eye, projection: Projection::default() })
    }

    /// An eye at an azimuth about the z axis, counter-clockwise from the x axis, and an elevation above the xy plane,
    /// both in degrees. The z axis is up.
    ///
    /// # Errors
    /// When an angle is not finite.
    pub fn from_angles(azimuth: f64, elevation: f64) -> Result<Self, NoDirection> {
        let (azimuth, elevation) = (azimuth.to_radians(), elevation.to_radians());
        let level = elevation.cos();
        let towards_eye = [level * azimuth.cos(), level * azimuth.sin(), elevation.sin()];
        Camera::from(towards_eye, [0.0, 0.0, 1.0])
    }

    /// The same camera with another projection.
    pub fn with_projection(self, projection: Projection) -> Self {
        Camera { projection, ..self }
    }

    /// The direction in space that is to the right in the picture.
    pub fn right(&self) -> [f64; 3] {
        self.right
    }

    /// The direction in space that is up in the picture.
    pub fn up(&self) -> [f64; 3] {
        self.up
    }

    /// The direction of the eye.
    pub fn towards_eye(&self) -> [f64; 3] {
        self.towards_eye
    }

    /// A point as seen: how far to the right, how far up, how near.
    pub(crate) fn turn(&self, point: Vector) -> Vector {
        [dot(self.right, point), dot(self.up, point), dot(self.towards_eye, point)]
    }

    /// Projects a turned point whose coordinates are about one. Lines and planes stay such, so that nearness can be
    /// interpolated in the picture.
    pub(crate) fn project(&self, turned: Vector) -> Vector {
        match self.projection {
            Projection::Orthographic => turned,
            Projection::Perspective => {
                let factor = EYE_DISTANCE / (EYE_DISTANCE - turned[2]);
                turned.map(|x| x * factor)
            }
        }
    }
}

impl Default for Camera {
    /// From the right, in front and above, the z axis being up.
    fn default() -> Self {
        let half = 0.5_f64.sqrt();
        let (level, up) = (3.0_f64.sqrt() / 2.0, [-half / 2.0, half / 2.0, 3.0_f64.sqrt() / 2.0]);
        Camera {
            right: [half, half, 0.0],
            up,
            towards_eye: [half * level, -half * level, 0.5],
            projection: Projection::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(one: Vector, other: Vector) -> bool {
        one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-12)
    }

    #[test]
    fn right_up_and_eye_are_a_right_handed_frame() {
        let cameras = [
            Camera::default(),
            Camera::from([1e200, -3e200, 1e199], [0.0, 1.0, 0.3]).unwrap(),
            Camera::from_angles(123.0, -71.0).unwrap(),
        ];
        for camera in cameras {
            assert!(close(cross(camera.right, camera.up), camera.towards_eye));
            assert!(close(cross(camera.towards_eye, camera.right), camera.up));
            let lengths = [camera.right, camera.up, camera.towards_eye].map(|a| dot(a, a));
            assert!(close(lengths, [1.0; 3]));
        }
        let by_angles = Camera::from_angles(-45.0, 30.0).unwrap();
        assert!(close(by_angles.turn([1.0, 2.0, 3.0]), Camera::default().turn([1.0, 2.0, 3.0])));
    }

    #[test]
    fn an_up_that_is_none_is_replaced() {
        let plan = Camera::from_angles(0.0, 90.0).unwrap();
        assert!(close(plan.up(), [0.0, 1.0, 0.0]));
        let along_y = Camera::from([0.0, 1.0, 0.0], [0.0; 3]).unwrap();
        assert!(close(along_y.up(), [0.0, 0.0, 1.0]));
        assert_eq!(Camera::from([0.0; 3], [0.0, 0.0, 1.0]), Err(NoDirection));
        assert_eq!(Camera::from_angles(f64::NAN, 0.0), Err(NoDirection));
    }

    #[test]
    fn in_perspective_the_nearer_one_is_larger_and_lines_stay_straight() {
        let camera = Camera::default().with_projection(Projection::Perspective);
        let [near, middle, far] = [1.0, 0.0, -1.0].map(|z| camera.project([0.5, 0.5, z]));
        assert!(near[0] > middle[0] && middle[0] > far[0]);
        assert!(near[2] > middle[2] && middle[2] > far[2]);
        let (along, whole) =
            ((middle[0] - far[0]) / (near[0] - far[0]), (middle[2] - far[2]) / (near[2] - far[2]));
        assert!((along - whole).abs() < 1e-12);
    }
}
