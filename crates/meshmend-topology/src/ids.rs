//! Numbers of the parts that a mesh falls into.

use std::fmt;

use meshmend_core::Id;
use serde::Serialize;

macro_rules! part_id {
    ($(#[$doc:meta])* $name:ident, $word:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize)]
        #[serde(transparent)]
        #[repr(transparent)]
        pub struct $name(pub u32);

        impl Id for $name {
            #[inline]
            fn new(index: usize) -> Self {
                $name(index as u32)
            }
            #[inline]
            fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($word, " {}"), self.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }
    };
}

part_id!(
    /// A connected component, by its place in the order of lowest vertices. Shown as `component 2`.
    ComponentId,
    "component"
);
part_id!(
    /// A patch, by its place in the order of lowest faces. Shown as `patch 0`.
    PatchId,
    "patch"
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_shown_with_their_word() {
        assert_eq!(ComponentId::new(2).to_string(), "component 2");
        assert_eq!(format!("{:?}", PatchId::new(0)), "patch 0");
    }
}
