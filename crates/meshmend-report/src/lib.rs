//! Reports on meshes as a page: one HTML file that anyone can open from a disk or a mail, without a network.
//!
//! A [`Page`] has an [`Entry`] for each mesh: what a check or a repair says of it, in the same words and numbers as the JSON of
//! [`meshmend::report`], with the mesh itself, before and after. The viewer in the page shows the mesh in 3D, where the defects
//! are, and what was done.
//!
//! ```
//! use meshmend::report::CheckDocument;
//! use meshmend::{CheckOptions, check};
//! use meshmend_report::{Entry, EntryOptions, Page};
//! # use meshmend::{FaceTable, PolygonMesh, VertexId};
//! # let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
//! # let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces)?;
//!
//! let report = check(&mesh, &CheckOptions::default())?;
//! let document = CheckDocument::new(report.clone(), 1000);
//! let mut page = Page::titled("a triangle");
//! page.entries.push(Entry::of_check("triangle", (&mesh, &report), &document, &EntryOptions::default())?);
//! let mut html = Vec::new();
//! page.write(&mut html)?;
//! assert!(html.starts_with(b"<!doctype html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing that comes from a file is ever part of the page's HTML but the title, escaped: all of it is data, which the viewer puts in
//! as text. The page's own policy forbids it to ask for anything from anywhere.

mod entry;
mod kinds;
mod loops;
mod marks;
mod mesh;
mod packed;
mod page;
mod pictures;
mod rows;
mod state;
mod thinned;
mod verdict;

pub use entry::{Entry, EntryOptions};
pub use page::Page;
