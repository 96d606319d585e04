//! Small shapes with known answers, and random soups, for the tests of this crate.

use meshmend_core::{Build, EdgeUse, FaceTableBuilder, PolygonMesh, VertexId};

use crate::{TopologyReport, topology};

/// Faces over as many vertices as they name.
#[derive(Clone, Debug)]
pub(crate) struct Shape(pub(crate) Vec<Vec<u32>>);

impl Shape {
    pub(crate) fn of(faces: &[&[u32]]) -> Self {
        Shape(faces.iter().map(|face| face.to_vec()).collect())
    }

    fn vertex_count(&self) -> u32 {
        self.0.iter().flatten().max().map_or(0, |&v| v + 1)
    }

    pub(crate) fn mesh(&self) -> PolygonMesh {
        let faces: Vec<&[u32]> = self.0.iter().map(Vec::as_slice).collect();
        mesh(self.vertex_count(), &faces)
    }

    pub(crate) fn kernel(&self) -> EdgeUse {
        EdgeUse::build(self.mesh().complex()).unwrap()
    }

    pub(crate) fn report(&self) -> TopologyReport {
        let mesh = self.mesh();
        topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh)
    }

    pub(crate) fn side_by_side(parts: &[Shape]) -> Self {
        let mut all = Shape(Vec::new());
        for part in parts {
            let offset = all.vertex_count();
            all.0.extend(part.0.iter().map(|face| face.iter().map(|v| v + offset).collect()));
        }
        all
    }
}

pub(crate) fn mesh(vertex_count: u32, faces: &[&[u32]]) -> PolygonMesh {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    let table = builder.build(vertex_count as usize).unwrap();
    PolygonMesh::new(vec![[0.0; 3]; vertex_count as usize], table).unwrap()
}

pub(crate) fn kernel(vertex_count: u32, faces: &[&[u32]]) -> EdgeUse {
    EdgeUse::build(mesh(vertex_count, faces).complex()).unwrap()
}

pub(crate) fn tetrahedron() -> Shape {
    Shape::of(&[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]])
}

