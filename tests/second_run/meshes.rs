//! Meshes of few faces, with much that is wrong.

use crate::random::Random;

pub(crate) type Mesh = (Vec<[f64; 3]>, Vec<Vec<u32>>);

/// Faces over few points of a small grid.
pub(crate) fn soup(random: &mut Random) -> Mesh {
    let (count, side) = (3 + random.below(8), 1 + random.below(3));
    let positions = (0..count).map(|_| [0; 3].map(|_| random.below(side + 1) as f64)).collect();
    let sizes: &[usize] = random.one(&[&[3][..], &[3, 3, 3, 4, 4, 5, 6, 7, 2]]);
    let faces = (0..1 + random.below(12)).map(|_| {
        let size = random.one(sizes);
        let mut names: Vec<u32> = (0..count as u32).collect();
        let repeats = random.percent(10);
        (0..size.min(count))
            .map(|_| match repeats {
                true => random.below(count) as u32,
                false => names.swap_remove(random.below(names.len())),
            })
            .collect()
    });
    let faces = faces.collect();
    (positions, faces)
}

/// A strip of squares or triangles, closed or not, twisted or not, with a page or two at its edges.
pub(crate) fn strip(random: &mut Random) -> Mesh {
    let count = 3 + random.below(4) as u32;
    let points = |x: u32| [0, 1].map(|y| [f64::from(x), f64::from(y), f64::from(x * (count - x) % 3)]);
    let positions: Vec<[f64; 3]> = (0..count).flat_map(points).collect();
    let is_twisted = random.percent(60);
    let mut faces = Vec::new();
    for x in 0..count - random.below(2) as u32 {
        let mut next = [2 * x + 2, 2 * x + 3].map(|v| v % (2 * count));
        if is_twisted && x + 1 == count {
            next.reverse();
        }
        let square = vec![2 * x, next[0], next[1], 2 * x + 1];
        match random.below(3) {
            0 => faces.extend([[0, 1, 2], [0, 2, 3]].map(|f| f.map(|i| square[i]).to_vec())),
            _ => faces.push(square),
        }
    }
    for _ in 0..random.below(3) {
        let x = random.below(count as usize) as u32;
        faces.push(vec![2 * x, 2 * x + 1, random.below(2 * count as usize) as u32]);
    }
    (positions, faces)
}

/// Tetrahedra and cubes that touch, lie in each other or stand there twice; a ring with a bridge.
pub(crate) fn solids(random: &mut Random) -> Mesh {
    pub(crate) const CUBE: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    pub(crate) const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 4], [0, 4, 2], [1, 2, 4]];
    pub(crate) const RING: [u32; 10] = [0, 1, 3, 2, 0, 8, 9, 10, 11, 8];
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for _ in 0..1 + random.below(3) {
        let (first, size) = (positions.len() as u32, random.one(&[1.0, 1.0, 2.0, 4.0]));
        let origin = [0; 3].map(|_| random.below(3) as f64);
        let at = |corner: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| origin[i] + size * corner[i]) };
        positions.extend((0..8u8).map(|v| at([v & 1, v >> 1 & 1, v >> 2].map(f64::from))));
        let hole = [[0.25, 0.25], [0.25, 0.75], [0.75, 0.75], [0.75, 0.25]];
        positions.extend(hole.map(|[x, y]| at([x, y, 0.0])));
        let named = |face: &[u32]| face.iter().map(|v| first + v).collect::<Vec<u32>>();
        match random.below(3) {
            0 => faces.extend(CUBE.iter().map(|face| named(face))),
            1 => faces.extend(TETRAHEDRON.iter().map(|face| named(face))),
            _ => faces.push(named(&RING)),
        }
    }
    (positions, faces)
}

/// Turns, doubles and drops faces, stores vertices twice, moves points a little or to where numbers are scarce.
pub(crate) fn spoil(random: &mut Random, positions: &mut Vec<[f64; 3]>, faces: &mut Vec<Vec<u32>>) {
    for face in 0..faces.len() {
        if random.percent(20) {
            faces[face].reverse();
        }
        if random.percent(8) {
            let mut again = faces[face].clone();
            again.rotate_left(1);
            if random.percent(40) {
                again.reverse();
            }
            faces.push(again);
        }
        if random.percent(5) {
            faces[face].pop();
        }
    }
    let is_cracked = random.percent(50);
    for corner in faces.iter_mut().flatten().filter(|_| is_cracked) {
        if random.percent(25) {
            positions.push(positions[*corner as usize]);
            *corner = positions.len() as u32 - 1;
        }
    }
    let kind = random.below(12);
    for number in positions.iter_mut().flatten() {
        let noise = random.one(&[0.0, 0.0, 0.24, 0.26, -0.25, 0.3, -0.3]);
        *number = match kind {
            0 => f64::from_bits(*number as u64),
            1 => f64::from_bits(1.0f64.to_bits() + *number as u64),
            2 => -f64::from_bits(f64::MIN_POSITIVE.to_bits() - 1 + *number as u64),
            3 => *number + noise,
            4 => *number / 3.0 + noise / 1e6,
            5 => *number + 1e6,
            6 => f64::from(f32::from_bits(1.0f32.to_bits() + *number as u32)),
            7 if random.percent(2) => random.one(&[f64::NAN, f64::INFINITY]),
            8 if *number == 0.0 => random.one(&[0.0, -0.0]),
            _ => *number,
        };
    }
}
