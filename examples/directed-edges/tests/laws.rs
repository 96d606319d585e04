//! Every law of kernels, each a test.

meshmend_conformance::kernel!(directed_edges: ::directed_edges::DirectedEdges, at_least = TRIANGLES);
