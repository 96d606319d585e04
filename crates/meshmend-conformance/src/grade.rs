//! All verdicts on a kernel as one document, for whoever grades it.

use std::process::ExitCode;

use crate::{Settings, Subject};

/// Prints all verdicts on a kernel as one JSON document. The status is 0 where all laws are kept, 1 where one is broken,
/// and 2 where they can't be asked.
#[doc(hidden)]
pub fn grade(subject: &Subject) -> ExitCode {
    match Settings::from_environment().and_then(|settings| subject.verdicts(&settings)) {
        Ok(verdicts) => {
            print!("{}", verdicts.document());
            ExitCode::from(u8::from(!verdicts.are_all_kept()))
        }
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::from(2)
        }
    }
}
