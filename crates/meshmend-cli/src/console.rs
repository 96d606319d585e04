//! The two streams to the outside. Reports go to standard output, errors and progress to standard error.

use std::io::{self, IsTerminal, Write};

use crate::failure::Failure;
use crate::render::{Style, printable};

/// Standard output, in which a reader that has gone away is no error.
pub(crate) struct Console {
    out: io::BufWriter<io::StdoutLock<'static>>,
    is_closed: bool,
}

impl Console {
    pub(crate) fn open() -> Self {
        Console { out: io::BufWriter::new(io::stdout().lock()), is_closed: false }
    }

    /// How text is marked up: with colours on a terminal, unless the environment says `NO_COLOR`.
    pub(crate) fn style() -> Style {
        let is_unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let is_dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        if io::stdout().is_terminal() && !is_unwanted && !is_dumb { Style::Coloured } else { Style::Plain }
    }

    /// Whether nobody reads any more.
    pub(crate) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Writes a text and passes it on.
    pub(crate) fn write(&mut self, text: &str) -> Result<(), Failure> {
        if self.is_closed {
            return Ok(());
        }
        match self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush()) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(())
            }
            Err(error) => Err(Failure::unwritable("standard output", error)),
            Ok(()) => Ok(()),
        }
    }
}

/// Tells why something was not done. There is nowhere to tell if that fails.
pub(crate) fn complain(failure: &Failure) {
    let lines: Vec<String> = failure.message.trim_end().lines().map(printable).collect();
    let text = format!("meshmend: {}\n", lines.join("\n"));
    io::stderr().lock().write_all(text.as_bytes()).ok();
}
