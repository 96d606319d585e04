//! A check within a bound of memory: whatever the bytes are, it says what a check in memory says, in any number of parts.

use std::fs;
use std::path::PathBuf;

use meshmend::formats::ReadErrorKind;
use meshmend::report::{CheckDocument, json};
use meshmend::{
    CheckOptions, Distance, ExternalError, ExternalOptions, Format, Kernels, ReadOptions, View, check,
    check_external, read,
};

/// A byte that chooses a format, a view and a number of parts, and the other bytes as a file.
pub fn external(data: &[u8]) {
    let [choice, bytes @ ..] = data else { return };
    let format = if choice & 1 == 0 { Format::Ply } else { Format::Stl };
    let is_welded = choice & 2 != 0;
    let file = File::of(bytes);
    let mut options = ExternalOptions::within(1 << 28);
    (options.is_welded, options.parts) = (Some(is_welded), Some(1 + usize::from(choice >> 2) % 7));
    options.read = ReadOptions::default().with_format(format);
    let found = match check_external(&file.0, &options, Kernels::builtin()) {
        Err(ExternalError::Read(error)) if matches!(error.kind, ReadErrorKind::NotInRows) => return,
        Err(ExternalError::Read(error)) => Err(error.to_string()),
        Err(error) => panic!("{error}"),
        Ok(report) => {
            Ok(json(&CheckDocument::of_external(&report, String::new(), options.limit)).expect("JSON"))
        }
    };
    let expected = read(&file.0, &options.read).map_err(|error| error.to_string()).map(|file| {
        let view = if is_welded { View::Welded(Distance::Exact) } else { View::Indexed };
        let report =
            check(&file.mesh, &CheckOptions::default().with_view(view)).expect("any mesh can be judged");
        json(&CheckDocument::new(report, options.limit).of_file(String::new(), &file)).expect("JSON")
    });
    assert_eq!(found, expected);
}

/// A file that is removed again.
struct File(PathBuf);

impl File {
    fn of(bytes: &[u8]) -> Self {
        let file = File(std::env::temp_dir().join(format!("meshmend-fuzz-external-{}", std::process::id())));
        fs::write(&file.0, bytes).expect("there is room for temporary files");
        file
    }
}

impl Drop for File {
    fn drop(&mut self) {
        fs::remove_file(&self.0).ok();
    }
}
