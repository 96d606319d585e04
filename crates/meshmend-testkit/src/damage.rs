//! Harm done to a mesh, each kind with what it must change, and what mends it.

use std::collections::{BTreeMap, BTreeSet};

use crate::Soup;

/// Which way a copy of a face runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// As the original does.
    Same,
    /// The other way round.
    Opposite,
}

/// One kind of harm, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Damage {
    /// Faces are reversed, the first corner staying first. All counts stay; an edge of degree 2 between a reversed
    /// face and another changes between consistent and inconsistent.
    Flip {
        /// Which; one that is named twice is reversed once.
        faces: Vec<usize>,
    },
    /// A copy of a face is added at the end, over the same vertices. F grows by one; each edge of the face gains as
    /// many uses as the face has there.
    Duplicate {
        /// Which.
        face: usize,
        /// Which way the copy runs.
        way: Way,
    },
    /// One vertex takes the place of another, which is left unreferenced. Where the two have no common neighbour and
    /// are not neighbours themselves, and are of one component, V and χ fall by one, and `kept` is no disc any more.
    Pinch {
        /// The vertex that stays.
        kept: u32,
        /// The vertex that no face names afterwards.
        lost: u32,
    },
    /// One corner of a face gets a vertex of its own, at the same place. At an inner vertex of a manifold with three
    /// faces or more V grows by one, E by two, and the face hangs by one corner less. Exact welding undoes it.
    Tear {
        /// Which face.
        face: usize,
        /// Which of its corners.
        corner: usize,
    },
    /// Some faces get vertices of their own, at the same places, shared among them alone. Exact welding undoes it.
    Crack {
        /// Which.
        faces: Vec<usize>,
    },
    /// Every face gets vertices of its own, as in a file without indices: V = E = number of corners, and each face is
    /// a component. Exact welding undoes it, where the vertices of the mesh had places of their own.
    WeldApart,
    /// Unreferenced vertices are added at the end, at places of their own. No figure changes.
    Noise {
        /// How many.
        count: usize,
    },
    /// A coordinate of a vertex becomes infinite or no number. No figure of the indices changes; a repair drops the
    /// faces at the vertex.
    NonFinite {
        /// Which vertex.
        vertex: u32,
        /// What its x becomes: not finite.
        value: Unreal,
    },
}

/// A number that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreal {
    /// No number.
    Nan,
    /// Positive infinity.
    Infinity,
    /// Negative infinity.
    MinusInfinity,
}

impl Unreal {
    /// As a double.
    pub fn value(self) -> f64 {
        match self {
            Unreal::Nan => f64::NAN,
            Unreal::Infinity => f64::INFINITY,
            Unreal::MinusInfinity => f64::NEG_INFINITY,
        }
    }
}

impl Damage {
    /// The damaged mesh; new faces and vertices come last.
    pub fn apply(&self, soup: &Soup) -> Soup {
        let mut harmed = soup.clone();
        match self {
            Damage::Flip { faces } => {
                for (f, face) in harmed.faces.iter_mut().enumerate().filter(|(f, _)| faces.contains(f)) {
                    *face = reversed(&soup.faces[f]);
                }
            }
            Damage::Duplicate { face, way } => harmed.faces.push(match way {
                Way::Same => soup.faces[*face].clone(),
                Way::Opposite => reversed(&soup.faces[*face]),
            }),
            Damage::Pinch { kept, lost } => {
                harmed.faces.iter_mut().flatten().filter(|v| *v == lost).for_each(|v| *v = *kept);
            }
            Damage::Tear { face, corner } => detach(&mut harmed, &[(*face, *corner)]),
            Damage::Crack { faces } => {
                let corners = |f: &usize| (0..soup.faces[*f].len()).map(|i| (*f, i)).collect::<Vec<_>>();
                let mut chosen: Vec<(usize, usize)> = faces.iter().flat_map(corners).collect();
                chosen.sort_unstable();
                chosen.dedup();
                detach(&mut harmed, &chosen);
            }
            Damage::WeldApart => {
                harmed.positions.clear();
                for v in harmed.faces.iter_mut().flatten() {
                    harmed.positions.push(soup.positions[*v as usize]);
                    *v = harmed.positions.len() as u32 - 1;
                }
            }
            Damage::Noise { count } => {
                let far = soup
                    .positions
                    .iter()
                    .flatten()
                    .filter(|x| x.is_finite())
                    .fold(0.0, |a: f64, x| a.max(*x));
                harmed.positions.extend((1..=*count).map(|i| [far + i as f64; 3]));
            }
            Damage::NonFinite { vertex, value } => harmed.positions[*vertex as usize][0] = value.value(),
        }
        harmed
    }
}

