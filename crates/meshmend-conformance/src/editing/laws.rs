//! The laws, and over which surfaces they are asked.

use std::collections::BTreeSet;
use std::fmt::Debug;

use super::drawn::{Draw, Numbers, all_operators, operators_at};
use super::inverse::same_up_to_names;
use super::model::{declared, makes_a_pillow, naive};
use super::surface::{Surface, canonical};
use super::{Edited, Editing, Operator};
use crate::worlds::oriented_triangle_sets;
use crate::{Effort, Settings};

/// A law of editors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EditLaw {
    /// After any operators the faces are those of an oriented manifold.
    Valid,
    /// The numbers of vertices, edges, faces, holes and components change as the operator says.
    Euler,
    /// A call that is refused changes nothing.
    Unchanged,
    /// The call that undoes an operator is not refused, and gives the faces before, up to the names of vertices.
    Inverse,
    /// What is refused would break the surface or change its class, and what is done gives just the faces that it should.
    Cause,
    /// A call that names a vertex that is gone is refused.
    Stale,
}

impl EditLaw {
    /// All of them.
    pub const ALL: [EditLaw; 6] = [
        EditLaw::Valid,
        EditLaw::Euler,
        EditLaw::Unchanged,
        EditLaw::Inverse,
        EditLaw::Cause,
        EditLaw::Stale,
    ];

    /// The word for it.
    pub fn id(self) -> &'static str {
        match self {
            EditLaw::Valid => "valid",
            EditLaw::Euler => "euler",
            EditLaw::Unchanged => "unchanged",
            EditLaw::Inverse => "inverse",
            EditLaw::Cause => "cause",
            EditLaw::Stale => "stale",
        }
    }

    /// What it says.
    pub fn sentence(self) -> &'static str {
        match self {
            EditLaw::Valid => "after any operators the faces are those of an oriented manifold",
            EditLaw::Euler => "an operator changes the figures of the surface as it says",
            EditLaw::Unchanged => "a call that is refused changes nothing",
            EditLaw::Inverse => "the call that undoes an operator gives the faces before, up to names",
            EditLaw::Cause => "what is refused would break the surface, and what is done does what it should",
            EditLaw::Stale => "a call that names a vertex that is gone is refused",
        }
    }
}

/// How many random operators are applied one after the other.
const LONGEST: usize = 60;

/// How many random sequences are asked about.
fn sequences(effort: Effort) -> u64 {
    match effort {
        Effort::Quick => 60,
        Effort::Usual => 400,
        Effort::Thorough => 20_000,
    }
}

/// Asks one law of an editor: with every operator on every oriented surface of triangles over four vertices, and over five up
/// to names; and with random operators one after the other.
///
/// # Errors
/// A verdict with the fewest faces, or the fewest operators, that break the law; or a setting of the environment that is none.
pub fn edit_law<E: Editing>(law: EditLaw) -> Result<(), String> {
    for surface in small_surfaces() {
        for operator in all_operators(&surface) {
            let mut editor = E::begin(vertex_count(&surface), &surface.faces);
            step(law, &mut editor, &surface, &operator)
                .map_err(|wrong| verdict::<E>(law, &surface, &[operator], &wrong))?;
        }
    }
    let starts = starts();
    let mut numbers = Numbers(1);
    for round in 0..sequences(Settings::from_environment()?.effort) {
        let start = &starts[(round % starts.len() as u64) as usize];
        let draws: Vec<Draw> = (0..LONGEST).map(|_| numbers.draw()).collect();
        if run::<E>(law, start, &draws).is_err() {
            return Err(shrunk::<E>(law, start, draws));
        }
    }
    Ok(())
}

/// Asks all laws about random operators, one after the other, that begin with some faces; of faces that a half-edge structure
/// does not hold nothing is asked.
///
/// # Errors
/// A verdict with the fewest operators that break a law.
pub fn edit_laws<E: Editing>(faces: &[Vec<u32>], draws: &[Draw]) -> Result<(), String> {
    let Some(start) = Surface::of(faces.to_vec()) else { return Ok(()) };
    for law in EditLaw::ALL {
        if run::<E>(law, &start, draws).is_err() {
            return Err(shrunk::<E>(law, &start, draws.to_vec()));
        }
    }
    Ok(())
}

