//! Faces as cyclic words: folding spikes, and splitting at repeated letters.
//!
//! A word lists corners by their place in the face; two corners are the same letter when they stand at the same
//! vertex. *Source*: the reference pipeline; the definitions are in the semantics of repairs.

use std::collections::VecDeque;

use meshmend_core::{Column, VertexId};

const NOWHERE: u32 = u32::MAX;

/// Splits faces into simple loops; keeps its memory from face to face.
#[derive(Default)]
pub struct WordSplitter {
    /// For each vertex its place in the loop that is being read.
    place: Column<VertexId, u32>,
}

/// What became of a face's word.
pub struct Loops {
    /// The face without consecutive repeats and spikes, as places in it.
    pub word: Vec<usize>,
    /// Each simple loop of three corners or more, as places in the face; inner loops first.
    pub loops: Vec<Vec<usize>>,
    /// A vertex that the word came back to after spikes were folded.
    pub repeated: Option<VertexId>,
}

impl WordSplitter {
    /// A splitter of faces whose vertices are below a number.
    ///
    /// *Cost*: 4 bytes a vertex.
    pub fn new(vertex_count: usize) -> Self {
        WordSplitter { place: Column::filled(NOWHERE, vertex_count) }
    }

    /// The simple loops of a face.
    ///
    /// *Cost*: linear in its corners.
    pub fn split(&mut self, vertices: &[VertexId]) -> Loops {
        self.simple_loops(folded(vertices), vertices)
    }

    /// Reads the word onto a stack; where a letter recurs, what was read since its first place is a loop.
    fn simple_loops(&mut self, word: Vec<usize>, vertices: &[VertexId]) -> Loops {
        let (mut found, mut repeated, mut stack) = (Vec::new(), None, Vec::<usize>::new());
        for &corner in &word {
            let first = self.place[vertices[corner]];
            if first == NOWHERE {
                self.place[vertices[corner]] = stack.len() as u32;
                stack.push(corner);
                continue;
            }
            repeated.get_or_insert(vertices[corner]);
            let at = first as usize;
            found.push(stack[at..].to_vec());
            for closed in stack.drain(at + 1..) {
                self.place[vertices[closed]] = NOWHERE;
            }
        }
        stack.iter().for_each(|&corner| self.place[vertices[corner]] = NOWHERE);
        found.push(stack);
        found.retain(|corners| corners.len() >= 3);
        Loops { word, loops: found, repeated }
    }
}

/// The word without consecutive repeats (the earlier corner stays) and spikes (x y x becomes the first x): one
/// pass with a stack, then the two ends.
fn folded(vertices: &[VertexId]) -> Vec<usize> {
    let mut word: VecDeque<usize> = VecDeque::with_capacity(vertices.len());
    for (place, vertex) in vertices.iter().enumerate() {
        let from_end = |back: usize| word.len().checked_sub(back).map(|at| vertices[word[at]]);
        if from_end(1) == Some(*vertex) {
            continue;
        }
        if from_end(2) == Some(*vertex) {
            word.pop_back();
        } else {
            word.push_back(place);
        }
    }
    while word.len() > 1 {
        let at = |place: usize| vertices[word[place]];
        let last = word.len() - 1;
        if at(0) == at(last) || (last > 1 && at(last - 1) == at(0)) {
            word.pop_back();
        } else if last > 1 && at(last) == at(1) {
            word.pop_front();
        } else {
            break;
        }
    }
    word.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(face: &[u32]) -> (Vec<Vec<usize>>, Option<u32>) {
        let vertices: Vec<VertexId> = face.iter().copied().map(VertexId).collect();
        let loops = WordSplitter::new(9).split(&vertices);
        (loops.loops, loops.repeated.map(|v| v.0))
    }

    #[test]
    fn a_face_is_split_at_the_first_corner_of_a_repeated_vertex_inner_loop_first() {
        assert_eq!(split(&[0, 1, 2, 0, 3, 4]), (vec![vec![0, 1, 2], vec![0, 4, 5]], Some(0)));
        assert_eq!(split(&[5, 0, 1, 2, 0, 3]), (vec![vec![1, 2, 3], vec![0, 1, 5]], Some(0)));
    }

    #[test]
    fn repeats_and_spikes_are_folded_round_the_ends_too() {
        assert_eq!(split(&[0, 0, 1, 2]), (vec![vec![0, 2, 3]], None));
        assert_eq!(split(&[0, 1, 2, 3, 2]), (vec![vec![0, 1, 2]], None));
        assert_eq!(split(&[3, 0, 1, 2, 0]), (vec![vec![1, 2, 3]], None));
        assert_eq!(split(&[0, 1, 2, 0, 3]), (vec![vec![0, 1, 2]], None));
        assert_eq!(split(&[0, 1, 2, 1]), (vec![], None));
    }

    #[test]
    fn a_face_walked_out_and_back_leaves_nothing() {
        let out_and_back: Vec<u32> = (0..9).chain((1..8).rev()).collect();
        assert_eq!(split(&out_and_back), (vec![], None));
        assert_eq!(split(&[]), (vec![], None));
        assert_eq!(split(&[4]), (vec![], None));
    }

    #[test]
    fn the_splitter_can_be_used_again() {
        let mut splitter = WordSplitter::new(9);
        let face = [0, 1, 2, 0, 3, 4].map(VertexId);
        let first = splitter.split(&face).loops;
        assert_eq!(splitter.split(&face).loops, first);
    }
}
