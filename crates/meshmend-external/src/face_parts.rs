//! Faces on disk, by ranges of vertices.

use meshmend_core::VertexId;

use crate::budget::{BYTES_A_FACE, Budget};
use crate::error::ExternalError;
use crate::part::Part;
use crate::spill::Spill;

/// Faces on disk, by ranges of vertices: each is in all parts in which it has a vertex.
pub(crate) struct FaceParts {
    pub(crate) spill: Spill,
    /// The first vertex of the first part, and how many vertices a part has.
    first: u32,
    range: u32,
    end: u32,
}

/// The bit of a face's number that says that it is no triangle: how many vertices it has comes next.
const POLYGON: u32 = 1 << 31;

impl FaceParts {
    pub(crate) fn new(budget: &Budget<'_>, parts: usize, vertices: u32) -> Result<Self, ExternalError> {
        FaceParts::of_range(budget, parts, (0, vertices))
    }

    /// Parts of a range of vertices.
    pub(crate) fn of_range(
        budget: &Budget<'_>,
        parts: usize,
        (first, end): (u32, u32),
    ) -> Result<Self, ExternalError> {
        let range = (end - first).div_ceil(parts as u32).max(1);
        let parts = (end - first).div_ceil(range).max(1) as usize;
        Ok(FaceParts { spill: budget.spill(parts)?, first, range, end })
    }

    /// The part of a vertex in the range.
    #[inline]
    pub(crate) fn part_of(&self, vertex: u32) -> usize {
        ((vertex - self.first) / self.range) as usize
    }

    /// The vertices of a part.
    pub(crate) fn range(&self, part: usize) -> (u32, u32) {
        let first = self.first + part as u32 * self.range;
        (first, first.saturating_add(self.range).min(self.end))
    }

    /// Puts a face in normal form in the parts of its vertices.
    #[inline]
    pub(crate) fn push(&mut self, face: u32, vertices: &[VertexId]) -> Result<(), ExternalError> {
        let part =
            |vertex: VertexId| (self.first..self.end).contains(&vertex.0).then(|| self.part_of(vertex.0));
        if let &[a, b, c] = vertices {
            let parts = [part(a), part(b), part(c)];
            for (place, part) in parts.into_iter().enumerate() {
                if let Some(known) = part
                    && !parts[..place].contains(&part)
                {
                    self.spill.push(known, &[face, a.0, b.0, c.0])?;
                }
            }
            return Ok(());
        }
        let mut parts: Vec<usize> = vertices.iter().copied().filter_map(part).collect();
        parts.sort_unstable();
        parts.dedup();
        for part in parts {
            self.spill.push(part, &[face | POLYGON, vertices.len() as u32])?;
            vertices.iter().try_for_each(|vertex| self.spill.push(part, &[vertex.0]))?;
        }
        Ok(())
    }

    /// Looks at a part as a mesh. One of more faces than a part may have is put in parts again, down to a single vertex. Returns how
    /// many bytes that wrote.
    pub(crate) fn look_at(
        &self,
        part: usize,
        (budget, faces_a_part): (&Budget<'_>, u64),
        look: &mut dyn FnMut(&Part) -> Result<(), ExternalError>,
    ) -> Result<u64, ExternalError> {
        let (range, faces) = (self.range(part), (self.spill.len(part) / 4) as u64);
        if faces <= faces_a_part {
            look(&Part::of(self.spill.load(part)?, range))?;
            return Ok(0);
        }
        if range.1 - range.0 == 1 {
            let needed = budget.memory + BYTES_A_FACE * (faces - faces_a_part);
            return Err(ExternalError::Memory {
                what: "the star of a single vertex",
                needed,
                allowed: budget.memory,
            });
        }
        let count = 2 * faces.div_ceil(faces_a_part.max(1)) as usize;
        let mut smaller = FaceParts::of_range(budget, count, range)?;
        self.split(part, &mut smaller)?;
        let mut written = smaller.spill.written();
        for part in 0..smaller.spill.part_count() {
            written += smaller.look_at(part, (budget, faces_a_part), look)?;
        }
        Ok(written)
    }

    /// Puts the faces of a part in smaller parts.
    fn split(&self, part: usize, smaller: &mut FaceParts) -> Result<(), ExternalError> {
        let (mut begun, mut face) = (Vec::new(), Vec::new());
        self.spill.read(part, |numbers| {
            begun.extend_from_slice(numbers);
            let whole = whole_faces(&begun);
            each_face(&begun[..whole], |number, vertices| {
                face.clear();
                face.extend(vertices.iter().copied().map(VertexId));
                smaller.push(number, &face)
            })?;
            begun.drain(..whole);
            Ok(())
        })
    }
}

/// Hands over the faces in the numbers of a part, by ascending number of the face.
pub(crate) fn each_face<E>(
    mut numbers: &[u32],
    mut take: impl FnMut(u32, &[u32]) -> Result<(), E>,
) -> Result<(), E> {
    while let Some((&head, rest)) = numbers.split_first() {
        let (count, rest) = if head & POLYGON == 0 { (3, rest) } else { (rest[0] as usize, &rest[1..]) };
        let (vertices, after) = rest.split_at(count);
        take(head & !POLYGON, vertices)?;
        numbers = after;
    }
    Ok(())
}

/// Whether the numbers of a part are those of triangles alone.
pub(crate) fn are_triangles(numbers: &[u32]) -> bool {
    let (faces, rest) = numbers.as_chunks::<4>();
    // Up to the first face that is none, each has four numbers.
    rest.is_empty() && faces.iter().all(|face| face[0] & POLYGON == 0)
}

/// How many of some numbers are those of whole faces.
fn whole_faces(numbers: &[u32]) -> usize {
    let mut end = 0;
    while let Some(&head) = numbers.get(end) {
        let length = if head & POLYGON == 0 {
            4
        } else {
            let Some(&count) = numbers.get(end + 1) else { return end };
            2 + count as usize
        };
        if numbers.len() < end + length {
            return end;
        }
        end += length;
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_in_each_part_of_its_vertices_once() {
        let folder = std::env::temp_dir();
        let budget = Budget { memory: 1 << 30, folder: &folder, parts: None };
        let mut parts = FaceParts::new(&budget, 3, 8).unwrap();
        assert_eq!([0, 1, 2].map(|part| parts.range(part)), [(0, 3), (3, 6), (6, 8)]);
        let faces: [&[u32]; 4] = [&[0, 1, 2], &[2, 3, 7], &[7, 6, 1, 0], &[4, 5, 3]];
        for (face, vertices) in (0..).zip(faces) {
            let vertices: Vec<VertexId> = vertices.iter().copied().map(VertexId).collect();
            parts.push(face, &vertices).unwrap();
        }
        let mut found = Vec::new();
        for part in 0..3 {
            each_face(&parts.spill.load(part).unwrap(), |face, vertices| {
                assert_eq!(vertices, faces[face as usize]);
                found.push((part, face));
                Ok::<(), ()>(())
            })
            .unwrap();
        }
        assert_eq!(found, [(0, 0), (0, 1), (0, 2), (1, 1), (1, 3), (2, 1), (2, 2)]);
    }
}
