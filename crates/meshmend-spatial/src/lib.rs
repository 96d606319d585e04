//! Where the faces of a mesh lie, decided exactly: questions about distances, sides and intersections, without passes and
//! files.
