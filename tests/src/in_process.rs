//! The program in the process of the test.

use meshmend_cli::{Console, Program, Status};

/// How a run of the program ended, and what it printed on standard output and on standard error.
///
/// # Panics
/// When what it printed is not UTF-8.
pub fn run(program: Program, arguments: &[&str]) -> (Status, String, String) {
    let (mut out, mut errors) = (Vec::new(), Vec::new());
    let mut console = Console::of(&mut out, &mut errors);
    let status = program.run([&["meshmend"], arguments].concat(), &mut console);
    drop(console);
    let text = |bytes| String::from_utf8(bytes).expect("what is printed is UTF-8");
    (status, text(out), text(errors))
}
