//! How files begin that are not read here. Only messages use this.

use std::ffi::OsStr;

use crate::text::{trimmed_start, without_mark};

/// What content surely is, if it is of a known format that is not read here.
pub(crate) fn looks_like(head: &[u8], length: u64) -> Option<&'static str> {
    if length == 0 {
        return Some("an empty file");
    }
    let begins = |(start, _): &&(&[u8], &str)| head.starts_with(start);
    let by_start = BINARY.iter().find(begins).map(|&(_, name)| name);
    by_start
        .or_else(|| zip(head))
        .or_else(|| discreet(head, length))
        .or_else(|| tar(head))
        .or_else(|| text(head))
}

/// The first bytes of formats that always begin alike.
const BINARY: [(&[u8], &str); 30] = [
    (b"Kaydara FBX Binary", "binary FBX"),
    (b"BLENDER", "a Blender file"),
    (b"3D Geometry File Format", "a Rhino 3DM file"),
    (b"PXR-USDC", "binary USD"),
    (b"#usda", "USD"),
    (b"Ogawa", "Alembic"),
    (b"DRACO", "Draco-compressed geometry"),
    (b"\x1f\x8b", "gzip-compressed data"),
    (b"BZh", "bzip2-compressed data"),
    (b"\xfd7zXZ\0", "xz-compressed data"),
    (b"\x28\xb5\x2f\xfd", "zstd-compressed data"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive"),
    (b"Rar!", "a RAR archive"),
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"%PDF-", "a PDF document"),
    (b"\xff\xfe", "text in UTF-16 (ASCII and UTF-8 are read)"),
    (b"\xfe\xff", "text in UTF-16 (ASCII and UTF-8 are read)"),
    (b"version https://git-lfs", "a Git LFS pointer (`git lfs pull` fetches the file itself)"),
    (b"# vtk DataFile", "a legacy VTK file"),
    (b"#VRML", "VRML"),
    (b"#X3D", "X3D"),
    (b"; FBX", "FBX as text"),
    (b"ISO-10303-21", "STEP"),
    (b"$MeshFormat", "a Gmsh file"),
    (b"MeshVersionFormatted", "a Medit mesh"),
    (b"AC3D", "an AC3D file"),
    (b"xof 0", "a DirectX X file"),
    (b"\xd0\xcf\x11\xe0", "an OLE document"),
    (b"\x7fELF", "a program"),
];

/// What a text in markup contains near its start, in lower case.
const MARKUP: [(&[u8], &str); 9] = [
    (b"<!doctype html", "HTML, a web page, perhaps in place of a download"),
    (b"<html", "HTML, a web page, perhaps in place of a download"),
    (b"<collada", "COLLADA"),
    (b"<x3d", "X3D"),
    (b"<amf", "AMF"),
    (b"<vtkfile", "a VTK XML file"),
    (b"<svg", "an SVG picture"),
    (b"<model", "a 3MF model part"),
    (b"<error>", "an error message in XML, in place of a download"),
];

/// The extensions of mesh files that are not read here.
const EXTENSIONS: [&str; 7] = ["fbx", "dae", "x3d", "wrl", "3ds", "amf", "usdz"];

/// Whether an extension stands for a mesh format that is not read here.
pub(crate) fn is_extension(extension: &OsStr) -> bool {
    EXTENSIONS.iter().any(|foreign| extension.eq_ignore_ascii_case(foreign))
}

/// Whether content is a zip archive.
pub(crate) fn is_zip(head: &[u8]) -> bool {
    head.starts_with(b"PK\x03\x04")
}

fn zip(head: &[u8]) -> Option<&'static str> {
    let has = |name: &[u8]| head.windows(name.len()).any(|window| window == name);
    is_zip(head).then(|| {
        if has(b".usdc") || has(b".usda") {
            "USDZ (a zip archive)"
        } else {
            "a zip archive (unpack it first, unless it is 3MF)"
        }
    })
}

/// 3DS: a chunk that is the whole file.
fn discreet(head: &[u8], length: u64) -> Option<&'static str> {
    let bytes = head.get(2..6)?.try_into().ok()?;
    (head.starts_with(b"MM") && u64::from(u32::from_le_bytes(bytes)) == length).then_some("3DS")
}

fn tar(head: &[u8]) -> Option<&'static str> {
    (head.get(257..262) == Some(b"ustar")).then_some("a tar archive")
}

fn text(head: &[u8]) -> Option<&'static str> {
    const NEAR: usize = 4096;
    let start = trimmed_start(without_mark(head));
    let start = start[..start.len().min(NEAR)].to_ascii_lowercase();
    if !start.starts_with(b"<") {
        return None;
    }
    let has = |name: &[u8]| start.windows(name.len()).any(|window| window == name);
    let known = MARKUP.iter().find(|(name, _)| has(name));
    known.map(|&(_, name)| name).or(if start.starts_with(b"<?xml") { Some("XML") } else { None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_beginning_is_known() {
        for (start, name) in BINARY {
            assert_eq!(looks_like(start, 99), Some(name));
        }
        for (text, name) in [
            (&b"PK\x03\x04 a.usdc"[..], "USDZ (a zip archive)"),
            (b"PK\x03\x04 a.obj", "a zip archive (unpack it first, unless it is 3MF)"),
            (b"<!DOCTYPE HTML>\n<title>404", "HTML, a web page, perhaps in place of a download"),
            (b"\xef\xbb\xbf  <html>", "HTML, a web page, perhaps in place of a download"),
            (b"<?xml version=\"1.0\"?>\n<COLLADA xmlns", "COLLADA"),
            (b"<?xml version=\"1.0\"?><a/>", "XML"),
            (b"MM\x07\0\0\0x", "3DS"),
        ] {
            assert_eq!(looks_like(text, text.len() as u64), Some(name));
        }
        let mut tar = vec![0; 512];
        tar[257..262].copy_from_slice(b"ustar");
        assert_eq!(looks_like(&tar, 512), Some("a tar archive"));
        assert_eq!(looks_like(b"", 0), Some("an empty file"));
    }

    #[test]
    fn what_may_be_anything_has_no_name() {
        for text in [
            &b"v 0 0 0"[..],
            b"solid x",
            b"{}",
            b"{ v }",
            b"<",
            b"MM",
            b"MM\0\0\0\0",
            b"\0\0\0",
            b"G",
            b"# x",
        ] {
            assert_eq!(looks_like(text, text.len() as u64), None);
        }
    }
}
