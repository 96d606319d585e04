//! The commands that the texts of the kernels say to try: each of them works, one after the other.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test stops where it fails")]

mod common;

use common::{Folder, program};
use meshmend::KernelKind;

#[test]
fn what_a_text_says_to_try_works() {
    for kind in KernelKind::ALL {
        let folder = Folder::new();
        let lines = kind.lesson().lines().filter_map(|line| line.strip_prefix("$ "));
        for command in lines.flat_map(|line| line.split(" && ")) {
            let words = command.strip_prefix("meshmend ").unwrap().split(' ');
            let run = program().args(words).current_dir(folder.at("")).output().unwrap();
            let complaint = String::from_utf8(run.stderr).unwrap();
            // A check ends with 1 where the text shows a mesh that has defects.
            let has_shown = command.contains(" check ") && run.status.code() == Some(1);
            assert!(run.status.success() || has_shown, "{kind}: {command}: {complaint}");
        }
    }
}
