//! Where a run keeps its files, and where verdicts are written.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// The folder of all that the kit writes: `meshmend-conformance` below the folder of what cargo builds, or below that of
/// temporary files where a program was put elsewhere.
pub(crate) fn output() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    let has_tag = |folder: &&Path| folder.join("CACHEDIR.TAG").is_file();
    let is_target = |folder: &&Path| folder.file_name().is_some_and(|name| name == "target");
    let built = program.ancestors().find(has_tag).or_else(|| program.ancestors().find(is_target));
    built.map_or_else(std::env::temp_dir, Path::to_path_buf).join("meshmend-conformance")
}

/// A path below [`output`] as it is shown: from the folder of what cargo builds on.
pub(crate) fn shown(path: &Path) -> String {
    let base = output();
    let above = base.parent().and_then(Path::parent).unwrap_or(&base);
    path.strip_prefix(above).unwrap_or(path).display().to_string()
}

/// A name in which no character is special to a file system.
pub(crate) fn file_name(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    name.chars().map(plain).collect()
}

/// A folder of a run, which goes when the run is over.
pub(super) struct Scratch(pub(super) PathBuf);

impl Scratch {
    pub(super) fn new(kernel: &str) -> io::Result<Self> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Relaxed);
        let name = format!("run-{}-{}-{number}", file_name(kernel), std::process::id());
        let folder = output().join(name);
        fs::create_dir_all(&folder)?;
        Ok(Scratch(folder))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What is left behind is below the folder of what cargo builds.
        let _ = fs::remove_dir_all(&self.0);
    }
}
