//! Which kernels there are: meshmend's own, and those of whoever uses it.

use std::fmt;

use meshmend_kernels::KernelKind;

use super::AnyKernel;

/// The kernels that a program knows.
///
/// ```
/// use meshmend::Kernels;
///
/// let kernels = Kernels::builtin();
/// assert_eq!(kernels.all().next().map(|kernel| kernel.name), Some("edge-use"));
/// assert!(kernels.named("half-edge").is_some() && kernels.named("no-such-kernel").is_none());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kernels {
    own: &'static [AnyKernel],
}

/// Two kernels have the same name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KernelNameError {
    /// The name.
    pub name: &'static str,
}

impl Kernels {
    /// The kernels that meshmend has.
    pub fn builtin() -> Self {
        Kernels::default()
    }

    /// The kernels that meshmend has, and others.
    ///
    /// # Errors
    /// When two kernels have the same name.
    ///
    /// *Cost*: quadratic in the number of other kernels.
    pub fn with(own: &'static [AnyKernel]) -> Result<Self, KernelNameError> {
        for (place, kernel) in own.iter().enumerate() {
            if own[..place].contains(kernel) || KernelKind::from_name(kernel.name).is_some() {
                return Err(KernelNameError { name: kernel.name });
            }
        }
        Ok(Kernels { own })
    }

    /// All kernels, the default one first.
    pub fn all(self) -> impl Iterator<Item = AnyKernel> {
        KernelKind::ALL.iter().map(|&kind| AnyKernel::from(kind)).chain(self.own.iter().copied())
    }

    /// The kernel with a name.
    pub fn named(self, name: &str) -> Option<AnyKernel> {
        self.all().find(|kernel| kernel.name == name)
    }
}

impl fmt::Display for KernelNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "two kernels have the name `{}`", self.name)
    }
}

impl std::error::Error for KernelNameError {}

#[cfg(test)]
mod tests {
    use meshmend_core::EdgeUse;
    use meshmend_kernels::HalfEdge;

    use super::*;

    #[test]
    fn every_kernel_of_the_registry_is_a_value_with_its_own_facts() {
        let kernels: Vec<AnyKernel> = Kernels::builtin().all().collect();
        assert_eq!(kernels.len(), KernelKind::ALL.len());
        for (kernel, kind) in kernels.iter().zip(KernelKind::ALL) {
            assert_eq!((kernel.name, kernel.capabilities), (kind.name(), kind.capabilities()));
            assert_eq!(Kernels::builtin().named(kind.name()), Some(*kernel));
        }
        assert_eq!(AnyKernel::default(), AnyKernel::of::<EdgeUse>());
    }

    #[test]
    fn a_name_is_taken_once() {
        static TAKEN: [AnyKernel; 1] = [AnyKernel::of::<HalfEdge>()];
        assert_eq!(Kernels::with(&TAKEN), Err(KernelNameError { name: "half-edge" }));
        assert!(Kernels::with(&[]).is_ok());
    }
}
