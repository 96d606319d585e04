//! A sink that fails: the writer says so, and nothing is written twice.

use std::io::{self, Write};

use meshmend_io::{WriteErrorKind, WriteOptions, encode};

use super::{encoded, forms, sheet_mesh};

/// A sink that takes a little at a time, and fails at one operation, a write or a flush.
struct Failing {
    taken: Vec<u8>,
    operations: usize,
    failing: usize,
    fault: Fault,
    fails_in_a_flush: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    Error(io::ErrorKind),
    /// A write that takes nothing.
    Nothing,
}

const FAULTS: [Fault; 4] = [
    Fault::Error(io::ErrorKind::StorageFull),
    Fault::Error(io::ErrorKind::Other),
    Fault::Error(io::ErrorKind::Interrupted),
    Fault::Nothing,
];

/// How much is taken at a time.
const MOST: usize = 5_000;

impl Failing {
    fn new(failing: usize, fault: Fault) -> Self {
        Failing { taken: Vec::new(), operations: 0, failing, fault, fails_in_a_flush: false }
    }

    fn fault(&mut self) -> Option<Fault> {
        self.operations += 1;
        (self.operations == self.failing).then_some(self.fault)
    }
}

impl Write for Failing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.fault() {
            Some(Fault::Error(error)) => Err(error.into()),
            Some(Fault::Nothing) => Ok(0),
            None => {
                let piece = &bytes[..bytes.len().min(MOST)];
                self.taken.extend_from_slice(piece);
                Ok(piece.len())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.fault() {
            Some(Fault::Error(error)) => {
                self.fails_in_a_flush = true;
                Err(error.into())
            }
            _ => Ok(()),
        }
    }
}

#[test]
fn whichever_operation_fails_the_writer_says_so_and_interruptions_are_nothing() {
    let mesh = sheet_mesh(40);
    let mut count = 0;
    for form in forms() {
        let whole = encoded(&mesh, form);
        let options = WriteOptions::of(form.0).with_encoding(form.1);
        let mut counting = Failing::new(0, Fault::Nothing);
        encode(&mesh, &options, &mut counting).unwrap();
        assert!(counting.operations > whole.len() / MOST && counting.taken == whole);
        for (failing, fault) in (1..=counting.operations).flat_map(|k| FAULTS.map(|fault| (k, fault))) {
            let mut sink = Failing::new(failing, fault);
            let result = encode(&mesh, &options, &mut sink).map_err(|error| error.kind);
            let case = format!("{form:?}, {fault:?} at operation {failing}");
            let is_retried = fault == Fault::Error(io::ErrorKind::Interrupted) && !sink.fails_in_a_flush;
            let is_harmless = fault == Fault::Nothing && failing == counting.operations;
            match (result, fault) {
                (Ok(_), _) => assert!((is_retried || is_harmless) && sink.taken == whole, "{case}"),
                (Err(_), _) if is_retried || is_harmless => panic!("{case}: an error"),
                (Err(WriteErrorKind::Io(found)), Fault::Error(error)) => {
                    assert_eq!(found.kind(), error, "{case}");
                }
                (Err(WriteErrorKind::Io(found)), Fault::Nothing) => {
                    assert_eq!(found.kind(), io::ErrorKind::WriteZero, "{case}");
                }
                (Err(other), _) => panic!("{case}: {other}"),
            }
            assert!(whole.starts_with(&sink.taken), "{case}: something was written twice or left out");
            count += 1;
        }
    }
    println!("{count} faults");
}
