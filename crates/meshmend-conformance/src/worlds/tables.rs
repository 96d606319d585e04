//! Every small table: faces of any length, with corners repeated at will.

/// Every table of one face of up to five corners over four vertices, and of two faces of up to three corners over three
/// vertices: degenerate faces, faces that come back to a vertex, and faces over the same vertices among them.
pub(super) fn small_tables() -> impl Iterator<Item = (u32, Vec<Vec<u32>>)> {
    let one = words(4, 5).into_iter().map(|face| (4, vec![face]));
    let few = words(3, 3);
    let two = few
        .clone()
        .into_iter()
        .flat_map(move |first| few.clone().into_iter().map(move |second| (3, vec![first.clone(), second])));
    one.chain(two)
}

/// Every list of up to so many of the first numbers, the shorter ones first.
fn words(letters: u32, most: usize) -> Vec<Vec<u32>> {
    let mut words = vec![Vec::new()];
    let mut from = 0;
    for _ in 0..most {
        let until = words.len();
        for place in from..until {
            for letter in 0..letters {
                let mut longer = words[place].clone();
                longer.push(letter);
                words.push(longer);
            }
        }
        from = until;
    }
    words
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_word_is_there_once() {
        let words = words(4, 5);
        assert_eq!(words.len(), 1 + 4 + 16 + 64 + 256 + 1024);
        assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), words.len());
        assert_eq!(small_tables().count(), words.len() + 40 * 40);
    }
}
