//! The default repair pipeline of section 5 of the semantics, slow, plain and exact: the executable definition in
//! Rust, step for step and in its order.
//!
//! Weld is exact, orient is `majority`/`report`, split is `sheets` or `cut`, and triangulate is off; attributes and
//! tolerance are left to the program. Results are to be compared face by face, up to rotation of a face's corners; not
//! where there are [`faces_with_holes`], whose pieces are judged by their [`hole_faults`].

mod corners;
mod duplicates;
mod holes;
mod matching;
mod orient;
mod postconditions;
mod rename;
mod sheets;
mod subdivide;

use std::collections::BTreeMap;

use num_rational::BigRational;

use crate::Soup;
use corners::{fold_spikes, simple_loops};
pub use holes::{faces_with_holes, hole_faults, loops_of, word_of};
pub use postconditions::broken_postconditions;

/// An exact point; none where a coordinate is not finite.
pub type Point = Option<[BigRational; 3]>;

/// What is done with the sides that are free at an edge of degree three or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Split {
    /// They are paired into sheets by their angles.
    Sheets,
    /// They become boundary.
    Cut,
}

/// A vertex that was put on an edge: at `low + (high − low) · numerator / denominator`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inserted {
    /// The stored vertices of the welded edge's ends, the lower one first.
    pub ends: [u32; 2],
    /// The numerator.
    pub numerator: u32,
    /// The denominator.
    pub denominator: u32,
}

/// What the repair gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// The point of each new vertex.
    pub positions: Vec<Point>,
    /// The vertices of each new face.
    pub faces: Vec<Vec<u32>>,
    /// For each new vertex the stored vertex whose place it has; none for an inserted one.
    pub source_vertex: Vec<Option<u32>>,
    /// The inserted vertices.
    pub inserted: BTreeMap<u32, Inserted>,
    /// For each new face the stored face that it came from.
    pub source_face: Vec<u32>,
    /// For each new face whether it was reversed.
    pub flipped: Vec<bool>,
    /// The new faces of each patch that is not orientable.
    pub non_orientable: Vec<Vec<u32>>,
}

/// The points of a soup, exactly.
pub fn exact_positions(soup: &Soup) -> Vec<Point> {
    let exact = |p: &[f64; 3]| {
        let [x, y, z] = p.map(BigRational::from_float);
        Some([x?, y?, z?])
    };
    soup.positions.iter().map(exact).collect()
}

/// The default repair of a soup of doubles.
pub fn repair_soup(soup: &Soup, split: Split) -> Repaired {
    repair(exact_positions(soup), &soup.faces, split)
}

/// The default repair.
pub fn repair(positions: Vec<Point>, faces: &[Vec<u32>], split: Split) -> Repaired {
    Pipeline::new(positions, faces, split).run()
}

/// One corner with the side that it stands for: face and place.
type Side = (usize, usize);

/// A face while it is repaired: its corners are stored vertices.
#[derive(Clone, Debug)]
struct Face {
    corners: Vec<u32>,
    source: u32,
    flipped: bool,
}

impl Face {
    /// The vertices of the side at a place.
    fn side(&self, place: usize) -> [u32; 2] {
        [self.corners[place], self.corners[(place + 1) % self.corners.len()]]
    }

    /// The first corner first, the rest reversed.
    fn reversed(&self) -> Face {
        let corners = self.corners[..1].iter().chain(self.corners[1..].iter().rev()).copied().collect();
        Face { corners, source: self.source, flipped: !self.flipped }
    }
}

struct Pipeline {
    positions: Vec<Point>,
    split: Split,
    /// The lowest vertex at each vertex's point.
    welded: Vec<u32>,
    faces: Vec<Face>,
    /// Which side each matched side is matched with; both ways.
    matches: BTreeMap<Side, Side>,
    patches: Vec<Vec<usize>>,
    non_orientable: Vec<Vec<usize>>,
}

impl Pipeline {
    fn new(positions: Vec<Point>, faces: &[Vec<u32>], split: Split) -> Self {
        let welded = weld(&positions);
        let mut loops = Vec::new();
        for (source, word) in faces.iter().enumerate() {
            if word.iter().any(|&v| positions[v as usize].is_none()) {
                continue;
            }
            let name = |v: u32| welded[v as usize];
            for corners in simple_loops(&fold_spikes(word, name), name) {
                loops.push(Face { corners, source: source as u32, flipped: false });
            }
        }
        Pipeline {
            positions,
            split,
            welded,
            faces: loops,
            matches: BTreeMap::new(),
            patches: Vec::new(),
            non_orientable: Vec::new(),
        }
    }

    fn run(mut self) -> Repaired {
        self.drop_repeated_faces();
        loop {
            self.match_stored();
            self.find_patches();
            if !self.drop_duplicate_patches() {
                break;
            }
        }
        loop {
            self.match_stored();
            self.match_welded();
            self.orient();
            if !self.drop_duplicate_patches() {
                break;
            }
        }
        if self.split == Split::Sheets {
            self.match_sheets();
        }
        self.rename()
    }

    /// The welded name of a vertex.
    fn name(&self, vertex: u32) -> u32 {
        self.welded[vertex as usize]
    }

    /// The point of a vertex that a face uses.
    fn point(&self, vertex: u32) -> &[BigRational; 3] {
        self.positions[vertex as usize].as_ref().expect("faces with such a corner are gone")
    }

    /// Whether a side runs from the lower to the higher welded vertex.
    fn is_forward(&self, (face, place): Side) -> bool {
        let [a, b] = self.faces[face].side(place);
        self.name(a) < self.name(b)
    }

    /// The sides of each edge, the lower end first, by names of the vertices.
    fn sides_by(&self, name: impl Fn(u32) -> u32) -> BTreeMap<[u32; 2], Vec<Side>> {
        let mut table: BTreeMap<[u32; 2], Vec<Side>> = BTreeMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            for place in 0..face.corners.len() {
                let [a, b] = face.side(place).map(&name);
                table.entry([a.min(b), a.max(b)]).or_default().push((f, place));
            }
        }
        table
    }

    fn sides_by_welded(&self) -> BTreeMap<[u32; 2], Vec<Side>> {
        self.sides_by(|v| self.name(v))
    }
}

/// The lowest vertex at each vertex's point; a vertex without one stays by itself.
fn weld(positions: &[Point]) -> Vec<u32> {
    let mut first_at = BTreeMap::new();
    let lowest = |(v, point): (usize, &Point)| match point {
        None => v as u32,
        Some(p) => *first_at.entry(p.clone()).or_insert(v as u32),
    };
    positions.iter().enumerate().map(lowest).collect()
}

#[cfg(test)]
mod tests;
