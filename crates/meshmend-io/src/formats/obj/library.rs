//! The images that a material library names.

use crate::text::{trimmed, trimmed_start, word};

/// Statements that name an image. So do all that begin with `map_`.
const WITH_IMAGE: [&[u8]; 6] = [b"bump", b"disp", b"decal", b"refl", b"norm", b"map"];

/// Options, with the most values that each can have.
const OPTIONS: [(&[u8], usize); 14] = [
    (b"-blendu", 1),
    (b"-blendv", 1),
    (b"-bm", 1),
    (b"-boost", 1),
    (b"-cc", 1),
    (b"-clamp", 1),
    (b"-imfchan", 1),
    (b"-mm", 2),
    (b"-o", 3),
    (b"-s", 3),
    (b"-t", 3),
    (b"-texres", 1),
    (b"-type", 1),
    (b"-colorspace", 1),
];

/// The images that a library names, each in two readings: all that follows the options, and the last word alone.
pub(super) fn images(text: &[u8]) -> impl Iterator<Item = [&[u8]; 2]> {
    text.split(|&byte| byte == b'\n' || byte == b'\r').filter_map(image)
}

/// The image that a line names, in two readings.
pub(super) fn image(line: &[u8]) -> Option<[&[u8]; 2]> {
    let line = trimmed(line);
    let keyword = word(line, 0).to_ascii_lowercase();
    if !keyword.starts_with(b"map_") && !WITH_IMAGE.contains(&&keyword[..]) {
        return None;
    }
    let name = without_options(trimmed(&line[keyword.len()..]));
    let last = name.rsplit(|byte| byte.is_ascii_whitespace()).next()?;
    (!name.is_empty()).then_some([name, last])
}

/// A text without the options that it begins with.
pub(super) fn without_options(mut rest: &[u8]) -> &[u8] {
    while let Some((_, most)) = OPTIONS.iter().find(|(option, _)| *option == word(rest, 0)) {
        rest = after_word(rest);
        for value in 0..*most {
            // Of several values only the first is required; the others are numbers.
            if value > 0 && fast_float2::parse::<f64, _>(word(rest, 0)).is_err() {
                break;
            }
            rest = after_word(rest);
        }
    }
    rest
}

fn after_word(text: &[u8]) -> &[u8] {
    trimmed_start(&text[word(text, 0).len()..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_named_after_the_options() {
        let read = |line: &str| {
            images(line.as_bytes()).map(|names| names.map(|n| String::from_utf8_lossy(n).into_owned())).next()
        };
        let both = |name: &str| Some([name.to_owned(), name.to_owned()]);
        assert_eq!(read("map_Kd a.png"), both("a.png"));
        assert_eq!(read("\tMAP_kd -s 1 2 3 -clamp on a.png \r"), both("a.png"));
        assert_eq!(read("bump -bm 0.5 a.png"), both("a.png"));
        assert_eq!(read("map_Ks -o 0.5 b.tga"), both("b.tga"));
        assert_eq!(read("map_Kd my own.png"), Some(["my own.png".to_owned(), "own.png".to_owned()]));
        for line in ["Kd 1 0 0", "map_Kd", "map_Kd -s 1 1 1", "# map_Kd a.png", "newmtl map_Kd"] {
            assert_eq!(read(line), None, "{line}");
        }
    }
}
