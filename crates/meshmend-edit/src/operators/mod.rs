//! The thirteen operators, each beside its inverse.
//!
//! Every operator is a question and a deed: `can_x` lists all that stands against it, and `x` asks that first, so that a
//! refused call changes nothing. The deed then relies on what was asked.

mod collapse;
mod cut_loop;
mod flip;
mod open_face;
mod poke;
mod split_edge;
mod split_face;
mod split_vertex;
mod zip_holes;
