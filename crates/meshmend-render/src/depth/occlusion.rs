//! Which parts of a panel are covered so near that a face behind them need not be drawn there.
//!
//! The samples are parted into square tiles. Of each tile it is known how far its farthest sample is, and where a plane
//! face covers all of it, a plane behind which nothing is seen. So of many faces that lie one over the other most cost
//! the tiles that they would cover, and not the samples.

use crate::vector::{Vector, cross, subtract};

/// How many samples a tile has each way.
pub(crate) const TILE: usize = 16;

/// What is hidden is farther by at least this: far more than rounding to single precision does.
const MARGIN: f64 = 1e-6;

/// How near a plane face is at each sample: so much at the origin, and so much more for each sample to the right and
/// each sample down.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    at_origin: f64,
    steps: [f64; 2],
}

impl Plane {
    /// The plane of a face, if it has one, from its corners in samples.
    pub(crate) fn of(corners: &[Vector]) -> Option<Self> {
        let [a, b, c, ..] = *corners else { return None };
        let [x, y, z] = cross(subtract(b, a), subtract(c, a));
        let steps = [-x / z, -y / z];
        let plane = Plane { at_origin: a[2] - steps[0] * a[0] - steps[1] * a[1], steps };
        let is_on = |corner: &Vector| (plane.at(corner[0], corner[1]) - corner[2]).abs() < MARGIN / 4.0;
        corners.iter().all(is_on).then_some(plane)
    }

    fn at(&self, x: f64, y: f64) -> f64 {
        self.at_origin + self.steps[0] * x + self.steps[1] * y
    }

    /// At the corners of a tile.
    fn on(&self, column: usize, row: usize) -> [f64; 4] {
        let ends = |tile: usize| [(tile * TILE) as f64, ((tile + 1) * TILE) as f64];
        let ([left, right], [top, bottom]) = (ends(column), ends(row));
        [self.at(left, top), self.at(right, top), self.at(left, bottom), self.at(right, bottom)]
    }
}

/// What is known of a tile.
#[derive(Clone, Copy, Debug)]
struct Tile {
    /// The farthest sample; of tiles that have changed since, it may be nearer by now.
    farthest: f32,
    has_changed: bool,
    /// A plane that is nowhere nearer than what is in the tile.
    cover: Option<Plane>,
    /// How many rows of the tile the face that is being drawn covers from end to end.
    covered_rows: u32,
}

/// The tiles of a panel.
#[derive(Clone, Debug)]
pub(crate) struct Tiles {
    columns: usize,
    tiles: Vec<Tile>,
    /// From which sample to which what is drawn may be seen, in the rows that are being drawn.
    open: Vec<[usize; 2]>,
}

impl Tiles {
    pub(crate) fn new(columns: usize, rows: usize) -> Self {
        let new = Tile { farthest: f32::NEG_INFINITY, has_changed: false, cover: None, covered_rows: 0 };
        let columns = columns.div_ceil(TILE);
        Tiles { columns, tiles: vec![new; columns * rows.div_ceil(TILE)], open: Vec::new() }
    }

    /// Looks where in a row of tiles, from one sample to before another, a plane may be seen. Where there is no plane it
    /// may be seen everywhere.
    pub(crate) fn find_open(
        &mut self,
        row: usize,
        span: [usize; 2],
        plane: Option<Plane>,
        nearness: &Nearness<'_>,
    ) -> &[[usize; 2]] {
        self.open.clear();
        for column in span[0] / TILE..span[1].div_ceil(TILE) {
            let tile = &mut self.tiles[row * self.columns + column];
            if plane.is_some_and(|plane| tile.hides(plane, [column, row], nearness)) {
                continue;
            }
            let (start, end) = (column * TILE, (column + 1) * TILE);
            match self.open.last_mut().filter(|last| last[1] == start) {
                Some(last) => last[1] = end,
                None => self.open.push([start, end]),
            }
        }
        &self.open
    }

    /// What was found open last.
    pub(crate) fn open(&self) -> &[[usize; 2]] {
        &self.open
    }

    /// Takes note that a face covers some samples of a row of samples.
    pub(crate) fn cover(&mut self, row: usize, first: usize, end: usize) {
        let start = row / TILE * self.columns;
        for column in first / TILE..end.div_ceil(TILE) {
            let tile = &mut self.tiles[start + column];
            tile.has_changed = true;
            tile.covered_rows += u32::from(column * TILE >= first && (column + 1) * TILE <= end);
        }
    }

    /// Takes note that a face has been drawn in a row of tiles.
    pub(crate) fn finish(&mut self, row: usize, span: [usize; 2], plane: Option<Plane>) {
        for column in span[0] / TILE..span[1].div_ceil(TILE) {
            let tile = &mut self.tiles[row * self.columns + column];
            let is_covered = std::mem::take(&mut tile.covered_rows) == TILE as u32;
            let Some(plane) = plane.filter(|_| is_covered) else { continue };
            let is_nearer = |old: Plane| {
                let pairs = plane.on(column, row).into_iter().zip(old.on(column, row));
                pairs.into_iter().all(|(new, old)| new >= old)
            };
            if tile.cover.is_none_or(is_nearer) {
                tile.cover = Some(plane);
            }
        }
    }
}

/// The nearness of all samples, row by row.
pub(crate) struct Nearness<'a> {
    pub(crate) columns: usize,
    pub(crate) values: &'a [f32],
}

impl Tile {
    /// Whether nothing of a plane is seen in the tile.
    fn hides(&mut self, plane: Plane, [column, row]: [usize; 2], nearness: &Nearness<'_>) -> bool {
        let near = plane.on(column, row);
        let is_behind = |cover: Plane| {
            let pairs = near.into_iter().zip(cover.on(column, row));
            pairs.into_iter().all(|(near, cover)| near + MARGIN < cover)
        };
        if self.cover.is_some_and(is_behind) {
            return true;
        }
        if std::mem::take(&mut self.has_changed) {
            self.farthest = nearness.farthest(column, row);
        }
        near.into_iter().all(|near| near + MARGIN < f64::from(self.farthest))
    }
}

impl Nearness<'_> {
    /// The farthest sample of a tile.
    fn farthest(&self, column: usize, row: usize) -> f32 {
        let rows = self.values.chunks(self.columns).skip(row * TILE).take(TILE);
        let end = ((column + 1) * TILE).min(self.columns);
        let samples = rows.flat_map(|samples| &samples[column * TILE..end]);
        samples.fold(f32::INFINITY, |farthest, &near| farthest.min(near))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_face_is_as_near_as_its_corners_say() {
        let face = [[0.0, 0.0, 1.0], [10.0, 0.0, 2.0], [10.0, 10.0, 4.0], [0.0, 10.0, 3.0]];
        let plane = Plane::of(&face).unwrap();
        assert!((plane.at(5.0, 5.0) - 2.5).abs() < 1e-12);
        let mut bent = face;
        bent[3][2] = 3.5;
        assert!(Plane::of(&bent).is_none() && Plane::of(&face[..2]).is_none());
        let upright = [[0.0, 0.0, 0.0], [5.0, 5.0, 0.0], [5.0, 5.0, 1.0]];
        assert!(Plane::of(&upright).is_none());
    }
}
