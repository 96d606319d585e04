//! Formats, as the command line and its help name them.

use meshmend::{Format, WriteOptions};

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

/// What readers call a file that is written so.
pub(crate) fn variant(options: &WriteOptions) -> Option<&'static str> {
    let (format, encoding) = options.resolved().ok()?;
    Some(format.variant(encoding))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_format_is_answered_with_the_known_ones() {
        assert!(format("fbx").unwrap_err().starts_with("the formats are obj, ply"));
        assert_eq!(format("PLY"), Ok(Format::Ply));
    }

    #[test]
    fn what_is_written_has_the_name_that_its_reader_gives_it() {
        for &format in Format::ALL {
            for &encoding in format.encodings() {
                let options = WriteOptions::of(format).with_encoding(encoding);
                let faces = meshmend::FaceTable::triangles(3, [0, 1, 2].map(meshmend::VertexId).to_vec());
                let mesh = meshmend::PolygonMesh::new(vec![[0.0; 3]; 3], faces.unwrap()).unwrap();
                let mut bytes = Vec::new();
                meshmend::encode(&mesh, &options, &mut bytes).unwrap();
                let name = format!("a.{}", format.extensions()[0]);
                let file = meshmend::read_bytes(&bytes, &name, &Default::default()).unwrap();
                assert_eq!(Some(file.variant), variant(&options));
            }
        }
    }
}
