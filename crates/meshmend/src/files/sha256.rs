//! SHA-256, by which rows tell whether bytes are the same.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use sha2::{Digest, Sha256};

/// How much of a file is held at once.
const BLOCK: usize = 1 << 16;

/// The SHA-256 of some bytes, in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// The SHA-256 of a file, in hexadecimal digits.
///
/// # Errors
/// If the system can't read it.
///
/// *Cost*: linear; memory for one block of the file.
pub fn sha256_of(path: &Path) -> io::Result<String> {
    let (mut file, mut digest, mut block) = (File::open(path)?, Sha256::new(), vec![0; BLOCK]);
    loop {
        match file.read(&mut block) {
            Ok(0) => return Ok(hexadecimal(&digest.finalize())),
            Ok(count) => digest.update(block.get(..count).unwrap_or_default()),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_the_standard_for_bytes_and_for_files_of_several_blocks() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), abc);
        let path = std::env::temp_dir().join(format!("meshmend-sha256-{}", std::process::id()));
        let bytes = vec![7; 2 * BLOCK + 1];
        std::fs::write(&path, &bytes).unwrap();
        let read = sha256_of(&path);
        std::fs::remove_file(&path).unwrap();
        assert_eq!(read.unwrap(), sha256(&bytes));
        assert!(sha256_of(&path).is_err());
    }
}
