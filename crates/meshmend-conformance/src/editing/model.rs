//! Each operator, done on lists of faces without asking whether it may be.

use std::collections::{BTreeMap, BTreeSet};

use super::surface::{Figures, Surface};
use super::{Opening, Operator, Side};

/// What an operator makes of the faces; new vertices are named by `fresh`. None where the operator says nothing: its edge,
/// its face or its loop is not there, or not of the kind that it is about.
pub(super) fn naive(before: &Surface, operator: &Operator, fresh: &[u32]) -> Option<Vec<Vec<u32>>> {
    let new = fresh.first().copied()?;
    match *operator {
        Operator::SplitEdge(side) => before.is_half(side).then(|| with_vertex_on(before, side, new)),
        Operator::JoinEdges(vertex) => (before.star(vertex).len() == 2).then(|| without(before, vertex)),
        Operator::SplitFace(one, other) => split_face(before, one, other),
        Operator::JoinFaces(side) => join_faces(before, side),
        Operator::Poke(side) => poke(before, side, new),
        Operator::RemoveVertex(vertex) => remove_vertex(before, vertex),
        Operator::Flip(side) => flip(before, side),
        Operator::Collapse(side) => before.is_half(side).then(|| collapse(&before.faces, side)),
        Operator::SplitVertex(from, to) => split_vertex(before, from, to, new),
        Operator::OpenFace(side) => Some(others(before, &[before.face(side)?[0]])),
        Operator::CloseHole(side) => {
            let hole = before.hole_from(side)?;
            Some(before.faces.iter().cloned().chain([hole]).collect())
        }
        Operator::CutLoop(ref walk) => cut_loop(before, walk, fresh),
        Operator::ZipHoles(one, other) => zip_holes(before, one, other),
    }
}

/// How the figures change, and by how much the number of components may.
pub(super) fn declared(before: &Surface, operator: &Operator) -> Option<(Figures, &'static [isize])> {
    let size = |side: Side| before.face_from(side).map(|face| face.len() as isize);
    let triangles =
        |[a, b]: Side| [[a, b], [b, a]].iter().filter(|&&side| size(side) == Some(3)).count() as isize;
    let change = |vertices, edges, faces, holes| Figures { vertices, edges, faces, holes, components: 0 };
    let same: &[isize] = &[0];
    Some(match *operator {
        Operator::SplitEdge(_) => (change(1, 1, 0, 0), same),
        Operator::JoinEdges(_) => (change(-1, -1, 0, 0), same),
        Operator::SplitFace(..) => (change(0, 1, 1, 0), same),
        Operator::JoinFaces(_) => (change(0, -1, -1, 0), same),
        Operator::Poke(side) => (change(1, size(side)?, size(side)? - 1, 0), same),
        Operator::RemoveVertex(vertex) => {
            let degree = before.star(vertex).len() as isize;
            (change(-1, -degree, 1 - degree, 0), same)
        }
        Operator::Flip(_) => (change(0, 0, 0, 0), same),
        Operator::Collapse(side) => (change(-1, -1 - triangles(side), -triangles(side), 0), same),
        Operator::SplitVertex(from, to) => {
            let opened = [from, to].iter().filter(|end| matches!(end, Opening::Edge(_))).count() as isize;
            (change(1, 1 + opened, opened, 0), same)
        }
        Operator::OpenFace(_) => (change(0, 0, -1, 1), same),
        Operator::CloseHole(_) => (change(0, 0, 1, -1), same),
        Operator::CutLoop(ref walk) => {
            let length = walk.len() as isize;
            (change(length, length, 0, 2), &[0, 1])
        }
        Operator::ZipHoles(side, _) => {
            let length = before.hole_from(side)?.len() as isize;
            (change(-length, -length, 0, -2), &[0, -1])
        }
    })
}

/// The faces but for some.
fn others(before: &Surface, gone: &[usize]) -> Vec<Vec<u32>> {
    let kept = before.faces.iter().enumerate().filter(|(face, _)| !gone.contains(face));
    kept.map(|(_, vertices)| vertices.clone()).collect()
}

