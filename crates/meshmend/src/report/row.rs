//! The row of a file: what became of it among many, always with the same columns.
//!
//! A ledger of many files is one row a file, whatever happened to it. `docs/batch.md` says what each column means, and
//! `schemas/row.json` says it to programs.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::SCHEMA;

/// How long a message of a row is at most, in bytes.
pub const LONGEST_ROW_MESSAGE: usize = 500;

/// What became of a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Row {
    /// The file as listed.
    pub path: String,
    /// The file that was written, if one was.
    pub output: Option<String>,
    /// How many bytes the file has, as listed.
    pub size: Option<u64>,
    /// What an object store calls this content of the file.
    pub etag: Option<String>,
    /// When the file was changed last, as listed: RFC 3339, in UTC.
    pub mtime: Option<String>,
    /// The SHA-256 of what was read, in hexadecimal digits.
    pub input_sha256: Option<String>,
    /// The SHA-256 of what was written.
    pub output_sha256: Option<String>,
    /// What stands for the plan and the form of the output.
    pub plan_digest: String,
    /// The version of meshmend.
    pub version: String,
    /// The number of the form of rows and reports.
    pub schema: u32,
    /// How it ended.
    pub status: RowStatus,
    /// The signal that ended the process that worked on it.
    pub signal: Option<i32>,
    /// Why it was not mended.
    pub message: Option<String>,
    /// The line where the file can't be read, from 1.
    pub line: Option<u64>,
    /// The byte where the file can't be read, from 0.
    pub byte: Option<u64>,
    /// How many times it was tried.
    pub attempts: u32,
    /// How long the last attempt took.
    pub seconds: f64,
    /// How much of a processor's time it took, where the system tells.
    pub cpu_seconds: Option<f64>,
    /// The most memory that the process had while it worked on the file, where the system tells.
    pub peak_bytes: Option<u64>,
    /// The machine.
    pub host: String,
    /// The format and encoding of the file, such as `ply-le`, if it was read.
    pub format_in: Option<String>,
    /// Those of the output, if one was written.
    pub format_out: Option<String>,
    /// The mesh before, if it was read.
    pub before: Option<RowFigures>,
    /// The mesh after, if it was mended.
    pub after: Option<RowFigures>,
    /// How many defects and notes of each kind there were before, by code.
    pub defects: BTreeMap<String, u64>,
    /// Whether what is written differs from what was read, apart from the format.
    pub changed: bool,
    /// How many faces went.
    pub removed_faces: u64,
    /// How many faces run the other way round.
    pub flipped_faces: u64,
    /// How many vertices were created.
    pub created_vertices: u64,
    /// How many vertices were joined to others.
    pub welded_vertices: u64,
    /// What the output can't carry.
    pub losses: Vec<RowLoss>,
    /// The whole report as JSON, if that was asked for.
    pub report: Option<String>,
}

/// How the work on a file ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum RowStatus {
    /// It was mended, and nothing is left.
    Mended,
    /// There was nothing to do.
    Clean,
    /// Something is named as left, or something is there that the run was to be failed on.
    Left,
    /// It can't be read.
    Unreadable,
    /// The output can't be written.
    Unwritable,
    /// A policy says `fail`, the kernel can't hold a mesh, or no face would be left.
    Refused,
    /// It took too long.
    Timeout,
    /// It needed too much memory.
    Memory,
    /// The process that worked on it ended.
    Crashed,
    /// It is not there.
    #[default]
    Missing,
}

impl RowStatus {
    /// All of them, in the order in which they are told.
    pub const ALL: [RowStatus; 10] = [
        RowStatus::Mended,
        RowStatus::Clean,
        RowStatus::Left,
        RowStatus::Unreadable,
        RowStatus::Unwritable,
        RowStatus::Refused,
        RowStatus::Timeout,
        RowStatus::Memory,
        RowStatus::Crashed,
        RowStatus::Missing,
    ];

    /// Whether it is the same with every try: it hangs on the file and the policies, not on time, memory or a process.
    pub fn is_settled(self) -> bool {
        !matches!(self, RowStatus::Timeout | RowStatus::Memory | RowStatus::Crashed)
    }

