//! What a file has round its meshes.

use crate::document::{Document, Placement};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::file::File;
use crate::formats::gltf::materials;
use crate::formats::gltf::nodes::{Placed, nodes, placed, roots};
use crate::formats::gltf::primitives::Mode;
use crate::formats::gltf::splice;
use crate::shell::{NamedFile, Output, Shape, Splice, Spliced};
use crate::text::one_or_many;
use crate::{Format, Loss, LossKind, Material, WriteErrorKind};

/// A file as it was read.
#[derive(Debug)]
pub(super) struct GltfShape {
    pub(super) file: File,
}

impl GltfShape {
    pub(super) fn of(file: File) -> Self {
        GltfShape { file }
    }

    /// All that the scene places.
    fn placed(&self, asset: &Asset<'_>) -> Result<Vec<Placement>, Fault> {
        let nodes = nodes(asset)?;
        let name_of = |placed: &Placed| match &nodes[placed.node].name {
            Some(name) if !name.is_empty() => name.clone(),
            _ => asset.mesh(placed.mesh).map(|mesh| mesh.name).unwrap_or_default(),
        };
        let placements = placed(&nodes, &roots(asset, &nodes)?);
        let placement = |placed: &Placed| Placement {
            part: placed.mesh,
            name: name_of(placed).into_bytes(),
            matrix: placed.matrix,
        };
        Ok(placements.iter().map(placement).collect())
    }

    /// What a format without nodes does not hold.
    fn losses(&self) -> Result<Vec<Loss>, Fault> {
        let asset = self.file.asset()?;
        let mut losses = Vec::new();
        let mut lost = |count: usize, one: &str, many: &str| {
            let told = |count| {
                format!("{} left out", one_or_many(count, &format!("{one} is"), &format!("{many} are")))
            };
            losses.extend(Loss::if_any(LossKind::ScenePart, count, told));
        };
        for (array, one, many) in [
            ("skins", "skin", "skins"),
            ("animations", "animation", "animations"),
            ("cameras", "camera", "cameras"),
        ] {
            lost(asset.root.items(array)?.len(), one, many);
        }
        lost(lights(&asset)?, "light", "lights");
        let (mut targets, mut lines) = (0, 0);
        for index in 0..asset.meshes.len() {
            let mesh = asset.mesh(index)?;
            let of_target = |primitive: &crate::formats::gltf::primitives::Primitive<'_>| {
                primitive
                    .attributes
                    .iter()
                    .filter_map(|(semantic, _)| semantic.target)
                    .max()
                    .map_or(0, |last| last + 1)
            };
            targets += mesh.primitives.iter().map(of_target).max().unwrap_or(0);
            lines += mesh.primitives.iter().filter(|primitive| primitive.mode == Mode::NoFaces).count();
        }
        lost(targets, "morph target", "morph targets");
        lost(lines, "primitive of points or lines", "primitives of points or lines");
        losses.extend(asset.material_names().loss());
        losses.extend(self.losses_of_placing(&asset)?);
        Ok(losses)
    }

    fn losses_of_placing(&self, asset: &Asset<'_>) -> Result<Vec<Loss>, Fault> {
        let placements = self.placed(asset)?;
        let moved = placements.iter().filter(|placement| placement.matrix != Placement::STILL).count();
        let mirrored = placements.iter().filter(|placement| placement.mirrors()).count();
        let mut is_placed = vec![asset.nodes.is_empty(); asset.meshes.len()];
        placements.iter().for_each(|placement| is_placed[placement.part] = true);
        let hidden = is_placed.iter().filter(|&&is_placed| !is_placed).count();
        let transforms = Loss::if_any(LossKind::NodeTransforms, moved, |count| {
            let nodes = one_or_many(count, "node that moves its mesh", "nodes that move their meshes");
            let turned = match mirrored {
                0 => String::new(),
                _ => format!(
                    "; {} its faces turned",
                    one_or_many(mirrored, "mirrors it and has", "mirror it, each with")
                ),
            };
            format!("{nodes}: positions are those in the scene{turned}")
        });
        let hidden = Loss::if_any(LossKind::ScenePart, hidden, |count| {
            one_or_many(
                count,
                "mesh that the scene does not show is left out",
                "meshes that the scene does not show are left out",
            )
        });
        Ok(transforms.into_iter().chain(hidden).collect())
    }
}

fn lights(asset: &Asset<'_>) -> Result<usize, Fault> {
    let Some(extensions) = asset.root.object("extensions")? else { return Ok(0) };
    let lights = extensions.object("KHR_lights_punctual")?;
    lights.map_or(Ok(0), |lights| Ok(lights.items("lights")?.len()))
}

impl Shape for GltfShape {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast::<GltfShape>().is_some_and(|other| self.file.bytes == other.file.bytes)
    }

    fn losses_in(&self, output: Output) -> Vec<Loss> {
        match output {
            Output::OfSameFormat => Vec::new(),
            // The file was opened before, so nothing is wrong with it.
            Output::OfOtherFormat => self.losses().unwrap_or_default(),
        }
    }

    fn is_spliced_into(&self, format: Format) -> bool {
        matches!(format, Format::Glb | Format::Gltf)
    }

    fn splice(&self, document: &Document, splice: &Splice<'_>) -> Option<Result<Spliced, WriteErrorKind>> {
        self.is_spliced_into(splice.format).then(|| splice::splice(&self.file, document, splice))
    }

    fn materials(&self) -> Vec<Material> {
        materials::materials(&self.file).unwrap_or_default()
    }

    fn companions(&self) -> Vec<NamedFile> {
        materials::named_files(&self.file).unwrap_or_default()
    }

    fn placements(&self) -> Option<Vec<Placement>> {
        let asset = self.file.asset().ok()?;
        if asset.nodes.is_empty() { None } else { self.placed(&asset).ok() }
    }
}
