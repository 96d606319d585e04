//! Every kernel tells its size truly: what it says it keeps on the heap is what the allocator gave it.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use std::alloc::System;
use std::collections::BTreeSet;

use cap::Cap;
use meshmend_core::{Complex, Connectivity};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::damage::Damage;
use meshmend_testkit::shapes::{self, Closed, Tiles};
use meshmend_testkit::{Soup, laws};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Whether what a kernel says of its size is what it gives back when it goes, nothing else holding what it shares with
/// the complex but the face table.
struct HeapLaw<'a>(&'a Soup);

impl KernelTask for HeapLaw<'_> {
    type Output = Result<(), String>;
    fn run<K: Connectivity>(self, _: &K) -> Self::Output {
        let complex = self.0.complex();
        let _faces = complex.shared_faces();
        let kernel = K::assemble(&complex);
        drop(complex);
        let with = ALLOCATOR.allocated();
        let said = kernel.heap_bytes();
        drop(kernel);
        laws::heap_law::<K>(said, with - ALLOCATOR.allocated())
    }
}

/// Meshes of a few thousand faces each, of triangles and others, tidy and not.
fn meshes() -> Vec<(&'static str, Soup)> {
    let torus = |tiles| shapes::torus(70, 60, tiles).soup;
    let degenerate = |soup: &mut Soup| soup.faces.extend((0..900).map(|v| vec![v, v, v + 1]));
    let mut with_degenerate = torus(Tiles::Quads);
    degenerate(&mut with_degenerate);
    vec![
        ("triangles", torus(Tiles::Triangles)),
        ("quads", torus(Tiles::Quads)),
        ("quads and degenerate faces", with_degenerate),
        ("a Klein bottle", shapes::klein_bottle(70, 60, Tiles::Triangles).soup),
        ("an open strip", shapes::strip(5000).soup),
        ("a fan", shapes::fan(5000).soup),
        ("one face", shapes::polygon(5000).soup),
        ("a book", shapes::book(5000).soup),
        ("foam", shapes::foam(12, 12, 12).soup),
        ("faces that share nothing", Damage::WeldApart.apply(&torus(Tiles::Triangles))),
        ("vertices in no face", Damage::Noise { count: 5000 }.apply(&torus(Tiles::Triangles))),
        ("handles", shapes::surface(Closed::Handles(20), 5, 2).soup),
    ]
}

/// One test, because the allocator counts for the whole program.
#[test]
#[cfg_attr(miri, ignore = "what the system's allocator gives is not what Miri's gives")]
fn what_a_kernel_says_it_keeps_is_what_was_allocated() {
    let mut asked = BTreeSet::new();
    for (name, soup) in meshes() {
        for &kind in KernelKind::ALL {
            match kind.run(&Complex::of(&soup.table().into()), HeapLaw(&soup)) {
                Ok(kept) => {
                    assert_eq!(kept, Ok(()), "{name}");
                    asked.insert((kind, name));
                }
                Err(_) => assert!(!kind.capabilities().is_permissive(), "{kind} refuses {name}"),
            }
        }
    }
    for kind in KernelKind::ALL {
        let count = asked.iter().filter(|(asked, _)| asked == kind).count();
        assert!(count >= 3, "{kind} was asked {count} times");
    }
}
