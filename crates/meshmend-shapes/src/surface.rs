//! Any compact connected surface: a slab of cubes with tunnels, cross-caps and holes.
//!
//! ```text
//!   ┌──┬──┬──┬──┬──┐      a slab one cube high, three wide and w long; every second cube of its middle row is
//!   ├──┼──┼──┼──┼──┤        a handle:    a tunnel, the cube taken out
//!   │  │◉ │  │◎ │  │        a cross-cap: its top replaced by a Möbius band
//!   ├──┼──┼──┼──┼──┤        a hole:      its top taken away
//!   └──┴──┴──┴──┴──┘      and each square is cut into n × n
//! ```

use std::f64::consts::TAU;

use crate::mesh_builder::{MeshBuilder, at_least};
use crate::schemes::PROJECTIVE_PLANE;
use crate::{Closed, Shape, ShapeError};

/// The surface of a kind with so many holes, of quads, on a slab whose cubes have n × n of them a side.
///
/// With h handles, x cross-caps, b holes and w = 2 max(1, h + x + b) + 1, and S = (8w + 6 + 2h)n² squares before
/// anything is opened: F = S − (x + b)n² + 4nx, E = 2S − 2n(n − 1)(x + b) + 6nx and
/// V = S + 2 − 2h − (n − 1)²(x + b) + 2nx; but for n = 1 a cross-cap is eight triangles with ten edges.
///
/// Orientable surfaces are embedded and look outward; a cross-cap passes through itself above the slab.
///
/// # Errors
/// When n is 0, the cross-caps are none, or the surface is too large.
///
/// *Cost*: linear.
pub fn surface(kind: Closed, holes: usize, n: usize) -> Result<Shape, ShapeError> {
    let (handles, caps) = match kind {
        Closed::Handles(genus) => (genus, 0),
        Closed::CrossCaps(caps) => {
            at_least(1, "the number of cross-caps", caps)?;
            (0, caps)
        }
    };
    at_least(1, "the resolution", n)?;
    let features = handles.saturating_add(caps).saturating_add(holes);
    let columns = features.max(1).saturating_mul(2).saturating_add(1);
    let mut builder = MeshBuilder::with_room(&[columns.saturating_mul(12), n, n, 4])?;
    let slab = Slab { columns, n, handles, caps, holes };
    let first = slab.place_points(&mut builder);
    let lattice = Lattice { slab: &slab, first: &first };
    lattice.add_faces(&mut builder);
    for cap in handles..handles + caps {
        add_cross_cap(&mut builder, &lattice.rim(2 * cap + 1), [(2 * cap + 1) as f64 + 0.5, 1.5]);
    }
    let what = match kind {
        Closed::Handles(genus) => format!("of genus {genus}"),
        Closed::CrossCaps(caps) => format!("with {caps} cross-caps"),
    };
    builder.surface(format!("surface {what}, {holes} holes, resolution {n}"), kind, holes, slab.counts())
}

/// Coarse cells are cubes, fine cells the columns of n × n a cube; lattice points are the corners of fine cells.
struct Slab {
    columns: usize,
    n: usize,
    handles: usize,
    caps: usize,
    holes: usize,
}

/// What stands in the place of a fine cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cell {
    Empty,
    Solid,
    /// Solid below, open above.
    Open,
}

/// The lowest vertex above each lattice point of the ground; those above it follow, as far as there are any.
struct Lattice<'a> {
    slab: &'a Slab,
    first: &'a [u32],
}

impl Slab {
    fn counts(&self) -> [usize; 3] {
        let Slab { columns, n, handles, caps, holes } = *self;
        let squares = (8 * columns + 6 + 2 * handles) * n * n;
        let open = caps + holes;
        let [cap_edges, cap_faces] = if n == 1 { [10, 8] } else { [6 * n, 4 * n] };
        [
            squares + 2 - 2 * handles - (n - 1) * (n - 1) * open + 2 * n * caps,
            2 * squares - 2 * n * (n - 1) * open + cap_edges * caps,
            squares - n * n * open + cap_faces * caps,
        ]
    }

    /// Lattice points along the slab and across.
    fn extent(&self) -> [usize; 2] {
        [self.columns * self.n + 1, 3 * self.n + 1]
    }

    /// The cell whose lowest lattice point is (x, y); outside the slab, where the numbers have wrapped, it is empty.
    fn cell(&self, x: usize, y: usize) -> Cell {
        let (x, y) = (x / self.n, y / self.n);
        if x >= self.columns || y >= 3 {
            Cell::Empty
        } else if y != 1 || x.is_multiple_of(2) || x / 2 >= self.handles + self.caps + self.holes {
            Cell::Solid
        } else if x / 2 < self.handles {
            Cell::Empty
        } else {
            Cell::Open
        }
    }

