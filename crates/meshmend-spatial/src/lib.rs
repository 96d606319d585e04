//! Where the faces of a mesh lie, decided exactly: questions about distances, sides and intersections, without passes and
//! files.
//!
//! * [`exact`]: signs of real arithmetic on doubles, from which all else is decided.
//! * [`intersections`] finds the faces that cross, overlap or touch; [`CrossingSearch`] and [`do_cross`] tell whether new
//!   triangles would.
//! * [`boxes`]: a tree that finds which boxes overlap.
//! * [`Surface`]: the faces of a mesh as triangles, corners known by their positions.
//! * [`nesting`] tells what is inside of what, and what is inside out; [`passage`] how a ray passes a triangle.
//! * [`internal_faces`] finds the faces inside of what closed components enclose.
//! * [`fronts`] tells which side of an open component is seen.
//! * Open places: [`t_junctions`] finds vertices on edges, [`heal`] decides which of them become corners there,
//!   [`open_loops`] tells holes from the rims of sheets.
//! * [`near_pairs`] finds the points that are near each other.
//! * Fills: [`best_fill`] covers a hole with triangles, [`fan_cost`] judges a fan.
//! * Shape: [`shapes`] finds the faces that are too thin, [`sliver_kind`] and [`compare_aspects`] judge triangles,
//!   [`is_straight`] points; [`mend_slivers`] mends slivers step by step.

pub mod boxes;
pub mod exact;
mod fill;
mod heal;
mod internal;
mod intersections;
mod meeting;
mod near_pairs;
mod nesting;
mod rims;
mod shape;
mod sight;
mod slivers;
mod surface;
mod t_junctions;
mod unit;

pub use fill::{Fill, FillBy, FillCost, Opening, best_fill, direction_of_face, fan_cost};
pub use heal::{Healed, HealedCorner, Insertion, LeftTJunction, NotHealed, heal};
pub use internal::{InternalFaces, internal_faces};
pub use intersections::{
    Budget, CrossingSearch, FacePair, Figures, IntersectionOptions, Intersections, do_cross, intersections,
};
pub use meeting::Contact;
pub use near_pairs::near_pairs;
pub use nesting::{
    NestedComponent, Nesting, NestingState, NoSpace, lies_on, nesting, passage, passage_of_turns,
};
pub use rims::{LoopKind, NoSide, OpenLoop, RIM, open_loops};
pub use shape::{Shapes, Sliver, SliverKind, compare_aspects, is_straight, shapes, sliver_kind};
pub use sight::{Front, fronts};
pub use slivers::{
    Attributes, FoundSliver, LeftSliver, MendedSlivers, NoAttributes, Reshaped, SliverMend, SliverReason,
    SliverStep, SliverTask, agreement, mend_slivers,
};
pub use surface::{Cell, Surface, SurfaceError, Triangle, WHOLE};
pub use t_junctions::{TJunction, t_junctions};
