//! Which entry of a package is its model: the relations that an entry names.

use crate::formats::threemf::package::Fault;
use crate::formats::threemf::xml::{Scanner, Text};

/// What the relation to a model is called.
const MODEL: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// Where the relations of the package itself stand.
pub(super) const OF_PACKAGE: &str = "_rels/.rels";

/// The entries that a text of relations names as models.
///
/// # Errors
/// If it is no text of relations.
pub(super) fn models(text: &Text, entry: &str) -> Result<Vec<String>, Fault> {
    let mut scanner = Scanner::of(&text.text, entry);
    let (root, mut targets) = (scanner.root()?, Vec::new());
    if root.local != "Relationships" {
        return Err(scanner.wrong("the text holds no relations"));
    }
    while let Some(tag) = scanner.child(&root)? {
        if tag.local == "Relationship" && scanner.value(&tag, "Type")?.as_deref() == Some(MODEL) {
            targets.extend(scanner.value(&tag, "Target")?);
        }
        scanner.skip(&tag)?;
    }
    scanner.finish()?;
    Ok(targets)
}

/// The name of the entry that a target stands for, seen from the top of the package: without `/` at its start, `.` and
/// `..`. `None` if it leads out of the package.
pub(super) fn entry_name(target: &str) -> Option<String> {
    let mut folders: Vec<&str> = Vec::new();
    for folder in target.split('/') {
        match folder {
            "" | "." => {}
            ".." => {
                folders.pop()?;
            }
            name => folders.push(name),
        }
    }
    Some(folders.join("/"))
}
