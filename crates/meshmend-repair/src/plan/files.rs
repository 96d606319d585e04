//! What a plan says beside the passes.

use serde::{Deserialize, Serialize};

/// What a plan says for whoever reads and writes the files. A pipeline does not look at it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct FilePolicies {
    /// What fails a run (`fail-on`): kinds of defect and other words.
    pub fail_on: Vec<String>,
    /// How a vertex is written whose attributes differ from face to face (`seams`).
    pub seams: Option<WrittenSeams>,
    /// How many items each list of a report shows (`limit`).
    pub limit: Option<usize>,
}

/// How a vertex is written whose attributes differ from face to face, where a format has them at the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum WrittenSeams {
    /// As several vertices at one place.
    Split,
    /// Once, with its values at the corners.
    Corners,
    /// Not at all: the mesh is not written.
    Fail,
}
