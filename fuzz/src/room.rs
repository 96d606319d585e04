//! A folder with a few small files, in which command lines may do what they like.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// The names that a command line can name. Some are not there before it runs.
pub(crate) const NAMES: [&str; 19] = [
    "good.obj",
    "broken.obj",
    "moebius.off",
    "pinched.ply",
    "soup.stl",
    "malformed.ply",
    "plan.toml",
    "wrong.toml",
    "new.obj",
    "new.ply",
    "new.stl",
    "new.off",
    "new.json",
    "new.svg",
    "new.png",
    "mesh",
    "nowhere/new.obj",
    "new.mtx",
    "new.html",
];

const GOOD: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl wood\nf 1 2 3\nf 1 3 4\n";
/// The header promises a vertex more than there is.
const MALFORMED: &[u8] =
    b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float \
z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";

/// What is in a file before a command line runs, if it is there.
fn content(name: &str) -> Option<&'static [u8]> {
    Some(match name {
        "good.obj" => GOOD,
        "broken.obj" => include_bytes!("../../examples/broken.obj"),
        "moebius.off" => include_bytes!("../../examples/moebius.off"),
        "pinched.ply" => include_bytes!("../../examples/pinched.ply"),
        "soup.stl" => include_bytes!("../../examples/soup.stl"),
        "malformed.ply" => MALFORMED,
        "plan.toml" => include_bytes!("../../examples/plan.toml"),
        "wrong.toml" => b"passes = [\"weld\", \"mend\"]\n",
        _ => return None,
    })
}

/// The folder, which goes with the value.
pub(crate) struct Room(PathBuf);

impl Room {
    pub(crate) fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("meshmend-fuzz-{}-{number}", std::process::id()));
        fs::create_dir_all(&folder).expect("there is a folder for temporary files");
        let room = Room(folder);
        for (at, name) in NAMES.iter().enumerate() {
            if let Some(bytes) = content(name) {
                fs::write(room.path(at), bytes).expect("a temporary file can be written");
            }
        }
        room
    }

    /// The path of a file that has a name.
    pub(crate) fn path(&self, at: usize) -> PathBuf {
        self.0.join(NAMES[at])
    }

    /// Whether a path is that of a file that has a name.
    pub(crate) fn has(&self, path: &Path) -> bool {
        (0..NAMES.len()).any(|at| self.path(at) == path)
    }

    /// Whether a file is there with what was in it, or not there as before.
    pub(crate) fn is_unchanged(&self, at: usize) -> bool {
        fs::read(self.path(at)).ok().as_deref() == content(NAMES[at])
    }

    /// Panics if there is a file that has no name.
    pub(crate) fn assert_tidy(&self) {
        for entry in fs::read_dir(&self.0).expect("the folder is there") {
            let path = entry.expect("the folder can be listed").path();
            assert!(self.has(&path), "{} was left behind", path.display());
        }
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).ok();
    }
}
