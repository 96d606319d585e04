//! The folder of references and test files beside the workspace.

use std::path::{Path, PathBuf};

/// A path in the shared folder; nothing, and a message, where it does not exist.
pub fn shared(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared").join(name);
    match path.canonicalize() {
        Ok(path) => Some(path),
        Err(_) => {
            println!("skipped: there is no {}", path.display());
            None
        }
    }
}