    /// The four cells round a lattice point.
    fn round(&self, x: usize, y: usize) -> [Cell; 4] {
        let (west, south) = (x.wrapping_sub(1), y.wrapping_sub(1));
        [self.cell(west, south), self.cell(x, south), self.cell(west, y), self.cell(x, y)]
    }

    fn is_wall(&self, x: usize, y: usize) -> bool {
        self.round(x, y).contains(&Cell::Empty)
    }

    /// Adds the vertices above each lattice point, from the ground up.
    fn place_points(&self, builder: &mut MeshBuilder) -> Vec<u32> {
        let [along, across] = self.extent();
        let mut first = Vec::with_capacity(along * across);
        for (x, y) in (0..along).flat_map(|x| (0..across).map(move |y| (x, y))) {
            first.push(builder.next());
            let cells = self.round(x, y);
            let height = |z: usize| [x, y, z].map(|i| i as f64 / self.n as f64);
            if cells == [Cell::Open; 4] {
                builder.point(height(0));
            } else if cells == [Cell::Empty; 4] {
                continue;
            } else if cells.contains(&Cell::Empty) {
                builder.points((0..=self.n).map(height));
            } else {
                builder.points([height(0), height(self.n)]);
            }
        }
        first
    }
}

impl Lattice<'_> {
    fn bottom(&self, [x, y]: [usize; 2]) -> u32 {
        self.first[x * self.slab.extent()[1] + y]
    }

    fn top(&self, [x, y]: [usize; 2]) -> u32 {
        let rise = if self.slab.is_wall(x, y) { self.slab.n as u32 } else { 1 };
        self.bottom([x, y]) + rise
    }

    /// Adds the squares of each cell: above, below, and where its neighbour is empty.
    fn add_faces(&self, builder: &mut MeshBuilder) {
        let [along, across] = self.slab.extent();
        for (x, y) in (0..along - 1).flat_map(|x| (0..across - 1).map(move |y| (x, y))) {
            let cell = self.slab.cell(x, y);
            if cell == Cell::Empty {
                continue;
            }
            let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
            if cell == Cell::Solid {
                builder.face(&corners.map(|corner| self.top(corner)));
            }
            let [a, b, c, d] = corners.map(|corner| self.bottom(corner));
            builder.face(&[a, d, c, b]);
            let beside = [(x, y.wrapping_sub(1)), (x + 1, y), (x, y + 1), (x.wrapping_sub(1), y)];
            for (side, (x, y)) in beside.into_iter().enumerate() {
                if self.slab.cell(x, y) == Cell::Empty {
                    let [from, to] = [side, (side + 1) % 4].map(|i| self.bottom(corners[i]));
                    (0..self.slab.n as u32)
                        .for_each(|z| builder.face(&[from + z, to + z, to + z + 1, from + z + 1]));
                }
            }
        }
    }

    /// The rim of the top of a cube of the middle row, counter-clockwise.
    fn rim(&self, column: usize) -> Vec<u32> {
        let n = self.slab.n;
        let (x, y) = (column * n, n);
        let south = (0..n).map(|i| [x + i, y]);
        let east = (0..n).map(|i| [x + n, y + i]);
        let north = (0..n).map(|i| [x + n - i, y + n]);
        let west = (0..n).map(|i| [x, y + n - i]);
        south.chain(east).chain(north).chain(west).map(|point| self.top(point)).collect()
    }
}

/// Glues a Möbius band into a rim of 4n vertices: opposite points of the rim lead to the same point of a circle; for
/// n = 1, where that circle would have two points, the six-vertex projective plane less two triangles.
fn add_cross_cap(builder: &mut MeshBuilder, rim: &[u32], [x, y]: [f64; 2]) {
    let half = rim.len() / 2;
    let first = builder.next();
    builder.points((0..half).map(|i| {
        let turn = TAU * (i as f64 + 0.25) / half as f64;
        [x + 0.25 * turn.cos(), y + 0.25 * turn.sin(), 1.5]
    }));
    if let [a, b, c, d] = *rim {
        let names = [a, b, c, d, first, first + 1];
        PROJECTIVE_PLANE[2..].iter().for_each(|face| builder.face(&face.map(|v| names[v as usize])));
        return;
    }
    let circle = |i: usize| first + (i % half) as u32;
    for i in 0..rim.len() {
        builder.face(&[rim[i], rim[(i + 1) % rim.len()], circle(i + 1), circle(i)]);
    }
}