fn with_vertex_on(before: &Surface, [a, b]: Side, new: u32) -> Vec<Vec<u32>> {
    let is_edge = |one: u32, other: u32| [one, other] == [a, b] || [one, other] == [b, a];
    let with = |face: &Vec<u32>| {
        let mut vertices = Vec::new();
        for (place, &vertex) in face.iter().enumerate() {
            vertices.push(vertex);
            if is_edge(vertex, face[(place + 1) % face.len()]) {
                vertices.push(new);
            }
        }
        vertices
    };
    before.faces.iter().map(with).collect()
}

fn without(before: &Surface, vertex: u32) -> Vec<Vec<u32>> {
    before.faces.iter().map(|face| face.iter().copied().filter(|&v| v != vertex).collect()).collect()
}

fn split_face(before: &Surface, one: Side, other: Side) -> Option<Vec<Vec<u32>>> {
    let ([face, _], [same, _]) = (before.face(one)?, before.face(other)?);
    let vertices = before.face_from(one)?;
    let at = vertices.iter().position(|&vertex| vertex == other[0])?;
    if face != same || at < 2 || at + 1 == vertices.len() {
        return None;
    }
    let second = vertices[at..].iter().chain(&vertices[..1]).copied().collect();
    Some(others(before, &[face]).into_iter().chain([vertices[..=at].to_vec(), second]).collect())
}

fn join_faces(before: &Surface, [a, b]: Side) -> Option<Vec<Vec<u32>>> {
    let ([one, _], [other, _]) = (before.face([a, b])?, before.face([b, a])?);
    // From b on to a, and from there on to b.
    let (first, second) = (before.face_from([a, b])?, before.face_from([b, a])?);
    let joined = first[1..].iter().chain(&first[..1]).chain(&second[2..]).copied().collect();
    Some(others(before, &[one, other]).into_iter().chain([joined]).collect())
}

fn poke(before: &Surface, side: Side, new: u32) -> Option<Vec<Vec<u32>>> {
    let (face, vertices) = (before.face(side)?[0], before.face_from(side)?);
    let fan = (0..vertices.len()).map(|at| vec![vertices[at], vertices[(at + 1) % vertices.len()], new]);
    Some(others(before, &[face]).into_iter().chain(fan).collect())
}

fn remove_vertex(before: &Surface, vertex: u32) -> Option<Vec<Vec<u32>>> {
    let rim = before.star(vertex);
    let round: Option<Vec<[usize; 2]>> =
        rim.iter().map(|&neighbour| before.face([vertex, neighbour])).collect();
    let gone: Vec<usize> = round?.into_iter().map(|[face, _]| face).collect();
    let is_fan = rim.len() >= 3 && gone.iter().all(|&face| before.faces[face].len() == 3);
    is_fan.then(|| others(before, &gone).into_iter().chain([rim]).collect())
}

fn flip(before: &Surface, [a, b]: Side) -> Option<Vec<Vec<u32>>> {
    let (&[_, _, c], &[_, _, d]) = (&before.face_from([a, b])?[..], &before.face_from([b, a])?[..]) else {
        return None;
    };
    let has_enough =
        |vertex: u32| before.star(vertex).len() >= if before.is_on_boundary(vertex) { 3 } else { 4 };
    let gone = [before.face([a, b])?[0], before.face([b, a])?[0]];
    let turned = [vec![d, c, a], vec![c, d, b]];
    (has_enough(a) && has_enough(b)).then(|| others(before, &gone).into_iter().chain(turned).collect())
}

fn collapse(faces: &[Vec<u32>], [gone, kept]: Side) -> Vec<Vec<u32>> {
    let shrunk = faces.iter().map(|face| {
        let mut face: Vec<u32> =
            face.iter().map(|&vertex| if vertex == gone { kept } else { vertex }).collect();
        face.dedup();
        if face.first() == face.last() {
            face.pop();
        }
        face
    });
    shrunk.filter(|face| face.len() >= 3).collect()
}

/// Whether a triangle would come to lie on another one, as the faces of a tetrahedron do when an edge of it shrinks.
pub(super) fn makes_a_pillow(before: &Surface, side: Side) -> bool {
    let triangles: Vec<Vec<u32>> = before.faces.iter().filter(|face| face.len() == 3).cloned().collect();
    faces_on_others(collapse(&triangles, side)) > faces_on_others(triangles)
}