/// Applies operators one after the other; or the operators up to the one that breaks the law, and what is wrong.
fn run<E: Editing>(law: EditLaw, start: &Surface, draws: &[Draw]) -> Result<(), (Vec<Operator>, String)> {
    let mut editor = E::begin(vertex_count(start), &start.faces);
    let (mut surface, mut applied) = (start.clone(), Vec::new());
    for draw in draws {
        let Some(operator) = draw.on(&surface) else { continue };
        applied.push(operator.clone());
        step(law, &mut editor, &surface, &operator)
            .map_err(|wrong| (applied.clone(), format!("{wrong}\n  before it: {:?}", surface.faces)))?;
        let faces = editor.faces();
        surface = match Surface::of(faces.clone()) {
            Some(surface) => surface,
            None => return Err((applied, format!("the faces are now {faces:?}"))),
        };
    }
    Ok(())
}

/// Leaves out operators as long as the law stays broken.
fn shrunk<E: Editing>(law: EditLaw, start: &Surface, mut draws: Vec<Draw>) -> String {
    let breaks = |draws: &[Draw]| run::<E>(law, start, draws).is_err();
    loop {
        let length = draws.len();
        for at in (0..length).rev() {
            let mut fewer = draws.clone();
            fewer.remove(at);
            if breaks(&fewer) {
                draws = fewer;
            }
        }
        if draws.len() == length {
            break;
        }
    }
    match run::<E>(law, start, &draws) {
        Err((operators, wrong)) => verdict::<E>(law, start, &operators, &wrong),
        Ok(()) => format!("{} breaks the law `{}`, and not always", E::NAME, law.id()),
    }
}

fn verdict<E: Editing>(law: EditLaw, start: &Surface, operators: &[Operator], wrong: &str) -> String {
    let mut text = format!("{} breaks the law `{}`: {}.\n\n  begin with", E::NAME, law.id(), law.sentence());
    start.faces.iter().for_each(|face| text += &format!(" {face:?}"));
    operators.iter().for_each(|operator| text += &format!("\n  {operator}"));
    text + "\n\n  " + wrong
}

/// Applies an operator, and asks the law about it.
fn step<E: Editing>(
    law: EditLaw,
    editor: &mut E,
    before: &Surface,
    operator: &Operator,
) -> Result<(), String> {
    if !E::offers(operator.kind()) {
        return Ok(());
    }
    let faces = editor.faces();
    let edited = editor.apply(operator);
    match law {
        EditLaw::Valid => valid(editor),
        EditLaw::Euler => edited.map_or(Ok(()), |_| euler(editor, before, operator)),
        EditLaw::Unchanged if edited.is_err() => same("the faces", &editor.faces(), &faces),
        EditLaw::Unchanged => Ok(()),
        EditLaw::Inverse => edited.map_or(Ok(()), |edited| inverse(editor, before, &edited)),
        EditLaw::Cause => cause(editor, before, operator, &edited),
        EditLaw::Stale => edited.map_or(Ok(()), |_| stale(editor, before)),
    }
}

fn valid<E: Editing>(editor: &E) -> Result<(), String> {
    let faces = editor.faces();
    if Surface::of(faces.clone()).is_some() { Ok(()) } else { Err(format!("the faces are now {faces:?}")) }
}

fn euler<E: Editing>(editor: &E, before: &Surface, operator: &Operator) -> Result<(), String> {
    match Surface::of(editor.faces()) {
        Some(after) => figures(before, &after, operator),
        None => Err("the faces are those of no oriented manifold".into()),
    }
}

fn figures(before: &Surface, after: &Surface, operator: &Operator) -> Result<(), String> {
    let Some((change, components)) = declared(before, operator) else {
        return Err("the operator is about something that is not there".into());
    };
    let (old, new) = (before.figures(), after.figures());
    let count = |name: &str, old: isize, change: isize, new: isize| same(name, &new, &(old + change));
    count("the number of vertices", old.vertices, change.vertices, new.vertices)?;
    count("the number of edges", old.edges, change.edges, new.edges)?;
    count("the number of faces", old.faces, change.faces, new.faces)?;
    count("the number of holes", old.holes, change.holes, new.holes)?;
    let found = new.components - old.components;
    if components.contains(&found) {
        Ok(())
    } else {
        Err(format!("the number of components changes by {found}"))
    }
}

fn inverse<E: Editing>(editor: &mut E, before: &Surface, edited: &Edited) -> Result<(), String> {
    editor.apply(&edited.undo).map_err(|reasons| format!("{} is refused: {reasons:?}", edited.undo))?;
    let faces = editor.faces();
    if same_up_to_names(&faces, &before.faces) {
        Ok(())
    } else {
        Err(format!("after {} the faces are {faces:?}", edited.undo))
    }
}

