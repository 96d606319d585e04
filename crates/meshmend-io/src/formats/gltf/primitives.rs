//! The primitives of a mesh, as the JSON has them, and why a mesh may be sealed.

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::{Object, Value};
use crate::formats::gltf::semantic::Semantic;

/// How the vertices of a primitive make faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Points and lines, which are not faces.
    NoFaces,
    Triangles,
    Strip,
    Fan,
}

/// Some faces of a mesh, with the accessors that hold their vertices.
pub(super) struct Primitive<'a> {
    pub(super) object: Object<'a>,
    pub(super) mode: Mode,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    /// Each attribute with its accessor, those of morph targets included; in the order of the file.
    pub(super) attributes: Vec<(Semantic, usize)>,
}

impl Primitive<'_> {
    /// How many corners the triangles of so many indices have at most.
    pub(super) fn most_corners(&self, indices: usize) -> u64 {
        let indices = indices as u64;
        match self.mode {
            Mode::NoFaces => 0,
            Mode::Triangles => indices,
            Mode::Strip | Mode::Fan => indices.saturating_sub(2).saturating_mul(3),
        }
    }
}

/// A mesh of the file.
pub(super) struct Mesh<'a> {
    pub(super) object: Object<'a>,
    pub(super) name: String,
    pub(super) primitives: Vec<Primitive<'a>>,
    /// The indices that say which corners are at one vertex, by `EXT_mesh_manifold`.
    pub(super) manifold_indices: Option<usize>,
    /// Why it can't be changed.
    pub(super) seal: Option<String>,
}

/// The extension that says which corners are at one vertex.
pub(super) const MANIFOLD: &str = "EXT_mesh_manifold";

/// Extensions on a primitive that hold nothing which numbers vertices or triangles by place.
const HARMLESS: [&str; 5] = [
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "KHR_materials_variants",
    "FB_ngon_encoding",
    "MSFT_lod",
];

/// Extensions on a primitive whose vertices are stored in another way.
const COMPRESSED: [&str; 2] = ["KHR_draco_mesh_compression", "KHR_meshopt_compression"];

impl<'a> Asset<'a> {
    /// A mesh with its primitives.
    ///
    /// # Errors
    /// If it names what does not exist.
    pub(super) fn mesh(&self, index: usize) -> Result<Mesh<'a>, Fault> {
        let object = Object::of(self.meshes[index], Pointer::item("meshes", index))?;
        let name = object.text("name")?.unwrap_or_default();
        let items = object.items("primitives")?;
        let primitive = |(at, value): (usize, &Value<'a>)| {
            self.primitive(Object::of(*value, object.pointer.item_of("primitives", at))?)
        };
        let primitives: Vec<Primitive<'a>> =
            items.iter().enumerate().map(primitive).collect::<Result<_, _>>()?;
        let manifold_indices = self.manifold_indices(&object)?;
        let mut mesh = Mesh { object, name, primitives, manifold_indices, seal: None };
        mesh.seal = self.reason_to_seal(index, &mesh)?;
        Ok(mesh)
    }

    fn primitive(&self, object: Object<'a>) -> Result<Primitive<'a>, Fault> {
        let mode = match object.count_or("mode", 4)? {
            0..=3 => Mode::NoFaces,
            4 => Mode::Triangles,
            5 => Mode::Strip,
            6 => Mode::Fan,
            other => return Err(object.fault_in("mode", format!("mode {other} is unknown"))),
        };
        let mut attributes = Vec::new();
        if let Some(listed) = object.object("attributes")? {
            for member in &listed.members {
                let accessor = listed.index(&member.name, self.accessors.len(), "accessor")?;
                attributes.extend(accessor.map(|accessor| (Semantic::of(&member.name), accessor)));
            }
        }
        for (target, listed) in object.items("targets")?.into_iter().enumerate() {
            let listed = Object::of(listed, object.pointer.item_of("targets", target))?;
            for member in &listed.members {
                let accessor = listed.index(&member.name, self.accessors.len(), "accessor")?;
                attributes.extend(
                    accessor.map(|accessor| (Semantic::of(&member.name).of_target(target), accessor)),
                );
            }
        }
        Ok(Primitive {
            mode,
            indices: object.index("indices", self.accessors.len(), "accessor")?,
            material: object.index("material", self.materials.len(), "material")?,
            attributes,
            object,
        })
    }

    fn manifold_indices(&self, mesh: &Object<'a>) -> Result<Option<usize>, Fault> {
        let Some(extensions) = mesh.object("extensions")? else { return Ok(None) };
        let Some(manifold) = extensions.object(MANIFOLD)? else { return Ok(None) };
        let Some(primitive) = manifold.object("manifoldPrimitive")? else { return Ok(None) };
        primitive.index("indices", self.accessors.len(), "accessor")
    }

    /// Why a mesh is passed through as it is, if there is a reason.
    fn reason_to_seal(&self, index: usize, mesh: &Mesh<'a>) -> Result<Option<String>, Fault> {
        let called = match mesh.name.as_str() {
            "" => format!("mesh {index}"),
            name => format!("mesh {index} `{}`", name.escape_debug()),
        };
        for (at, primitive) in mesh.primitives.iter().enumerate() {
            let found = match self.extension_that_seals(primitive)? {
                Some(found) => Some(found),
                None => self.compression_of(primitive)?,
            };
            if let Some(extension) = found {
                return Ok(Some(format!("{called} {}", because_of(&extension))));
            }
            if !primitive.attributes.iter().any(|(semantic, _)| semantic.is_position()) {
                return Ok(Some(format!("{called} has no positions in its primitive {at}")));
            }
        }
        Ok(None)
    }

    fn extension_that_seals(&self, primitive: &Primitive<'a>) -> Result<Option<String>, Fault> {
        let Some(extensions) = primitive.object.object("extensions")? else { return Ok(None) };
        let seals = |name: &str, value: Value<'_>| {
            !HARMLESS.contains(&name)
                && !name.starts_with("KHR_materials_")
                && (name.starts_with("KHR_gaussian_splatting") || names_accessors(value))
        };
        let found = extensions.members.iter().find(|member| seals(&member.name, member.value));
        Ok(found.map(|member| member.name.clone()))
    }

    /// The extension that compresses the bytes of a primitive.
    fn compression_of(&self, primitive: &Primitive<'a>) -> Result<Option<String>, Fault> {
        let accessors = primitive.attributes.iter().map(|&(_, accessor)| accessor).chain(primitive.indices);
        for accessor in accessors {
            let object = Object::of(self.accessors[accessor], Pointer::item("accessors", accessor))?;
            let Some(view) = object.index("bufferView", self.views.len(), "buffer view")? else { continue };
            if let Some(extension) = self.view(view)?.compression {
                return Ok(Some(extension.to_owned()));
            }
        }
        Ok(None)
    }
}

fn because_of(extension: &str) -> String {
    let is_compression = COMPRESSED.contains(&extension) || extension.ends_with("_compression");
    if is_compression {
        format!("is compressed with {extension}: decompress it first, for instance with `gltf-transform cp`")
    } else if extension.starts_with("KHR_gaussian_splatting") {
        format!("holds splats ({extension}), which have no faces")
    } else {
        format!(
            "has the extension {extension}, which may number vertices or triangles in a way not known here"
        )
    }
}

/// Whether a value has a number anywhere, which may be that of an accessor.
fn names_accessors(value: Value<'_>) -> bool {
    value.as_number().is_some() || value.children().into_iter().any(|child| names_accessors(child.value))
}
