//! PLY: a header that declares elements with properties of given types, and their values as text or binary.
//!
//! | element, property | becomes |
//! |---|---|
//! | `vertex`: `x y z` | a vertex; values are those of the declared type, also in text |
//! | `nx ny nz`, `red green blue [alpha]`, `s t` or `u v` or `texture_u texture_v`, all of one type | the layers `normal`, `color`, `texcoord` of vertices or faces |
//! | any other property | a layer of that name and type; lists stay lists |
//! | `face`: list `vertex_indices` or `vertex_index` | a face |
//! | `face`: list `texcoord` of two numbers a corner, list `corner_NAME` of any number a corner | the corner layers `texcoord`, `NAME` |
//! | `tristrips`: list `vertex_indices` with −1 for a restart | triangles, every second one reversed; those that name a vertex twice are stitches, which are noted and are not faces |
//! | `edge`: `vertex1 vertex2` | a loose edge |
//! | any other element | rows that a PLY output carries unchanged |
//! | `comment`, `obj_info` | metadata |
//!
//! **Text.** Each row stands on its own line. A file with other line breaks is accepted, with a note, if all values
//! fit at the end of each element and of the file. Else the error names the first line with a wrong number of values.
//!
//! Elements and properties may come in any order. If the mesh comes from a PLY file, they are written in the order,
//! with the names and in the types of that file, if the types hold every value. Else positions are written as `float`
//! if that holds all of them exactly, and as `double` if not. What is written reads back to the same layers, whatever
//! their names and types are. There are two exceptions for the sake of other programs. Attributes of vertices whose
//! corners differ, normals, and texture coordinates of polygons are written with the vertices, which are split for
//! that. And attributes from other formats are written in the types that programs expect in a PLY.

mod binary_values;
mod carried;
mod columns;
mod data;
mod expected;
pub(crate) mod facts;
mod header;
mod interpret;
mod layers;
mod line_check;
mod listed;
mod plan;
mod prepare;
mod property;
mod property_names;
mod read;
mod rows;
mod scalar;
mod shape;
mod stream;
mod strips;
mod text_values;
mod types;
mod usual_rows;
mod write;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: read::read_blocks,
    stream: stream::stream,
    look_beside: Driver::names_no_files,
    prepare: prepare::prepare,
    encode: write::encode,
    losses: plan::losses,
};
