//! In which order faces are painted. What is seen does not depend on it, but what it costs does.

use meshmend_core::{FaceId, Id, PolygonMesh};

use crate::depth::buffer::DepthBuffer;
use crate::look::appearance::Side;
use crate::look::shade::side_of;
use crate::vector::Vector;

/// Where faces cover a panel more often than this, they are sorted, so that most are found to be hidden.
const OFTEN: usize = 8;

/// Faces with more corners than this are not compared with each other.
const MOST_COMPARED: usize = 8;

/// A face to be painted, the nearest first.
struct Entry {
    nearest: f64,
    /// A sum over its corners, whatever the order in which they come.
    sum: u64,
    number: u32,
}

/// Paints all faces that are finite, so that of two in one place the front is seen, and of two fronts the lower one;
/// lists the others.
///
/// *Cost*: as [`DepthBuffer::paint`]; O(n log n) where n faces cover the panel often.
pub(crate) fn paint_faces(mesh: &PolygonMesh, placed: &[Vector], buffer: &mut DepthBuffer) -> Vec<FaceId> {
    let faces = mesh.complex().faces();
    let mut corners = Vec::new();
    let place = |face: FaceId, corners: &mut Vec<Vector>| {
        corners.clear();
        corners.extend(faces.face_vertices(face).iter().map(|v| placed[v.index()]));
    };
    let [mut fronts, mut backs, mut left_out] = [const { Vec::new() }; 3];
    let mut covered = 0_usize;
    for face in faces.faces() {
        place(face, &mut corners);
        if corners.iter().any(|corner| !corner[0].is_finite()) {
            left_out.push(face);
            continue;
        }
        covered = covered.saturating_add(buffer.samples_around(&corners));
        match side_of(&corners) {
            Side::Front => fronts.push(face),
            Side::Back => backs.push(face),
        }
    }
    fronts.append(&mut backs);
    let order = fronts;
    if covered <= OFTEN.saturating_mul(buffer.samples()) {
        for (number, &face) in (0_u32..).zip(&order) {
            place(face, &mut corners);
            buffer.paint(number, &corners);
        }
    } else {
        paint_sorted(&order, buffer, place);
    }
    buffer.rename(&order);
    left_out
}

/// Paints from the nearest to the farthest, each place that several faces have once.
fn paint_sorted(order: &[FaceId], buffer: &mut DepthBuffer, place: impl Fn(FaceId, &mut Vec<Vector>)) {
    let (mut corners, mut last) = (Vec::new(), Vec::new());
    let entry = |(number, &face): (u32, &FaceId)| {
        place(face, &mut corners);
        let nearest = corners.iter().fold(f64::NEG_INFINITY, |nearest, corner| nearest.max(corner[2]));
        Entry { nearest, sum: corners.iter().map(mixed).fold(0, u64::wrapping_add), number }
    };
    let mut entries: Vec<Entry> = (0_u32..).zip(order).map(entry).collect();
    entries.sort_unstable_by(|one, other| {
        let nearness = other.nearest.total_cmp(&one.nearest);
        nearness.then(one.sum.cmp(&other.sum)).then(one.number.cmp(&other.number))
    });
    let mut corners = Vec::new();
    for Entry { number, .. } in entries {
        place(order[number as usize], &mut corners);
        // Of those in one place the one with the lowest number came first.
        if !is_same_face(&corners, &last) {
            buffer.paint(number, &corners);
            std::mem::swap(&mut corners, &mut last);
        }
    }
}

/// A number that hardly any other corner has.
fn mixed(corner: &Vector) -> u64 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    corner.iter().fold(FACTOR, |mix, x| (mix ^ x.to_bits()).wrapping_mul(FACTOR).rotate_left(29))
}

/// Whether two faces have the same corners in the same order, whichever is the first and whichever way they run.
fn is_same_face(one: &[Vector], other: &[Vector]) -> bool {
    let count = one.len();
    if count != other.len() || count > MOST_COMPARED {
        return false;
    }
    let runs_as = |first: usize, step: usize| (0..count).all(|i| one[i] == other[(first + i * step) % count]);
    (0..count).any(|first| runs_as(first, 1) || runs_as(first, count - 1))
}
