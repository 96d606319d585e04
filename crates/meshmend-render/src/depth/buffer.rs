//! Which face is nearest at each sample of a panel: scan conversion into a depth buffer.
//!
//! Every face is drawn by its boundary: each of its sides crosses rows of samples, and between the first and second,
//! third and fourth … crossing of a row lies the face. Nearness is interpolated along sides and then along rows:
//! exact for triangles and plane faces, without cracks between any faces that share sides, and the same whatever the
//! corner at which a face begins and whichever way it runs. A face whose sides cross in the picture is filled by the
//! even-odd rule.

use meshmend_core::FaceId;

use crate::depth::occlusion::{Nearness, Plane, TILE, Tiles};
use crate::vector::Vector;

/// The nearest face at each sample, and how near it is.
#[derive(Clone, Debug)]
pub(crate) struct DepthBuffer {
    columns: usize,
    rows: usize,
    /// Samples a pixel, along each axis.
    density: usize,
    nearness: Vec<f32>,
    owner: Vec<u32>,
    crossings: Vec<Crossing>,
    tiles: Tiles,
}

/// Where a side of a face crosses a row of samples.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    row: u32,
    x: f64,
    near: f64,
}

/// The owner of a sample at which there is no face.
pub(crate) const NOTHING: u32 = u32::MAX;

/// About how many crossings are kept at a time.
const CROSSINGS_AT_ONCE: usize = 1 << 22;

/// Differences of nearness below this, in halves of the mesh's longest side, hide nothing.
const TOLERANCE: f32 = 2e-3;

impl DepthBuffer {
    /// An empty buffer for a panel of so many pixels.
    pub(crate) fn new(width: usize, height: usize, density: usize) -> Self {
        let (columns, rows) = (width * density, height * density);
        DepthBuffer {
            columns,
            rows,
            density,
            nearness: vec![f32::NEG_INFINITY; columns * rows],
            owner: vec![NOTHING; columns * rows],
            crossings: Vec::new(),
            tiles: Tiles::new(columns, rows),
        }
    }

    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    pub(crate) fn density(&self) -> usize {
        self.density
    }

    /// The nearest face at each sample, row by row.
    pub(crate) fn owners(&self) -> &[u32] {
        &self.owner
    }

    /// How many samples there are.
    pub(crate) fn samples(&self) -> usize {
        self.owner.len()
    }

    /// How many samples the box around some corners covers.
    pub(crate) fn samples_around(&self, corners: &[Vector]) -> usize {
        let [[left, right], [top, bottom]] = self.samples_of(corners);
        (right - left) * (bottom - top)
    }

