//! OBJ: text with one statement a line.
//!
//! | statement | becomes |
//! |---|---|
//! | `v x y z`, `v x y z w`, `v x y z r g b`, `v x y z r g b a` | a vertex; layer `weight` where some w is not 1; layer `color` |
//! | `vt`, `vn` | the pools of the corner layers `texcoord` (one to three numbers) and `normal` |
//! | `f` | a face, however many corners it has |
//! | `l`, `p` | loose edges, loose points; edges of one statement have one value in the layer `polyline`, and their texture coordinates are in the layers `texcoord` (where an edge starts) and `texcoord_end` |
//! | `o`, `g`, `usemtl`, `s` | the layers `object`, `group`, `material`, `smoothing` of faces and loose elements; without a name (or with `s off`) an element has no value; each statement is its own value |
//! | `mtllib`, `#` | metadata; a comment after the first vertex stands before the element that follows it |
//!
//! Any other statement is skipped, with a note. Indices count from 1, or back from the last vertex if they are
//! negative. A face may name later vertices. The index of a missing vertex is an error. The index of a missing
//! texture coordinate or normal is noted, and the corner has no such value, as the geometry is whole. A `\` at the
//! end of a line continues it, but not a comment. Lines end with LF, CR LF or CR.

mod comment_anchors;
mod companions;
pub(crate) mod facts;
mod finish;
mod library;
mod loose_parts;
mod materials;
mod name_statements;
mod pools;
mod read;
mod read_loose;
mod reader;
mod shape;
mod statement_cursor;
mod usual_statements;
mod write;
mod write_comments;
mod write_library;
mod write_loose;
mod write_names;
mod write_values;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: Driver::needs_whole_file,
    stream: Driver::streams_nothing,
    look_beside: shape::look_beside,
    prepare: write::prepare,
    encode: write::encode,
    losses: write::losses,
};
