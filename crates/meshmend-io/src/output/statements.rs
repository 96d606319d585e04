//! Statements about a file as a whole: how a line spells them, and the losses of those that are left out.

use std::borrow::Cow;

use meshmend_core::{PolygonMesh, counted};

use crate::text::one_or_many;
use crate::{Loss, LossKind};

/// A statement as one line, without line ends, and without a `\` at its end, which would continue it.
pub(crate) fn one_line(value: &[u8]) -> Cow<'_, [u8]> {
    let breaks = |byte: &u8| matches!(byte, b'\n' | b'\r' | 0);
    if value.iter().any(breaks) || value.ends_with(b"\\") {
        let mut line: Vec<u8> = value.iter().map(|b| if breaks(b) { b' ' } else { *b }).collect();
        line.push(b' ');
        return Cow::Owned(line);
    }
    Cow::Borrowed(value)
}

/// The loss of statements with these keys that a line can't spell exactly.
pub(crate) fn spelling_loss(mesh: &PolygonMesh, keys: &[&str]) -> Option<Loss> {
    let written = mesh.metadata().iter().filter(|statement| keys.contains(&statement.kind()));
    let other = written.filter(|statement| one_line(&statement.value)[..] != statement.value[..]).count();
    Loss::if_any(LossKind::Names, other, |n| {
        one_or_many(
            n,
            "statement about the file is spelled differently",
            "statements about the file are spelled differently",
        )
    })
}

/// A loss for each kind of statement about the whole file that is not written.
pub(crate) fn metadata_losses(mesh: &PolygonMesh, written: &[&str]) -> Vec<Loss> {
    let mut keys: Vec<&str> = mesh.metadata().iter().map(|m| m.kind()).collect();
    keys.retain(|key| !written.contains(key));
    keys.sort_unstable();
    let of_key = keys.chunk_by(|a, b| a == b);
    let loss = |same: &[&str]| {
        let message = format!("{} `{}` about the file", counted(same.len(), "statement"), same[0]);
        Loss::new(LossKind::Metadata, same.len(), message)
    };
    of_key.map(loss).collect()
}
