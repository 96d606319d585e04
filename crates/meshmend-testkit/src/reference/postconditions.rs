//! What the default repair promises of its result.

use std::collections::{BTreeMap, BTreeSet};

use super::corners::{Classes, bases, canonical};

/// Every promise that faces over `vertex_count` vertices break: faces that are not simple or repeat another, edges of
/// degree three or more, vertices with more than one umbrella, unreferenced vertices.
pub fn broken_postconditions(vertex_count: usize, faces: &[Vec<u32>]) -> Vec<String> {
    let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
    let mut sides: BTreeMap<[u32; 2], Vec<(usize, usize)>> = BTreeMap::new();
    for (f, word) in faces.iter().enumerate() {
        if word.len() < 3 || word.iter().collect::<BTreeSet<_>>().len() < word.len() {
            found.push(format!("face {f} is not simple: {word:?}"));
        }
        if !seen.insert(canonical(word)) {
            found.push(format!("face {f} is a duplicate"));
        }
        for i in 0..word.len() {
            let (a, b) = (word[i], word[(i + 1) % word.len()]);
            sides.entry([a.min(b), a.max(b)]).or_default().push((f, i));
        }
    }
    let base = bases(faces.iter().map(Vec::len));
    let mut umbrellas = Classes::new(base[faces.len()]);
    for (ends, here) in &sides {
        if here.len() > 2 {
            let ends: BTreeSet<_> = ends.iter().collect();
            let ends: Vec<_> = ends.into_iter().collect();
            found.push(format!("edge {ends:?} has degree {}", here.len()));
        }
        for &v in ends {
            let at = |&(f, i): &(usize, usize)| {
                base[f] + if faces[f][i] == v { i } else { (i + 1) % faces[f].len() }
            };
            here[1..].iter().for_each(|side| umbrellas.join(at(&here[0]), at(side)));
        }
    }
    let mut of_vertex = BTreeMap::new();
    for (f, word) in faces.iter().enumerate() {
        for (i, &v) in word.iter().enumerate() {
            let root = umbrellas.root(base[f] + i);
            if *of_vertex.entry(v).or_insert(root) != root {
                found.push(format!("vertex {v} has more than one umbrella"));
            }
        }
    }
    if of_vertex.len() != vertex_count {
        found.push("an unreferenced vertex is left".into());
    }
    found
}
