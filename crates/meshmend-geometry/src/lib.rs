//! The geometry that repairs and writers share: it knows points, and nothing of passes or files.
//!
//! [`polygon`] cuts one polygon in space into triangles; [`vector`] is the arithmetic of points in doubles.

pub mod polygon;
pub mod vector;
