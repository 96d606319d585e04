//! Where a statement stands that belongs before an element: comments between the elements of a file.
//!
//! Such a statement's key ends in `@` and the element: `comment@f7` stands before face 7. A change that removes elements
//! moves it before the next element that is left.

use crate::{Draft, Id, Metadata, Sources};

/// The statements of a file after a change.
///
/// *Cost*: constant for statements about the file as a whole; linear in the new vertices and faces where any stands before one.
pub(crate) fn carried(metadata: &[Metadata], draft: &Draft) -> Vec<Metadata> {
    let vertices = Successors::of(metadata, "v", &draft.vertex_sources);
    let faces = Successors::of(metadata, "f", &draft.face_sources);
    let moved = |statement: &Metadata| match statement.anchor() {
        Some((sign @ "v", vertex)) => statement.moved_to(sign, vertices.after(vertex)),
        Some((sign @ "f", face)) => statement.moved_to(sign, faces.after(face)),
        _ => statement.clone(),
    };
    metadata.iter().map(moved).collect()
}

/// For some old elements, the first new one that comes from it or from one after it.
struct Successors {
    old: Vec<usize>,
    new: Vec<usize>,
}

impl Successors {
    fn of<I: Id>(metadata: &[Metadata], sign: &str, sources: &Sources<I>) -> Self {
        let anchors = metadata.iter().filter_map(Metadata::anchor);
        let mut old: Vec<usize> = anchors.filter(|(of, _)| *of == sign).map(|(_, element)| element).collect();
        old.sort_unstable();
        old.dedup();
        let mut new = vec![(usize::MAX, sources.len()); old.len()];
        if !old.is_empty() {
            for (element, source) in sources.iter() {
                let Some(source) = source.map(Id::index) else { continue };
                // It comes after all anchors up to its source; the last of them speaks for those before it.
                let Some(last) = old.partition_point(|&anchor| anchor <= source).checked_sub(1) else {
                    continue;
                };
                new[last] = new[last].min((source, element.index()));
            }
        }
        for at in (1..new.len()).rev() {
            new[at - 1] = new[at - 1].min(new[at]);
        }
        Successors { old, new: new.into_iter().map(|(_, element)| element).collect() }
    }

    /// The new element that an anchor at an old one stands before.
    fn after(&self, old: usize) -> usize {
        self.old.binary_search(&old).map_or(old, |at| self.new[at])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceId;

    fn statement(key: &str) -> Metadata {
        Metadata { key: key.to_owned(), value: b"text".to_vec() }
    }

    #[test]
    fn a_key_says_what_a_statement_is_and_where_it_stands() {
        let read = |key: &str| {
            let statement = statement(key);
            (statement.kind().to_owned(), statement.anchor().map(|(sign, at)| (sign.to_owned(), at)))
        };
        assert_eq!(read("comment"), ("comment".to_owned(), None));
        assert_eq!(read("comment@vt12"), ("comment".to_owned(), Some(("vt".to_owned(), 11))));
        for key in ["comment@", "comment@f", "comment@f0", "comment@fx", "comment@f99999999999999999999999"] {
            assert_eq!(read(key), ("comment".to_owned(), None), "{key}");
        }
    }

    #[test]
    fn a_statement_moves_before_the_next_element_that_is_left() {
        let metadata: Vec<Metadata> =
            [0, 1, 2, 5, 9].map(|face| statement(&format!("comment@f{}", face + 1))).into();
        let moved = |sources: &[Option<u32>]| -> Vec<usize> {
            let sources: Sources<FaceId> = Sources::listed(sources.iter().map(|s| s.map(FaceId)));
            let successors = Successors::of(&metadata, "f", &sources);
            metadata.iter().filter_map(|m| Some(successors.after(m.anchor()?.1))).collect()
        };
        assert_eq!(moved(&[0, 1, 2, 3, 4, 5].map(Some)), [0, 1, 2, 5, 6]);
        // Face 1 is gone, and so are all from 4 on.
        assert_eq!(moved(&[0, 2, 3].map(Some)), [0, 1, 1, 3, 3]);
        // Face 0 fell into two, a face was created, and 2 stands before 1.
        assert_eq!(moved(&[Some(0), Some(0), None, Some(2), Some(1), Some(6)]), [0, 4, 3, 5, 6]);
        assert_eq!(moved(&[]), [0, 0, 0, 0, 0]);
    }
}
