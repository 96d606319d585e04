//! Who names the accessors and the buffer views of a file.

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::Object;
use crate::formats::gltf::primitives::MANIFOLD;

/// What names an accessor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum User {
    /// A primitive of a mesh, by its attributes, morph targets or indices.
    Primitive(usize, usize),
    /// The vertices of a mesh that the extension for manifolds states.
    Manifold(usize),
    /// Anything else.
    Other,
}

/// What names each accessor, and which views are named by something else than accessors.
pub(super) struct Users {
    pub(super) of_accessor: Vec<Vec<User>>,
    /// Whether a view is named by an image, by sparse rows, or by something unknown.
    pub(super) is_named_elsewhere: Vec<bool>,
    /// Whether all that may name accessors or views is known.
    pub(super) are_all_known: bool,
}

/// Extensions that name no accessors, or name them where they are looked for here.
const HARMLESS: [&str; 17] = [
    "EXT_lights_image_based",
    "EXT_mesh_features",
    "EXT_mesh_gpu_instancing",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "FB_ngon_encoding",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_xmp_json_ld",
    "MSFT_lod",
    "KHR_draco_mesh_compression",
    "KHR_gaussian_splatting",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "MSFT_texture_dds",
];

/// Whether an extension is known to name no accessor or view in a place that is not looked at.
fn is_harmless(extension: &str) -> bool {
    let families = ["KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_packing_"];
    HARMLESS.contains(&extension) || families.iter().any(|family| extension.starts_with(family))
}

impl Users {
    /// Looks at all places of a file that name accessors or views.
    ///
    /// # Errors
    /// If a place does not have the form that it must.
    pub(super) fn of(asset: &Asset<'_>) -> Result<Self, Fault> {
        let mut users = Users {
            of_accessor: vec![Vec::new(); asset.accessors.len()],
            is_named_elsewhere: vec![false; asset.views.len()],
            are_all_known: asset.extensions_used.iter().all(|extension| is_harmless(extension)),
        };
        for mesh in 0..asset.meshes.len() {
            users.see_mesh(asset, mesh)?;
        }
        users.see_animations(asset)?;
        users.see_others(asset)?;
        users.see_views(asset)?;
        Ok(users)
    }

    fn see(&mut self, accessor: Option<usize>, user: User) {
        if let Some(users) = accessor.and_then(|accessor| self.of_accessor.get_mut(accessor)) {
            users.push(user);
        }
    }

    fn see_member(&mut self, object: &Object<'_>, name: &str, user: User) {
        self.see(object.get(name).and_then(|value| value.as_count()).map(|index| index as usize), user);
    }

    fn see_mesh(&mut self, asset: &Asset<'_>, index: usize) -> Result<(), Fault> {
        let mesh = asset.mesh(index)?;
        for (at, primitive) in mesh.primitives.iter().enumerate() {
            for &(_, accessor) in &primitive.attributes {
                self.see(Some(accessor), User::Primitive(index, at));
            }
            self.see(primitive.indices, User::Primitive(index, at));
        }
        let Some(extensions) = mesh.object.object("extensions")? else { return Ok(()) };
        let Some(manifold) = extensions.object(MANIFOLD)? else { return Ok(()) };
        for name in ["mergeIndices", "mergeValues"] {
            self.see_member(&manifold, name, User::Manifold(index));
        }
        if let Some(primitive) = manifold.object("manifoldPrimitive")? {
            self.see_member(&primitive, "indices", User::Manifold(index));
            if let Some(attributes) = primitive.object("attributes")? {
                attributes
                    .members
                    .iter()
                    .for_each(|m| self.see_member(&attributes, &m.name, User::Manifold(index)));
            }
        }
        Ok(())
    }

    fn see_animations(&mut self, asset: &Asset<'_>) -> Result<(), Fault> {
        for (index, animation) in asset.root.items("animations")?.into_iter().enumerate() {
            let animation = Object::of(animation, Pointer::item("animations", index))?;
            for (at, sampler) in animation.items("samplers")?.into_iter().enumerate() {
                let sampler = Object::of(sampler, animation.pointer.item_of("samplers", at))?;
                self.see_member(&sampler, "input", User::Other);
                self.see_member(&sampler, "output", User::Other);
            }
        }
        Ok(())
    }

    /// Skins, and instances of nodes.
    fn see_others(&mut self, asset: &Asset<'_>) -> Result<(), Fault> {
        for (index, skin) in asset.root.items("skins")?.into_iter().enumerate() {
            let skin = Object::of(skin, Pointer::item("skins", index))?;
            self.see_member(&skin, "inverseBindMatrices", User::Other);
        }
        for (index, &node) in asset.nodes.iter().enumerate() {
            let node = Object::of(node, Pointer::item("nodes", index))?;
            let Some(extensions) = node.object("extensions")? else { continue };
            let Some(instances) = extensions.object("EXT_mesh_gpu_instancing")? else { continue };
            if let Some(attributes) = instances.object("attributes")? {
                attributes.members.iter().for_each(|m| self.see_member(&attributes, &m.name, User::Other));
            }
        }
        Ok(())
    }

    /// Views that images or sparse rows name, and those of the extensions that keep bytes in them.
    fn see_views(&mut self, asset: &Asset<'_>) -> Result<(), Fault> {
        for (index, image) in asset.root.items("images")?.into_iter().enumerate() {
            let image = Object::of(image, Pointer::item("images", index))?;
            self.name_view(&image);
        }
        for (index, &accessor) in asset.accessors.iter().enumerate() {
            let accessor = Object::of(accessor, Pointer::item("accessors", index))?;
            let Some(sparse) = accessor.object("sparse")? else { continue };
            for name in ["indices", "values"] {
                if let Some(rows) = sparse.object(name)? {
                    self.name_view(&rows);
                }
            }
        }
        // Property tables keep their values in views, and compressed primitives their bytes.
        let keeps_bytes = |extension: &String| {
            matches!(extension.as_str(), "EXT_structural_metadata" | "KHR_draco_mesh_compression")
                || extension.ends_with("_meshopt_compression")
                || !is_harmless(extension)
        };
        if asset.extensions_used.iter().any(keeps_bytes) {
            self.is_named_elsewhere.fill(true);
        }
        Ok(())
    }

    fn name_view(&mut self, object: &Object<'_>) {
        let view = object.get("bufferView").and_then(|value| value.as_count());
        if let Some(slot) = view.and_then(|view| self.is_named_elsewhere.get_mut(view as usize)) {
            *slot = true;
        }
    }

    /// Whether all that names an accessor is among some users.
    pub(super) fn are_among(&self, accessor: usize, some: impl Fn(User) -> bool) -> bool {
        self.are_all_known && self.of_accessor[accessor].iter().all(|&user| some(user))
    }
}
