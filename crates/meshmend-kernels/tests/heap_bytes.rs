//! Every kernel tells its size truly: what it says it keeps on the heap is what the allocator gave it.

use meshmend_kernels::*;

macro_rules! sized_by {
    ($($module:ident::$kernel:ident,)*) => {
        meshmend_conformance::kernel_size!(edge_use: EdgeUse, $($module: $kernel,)*);
    };
}

meshmend_kernels::every_kernel!(sized_by);
