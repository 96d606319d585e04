//! The JSON of a file: its arrays, opened as far as meshes need them. All else stays text.

use std::cell::OnceCell;

use crate::Limits;
use crate::document::DistinctNames;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::{Object, Value};
use crate::limits::{NODES, PARTS};

/// The JSON of a file.
pub(super) struct Asset<'a> {
    pub(super) root: Object<'a>,
    pub(super) buffers: Vec<Value<'a>>,
    pub(super) views: Vec<Value<'a>>,
    pub(super) accessors: Vec<Value<'a>>,
    pub(super) meshes: Vec<Value<'a>>,
    pub(super) nodes: Vec<Value<'a>>,
    pub(super) materials: Vec<Value<'a>>,
    pub(super) extensions_used: Vec<String>,
    /// How many bytes each buffer says that it has, once that was asked for: the text of a buffer may be long.
    lengths: Vec<OnceCell<u64>>,
    material_names: OnceCell<DistinctNames>,
}

/// A piece of a buffer.
pub(super) struct View {
    pub(super) buffer: usize,
    pub(super) offset: u64,
    pub(super) length: u64,
    pub(super) stride: Option<u64>,
    /// The extension by which its bytes are compressed.
    pub(super) compression: Option<&'static str>,
}

/// Extensions that compress the bytes of buffer views.
const COMPRESSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// A stride has at least and at most so many bytes.
const STRIDES: std::ops::RangeInclusive<u64> = 4..=252;

impl<'a> Asset<'a> {
    /// Opens the JSON of a file.
    ///
    /// # Errors
    /// If it is not glTF 2, or has more meshes or nodes than the limits allow.
    pub(super) fn of(json: Value<'a>, limits: &Limits) -> Result<Self, Fault> {
        let root = Object::of(json, Pointer::ROOT)?;
        check_version(&root)?;
        let buffers = root.items("buffers")?;
        let asset = Asset {
            lengths: vec![OnceCell::new(); buffers.len()],
            buffers,
            views: root.items("bufferViews")?,
            accessors: root.items("accessors")?,
            meshes: root.items("meshes")?,
            nodes: root.items("nodes")?,
            materials: root.items("materials")?,
            extensions_used: root.items("extensionsUsed")?.iter().filter_map(|name| name.as_text()).collect(),
            root,
            material_names: OnceCell::new(),
        };
        Fault::if_more(PARTS, asset.meshes.len() as u64, limits.max_parts)?;
        Fault::if_more(NODES, asset.nodes.len() as u64, limits.max_nodes)?;
        Ok(asset)
    }

    /// A buffer view.
    ///
    /// # Errors
    /// If it is not within its buffer.
    pub(super) fn view(&self, index: usize) -> Result<View, Fault> {
        let pointer = Pointer::item("bufferViews", index);
        let view = Object::of(self.views[index], pointer.clone())?;
        let buffer = view.index("buffer", self.buffers.len(), "buffer")?;
        let buffer = buffer.ok_or_else(|| pointer.fault("has no `buffer`"))?;
        let (offset, length) = (view.count_or("byteOffset", 0)?, view.count("byteLength")?);
        let held = self.buffer_length(buffer)?;
        if offset.checked_add(length).is_none_or(|end| end > held) {
            let reason = format!("{length} bytes from byte {offset} on are not within a buffer of {held}");
            return Err(pointer.fault(reason));
        }
        let stride = view.get("byteStride").map(|_| view.count("byteStride")).transpose()?;
        if let Some(stride) = stride.filter(|stride| !STRIDES.contains(stride)) {
            return Err(view.fault_in("byteStride", format!("{stride} is not from 4 to 252")));
        }
        let extensions = view.object("extensions")?;
        let has = |name: &&&str| extensions.as_ref().is_some_and(|all| all.get(name).is_some());
        Ok(View { buffer, offset, length, stride, compression: COMPRESSIONS.iter().find(has).copied() })
    }

    /// How many bytes a buffer says that it has.
    pub(super) fn buffer_length(&self, index: usize) -> Result<u64, Fault> {
        if let Some(&length) = self.lengths[index].get() {
            return Ok(length);
        }
        let length = Object::of(self.buffers[index], Pointer::item("buffers", index))?.count("byteLength")?;
        Ok(*self.lengths[index].get_or_init(|| length))
    }

    /// The names of the materials.
    pub(super) fn material_names(&self) -> &DistinctNames {
        let given = |(index, &material): (usize, &Value<'_>)| {
            let material = Object::of(material, Pointer::item("materials", index)).ok()?;
            let name = material.text("name").ok().flatten()?;
            (!name.is_empty()).then(|| name.into_bytes())
        };
        let all = || self.materials.iter().enumerate().map(given).collect::<Vec<_>>();
        self.material_names.get_or_init(|| DistinctNames::of(&all()))
    }
}

fn check_version(root: &Object<'_>) -> Result<(), Fault> {
    let asset = root.object("asset")?.ok_or_else(|| Pointer::ROOT.fault("has no `asset`: it is not glTF"))?;
    let version = asset.text("version")?.ok_or_else(|| asset.pointer.fault("has no `version`"))?;
    if version.split('.').next() != Some("2") {
        let shown = version.escape_debug();
        return Err(asset.fault_in("version", format!("version {shown} of glTF is not read, only 2.x")));
    }
    match asset.text("minVersion")? {
        Some(least) if least != "2.0" => {
            let shown = least.escape_debug();
            Err(asset
                .fault_in("minVersion", format!("at least version {shown} of glTF is needed; 2.0 is read")))
        }
        _ => Ok(()),
    }
}
