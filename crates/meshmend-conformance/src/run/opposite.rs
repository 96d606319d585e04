//! What a kernel of at most two sides an edge says is opposite.

use std::marker::PhantomData;

use meshmend_core::{CornerId, ManifoldConnectivity};

#[doc(hidden)]
/// How a kernel is asked what is opposite; `None` for one that has no say in it.
pub type OppositeOf<K> = Option<fn(&K, CornerId) -> Option<CornerId>>;

/// A kernel that may have a say in it: a macro, which knows the type, finds out whether it has.
#[doc(hidden)]
#[derive(Debug, Default)]
pub struct Opposite<K>(PhantomData<K>);

impl<K> Opposite<K> {
    /// The kernel of a type.
    pub const fn new() -> Self {
        Opposite(PhantomData)
    }
}

impl<K: ManifoldConnectivity> Opposite<K> {
    /// How it is asked.
    pub fn asked(&self) -> OppositeOf<K> {
        Some(K::opposite)
    }
}

/// A kernel that has no say in it.
#[doc(hidden)]
pub trait NotManifold<K> {
    /// Not at all.
    fn asked(&self) -> OppositeOf<K>;
}

impl<K> NotManifold<K> for Opposite<K> {
    fn asked(&self) -> OppositeOf<K> {
        None
    }
}
