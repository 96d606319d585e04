//! The whole program, with one more kernel.

use std::process::ExitCode;

use meshmend::AnyKernel;
use my_kernel::MyKernel;

fn main() -> ExitCode {
    meshmend_cli::main_with(&[AnyKernel::of::<MyKernel>()])
}
