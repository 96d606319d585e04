//! Which capabilities a mesh needs, so that a kernel that claims one too much is found out.

use meshmend_core::{Capabilities, Complex, admission};

/// The capabilities by which meshes are admitted: the name, whether a kernel has it, and all but it.
const EACH: [(&str, fn(&Capabilities) -> bool, Capabilities); 5] = {
    const ALL: Capabilities = Capabilities::PERMISSIVE;
    [
        ("non_simple_faces", |able| able.non_simple_faces, Capabilities { non_simple_faces: false, ..ALL }),
        (
            "non_manifold_edges",
            |able| able.non_manifold_edges,
            Capabilities { non_manifold_edges: false, ..ALL },
        ),
        (
            "non_manifold_vertices",
            |able| able.non_manifold_vertices,
            Capabilities { non_manifold_vertices: false, ..ALL },
        ),
        (
            "mixed_orientation",
            |able| able.mixed_orientation,
            Capabilities { mixed_orientation: false, ..ALL },
        ),
        ("polygons", |able| able.polygons, Capabilities { polygons: false, ..ALL }),
    ]
};

/// The capabilities that a kernel claims, one bit each.
pub(crate) fn claimed(capabilities: &Capabilities) -> u8 {
    bits(|(_, has, _)| has(capabilities))
}

/// The capabilities without which a complex is not admitted.
pub(crate) fn needed(complex: &Complex) -> u8 {
    bits(|(_, _, without)| !admission(complex, without).is_empty())
}

/// Their names, in a row.
pub(crate) fn names(capabilities: u8) -> String {
    let chosen = EACH.iter().enumerate().filter(|(bit, _)| capabilities >> bit & 1 == 1);
    let names: Vec<String> = chosen.map(|(_, (name, ..))| format!("CAPABILITIES.{name}")).collect();
    names.join(" and ")
}

fn bits(is_set: impl Fn(&(&str, fn(&Capabilities) -> bool, Capabilities)) -> bool) -> u8 {
    EACH.iter().enumerate().map(|(bit, each)| u8::from(is_set(each)) << bit).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Soup;

    #[test]
    fn a_mesh_needs_what_admits_it() {
        let needs = |faces: &[&[u32]]| names(needed(&Soup::generic(6, faces).complex()));
        assert_eq!(needs(&[&[0, 1, 2], &[0, 2, 3]]), "");
        assert_eq!(needs(&[&[0, 1, 2], &[0, 3, 2]]), "CAPABILITIES.mixed_orientation");
        assert_eq!(needs(&[&[0, 1, 2, 3]]), "CAPABILITIES.polygons");
        let book = needs(&[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]);
        assert_eq!(book, "CAPABILITIES.non_manifold_edges and CAPABILITIES.non_manifold_vertices");
        assert_eq!(claimed(&Capabilities::PERMISSIVE), 0b11111);
        assert_eq!(
            names(claimed(&Capabilities::SURFACES)),
            "CAPABILITIES.mixed_orientation and CAPABILITIES.polygons"
        );
    }
}
