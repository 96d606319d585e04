//! The two streams to the outside. Reports go to standard output, errors and progress to standard error.

use std::io::{self, IsTerminal, Write};

use clap::builder::StyledStr;

use crate::failure::Failure;
use crate::progress::Progress;
use crate::render::{Style, printable};

/// Where a command writes: a stream for reports, in which a reader that has gone away is no error, and one for what
/// went wrong.
pub struct Console<'a> {
    out: Stream<'a>,
    errors: Stream<'a>,
    is_closed: bool,
}

/// A stream, and whether somebody watches it on a terminal.
struct Stream<'a> {
    sink: Box<dyn Write + Send + 'a>,
    is_terminal: bool,
    style: Style,
}

impl Console<'static> {
    /// The streams of the process, with colours on a terminal, unless the environment says `NO_COLOR`.
    pub fn standard() -> Self {
        let (out, errors) = (io::stdout(), io::stderr());
        Console { out: Stream::of_process(out), errors: Stream::of_process(errors), is_closed: false }
    }
}

impl<'a> Console<'a> {
    /// Any two streams, to which plain text is written.
    pub fn of(out: &'a mut (dyn Write + Send), errors: &'a mut (dyn Write + Send)) -> Self {
        Console { out: Stream::plain(out), errors: Stream::plain(errors), is_closed: false }
    }

    /// How reports are marked up.
    pub(crate) fn style(&self) -> Style {
        self.out.style
    }

    /// Whether nobody reads any more.
    pub(crate) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The progress of work in so many steps.
    pub(crate) fn progress(&self, steps: usize) -> Progress {
        if self.errors.is_terminal { Progress::shown(steps) } else { Progress::hidden(steps) }
    }

    /// Writes a text and passes it on.
    pub(crate) fn write(&mut self, text: &str) -> Result<(), Failure> {
        if self.is_closed {
            return Ok(());
        }
        match self.out.write(text) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(())
            }
            Err(error) => Err(Failure::unwritable("standard output", error)),
            Ok(()) => Ok(()),
        }
    }

    /// Writes a text that has its own style.
    pub(crate) fn write_styled(&mut self, text: &StyledStr) -> Result<(), Failure> {
        self.write(&self.out.spelt(text))
    }

    /// Writes a text about a mistake that has its own style. There is nowhere to tell if that fails.
    pub(crate) fn write_error(&mut self, text: &StyledStr) {
        self.errors.write(&self.errors.spelt(text)).ok();
    }

    /// Tells why something was not done. There is nowhere to tell if that fails.
    pub(crate) fn complain(&mut self, failure: &Failure) {
        let lines: Vec<String> = failure.message.trim_end().lines().map(printable).collect();
        self.errors.write(&format!("meshmend: {}\n", lines.join("\n"))).ok();
    }
}

impl<'a> Stream<'a> {
    fn plain(sink: &'a mut (dyn Write + Send)) -> Self {
        Stream { sink: Box::new(sink), is_terminal: false, style: Style::Plain }
    }

    fn of_process(stream: impl Write + IsTerminal + Send + 'a) -> Self {
        let is_unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let is_dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        let is_terminal = stream.is_terminal();
        let style = if is_terminal && !is_unwanted && !is_dumb { Style::Coloured } else { Style::Plain };
        Stream { sink: Box::new(stream), is_terminal, style }
    }

    fn spelt(&self, text: &StyledStr) -> String {
        match self.style {
            Style::Plain => text.to_string(),
            Style::Coloured => text.ansi().to_string(),
        }
    }

    fn write(&mut self, text: &str) -> io::Result<()> {
        self.sink.write_all(text.as_bytes())?;
        self.sink.flush()
    }
}