/// How many faces have the same vertices as another one.
fn faces_on_others(mut faces: Vec<Vec<u32>>) -> usize {
    faces.iter_mut().for_each(|face| face.sort_unstable());
    faces.sort();
    faces.windows(2).filter(|pair| pair[0] == pair[1]).count()
}

/// The neighbours whose corners lie strictly between two openings, counter-clockwise.
fn corners_between(before: &Surface, from: Opening, to: Opening) -> Vec<u32> {
    let [vertex, first] = from.side();
    let mut star = before.star_from(vertex, first);
    if let Opening::Corner(_) = from {
        star.rotate_left(1);
    }
    let last = star.iter().position(|&neighbour| neighbour == to.side()[1]).unwrap_or(star.len());
    star.truncate(last);
    star
}

fn split_vertex(before: &Surface, from: Opening, to: Opening, new: u32) -> Option<Vec<Vec<u32>>> {
    let [vertex, _] = from.side();
    let is_there = [from, to].iter().all(|end| before.is_half(end.side()) && end.side()[0] == vertex);
    if !is_there || from == to || is_pillow(before, from, to) {
        return None;
    }
    let mut faces = before.faces.clone();
    // Begins in the corner before its edge: then all corners but that one lie between.
    for neighbour in corners_between(before, from, to) {
        if let Some([face, place]) = before.face([vertex, neighbour]) {
            faces[face][place] = new;
        }
    }
    for (end, at_end) in [(from, [new, vertex]), (to, [vertex, new])] {
        match end {
            Opening::Corner(side) => {
                if let Some([face, place]) = before.face(side) {
                    faces[face].splice(place..=place, at_end);
                }
            }
            Opening::Edge([_, tip]) => faces.push(vec![at_end[0], at_end[1], tip]),
        }
    }
    Some(faces)
}

/// Whether both edges of a vertex between two triangles on the same three vertices are to be opened.
fn is_pillow(before: &Surface, from: Opening, to: Opening) -> bool {
    let is_triangle = |end: Opening| before.face_from(end.side()).is_some_and(|face| face.len() == 3);
    let are_edges = matches!((from, to), (Opening::Edge(_), Opening::Edge(_)));
    are_edges && before.star(from.side()[0]).len() == 2 && is_triangle(from) && is_triangle(to)
}

fn cut_loop(before: &Surface, walk: &[u32], fresh: &[u32]) -> Option<Vec<Vec<u32>>> {
    let different: BTreeSet<u32> = walk.iter().copied().collect();
    let side = |at: usize| [walk[at], walk[(at + 1) % walk.len()]];
    let is_walk = (0..walk.len()).all(|at| before.is_half(side(at)));
    let is_inside = walk.iter().all(|&vertex| !before.is_on_boundary(vertex));
    if walk.len() < 3 || different.len() < walk.len() || !is_walk || !is_inside || fresh.len() < walk.len() {
        return None;
    }
    let mut faces = before.faces.clone();
    for (at, &vertex) in walk.iter().enumerate() {
        let (back, on) = (walk[(at + walk.len() - 1) % walk.len()], side(at)[1]);
        for neighbour in before.star_from(vertex, back).into_iter().take_while(|&neighbour| neighbour != on) {
            let [face, place] = before.face([vertex, neighbour])?;
            faces[face][place] = fresh[at];
        }
    }
    Some(faces)
}

fn zip_holes(before: &Surface, one: Side, [from, to]: Side) -> Option<Vec<Vec<u32>>> {
    let (kept, mut gone) = (before.hole_from(one)?, before.hole_from([from, to])?);
    if kept.len() != gone.len() || kept.contains(&from) {
        return None;
    }
    // The end of the second half-edge comes to lie on the beginning of the first.
    gone.rotate_left(2);
    gone.reverse();
    let instead: BTreeMap<u32, u32> = gone.into_iter().zip(kept).collect();
    let renamed = |face: &Vec<u32>| face.iter().map(|v| *instead.get(v).unwrap_or(v)).collect();
    Some(before.faces.iter().map(renamed).collect())
}
