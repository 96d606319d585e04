//! What a polygon mesh is, told from its connectivity alone: exact answers for any mesh, manifold or not.
//!
//! Each file asks one question, through the [`Connectivity`](meshmend_core::Connectivity) trait, so that every
//! kernel gives the same answer. [`topology`] asks them all and returns a [`TopologyReport`] of plain facts.
//!
//! ```
//! use meshmend_core::{Connectivity, EdgeUse, FaceTable, PolygonMesh, VertexId};
//! use meshmend_topology::topology;
//!
//! let tetrahedron = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
//! let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, tetrahedron)?)?;
//! let report = topology(&EdgeUse::build(mesh.complex())?, &mesh);
//! assert_eq!(report.betti.z2, Some([1, 0, 1]));
//! assert_eq!(report.component_kinds[0].name.as_deref(), Some("sphere"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! No answer is a guess: a figure that is not defined for a mesh (the genus of something that is no surface) is
//! absent, and the report says why.

mod betti;
mod boundary;
mod component_kinds;
mod components;
mod crossings;
mod defect_list;
mod dual_graph;
mod duplicates;
mod elimination;
mod face_shape;
mod gluing;
mod ids;
mod incremental;
mod loops;
mod one_sided;
mod orientability;
mod patches;
mod report;
mod seam;
mod surface;

#[cfg(test)]
mod shapes;

pub use betti::{Betti, ELIMINATION_BUDGET, Instigators, betti, betti_within, instigators};
pub use boundary::{BoundaryLoops, boundary_loops};
pub use component_kinds::{ComponentFacts, ComponentKind, component_facts, component_kinds};
pub use components::{Components, components};
pub use defect_list::DefectList;
pub use dual_graph::DualEdge;
pub use duplicates::{AlikeFace, DuplicateFace, Likeness, alike_faces, duplicate_faces};
pub use face_shape::{faces_with_repeated_corners, non_simple_faces};
pub use gluing::{GluingWord, Letter};
pub use ids::{ComponentId, PatchId};
pub use incremental::{Cell, Effect, Incremental, REDUCTION_BUDGET, Step, incremental, incremental_within};
pub use loops::{
    CoTree, ComponentGenerators, CutGraph, Generator, GeneratorError, GeneratorKind, GeneratorOptions,
    Generators, LoopSystem, Measure, Roots, cut_graph, generators,
};
pub use one_sided::{ONE_SIDED_BUDGET, OneSidedLoop, one_sided_loops, one_sided_loops_by_length};
pub use orientability::{OneSidedStrip, Orientability, orientability};
pub use patches::{Patches, Side, patches};
pub use report::{
    DuplicateCounts, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness, topology,
    topology_with,
};
pub use seam::{Seam, seams, seams_by_length, short_seam};
pub use surface::{Surface, surface_name};
