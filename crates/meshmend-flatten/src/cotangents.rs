//! Cotangent weights, whose solution is the discrete harmonic map: an edge weighs as much as the cotangents of the
//! two angles across it.
//!
//! *Source*: U. Pinkall, K. Polthier, *Computing discrete minimal surfaces and their conjugates*, 1993.

use crate::discs::{Discs, norm};
use crate::error::FlattenError;
use crate::laplacian::Laplacian;

/// Half the sum of the cotangents across each edge.
pub(crate) fn cotangents(discs: &Discs, laplacian: &Laplacian) -> Result<Vec<f64>, FlattenError> {
    let mut weights = vec![0.0; laplacian.ends.len()];
    for (triangle, &face) in discs.triangles.iter().zip(&discs.face_of) {
        for corner in 0..3 {
            let [apex, a, b] = [0, 1, 2].map(|i| triangle[(corner + i) % 3]);
            let cotangent = cotangent(discs.vector(apex, a), discs.vector(apex, b));
            if !cotangent.is_finite() {
                return Err(FlattenError::NoCotangent { face });
            }
            if let Some(spring) = laplacian.between(a, b) {
                weights[spring] += cotangent / 2.0;
            }
        }
    }
    Ok(weights)
}

/// That of the angle between two vectors; not finite where there is no angle.
fn cotangent(p: [f64; 3], q: [f64; 3]) -> f64 {
    let cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    let dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    dot / norm(cross)
}
