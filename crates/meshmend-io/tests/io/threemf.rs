//! 3MF: packages made in code, and what is right about each.

mod conversions;
mod objects;
mod packages;
mod splicing;
mod splicing_numbers;

use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use meshmend_core::{CornerId, Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};
use meshmend_io::{
    Document, Format, Limits, Loss, PreparedDocument, ReadError, ReadErrorKind, ReadOptions, WriteOptions,
    read_document_bytes,
};
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveWriter};

const TYPES: &str = "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>";
const RELATIONS: &str = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
    <Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" \
    Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

/// An archive of these entries.
fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipArchiveWriter::new(Vec::new());
    for (name, content) in entries {
        let path = rawzip::path::EntryPath::verbatim(name.as_bytes());
        let file = writer.new_file(path).compression_method(CompressionMethod::DEFLATE);
        let (mut entry, config) = file.start().unwrap();
        let encoder = DeflateEncoder::new(&mut entry, Compression::default());
        let mut data = config.wrap(encoder);
        data.write_all(content).unwrap();
        let (encoder, descriptor) = data.finish().unwrap();
        encoder.finish().unwrap();
        entry.finish(descriptor).unwrap();
    }
    writer.finish().unwrap()
}

/// A package with a model and a picture beside it.
fn package_of(model: &[u8]) -> Vec<u8> {
    archive(&[
        ("[Content_Types].xml", TYPES.as_bytes()),
        ("Metadata/plate_1.png", b"\x89PNG not a picture"),
        ("_rels/.rels", RELATIONS.as_bytes()),
        ("3D/3dmodel.model", model),
        ("Metadata/slic3r.config", b"; layer_height = 0.2\n"),
    ])
}

/// A model with these resources and items.
fn model(resources: &str, items: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xmlns=\"{CORE}\" \
         xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" \
         xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" \
         xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" \
         xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" \
         xmlns:t=\"http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07\" \
         xmlns:x=\"http://example.org/x\">\n<resources>\n{resources}</resources>\n<build>\n{items}</build>\n</model>\n"
    )
}

/// A package with these resources, of which object 1 is built.
fn package(resources: &str) -> Vec<u8> {
    package_of(model(resources, "<item objectid=\"1\"/>\n").as_bytes())
}

/// An object that is a tetrahedron. Its rows have attributes of other programs, and odd spellings.
fn tetrahedron(attributes: &str, children: &str) -> String {
    format!(
        "<object id=\"1\" {attributes}>\n<mesh>\n<vertices>\n<vertex x=\"0\" y=\"0.0\" z=\"0e0\"/>\n \
         <vertex y=\"0\" x=\"1.50\" z=\"0\" x:note=\"a &gt; b\" />\n<vertex x='0' y='1' z='0'></vertex>\n\
         <vertex x=\"0\" y=\"0\" z=\"+1\"/>\n</vertices>\n<triangles>\n\
         <triangle v1=\"0\" v2=\"2\" v3=\"1\" paint_color=\"8\"/>\n\
         <triangle v1=\"0\" v2=\"1\" v3=\"3\" slic3rpe:mmu_segmentation=\"1C\" />\n\
         <!-- two more --><triangle v1=\"1\" v2=\"2\" v3=\"3\"/>\n\
         <triangle v2='0' v1='2' v3='3'/>\n</triangles>\n{children}</mesh>\n</object>\n"
    )
}

fn try_document(bytes: &[u8]) -> Result<Document, ReadError> {
    read_document_bytes(bytes, "test.3mf", &ReadOptions::default())
}

#[track_caller]
fn document(bytes: &[u8]) -> Document {
    try_document(bytes).unwrap()
}

/// Why a package is not read, with its place.
#[track_caller]
fn refused(bytes: &[u8]) -> String {
    let error = try_document(bytes).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::Malformed(_)), "{error}");
    error.to_string()
}

/// A document as it is written, and what is lost.
#[track_caller]
fn spliced(document: &Document) -> (Vec<u8>, Vec<Loss>) {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(Format::ThreeMf)).unwrap();
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).unwrap();
    (bytes, prepared.losses())
}

/// The content of an entry.
#[track_caller]
fn content(bytes: &[u8], name: &str) -> Vec<u8> {
    let archive = ZipArchive::from_slice(bytes).unwrap();
    let mut entries = archive.entries();
    while let Some(record) = entries.next_entry().unwrap() {
        if record.file_path().as_bytes() == name.as_bytes() {
            let entry = archive.get_entry(record.wayfinder()).unwrap();
            let mut content = Vec::new();
            if record.compression_method() == CompressionMethod::DEFLATE {
                let inflated = DeflateDecoder::new(entry.data());
                entry.verifying_reader(inflated).read_to_end(&mut content).unwrap();
            } else {
                entry.verifying_reader(entry.data()).read_to_end(&mut content).unwrap();
            }
            return content;
        }
    }
    panic!("no entry {name}")
}

#[track_caller]
fn model_text(bytes: &[u8]) -> String {
    String::from_utf8(content(bytes, "3D/3dmodel.model")).unwrap()
}

/// A mesh with other faces: each has the number of an old one and, of each corner, its place in that.
fn rearranged(mesh: &PolygonMesh, faces: &[(u32, [usize; 3])], flipped: &[u32]) -> PolygonMesh {
    let old = mesh.faces();
    let corner = |(face, place): (u32, usize)| CornerId(face * 3 + place as u32);
    let corners: Vec<CornerId> =
        faces.iter().flat_map(|&(face, places)| places.map(|place| corner((face, place)))).collect();
    let vertices: Vec<VertexId> = corners.iter().map(|&corner| old.corner_vertex(corner)).collect();
    let table = FaceTable::triangles(mesh.counts().vertices, vertices).unwrap();
    let face_sources = Sources::listed(faces.iter().map(|&(face, _)| Some(FaceId(face))));
    let corner_sources = Sources::listed(corners.into_iter().map(Some));
    let draft = Draft::of_faces(mesh, table, face_sources, corner_sources);
    let flipped = flipped.iter().map(|&face| FaceId(face)).collect();
    mesh.rebuild(Draft { flipped, ..draft }).unwrap().0
}

/// The limits with one of them changed.
fn read_within(bytes: &[u8], limits: Limits) -> String {
    let options = ReadOptions::default().with_limits(limits);
    read_document_bytes(bytes, "test.3mf", &options).unwrap_err().to_string()
}
