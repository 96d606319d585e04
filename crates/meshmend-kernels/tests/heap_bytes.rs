//! Every kernel tells its size truly: what it says it keeps on the heap is what the allocator gave it.

use std::alloc::System;
use std::sync::Arc;

use cap::Cap;
use meshmend_core::{Complex, Connectivity, FaceTable, FaceTableBuilder, FaceTableError, VertexId};
use meshmend_kernels::{KernelKind, KernelTask};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// What a kernel says of its size.
struct HeapBytes;

impl KernelTask for HeapBytes {
    type Output = usize;
    fn run<K: Connectivity>(self, kernel: &K) -> usize {
        kernel.heap_bytes()
    }
}

/// What the allocator says of it: all that is given back when the kernel goes, but for the face table.
struct Allocated<'a>(&'a Arc<FaceTable>);

impl KernelTask for Allocated<'_> {
    type Output = usize;
    fn run<K: Connectivity>(self, _: &K) -> usize {
        let before = ALLOCATOR.allocated();
        let kernel = K::assemble(&Complex::of(self.0));
        let after = ALLOCATOR.allocated();
        drop(kernel);
        after - before
    }
}

fn grid(size: u32, corners_a_face: usize) -> Result<Arc<FaceTable>, FaceTableError> {
    let mut faces = FaceTableBuilder::default();
    for cell in 0..size * size {
        let low = cell / size * (size + 1) + cell % size;
        let quad = [low, low + 1, low + size + 2, low + size + 1].map(VertexId);
        if corners_a_face == 4 {
            faces.push_face(quad);
        } else {
            faces.push_face([quad[0], quad[1], quad[2]]);
            faces.push_face([quad[0], quad[2], quad[3]]);
        }
    }
    let vertices = (size + 1) * (size + 1);
    faces.build(vertices as usize).map(Arc::new)
}

/// One test, because the allocator counts for the whole program.
#[test]
fn what_a_kernel_says_it_keeps_is_what_was_allocated() {
    for faces in [grid(100, 3).unwrap(), grid(70, 4).unwrap()] {
        for kind in KernelKind::ALL {
            let complex = Complex::of(&faces);
            let said = kind.run(&complex, HeapBytes).unwrap();
            let true_bytes = kind.run(&complex, Allocated(&faces)).unwrap();
            assert!(said.abs_diff(true_bytes) * 20 <= true_bytes, "{kind} says {said}, not {true_bytes}");
        }
    }
}
