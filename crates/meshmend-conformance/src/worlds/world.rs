//! All meshes of a run in their order: by faces and vertices, then random ones.

use super::random::random_table;
use super::sets::{oriented_set, oriented_triangle_sets, triples};
use super::shapes::{shapes, surfaces};
use super::tables::small_tables;
use crate::{Effort, Soup};

/// The meshes on which the laws of a kernel are asked.
pub(crate) struct World {
    listed: Vec<Listed>,
    tables: Vec<Soup>,
    bases: Vec<Soup>,
    random: usize,
}

/// A mesh of the list, as it sorts: the first one that breaks a law is the smallest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Listed {
    faces: u32,
    vertices: u32,
    corners: u32,
    source: Source,
}

/// Where a mesh of the list comes from.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Source {
    /// A set of oriented triangles over all the vertices, by its number.
    Set(u32),
    /// A table that is kept.
    Table(u32),
}

/// A mesh of a world.
pub(crate) struct Candidate {
    /// The mesh.
    pub(crate) soup: Soup,
    /// Whether it is a random one, which can be smaller still.
    pub(crate) is_random: bool,
    /// Whether it is one of so many of a kind that what takes long is asked on few of them.
    pub(crate) is_one_of_many: bool,
}

impl World {
    /// The meshes that an effort goes over.
    pub(crate) fn of(effort: Effort) -> Self {
        let most = if effort == Effort::Quick { 4 } else { 5 };
        let random = match effort {
            Effort::Quick => 200,
            Effort::Usual => 2_000,
            Effort::Thorough => 20_000,
        };
        let small = small_tables().map(|(vertices, faces)| Soup::generic(vertices as usize, faces));
        let tables: Vec<Soup> =
            small.chain(shapes().iter().map(|shape| Soup::of_mesh(&shape.mesh))).collect();
        let mut listed: Vec<Listed> = (3..=most).flat_map(sets_over).collect();
        listed.extend(
            tables.iter().zip(0..).map(|(soup, at)| Listed::of(soup.vertex_count(), &soup.faces, at)),
        );
        listed.sort_unstable();
        let bases = surfaces().iter().map(|shape| Soup::of_mesh(&shape.mesh)).collect();
        World { listed, tables, bases, random }
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.listed.len() + self.random
    }

    /// How many of them are random.
    pub(crate) fn random_count(&self) -> usize {
        self.random
    }

    /// The mesh of a number.
    pub(crate) fn mesh(&self, number: usize) -> Candidate {
        let Some(&listed) = self.listed.get(number) else {
            let soup = random_table(number - self.listed.len(), &self.bases);
            return Candidate { soup, is_random: true, is_one_of_many: false };
        };
        let (soup, is_one_of_many) = match listed.source {
            Source::Table(at) => (self.tables[at as usize].clone(), false),
            Source::Set(code) => {
                let faces = oriented_set(&triples(listed.vertices), code);
                (Soup::generic(listed.vertices as usize, faces), listed.vertices > 4)
            }
        };
        Candidate { soup, is_random: false, is_one_of_many }
    }
}

fn sets_over(vertices: u32) -> impl Iterator<Item = Listed> {
    let of = move |(faces, code): (Vec<Vec<u32>>, u32)| {
        let listed = Listed::of(vertices as usize, &faces, 0);
        Listed { source: Source::Set(code), ..listed }
    };
    oriented_triangle_sets(vertices).zip(0..).map(of)
}

impl Listed {
    fn of(vertices: usize, faces: &[Vec<u32>], at: u32) -> Self {
        let corners = faces.iter().map(Vec::len).sum::<usize>() as u32;
        Listed { faces: faces.len() as u32, vertices: vertices as u32, corners, source: Source::Table(at) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_world_goes_from_small_to_large_and_ends_at_random() {
        let world = World::of(Effort::Quick);
        let size = |number| {
            let soup = world.mesh(number).soup;
            (soup.faces.len(), soup.vertex_count())
        };
        let listed = world.len() - world.random_count();
        let sizes: Vec<_> = (0..listed).map(size).collect();
        assert!(sizes.is_sorted() && sizes[0] == (0, 3), "{sizes:?}");
        assert!((0..world.len()).all(|number| world.mesh(number).is_random == (number >= listed)));
        assert!(listed > 3 + 81 + 1365 + 1600 + 40);
    }

    #[test]
    fn every_effort_goes_over_more_meshes_than_the_one_before() {
        let [quick, usual, thorough] = [Effort::Quick, Effort::Usual, Effort::Thorough].map(World::of);
        assert!(usual.len() > quick.len() + 59_049 && thorough.len() == usual.len() + 18_000);
    }
}
