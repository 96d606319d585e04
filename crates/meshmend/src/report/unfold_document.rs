//! The document of a layout.

use meshmend_core::{FaceId, PolygonMesh};
use meshmend_flatten::{Boundary, Flatten, Weights};
use meshmend_io::{Loss, Note};
use meshmend_repair::Distance;
use serde::Serialize;

use super::{BeforeAndAfter, Listing, SCHEMA};
use crate::{StoredCounts, Unfolded, View};

/// What was laid out and how well, with every list cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct UnfoldDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that was read, if one was.
    pub file: Option<String>,
    /// The file that was written, if one was.
    pub output: Option<String>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// `circle` or `square`.
    pub boundary: &'static str,
    /// `tutte` or `harmonic`.
    pub weights: &'static str,
    /// What there was before, in that view, and what there is after.
    pub stored: BeforeAndAfter,
    /// How many edges were opened to make discs.
    pub opened_edges: usize,
    /// How many discs there are, each in a square of its own.
    pub discs: usize,
    /// How often the weights were evened out, so that no face became too small.
    pub rounds: usize,
    /// Whether no face is flipped or collapsed, exactly.
    pub one_to_one: bool,
    /// Faces that run the other way round than their disc.
    pub flipped: Listing<FaceId>,
    /// Faces with a part that has no area.
    pub collapsed: Listing<FaceId>,
    /// Whether the mesh had texture coordinates, which the layout has replaced.
    pub replaced_texcoords: bool,
    /// What the written format can't carry.
    pub losses: Vec<Loss>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

impl UnfoldDocument {
    /// The document of what was laid out, with at most `limit` items in each list.
    pub fn new(unfolded: &Unfolded, request: &Flatten, view: View, limit: usize) -> Self {
        let counts = |mesh: &PolygonMesh| StoredCounts::of(mesh);
        let layout = &unfolded.layout;
        UnfoldDocument {
            schema: SCHEMA,
            file: None,
            output: None,
            view: view.name(),
            weld: view.distance(),
            boundary: match request.boundary {
                Boundary::Circle => "circle",
                Boundary::Square | Boundary::SquareAt(_) => "square",
            },
            weights: match request.weights {
                Weights::Uniform => "tutte",
                Weights::Cotangent => "harmonic",
            },
            stored: BeforeAndAfter { before: counts(&unfolded.before), after: counts(&unfolded.mesh) },
            opened_edges: unfolded.opened_edges,
            discs: layout.discs,
            rounds: layout.rounds,
            one_to_one: layout.is_one_to_one(),
            flipped: Listing::cut(layout.flipped.iter().copied(), limit),
            collapsed: Listing::cut(layout.collapsed.iter().copied(), limit),
            replaced_texcoords: unfolded.has_replaced_texcoords,
            losses: Vec::new(),
            notes: Vec::new(),
        }
    }
}
