//! Typed element numbers: a vertex can't be taken for a face.

use std::fmt;

/// What all four element numbers have in common: a dense index that fits 32 bits.
pub trait Id: Copy + Ord + fmt::Debug + fmt::Display {
    /// The id of the element at `index`.
    ///
    /// Element counts are below 2³¹ by construction of the tables, so an index that came from one always fits.
    fn new(index: usize) -> Self;
    /// The element's place in its table.
    fn index(self) -> usize;
}

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
        #[repr(transparent)]
        pub struct $name(pub u32);

        impl Id for $name {
            #[inline]
            fn new(index: usize) -> Self {
                debug_assert!(index <= u32::MAX as usize);
                $name(index as u32)
            }
            #[inline]
            fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }
    };
}

id!(
    /// A vertex, by its place in the mesh's list of positions. Shown as `v3`.
    VertexId,
    "v"
);
id!(
    /// An edge, by its place in the order of (smaller vertex, larger vertex). Shown as `e12`.
    EdgeId,
    "e"
);
id!(
    /// A face, by its place in the mesh's face table. Shown as `f0`.
    FaceId,
    "f"
);
id!(
    /// A corner of a face, and with it the side from this corner's vertex to the next one's. Shown as `c7`.
    CornerId,
    "c"
);
