//! The program `meshmend`.

use std::process::ExitCode;

use meshmend_cli::{Console, run};

#[cfg(feature = "mimalloc")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    run(std::env::args_os(), &mut Console::standard()).into()
}
