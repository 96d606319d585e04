//! Which capabilities a mesh needs, so that a kernel that claims one too much is found out.

use meshmend_core::{Capabilities, Complex, admission};

/// A capability by which meshes are admitted.
struct Capability {
    name: &'static str,
    has: fn(&Capabilities) -> bool,
    /// All capabilities but this one.
    others: Capabilities,
}

const ALL: Capabilities = Capabilities::PERMISSIVE;

const EACH: [Capability; 5] = [
    Capability {
        name: "non_simple_faces",
        has: |able| able.non_simple_faces,
        others: Capabilities { non_simple_faces: false, ..ALL },
    },
    Capability {
        name: "non_manifold_edges",
        has: |able| able.non_manifold_edges,
        others: Capabilities { non_manifold_edges: false, ..ALL },
    },
    Capability {
        name: "non_manifold_vertices",
        has: |able| able.non_manifold_vertices,
        others: Capabilities { non_manifold_vertices: false, ..ALL },
    },
    Capability {
        name: "mixed_orientation",
        has: |able| able.mixed_orientation,
        others: Capabilities { mixed_orientation: false, ..ALL },
    },
    Capability {
        name: "polygons",
        has: |able| able.polygons,
        others: Capabilities { polygons: false, ..ALL },
    },
];

/// The capabilities that a kernel claims, one bit each.
pub(crate) fn claimed(capabilities: &Capabilities) -> u8 {
    bits(|each| (each.has)(capabilities))
}

/// The capabilities without which a complex is not admitted.
pub(crate) fn needed(complex: &Complex) -> u8 {
    bits(|each| !admission(complex, &each.others).is_empty())
}

/// Their names, in a row.
pub(crate) fn names(capabilities: u8) -> String {
    let chosen = EACH.iter().enumerate().filter(|(bit, _)| capabilities >> bit & 1 == 1);
    let names: Vec<String> = chosen.map(|(_, each)| format!("CAPABILITIES.{}", each.name)).collect();
    names.join(" and ")
}

fn bits(is_set: impl Fn(&Capability) -> bool) -> u8 {
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
