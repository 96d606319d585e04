//! Writing the statements that change the names of the elements after them.

use std::borrow::Cow;

use meshmend_core::{Layer, PolygonMesh, Values};

use crate::formats::obj::name_statements::{KINDS, Kind, NAMED, spelled};
use crate::layers::layer_of;
use crate::output::sink::Sink;
use crate::{Loss, LossKind};

/// The names of all kinds, and the names that hold at present.
pub(super) struct NameWriter<'a> {
    kinds: [NamesOfKind<'a>; KINDS.len()],
}

/// The layers of one kind of name, by the kind of element, and what holds at present.
struct NamesOfKind<'a> {
    layers: [Option<NamedBy<'a>>; NAMED.len()],
    /// Whether all layers have the same pool, so that a value is the same statement in each.
    is_shared: bool,
    current: Option<(usize, usize)>,
}

/// A layer and its pool of names.
#[derive(Clone, Copy)]
struct NamedBy<'a> {
    layer: &'a Layer,
    pool: &'a [Vec<u8>],
}

impl<'a> NameWriter<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let kinds = KINDS.each_ref().map(|kind| {
            let layers = NAMED.map(|domain| {
                let layer = layer_of(mesh, kind.layer, domain, |layer| names_of(layer).is_some())?;
                Some(NamedBy { layer, pool: names_of(layer)? })
            });
            let mut pools = layers.iter().flatten().map(|named| named.pool);
            let first = pools.next();
            NamesOfKind { layers, is_shared: pools.all(|pool| Some(pool) == first), current: None }
        });
        NameWriter { kinds }
    }

    /// The layers that are written.
    pub(super) fn layers(&self) -> impl Iterator<Item = &'a Layer> + '_ {
        self.kinds.iter().flat_map(|names| names.layers.iter().flatten().map(|named| named.layer))
    }

    /// The losses of names that a statement must spell in another way.
    pub(super) fn losses(&self) -> impl Iterator<Item = Loss> + '_ {
        self.kinds.iter().zip(&KINDS).filter_map(|(names, kind)| {
            let mut pools: Vec<&[Vec<u8>]> = names.layers.iter().flatten().map(|named| named.pool).collect();
            pools.truncate(if names.is_shared { 1 } else { NAMED.len() });
            let is_other = |name: &&Vec<u8>| *spelled(kind, name) != name[..];
            let other = pools.into_iter().flatten().filter(is_other).count();
            Loss::if_any(LossKind::Names, other, |n| {
                let (names, are) = if n == 1 { ("name", "is") } else { ("names", "are") };
                format!("{n} {names} of `{}` {are} spelled differently", kind.layer)
            })
        })
    }

    /// Writes the statements that an element needs before it. `which` is the place of its kind among those with
    /// names.
    #[inline]
    pub(super) fn before(&mut self, which: usize, element: usize, sink: &mut Sink<'_>) {
        for (names, kind) in self.kinds.iter_mut().zip(&KINDS) {
            names.before(which, element, kind, sink);
        }
    }
}

impl NamesOfKind<'_> {
    #[inline]
    fn before(&mut self, which: usize, element: usize, kind: &Kind, sink: &mut Sink<'_>) {
        let next = self.layers[which].and_then(|named| Some((which, named.layer.value_of(element)?)));
        if next == self.current {
            return;
        }
        if !self.is_same(next) {
            let name = next.and_then(|place| self.name(place));
            state(kind, name.map_or(Cow::Borrowed(kind.none), |name| spelled(kind, name)), sink);
        }
        self.current = next;
    }

    /// Whether the name that holds at present is that of an element of another kind.
    fn is_same(&self, next: Option<(usize, usize)>) -> bool {
        match (self.current, next) {
            (Some((one, value)), Some((other, next))) if one != other => {
                if self.is_shared {
                    value == next
                } else {
                    self.name((one, value)) == self.name((other, next))
                }
            }
            _ => false,
        }
    }

    fn name(&self, (which, value): (usize, usize)) -> Option<&[u8]> {
        self.layers[which].map(|named| &named.pool[value][..])
    }
}

fn names_of(layer: &Layer) -> Option<&[Vec<u8>]> {
    match layer.values() {
        Values::Text(names) if layer.width() == 1 => Some(names),
        _ => None,
    }
}

fn state(kind: &Kind, name: Cow<'_, [u8]>, sink: &mut Sink<'_>) {
    sink.bytes(kind.statement);
    if !name.is_empty() {
        sink.byte(b' ');
        sink.bytes(&name);
    }
    sink.byte(b'\n');
}
