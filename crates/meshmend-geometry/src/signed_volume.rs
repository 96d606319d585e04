//! The sign of the volume that a closed patch encloses.

use meshmend_core::{CornerId, PolygonMesh};

/// Adds up the signed volume of faces, six-fold, and how much rounding may have changed it.
///
/// Volumes are taken against a point of the patch itself, so that a patch far from the origin keeps its digits.
#[derive(Clone, Debug, Default)]
pub struct SignedVolume {
    origin: Option<[f64; 3]>,
    total: f64,
    magnitude: f64,
    terms: f64,
}

impl SignedVolume {
    /// Adds a face, as a fan from its first corner.
    pub fn add_face(
        &mut self,
        mesh: &PolygonMesh,
        corners: impl Iterator<Item = CornerId>,
        is_flipped: bool,
    ) {
        let faces = mesh.complex().faces();
        let mut points = corners.map(|c| mesh.position(faces.corner_vertex(c)));
        let Some(first) = points.next() else { return };
        let origin = *self.origin.get_or_insert(first);
        let away = |p: [f64; 3]| [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]];
        let (a, mut before) = (away(first), None);
        for c in points.map(away) {
            if let Some(b) = before.replace(c) {
                self.add_term(a, b, c, is_flipped);
            }
        }
    }

    fn add_term(&mut self, a: [f64; 3], b: [f64; 3], c: [f64; 3], is_flipped: bool) {
        let products = [
            a[0] * (b[1] * c[2]),
            -(a[0] * (b[2] * c[1])),
            a[1] * (b[2] * c[0]),
            -(a[1] * (b[0] * c[2])),
            a[2] * (b[0] * c[1]),
            -(a[2] * (b[1] * c[0])),
        ];
        let volume: f64 = products.iter().sum();
        self.total += if is_flipped { -volume } else { volume };
        self.magnitude += products.iter().map(|p| p.abs()).sum::<f64>();
        self.terms += 1.0;
    }

    /// The sign, where rounding leaves one: −1, 0 or 1.
    pub fn sign(&self) -> i8 {
        let error = f64::EPSILON * (self.terms + 8.0) * self.magnitude;
        if !(error.is_finite() && self.total.is_finite()) || self.total.abs() <= error {
            0
        } else if self.total < 0.0 {
            -1
        } else {
            1
        }
    }
}