/// Gives corners new vertices, one for each vertex that they share with other corners.
fn detach(soup: &mut Soup, corners: &[(usize, usize)]) {
    let places = soup.faces.iter().enumerate().flat_map(|(f, face)| (0..face.len()).map(move |i| (f, i)));
    let others = places.filter(|place| !corners.contains(place));
    let shared: BTreeSet<u32> = others.map(|(f, i)| soup.faces[f][i]).collect();
    let mut own = BTreeMap::new();
    for &(f, i) in corners.iter().filter(|&&(f, i)| shared.contains(&soup.faces[f][i])).collect::<Vec<_>>() {
        let vertex = &mut soup.faces[f][i];
        let place = soup.positions[*vertex as usize];
        *vertex = *own.entry(*vertex).or_insert_with(|| {
            soup.positions.push(place);
            soup.positions.len() as u32 - 1
        });
    }
}

/// The first corner first, the rest reversed.
pub fn reversed(face: &[u32]) -> Vec<u32> {
    face.iter().take(1).chain(face.iter().skip(1).rev()).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{OracleReport, findings, report};
    use crate::reference::{Split, repair_soup};
    use crate::shapes::{Tiles, torus};

    fn torus_and(damage: Damage) -> (OracleReport, OracleReport, Soup) {
        let soup = torus(5, 4, Tiles::Quads).soup;
        let harmed = damage.apply(&soup);
        (report(&soup), report(&harmed), harmed)
    }

    #[test]
    fn flipping_a_face_turns_its_edges_and_nothing_else() {
        let (before, after, _) = torus_and(Damage::Flip { faces: vec![7, 7] });
        assert_eq!(after.inconsistent_edges, 4);
        let unturned = OracleReport { inconsistent_edges: 0, consistently_oriented: true, ..after };
        assert_eq!(unturned, before);
    }

    #[test]
    fn a_duplicate_is_found_with_its_way() {
        let (_, after, _) = torus_and(Damage::Duplicate { face: 3, way: Way::Same });
        assert_eq!((after.duplicate_faces.same, after.non_manifold_edges, after.faces), (1, 4, 21));
        let (_, after, _) = torus_and(Damage::Duplicate { face: 3, way: Way::Opposite });
        assert_eq!((after.duplicate_faces.opposite, after.betti.z2), (1, [1, 2, 2]));
    }

    #[test]
    fn a_pinch_costs_a_vertex_and_a_disc() {
        let (before, after, harmed) = torus_and(Damage::Pinch { kept: 0, lost: 10 });
        assert_eq!(after.vertices + 1, before.vertices);
        assert_eq!(after.euler_characteristic + 1, before.euler_characteristic);
        assert_eq!(after.non_manifold_vertices.pinched, 1);
        assert_eq!(findings(&harmed).unreferenced_vertices, [10]);
    }

    #[test]
    fn a_tear_opens_two_edges_and_welding_closes_them() {
        let (before, after, harmed) = torus_and(Damage::Tear { face: 6, corner: 2 });
        assert_eq!((after.vertices, after.edges), (before.vertices + 1, before.edges + 2));
        assert_eq!((after.boundary_edges, after.boundary_loops), (4, Some(1)));
        assert_is_torus(&harmed);
    }

    #[test]
    fn a_crack_and_a_soup_are_welded_whole() {
        let (before, after, harmed) = torus_and(Damage::Crack { faces: vec![0, 1, 4, 5] });
        assert_eq!((after.components, after.boundary_loops), (2, Some(2)));
        assert_eq!((after.vertices, after.faces), (before.vertices + 8, before.faces));
        assert_is_torus(&harmed);
        let (_, after, harmed) = torus_and(Damage::WeldApart);
        assert_eq!((after.vertices, after.edges, after.components), (80, 80, 20));
        assert_is_torus(&harmed);
    }

    #[test]
    fn noise_is_counted_apart_and_non_finite_vertices_are_found() {
        let (before, after, _) = torus_and(Damage::Noise { count: 3 });
        assert_eq!(after.unreferenced_vertices, 3);
        assert_eq!(OracleReport { unreferenced_vertices: 0, ..after }, before);
        for value in [Unreal::Nan, Unreal::Infinity, Unreal::MinusInfinity] {
            let (before, after, harmed) = torus_and(Damage::NonFinite { vertex: 2, value });
            assert_eq!(findings(&harmed).non_finite_vertices, [2]);
            assert_eq!(OracleReport { non_finite_vertices: 0, ..after }, before);
            assert_eq!(repair_soup(&harmed, Split::Sheets).faces.len(), 16);
        }
    }

    fn assert_is_torus(harmed: &Soup) {
        let repaired = repair_soup(harmed, Split::Sheets);
        let mended = report(&Soup::generic(repaired.positions.len(), &repaired.faces));
        let names: Vec<_> = mended.component_kinds.iter().map(|kind| kind.name.as_deref()).collect();
        assert_eq!(names, [Some("torus")]);
        assert_eq!(mended.vertices, 20);
    }
}