/// A grid of quadrilaterals, closed in both directions; where `seam` maps the last column's rows to the first's.
fn closed_grid(columns: u32, rows: u32, seam: impl Fn(u32) -> u32) -> Shape {
    let at = |i: u32, j: u32| {
        let (i, j) = if i == columns { (0, seam(j % rows)) } else { (i, j % rows) };
        i * rows + j % rows
    };
    let squares = (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
    Shape(squares.map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect())
}

pub(crate) fn torus(columns: u32, rows: u32) -> Shape {
    closed_grid(columns, rows, |row| row)
}

pub(crate) fn klein_bottle(columns: u32, rows: u32) -> Shape {
    closed_grid(columns, rows, |row| (rows - row) % rows)
}

pub(crate) fn annulus(squares: u32) -> Shape {
    Shape(
        (0..squares)
            .map(|i| (2 * i, 2 * ((i + 1) % squares)))
            .map(|(a, b)| vec![a, b, b + 1, a + 1])
            .collect(),
    )
}

pub(crate) fn moebius_band(squares: u32) -> Shape {
    let mut band = annulus(squares);
    if let Some(last) = band.0.last_mut() {
        last.swap(1, 2);
    }
    band
}

/// The projective plane with six vertices.
pub(crate) fn projective_plane() -> Shape {
    let fan = (0..5).map(|i| vec![0, 1 + i, 1 + (i + 1) % 5]);
    let rest = (0..5).map(|i| vec![1 + i, 1 + (i + 1) % 5, 1 + (i + 3) % 5]);
    Shape(fan.chain(rest).collect())
}

/// A disc of triangles whose rim spells a word.
pub(crate) fn disc_with_rim(word: &[u32]) -> Shape {
    let n = word.len() as u32;
    let ring = word.iter().max().map_or(0, |v| v + 1);
    let mut faces = Vec::new();
    for i in 0..n {
        let j = (i + 1) % n;
        let (a, b) = (word[i as usize], word[j as usize]);
        faces.extend([vec![a, b, ring + i], vec![b, ring + j, ring + i], vec![ring + i, ring + j, ring + n]]);
    }
    Shape(faces)
}

pub(crate) fn three_hemispheres() -> Shape {
    Shape((3..6).flat_map(|top| (0..3).map(move |i| vec![i, (i + 1) % 3, top])).collect())
}

pub(crate) fn sphere_with_membrane() -> Shape {
    let mut shape = Shape((3..5).flat_map(|top| (0..3).map(move |i| vec![i, (i + 1) % 3, top])).collect());
    shape.0.push(vec![0, 1, 2]);
    shape
}

pub(crate) fn tetrahedra_on_a_vertex() -> Shape {
    let other = tetrahedron().0.into_iter().map(|face| face.into_iter().map(|v| v + 3).collect());
    Shape(tetrahedron().0.into_iter().chain(other).collect())
}

pub(crate) fn tetrahedra_on_an_edge() -> Shape {
    let other = tetrahedron().0.into_iter().map(|face| face.into_iter().map(|v| v + 2).collect());
    Shape(tetrahedron().0.into_iter().chain(other).collect())
}

pub(crate) fn bow_tie() -> Shape {
    Shape::of(&[&[0, 1, 2], &[2, 3, 4]])
}

/// A torus one of whose circles is shrunk to a vertex: a sphere with two points made one.
pub(crate) fn pinched_torus() -> Shape {
    let tube = |i: u32, j: u32| 1 + 3 * i + j % 3;
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for j in 0..3 {
        faces.push(vec![0, tube(0, j + 1), tube(0, j)]);
        faces.push(vec![0, tube(1, j), tube(1, j + 1)]);
        faces.push(vec![tube(0, j), tube(0, j + 1), tube(1, j + 1), tube(1, j)]);
    }
    Shape(faces)
}

/// A small generator of numbers that look random: Steele, Lea and Flood's SplitMix.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound as u64) as usize
    }

    /// Up to `most_faces` faces of up to `most_corners` corners over some vertices; some are degenerate, some
    /// repeat vertices or one another.
    pub(crate) fn soup(&mut self, vertices: usize, most_faces: usize, most_corners: usize) -> Vec<Vec<u32>> {
        let count = 1 + self.below(most_faces);
        (0..count)
            .map(|_| {
                let wide = self.below(4) == 0;
                let corners = if wide { 1 + self.below(most_corners) } else { 3 };
                (0..corners).map(|_| self.below(vertices) as u32).collect()
            })
            .collect()
    }

    /// A face from another corner on, and half of the time the other way round.
    pub(crate) fn turned(&mut self, face: &[u32]) -> Vec<u32> {
        let mut turned = face.to_vec();
        turned.rotate_left(self.below(face.len().max(1)));
        if self.below(2) == 0 {
            turned.reverse();
        }
        turned
    }

    /// A permutation of `count` numbers.
    pub(crate) fn permutation(&mut self, count: usize) -> Vec<u32> {
        let mut numbers: Vec<u32> = (0..count as u32).collect();
        (1..count).rev().for_each(|i| numbers.swap(i, self.below(i + 1)));
        numbers
    }
}

/// The rank of a matrix modulo a prime, by plain elimination.
pub(crate) fn dense_rank(rows: &[Vec<i64>], prime: i64) -> usize {
    let mut rows: Vec<Vec<i64>> =
        rows.iter().map(|row| row.iter().map(|x| x.rem_euclid(prime)).collect()).collect();
    let width = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..width {
        let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        let pivot_row = &done[rank];
        for row in rest {
            let factor = row[column];
            for (entry, pivot) in row.iter_mut().zip(pivot_row) {
                *entry = (*entry * pivot_row[column] - pivot * factor).rem_euclid(prime);
            }
        }
        rank += 1;
    }
    rank
}
