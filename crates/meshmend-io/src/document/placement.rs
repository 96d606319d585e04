//! Where the parts of a document are put.

/// How the parts of a document become one mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Placing {
    /// As the file shows them: moved by the transforms of nodes or build items, and once for each time that they are
    /// placed.
    #[default]
    Scene,
    /// Each once, in its own space.
    Parts,
}

/// A place where a file puts a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Which part.
    pub part: usize,
    /// What the file calls the place; empty if it has no name.
    pub name: Vec<u8>,
    /// The rows of the matrix that moves a point: `x' = row · (x, y, z, 1)`.
    pub matrix: [[f64; 4]; 3],
}

impl Placement {
    /// The matrix that moves no point.
    pub const STILL: [[f64; 4]; 3] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

    /// A part where it is.
    pub fn still(part: usize, name: Vec<u8>) -> Self {
        Placement { part, name, matrix: Placement::STILL }
    }

    /// Where a point goes.
    pub fn moved(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        if self.matrix == Placement::STILL {
            return [x, y, z];
        }
        self.matrix.map(|[a, b, c, d]| a * x + b * y + c * z + d)
    }

    /// Where a direction of the surface's front goes: the matrix's cofactors move it, without regard to its length.
    pub fn moved_normal(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [r, s, t] = self.matrix;
        let cofactors = [cross(s, t), cross(t, r), cross(r, s)];
        let side = self.side();
        cofactors.map(|[a, b, c]| side * (a * x + b * y + c * z))
    }

    /// Where a direction along the surface goes.
    pub fn moved_direction(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        self.matrix.map(|[a, b, c, _]| a * x + b * y + c * z)
    }

    /// Whether it mirrors, so that faces must be turned to keep their fronts.
    pub fn mirrors(&self) -> bool {
        let [r, s, t] = self.matrix;
        let [a, b, c] = cross(s, t);
        r[0] * a + r[1] * b + r[2] * c < 0.0
    }

    /// By what the handedness of tangents is multiplied.
    pub(super) fn handedness(&self) -> f64 {
        self.side()
    }

    fn side(&self) -> f64 {
        if self.mirrors() { -1.0 } else { 1.0 }
    }
}

fn cross([a, b, c, _]: [f64; 4], [d, e, f, _]: [f64; 4]) -> [f64; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_moves_points_and_keeps_normals_on_the_front() {
        let mirror = Placement {
            matrix: [[-2.0, 0.0, 0.0, 5.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
            ..Placement::still(0, Vec::new())
        };
        assert!(mirror.mirrors() && !Placement::still(0, Vec::new()).mirrors());
        assert_eq!(mirror.moved([1.0, 2.0, 3.0]), [3.0, 2.0, 3.0]);
        assert_eq!(mirror.moved_normal([1.0, 0.0, 0.0]), [-1.0, 0.0, 0.0]);
        assert_eq!(mirror.moved_normal([0.0, 0.0, 1.0]), [0.0, 0.0, 2.0]);
        assert_eq!(mirror.moved_direction([1.0, 0.0, 1.0]), [-2.0, 0.0, 1.0]);
    }
}