fn cause<E: Editing>(
    editor: &E,
    before: &Surface,
    operator: &Operator,
    edited: &Result<Edited, Vec<String>>,
) -> Result<(), String> {
    let most = before.vertices().last().map_or(0, |&vertex| vertex + 1);
    let fresh: Vec<u32> = match edited {
        Ok(edited) if !edited.vertices.is_empty() => edited.vertices.clone(),
        _ => (most..most + 100).collect(),
    };
    let expected = naive(before, operator, &fresh);
    let broken = expected.clone().map(|faces| match (Surface::of(faces), operator) {
        (None, _) => Err("the faces would be those of no oriented manifold".to_owned()),
        (_, &Operator::Collapse(side)) if makes_a_pillow(before, side) => {
            Err("two triangles would lie on each other".to_owned())
        }
        (Some(after), _) => figures(before, &after, operator),
    });
    match (edited, expected, broken) {
        (Err(reasons), _, Some(Ok(()))) => Err(format!("it is refused and could be done: {reasons:?}")),
        (Err(_), ..) => Ok(()),
        (Ok(_), Some(faces), Some(Ok(()))) => {
            same("the faces", &canonical(&editor.faces()), &canonical(&faces))
        }
        (Ok(_), _, Some(Err(why))) => Err(format!("it is done, but {why}")),
        (Ok(_), ..) => Err("it is done, but is about something that is not there".into()),
    }
}

/// Calls that name vertices that are gone.
fn stale<E: Editing>(editor: &mut E, before: &Surface) -> Result<(), String> {
    let left: BTreeSet<u32> = editor.faces().into_iter().flatten().collect();
    for gone in before.vertices().into_iter().filter(|vertex| !left.contains(vertex)) {
        for operator in operators_at(before, gone) {
            if E::offers(operator.kind()) && editor.apply(&operator).is_ok() {
                return Err(format!("then {operator} is done, and v{gone} is gone"));
            }
        }
    }
    Ok(())
}

fn same<T: PartialEq + Debug>(what: &str, found: &T, expected: &T) -> Result<(), String> {
    if found == expected { Ok(()) } else { Err(format!("{what}: found {found:?}, should be {expected:?}")) }
}

fn vertex_count(surface: &Surface) -> usize {
    surface.vertices().last().map_or(0, |&vertex| vertex as usize + 1)
}

/// The surfaces over four vertices, and those over five up to names, the smaller ones first.
fn small_surfaces() -> Vec<Surface> {
    let mut surfaces: Vec<Surface> = oriented_triangle_sets(4).filter_map(Surface::of).collect();
    let mut seen = BTreeSet::new();
    for surface in oriented_triangle_sets(5).filter_map(Surface::of) {
        if surface.vertices().len() == 5 && seen.insert(least_names(&surface)) {
            surfaces.push(surface);
        }
    }
    surfaces.sort_by_key(|surface| surface.faces.len());
    surfaces
}

/// The least of all tables that a surface over five vertices has with other names.
fn least_names(surface: &Surface) -> Option<Vec<Vec<u32>>> {
    let renamed = |names: Vec<u32>| {
        let faces: Vec<Vec<u32>> =
            surface.faces.iter().map(|face| face.iter().map(|&v| names[v as usize]).collect()).collect();
        canonical(&faces)
    };
    super::inverse::permutations(&[0, 1, 2, 3, 4]).into_iter().map(renamed).min()
}

/// Where random sequences begin: a triangle, a polygon, a cube, a torus, two shells, a ring.
fn starts() -> Vec<Surface> {
    let cube = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let torus = (0..9).map(|at| {
        let (x, y) = (at % 3, at / 3);
        let vertex = |x: u32, y: u32| x % 3 + 3 * (y % 3);
        vec![vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)]
    });
    let ring = (0..4).map(|at| vec![at, (at + 1) % 4, 4 + (at + 1) % 4, 4 + at]);
    let shell = |at: u32| {
        [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]].map(|face| face.map(|vertex| vertex + at).to_vec())
    };
    let tables = [
        vec![vec![0, 1, 2]],
        vec![vec![0, 1, 2, 3, 4, 5]],
        cube.map(|face| face.to_vec()).to_vec(),
        torus.collect(),
        [shell(0), shell(4)].concat(),
        ring.collect(),
    ];
    tables.into_iter().filter_map(Surface::of).collect()
}
