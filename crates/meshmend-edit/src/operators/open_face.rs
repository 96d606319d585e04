//! A face becomes a hole, and a hole a face.

use crate::place::Place;
use crate::refusal::unless;
use crate::{Done, Edit, EditRefusal, Editor, FaceKey, HalfKey, Refused};

impl Editor {
    /// Whether a face can become a hole.
    ///
    /// # Errors
    /// `stale`; `would-pinch` for each vertex of the face that is on a hole.
    pub fn can_open_face(&self, face: FaceKey) -> Result<(), Refused> {
        self.fresh([face.into()])?;
        let vertices = self.round(self.faces[face].half).map(|half| self.halves[half].origin);
        unless(vertices.filter(|&v| self.is_on_boundary(v)).map(EditRefusal::WouldPinch).collect())
    }

    /// Makes a face a hole. [`Editor::close_hole`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_open_face`].
    ///
    /// *Cost*: linear in the edges of the face's vertices.
    pub fn open_face(&mut self, face: FaceKey) -> Result<Done, Refused> {
        self.can_open_face(face)?;
        let first = self.faces[face].half;
        let rim: Vec<HalfKey> = self.round(first).collect();
        for half in rim {
            (self.halves[half].face, self.halves[half].place) = (None, Place::Unknown);
        }
        self.faces.remove(face);
        Ok(Done::undone_by(Edit::CloseHole { half: first }))
    }

    /// Whether a hole can become a face: always, since a vertex is on one hole at most, and once.
    ///
    /// # Errors
    /// `stale`; `not-a-hole` if there is a face to the left of the half-edge.
    pub fn can_close_hole(&self, half: HalfKey) -> Result<(), Refused> {
        self.fresh([half.into()])?;
        let is_closed = self.halves[half].face.is_some();
        unless(is_closed.then_some(EditRefusal::NotAHole(half)).into_iter().collect())
    }

    /// Makes the hole along a half-edge a face, which begins there. [`Editor::open_face`] undoes it.
    ///
    /// # Errors
    /// As [`Editor::can_close_hole`].
    ///
    /// *Cost*: linear in the sides of the hole.
    pub fn close_hole(&mut self, half: HalfKey) -> Result<Done, Refused> {
        self.can_close_hole(half)?;
        let face = self.add_face(half, None);
        Ok(Done { faces: vec![face], ..Done::undone_by(Edit::OpenFace { face }) })
    }
}
