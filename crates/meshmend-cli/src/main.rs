//! The program `meshmend`.

use std::process::ExitCode;

use meshmend_cli::{Console, run};

fn main() -> ExitCode {
    run(std::env::args_os(), &mut Console::standard()).into()
}
