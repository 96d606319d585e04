//! Formats, as the command line and its help name them.

use meshmend::Format;

/// Reads the extension of a format that is written.
pub(crate) fn format(word: &str) -> Result<Format, String> {
    Format::from_extension(word).ok_or_else(|| {
        let extensions = Format::ALL.iter().flat_map(|format| format.extensions());
        format!("the formats are {}", extensions.copied().collect::<Vec<&str>>().join(", "))
    })
}

/// What the help of a command says of its input.
pub(crate) fn input_help() -> String {
    format!("The mesh file: {}; `-` is standard input", formats_that_are_read())
}

/// What the help of a command says of its inputs.
pub(crate) fn inputs_help() -> String {
    format!("The mesh files: {}; `-` is standard input", formats_that_are_read())
}

/// `OBJ, PLY, … or OFF`.
fn formats_that_are_read() -> String {
    let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => names.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_format_is_answered_with_the_known_ones() {
        assert!(format("fbx").unwrap_err().starts_with("the formats are obj, ply"));
        assert_eq!(format("PLY"), Ok(Format::Ply));
    }
}
