//! Along which closed paths is the surface open? In a component that is a surface these are the classes of boundary edges that
//! share vertices.

use fixedbitset::FixedBitSet;
use meshmend_core::{Classes, VertexId};

use crate::components::Tally;
use crate::error::ExternalError;
use crate::spill::Spill;

/// Counts the classes of boundary edges in the facts of their components.
pub(crate) fn count_loops(boundary: &Spill, vertices: u32, tally: &mut Tally) -> Result<(), ExternalError> {
    if boundary.len(0) == 0 {
        return Ok(());
    }
    let mut classes = Classes::new(vertices as usize);
    each(boundary, |[one, other, _]| {
        classes.join(one, other);
        Ok(())
    })?;
    // The lowest vertex of a class is its root, and the lower end of one of its edges.
    let mut is_counted = FixedBitSet::with_capacity(vertices as usize);
    each(boundary, |[one, _, component]| {
        if classes.root(one) == one && !is_counted.put(one as usize) {
            tally.at(component, VertexId(one))?.loops += 1;
        }
        Ok(())
    })
}

fn each(
    boundary: &Spill,
    mut take: impl FnMut([u32; 3]) -> Result<(), ExternalError>,
) -> Result<(), ExternalError> {
    let mut begun = Vec::new();
    boundary.read(0, |numbers| {
        begun.extend_from_slice(numbers);
        let (edges, rest) = begun.as_chunks::<3>();
        edges.iter().try_for_each(|&edge| take(edge))?;
        begun = rest.to_vec();
        Ok(())
    })
}
