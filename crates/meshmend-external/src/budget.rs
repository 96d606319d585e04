//! How much memory may be used, and into how many parts a mesh is to be put.

use std::path::Path;

use meshmend_io::Announced;

use crate::error::ExternalError;
use crate::sides::PatchSides;
use crate::spill::Spill;

/// What the program takes before it reads anything, and what allocations take beyond what is asked for.
const PROGRAM: u64 = 28 << 20;

/// What a face takes in a part while the part is looked at: its record, its corners, the sorted corners outside, the table of edges, the
/// corners of vertices, and what duplicates are looked for with.
pub(crate) const BYTES_A_FACE: u64 = 150;

/// The memory that may be used, and the folder for what does not fit it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget<'a> {
    pub(crate) memory: u64,
    pub(crate) folder: &'a Path,
    /// So many parts, whatever fits.
    pub(crate) parts: Option<usize>,
}

impl Budget<'_> {
    /// How much is left beside what stays in memory all the time.
    fn room(&self, what: &'static str, resident: u64) -> Result<u64, ExternalError> {
        let least = resident + PROGRAM + (8 << 20);
        if self.memory < least {
            return Err(ExternalError::Memory { what, needed: least, allowed: self.memory });
        }
        Ok(self.memory - resident - PROGRAM)
    }

    /// Into how many parts things of so many bytes go, of which one part at a time is in memory beside what stays there.
    pub(crate) fn parts(&self, resident: u64, bytes: u64) -> Result<usize, ExternalError> {
        let room = self.room("the welding", resident)?;
        // Parts are of unequal size, and blocks on their way to disk take some of the room.
        Ok(self.parts.unwrap_or(bytes.div_ceil(room / 2) as usize).max(1))
    }

    /// What parts of faces may take, for a view of so many vertices.
    pub(crate) fn for_faces(
        &self,
        announced: &Announced,
        vertices: u64,
        is_welded: bool,
    ) -> Result<FaceBudget, ExternalError> {
        // Either the patches of faces are in memory, or the components of vertices with their boundary.
        let of_faces = PatchSides::bytes(announced.faces);
        let of_vertices = 4 * vertices + vertices / 2;
        let map = if is_welded { announced.vertices / 6 + 4 * self.range_of_stored(announced) } else { 0 };
        let room = self.room("the mesh", of_faces.max(of_vertices + map))? * 7 / 8;
        // A face is in as many parts as it has corners at most.
        let copies = if announced.is_soup { 3 * announced.faces } else { announced.corners };
        Ok(FaceBudget {
            parts: self.parts.unwrap_or((copies * BYTES_A_FACE).div_ceil(room) as usize).max(1),
            faces_a_part: if self.parts.is_some() { u64::MAX } else { room / BYTES_A_FACE },
            room,
        })
    }

    /// How many vertices as stored have their vertices of the view in memory at a time. Faces of a soup name them in order, others in
    /// any order.
    pub(crate) fn range_of_stored(&self, announced: &Announced) -> u64 {
        let most = announced.vertices.max(1);
        match (announced.is_soup, self.parts) {
            (false, _) => most,
            (true, Some(parts)) => most.div_ceil(parts as u64),
            (true, None) => most.min((self.memory / 64).max(1 << 16)),
        }
    }

    /// Room on disk for so many parts.
    pub(crate) fn spill(&self, parts: usize) -> Result<Spill, ExternalError> {
        Spill::new(self.folder, parts, self.memory / 32)
    }
}

/// What parts of faces may take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FaceBudget {
    /// How many parts there are.
    pub(crate) parts: usize,
    /// How many faces a part may have before it is put in parts again.
    pub(crate) faces_a_part: u64,
    /// How many bytes there are for what is looked at.
    pub(crate) room: u64,
}
