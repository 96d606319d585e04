//! The program `meshmend`.

use std::process::ExitCode;

use meshmend_cli::{Console, end_cleanly, run};

#[cfg(feature = "mimalloc")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    end_cleanly();
    run(std::env::args_os(), &mut Console::standard()).into()
}
