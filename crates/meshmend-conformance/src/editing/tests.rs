//! Editors that make the usual mistakes, and the laws that notice.

use super::model::{declared, makes_a_pillow, naive};
use super::surface::Surface;
use super::*;

/// An editor that is nothing but lists: what it may do it finds out by doing it. The undo of most operators is left out.
struct Lists<const MISTAKE: u8> {
    surface: Surface,
    next: u32,
}

/// The usual mistakes.
const NONE: u8 = 0;
const SHRINKS_A_TETRAHEDRON: u8 = 1;
const ASKS_NOTHING: u8 = 2;
const REFUSES_TOO_MUCH: u8 = 3;
const CHANGES_AND_REFUSES: u8 = 4;
const UNDOES_ELSEWHERE: u8 = 5;
const LOSES_A_FACE: u8 = 6;
const KNOWS_WHAT_IS_GONE: u8 = 7;
/// None, and offers just what it can undo.
const UNDOES: u8 = 8;

impl<const MISTAKE: u8> Editing for Lists<MISTAKE> {
    const NAME: &'static str = "lists";

    fn begin(vertices: usize, faces: &[Vec<u32>]) -> Self {
        Lists { surface: Surface::of(faces.to_vec()).unwrap(), next: vertices as u32 }
    }

    fn apply(&mut self, operator: &Operator) -> Result<Edited, Vec<String>> {
        let refused = || vec!["it would break something".to_owned()];
        let before = self.surface.clone();
        if MISTAKE == KNOWS_WHAT_IS_GONE
            && matches!(operator, Operator::JoinEdges(v) if before.star(*v).is_empty())
        {
            return Ok(Edited { vertices: Vec::new(), undo: operator.clone() });
        }
        let faces = naive(&before, operator, &[self.next]).ok_or_else(refused)?;
        let after = Surface::of(faces).ok_or_else(refused)?;
        let lost = match *operator {
            Operator::Collapse(side) if MISTAKE != SHRINKS_A_TETRAHEDRON => makes_a_pillow(&before, side),
            Operator::Flip(_) => MISTAKE == REFUSES_TOO_MUCH,
            _ => false,
        };
        let (change, _) = declared(&before, operator).ok_or_else(refused)?;
        let is_declared = after.figures().edges - before.figures().edges == change.edges
            && after.figures().vertices - before.figures().vertices == change.vertices
            && after.figures().holes - before.figures().holes == change.holes;
        if MISTAKE == CHANGES_AND_REFUSES && !is_declared {
            self.surface = after;
            return Err(refused());
        }
        if lost || !(is_declared || MISTAKE == ASKS_NOTHING) {
            return Err(refused());
        }
        self.surface = after;
        if MISTAKE == LOSES_A_FACE && matches!(operator, Operator::Poke(_)) {
            let fewer = self.surface.faces[1..].to_vec();
            self.surface = Surface::of(fewer).ok_or_else(refused)?;
        }
        let new = self.next;
        self.next += 1;
        let is_new = self.surface.vertices().contains(&new);
        let vertices = if is_new { vec![new] } else { Vec::new() };
        Ok(Edited { vertices, undo: self.undo(operator, new) })
    }

    fn faces(&self) -> Vec<Vec<u32>> {
        self.surface.faces.clone()
    }

    fn offers(kind: Kind) -> bool {
        let is_undone = matches!(kind, Kind::SplitEdge | Kind::Poke);
        let is_not = matches!(kind, Kind::Flip | Kind::Collapse | Kind::OpenFace | Kind::JoinEdges);
        is_undone || is_not && MISTAKE != UNDOES && MISTAKE != UNDOES_ELSEWHERE
    }
}

impl<const MISTAKE: u8> Lists<MISTAKE> {
    fn undo(&self, operator: &Operator, new: u32) -> Operator {
        match *operator {
            Operator::SplitEdge(side) if MISTAKE == UNDOES_ELSEWHERE => Operator::SplitEdge(side),
            Operator::SplitEdge(_) => Operator::JoinEdges(new),
            Operator::Poke(_) => Operator::RemoveVertex(new),
            ref other => other.clone(),
        }
    }
}

fn breaks<const MISTAKE: u8>(law: EditLaw) -> bool {
    edit_law::<Lists<MISTAKE>>(law).is_err()
}

#[test]
fn each_of_the_usual_mistakes_breaks_its_law() {
    assert!(breaks::<SHRINKS_A_TETRAHEDRON>(EditLaw::Cause));
    assert!(breaks::<ASKS_NOTHING>(EditLaw::Cause));
    assert!(breaks::<ASKS_NOTHING>(EditLaw::Euler));
    assert!(breaks::<REFUSES_TOO_MUCH>(EditLaw::Cause));
    assert!(breaks::<CHANGES_AND_REFUSES>(EditLaw::Unchanged));
    assert!(breaks::<LOSES_A_FACE>(EditLaw::Euler));
    assert!(breaks::<KNOWS_WHAT_IS_GONE>(EditLaw::Stale));
    assert!(breaks::<UNDOES_ELSEWHERE>(EditLaw::Inverse));
}

#[test]
fn an_editor_without_a_mistake_keeps_the_laws() {
    for law in [EditLaw::Valid, EditLaw::Euler, EditLaw::Unchanged, EditLaw::Cause, EditLaw::Stale] {
        assert_eq!(edit_law::<Lists<NONE>>(law), Ok(()));
    }
    assert_eq!(edit_law::<Lists<UNDOES>>(EditLaw::Inverse), Ok(()));
}

#[test]
fn the_verdict_names_the_law_the_faces_and_the_operator() {
    let verdict = edit_law::<Lists<SHRINKS_A_TETRAHEDRON>>(EditLaw::Cause).unwrap_err();
    let expected = "lists breaks the law `cause`: what is refused would break the surface, and what is done does what it \
        should.\n\n  begin with [0, 2, 1] [0, 1, 3] [0, 3, 2] [1, 2, 3]\n  Collapse([0, 1])\n\n  it is done, but two \
        triangles would lie on each other";
    assert_eq!(verdict, expected);
}
