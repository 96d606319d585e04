//! The one line of a test file.

/// A module with a test for each law of a kernel, each named after its law.
///
/// ```
/// # use meshmend_core::EdgeUse as WingedEdge;
/// # fn main() {}
/// meshmend_conformance::kernel!(winged_edge: WingedEdge);
/// ```
///
/// With `at_least` the kernel must hold all that some capabilities admit: [`PERMISSIVE`](crate::PERMISSIVE),
/// [`SURFACES`](crate::SURFACES), [`ORIENTED_SURFACES`](crate::ORIENTED_SURFACES), [`TRIANGLES`](crate::TRIANGLES), or
/// others.
///
/// ```
/// # use meshmend_core::EdgeUse as WingedEdge;
/// # fn main() {}
/// meshmend_conformance::kernel!(winged_edge: WingedEdge, at_least = SURFACES);
/// ```
#[macro_export]
macro_rules! kernel {
    ($module:ident: $kernel:ty $(, at_least = $least:expr)? $(,)?) => {
        #[allow(unused_imports, reason = "the kernel may be named by its whole path")]
        mod $module {
            use super::*;

            $crate::__kernel_tests! {
                $kernel, [$($least)?]:
                refusal "refusal",
                assembly "assembly",
                counts "counts",
                numbering "numbering",
                next_and_prev "next-and-prev",
                face_stars "face-stars",
                edge_stars "edge-stars",
                vertex_stars "vertex-stars",
                rotation "rotation",
                across "across",
                derived "derived",
                arrays "arrays",
                pointers "pointers",
                report "report",
                growth "growth",
                capacity "capacity",
            }
        }
    };
}

/// The tests of [`kernel!`].
#[doc(hidden)]
#[macro_export]
macro_rules! __kernel_tests {
    ($kernel:ty, [$($least:expr)?]: $($test:ident $law:literal,)*) => {
        fn subject() -> &'static $crate::Subject {
            static SUBJECT: ::std::sync::OnceLock<$crate::Subject> = ::std::sync::OnceLock::new();
            SUBJECT.get_or_init(|| {
                use $crate::{NotManifold as _, ORIENTED_SURFACES, PERMISSIVE, SURFACES, TRIANGLES};
                let subject = $crate::Subject::with_opposite::<$kernel>($crate::Opposite::<$kernel>::new().asked())
                    .in_test(::std::concat!(::std::module_path!(), "::refusal"));
                $(let subject = subject.at_least::<$kernel>($least);)?
                subject
            })
        }

        $(#[test]
        #[cfg_attr(miri, ignore = "an interpreter takes hours over every small mesh, and begins no process")]
        fn $test() {
            subject().assert_kept($law);
        })*
    };
}

/// A test of what a kernel says of its size, which is held against what the allocator gave.
///
/// It needs a test file of its own, since it sets the global allocator. With names it takes several kernels.
///
/// ```
/// # use meshmend_core::EdgeUse as WingedEdge;
/// meshmend_conformance::kernel_size!(WingedEdge);
/// ```
#[macro_export]
macro_rules! kernel_size {
    ($kernel:ty $(,)?) => {
        $crate::kernel_size!(size: $kernel);
    };
    ($($test:ident: $kernel:ty),+ $(,)?) => {
        #[global_allocator]
        static ALLOCATOR: $crate::Cap<::std::alloc::System> = $crate::Cap::new(::std::alloc::System, usize::MAX);

        $(#[test]
        #[cfg_attr(miri, ignore = "what an interpreter allocates is not what the system does")]
        fn $test() {
            $crate::Subject::measured::<$kernel>(|| ALLOCATOR.allocated())
                .in_test(::std::concat!(::std::module_path!(), "::", ::std::stringify!($test)))
                .assert_kept("size");
        })+
    };
}

/// The `main` of a program that prints the verdicts on a kernel as one JSON document, and ends with 0 where all laws are
/// kept and 1 where one is broken.
///
/// ```no_run
/// # use meshmend_core::EdgeUse as WingedEdge;
/// meshmend_conformance::grade!(WingedEdge);
/// ```
#[macro_export]
macro_rules! grade {
    ($kernel:ty $(, at_least = $least:expr)? $(,)?) => {
        fn main() -> ::std::process::ExitCode {
            #[allow(unused_imports, reason = "which of them is asked for is said by whoever calls")]
            use $crate::{NotManifold as _, ORIENTED_SURFACES, PERMISSIVE, SURFACES, TRIANGLES};
            let subject = $crate::Subject::with_opposite::<$kernel>($crate::Opposite::<$kernel>::new().asked());
            $(let subject = subject.at_least::<$kernel>($least);)?
            $crate::grade(&subject)
        }
    };
}

#[cfg(test)]
mod tests {
    use crate::LAWS;

    #[test]
    fn the_macro_has_a_test_for_each_law_but_the_size() {
        let rows = include_str!("macros.rs").lines().map(str::trim);
        let tests: Vec<&str> = rows.filter(|row| row.ends_with("\",")).collect();
        let expected = LAWS.iter().filter(|law| law.id != "size");
        let row = |id: &str| format!("{} \"{id}\",", id.replace('-', "_"));
        assert_eq!(tests, expected.map(|law| row(law.id)).collect::<Vec<_>>());
    }
}
