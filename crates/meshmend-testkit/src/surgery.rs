//! Changes to a mesh whose effect on every figure is known: faces cut up, and handles, cross-caps and holes let in.
//!
//! ```text
//!   inset                 starred               summed
//!   ┌────────┐            ┌────────┐            a triangle of one mesh and a triangle of another one are taken out, and
//!   │╲┌────┐╱│            │╲      ╱│            the rims glued: χ = χ₁ + χ₂ − 2
//!   │ │    │ │            │  ╲  ╱  │
//!   │ │    │ │            │   ╳    │
//!   │╱└────┘╲│            │  ╱  ╲  │
//!   └────────┘            └────────┘
//! ```
//!
//! A face that is operated on has three different corners or more. New vertices are where they fall; none of this is
//! about shape.

use crate::{Soup, shapes};

/// Operations on a face of a mesh.
pub trait Surgery {
    /// A face of n corners is cut into n quads round a smaller copy of it, which has its place in the list: V + n,
    /// E + 2n, F + n.
    ///
    /// The vertices of the copy are in no other face but the quads.
    #[must_use]
    fn inset(&self, face: usize) -> Self;

    /// A face of n corners is cut into n triangles round a new vertex, the first of which has its place in the list:
    /// V + 1, E + n, F + n − 1.
    #[must_use]
    fn starred(&self, face: usize) -> Self;

    /// The face is gone. Of an inset face: F − 1 and one more hole.
    #[must_use]
    fn without_face(&self, face: usize) -> Self;

    /// A handle in the midst of a face of n corners: V + n + 5, E + 3n + 18, F + 2n + 11, so χ − 2.
    #[must_use]
    fn with_handle(&self, face: usize) -> Self;

    /// A cross-cap in the midst of a face of n corners: V + n + 4, E + 3n + 12, F + 2n + 7, so χ − 1.
    #[must_use]
    fn with_cross_cap(&self, face: usize) -> Self;

    /// The connected sum at a triangle of each: V + V' − 3, E + E' − 3, F + F' − 2.
    ///
    /// # Panics
    /// When one of the two faces is no triangle.
    #[must_use]
    fn summed(&self, face: usize, other: &Soup, other_face: usize) -> Self;
}

impl Surgery for Soup {
    fn inset(&self, face: usize) -> Self {
        let (mut cut, rim) = (self.clone(), self.faces[face].clone());
        let centre = mean(self, &rim);
        let inner: Vec<u32> = rim
            .iter()
            .map(|&v| {
                let place = self.positions[v as usize];
                added(&mut cut, [0, 1, 2].map(|axis| place[axis] * 0.625 + centre[axis] * 0.375))
            })
            .collect();
        for i in 0..rim.len() {
            let next = (i + 1) % rim.len();
            cut.faces.push(vec![rim[i], rim[next], inner[next], inner[i]]);
        }
        cut.faces[face] = inner;
        cut
    }

    fn starred(&self, face: usize) -> Self {
        let (mut cut, rim) = (self.clone(), self.faces[face].clone());
        let centre = added(&mut cut, mean(self, &rim));
        let mut triangles = (0..rim.len()).map(|i| vec![rim[i], rim[(i + 1) % rim.len()], centre]);
        cut.faces[face] = triangles.next().expect("a face has corners");
        cut.faces.extend(triangles);
        cut
    }

    fn without_face(&self, face: usize) -> Self {
        let mut open = self.clone();
        open.faces.remove(face);
        open
    }

    fn with_handle(&self, face: usize) -> Self {
        self.inset(face).starred(face).summed(face, &shapes::seven_vertex_torus().soup, 0)
    }

    fn with_cross_cap(&self, face: usize) -> Self {
        self.inset(face).starred(face).summed(face, &shapes::projective_plane().soup, 0)
    }

    fn summed(&self, face: usize, other: &Soup, other_face: usize) -> Self {
        let (mut sum, rim) = (self.without_face(face), &self.faces[face]);
        let seam = &other.faces[other_face];
        assert!(rim.len() == 3 && seam.len() == 3, "sums are taken at triangles");
        // The other face runs against this one, so that orientations go on.
        let seam = [seam[0], seam[2], seam[1]];
        let names: Vec<u32> = (0..other.vertex_count() as u32)
            .map(|v| match seam.iter().position(|&s| s == v) {
                Some(at) => rim[at],
                None => added(
                    &mut sum,
                    other.positions[v as usize].map(|x| x * 0.0625 + self.positions[rim[0] as usize][0]),
                ),
            })
            .collect();
        let others = other.faces.iter().enumerate().filter(|(f, _)| *f != other_face);
        sum.faces.extend(others.map(|(_, face)| face.iter().map(|&v| names[v as usize]).collect::<Vec<_>>()));
        sum
    }
}

fn added(soup: &mut Soup, position: [f64; 3]) -> u32 {
    soup.positions.push(position);
    soup.positions.len() as u32 - 1
}

fn mean(soup: &Soup, vertices: &[u32]) -> [f64; 3] {
    let sum = |axis: usize| vertices.iter().map(|&v| soup.positions[v as usize][axis]).sum::<f64>();
    [0, 1, 2].map(|axis| sum(axis) / vertices.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::report;
    use crate::shapes::cube;

    #[test]
    fn every_operation_costs_what_it_says() {
        let cube = cube().soup;
        let counts = |soup: &Soup| {
            let report = report(soup);
            [report.vertices, report.edges, report.faces]
        };
        assert_eq!(counts(&cube.inset(2)), [8 + 4, 12 + 8, 6 + 4]);
        assert_eq!(counts(&cube.starred(2)), [8 + 1, 12 + 4, 6 + 3]);
        assert_eq!(counts(&cube.with_handle(2)), [8 + 9, 12 + 30, 6 + 19]);
        assert_eq!(counts(&cube.with_cross_cap(2)), [8 + 8, 12 + 24, 6 + 15]);
        assert_eq!(counts(&cube.without_face(2)), [8, 12, 5]);
    }

    #[test]
    fn sums_are_what_the_classification_says() {
        let cube = cube().soup;
        let name = |soup: &Soup| report(soup).component_kinds[0].name.clone().unwrap();
        assert_eq!(name(&cube.with_handle(0)), "torus");
        assert_eq!(name(&cube.with_handle(0).with_handle(3)), "double torus");
        assert_eq!(name(&cube.with_cross_cap(0)), "projective plane");
        assert_eq!(name(&cube.with_cross_cap(0).with_handle(0)), "Dyck's surface");
        assert_eq!(name(&cube.inset(1).without_face(1).with_cross_cap(0)), "Möbius band");
        assert!(report(&cube.with_handle(0)).consistently_oriented, "orientations go on");
    }
}
