//! The lines of the protocol between a worker and whoever started it.

use meshmend::report::Row;
use serde::{Deserialize, Serialize};

/// What a worker is asked to do: one line of JSON.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Job {
    /// What the answer is found by.
    pub(crate) id: u64,
    /// What the row and the report call the file.
    pub(crate) name: String,
    /// Where the file is.
    pub(crate) input: JobInput,
    /// Where the result goes; without it, it is only judged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) output: Option<JobOutput>,
    /// The format of the output; by default that of its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) format: Option<String>,
}

/// Where a file is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum JobInput {
    /// At a path.
    Path(String),
    /// Behind the line: so many bytes.
    Bytes(u64),
}

/// Where a result goes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum JobOutput {
    /// To a path.
    Path(String),
    /// Behind the line of the answer, if this is true.
    Bytes(bool),
}

/// What a worker answers: one line of JSON.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Answer {
    /// The number of the job.
    pub(crate) id: u64,
    /// What became of the file.
    pub(crate) row: Row,
    /// How many bytes of the result follow, if they were asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) bytes: Option<u64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jobs_are_read_as_they_are_written_down() {
        let read = |line: &str| serde_json::from_str::<Job>(line);
        let line = r#"{"id":7,"name":"a/b.obj","input":{"path":"/x/b.obj"},"output":{"path":"/y/b.obj"},"format":"ply"}"#;
        let job = read(line).unwrap();
        assert_eq!(job.input, JobInput::Path("/x/b.obj".to_owned()));
        assert_eq!(serde_json::to_string(&job).unwrap(), line);
        let piped = read(r#"{"id":8,"name":"b","input":{"bytes":3},"output":{"bytes":true},"format":"ply"}"#)
            .unwrap();
        assert_eq!((piped.input, piped.output), (JobInput::Bytes(3), Some(JobOutput::Bytes(true))));
        for broken in [r#"{"id":7}"#, r#"{"id":7,"name":"a","input":{"path":"b"},"more":1}"#, "[]", ""] {
            assert!(read(broken).is_err(), "{broken}");
        }
    }
}