    /// The columns and rows of samples of the box around some corners.
    fn samples_of(&self, corners: &[Vector]) -> [[usize; 2]; 2] {
        let density = self.density as f64;
        [(0, self.columns), (1, self.rows)].map(|(axis, most)| {
            let places = corners.iter().map(|corner| corner[axis] * density);
            let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
                (low.min(place), high.max(place))
            });
            let first = sample_from(low, most);
            // Where all corners lie on one side, or one is not a number, the box covers no sample.
            [first, sample_from(high, most).max(first)]
        })
    }

    /// Paints a face with its corners in the panel's pixels. Of equally near faces the one of the lower number stays,
    /// whatever the order in which they are painted.
    ///
    /// *Cost*: the corners, the rows that each side crosses, with a logarithm, and the samples covered, apart from
    /// those in tiles where the face is behind others.
    pub(crate) fn paint(&mut self, face: u32, corners: &[Vector]) {
        let [columns, [first, end]] = self.samples_of(corners);
        let is_large = columns[1] - columns[0] > TILE && end - first > TILE;
        let plane = if is_large { self.plane(corners) } else { None };
        let most = (CROSSINGS_AT_ONCE / corners.len().max(1)).max(1);
        let mut top = first;
        while top < end {
            let row = top / TILE;
            let bottom = end.min((row + 1) * TILE).min(top + most);
            let nearness = Nearness { columns: self.columns, values: &self.nearness };
            if !self.tiles.find_open(row, columns, plane, &nearness).is_empty() {
                self.paint_rows(face, corners, top..bottom);
                self.tiles.finish(row, columns, plane);
            }
            top = bottom;
        }
    }

    fn plane(&self, corners: &[Vector]) -> Option<Plane> {
        let density = self.density as f64;
        let in_samples: Vec<Vector> =
            corners.iter().map(|&[x, y, near]| [x * density, y * density, near]).collect();
        Plane::of(&in_samples)
    }

    fn paint_rows(&mut self, face: u32, corners: &[Vector], rows: std::ops::Range<usize>) {
        let mut crossings = std::mem::take(&mut self.crossings);
        find_crossings(corners, self.density as f64, rows, &mut crossings);
        crossings.sort_unstable_by(|one, other| {
            one.row.cmp(&other.row).then(one.x.total_cmp(&other.x)).then(one.near.total_cmp(&other.near))
        });
        crossings.as_chunks().0.iter().for_each(|&[from, to]| self.fill(face, from, to));
        self.crossings = crossings;
    }

    fn fill(&mut self, face: u32, from: Crossing, to: Crossing) {
        let (first, end) = (sample_from(from.x, self.columns), sample_from(to.x, self.columns));
        let slope = (to.near - from.near) / (to.x - from.x);
        let start = from.row as usize * self.columns;
        for place in 0..self.tiles.open().len() {
            let [open, close] = self.tiles.open()[place];
            let (first, end) = (first.max(open), end.min(close));
            for column in first..end {
                let near = (from.near + slope * (column as f64 + 0.5 - from.x)) as f32;
                let sample = start + column;
                let (nearest, owner) = (self.nearness[sample], self.owner[sample]);
                if near > nearest || (near == nearest && face < owner) {
                    self.nearness[sample] = near;
                    self.owner[sample] = face;
                }
            }
            if first < end {
                self.tiles.cover(from.row as usize, first, end);
            }
        }
    }

    /// Puts for each number under which faces were painted the face that it stands for.
    pub(crate) fn rename(&mut self, faces: &[FaceId]) {
        let owned = self.owner.iter_mut().filter(|owner| **owner != NOTHING);
        owned.for_each(|owner| *owner = faces[*owner as usize].0);
    }

    /// The nearest face at a place in the panel's pixels; `None` where there is none.
    pub(crate) fn face_at(&self, x: f64, y: f64) -> Option<u32> {
        let (column, row) = self.sample_at(x, y)?;
        Some(self.owner[row * self.columns + column]).filter(|&face| face != NOTHING)
    }

    /// Whether nothing hides a point that lies on a face.
    pub(crate) fn is_seen_on(&self, face: u32, point: Vector) -> bool {
        (face != NOTHING && self.face_at(point[0], point[1]) == Some(face)) || self.is_seen(point)
    }

    /// Whether nothing hides a point: it is at least as near as the farthest of the nine samples about it, so that a
    /// line on a steep face is not hidden by that face.
    pub(crate) fn is_seen(&self, point: Vector) -> bool {
        let Some((column, row)) = self.sample_at(point[0], point[1]) else { return true };
        let (left, right) = (column.saturating_sub(1), (column + 2).min(self.columns));
        let rows = row.saturating_sub(1)..(row + 2).min(self.rows);
        let samples =
            rows.flat_map(|row| &self.nearness[row * self.columns + left..row * self.columns + right]);
        let farthest = samples.fold(f32::INFINITY, |farthest, &near| farthest.min(near));
        point[2] as f32 >= farthest - TOLERANCE
    }

    fn sample_at(&self, x: f64, y: f64) -> Option<(usize, usize)> {
        let (column, row) = ((x * self.density as f64).floor(), (y * self.density as f64).floor());
        let is_inside = column >= 0.0 && row >= 0.0 && column < self.columns as f64 && row < self.rows as f64;
        is_inside.then_some((column as usize, row as usize))
    }
}

/// The first sample whose middle is at or after a place, at most `end`.
fn sample_from(place: f64, end: usize) -> usize {
    // Casting puts what is below zero, or no number, to zero.
    ((place - 0.5).ceil() as usize).min(end)
}

