//! Every set of triangles over a few vertices.

/// Every set of oriented triangles over `vertices` vertices: each triple absent, one way round, or the other.
///
/// Over four vertices there are 81, over five 59 049.
pub fn oriented_triangle_sets(vertices: u32) -> impl Iterator<Item = Vec<Vec<u32>>> {
    let triples = triples(vertices);
    (0..3u32.pow(triples.len() as u32)).map(move |code| oriented_set(&triples, code))
}

/// The set of oriented triangles whose digits to base 3 are the number's.
pub(super) fn oriented_set(triples: &[[u32; 3]], code: u32) -> Vec<Vec<u32>> {
    let mut digits = code;
    let mut faces = Vec::new();
    for &[a, b, c] in triples {
        match digits % 3 {
            0 => {}
            1 => faces.push(vec![a, b, c]),
            _ => faces.push(vec![a, c, b]),
        }
        digits /= 3;
    }
    faces
}

/// Every set of triangles over `vertices` vertices, each ascending: 2²⁰ over six.
pub fn triangle_sets(vertices: u32) -> impl Iterator<Item = Vec<Vec<u32>>> {
    let triples = triples(vertices);
    (0..1usize << triples.len()).map(move |code| {
        let chosen = triples.iter().enumerate().filter(|(bit, _)| code >> bit & 1 == 1);
        chosen.map(|(_, triple)| triple.to_vec()).collect()
    })
}

/// Every three of the first vertices, ascending.
pub(super) fn triples(vertices: u32) -> Vec<[u32; 3]> {
    let pairs = (0..vertices).flat_map(move |a| (a + 1..vertices).map(move |b| [a, b]));
    pairs.flat_map(move |[a, b]| (b + 1..vertices).map(move |c| [a, b, c])).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn small_worlds_are_complete_and_without_repeats() {
        assert_eq!(oriented_triangle_sets(4).collect::<BTreeSet<_>>().len(), 81);
        assert_eq!(oriented_triangle_sets(5).count(), 59_049);
        assert_eq!(triangle_sets(5).collect::<BTreeSet<_>>().len(), 1 << 10);
        assert_eq!(triangle_sets(6).count(), 1 << 20);
        assert_eq!(triangle_sets(6).last().map(|faces| faces.len()), Some(20));
    }
}
