//! The two ways to look at a file: by its indices, or by its positions.

use meshmend_core::{PolygonMesh, Watch};
use meshmend_io::{Format, Part};
use meshmend_repair::{Advice, Context, Distance, Pass, PassError, Weld};

/// As what a mesh is judged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum View {
    /// As stored: two vertices are one when they have the same index.
    #[default]
    Indexed,
    /// As welded: two vertices are one when they are in the same place.
    Welded(Distance),
}

impl View {
    /// How files of a format are usually judged: by position where the format has no indices, else as stored.
    pub fn usual_for(format: Format) -> Self {
        if format.has_indices() { View::Indexed } else { View::Welded(Distance::Exact) }
    }

    /// How a part of a file of a format is usually judged: as stored where the file itself says which vertices are one.
    pub fn usual_for_part(format: Format, part: &Part) -> Self {
        if part.tells_vertices() { View::Indexed } else { View::usual_for(format) }
    }

    /// Its name in reports: `indexed` or `welded`.
    pub fn name(self) -> &'static str {
        match self {
            View::Indexed => "indexed",
            View::Welded(_) => "welded",
        }
    }

    /// The distance within which vertices count as one; `None` for the view by index.
    pub fn distance(self) -> Option<Distance> {
        match self {
            View::Indexed => None,
            View::Welded(distance) => Some(distance),
        }
    }

    /// The view with the distance that stands out in a mesh, where that is to be looked for.
    ///
    /// # Errors
    /// As [`Advice::on`].
    ///
    /// *Cost*: that of [`Advice::on`], or constant where the distance is known.
    pub fn resolved(self, mesh: &PolygonMesh, watch: &Watch) -> Result<Self, PassError> {
        match self {
            View::Welded(Distance::Auto) => Ok(View::Welded(Advice::on(mesh, watch)?.weld())),
            known => Ok(known),
        }
    }

    /// A mesh as this view shows it: welded, or as stored.
    ///
    /// # Errors
    /// When the distance is not a finite, non-negative number.
    pub fn of(self, mesh: &PolygonMesh) -> Result<PolygonMesh, PassError> {
        match self {
            View::Indexed => Ok(mesh.clone()),
            View::Welded(distance) => Ok(Weld::within(distance).apply(mesh, &Context::default())?.mesh),
        }
    }
}