/// Where the sides of a face cross some rows.
fn find_crossings(corners: &[Vector], density: f64, rows: std::ops::Range<usize>, found: &mut Vec<Crossing>) {
    found.clear();
    let nexts = corners.iter().cycle().skip(1);
    for (&one, &other) in corners.iter().zip(nexts) {
        // From top to bottom, so that a side gives the same crossings in every face that has it.
        let (from, to) = if one[1] <= other[1] { (one, other) } else { (other, one) };
        let [top, bottom] = [from, to].map(|corner| corner[1] * density);
        let first = sample_from(top, rows.end).max(rows.start);
        for row in first..sample_from(bottom, rows.end) {
            let along = (row as f64 + 0.5 - top) / (bottom - top);
            let at = |axis: usize| from[axis] + (to[axis] - from[axis]) * along;
            found.push(Crossing { row: row as u32, x: at(0) * density, near: at(2) });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64, near: f64) -> [Vector; 4] {
        [[low, low, near], [high, low, near], [high, high, near], [low, high, near]]
    }

    fn painted(faces: &[(u32, &[Vector])]) -> DepthBuffer {
        let mut buffer = DepthBuffer::new(8, 8, 1);
        faces.iter().for_each(|(face, corners)| buffer.paint(*face, corners));
        buffer
    }

    fn covered(buffer: &DepthBuffer, face: u32) -> usize {
        buffer.owners().iter().filter(|&&owner| owner == face).count()
    }

    #[test]
    fn a_square_covers_the_samples_whose_middles_it_holds() {
        assert_eq!(covered(&painted(&[(0, &square(1.0, 5.0, 0.0))]), 0), 16);
        assert_eq!(covered(&painted(&[(0, &square(1.6, 4.4, 0.0))]), 0), 4);
        assert_eq!(covered(&painted(&[(0, &square(-9.0, 90.0, 0.0))]), 0), 64);
        assert_eq!(covered(&painted(&[(0, &[])]), 0), 0);
    }

    #[test]
    fn the_nearer_face_hides_whatever_the_order() {
        let (near, far) = (square(2.0, 6.0, 1.0), square(0.0, 8.0, -1.0));
        for faces in [[(0, &near[..]), (1, &far[..])], [(1, &far[..]), (0, &near[..])]] {
            let buffer = painted(&faces);
            assert_eq!((covered(&buffer, 0), covered(&buffer, 1)), (16, 48));
        }
        assert_eq!(
            covered(&painted(&[(0, &near), (1, &near)]), 0),
            16,
            "of equally near ones the first stays"
        );
    }

    #[test]
    fn faces_that_pass_through_each_other_part_where_they_meet() {
        let rising = [[0.0, 0.0, -1.0], [8.0, 0.0, 1.0], [8.0, 8.0, 1.0], [0.0, 8.0, -1.0]];
        let buffer = painted(&[(0, &rising), (1, &square(0.0, 8.0, 0.0))]);
        let first_row: Vec<u32> = buffer.owners()[..8].to_vec();
        assert_eq!(first_row, [1, 1, 1, 1, 0, 0, 0, 0]);
    }

    #[test]
    fn neighbours_leave_no_sample_between_them_and_share_none() {
        let mut buffer = DepthBuffer::new(16, 16, 2);
        let (middle, around) =
            ([7.3, 6.9, 0.0], [[0.0, 0.0, 0.0], [16.0, 0.0, 0.0], [16.0, 16.0, 0.0], [0.0, 16.0, 0.0]]);
        for k in 0..4 {
            let mut alone = DepthBuffer::new(16, 16, 2);
            let triangle = [around[k], middle, around[(k + 1) % 4]];
            alone.paint(0, &triangle);
            let shared = alone
                .owners()
                .iter()
                .zip(buffer.owners())
                .filter(|(one, other)| **one == 0 && **other != NOTHING);
            assert_eq!(shared.count(), 0);
            buffer.paint(k as u32, &triangle);
        }
        assert_eq!(covered(&buffer, NOTHING), 0);
    }

    #[test]
    fn a_face_is_the_same_from_every_corner_and_both_ways() {
        let face = [[0.3, 0.1, 0.7], [7.9, 2.2, -0.4], [4.1, 7.7, 0.2]];
        let expected = painted(&[(0, &face)]).nearness;
        for turn in 0..3 {
            let mut other = face;
            other.rotate_left(turn);
            assert_eq!(painted(&[(0, &other)]).nearness, expected);
            other.reverse();
            assert_eq!(painted(&[(0, &other)]).nearness, expected);
        }
    }

    #[test]
    fn a_hollow_face_is_not_filled() {
        let horseshoe =
            [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [5.0, 8.0], [5.0, 3.0], [3.0, 3.0], [3.0, 8.0], [0.0, 8.0]];
        let buffer = painted(&[(0, &horseshoe.map(|[x, y]| [x, y, 0.0]))]);
        assert_eq!(covered(&buffer, 0), 64 - 10);
        assert_eq!(
            (buffer.face_at(4.5, 5.5), buffer.face_at(1.5, 5.5), buffer.face_at(-1.0, 99.0)),
            (None, Some(0), None)
        );
    }

    #[test]
    fn a_face_of_very_many_corners_is_painted_band_by_band() {
        // Teeth that reach from top to bottom: more crossings than are kept at once.
        let teeth = CROSSINGS_AT_ONCE / 4;
        let mut corners: Vec<Vector> = (0..teeth)
            .map(|k| [8.0 * k as f64 / teeth as f64, if k % 2 == 0 { 0.0 } else { 8.0 }, 0.0])
            .collect();
        corners.extend([[8.0, 9.0, 0.0], [0.0, 9.0, 0.0]]);
        let buffer = painted(&[(0, &corners)]);
        assert!(buffer.crossings.len() <= CROSSINGS_AT_ONCE);
        assert_eq!(covered(&painted(&[(0, &square(0.0, 8.0, 0.0))]), 0), 64);
        assert!(covered(&buffer, 0) > 0);
    }

    #[test]
    fn points_are_seen_in_front_of_a_face_and_on_it_and_hidden_behind_it() {
        let buffer = painted(&[(0, &square(0.0, 8.0, 0.0))]);
        assert!(buffer.is_seen([4.0, 4.0, 0.5]) && buffer.is_seen([4.0, 4.0, 0.0]));
        assert!(!buffer.is_seen([4.0, 4.0, -0.5]));
        assert!(buffer.is_seen([40.0, 4.0, -0.5]), "outside of the panel nothing hides");
    }
}
