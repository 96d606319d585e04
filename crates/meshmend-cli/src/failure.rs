//! Why a command ends without having done its work, and with which exit status.

use std::fmt;
use std::process::ExitCode;

use meshmend::files::{FileError, NoSuchPart};
use meshmend::formats::{Place, ReadErrorKind, WriteErrorKind};
use meshmend::{ExternalError, PassError, ReadError, WriteError};

/// How a command ended. Of several pieces of work the worst counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The work is done.
    Done = 0,
    /// A check found defects, or a file is what `--fail-on` names.
    Failing = 1,
    /// The command line, a plan or a format is wrong.
    Usage = 2,
    /// An input can't be read.
    Unreadable = 3,
    /// An output can't be written.
    Unwritable = 4,
    /// A policy says `fail`, the kernel can't hold the mesh, or no face would be left of it.
    Refused = 5,
}

impl Status {
    /// The status of two pieces of work together.
    pub(crate) fn and(self, other: Status) -> Status {
        if other.rank() > self.rank() { other } else { self }
    }

    fn rank(self) -> u8 {
        match self {
            Status::Done => 0,
            Status::Failing => 1,
            Status::Refused => 2,
            Status::Unreadable => 3,
            Status::Unwritable => 4,
            Status::Usage => 5,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> ExitCode {
        ExitCode::from(status as u8)
    }
}

/// Why a command ends without having done its work.
#[derive(Debug)]
pub(crate) struct Failure {
    /// The exit status.
    pub(crate) status: Status,
    /// The message, without the program's name.
    pub(crate) message: String,
}

impl Failure {
    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Failure { status: Status::Usage, message: message.into() }
    }

    pub(crate) fn unwritable(what: &str, error: impl fmt::Display) -> Self {
        Failure { status: Status::Unwritable, message: format!("{what}: {error}") }
    }

    /// Why a pass gave no mesh, for the mesh of a file.
    pub(crate) fn of_pass(file: &str, error: &PassError) -> Self {
        Failure::of_mesh(file, error, "; --allow-empty goes on all the same")
    }

    /// The same, for a part of a file that can't hold a part without faces.
    fn of_part(file: &str, error: &PassError) -> Self {
        Failure::of_mesh(file, error, "; --allow-empty has no effect on a file of parts")
    }

    fn of_mesh(file: &str, error: &PassError, if_emptied: &str) -> Self {
        let status = match error {
            PassError::Request { .. } => Status::Usage,
            _ => Status::Refused,
        };
        let hint = match error {
            PassError::Emptied(_) => if_emptied,
            _ => "",
        };
        Failure { status, message: format!("{file}: {error}{hint}") }
    }
}

impl Failure {
    /// Why a mesh was not checked within a bound of memory.
    pub(crate) fn of_external(file: &str, error: ExternalError) -> Self {
        match error {
            ExternalError::Read(error) => {
                let hint =
                    if matches!(error.kind, ReadErrorKind::NotInRows) { ": leave out --memory" } else { "" };
                let failure = Failure::from(error);
                Failure { message: failure.message + hint, ..failure }
            }
            ExternalError::Spill { .. } => Failure::unwritable("what does not fit the memory", error),
            error => Failure { status: Status::Unreadable, message: format!("{file}: {error}") },
        }
    }
}

impl From<ReadError> for Failure {
    /// Shown as editors like it: `file:line: reason`.
    fn from(error: ReadError) -> Self {
        let ReadError { file, place, kind } = error;
        let message = match place {
            Place::File => format!("{file}: {kind}"),
            Place::Line(line) => format!("{file}:{line}: {kind}"),
            place => format!("{file}: {place}: {kind}"),
        };
        Failure { status: Status::Unreadable, message }
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        match error {
            FileError::Placed { .. } => Failure { status: Status::Unreadable, message: error.to_string() },
            FileError::HasParts { file } => {
                Failure::usage(format!("{file}: the file has parts of its own; --by takes one mesh apart"))
            }
            FileError::Pass { file, error } => Failure::of_pass(&file, &error),
            FileError::NoPartLeft { file, error } => Failure::of_part(&file, &error),
            FileError::Write(error) => error.into(),
            // What was asked for is not there.
            error => Failure::usage(error.to_string()),
        }
    }
}

impl From<NoSuchPart> for Failure {
    fn from(error: NoSuchPart) -> Self {
        FileError::from(error).into()
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        let status = match error.kind {
            WriteErrorKind::UnknownFormat | WriteErrorKind::NoSuchEncoding { .. } => Status::Usage,
            WriteErrorKind::Seams { .. } => Status::Refused,
            _ => Status::Unwritable,
        };
        let hint = match error.kind {
            WriteErrorKind::Occupied { .. } => "; --companions skip leaves it out",
            _ => "",
        };
        Failure { status, message: format!("{error}{hint}") }
    }
}

#[cfg(test)]
mod tests {
    use meshmend::mesh::Cancelled;

    use super::*;

    #[test]
    fn of_two_pieces_of_work_the_worse_counts() {
        use Status::{Done, Failing, Refused, Unreadable, Unwritable, Usage};
        let worse_and_worse = [Done, Failing, Refused, Unreadable, Unwritable, Usage];
        for (rank, &worse) in worse_and_worse.iter().enumerate() {
            for &better in &worse_and_worse[..=rank] {
                assert_eq!((better.and(worse), worse.and(better)), (worse, worse));
            }
        }
    }

    #[test]
    fn a_wish_that_cant_be_met_is_a_mistake_of_the_command_line() {
        let failure = |kind| Failure::from(WriteError { file: "a.obj".into(), kind });
        let unknown = failure(WriteErrorKind::UnknownFormat);
        assert_eq!(unknown.status, Status::Usage);
        assert!(unknown.message.starts_with("a.obj: the format is not known"), "{}", unknown.message);
        let full = failure(WriteErrorKind::Io(std::io::ErrorKind::StorageFull.into()));
        assert_eq!((full.status, full.message.as_str()), (Status::Unwritable, "a.obj: no storage space"));
        let request = PassError::Request { pass: "weld", reason: "no distance".into() };
        let request = Failure::of_pass("a.obj", &request);
        assert_eq!((request.status, request.message.as_str()), (Status::Usage, "a.obj: weld: no distance"));
        assert_eq!(Failure::of_pass("a.obj", &PassError::Cancelled(Cancelled)).status, Status::Refused);
    }

    #[test]
    fn errors_in_text_files_are_shown_as_file_and_line() {
        let error = meshmend::read_bytes(b"v 0 0 x\n", "a.obj", &Default::default()).unwrap_err();
        let failure = Failure::from(error);
        assert!(failure.message.starts_with("a.obj:1: "), "{}", failure.message);
        assert_eq!(failure.status, Status::Unreadable);
    }
}
