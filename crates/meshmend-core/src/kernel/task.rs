//! Questions that can be asked of whichever kernel holds a complex.

use crate::Connectivity;

/// A question to ask of a complex, whichever kernel holds it.
///
/// It is a trait rather than a closure because the answer is compiled for each kernel: a query costs what the
/// kernel's own code costs, and nothing for having been chosen at run time.
pub trait KernelTask {
    /// The answer.
    type Output;
    /// Asks a kernel.
    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output;
}
