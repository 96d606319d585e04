//! Every law of kernels, each a test.

meshmend_conformance::kernel!(my_kernel: ::my_kernel::MyKernel, at_least = PERMISSIVE);
