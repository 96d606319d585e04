//! Where the bytes of changed accessors go: into the slots of views of which nothing else is left, or into new views at
//! the end.

use std::ops::Range;

use crate::formats::gltf::accessor::{Accessor, Place};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Held;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::file::File;
use crate::formats::gltf::json::Object;
use crate::formats::gltf::splice::slots::{NewAccessor, Slots};
use crate::formats::gltf::splice::users::Users;

/// A buffer view that has other bytes, or has them elsewhere.
pub(super) struct NewView {
    /// Its number; beyond those of the file if it is new.
    pub(super) index: usize,
    pub(super) buffer: usize,
    pub(super) offset: usize,
    pub(super) length: usize,
    /// What a new view says of its rows: from one to the next, if they are further apart than they are long.
    pub(super) stride: Option<usize>,
    pub(super) holds_indices: bool,
}

/// Where an accessor's rows are now.
pub(super) struct Moved {
    pub(super) view: usize,
    pub(super) offset: usize,
}

/// Where all bytes go.
pub(super) struct Layout {
    /// The buffer that has the new bytes; one more than there are if it is new.
    pub(super) buffer: usize,
    /// What is left out of its old bytes: ascending, at multiples of 4.
    pub(super) removed: Vec<Range<usize>>,
    /// Where the new bytes begin: after the old ones, at a multiple of 4.
    pub(super) start: usize,
    /// The new bytes.
    pub(super) added: Vec<u8>,
    pub(super) views: Vec<NewView>,
    /// For each changed accessor, in the order of the slots.
    pub(super) moved: Vec<Moved>,
    /// How many old bytes stay though nothing names them any more.
    pub(super) dead: usize,
}

/// Rows of several accessors that stand in one stride, or of one.
struct Block {
    /// Places among the changed accessors, each with its first byte within the stride.
    members: Vec<(usize, usize)>,
    stride: usize,
    count: usize,
}

/// A changed accessor with the place of its rows in the file.
struct Old {
    /// Its place among the changed ones.
    at: usize,
    place: Place,
    count: usize,
}

impl Layout {
    /// Lays the bytes of changed accessors out.
    ///
    /// # Errors
    /// If an accessor of the file is malformed.
    pub(super) fn of(asset: &Asset<'_>, file: &File, slots: &Slots, users: &Users) -> Result<Self, Fault> {
        let held = &file.held;
        let own = |held: &Held| matches!(held, Held::Chunk(_) | Held::Data(_));
        // A file beside is never written again, so new bytes go into a buffer of their own if the first is one.
        let first = held.iter().find(|held| !matches!(held, Held::Absent));
        let buffer =
            first.filter(|held| own(held)).and_then(|_| held.iter().position(own)).unwrap_or(held.len());
        let mut layout = Layout {
            buffer,
            removed: Vec::new(),
            start: 0,
            added: Vec::new(),
            views: Vec::new(),
            moved: Vec::new(),
            dead: 0,
        };
        let mut old: Vec<Option<Accessor>> = Vec::new();
        for accessor in &slots.accessors {
            let like = accessor.like.filter(|_| accessor.keeps_slot);
            old.push(like.map(|like| asset.accessor(like)).transpose()?);
        }
        let freed = freed_views(asset, slots, users)?;
        let mut places: Vec<Option<Moved>> = slots.accessors.iter().map(|_| None).collect();
        for (view, members) in members_of_views(&old, asset.views.len()).into_iter().enumerate() {
            if members.is_empty() {
                continue;
            }
            let opened = asset.view(view)?;
            let blocks = freed[view].then(|| blocks(&members, opened.stride, &slots.accessors)).flatten();
            let is_left_out = blocks.is_some() && opened.buffer == buffer;
            if is_left_out {
                let start = opened.offset as usize;
                layout.removed.push(start..start + opened.length as usize);
            } else {
                let size = |member: &Old| member.count * slots.accessors[member.at].rows.form.size();
                layout.dead += members.iter().map(size).sum::<usize>();
            }
            if let Some(blocks) = blocks {
                layout.put(view, &blocks, &slots.accessors, &mut places);
            }
        }
        layout.removed = uncovered(asset, &layout, &freed)?;
        let old = held.get(buffer).and_then(|held| held.bytes(&file.bytes)).map_or(0, <[u8]>::len);
        let left_out: usize = layout.removed.iter().map(Range::len).sum();
        layout.start = (old - left_out).next_multiple_of(4);
        let homeless = places.iter_mut().enumerate().filter(|(_, slot)| slot.is_none());
        for (next, (at, slot)) in (asset.views.len()..).zip(homeless) {
            *slot = Some(layout.append(next, &slots.accessors[at]));
        }
        layout.moved = places.into_iter().flatten().collect();
        Ok(layout)
    }

    /// Puts the rows of a view's accessors into its slot.
    fn put(
        &mut self,
        view: usize,
        blocks: &[Block],
        accessors: &[NewAccessor],
        places: &mut [Option<Moved>],
    ) {
        let start = self.align();
        for block in blocks {
            let first = self.align();
            self.added.resize(first + block.count * block.stride, 0);
            for &(at, within) in &block.members {
                let rows = &accessors[at].rows;
                let size = rows.form.size();
                let slots = self.added[first..].chunks_mut(block.stride);
                for (slot, row) in slots.zip(rows.bytes.chunks(size)) {
                    slot[within..within + size].copy_from_slice(row);
                }
                places[at] = Some(Moved { view, offset: first - start + within });
            }
        }
        let holds_indices =
            blocks.iter().flat_map(|b| &b.members).any(|&(at, _)| accessors[at].holds_indices);
        let length = self.added.len() - start;
        self.views.push(NewView {
            index: view,
            buffer: self.buffer,
            offset: start,
            length,
            stride: None,
            holds_indices,
        });
    }

