//! What is measured on: meshes of any size with known figures, the same ones every time.
//!
//! All but one are made from a torus of triangles on a grid. Coordinates are multiples of 1/128 below 2048, so they are
//! the same numbers in single precision, in doubles and in the text of a file.

mod bodies;
mod files;
mod load;
mod torus;

use clap::ValueEnum;
use meshmend::{FaceTable, PolygonMesh, VertexId};

use crate::failure::Failure;
use crate::random::Random;
use bodies::Bodies;
pub(crate) use files::{Folder, Form};
pub(crate) use load::load;
use torus::Torus;

/// The least that a mesh is asked to have, in faces.
pub(crate) const FEWEST_FACES: usize = 5_000;
/// The most that a mesh is asked to have, in faces: with more, the vertices of the torus would be too close.
pub(crate) const MOST_FACES: usize = 30_000_000;
/// How far apart the copies of a vertex in [`Content::Jittered`] are at most, as a tolerance of a weld.
pub(crate) const JITTER: f64 = 0.085;

/// What a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Content {
    /// The torus without shared vertices, as STL has it.
    Soup,
    /// The same, each corner some steps of 1/128 off its place.
    Jittered,
    /// The torus.
    Indexed,
    /// Half of its faces are the wrong way round.
    Flipped,
    /// One face in 512 is missing.
    Holes,
    /// Square holes with loops of 12 edges, two cells apart.
    SmallSquares,
    /// The same with loops of 32 edges.
    LargeSquares,
    /// A small triangle goes through every second face.
    Finned,
    /// Boxes that share edges, and boxes that share vertices.
    Pinched,
    /// With holes, half flipped, 1 % duplicates, 1 % degenerate faces, 1 % loose vertices.
    Dirty,
}

/// In which order vertices and faces are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum Order {
    /// Neighbours are near each other, as modellers write them.
    Mesh,
    /// In random order, as scans and soups often are.
    Shuffled,
}

/// A mesh to measure on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Input {
    pub(crate) content: Content,
    pub(crate) order: Order,
    /// How many faces are asked for; those of the mesh are about as many.
    pub(crate) faces: usize,
}

/// What is known of a mesh before it is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Known {
    /// Faces as stored.
    pub(crate) faces: u64,
    /// Vertices as they should be: those of the torus, or those of all boxes apart.
    pub(crate) mended_vertices: u64,
    /// Faces that are neither degenerate nor there twice.
    pub(crate) mended_faces: u64,
    /// Edges of the mesh, welded or not as it is stored; only where nothing is dirty.
    pub(crate) edges: u64,
    /// Edges with one face; only where nothing is dirty.
    pub(crate) boundary_edges: u64,
    /// Edges with three faces or more; only where nothing is dirty.
    pub(crate) non_manifold_edges: u64,
    /// Faces that cross others.
    pub(crate) crossing_faces: u64,
}

impl Content {
    /// All.
    pub(crate) const ALL: [Content; 10] = [
        Content::Soup,
        Content::Jittered,
        Content::Indexed,
        Content::Flipped,
        Content::Holes,
        Content::SmallSquares,
        Content::LargeSquares,
        Content::Finned,
        Content::Pinched,
        Content::Dirty,
    ];

    /// What it is called in names of files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Content::Soup => "soup",
            Content::Jittered => "jittered",
            Content::Indexed => "indexed",
            Content::Flipped => "flipped",
            Content::Holes => "holes",
            Content::SmallSquares => "small-squares",
            Content::LargeSquares => "large-squares",
            Content::Finned => "finned",
            Content::Pinched => "pinched",
            Content::Dirty => "dirty",
        }
    }
}

impl Content {
    /// How many cells its square holes have each way, if it has any.
    fn square_cells(self) -> Option<usize> {
        match self {
            Content::SmallSquares => Some(3),
            Content::LargeSquares => Some(8),
            _ => None,
        }
    }

    /// The torus under a mesh of about so many faces.
    fn torus(self, faces: usize) -> Torus {
        Torus::of_about(if self == Content::Finned { faces / 3 * 2 } else { faces })
    }
}

impl Order {
    /// What it is called in options and names of files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Order::Mesh => "mesh",
            Order::Shuffled => "shuffled",
        }
    }
}

