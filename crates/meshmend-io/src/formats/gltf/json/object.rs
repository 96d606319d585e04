//! An object of a JSON text, with its place for errors.

use super::value::{Child, Value};
use crate::formats::gltf::fault::{Fault, Pointer};

/// An object of which each member has a name of its own.
pub(in crate::formats::gltf) struct Object<'a> {
    pub(in crate::formats::gltf) pointer: Pointer,
    pub(in crate::formats::gltf) value: Value<'a>,
    pub(in crate::formats::gltf) members: Vec<Child<'a>>,
    /// The places of the members, by name.
    by_name: Vec<u32>,
}

impl<'a> Object<'a> {
    /// A value as an object.
    ///
    /// # Errors
    /// If it is not an object, or two of its members have one name.
    pub(in crate::formats::gltf) fn of(value: Value<'a>, pointer: Pointer) -> Result<Self, Fault> {
        if !value.is_object() {
            return Err(pointer.fault("is not an object"));
        }
        let members = value.children();
        let name = |at: u32| members[at as usize].name.as_str();
        let mut by_name: Vec<u32> = (0..members.len() as u32).collect();
        by_name.sort_unstable_by(|&one, &other| name(one).cmp(name(other)));
        match by_name.windows(2).find(|pair| name(pair[0]) == name(pair[1])) {
            Some(pair) => Err(pointer.fault(format!("has two members `{}`", name(pair[0])))),
            None => Ok(Object { pointer, value, members, by_name }),
        }
    }

    /// The value of a member.
    pub(in crate::formats::gltf) fn get(&self, name: &str) -> Option<Value<'a>> {
        let member = |at: u32| &self.members[at as usize];
        let place = self.by_name.binary_search_by(|&at| member(at).name.as_str().cmp(name));
        place.ok().map(|place| member(self.by_name[place]).value)
    }

    /// What is wrong with a member.
    pub(in crate::formats::gltf) fn fault_in(&self, name: &str, reason: impl Into<String>) -> Fault {
        self.pointer.member(name).fault(reason)
    }

    /// A member that is a whole number; the default if there is none.
    pub(in crate::formats::gltf) fn count_or(&self, name: &str, default: u64) -> Result<u64, Fault> {
        let Some(value) = self.get(name) else { return Ok(default) };
        value.as_count().ok_or_else(|| self.fault_in(name, "is not a whole number"))
    }

    /// A member that must be there and is a whole number.
    pub(in crate::formats::gltf) fn count(&self, name: &str) -> Result<u64, Fault> {
        let value = self.get(name).ok_or_else(|| self.pointer.fault(format!("has no `{name}`")))?;
        value.as_count().ok_or_else(|| self.fault_in(name, "is not a whole number"))
    }

    /// A member that is an index below a count.
    pub(in crate::formats::gltf) fn index(
        &self,
        name: &str,
        count: usize,
        what: &str,
    ) -> Result<Option<usize>, Fault> {
        self.get(name).map(|value| index_of(value, &self.pointer.member(name), count, what)).transpose()
    }

    /// A member that is an object.
    pub(in crate::formats::gltf) fn object(&self, name: &str) -> Result<Option<Object<'a>>, Fault> {
        self.get(name).map(|value| Object::of(value, self.pointer.member(name))).transpose()
    }

    /// The items of a member that is an array; empty if there is none.
    pub(in crate::formats::gltf) fn items(&self, name: &str) -> Result<Vec<Value<'a>>, Fault> {
        let Some(value) = self.get(name) else { return Ok(Vec::new()) };
        value.items().ok_or_else(|| self.fault_in(name, "is not an array"))
    }

    /// The items of a member that is an array of indices below a count.
    pub(in crate::formats::gltf) fn indices(
        &self,
        name: &str,
        count: usize,
        what: &str,
    ) -> Result<Vec<usize>, Fault> {
        let index = |(at, value): (usize, Value<'_>)| match value.as_count() {
            Some(index) if index < count as u64 => Ok(index as usize),
            _ => index_of(value, &self.pointer.item_of(name, at), count, what),
        };
        self.items(name)?.into_iter().enumerate().map(index).collect()
    }

    /// A member that is a text.
    pub(in crate::formats::gltf) fn text(&self, name: &str) -> Result<Option<String>, Fault> {
        let Some(value) = self.get(name) else { return Ok(None) };
        value.as_text().map(Some).ok_or_else(|| self.fault_in(name, "is not a text"))
    }
}

/// A value as an index below a count.
fn index_of(value: Value<'_>, pointer: &Pointer, count: usize, what: &str) -> Result<usize, Fault> {
    let index = value.as_count().ok_or_else(|| pointer.fault("is not a whole number"))?;
    let found = usize::try_from(index).ok().filter(|&index| index < count);
    found.ok_or_else(|| pointer.fault(no_such(what, index, count)))
}

/// The reason when a file names something that it does not have.
fn no_such(what: &str, index: u64, count: usize) -> String {
    match count {
        0 => format!("{what} {index} does not exist: the file has none"),
        _ => format!("{what} {index} does not exist: the last one is {}", count - 1),
    }
}
