//! A kernel is assembled only where it can hold the mesh.

use crate::{Complex, Connectivity, Refusal, admission};

/// How every kernel is built: if it can't hold the mesh, it says so and is not assembled.
pub trait Build: Connectivity {
    /// Builds the index, or says everything that stands against it.
    ///
    /// # Errors
    /// The full list of defects outside the kernel's capabilities.
    fn build(complex: &Complex) -> Result<Self, Refusal> {
        let defects = admission(complex, &Self::CAPABILITIES);
        if defects.is_empty() {
            Ok(Self::assemble(complex))
        } else {
            Err(Refusal { kernel: Self::NAME, defects })
        }
    }
}

impl<K: Connectivity> Build for K {}