impl Input {
    /// What is known of the mesh.
    pub(crate) fn known(&self) -> Known {
        let torus = self.content.torus(self.faces);
        let (faces, holes) = (torus.face_count() as u64, torus.hole_count() as u64);
        let whole = Known {
            faces,
            mended_vertices: torus.vertex_count() as u64,
            mended_faces: faces,
            edges: faces / 2 * 3,
            boundary_edges: 0,
            non_manifold_edges: 0,
            crossing_faces: 0,
        };
        match self.content {
            Content::Indexed | Content::Flipped => whole,
            Content::Soup | Content::Jittered => {
                Known { edges: 3 * faces, boundary_edges: 3 * faces, ..whole }
            }
            // No two holes share a vertex.
            Content::Holes => {
                let left = faces - holes;
                Known { faces: left, mended_faces: left, boundary_edges: 3 * holes, ..whole }
            }
            Content::Dirty => {
                let left = faces - holes;
                Known { faces: left + 2 * (left / 100), mended_faces: left, ..whole }
            }
            Content::SmallSquares | Content::LargeSquares => {
                let cells = self.content.square_cells().unwrap_or(0);
                let count = torus.square_hole_count(cells) as u64;
                let cells = cells as u64;
                let left = faces - 2 * cells * cells * count;
                Known {
                    faces: left,
                    mended_faces: left,
                    edges: whole.edges - (3 * cells * cells - 2 * cells) * count,
                    boundary_edges: 4 * cells * count,
                    ..whole
                }
            }
            Content::Finned => {
                let fins = torus.fin_count() as u64;
                Known {
                    faces: faces + fins,
                    mended_faces: faces + fins,
                    mended_vertices: whole.mended_vertices + 3 * fins,
                    edges: whole.edges + 3 * fins,
                    boundary_edges: 3 * fins,
                    crossing_faces: 2 * fins,
                    ..whole
                }
            }
            Content::Pinched => Bodies::of_about(self.faces).known(),
        }
    }

    /// The mesh.
    pub(crate) fn mesh(&self) -> Result<PolygonMesh, Failure> {
        let mut random = Random::new(0x6d65_7368 ^ self.faces as u64);
        let torus = self.content.torus(self.faces);
        let mut raw = match self.content {
            Content::Pinched => Bodies::of_about(self.faces).raw(),
            Content::Holes | Content::Dirty => torus.with_holes(),
            Content::Finned => torus.with_fins(),
            content => {
                content.square_cells().map_or_else(|| torus.raw(), |cells| torus.with_square_holes(cells))
            }
        };
        if matches!(self.content, Content::Flipped | Content::Dirty) {
            raw.flip_half(&mut random);
        }
        if self.content == Content::Dirty {
            raw.add_rubbish(&mut random);
        }
        if self.order == Order::Shuffled {
            raw = raw.shuffled(&mut random);
        }
        match self.content {
            Content::Soup => raw = raw.torn_apart(|point| point),
            Content::Jittered => raw = raw.torn_apart(|point| point.map(|x| x + jitter(&mut random))),
            _ => {}
        }
        raw.into_mesh()
    }
}

/// Up to three steps either way.
fn jitter(random: &mut Random) -> f64 {
    (f64::from(random.below(7)) - 3.0) / 128.0
}

