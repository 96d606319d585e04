//! One question to many things at once.

use rayon::prelude::*;

/// Checks every item, and fails with all that any of the checks says.
///
/// # Panics
/// When a check says anything.
pub fn assert_each<T: Sync>(items: &[T], check: impl Fn(&T) -> Vec<String> + Sync + Send) {
    let wrong: Vec<String> = items.par_iter().flat_map_iter(check).collect();
    assert!(wrong.is_empty(), "{} things are wrong:\n{}", wrong.len(), wrong.join("\n"));
    println!("{} checked", items.len());
}
