//! 3MF: a zip archive with a model in XML; objects of triangles, put together and placed to be built.
//!
//! **Package.** Entries are stored or deflated. Two entries of one name, an encrypted entry, and a name with `..` are
//! errors. What entries inflate to is limited. The root model is the one that `_rels/.rels` names; other models are
//! read when one of its objects or items is in them.
//!
//! **Objects.** An object with a mesh is a part, in its own space. Components and items of the build place parts; they
//! are never joined. The unit is kept. The layer `pid` names the property group of each triangle, `property` its member
//! for each corner, with the defaults of the object; `material` is the name of the base material; where it says all, the other two are not there. An object that holds
//! something that numbers its vertices or triangles in a way not known here is sealed, as is one in an encrypted model.
//!
//! **Writing what was read.** Entries that do not change are copied as they are. In a model that changes only the rows
//! of vertices and triangles are replaced: those that stay are copied as text, with every attribute; only the numbers
//! of vertices are set, and the properties of corners where a triangle was turned or cut. Sets of triangles and beams
//! follow. A package of which nothing changed is the same to the byte.
//!
//! **Writing a new file.** One object a name of the face layer `object`, in millimetres, each with its own vertices;
//! names of the layer `material` are base materials.

mod assembly;
mod counts;
mod extras;
pub(crate) mod facts;
mod fresh;
mod kept;
mod model;
mod package;
mod parts;
mod read;
mod relations;
mod shape;
mod splice;
mod xml;

use crate::formats::driver::Driver;
use crate::output::triangles::cut_polygons;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: Driver::needs_whole_file,
    stream: Driver::streams_nothing,
    look_beside: Driver::names_no_files,
    prepare: cut_polygons,
    encode: fresh::encode,
    losses: fresh::losses,
};
