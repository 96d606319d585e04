//! What numbers the vertices and triangles of an object: beams, balls, and sets of triangles.

use std::ops::Range;

use quick_xml::Reader;
use quick_xml::events::Event;

use super::rows::{attributes_of, value, with_values};
use super::vertices::Vertices;

/// Some of a text, with what is to stand in its place.
#[derive(Clone, Debug)]
pub(super) struct Edit {
    pub(super) place: Range<usize>,
    pub(super) text: String,
}

/// The attributes that name a vertex.
const NAMES: [&str; 3] = ["v1", "v2", "vindex"];

/// Calls back for each tag of a part of a text, with its place.
fn each_tag(text: &str, part: &Range<usize>, mut then: impl FnMut(Range<usize>, &str, &str)) {
    let inside = &text[part.clone()];
    let mut reader = Reader::from_str(inside);
    reader.config_mut().check_end_names = false;
    loop {
        let from = reader.buffer_position() as usize;
        let event = reader.read_event();
        let place = from..reader.buffer_position() as usize;
        match event {
            Ok(Event::Empty(tag) | Event::Start(tag)) => {
                let name = tag.local_name();
                let local: &str = name.as_ref();
                then(part.start + place.start..part.start + place.end, local, &inside[place]);
            }
            Ok(Event::Eof) | Err(_) => return,
            Ok(_) => {}
        }
    }
}

/// Marks the rows of vertices that beams and balls use.
pub(super) fn mark_used(text: &str, lattice: &Range<usize>, is_used: &mut [bool]) {
    each_tag(text, lattice, |_, local, tag| {
        for vertex in named_vertices(local, tag) {
            if let Some(flag) = is_used.get_mut(vertex as usize) {
                *flag = true;
            }
        }
    });
}

fn named_vertices<'t>(local: &str, tag: &'t str) -> impl Iterator<Item = u32> + use<'t> {
    let names: &[&str] = if matches!(local, "beam" | "ball") { &NAMES } else { &[] };
    names.iter().filter_map(|name| value(tag, name)?.trim().parse().ok())
}

/// The beams and balls with the new numbers of their vertices.
pub(super) fn lattice_edits(text: &str, lattice: &Range<usize>, vertices: &Vertices, edits: &mut Vec<Edit>) {
    each_tag(text, lattice, |place, local, tag| {
        if !matches!(local, "beam" | "ball") {
            return;
        }
        let numbers = attributes_of(tag).filter_map(|attribute| {
            let name = NAMES.into_iter().find(|name| *name == attribute.name)?;
            let old: u32 = attribute.value.trim().parse().ok()?;
            let new = vertices.of_row(old).filter(|&new| new != old)?;
            Some((name, new.to_string()))
        });
        let numbers: Vec<(&str, String)> = numbers.collect();
        if !numbers.is_empty() {
            edits.push(Edit { place, text: with_values(tag, &numbers) });
        }
    });
}

/// For each old triangle the ones that it is now.
pub(super) struct Triangles {
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl Triangles {
    /// The old triangle of each new one, in order.
    pub(super) fn of(sources: &[Option<u32>], before: usize) -> Self {
        let mut pairs: Vec<(u32, u32)> =
            sources.iter().zip(0..).filter_map(|(old, new)| old.map(|old| (old, new))).collect();
        pairs.sort_unstable();
        let starts = (0..=before).map(|old| pairs.partition_point(|pair| (pair.0 as usize) < old)).collect();
        Triangles { starts, items: pairs.into_iter().map(|pair| pair.1).collect() }
    }

    fn now(&self, old: usize) -> &[u32] {
        match (self.starts.get(old), self.starts.get(old + 1)) {
            (Some(&start), Some(&end)) => &self.items[start..end],
            _ => &[],
        }
    }

    fn before(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }
}

/// The sets of triangles with the new numbers of their members. Returns how many members are no more.
pub(super) fn set_edits(
    text: &str,
    sets: &Range<usize>,
    triangles: &Triangles,
    edits: &mut Vec<Edit>,
) -> usize {
    let mut lost = 0;
    each_tag(text, sets, |place, local, tag| {
        let number = |name: &str| value(tag, name).and_then(|text| text.trim().parse::<usize>().ok());
        let members = match local {
            "ref" => number("index").map(|index| index..index.saturating_add(1)),
            "refrange" => {
                number("startindex").zip(number("endindex")).map(|(start, end)| start..end.saturating_add(1))
            }
            _ => None,
        };
        let Some(members) = members else { return };
        let within = members.start.min(triangles.before())..members.end.min(triangles.before());
        let gone = within.clone().filter(|&old| triangles.now(old).is_empty()).count();
        lost += gone + members.len().saturating_sub(within.len()).min(1);
        let mut now: Vec<u32> = within.flat_map(|old| triangles.now(old)).copied().collect();
        now.sort_unstable();
        let place = place.start..element_end(text, &place);
        let element = &text[place.clone()];
        let changed = if local == "ref" { single(element, &now) } else { ranges(element, &now) };
        if changed != element {
            edits.push(Edit { place, text: changed });
        }
    });
    lost
}

/// Where an element ends that begins with a tag and has no others in it.
fn element_end(text: &str, tag: &Range<usize>) -> usize {
    if text[tag.clone()].ends_with("/>") {
        return tag.end;
    }
    let behind = &text[tag.end..];
    let end = behind.find("</").and_then(|start| Some(start + behind[start..].find('>')? + 1));
    end.map_or(tag.end, |length| tag.end + length)
}

fn single(tag: &str, members: &[u32]) -> String {
    members.iter().map(|member| with_values(tag, &[("index", member.to_string())])).collect()
}

/// A tag for each run of neighbours.
fn ranges(tag: &str, members: &[u32]) -> String {
    let runs = members.chunk_by(|one, next| one + 1 == *next);
    let tags = runs.filter_map(|run| {
        let (start, end) = (run.first()?.to_string(), run.last()?.to_string());
        Some(with_values(tag, &[("startindex", start), ("endindex", end)]))
    });
    tags.collect()
}
