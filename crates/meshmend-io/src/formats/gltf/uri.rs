//! The URIs of buffers: bytes within the file, or a file beside it.

use crate::formats::gltf::base64;

/// How data URIs of buffers begin.
pub(super) const DATA_URI: &str = "data:application/octet-stream;base64,";

/// What a URI names.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Named<'a> {
    /// Bytes in base64.
    Data(&'a str),
    /// A file, by its path.
    File(Vec<u8>),
}

/// What a URI names, or why it can't be.
///
/// # Errors
/// If it is neither data in base64 nor the relative path of a file.
pub(super) fn named(uri: &str) -> Result<Named<'_>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (form, data) = data.split_once(',').ok_or("is a data URI without data")?;
        let is_base64 = form.len() >= 7
            && form.is_char_boundary(form.len() - 7)
            && form[form.len() - 7..].eq_ignore_ascii_case(";base64");
        return if is_base64 {
            Ok(Named::Data(data))
        } else {
            Err("is a data URI that is not in base64".to_owned())
        };
    }
    if let Some((scheme, _)) = uri.split_once(':').filter(|(scheme, _)| is_scheme(scheme)) {
        return Err(format!("names a place on the net or in the system (`{scheme}:`), which is not opened"));
    }
    if uri.is_empty() {
        return Err("is empty".to_owned());
    }
    percent_decoded(uri).map(Named::File)
}

fn is_scheme(text: &str) -> bool {
    // One letter would be the drive of a Windows path, which is outside the folder all the same.
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c))
}

/// The bytes in base64 of a data URI.
///
/// # Errors
/// If they are something else.
pub(super) fn decoded(data: &str) -> Result<Vec<u8>, String> {
    base64::decode(data.as_bytes()).map_err(|at| format!("is not base64 from its byte {at} on"))
}

/// A data URI of some bytes.
pub(super) fn data_uri(bytes: &[u8]) -> String {
    DATA_URI.to_owned() + &base64::encode(bytes)
}

fn percent_decoded(text: &str) -> Result<Vec<u8>, String> {
    let mut parts = text.split('%');
    let mut out = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        let digits = part.get(..2).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()));
        let byte = digits.and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match byte {
            Some(byte) if byte != 0 => out.push(byte),
            _ => {
                return Err(format!(
                    "`%{}` stands for no character",
                    part.chars().take(2).collect::<String>()
                ));
            }
        }
        out.extend_from_slice(&part.as_bytes()[2..]);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_uri_is_data_or_a_file_beside() {
        assert_eq!(named("data:application/octet-stream;base64,AAA="), Ok(Named::Data("AAA=")));
        assert_eq!(named("data:;Base64,"), Ok(Named::Data("")));
        assert_eq!(named("a%20b%C3%A9.bin"), Ok(Named::File("a bé.bin".into())));
        assert_eq!(named("parts/a.bin"), Ok(Named::File(b"parts/a.bin".to_vec())));
        assert_eq!(named("../a.bin"), Ok(Named::File(b"../a.bin".to_vec())));
        let wrong = [
            "",
            "data:x",
            "data:text/plain,hello",
            "data:é,x",
            "http://a/b",
            "file:///a",
            "C:/a.bin",
            "a%2",
            "a%zz",
            "a%00",
            "%é",
        ];
        for uri in wrong {
            assert!(named(uri).is_err(), "{uri}");
        }
        assert_eq!(decoded(data_uri(b"xyz").rsplit(',').next().unwrap()), Ok(b"xyz".to_vec()));
        assert_eq!(decoded("AA?="), Err("is not base64 from its byte 2 on".to_owned()));
    }
}
