//! Editing: whatever operators come one after the other, every law of editors holds, and what comes of them is true.

use arbitrary::{Arbitrary, Result, Unstructured};
use meshmend_edit::Editor;
use meshmend_testkit::Soup;
use meshmend_testkit::edits::{Draw, Editing, Indexed, edit_laws};
use meshmend_testkit::laws::Change;

use crate::input::SmallMesh;

/// The most operators that are applied.
const MOST_OPERATORS: usize = 40;

/// Operators on a small mesh: the surface stays valid, its figures change as they should, a refusal changes nothing and has a
/// cause, an undo undoes, and the record of the result is true.
pub fn edit(data: &[u8]) {
    let mut u = Unstructured::new(data);
    let Ok((soup, draws)) = start(&mut u).and_then(|soup| Ok((soup, draws(&mut u)?))) else { return };
    let mesh = soup.numbered();
    if Editor::new(&mesh).is_err() {
        return;
    }
    assert_eq!(edit_laws::<Indexed>(&soup.faces, &draws), Ok(()));
    let mut indexed = Indexed::of(&mesh);
    for draw in draws {
        if let Some(operator) = draw.operator(&indexed.faces()) {
            let _ = indexed.apply(&operator);
        }
    }
    let (after, record) = indexed.editor.finish().expect("it is small");
    let change = Change { before: &mesh, after: &after, record: &record };
    assert_eq!(change.record_law(), Ok(()));
    assert_eq!(change.bit_law(), Ok(()));
    assert_eq!(change.attribute_law(), Ok(()));
    assert!(Editor::new(&after).is_ok());
}

/// A surface that is known to be one, or any mesh.
fn start(u: &mut Unstructured<'_>) -> Result<Soup> {
    let faces: &[&[u32]] = match u.int_in_range(0..=6u8)? {
        0 => return SmallMesh::arbitrary(u).map(|mesh| mesh.0),
        1 => &[&[0, 1, 2]],
        2 => &[&[0, 1, 2, 3, 4]],
        3 => &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]],
        4 => &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        5 => &[&[0, 1, 2], &[2, 1, 0], &[3, 4, 5, 6]],
        _ => return Ok(torus()),
    };
    let most = faces.iter().copied().flatten().max().map_or(0, |&vertex| vertex as usize);
    Ok(Soup::generic(most + 1, faces))
}

fn torus() -> Soup {
    let vertex = |x: u32, y: u32| x % 3 + 3 * (y % 3);
    let quad = |at: u32| {
        let (x, y) = (at % 3, at / 3);
        [vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)]
    };
    Soup::generic(9, (0..9).map(quad))
}

fn draws(u: &mut Unstructured<'_>) -> Result<Vec<Draw>> {
    let mut draws = Vec::new();
    while draws.len() < MOST_OPERATORS && !u.is_empty() {
        let kind: u8 = u.arbitrary()?;
        let at: [u8; 3] = u.arbitrary()?;
        draws.push(Draw::new(kind.into(), at.map(u64::from)));
    }
    Ok(draws)
}
