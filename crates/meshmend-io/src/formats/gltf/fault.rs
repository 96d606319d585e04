//! What is wrong with a file, before the name of the file is known.

use std::fmt;

use crate::input::source::Source;
use crate::{Place, ReadError, ReadErrorKind};

/// A reason why a file can't be read, and its place.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) place: Place,
    pub(super) kind: ReadErrorKind,
}

impl Fault {
    pub(super) fn new(place: Place, reason: impl Into<String>) -> Self {
        Fault { place, kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// A fault if more was found than the limit allows.
    pub(super) fn if_more(what: &'static str, found: u64, limit: u64) -> Result<(), Fault> {
        let kind = ReadErrorKind::LimitExceeded { what, found, limit };
        if found <= limit { Ok(()) } else { Err(Fault { place: Place::File, kind }) }
    }

    /// The error of a file.
    pub(super) fn in_file(self, source: &Source<'_>) -> ReadError {
        ReadError { file: source.name.to_owned(), place: self.place, kind: self.kind }
    }
}

/// A place in the JSON of a file, such as `/accessors/3`.
#[derive(Clone, Debug)]
pub(super) struct Pointer {
    array: &'static str,
    index: Option<usize>,
    /// What stands below that, with a slash before each step.
    below: String,
}

impl Pointer {
    pub(super) const ROOT: Pointer = Pointer { array: "", index: None, below: String::new() };

    /// An item of an array of the root.
    pub(super) fn item(array: &'static str, index: usize) -> Self {
        Pointer { array, index: Some(index), below: String::new() }
    }

    /// Which item of an array of the root it is or lies in.
    pub(super) fn index(&self) -> Option<usize> {
        self.index
    }

    /// A member of what this points at.
    pub(super) fn member(&self, name: &str) -> Self {
        let escaped = name.replace('~', "~0").replace('/', "~1");
        Pointer { below: format!("{}/{escaped}", self.below), ..self.clone() }
    }

    /// An item of a member of what this points at.
    pub(super) fn item_of(&self, name: &str, index: usize) -> Self {
        self.member(name).member(&index.to_string())
    }

    pub(super) fn place(&self) -> Place {
        Place::Pointer(self.to_string())
    }

    /// What is wrong there.
    pub(super) fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::new(self.place(), reason)
    }
}

impl fmt::Display for Pointer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.array, self.index) {
            ("", _) if self.below.is_empty() => f.write_str("/")?,
            ("", _) => {}
            (array, index) => write!(f, "/{array}/{}", index.unwrap_or_default())?,
        }
        f.write_str(&self.below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pointer_is_shown_as_json_pointers_are() {
        let accessor = Pointer::item("accessors", 3);
        assert_eq!(Pointer::ROOT.to_string(), "/");
        assert_eq!(Pointer::ROOT.member("asset").to_string(), "/asset");
        assert_eq!(accessor.to_string(), "/accessors/3");
        assert_eq!(accessor.member("a/b~").to_string(), "/accessors/3/a~1b~0");
        let mesh = Pointer::item("meshes", 0);
        assert_eq!(
            mesh.item_of("primitives", 2).member("indices").to_string(),
            "/meshes/0/primitives/2/indices"
        );
    }
}