    /// Its name in rows.
    pub fn name(self) -> &'static str {
        match self {
            RowStatus::Mended => "mended",
            RowStatus::Clean => "clean",
            RowStatus::Left => "left",
            RowStatus::Unreadable => "unreadable",
            RowStatus::Unwritable => "unwritable",
            RowStatus::Refused => "refused",
            RowStatus::Timeout => "timeout",
            RowStatus::Memory => "memory",
            RowStatus::Crashed => "crashed",
            RowStatus::Missing => "missing",
        }
    }

    /// Whether there is no result.
    pub fn is_failure(self) -> bool {
        !matches!(self, RowStatus::Mended | RowStatus::Clean | RowStatus::Left)
    }
}

/// What a mesh is, in figures: those of a check. Those of several parts are added, and what only one surface has is null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RowFigures {
    /// Vertices that faces or loose elements use.
    pub vertices: u64,
    /// Edges.
    pub edges: u64,
    /// Faces that are not degenerate.
    pub faces: u64,
    /// Connected components.
    pub components: u64,
    /// Edges with one side.
    pub boundary_edges: u64,
    /// Edges with three sides or more.
    pub non_manifold_edges: u64,
    /// Vertices with two umbrellas or more.
    pub pinched: u64,
    /// Vertices at an edge with three sides or more.
    pub singular: u64,
    /// Edges whose two faces disagree on the direction.
    pub inconsistent_edges: u64,
    /// Degenerate faces.
    pub degenerate_faces: u64,
    /// The Euler characteristic.
    pub euler: i64,
    /// Boundary loops, where the boundary is one of curves.
    pub boundary_loops: Option<u64>,
    /// The genus, where the mesh is one orientable surface.
    pub genus: Option<u64>,
    /// The cross-caps, where it is one surface that is not orientable.
    pub cross_caps: Option<u64>,
    /// Whether every edge and vertex is that of a surface.
    pub manifold: bool,
    /// Whether there is no boundary.
    pub closed: bool,
    /// Whether it can be oriented.
    pub orientable: bool,
    /// Whether it is oriented.
    pub consistently_oriented: bool,
}

/// A kind of loss, and how many elements it concerns.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RowLoss {
    /// The kind, such as `layer`.
    pub kind: String,
    /// How many elements it concerns.
    pub count: u64,
}

impl Row {
    /// The row of a file on which nothing was done yet.
    pub fn of(path: impl Into<String>) -> Self {
        let version = env!("CARGO_PKG_VERSION").to_owned();
        Row { path: path.into(), version, schema: SCHEMA, attempts: 1, ..Row::default() }
    }

    /// This row, of a file that was not mended for this reason.
    #[must_use]
    pub fn failed(self, status: RowStatus, reason: &str) -> Self {
        let end = reason.floor_char_boundary(LONGEST_ROW_MESSAGE);
        Row { status, message: Some(reason[..end].to_owned()), ..self }
    }

    /// This row without the columns that may differ from run to run: how often it was tried, how long it took, on which
    /// machine, and in how much memory.
    #[must_use]
    pub fn without_run_columns(self) -> Self {
        let (cpu_seconds, peak_bytes) = (None, None);
        Row { attempts: 0, seconds: 0.0, cpu_seconds, peak_bytes, host: String::new(), ..self }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use schemars::generate::SchemaSettings;

    use super::*;

    #[test]
    fn the_schema_is_that_of_the_rows() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas/row.json");
        let settings = SchemaSettings::draft2020_12().for_serialize();
        let schema = settings.into_generator().into_root_schema_for::<Row>();
        let shown = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        if std::env::var_os("MESHMEND_WRITE").is_some() {
            std::fs::write(&path, &shown).unwrap();
        }
        let written = std::fs::read_to_string(&path).unwrap();
        assert_eq!(written, shown, "write it anew: MESHMEND_WRITE=1 cargo test -p meshmend --lib schema");
    }

    #[test]
    fn every_status_has_the_name_that_rows_have() {
        for status in RowStatus::ALL {
            assert_eq!(serde_json::to_value(status).unwrap(), status.name());
        }
    }

    #[test]
    fn a_message_is_cut_between_letters() {
        let row = Row::of("a").failed(RowStatus::Refused, &"é".repeat(LONGEST_ROW_MESSAGE));
        assert_eq!(row.message.unwrap(), "é".repeat(LONGEST_ROW_MESSAGE / 2));
        let row = Row::of("a").failed(RowStatus::Refused, &("x".to_owned() + &"é".repeat(300)));
        assert_eq!(row.message.unwrap().len(), 499);
    }
}
