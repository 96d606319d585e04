//! How generators and cut graphs are chosen.

use meshmend_core::{Column, EdgeId, Watch};

use super::co_tree::CoTree;
use super::roots::Roots;

/// How generators and cut graphs are chosen; by default with as few edges as a tree from the lowest vertex gives.
#[derive(Clone, Copy, Debug, Default)]
pub struct GeneratorOptions<'a> {
    /// The length of each edge; without, and in components where they can't be added up, edges are counted.
    pub lengths: Option<&'a Column<EdgeId, f64>>,
    /// Which edges the tree of the faces takes first.
    pub co_tree: CoTree,
    /// Where the trees of the vertices begin.
    pub roots: Roots,
    /// Who watches, and may stop it; nobody if nobody is named.
    pub watch: Option<&'a Watch>,
}

/// Stands for nobody.
static NOBODY: Watch = Watch::NOBODY;

impl<'a> GeneratorOptions<'a> {
    /// Who watches.
    pub fn watch(&self) -> &'a Watch {
        self.watch.unwrap_or(&NOBODY)
    }
}
