//! A mesh taken apart along every side that is not matched.

pub(crate) mod draft;
pub(crate) mod new_vertices;
pub(crate) mod parts;
pub(crate) mod subdivide;
