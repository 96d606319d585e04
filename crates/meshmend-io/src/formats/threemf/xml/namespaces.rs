//! Which vocabulary a prefix stands for.

/// The vocabularies of 3MF that matter here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::formats::threemf) enum Space {
    /// Models, objects, meshes, the build. A tag without a namespace is taken as one of these.
    Core,
    /// Models of several parts.
    Production,
    /// Slices.
    Slice,
    /// Beams, and balls at their ends.
    Lattice,
    /// Named sets of triangles.
    TriangleSets,
    /// Any other.
    Other,
}

const KNOWN: [(&str, Space); 8] = [
    ("http://schemas.microsoft.com/3dmanufacturing/core/2015/02", Space::Core),
    ("http://schemas.microsoft.com/3dmanufacturing/2013/01", Space::Core),
    ("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel", Space::Core),
    ("http://schemas.microsoft.com/3dmanufacturing/production/2015/06", Space::Production),
    ("http://schemas.microsoft.com/3dmanufacturing/slice/2015/07", Space::Slice),
    ("http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02", Space::Lattice),
    ("http://schemas.microsoft.com/3dmanufacturing/beamlattice/balls/2020/07", Space::Lattice),
    ("http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07", Space::TriangleSets),
];

/// What prefixes stand for at one place of a text.
#[derive(Debug, Default)]
pub(super) struct Namespaces<'a> {
    /// Each declaration that holds here, with the depth of its tag.
    declared: Vec<(usize, &'a str, Space)>,
}

/// More declarations at one place than any program writes.
const MOST: usize = 256;

impl<'a> Namespaces<'a> {
    /// Takes in what an attribute of a tag declares. Returns whether there is still room.
    pub(super) fn declare(&mut self, depth: usize, name: &'a str, value: &str) -> bool {
        let prefix = match name.strip_prefix("xmlns") {
            Some("") => "",
            Some(rest) => match rest.strip_prefix(':') {
                Some(prefix) => prefix,
                None => return true,
            },
            None => return true,
        };
        let known = KNOWN.iter().find(|(name, _)| *name == value.trim());
        let space =
            known.map_or(if value.is_empty() { Space::Core } else { Space::Other }, |(_, space)| *space);
        self.declared.push((depth, prefix, space));
        self.declared.len() <= MOST
    }

    /// Forgets what tags below a depth declared.
    pub(super) fn leave(&mut self, depth: usize) {
        while self.declared.last().is_some_and(|(declared, ..)| *declared > depth) {
            self.declared.pop();
        }
    }

    /// The vocabulary of a name, and the name without its prefix.
    pub(super) fn resolved<'n>(&self, name: &'n str) -> (Space, &'n str) {
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        let found = self.declared.iter().rev().find(|(_, declared, _)| *declared == prefix);
        let unknown = if prefix.is_empty() { Space::Core } else { Space::Other };
        (found.map_or(unknown, |(.., space)| *space), local)
    }
}
