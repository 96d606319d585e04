//! What a package has beside its meshes, and what another format would not carry.

use crate::document::{Document, Placement};
use crate::formats::threemf::kept::Package;
use crate::formats::threemf::splice;
use crate::shell::{Output, Shape, Splice, Spliced};
use crate::{Format, Loss, Material, WriteErrorKind};

impl Shape for Package {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast().is_some_and(|other: &Package| self.bytes == other.bytes)
    }

    fn losses_in(&self, output: Output) -> Vec<Loss> {
        match output {
            Output::OfSameFormat => Vec::new(),
            Output::OfOtherFormat => {
                self.extras.losses().into_iter().chain(self.material_names.loss()).collect()
            }
        }
    }

    fn materials(&self) -> Vec<Material> {
        self.materials.clone()
    }

    fn placements(&self) -> Option<Vec<Placement>> {
        self.assembly.placements()
    }

    fn is_spliced_into(&self, format: Format) -> bool {
        format == Format::ThreeMf
    }

    fn splice(&self, document: &Document, wanted: &Splice<'_>) -> Option<Result<Spliced, WriteErrorKind>> {
        self.is_spliced_into(wanted.format).then(|| splice::spliced(self, document))
    }
}