/// A mesh of triangles as it is being made.
#[derive(Clone, Debug, Default)]
struct Raw {
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Raw {
    fn flip_half(&mut self, random: &mut Random) {
        for triangle in &mut self.triangles {
            if random.bits() >> 63 == 1 {
                triangle.swap(1, 2);
            }
        }
    }

    /// Adds a repetition and a degenerate face for every hundredth face, and as many loose vertices as that.
    fn add_rubbish(&mut self, random: &mut Random) {
        let count = self.triangles.len() / 100;
        for i in 0..count {
            let [a, b, c] = self.triangles[100 * i];
            self.triangles.push([b, c, a]);
        }
        for i in 0..count {
            let [a, b, _] = self.triangles[100 * i + 50];
            self.triangles.push([a, a, b]);
        }
        // On a line beside the torus, each in a place of its own.
        let start = random.below(128);
        let place = |i: usize| (i as f64 + f64::from(start)) / 128.0;
        self.positions.extend((0..count).map(|i| [place(i) % 1024.0, 1500.0, (place(i) / 1024.0).floor()]));
    }

    /// The same mesh with its vertices and faces in random order.
    fn shuffled(mut self, random: &mut Random) -> Raw {
        let mut order: Vec<u32> = (0..self.positions.len() as u32).collect();
        random.shuffle(&mut order);
        let mut place = vec![0; order.len()];
        order.iter().zip(0..).for_each(|(&old, new)| place[old as usize] = new);
        let positions = order.iter().map(|&old| self.positions[old as usize]).collect();
        random.shuffle(&mut self.triangles);
        let moved = |triangle: &[u32; 3]| triangle.map(|vertex| place[vertex as usize]);
        Raw { positions, triangles: self.triangles.iter().map(moved).collect() }
    }

    /// The same triangles, each with vertices of its own.
    fn torn_apart(self, mut place: impl FnMut([f64; 3]) -> [f64; 3]) -> Raw {
        let corners = self.triangles.iter().flatten();
        let positions = corners.map(|&vertex| place(self.positions[vertex as usize])).collect();
        let triangles = (0..self.triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Raw { positions, triangles }
    }

    fn into_mesh(self) -> Result<PolygonMesh, Failure> {
        let corners = self.triangles.into_iter().flatten().map(VertexId).collect();
        let faces = FaceTable::triangles(self.positions.len(), corners)?;
        Ok(PolygonMesh::new(self.positions, faces)?)
    }
}

#[cfg(test)]
mod tests {
    use meshmend::passes::Context;
    use meshmend::{CheckOptions, DefectKind, Distance, Pass, check, passes::Weld};

    use super::*;

    fn inputs() -> impl Iterator<Item = Input> {
        let orders = [Order::Mesh, Order::Shuffled];
        let of = move |content| orders.map(|order| Input { content, order, faces: 20_000 });
        Content::ALL.into_iter().flat_map(of)
    }

    #[test]
    fn what_is_known_of_a_mesh_is_so() {
        for input in inputs() {
            let (known, mesh) = (input.known(), input.mesh().unwrap());
            assert_eq!(mesh.counts().faces as u64, known.faces, "{input:?}");
            let about = mesh.counts().faces as f64 / input.faces as f64;
            let is_open = input.content.square_cells().is_some();
            assert!(is_open || (0.9..1.1).contains(&about), "{input:?}: {} faces", mesh.counts().faces);
            if input.content == Content::Dirty {
                continue;
            }
            let found = check(&mesh, &CheckOptions::default()).unwrap().topology;
            let figures = [found.edges, found.boundary_edges, found.non_manifold_edges];
            assert_eq!(figures, [known.edges, known.boundary_edges, known.non_manifold_edges], "{input:?}");
        }
    }

    #[test]
    fn everything_that_is_said_of_dirt_is_there() {
        for order in [Order::Mesh, Order::Shuffled] {
            let input = Input { content: Content::Dirty, order, faces: 20_000 };
            let report = check(&input.mesh().unwrap(), &CheckOptions::default()).unwrap();
            let rubbish = input.known().mended_faces / 100;
            let kinds =
                [DefectKind::DuplicateFace, DefectKind::DegenerateFace, DefectKind::UnreferencedVertex];
            assert_eq!(kinds.map(|kind| report.count(kind) as u64), [rubbish; 3]);
            let share = report.count(DefectKind::InconsistentEdge) as f64 / input.known().edges as f64;
            assert!((0.45..0.55).contains(&share), "{share}");
        }
    }

    #[test]
    fn boxes_touch_along_edges_and_in_vertices() {
        let mesh = Input { content: Content::Pinched, order: Order::Mesh, faces: 20_000 }.mesh().unwrap();
        let found = check(&mesh, &CheckOptions::default()).unwrap();
        assert!(found.count(DefectKind::SingularVertex) > 100);
        assert!(found.count(DefectKind::PinchedVertex) > 20);
    }

    #[test]
    fn coordinates_are_exact_in_single_precision_and_short_as_text() {
        for input in inputs() {
            for x in input.mesh().unwrap().positions().iter().flatten() {
                assert!((x * 128.0).fract() == 0.0 && x.abs() < 2048.0, "{input:?}: {x}");
            }
        }
    }

    #[test]
    fn the_soups_weld_to_the_torus() {
        for input in inputs().filter(|input| matches!(input.content, Content::Soup | Content::Jittered)) {
            let distance = match input.content {
                Content::Soup => Distance::Exact,
                _ => Distance::Absolute(JITTER),
            };
            let welded = Weld::within(distance).apply(&input.mesh().unwrap(), &Context::default()).unwrap();
            assert_eq!(welded.mesh.counts().vertices as u64, input.known().mended_vertices, "{input:?}");
        }
    }

    #[test]
    fn a_mesh_is_the_same_every_time_and_another_one_in_another_order() {
        for input in inputs().filter(|input| input.order == Order::Shuffled) {
            let mesh = input.mesh().unwrap();
            let again = input.mesh().unwrap();
            assert!(mesh.positions() == again.positions() && mesh.faces() == again.faces(), "{input:?}");
            let in_order = Input { order: Order::Mesh, ..input }.mesh().unwrap();
            assert!(mesh.positions() != in_order.positions(), "{input:?}");
        }
    }
}
