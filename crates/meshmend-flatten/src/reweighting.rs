//! Edge weights that are lowered where a layout is crowded.
//!
//! At the far end of a long finger equal weights leave triangles too small for doubles: each ring of
//! vertices is a fixed part smaller than the one before. An edge's weight is therefore multiplied by a factor of
//! each of its nodes, the root of how large the triangles at the node are against the mean. Weights stay positive,
//! so the theorem goes on to hold; crowded nodes pull less, are pulled outward, and spread.

/// Areas below this part of the mean can't be told from rounding.
const LEAST_AREA: f64 = 1e-28;

/// Factors lie between these, so that a product of two is a normal number, and a sum of such products too.
const FACTORS: [f64; 2] = [1e-150, 1e145];

/// The factor of each node, given those with which the layout was made.
pub(crate) fn reweighted(factors: &[f64], triangles: &[[u32; 3]], points: &[[f64; 2]]) -> Vec<f64> {
    let mut sums = vec![(0.0f64, 0.0f64); factors.len()];
    let mut total = 0.0;
    for triangle in triangles {
        let area = area(triangle, points);
        total += area;
        for &node in triangle {
            let (sum, count) = &mut sums[node as usize];
            (*sum, *count) = (*sum + area, *count + 1.0);
        }
    }
    let mean = total / triangles.len() as f64;
    let factor = |(&old, &(sum, count)): (&f64, &(f64, f64))| {
        let part = if count > 0.0 { sum / count / mean } else { 1.0 };
        old * part.max(LEAST_AREA).sqrt()
    };
    let mut factors: Vec<f64> = factors.iter().zip(&sums).map(factor).collect();
    // Only their ratios matter.
    let [least, most] = FACTORS;
    let greatest = factors.iter().copied().fold(least, f64::max);
    factors.iter_mut().for_each(|factor| *factor = (*factor / greatest * most).max(least));
    factors
}

fn area(triangle: &[u32; 3], points: &[[f64; 2]]) -> f64 {
    let [a, b, c] = triangle.map(|node| points[node as usize]);
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
}
