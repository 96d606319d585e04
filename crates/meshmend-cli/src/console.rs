//! The streams to the outside. Reports go to standard output, errors and progress to standard error; reports too, where
//! standard output carries what a command makes.

use std::io::{self, IsTerminal, Read, Write};

use clap::builder::StyledStr;

use crate::failure::Failure;
use crate::progress::Progress;
use crate::render::{Style, printable};

/// Where a command reads and writes: a stream for a mesh, one for reports, in which a reader that has gone away is no
/// error, and one for what went wrong.
pub struct Console<'a> {
    input: Option<Box<dyn Read + Send + 'a>>,
    out: Stream<'a>,
    errors: Stream<'a>,
    is_closed: bool,
    /// Whether standard output carries what a command makes, and no reports.
    is_reserved: bool,
    /// Whether the streams are those of the process, which is then the program's own.
    is_of_process: bool,
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
        Console {
            input: Some(Box::new(io::stdin())),
            out: Stream::of_process(out),
            errors: Stream::of_process(errors),
            is_closed: false,
            is_reserved: false,
            is_of_process: true,
        }
    }
}

impl<'a> Console<'a> {
    /// Any two streams, to which plain text is written; standard input is empty.
    pub fn of(out: &'a mut (dyn Write + Send), errors: &'a mut (dyn Write + Send)) -> Self {
        let (out, errors) = (Stream::plain(out), Stream::plain(errors));
        let input: Option<Box<dyn Read + Send>> = Some(Box::new(io::empty()));
        Console { input, out, errors, is_closed: false, is_reserved: false, is_of_process: false }
    }

    /// These streams, with another one to read `-` from.
    #[must_use]
    pub fn with_input(self, input: &'a mut (dyn Read + Send)) -> Self {
        Console { input: Some(Box::new(input)), ..self }
    }

    /// Standard input, unless it was taken before.
    pub(crate) fn take_input(&mut self) -> Option<Box<dyn Read + Send + 'a>> {
        self.input.take()
    }

    /// Keeps standard output for what a command makes: from now on reports go to the stream for errors.
    pub(crate) fn reserve_output(&mut self) {
        self.is_reserved = true;
    }

    /// Lets something be written to standard output. It is not an error when the reader has gone away.
    pub(crate) fn send<R>(&mut self, write: impl FnOnce(&mut dyn Write) -> R) -> R {
        write(&mut Pipe { sink: &mut *self.out.sink, is_closed: &mut self.is_closed })
    }

    /// How reports are marked up.
    pub(crate) fn style(&self) -> Style {
        if self.is_reserved { self.errors.style } else { self.out.style }
    }

    /// Fails unless the process is the program's own, so that a command may limit it, or start it again.
    pub(crate) fn own_process(&self, command: &str) -> Result<(), Failure> {
        match self.is_of_process {
            true => Ok(()),
            false => Err(Failure::usage(format!("{command} needs a process of its own"))),
        }
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
        if self.is_reserved {
            // There is nowhere to tell if this fails.
            self.errors.write(text).ok();
            return Ok(());
        }
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

    /// Tells something that nobody asked for. There is nowhere to tell if that fails.
    pub(crate) fn note(&mut self, text: &str) {
        self.errors.write(&format!("meshmend: {}\n", printable(text))).ok();
    }

    /// Tells why something was not done. There is nowhere to tell if that fails.
    pub(crate) fn complain(&mut self, failure: &Failure) {
        let lines: Vec<String> = failure.message.trim_end().lines().map(printable).collect();
        self.errors.write(&format!("meshmend: {}\n", lines.join("\n"))).ok();
    }
}

/// A stream whose reader may go away: what is written then is dropped.
struct Pipe<'p> {
    sink: &'p mut (dyn Write + Send),
    is_closed: &'p mut bool,
}

impl Pipe<'_> {
    /// What a stream says, or something else when nobody reads it any more.
    fn unless_closed<T>(
        &mut self,
        closed: T,
        act: impl FnOnce(&mut dyn Write) -> io::Result<T>,
    ) -> io::Result<T> {
        if *self.is_closed {
            return Ok(closed);
        }
        match act(self.sink) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                *self.is_closed = true;
                Ok(closed)
            }
            result => result,
        }
    }
}

impl Write for Pipe<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.unless_closed(bytes.len(), |sink| sink.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.unless_closed((), |sink| sink.flush())
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes so many bytes; then its reader has gone away.
    struct Narrow(usize);

    impl Write for Narrow {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let taken = bytes.len().min(self.0);
            self.0 -= taken;
            if taken > 0 { Ok(taken) } else { Err(io::ErrorKind::BrokenPipe.into()) }
        }
        fn flush(&mut self) -> io::Result<()> {
            if self.0 > 0 { Ok(()) } else { Err(io::ErrorKind::BrokenPipe.into()) }
        }
    }

    #[test]
    fn a_reader_that_has_gone_away_is_no_error_and_is_written_to_no_more() {
        let (mut out, mut errors) = (Narrow(5), Vec::new());
        let mut console = Console::of(&mut out, &mut errors);
        console.send(|out| out.write_all(b"12345678").and_then(|()| out.flush())).unwrap();
        assert!(console.is_closed());
        console.write("a report").unwrap();
        console.reserve_output();
        console.write("another").unwrap();
        drop(console);
        assert_eq!(errors, b"another");
    }

    #[test]
    fn standard_input_is_there_once() {
        let (mut out, mut errors, mut input) = (Vec::new(), Vec::new(), &b"v 0 0 0"[..]);
        let mut console = Console::of(&mut out, &mut errors).with_input(&mut input);
        let mut text = String::new();
        console.take_input().unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "v 0 0 0");
        assert!(console.take_input().is_none());
    }
}
