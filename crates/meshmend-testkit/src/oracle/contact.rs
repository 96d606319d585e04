//! How two triangles meet, by the definition: the part that they share, by clipping, and the smallest cell of each that holds
//! it.

use num_rational::BigRational;
use num_traits::{FromPrimitive, Zero};

type Exact = [BigRational; 3];

/// How two triangles of finite corners and positive area meet: the contact's name, and whether they lie in one plane; `None`
/// if they are apart or meet properly.
///
/// *Cost*: slow; all numbers are fractions.
pub fn contact(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> Option<(&'static str, bool)> {
    let [f, g] = [one, other].map(|triangle| triangle.map(|corner| corner.map(exact)));
    let common = common_part(&f, &g);
    let count = BigRational::from_usize(common.len())?;
    if common.is_empty() {
        return None;
    }
    let middle: Exact =
        std::array::from_fn(|i| common.iter().map(|point| &point[i]).sum::<BigRational>() / &count);
    let cells = [cell_of(&middle, &f), cell_of(&middle, &g)];
    let normal = normal(&f);
    let is_flat = g.iter().all(|corner| dot(&normal, &minus(corner, &f[0])).is_zero());
    let is_same = cells[0].len() == cells[1].len() && cells[0].iter().all(|corner| cells[1].contains(corner));
    let sizes = [cells[0].len().min(cells[1].len()), cells[0].len().max(cells[1].len())];
    let name = match sizes {
        [3, 3] if is_same => "coincident",
        _ if is_same => return None,
        [1, 2] => "vertex-edge",
        [1, 3] => "vertex-face",
        [2, 2] => "edge-edge",
        [2, 3] => "edge-face",
        _ => "face-face",
    };
    Some((name, is_flat))
}

/// Whether three points of finite coordinates lie on one line.
pub fn has_no_area(triangle: [[f64; 3]; 3]) -> bool {
    normal(&triangle.map(|corner| corner.map(exact))).iter().all(Zero::is_zero)
}

/// The corners of what two triangles share: the first is clipped with the plane of the second and with its sides.
fn common_part(f: &[Exact; 3], g: &[Exact; 3]) -> Vec<Exact> {
    let up = normal(g);
    let down = minus(&[(); 3].map(|()| BigRational::zero()), &up);
    let mut planes = vec![(up.clone(), &g[0]), (down, &g[0])];
    planes.extend((0..3).map(|at| (cross(&up, &minus(&g[(at + 1) % 3], &g[at])), &g[at])));
    let mut corners = f.to_vec();
    for (normal, origin) in planes {
        let heights: Vec<BigRational> =
            corners.iter().map(|corner| dot(&normal, &minus(corner, origin))).collect();
        let mut kept = Vec::new();
        for at in 0..corners.len() {
            let next = (at + 1) % corners.len();
            if heights[at] >= BigRational::zero() {
                kept.push(corners[at].clone());
            }
            if &heights[at] * &heights[next] < BigRational::zero() {
                let part = &heights[at] / (&heights[at] - &heights[next]);
                let way = minus(&corners[next], &corners[at]);
                kept.push(std::array::from_fn(|i| &corners[at][i] + &way[i] * &part));
            }
        }
        corners = kept;
    }
    let mut different: Vec<Exact> = Vec::new();
    for corner in corners {
        if !different.contains(&corner) {
            different.push(corner);
        }
    }
    different
}

/// The corners of the smallest cell of a triangle that holds a point of it: those with a weight.
fn cell_of(point: &Exact, triangle: &[Exact; 3]) -> Vec<Exact> {
    let whole = normal(triangle);
    let has_weight = |at: &usize| {
        let part = normal(&[point.clone(), triangle[(at + 1) % 3].clone(), triangle[(at + 2) % 3].clone()]);
        !dot(&whole, &part).is_zero()
    };
    (0..3).filter(has_weight).map(|at| triangle[at].clone()).collect()
}

fn exact(number: f64) -> BigRational {
    BigRational::from_f64(number).expect("coordinates are finite")
}

fn normal([a, b, c]: &[Exact; 3]) -> Exact {
    cross(&minus(b, a), &minus(c, a))
}

fn minus(a: &Exact, b: &Exact) -> Exact {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn dot(a: &Exact, b: &Exact) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Exact, b: &Exact) -> Exact {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_meet_as_it_is_seen() {
        let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let cases = [
            ([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]], Some(("face-face", false))),
            ([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]], Some(("vertex-face", false))),
            ([[1.0, 0.0, 0.0], [2.0, -1.0, 0.0], [1.0, -9.0, 0.0]], Some(("vertex-edge", true))),
            ([[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [1.0, 1.0, 1.0]], Some(("edge-edge", false))),
            ([[0.0, 4.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0]], Some(("coincident", true))),
            ([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, -9.0, 0.0]], None),
            ([[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [1.0, -9.0, 1.0]], None),
        ];
        for (other, expected) in cases {
            assert_eq!(contact(flat, other), expected, "{other:?}");
            assert_eq!(contact(other, flat), expected, "{other:?}");
        }
        assert!(has_no_area([[0.0; 3], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0]]) && !has_no_area(flat));
    }
}
