//! XML as 3MF has it: tags with the places of their bytes, so that all that is not changed can be copied.

mod attributes;
mod namespaces;
mod scanner;
mod text;

pub(super) use self::attributes::{Attribute, attributes, unescaped};
pub(super) use self::namespaces::Space;
pub(super) use self::scanner::{Scanner, Tag};
pub(super) use self::text::{Text, declared_as_utf8, escaped};
