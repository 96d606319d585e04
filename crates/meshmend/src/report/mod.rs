//! Reports for other programs: plain facts with a schema number, the same bytes for the same input.
//!
//! A *document* is a report with every list cut to a limit and its full count beside it, so that it is small
//! whatever the mesh is. The command line prints these documents, as JSON or in words.
//!
//! ```
//! use meshmend::report::{CheckDocument, json};
//! use meshmend::{CheckOptions, check};
//! # use meshmend::{FaceTable, PolygonMesh, VertexId};
//! # let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
//! # let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces)?;
//!
//! let document = CheckDocument::new(check(&mesh, &CheckOptions::default())?, 10);
//! assert!(json(&document)?.contains(r#""euler_characteristic":1"#));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod advice_document;
mod batch_document;
mod check_document;
mod geometry_document;
mod incremental_document;
mod kernels_document;
mod listing;
mod loops_document;
mod matrix_document;
mod parts_document;
mod pass_document;
mod repair_document;
mod row;
mod sarif;
#[cfg(feature = "flatten")]
mod unfold_document;

pub use advice_document::{AdviceDocument, short};
pub use batch_document::BatchDocument;
pub use check_document::{CheckDocument, DefectGroup};
pub use geometry_document::{
    ComponentDocument, ContactCounts, GeometryDocument, IntersectionsDocument, LoopCounts, OpenLoopDocument,
};
pub use incremental_document::{IncrementalDocument, RunningStep};
pub use kernels_document::{KernelTrial, KernelsDocument};
pub use listing::{FacesRound, Listing, MOST_POSITIONS, PlacedDefect};
pub use loops_document::{
    ComponentLoops, CutComponent, CutDocument, LoopDocument, LoopsDocument, MOST_PATH_VERTICES, SeamDocument,
};
pub use matrix_document::{
    ArraysDocument, EdgeDocument, EigenvalueDocument, LostSideDocument, MatrixDocument, MatrixSize,
    NeighbourhoodDocument, RankDocument, SpectrumDocument, WalksDocument, WalksTo,
};
pub use parts_document::PartsDocument;
pub use pass_document::{
    ApartDocument, DroppedDocument, FigureChanges, PassDocument, SliversDocument, TJunctionsDocument,
};
pub use repair_document::{
    BeforeAndAfter, CreatedFace, CreatedVertex, EmptiedNameDocument, NamedFace, ProvenanceDocument,
    RemovedFaces, RepairDocument,
};
pub use row::{LONGEST_ROW_MESSAGE, Row, RowFigures, RowLoss, RowStatus};
pub use sarif::{Sarif, placing_elements};
use serde::Serialize;
#[cfg(feature = "flatten")]
pub use unfold_document::UnfoldDocument;

/// The number of the form that documents have; it changes when a key changes its meaning or goes.
pub const SCHEMA: u32 = 2;

/// A document as one line of JSON with sorted keys. A number that is not finite becomes `null`.
///
/// # Errors
/// When the value has a map whose keys are not texts. No document has one.
pub fn json(document: &impl Serialize) -> Result<String, serde_json::Error> {
    // A map of serde_json is sorted by key, while a struct is written in the order of its fields.
    serde_json::to_value(document).map(|value| value.to_string())
}
