//! The whole program, with directed edges among its kernels.

use std::process::ExitCode;

use directed_edges::DirectedEdges;
use meshmend::AnyKernel;

fn main() -> ExitCode {
    meshmend_cli::main_with(&[AnyKernel::of::<DirectedEdges>()])
}