    /// Puts the rows of an accessor into a view of their own.
    fn append(&mut self, index: usize, accessor: &NewAccessor) -> Moved {
        let (start, size) = (self.align(), accessor.rows.form.size());
        // Rows of values begin at multiples of 4.
        let stride = if accessor.holds_indices { size } else { size.next_multiple_of(4) };
        for row in accessor.rows.bytes.chunks(size) {
            self.added.extend_from_slice(row);
            self.added.resize(self.added.len() + stride - size, 0);
        }
        self.views.push(NewView {
            index,
            buffer: self.buffer,
            offset: start,
            length: self.added.len() - start,
            stride: (stride != size).then_some(stride),
            holds_indices: accessor.holds_indices,
        });
        Moved { view: index, offset: 0 }
    }

    /// Fills up to a multiple of 4, and says where that is.
    fn align(&mut self) -> usize {
        self.added.resize(self.added.len().next_multiple_of(4), 0);
        self.added.len()
    }

    /// Where a byte of the old buffer is once some are left out.
    pub(super) fn shifted(&self, offset: usize) -> usize {
        let before = self.removed.iter().take_while(|range| range.end <= offset);
        offset - before.map(Range::len).sum::<usize>()
    }
}

/// Whether all accessors of a view have other rows now, and nothing else names it.
fn freed_views(asset: &Asset<'_>, slots: &Slots, users: &Users) -> Result<Vec<bool>, Fault> {
    let mut is_changed = vec![false; asset.accessors.len()];
    let kept = slots.accessors.iter().filter(|accessor| accessor.keeps_slot);
    kept.for_each(|accessor| is_changed[accessor.index] = true);
    let mut freed: Vec<bool> =
        users.is_named_elsewhere.iter().map(|named| users.are_all_known && !named).collect();
    for (index, &accessor) in asset.accessors.iter().enumerate().filter(|&(index, _)| !is_changed[index]) {
        let accessor = Object::of(accessor, Pointer::item("accessors", index))?;
        if let Some(view) = accessor.index("bufferView", asset.views.len(), "buffer view")? {
            freed[view] = false;
        }
    }
    Ok(freed)
}

/// The changed accessors of each view, by their first byte.
fn members_of_views(old: &[Option<Accessor>], views: usize) -> Vec<Vec<Old>> {
    let mut members: Vec<Vec<Old>> = std::iter::repeat_with(Vec::new).take(views).collect();
    for (at, accessor) in old.iter().enumerate() {
        if let Some((place, accessor)) = accessor.as_ref().and_then(|a| Some((a.place?, a))) {
            members[place.view].push(Old { at, place, count: accessor.count });
        }
    }
    members.iter_mut().for_each(|members| members.sort_by_key(|member| (member.place.start, member.at)));
    members
}

/// The rows of a view, block by block; `None` if rows of different numbers stand in one stride.
fn blocks(members: &[Old], stride: Option<u64>, accessors: &[NewAccessor]) -> Option<Vec<Block>> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut block_start = 0;
    for member in members {
        let rows = &accessors[member.at].rows;
        let (size, count) = (rows.form.size(), rows.count());
        let stride = stride.map_or(size, |stride| stride as usize);
        let within = member.place.start - block_start;
        match blocks.last_mut().filter(|block| within + size <= block.stride) {
            Some(block) if block.count == count => block.members.push((member.at, within)),
            Some(_) => return None,
            None => {
                block_start = member.place.start;
                blocks.push(Block { members: vec![(member.at, 0)], stride, count });
            }
        }
    }
    Some(blocks)
}

/// What of the bytes that are to be left out no other view has, at multiples of 4.
fn uncovered(asset: &Asset<'_>, layout: &Layout, freed: &[bool]) -> Result<Vec<Range<usize>>, Fault> {
    let is_replaced = |view: usize| freed[view] && layout.views.iter().any(|new| new.index == view);
    let mut covered: Vec<Range<usize>> = Vec::new();
    for view in (0..asset.views.len()).filter(|&view| !is_replaced(view)) {
        let view = asset.view(view)?;
        if view.buffer == layout.buffer {
            covered.push(view.offset as usize..(view.offset + view.length) as usize);
        }
    }
    covered.sort_by_key(|range| (range.start, range.end));
    if layout.removed.is_empty() {
        return Ok(Vec::new());
    }
    // What fills up to a multiple of 4 goes with the bytes before it.
    let length = usize::try_from(asset.buffer_length(layout.buffer)?).unwrap_or(usize::MAX);
    let filled = |range: &Range<usize>| range.start..range.end.next_multiple_of(4).min(length).max(range.end);
    let mut removed: Vec<Range<usize>> = layout.removed.iter().map(filled).collect();
    removed.sort_by_key(|range| (range.start, range.end));
    let mut left: Vec<Range<usize>> = Vec::new();
    let mut done = 0;
    let mut covered = covered.into_iter().peekable();
    for range in removed {
        let mut start = range.start.max(done);
        while start < range.end {
            while covered.next_if(|covered| covered.end <= start).is_some() {}
            let (end, next) = match covered.peek() {
                Some(covered) if covered.start <= start => (start, covered.end),
                Some(covered) => (range.end.min(covered.start), range.end.min(covered.start)),
                None => (range.end, range.end),
            };
            let piece = start.next_multiple_of(4)..end / 4 * 4;
            if piece.start < piece.end {
                left.push(piece);
            }
            start = next.max(start + 1);
        }
        done = done.max(range.end);
    }
    Ok(left)
}
