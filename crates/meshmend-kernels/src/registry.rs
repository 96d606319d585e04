//! The list of all kernels, and the one place where a kernel is chosen by value.

use std::fmt;

use meshmend_core::{Build, Capabilities, Complex, Connectivity, Costs, Lesson, Refusal};

/// Something to make of a kernel's type, before there is a mesh.
pub trait KernelVisitor {
    /// What is made of it.
    type Output;
    /// Makes it of a kernel's type.
    fn visit<K: Lesson>(self) -> Self::Output;
}

macro_rules! kernels {
    ($($module:ident::$name:ident,)*) => {
        $(pub use crate::$module::$name;)*

        /// The kernels to choose from.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum KernelKind {
            /// [`EdgeUse`]: the fast default.
            #[default]
            EdgeUse,
            $(#[doc = concat!("[`", stringify!($name), "`](struct@", stringify!($name), ").")] $name,)*
        }

        impl KernelKind {
            /// Every kernel, the default one first.
            pub const ALL: &'static [Self] = &[KernelKind::EdgeUse, $(KernelKind::$name,)*];

            /// What it is called in commands and reports.
            pub fn name(self) -> &'static str {
                match self {
                    KernelKind::EdgeUse => EdgeUse::NAME,
                    $(KernelKind::$name => $name::NAME,)*
                }
            }

            /// What it holds and what it offers.
            pub fn capabilities(self) -> Capabilities {
                match self {
                    KernelKind::EdgeUse => EdgeUse::CAPABILITIES,
                    $(KernelKind::$name => $name::CAPABILITIES,)*
                }
            }

            /// Makes something of the kernel's type.
            pub fn visit<V: KernelVisitor>(self, visitor: V) -> V::Output {
                match self {
                    KernelKind::EdgeUse => visitor.visit::<EdgeUse>(),
                    $(KernelKind::$name => visitor.visit::<$name>(),)*
                }
            }

            /// Builds the kernel over a complex and asks it.
            ///
            /// # Errors
            /// When the kernel can't hold the complex: every reason why.
            ///
            /// *Cost*: building the kernel, near-linear, and the task's own.
            pub fn run<T: KernelTask>(self, complex: &Complex, task: T) -> Result<T::Output, Refusal> {
                match self {
                    KernelKind::EdgeUse => Ok(task.run(&EdgeUse::build(complex)?)),
                    $(KernelKind::$name => Ok(task.run(&$name::build(complex)?)),)*
                }
            }
        }
    };
}

/// The default kernel, which lives in the core because refusals are computed on it.
pub use meshmend_core::EdgeUse;
/// What is asked of a kernel that is chosen by value.
pub use meshmend_core::KernelTask;

/// Calls a macro with the row of each kernel but the default one.
#[doc(hidden)]
#[macro_export]
macro_rules! every_kernel {
    ($with:ident) => {
        $with! {
            face_vertex::FaceVertex,
            adjacency_lists::AdjacencyLists,
            half_edge::HalfEdge,
            quad_edge::QuadEdge,
            winged_edge::WingedEdge,
            corner_table::CornerTable,
            simple_record::SimpleRecord,
            generalised_map::GeneralisedMap,
            rotation_system::RotationSystem,
        }
    };
}

every_kernel!(kernels);

impl KernelKind {
    /// As [`run`](Self::run), for a task that looks at the corners of all vertices
    /// ([`Connectivity::ask_of_all_vertices`]).
    ///
    /// # Errors
    /// When the kernel can't hold the complex: every reason why.
    pub fn run_on_all_vertices<T: KernelTask>(
        self,
        complex: &Complex,
        task: T,
    ) -> Result<T::Output, Refusal> {
        struct OfAll<T>(T);
        impl<T: KernelTask> KernelTask for OfAll<T> {
            type Output = T::Output;
            fn run<K: Connectivity>(self, kernel: &K) -> T::Output {
                kernel.ask_of_all_vertices(self.0)
            }
        }
        self.run(complex, OfAll(task))
    }

    /// The text that teaches it, as [`Lesson::TEXT`] says.
    pub fn lesson(self) -> &'static str {
        struct Text;
        impl KernelVisitor for Text {
            type Output = &'static str;
            fn visit<K: Lesson>(self) -> Self::Output {
                K::TEXT
            }
        }
        self.visit(Text)
    }

    /// What its answers cost.
    pub fn costs(self) -> Costs {
        struct Declared;
        impl KernelVisitor for Declared {
            type Output = Costs;
            fn visit<K: Lesson>(self) -> Costs {
                K::COSTS
            }
        }
        self.visit(Declared)
    }

    /// The kernel with a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }
}

impl fmt::Display for KernelKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;

    /// What the source folder holds beside one file for each kernel.
    const NO_KERNELS: [&str; 3] = ["lib", "registry", "triangles"];

    #[test]
    #[cfg_attr(miri, ignore = "it reads the folder of the sources")]
    fn every_kernel_file_is_registered() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let stem = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned()
        };
        let mut files: BTreeSet<String> = std::fs::read_dir(folder).unwrap().map(stem).collect();
        for other in NO_KERNELS {
            assert!(files.remove(other), "{other} is gone");
        }
        let kinds = KernelKind::ALL.iter().filter(|&&kind| kind != KernelKind::EdgeUse);
        let registered: BTreeSet<String> = kinds.map(|kind| kind.name().replace('-', "_")).collect();
        assert_eq!(files, registered);
    }

    #[test]
    fn names_are_unique_and_lead_back() {
        for &kind in KernelKind::ALL {
            assert_eq!(KernelKind::from_name(kind.name()), Some(kind));
            assert_eq!(kind.to_string(), kind.name());
        }
        assert_eq!(KernelKind::from_name("no-such-kernel"), None);
    }

    #[test]
    fn the_default_holds_anything_and_comes_first() {
        assert!(KernelKind::default().capabilities().is_permissive());
        assert_eq!(KernelKind::ALL.first(), Some(&KernelKind::default()));
    }

    #[test]
    fn explanations_name_their_source() {
        for kind in KernelKind::ALL {
            let explanation = kind.lesson();
            assert!(explanation.contains("Source: ") || explanation.contains("*Source*: "), "{kind}");
        }
    }
}
