//! What the kernel says of its size, held against what the allocator gave.

meshmend_conformance::kernel_size!(directed_edges::DirectedEdges);
