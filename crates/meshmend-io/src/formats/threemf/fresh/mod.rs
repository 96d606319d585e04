//! The writer of a new package from one mesh.

mod losses;
mod model;
mod objects;

use std::io::{self, Write};

pub(super) use self::losses::losses;
use crate::formats::threemf::package::{Packer, archive_of};
use crate::{Prepared, WriteErrorKind};

const TYPES: &[u8] = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
    <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
    <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\
    </Types>\n";

const RELATIONS: &[u8] = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
    <Relationship Id=\"rel0\" Target=\"/3D/3dmodel.model\" \
    Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

/// *Cost*: linear; the packed bytes are held in memory.
pub(super) fn encode(prepared: &Prepared, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
    let packed = |text: &[u8]| {
        let mut packer = Packer::deflating();
        packer.write_all(text)?;
        packer.finish()
    };
    let mut packer = Packer::deflating();
    model::write(prepared, &mut packer)?;
    let contents = [
        ("[Content_Types].xml", packed(TYPES)?),
        ("_rels/.rels", packed(RELATIONS)?),
        ("3D/3dmodel.model", packer.finish()?),
    ];
    out.write_all(&archive_of(&contents))?;
    Ok(out.flush()?)
}
