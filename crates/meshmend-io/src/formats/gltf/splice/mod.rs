//! A file is written as it was read: what a change of its meshes did not touch stays to the byte.
//!
//! Each part is compared with the rows that the file has (`part_rows`, `classes`), which tells what of its mesh is other
//! now (`part_change`). Changed rows go into the accessors that had them, or into new ones where others name those too
//! (`slots`, `users`), their bytes into the views that are free by that, or into new ones at the end (`layout`). The JSON
//! is edited where it stands (`text`), and nothing is numbered anew.

mod classes;
mod closed_manifold;
mod contents;
mod document;
mod layout;
mod manifold;
mod part_change;
mod part_rows;
mod pool_bytes;
mod slots;
mod text;
mod told;
mod triangulated;
mod users;
mod values;

pub(super) use document::splice;
