//! The colours of base materials: `#RRGGBB` or `#RRGGBBAA`.

use crate::Material;

/// A material of a name, in the colour that a text says.
pub(super) fn material(name: String, color: Option<&str>) -> Material {
    let material = Material::named(name);
    let Some(bytes) = color.and_then(bytes) else { return material };
    let fractions: Vec<f64> = bytes.iter().map(|&byte| f64::from(byte) / 255.0).collect();
    let [red, green, blue, alpha @ ..] = fractions.as_slice() else { return material };
    let opacity = alpha.first().copied().filter(|&opacity| opacity < 1.0);
    Material { base_color: Some([*red, *green, *blue]), opacity, ..material }
}

fn bytes(color: &str) -> Option<Vec<u8>> {
    let digits = color.trim().strip_prefix('#').filter(|digits| matches!(digits.len(), 6 | 8))?;
    let pairs = digits.as_bytes().chunks(2).map(|pair| std::str::from_utf8(pair).ok());
    pairs.map(|pair| u8::from_str_radix(pair?, 16).ok()).collect()
}

/// The colour of a material as text; grey if it has none.
pub(in crate::formats::threemf) fn color_text(material: Option<&Material>) -> String {
    const GREY: [f64; 3] = [128.0 / 255.0; 3];
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let [red, green, blue] = material.and_then(|material| material.base_color).unwrap_or(GREY).map(byte);
    let opaque = format!("#{red:02X}{green:02X}{blue:02X}");
    match material.and_then(|material| material.opacity).map(byte) {
        None | Some(255) => opaque,
        Some(alpha) => format!("{opaque}{alpha:02X}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read_as_they_are_written() {
        for text in ["#C0FFEE", "#00000000", "#12345678", "#808080"] {
            assert_eq!(color_text(Some(&material("a".to_owned(), Some(text)))), text);
        }
        let read = |text| material("a".to_owned(), Some(text)).base_color;
        assert_eq!((read("#ff0000FF"), read(" #FF0000")), (Some([1.0, 0.0, 0.0]), Some([1.0, 0.0, 0.0])));
        for wrong in ["", "#", "red", "#FFF", "#GG0000", "#1234567", "#12345\u{e4}"] {
            assert_eq!(read(wrong), None, "{wrong}");
        }
        assert_eq!(color_text(None), "#808080");
    }
}
