//! The document of a mesh that is put together cell by cell.

use meshmend_core::{Cell, Connectivity, EdgeUse, PolygonMesh};
use meshmend_io::{Note, ReadFile};
use meshmend_repair::{Distance, PassError};
use meshmend_topology::{Effect, Incremental, Instigators, Reason, incremental, patches};
use serde::Serialize;

use super::{Listing, SCHEMA};
use crate::View;

/// The Betti numbers over ℤ/2 as vertices, edges and faces are added, with the list of steps cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct IncrementalDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that the mesh is from, if it is from one.
    pub file: Option<String>,
    /// Which form of which format the file has, such as `ply-le`.
    pub format: Option<&'static str>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// The Betti numbers in the end.
    pub betti: [Option<u64>; 3],
    /// Why β₁ and β₂ are absent, if they are.
    pub betti_unknown: Option<Reason>,
    /// How many cells of each kind start and fill cycles.
    pub instigators: Instigators,
    /// The cells in the order in which they are added.
    pub steps: Listing<RunningStep>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

/// A cell that is added, what it does, and the numbers after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RunningStep {
    /// The cell.
    #[serde(flatten)]
    pub cell: Cell,
    /// What it does; absent where that is not known.
    pub effect: Option<Effect>,
    /// β₀, β₁ and β₂ after it.
    pub betti: [Option<u64>; 3],
}

impl IncrementalDocument {
    /// The document of a mesh in a view, with at most `limit` steps, and all the steps.
    ///
    /// # Errors
    /// When the view's distance is not a finite, non-negative number.
    ///
    /// *Cost*: that of [`incremental`].
    pub fn new(mesh: &PolygonMesh, view: View, limit: usize) -> Result<(Self, Incremental), PassError> {
        let viewed = view.of(mesh)?;
        let kernel = EdgeUse::assemble(viewed.complex());
        let built = incremental(&kernel, &patches(&kernel));
        let running = built.steps().iter().zip(built.running_betti());
        let steps = running.map(|(step, betti)| RunningStep { cell: step.cell, effect: step.effect, betti });
        let betti = built.running_betti().last().unwrap_or([Some(0); 3]);
        let document = IncrementalDocument {
            schema: SCHEMA,
            file: None,
            format: None,
            view: view.name(),
            weld: view.distance(),
            betti,
            betti_unknown: betti.contains(&None).then_some(Reason::EliminationBudget),
            instigators: built.instigators(),
            steps: Listing::cut(steps, limit),
            notes: Vec::new(),
        };
        Ok((document, built))
    }

    /// The document with what is known of the file that the mesh was read from.
    pub fn of_file(self, name: String, file: &ReadFile) -> Self {
        let format = Some(file.variant);
        IncrementalDocument { file: Some(name), format, notes: file.notes.clone(), ..self }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, VertexId};
    use serde_json::json;

    use super::*;

    #[test]
    fn steps_are_told_by_cell_and_effect() {
        let corners = [0, 1, 2, 2, 1, 0].map(VertexId).to_vec();
        let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], FaceTable::triangles(3, corners).unwrap()).unwrap();
        let (document, built) = IncrementalDocument::new(&mesh, View::Indexed, 4).unwrap();
        assert_eq!(built.steps().len(), 8);
        let document = serde_json::to_value(document).unwrap();
        assert_eq!(document["betti"], json!([1, 0, 1]));
        assert_eq!(document["steps"]["count"], 8);
        let joining = json!({"edge": 0, "effect": "fills", "betti": [2, 0, 0]});
        assert_eq!(document["steps"]["items"][3], joining);
        assert_eq!(
            document["instigators"],
            json!({"v_n": 0, "v_c": 3, "e_n": 2, "e_c": 1, "f_c": 1, "f_n": 1})
        );
    }
}
